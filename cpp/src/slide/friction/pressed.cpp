// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/friction/pressed.hpp"

#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

namespace graspless::slide {

double weight(const Problem& problem) { return problem.object.mass() * kGravity; }

double drag_ratio(const Problem& problem, double press) {
  return problem.support.friction() / problem.hand.pad_friction * (1 + weight(problem) / press);
}

PressedRow pressed_row(const Problem& problem, const Tip& tip, const Planar& X_SO) {
  const double depth = problem.object.top() - tip.height;
  const double press = press_force(problem.hand, depth, tip.pitch);
  const Eigen::Vector2d p_SM = X_SO * problem.object.com().head<2>().eval();
  const Eigen::Vector2d p_SC =
      (press * tip.position + weight(problem) * p_SM) / (press + weight(problem));
  const double yaw = std::atan2(X_SO.linear()(1, 0), X_SO.linear()(0, 0));
  const Eigen::Vector2d p_OC = X_SO.inverse() * p_SC;
  const double radius = (problem.object.points().colwise() - p_OC).colwise().norm().mean();
  return {tip, depth, X_SO, p_SM, p_SC, yaw, radius};
}

std::vector<PressedRow> pressed_rows(const Problem& problem, const Segment& slide) {
  const robot::Robot& robot = problem.robot;
  const int F = robot.frame(problem.hand.fingertip);
  const Eigen::Isometry3d X_SW = problem.support.X_WS().inverse();
  std::vector<PressedRow> found;
  found.reserve(slide.positions.size());
  for (std::size_t row = 0; row < slide.positions.size(); ++row) {
    poll();
    found.push_back(pressed_row(problem, tip(X_SW * robot.pose(F, slide.positions[row])),
                                planar(X_SW * slide.object_poses[row])));
  }
  return found;
}

Eigen::Vector2d pressure_center(const Problem& problem, const PressedRow& row) {
  const double press = press_force(problem.hand, row.depth, row.tip.pitch);
  const double shift = contact_shift(problem.hand, row.depth, row.tip.pitch, row.tip.pitch);
  return row.p_SC + press / (press + weight(problem)) * shift * row.tip.heading;
}

std::optional<std::size_t> tipping_row(const Problem& problem, const Options& options,
                                       const std::vector<PressedRow>& rows) {
  constexpr double kStill = 1e-6;  // [m]
  const Object& object = problem.object;
  if (object.thickness() <= object.least_width() / 2) return std::nullopt;
  const double ahead = (1 + options.friction_spread) * problem.support.friction() * object.top();
  for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
    const PressedRow& now = rows[row];
    const Eigen::Vector2d center = pressure_center(problem, now);
    const Eigen::Vector2d moved = rows[row + 1].X_SO * (now.X_SO.inverse() * center) - center;
    if (moved.norm() < kStill) continue;
    const Eigen::Vector2d p_S = center + ahead * moved.normalized();
    const bool is_borne = object.outline().depth(now.X_SO.inverse() * p_S) >= 0 &&
                          problem.support.polygon().depth(p_S) >= 0;
    if (!is_borne) return row;
  }
  return std::nullopt;
}

std::vector<PressedRow> pressed_rows(const Problem& problem, const Plan& plan) {
  const auto slide = std::find_if(plan.segments.begin(), plan.segments.end(),
                                  [](const Segment& segment) { return segment.name == "slide"; });
  if (slide == plan.segments.end()) return {};
  return pressed_rows(problem, *slide);
}

}  // namespace graspless::slide
