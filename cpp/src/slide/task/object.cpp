// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/object.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graspless/geometry/point_cloud.hpp"
#include "graspless/mechanics/contact.hpp"
#include "graspless/watch.hpp"

#include "geometry/convex_hull.hpp"
#include "geometry/quantile.hpp"
#include "slide/task/prisms.hpp"
#include "slide/task/rim.hpp"
#include "text.hpp"

namespace graspless::slide {
namespace {

constexpr Eigen::Index kPolledRows = 256;   // points between two polls
constexpr double kColumnStep = 0.003;       // of the tops of columns [m]
constexpr double kLevel = 0.0025;           // of heights from that of the face [m]
constexpr double kLevelRadius = 0.006;      // of discs that are level or not [m]
constexpr double kNearCom = 0.02;           // from where on points of a face count less [m]
constexpr double kMaxSlenderness = 0.75;    // thickness of a thin object, in its least widths
constexpr double kComSlack = 1e-6;          // of a centre of mass on the hull, for rounding [m]
constexpr double kMaxHeightSpread = 0.010;  // of a flat top, 5th to 95th percentile [m]

std::vector<double> heights_of(const std::string& what, const Eigen::Matrix3Xd& p_OP) {
  if (p_OP.cols() < 3) {
    throw std::invalid_argument(what + " needs at least 3 points, not " +
                                std::to_string(p_OP.cols()));
  }
  const auto bad = p_OP.cols() - p_OP.array().isFinite().colwise().all().count();
  if (bad > 0) {
    throw std::invalid_argument(what + " has " + std::to_string(bad) +
                                " points that are not finite, of " + std::to_string(p_OP.cols()));
  }
  return {p_OP.row(2).begin(), p_OP.row(2).end()};
}

void require_thickness(const std::string& what, double thickness) {
  require_within(what + " thickness", thickness, geometry::kMinLength, geometry::kMaxLength, " m");
}

void check_thin(const std::string& what, const std::vector<double>& z, double thickness,
                double width) {
  const double spread = geometry::quantile(z, 0.95) - geometry::quantile(z, 0.05);
  if (spread > kMaxHeightSpread) {
    throw std::invalid_argument(
        what + " is not the top of a thin object: its heights spread over " + figure(spread) +
        " m (5th to 95th percentile); at most " + figure(kMaxHeightSpread) + " m is allowed");
  }
  require_thickness(what, thickness);
  if (thickness > kMaxSlenderness * width) {
    throw std::invalid_argument(what + " is not thin: thickness " + figure(thickness) +
                                " m exceeds three quarters of its width of " + figure(width) +
                                " m");
  }
}

double width_across_edges(const geometry::Polygon& outline) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < outline.size(); ++i) {
    poll();
    const Eigen::RowVectorXd across = outline.edge(i).inward.transpose() * outline.vertices();
    least = std::min(least, across.maxCoeff() - across.minCoeff());
  }
  return least;
}

Eigen::VectorXd depths_within(const geometry::Polygon& outline, const Eigen::Matrix2Xd& points) {
  Eigen::VectorXd depths(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    poll();
    depths[i] = outline.depth(points.col(i));
  }
  return depths;
}

/// Returns the lowest and the highest point along y of each run with the same x.
Eigen::Matrix2Xd outermost_of(const Eigen::Matrix2Xd& points) {
  std::vector<Eigen::Vector2d> found;
  std::size_t run = 0;  // index of its lowest point
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (i % kPolledRows == 0) poll();
    const Eigen::Vector2d p = points.col(i);
    if (found.empty() || found.back().x() != p.x()) {
      run = found.size();
      found.push_back(p);
    } else if (found.size() == run + 1) {
      found.insert(p.y() < found[run].y() ? found.end() - 1 : found.end(), p);
    } else if (p.y() < found[run].y()) {
      found[run] = p;
    } else if (p.y() > found[run + 1].y()) {
      found[run + 1] = p;
    }
  }
  return Eigen::Map<const Eigen::Matrix2Xd>(found.front().data(), 2,
                                            static_cast<Eigen::Index>(found.size()));
}

/// Height at which the most of some points of a map are level; nothing if none is. Points count the
/// more the nearer they are to the centre of mass: pressed far from there, an object tips.
std::optional<double> face_height(const geometry::HeightMap& map, const Eigen::Matrix2Xd& points,
                                  const Eigen::Vector2d& com) {
  std::vector<std::pair<double, double>> level;  // height and weight
  for (const auto& p : points.colwise()) {
    poll();
    const auto [least, largest] = map.range_near(p, kLevelRadius);
    if (map.at(p) > 0 && largest - least <= 2 * kLevel)
      level.emplace_back((least + largest) / 2, 1 / (kNearCom + (p - com).norm()));
  }
  std::sort(level.begin(), level.end());
  std::optional<double> height;
  double weight = 0, most = 0;
  for (auto first = level.begin(), last = first; first != level.end(); ++first) {
    for (; last != level.end() && last->first <= first->first + kLevel; ++last)
      weight += last->second;
    if (weight > most * (1 + 1e-12)) {
      most = weight;
      height = (first + (last - first) / 2)->first;
    }
    weight -= first->second;
  }
  return height;
}

}  // namespace

Object::Object(std::string name, Eigen::Matrix2Xd points, geometry::Polygon outline,
               double thickness, const Eigen::Vector2d& com)
    : name_(std::move(name)),
      outline_(std::move(outline)),
      top_(std::make_shared<Top>(top_of(outline_, std::move(points)))),
      spacing_(std::sqrt(outline_.area() / static_cast<double>(top_->points.cols()))),
      thickness_(thickness),
      face_height_(thickness),
      com_(com.x(), com.y(), thickness / 2),
      shapes_(prisms(outline_, 0, thickness)),
      solid_(shapes_, "object '" + name_ + "'") {}

Object::Top Object::top_of(const geometry::Polygon& outline, Eigen::Matrix2Xd points) {
  const Eigen::Vector2d middle = points.rowwise().mean();
  const Eigen::VectorXd distances = (points.colwise() - middle).colwise().norm();
  const double variance = distances.squaredNorm() / static_cast<double>(distances.size());
  const double ratio = variance > 0 ? distances.mean() / std::sqrt(variance) : 1;
  return {depths_within(outline, points),
          outermost_of(points),
          std::move(points),
          middle,
          variance,
          ratio};
}

Object Object::from_polygon(const std::string& name, const geometry::Polygon& outline,
                            double thickness, double spacing) {
  check_thin("object '" + name + "'", {0}, thickness, width_across_edges(outline));
  return prism(name, outline, thickness, spacing);
}

Object Object::prism(const std::string& name, const geometry::Polygon& outline, double thickness,
                     double spacing) {
  require_thickness("object '" + name + "'", thickness);
  return Object(name, geometry::sample_grid(outline, spacing), outline, thickness,
                outline.centroid());
}

Object Object::from_cloud(const std::string& name, const Eigen::Matrix3Xd& p_OP, double thickness) {
  const std::string what = "object '" + name + "' cloud";
  const std::vector<double> z = heights_of(what, p_OP);
  if (thickness == 0) thickness = geometry::quantile(z, 0.5);
  const geometry::Polygon outline = geometry::outline(p_OP.topRows<2>(), what);
  check_thin(what, z, thickness, width_across_edges(outline));
  return Object(name, p_OP.topRows<2>(), outline, thickness, p_OP.topRows<2>().rowwise().mean());
}

bool Object::is_thin() const { return thickness_ <= kMaxSlenderness * least_width(); }

double Object::least_width() const { return width_across_edges(outline_); }

Object Object::with_com(const Eigen::Vector3d& com_O) const {
  const geometry::Polygon hull(geometry::convex_outline(outline_.vertices()));
  const bool within = com_O.allFinite() && com_O.z() >= -kComSlack &&
                      com_O.z() <= thickness_ + kComSlack &&
                      hull.depth(com_O.head<2>()) >= -kComSlack;
  if (!within) {
    throw std::invalid_argument("com (" + figure(com_O.x()) + ", " + figure(com_O.y()) + ", " +
                                figure(com_O.z()) +
                                ") must lie within the convex hull of the outline of object '" +
                                name_ + "', at a height from 0 to " + figure(thickness_) + " m");
  }
  Object other = *this;
  other.com_ = com_O;
  if (heights_)
    other.face_height_ = face_height(*heights_, points(), com_O.head<2>()).value_or(thickness_);
  return other;
}

Object Object::with_mass(double mass) const {
  require_within("object '" + name_ + "' mass", mass, mechanics::kMinMass, mechanics::kMaxMass,
                 " kg");
  Object other = *this;
  other.mass_ = mass;
  return other;
}

Object Object::with_heights(const geometry::HeightMap& heights_O) const {
  constexpr double kRoundOff = 1e-9;
  const std::string what = "object '" + name_ + "' heights";
  geometry::validate(heights_O, what);
  if (heights_O.heights.maxCoeff() > thickness_ + kRoundOff) {
    throw std::invalid_argument(what + " must be at most the thickness of " + figure(thickness_) +
                                " m, not " + figure(heights_O.heights.maxCoeff()) + " m");
  }
  Object other = *this;
  other.heights_ = heights_O;
  other.face_height_ = face_height(heights_O, points(), com_.head<2>()).value_or(thickness_);
  other.shapes_ = geometry::columns(heights_O, kColumnStep);
  other.solid_ = collision::Solid(other.shapes_, "object '" + name_ + "'");
  return other;
}

Object Object::with_hollow(bool is_hollow) const {
  Object other = *this;
  other.is_hollow_ = is_hollow;
  const double even = mean_distance(top_->middle);  // 0 of a single point
  other.lever_ = is_hollow && even > 0 ? rim_distance(outline_, top_->middle) / even : 1;
  return other;
}

bool Object::has_face_at(const Eigen::Vector2d& p_O, double radius, double clear) const {
  if (!heights_) return true;
  if (heights_->at(p_O) == 0) return false;  // in a hole
  const double least = heights_->range_near(p_O, radius).first,
               largest = heights_->range_near(p_O, std::max(radius, clear)).second;
  return std::max(face_height_ - least, largest - face_height_) <= kLevel;
}

double Object::height_near(const Eigen::Vector2d& p_O, double radius) const {
  return heights_ ? heights_->range_near(p_O, radius).second : thickness_;
}

Object Object::scaled(double scale) const {
  require_within("object '" + name_ + "' scale", scale, 1e-6, 1e6);
  Object other(name_, scale * points(), geometry::Polygon(scale * outline_.vertices()), thickness_,
               scale * com_.head<2>());
  if (is_thin()) check_thin("object '" + name_ + "'", {0}, thickness_, other.least_width());
  other.com_.z() = com_.z();
  other.mass_ = mass_;
  other.lever_ = lever_;
  other.is_hollow_ = is_hollow_;
  if (!heights_) return other;
  geometry::HeightMap map = *heights_;
  map.corner *= scale;
  map.cell *= scale;
  return other.with_heights(map);
}

Eigen::Vector3d center_of_mass(const Eigen::Matrix3Xd& points, const Eigen::VectorXd& masses) {
  if (masses.size() != points.cols()) {
    throw std::invalid_argument("masses has " + std::to_string(masses.size()) + " entries for " +
                                std::to_string(points.cols()) + " points");
  }
  if (!masses.allFinite() || !points.allFinite() || (masses.array() < 0).any() ||
      !(masses.sum() > 0)) {
    throw std::invalid_argument("masses must be finite and not negative, with a positive sum");
  }
  return points * masses / masses.sum();
}

}  // namespace graspless::slide
