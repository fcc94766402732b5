// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/placement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "graspless/watch.hpp"

#include "slide/task/rim.hpp"

namespace graspless::slide {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr Eigen::Index kPolled = 256;  // points between two polls
constexpr double kLeastReach = 0.02;   // of fingers that close on an edge [m]

/// Returns the points of the object that are not over the support, in S.
Points points_off(const Problem& problem, const Planar& object_S) {
  constexpr double kSurely = 1e-9;  // [m]
  const geometry::Polygon& Q = problem.support.polygon();
  const Object& object = problem.object;
  const Eigen::Vector2d com = object.com().head<2>(), middle = object_S * com;
  const double radius = (object.outermost().colwise() - com).colwise().norm().maxCoeff();
  // On a convex support, the lines through the few edges that are near decide, except on an edge.
  const bool is_convex = Q.is_convex();
  std::vector<Eigen::Vector3d> near;  // x, y and 1 times this: distance from the line, inwards
  for (int i = 0; is_convex && i < Q.size(); ++i) {
    const geometry::Polygon::Edge edge = Q.edge(i);
    const double inside = edge.inward.dot(middle - edge.a);
    if (inside <= radius + kSurely)
      near.emplace_back(edge.inward.x(), edge.inward.y(), -edge.inward.dot(edge.a));
  }
  const auto depth = [&](const Eigen::Vector2d& p) {
    if (!is_convex) return Q.depth(p);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& line : near)
      least = std::min(least, line.x() * p.x() + line.y() * p.y() + line.z());
    return least;
  };
  Points off;
  const Eigen::Matrix2Xd& points = object.points();
  Eigen::Vector2d known = middle;
  double reach = depth(known);  // points within this distance of it are on the same side
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if (i % kPolled == 0) poll();
    const Eigen::Vector2d p = object_S * Eigen::Vector2d(points.col(i));
    const double sure = std::max(0.0, std::abs(reach) - kSurely);
    if ((p - known).squaredNorm() >= sure * sure) reach = depth(known = p);
    const bool is_sure = std::abs(reach) > kSurely;
    if (is_sure ? reach < 0 : !Q.contains(p)) off.push_back(p);
  }
  return off;
}

// Points at most this many spacings apart belong to one part. A position is on the object if a
// point is within half that distance. Neighbours on the diagonal of a grid are 1.4 spacings apart.
constexpr double kLink = 2.5;
constexpr double kTie =
    1e-9;  // centres often lie on the outline, or equally far from several points [m]

Eigen::Vector2d center_of(const Points& points) {
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  for (const auto& p : points) center += p / static_cast<double>(points.size());
  return center;
}

Eigen::Vector2d nearest(const Points& points, const Eigen::Vector2d& to) {
  return *std::min_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
    return (a - to).squaredNorm() < (b - to).squaredNorm();
  });
}

/// True if p (in S) lies within the outline and near a point of the part. The outline of a ring has
/// no hole; its points have.
bool is_on_object(const Object& object, const Planar& object_S, const Points& part,
                  const Eigen::Vector2d& p) {
  return (nearest(part, p) - p).norm() <= kLink / 2 * object.spacing() + kTie &&
         object.outline().depth(object_S.inverse() * p) > kTie;
}

/// Removes from `points` those that are linked with the first by steps of at most `link` [m], and
/// returns them.
Points take_part(Points& points, double link) {
  Points part{points.front()};
  points.erase(points.begin());
  for (std::size_t next = 0; next < part.size(); ++next) {
    poll();
    const auto is_far = [&, from = part[next]](const auto& p) { return (p - from).norm() > link; };
    const auto linked = std::stable_partition(points.begin(), points.end(), is_far);
    part.insert(part.end(), linked, points.end());
    points.erase(linked, points.end());
  }
  return part;
}

/// The part with the most points, of those into which `points` fall apart.
Points largest_part(Points points, double link) {
  Points largest;
  while (points.size() > largest.size()) {
    Points part = take_part(points, link);
    if (part.size() > largest.size()) largest = std::move(part);
  }
  return largest;
}

}  // namespace

double rim_margin(const Object& object, const Options& options) {
  if (options.rim_margin == 0) return -std::numeric_limits<double>::infinity();
  return std::min(options.rim_margin, object.depths().maxCoeff() / 2);
}

double face_radius(const Hand& hand, const Options& options) {
  constexpr double kLeast = 0.006;  // [m]
  return std::max(kLeast, (1 - options.pad_spread) * hand.pad_width / 2);
}

namespace {

/// Half of the pad, at least 1 cm [m].
double pad_radius(const Hand& hand) {
  constexpr double kLeast = 0.01;  // [m]
  return std::max(kLeast, hand.pad_width / 2);
}

}  // namespace

bool can_press_at(const Problem& problem, const Options& options, const Eigen::Vector2d& p_O) {
  return problem.object.has_face_at(p_O, face_radius(problem.hand, options),
                                    pad_radius(problem.hand));
}

std::vector<std::int32_t> contact_points(const Problem& problem, const Options& options) {
  const Object& object = problem.object;
  const Eigen::VectorXd& depths = object.depths();
  const double margin = rim_margin(object, options), clear = pad_radius(problem.hand);
  std::vector<std::int32_t> kept;
  kept.reserve((depths.array() >= margin).count());
  for (const double radius : {clear, face_radius(problem.hand, options)}) {
    for (Eigen::Index i = 0; i < depths.size(); ++i) {
      if (i % kPolled == 0) poll();
      if (depths[i] >= margin && object.has_face_at(object.points().col(i), radius, clear))
        kept.push_back(static_cast<std::int32_t>(i));
    }
    if (!kept.empty()) break;
  }
  return kept;
}

Eigen::Vector2d com_foot(const Problem& problem, const Planar& object_S) {
  const Eigen::Vector3d com_S = spatial(object_S) * problem.object.com();
  const Eigen::Vector3d down_S = -problem.support.X_WS().linear().row(2).transpose();
  return (com_S + down_S * (com_S.z() / -down_S.z())).head<2>();
}

bool is_com_inside(const Problem& problem, const Planar& object_S, double margin) {
  return problem.support.polygon().depth(com_foot(problem, object_S)) >= margin;
}

bool is_supported(const Problem& problem, const Planar& object_S, double margin) {
  return is_com_inside(problem, object_S, margin) &&
         (!problem.object.is_hollow() || is_held_by_rim(problem, object_S, margin));
}

Placement placement(const Problem& problem, const Options& options, const Planar& object_S) {
  const geometry::Polygon& Q = problem.support.polygon();
  Placement result;
  Points out = points_off(problem, object_S);  // P_out
  result.sticks_out = !out.empty();
  if (!result.sticks_out) return result;
  const bool is_over_usable_edges = !problem.support.has_unusable_edges() ||
                                    std::all_of(out.begin(), out.end(), [&](const auto& p) {
                                      return problem.support.is_usable(Q.nearest_edge(p).index);
                                    });
  result.out_center = center_of(out);
  if (!is_on_object(problem.object, object_S, out, result.out_center)) {
    out = largest_part(out, kLink * problem.object.spacing());
    result.out_center = center_of(out);
    if (!is_on_object(problem.object, object_S, out, result.out_center)) {
      result.out_center = nearest(out, result.out_center);
    }
  }
  result.edge = Q.nearest_edge(result.out_center);
  for (const auto& p : out) {
    result.overhang = std::max(result.overhang, -result.edge.inward.dot(p - result.edge.a));
  }
  // The fingers reach from out_center to the end of what sticks out.
  const double reach = result.overhang + result.edge.inward.dot(result.out_center - result.edge.a);
  result.height = problem.object.height_near(object_S.inverse() * result.out_center,
                                             std::max(kLeastReach, reach));
  if (!is_over_usable_edges) {
    result.overhang = 0;
    result.fault = "edge not usable";
  }
  result.com_inside = is_supported(problem, object_S, options.com_margin);
  return result;
}

Eigen::Isometry3d grasp_pose(const Problem& problem, const Placement& placement, int roll,
                             double back) {
  const Eigen::Vector2d in = placement.edge.inward;
  const double up = roll == 0 ? 1 : -1;
  Eigen::Isometry3d X_SH = Eigen::Isometry3d::Identity();
  X_SH.linear().col(2) << in.x(), in.y(), 0;
  X_SH.linear().col(1) << 0, 0, up;
  X_SH.linear().col(0) = X_SH.linear().col(1).cross(X_SH.linear().col(2));
  X_SH.translation().head<2>() = placement.out_center - back * in;
  X_SH.translation().z() = placement.height / 2;
  return problem.support.X_WS() * X_SH;
}

std::discrete_distribution<int> usable_edges(const Support& support) {
  std::vector<double> lengths;
  for (int i = 0; i < support.polygon().size(); ++i) {
    const geometry::Polygon::Edge edge = support.polygon().edge(i);
    lengths.push_back(support.is_usable(i) ? (edge.b - edge.a).norm() : 0);
  }
  return {lengths.begin(), lengths.end()};
}

std::optional<Planar> draw_graspable_pose(const Problem& problem, const Options& options,
                                          const geometry::Polygon::Edge& edge,
                                          std::mt19937_64& rng) {
  constexpr double kTwoPi = 6.28318530717958647692;
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(rng);
  };
  poll();
  const Eigen::Matrix2d R = Eigen::Rotation2Dd(uniform(0, kTwoPi)).toRotationMatrix();
  const Eigen::RowVector2d inward_O = edge.inward.transpose() * R;
  const double farthest =
      -(inward_O * problem.object.outermost()).minCoeff();          // outwards of O's origin
  const double com_in = inward_O * problem.object.com().head<2>();  // inwards of O's origin
  const double max_overhang = farthest + com_in - options.com_margin;
  if (max_overhang < options.min_overhang) return std::nullopt;
  const double overhang = uniform(options.min_overhang, max_overhang);
  Planar object_S = Planar::Identity();
  object_S.linear() = R;
  object_S.translation() =
      edge.a + uniform(0, 1) * (edge.b - edge.a) + (farthest - overhang) * edge.inward;
  return object_S;
}

}  // namespace graspless::slide
