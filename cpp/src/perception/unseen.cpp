// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "perception/objects.hpp"

namespace graspless::perception {
namespace {

constexpr int kSectors = 8;           // wedges behind an object, at most
constexpr double kLeastWidth = 0.01;  // of a wedge, in front [m]
constexpr double kWidest = 0.8;       // angle of a wedge [rad]
constexpr double kShortest = 0.005;   // shadow [m]
constexpr double kLowest = 0.003;     // shadow [m]
constexpr double kLeastPatch = 4e-4;  // area of a patch without depth [m^2]

/// The space that the pixels in one direction from the camera's foot hide.
struct Sector {
  double farthest = 0;  ///< distance of the farthest point of the object [m]
  double end = 0;       ///< distance at which the highest ray reaches the support [m]
  double rise = -std::numeric_limits<double>::infinity();  ///< slope of the highest ray
};

/// The corners of a wedge between two directions, from the height `h` at `near` to `h_far` at
/// `far`.
Eigen::Matrix3Xd wedge(const Eigen::Vector2d& foot, double first, double last, double near,
                       double far, double h, double h_far) {
  Eigen::Matrix3Xd corners(3, h_far > kLowest ? 8 : 6);
  const double outer = 1 / std::cos((last - first) / 2);  // the chord lies beyond the arc
  int i = 0;
  for (const double angle : {first, last}) {
    const Eigen::Vector2d ray(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d begin = foot + near * ray, end = foot + far * outer * ray;
    corners.col(i++) << begin.x(), begin.y(), 0;
    corners.col(i++) << begin.x(), begin.y(), h;
    corners.col(i++) << end.x(), end.y(), 0;
    if (h_far > kLowest) corners.col(i++) << end.x(), end.y(), h_far;
  }
  return corners;
}

/// Wedges behind the pixels of one view.
class Shade {
 public:
  Shade(const Cluster& cluster, int view, const Region& region, const Sighting& from)
      : region_(region), from_(from) {
    foot_ = (region.X_WS.inverse() * from.sight->X_WC.translation()).head<2>();
    for (const Pixel& p : cluster.pixels) {
      if (p.view == view) pixels_.push_back(&p);
    }
  }

  void add_to(std::vector<geometry::Convex>& shapes) {
    if (pixels_.empty()) return;
    span();
    const double turn = last_ - first_, wide = turn * nearest_ / kLeastWidth;
    const auto count = static_cast<std::size_t>(
        std::clamp(static_cast<int>(std::max(wide, std::ceil(turn / kWidest))), 1, kSectors));
    std::vector<Sector> sectors(count);
    const double width = (last_ - first_) / static_cast<double>(count);
    for (const Pixel* p : pixels_) {
      const auto k = std::min(count - 1, static_cast<std::size_t>((angle(*p) - first_) / width));
      sectors[k].farthest = std::max(sectors[k].farthest, distance(*p));
      sectors[k].end = std::max(sectors[k].end, end_of(*p));
      sectors[k].rise = std::max(sectors[k].rise, rise_of(*p));
    }
    for (std::size_t k = 0; k < count; ++k) {
      const double begin = first_ + static_cast<double>(k) * width;
      const auto [farthest, end, rise] = sectors[k];
      const double camera = from_.heights.camera;
      const double height = camera + rise * farthest, height_far = camera + rise * end;
      if (end - farthest < kShortest || height < kLowest) continue;
      shapes.push_back(
          {region_.X_WS * wedge(foot_, begin, begin + width, farthest, end, height, height_far)});
    }
  }

 private:
  Eigen::Vector2d from_foot(const Pixel& p) const { return p.p.cast<double>() - foot_; }
  double distance(const Pixel& p) const { return from_foot(p).norm(); }
  double angle(const Pixel& p) const {
    const Eigen::Vector2d d = from_foot(p);
    const double a = std::atan2(d.y(), d.x()) - middle_;
    return std::remainder(a, 2 * M_PI) + middle_;
  }
  /// Distance at which the ray of a pixel reaches the support, within the region.
  double end_of(const Pixel& p) const {
    const double camera = from_.heights.camera, h = static_cast<double>(p.height);
    const double longest = region_.inside.cell * std::hypot(region_.inside.nx, region_.inside.ny);
    if (h >= camera) return distance(p) + longest;
    return std::min(distance(p) * camera / (camera - h), distance(p) + longest);
  }
  double rise_of(const Pixel& p) const {
    return (static_cast<double>(p.height) - from_.heights.camera) / std::max(distance(p), 1e-9);
  }
  void span() {
    const Eigen::Vector2d d = from_foot(*pixels_[pixels_.size() / 2]);
    middle_ = std::atan2(d.y(), d.x());
    first_ = std::numeric_limits<double>::infinity();
    last_ = -first_;
    nearest_ = first_;
    for (const Pixel* p : pixels_) {
      first_ = std::min(first_, angle(*p));
      last_ = std::max(last_, angle(*p));
      nearest_ = std::min(nearest_, distance(*p));
    }
    last_ = std::max(last_, first_ + 1e-3);
  }

  const Region& region_;
  const Sighting& from_;
  Eigen::Vector2d foot_;
  std::vector<const Pixel*> pixels_;
  double middle_ = 0, first_ = 0, last_ = 0, nearest_ = 0;
};

/// True if the rays of a view passed a point.
bool is_passed(const Eigen::Vector3d& p_W, const Sight& sight) {
  const Eigen::Vector3d uvw = sight.K * (sight.X_WC.inverse() * p_W);
  if (uvw.z() <= 0) return false;
  const double u = std::round(uvw.x() / uvw.z()), v = std::round(uvw.y() / uvw.z());
  if (!(u >= 0 && v >= 0 && u < sight.width() && v < sight.height())) return false;
  return static_cast<double>(sight.depth(static_cast<int>(v), static_cast<int>(u))) > uvw.z();
}

/// True if other views passed the whole wedge: its middle, and points near its corners.
bool is_seen_by_another(const Eigen::Matrix3Xd& corners, const std::vector<Sighting>& sightings,
                        std::size_t own) {
  const Eigen::Vector3d middle = corners.rowwise().mean();
  const auto is_passed_by_others = [&](const Eigen::Vector3d& p) {
    for (std::size_t i = 0; i < sightings.size(); ++i) {
      if (i != own && is_passed(p, *sightings[i].sight)) return true;
    }
    return false;
  };
  if (!is_passed_by_others(middle)) return false;
  for (const auto& corner : corners.colwise()) {
    if (!is_passed_by_others(middle + 0.8 * (corner - middle))) return false;
  }
  return true;
}

/// Rectangles that cover a piece and not much else: one that is mostly empty is halved.
std::vector<Eigen::AlignedBox2i> cover_piece(const Pieces& pieces, const Raster& raster, int label,
                                             const Eigen::AlignedBox2i& around) {
  constexpr double kFull = 0.6;  // least share of a rectangle
  constexpr int kFinest = 8;     // cells along a side
  std::vector<Eigen::AlignedBox2i> parts, open{around};
  while (!open.empty()) {
    const Eigen::AlignedBox2i all = open.back();
    open.pop_back();
    Eigen::AlignedBox2i box;
    int count = 0;
    for (int y = all.min().y(); y <= all.max().y(); ++y) {
      for (int x = all.min().x(); x <= all.max().x(); ++x) {
        if (pieces.label[raster.index(x, y)] != label) continue;
        box.extend(Eigen::Vector2i(x, y));
        ++count;
      }
    }
    if (count == 0) continue;
    const Eigen::Vector2i sides = box.sizes() + Eigen::Vector2i::Ones();
    if (count >= kFull * sides.prod() || sides.maxCoeff() <= kFinest) {
      parts.push_back(box);
      continue;
    }
    const int axis = sides.x() >= sides.y() ? 0 : 1;
    Eigen::AlignedBox2i low = box, high = box;
    low.max()[axis] = box.min()[axis] + sides[axis] / 2 - 1;
    high.min()[axis] = low.max()[axis] + 1;
    open.push_back(high);
    open.push_back(low);
  }
  return parts;
}

}  // namespace

std::vector<geometry::Convex> shadows(const Cluster& cluster, const Region& region,
                                      const std::vector<Sighting>& sightings) {
  std::vector<geometry::Convex> shapes;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    std::vector<geometry::Convex> behind;
    Shade(cluster, static_cast<int>(i), region, sightings[i]).add_to(behind);
    for (geometry::Convex& shape : behind) {
      if (!is_seen_by_another(shape.vertices, sightings, i)) shapes.push_back(std::move(shape));
    }
  }
  return shapes;
}

std::vector<geometry::Convex> patches(const Region& region, const Options& options) {
  Raster unknown = region.ground;
  for (std::size_t i = 0; i < unknown.values.size(); ++i) {
    unknown.values[i] = region.inside.values[i] &&
                        region.ground.values[i] == static_cast<std::uint8_t>(Ground::unknown);
  }
  close_gaps(unknown);
  const Pieces pieces = pieces_of(unknown, true);
  std::vector<Eigen::AlignedBox2i> boxes(pieces.size.size());
  for (int y = 0; y < unknown.ny; ++y) {
    for (int x = 0; x < unknown.nx; ++x) {
      const int label = pieces.label[unknown.index(x, y)];
      if (label >= 0) boxes[label].extend(Eigen::Vector2i(x, y));
    }
  }
  constexpr int kThinnest = 5;  // cells across
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(unknown.cell / 2);
  std::vector<geometry::Convex> shapes;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const double area = static_cast<double>(pieces.size[k]) * unknown.cell * unknown.cell;
    if (area < kLeastPatch || boxes[k].sizes().minCoeff() + 1 < kThinnest) continue;
    for (const Eigen::AlignedBox2i& part :
         cover_piece(pieces, unknown, static_cast<int>(k), boxes[k])) {
      const Eigen::AlignedBox2d box(unknown.center(part.min().x(), part.min().y()) - half,
                                    unknown.center(part.max().x(), part.max().y()) + half);
      Eigen::Matrix3Xd corners(3, 8);
      for (int i = 0; i < 8; ++i) {
        const auto corner = box.corner(static_cast<Eigen::AlignedBox2d::CornerType>(i % 4));
        corners.col(i) << corner.x(), corner.y(), i < 4 ? 0 : options.unseen_height;
      }
      shapes.push_back({region.X_WS * corners});
    }
  }
  return shapes;
}

}  // namespace graspless::perception
