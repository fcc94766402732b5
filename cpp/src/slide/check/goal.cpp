// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Part of check(): where the object ends, and how it is grasped there.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "graspless/watch.hpp"

#include "geometry/convex_hull.hpp"
#include "geometry/segment.hpp"
#include "slide/check/examination.hpp"
#include "slide/check/replay.hpp"
#include "text.hpp"

namespace graspless::slide {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kNeighbours = 2.5;  // points of one part are linked over this many spacings

Eigen::Vector2d mean(const Points& points) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

const Eigen::Vector2d& closest(const Points& points, const Eigen::Vector2d& to) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if ((points[i] - to).norm() < (points[best] - to).norm()) best = i;
  }
  return points[best];
}

/// Returns all points that are as near to `to` as the closest one. A symmetric object has several.
Points nearly_closest(const Points& points, const Eigen::Vector2d& to) {
  const double least = (closest(points, to) - to).norm();
  Points found;
  for (const auto& p : points) {
    if ((p - to).norm() <= least + kSame) found.push_back(p);
  }
  return found;
}

/// The edge nearest to a point outside. Beyond a corner both edges are equally near: the one whose
/// line is farther away.
geometry::Polygon::Edge edge_beside(const geometry::Polygon& Q, const Eigen::Vector2d& p) {
  geometry::Polygon::Edge found{};
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < Q.size(); ++i) {
    const auto edge = Q.edge(i);
    const double distance = geometry::distance_to_segment(p, edge.a, edge.b);
    const double beyond = edge.inward.dot(edge.a - p);
    const bool tie = std::abs(distance - nearest) <= 1e-9;
    if (tie ? beyond <= found.inward.dot(found.a - p) : distance > nearest) continue;
    nearest = distance;
    found = edge;
  }
  return found;
}

/// Points of the largest group whose neighbours are at most `distance` [m] apart, by relabelling.
Points largest_group(const Points& points, double distance) {
  std::vector<std::size_t> label(points.size());
  std::iota(label.begin(), label.end(), std::size_t{0});
  for (std::size_t i = 0; i < points.size(); ++i) {
    poll();
    for (std::size_t j = 0; j < i; ++j) {
      if (label[i] == label[j] || (points[i] - points[j]).norm() > distance) continue;
      const auto [kept, merged] = std::minmax({label[i], label[j]});  // copies: both change
      std::replace(label.begin(), label.end(), merged, kept);
    }
  }
  std::vector<std::size_t> size(points.size(), 0);
  for (const std::size_t l : label) ++size[l];
  const auto largest =
      static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  Points group;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (label[i] == largest) group.push_back(points[i]);
  }
  return group;
}

}  // namespace

/// True if `p` lies inside the outline (not on it), and near a point of the part that sticks out.
bool Examination::is_held_at(const Eigen::Vector2d& p, const std::vector<Eigen::Vector2d>& out,
                             const Eigen::Isometry3d& X_SO) const {
  const Eigen::Vector3d p_O = X_SO.inverse() * Eigen::Vector3d(p.x(), p.y(), 0);
  return (closest(out, p) - p).norm() <= kNeighbours / 2 * problem_.object.spacing() + kRound &&
         signed_depth(problem_.object.outline().vertices(), p_O.head<2>()) > kRound;
}

Examination::Protrusion Examination::protrusion() const {
  const Eigen::Isometry3d X_SO = X_SW_ * plan_.X_WO_goal;
  const geometry::Polygon& Q = problem_.support.polygon();
  std::vector<Eigen::Vector2d> out;
  for (const auto& p_O : problem_.object.points().colwise()) {
    poll();
    const Eigen::Vector2d p = (X_SO * Eigen::Vector3d(p_O.x(), p_O.y(), 0)).head<2>();
    if (signed_depth(Q.vertices(), p) < 0) out.push_back(p);
  }
  Protrusion result;
  result.any = !out.empty();
  if (!result.any) return result;
  result.is_over_unusable_edge =
      problem_.support.has_unusable_edges() && std::any_of(out.begin(), out.end(), [&](auto& p) {
        poll();
        return !problem_.support.is_usable(edge_beside(Q, p).index);
      });
  result.center = mean(out);
  if (!is_held_at(result.center, out, X_SO)) {
    out = largest_group(out, kNeighbours * problem_.object.spacing());
    result.center = mean(out);
    if (!is_held_at(result.center, out, X_SO)) {
      const Eigen::Vector3d hand = X_SW_ * plan_.X_WH_grasp.translation();
      result.center = closest(nearly_closest(out, result.center), hand.head<2>());
    }
  }
  result.edge = edge_beside(Q, result.center);
  for (const auto& p : out) {
    result.overhang = std::max(result.overhang, result.edge.inward.dot(result.edge.a - p));
  }
  return result;
}

/// Conditions 1 and 2 of IsPairValid.
void Examination::check_pair() {
  const Protrusion out = protrusion();
  if (!out.any || !(out.overhang >= options_.min_overhang - 1e-9)) {
    fault("goal", "the object sticks out by only " + figure(out.overhang) + " m");
  }
  if (out.is_over_unusable_edge) {
    fault("goal", "the object sticks out over an edge of the support that is not usable");
  }
  if (!(std::abs(out.overhang - plan_.overhang) <= kSame)) {
    fault("goal", "the overhang is not what the plan says: it is " + figure(out.overhang) + " m");
  }
  check_held_up();
}

/// The object lies where it is to be left.
void Examination::check_end() {
  const Eigen::Isometry3d X_OO = problem_.X_WO_end->inverse() * plan_.X_WO_goal;
  constexpr double kFlat = 0.002, kTilt = 0.0175;  // of X_WO_end against the support [m, rad]
  const Eigen::Vector3d off = X_OO.translation(), turn = X_OO.linear() * Eigen::Vector3d::UnitX();
  if (!(off.head<2>().norm() <= kEndDistance + kFlat * kTilt && std::abs(off.z()) <= 2 * kFlat) ||
      !(std::abs(std::atan2(turn.y(), turn.x())) <= kEndTurn + kSame)) {
    fault("goal", "the object is not at its end: it is " + figure(off.norm()) + " m off");
  }
  check_held_up();
}

/// Condition 2 of IsPairValid: the support holds the object.
void Examination::check_held_up() {
  Eigen::Vector3d com_W = plan_.X_WO_goal * problem_.object.com();
  const Eigen::Vector3d n = problem_.support.normal_W();
  // Along gravity, onto the surface.
  com_W.z() -= n.dot(com_W - problem_.support.X_WS().translation()) / n.z();
  const double inside =
      signed_depth(problem_.support.polygon().vertices(), (X_SW_ * com_W).head<2>());
  if (!(inside >= options_.com_margin - 1e-9)) {
    fault("goal", "the centre of mass is only " + figure(inside) + " m inside the edge");
  }
  if (!problem_.object.is_hollow()) return;
  const double held = held_by_rim(planar(X_SW_ * plan_.X_WO_goal), (X_SW_ * com_W).head<2>());
  if (!(held >= options_.com_margin - kRimSpacing)) {
    fault("goal", "resting on its rim alone, the object tips: the centre of mass is only " +
                      figure(held) + " m inside the part of it on the support");
  }
}

/// An object that rests on its rim alone must not tip: in no direction may the whole part of the
/// rim that is on the support end short of the centre of mass. Returns how far it goes on, at least
/// [m]; negative if it does.
double Examination::held_by_rim(const Planar& X_SO, const Eigen::Vector2d& com) const {
  constexpr int kDirections = 720;
  const Eigen::Matrix2Xd& rim_O = problem_.object.outline().vertices();
  Points held;
  for (Eigen::Index i = 0; i < rim_O.cols(); ++i) {
    poll();
    const Eigen::Vector2d a = rim_O.col(i), side = rim_O.col((i + 1) % rim_O.cols()) - a;
    const int count = static_cast<int>(std::ceil(side.norm() / kRimSpacing));
    for (int k = 0; k < count; ++k) {
      const Eigen::Vector2d p = X_SO * Eigen::Vector2d(a + side * k / count);
      if (signed_depth(problem_.support.polygon().vertices(), p) >= 0) held.push_back(p);
    }
  }
  if (held.empty()) return -std::numeric_limits<double>::infinity();
  const Eigen::Matrix2Xd hull = geometry::convex_outline(Eigen::Map<const Eigen::Matrix2Xd>(
      held.front().data(), 2, static_cast<Eigen::Index>(held.size())));
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kDirections; ++k) {
    const double angle = k * 2 * M_PI / kDirections;
    const Eigen::Vector2d u(std::cos(angle), std::sin(angle));
    least = std::min(least, (u.transpose() * (hull.colwise() - com)).maxCoeff());
  }
  return least;
}

/// Largest height of the object around the middle of what sticks out, in O, as far as from there to
/// its end [m].
double Examination::highest_near(const Eigen::Vector2d& p_O, const Protrusion& out) const {
  const double reach = std::max(0.02, out.overhang - out.edge.inward.dot(out.edge.a - out.center));
  const auto& map = problem_.object.heights();
  if (!map) return problem_.object.thickness();
  double highest = map->at(p_O);
  for (Eigen::Index i = 0; i < map->heights.rows(); ++i) {
    for (Eigen::Index j = 0; j < map->heights.cols(); ++j) {
      const Eigen::Vector2d cell(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5);
      if ((map->corner + map->cell * cell - p_O).norm() <= reach)
        highest = std::max(highest, map->heights(i, j));
    }
  }
  return highest;
}

/// Condition 3: the hand reaches H_g along a straight line.
void Examination::check_grasp() {
  const Segment& grasp = segment("grasp");
  const int H = problem_.robot.frame(problem_.hand.grasp_frame);
  if (!scene::is_same(problem_.robot.pose(H, grasp.positions.back()), plan_.X_WH_grasp, 1e-5)) {
    fault("grasp", "does not end at X_WH_grasp");
  }
  const Protrusion out = protrusion();
  if (!out.any) return;
  const Eigen::Isometry3d X_SH = X_SW_ * plan_.X_WH_grasp;
  const Eigen::Vector3d in(out.edge.inward.x(), out.edge.inward.y(), 0);
  if (!(X_SH.linear().col(2) - in).isZero(kSame)) {
    fault("grasp", "the hand does not approach perpendicularly to the nearest edge");
  }
  if (!(std::abs(X_SH.linear()(2, 1)) >= 1 - kSame)) {
    fault("grasp", "the finger plane is not vertical");
  }
  const Eigen::Vector2d center_O = (planar(X_SW_ * plan_.X_WO_goal).inverse() * out.center);
  const Eigen::Vector3d where(out.center.x(), out.center.y(), highest_near(center_O, out) / 2);
  const double from_edge = -in.head<2>().dot(out.center - out.edge.a),
               deep = in.dot(X_SH.translation() - where);
  const bool is_deep = options_.deep_grasp && deep > 0 && deep < from_edge;
  if (!(X_SH.translation() - where - (is_deep ? deep : 0) * in).isZero(kSame)) {
    fault("grasp", options_.deep_grasp
                       ? "the hand is not between the edge and the middle of what sticks out"
                       : "the hand is not at the middle of the part that sticks out");
  }
  check_straight(grasp);
}

/// The hand must close from open towards closed while the arm is at rest, and stop when it touches
/// the object.
void Examination::check_closing() {
  constexpr double kPrecision = 2e-4;  // of the joint that moves most, at the touch [rad or m]
  const Segment& close = segment("close");
  const Eigen::VectorXd open = close.positions.front();
  const Eigen::VectorXd within = problem_.robot.clamp(open);
  Eigen::VectorXd stroke = problem_.robot.state(problem_.hand.closed, within) - open;
  for (int joint : problem_.robot.group(problem_.hand.arm)) stroke[joint] = 0;
  Eigen::Index fastest = 0;
  const double travel = stroke.cwiseAbs().maxCoeff(&fastest);
  double before = 0;
  for (std::size_t i = 0; i < close.positions.size(); ++i) {
    const Eigen::VectorXd moved = close.positions[i] - open;
    const double t = travel > 0 ? moved[fastest] / stroke[fastest] : 0;
    if (!(moved - t * stroke).isZero(kSame) || t < before - kSame || t > 1 + kSame) {
      fault(close, i, "must close the hand, and move the hand alone");
    }
    before = t;
  }
  const Eigen::Isometry3d& X_WO = close.object_poses.back();
  if (strict_.touching(close.positions.back(), X_WO).empty()) {
    fault("close", "no finger touches the object at the end");
  }
  const double just_before = travel > 0 ? std::max(0.0, before - kPrecision / travel) : 0;
  if (!strict_.touching(open + just_before * stroke, X_WO).empty()) {
    fault("close", "the hand closes further after it has touched the object");
  }
}

void Examination::check_straight(const Segment& grasp) {
  const robot::Robot& robot = problem_.robot;
  const int H = robot.frame(problem_.hand.grasp_frame);
  double back = 0;
  scene::replay_rows(problem_.robot, grasp.positions,
                     [&](std::size_t row, const Eigen::VectorXd& q) {
                       const Eigen::Isometry3d X_HH = plan_.X_WH_grasp.inverse() * robot.pose(H, q);
                       if (X_HH.translation().head<2>().norm() > kSideways ||
                           Eigen::AngleAxisd(X_HH.linear()).angle() > kTurned) {
                         fault(grasp, row, "the hand does not approach in a straight line");
                       }
                       back = std::max(back, -X_HH.translation().z());
                     });
  if (back < options_.grasp_approach - 1e-4) {
    fault("grasp", "the straight approach is only " + figure(back) + " m long");
  }
}

}  // namespace graspless::slide
