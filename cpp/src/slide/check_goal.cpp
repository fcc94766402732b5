// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(), where the object ends and how it is grasped there.
#include <algorithm>
#include <cmath>
#include <limits>

#include "slide/examination.hpp"
#include "slide/replay.hpp"

namespace graspless::slide {

/// The edge that the hand faces: of those across its way, the nearest to it.
geometry::Polygon::Edge Examination::faced_edge() {
  const geometry::Polygon& Q = problem_.support.polygon();
  const Eigen::Isometry3d X_SH = X_SW_ * plan_.X_WH_grasp;
  const Eigen::Vector2d in = X_SH.linear().col(2).head<2>(), hand = X_SH.translation().head<2>();
  geometry::Polygon::Edge faced = Q.edge(0);
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < Q.size(); ++i) {
    const auto edge = Q.edge(i);
    const double along = std::clamp(
        (hand - edge.a).dot(edge.b - edge.a) / (edge.b - edge.a).squaredNorm(), 0.0, 1.0);
    const double distance = (hand - edge.a - along * (edge.b - edge.a)).norm();
    if (edge.inward.dot(in) < 1 - 1e-6 || distance >= nearest) continue;
    nearest = distance;
    faced = edge;
  }
  if (!std::isfinite(nearest)) fault("goal", "the hand does not come perpendicularly to an edge");
  return faced;
}

/// Conditions 1 and 2 of IsPairValid.
void Examination::check_pair() {
  const Eigen::Isometry3d X_SO = X_SW_ * plan_.X_WO_goal;
  const geometry::Polygon& Q = problem_.support.polygon();
  const geometry::Polygon::Edge edge = faced_edge();
  double overhang = 0;
  for (const auto& p_O : problem_.object.points().colwise()) {
    const Eigen::Vector2d p = (X_SO * Eigen::Vector3d(p_O.x(), p_O.y(), 0)).head<2>();
    if (inside_by(Q.vertices(), p) < 0) overhang = std::max(overhang, -edge.inward.dot(p - edge.a));
  }
  if (!(overhang >= options_.min_overhang - 1e-9)) {
    fault("goal", "the object sticks out by " + figure(overhang) + " m only");
  }
  if (std::abs(overhang - plan_.overhang) > kSame)
    fault("goal", "the overhang is not what the plan says");
  Eigen::Vector3d com_W = plan_.X_WO_goal * problem_.object.com();
  const Eigen::Vector3d n = problem_.support.normal_W();
  com_W.z() -= n.dot(com_W - problem_.support.X_WS().translation()) /
               n.z();  // along gravity, onto the surface
  const double inside = inside_by(Q.vertices(), (X_SW_ * com_W).head<2>());
  if (inside < options_.com_margin - 1e-9) {
    fault("goal", "the centre of mass is inside by " + figure(inside) + " m only");
  }
}

/// Condition 3: the hand arrives at H_g, straight, and closes on the object.
void Examination::check_grasp() {
  const Segment& grasp = segment("grasp");
  const robot::Robot& robot = problem_.robot;
  const int H = robot.frame(problem_.hand.grasp_frame);
  if (!is_same(robot.pose(H, grasp.positions.back()), plan_.X_WH_grasp, 1e-5)) {
    fault("grasp", "does not end at X_WH_grasp");
  }
  const Eigen::Isometry3d X_SH = X_SW_ * plan_.X_WH_grasp;
  if (std::abs(X_SH.linear()(2, 2)) > 1e-6 || std::abs(std::abs(X_SH.linear()(2, 1)) - 1) > 1e-6) {
    fault("grasp", "the finger plane is not vertical, or the hand not level with the surface");
  }
  if (std::abs(X_SH.translation().z() - problem_.object.thickness() / 2) > 1e-6) {
    fault("grasp", "the hand is not at half the object's height");
  }
  const Eigen::Isometry3d X_OH = plan_.X_WO_goal.inverse() * plan_.X_WH_grasp;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& p : problem_.object.points().colwise()) {
    nearest = std::min(nearest, (X_OH.translation().head<2>() - p).norm());
  }
  if (nearest > 0.02) fault("grasp", "the hand closes beside the object");
  check_straight(grasp);

  Replay strict(problem_, options_, Contacts::none);
  const Segment& close = segment("close");
  if (strict.touching(close.positions.back(), close.object_poses.back()).empty()) {
    fault("close", "no finger touches the object at the end");
  }
}

void Examination::check_straight(const Segment& grasp) {
  constexpr double kSideways = 0.003, kTurn = 0.03;  // [m], [rad]
  const robot::Robot& robot = problem_.robot;
  const int H = robot.frame(problem_.hand.grasp_frame);
  double back = 0;
  replay(grasp, [&](std::size_t row, const Eigen::VectorXd& q) {
    const Eigen::Isometry3d X_HH = plan_.X_WH_grasp.inverse() * robot.pose(H, q);
    if (X_HH.translation().head<2>().norm() > kSideways ||
        Eigen::AngleAxisd(X_HH.linear()).angle() > kTurn) {
      fault(grasp, row, "the hand does not come straight");
    }
    back = std::max(back, -X_HH.translation().z());
  });
  if (back < options_.grasp_approach - 1e-4) {
    fault("grasp", "the straight way is " + figure(back) + " m only");
  }
}

}  // namespace graspless::slide
