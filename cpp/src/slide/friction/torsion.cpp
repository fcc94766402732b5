// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/torsion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "graspless/watch.hpp"

#include "slide/friction/pressed.hpp"

namespace graspless::slide {
namespace {

constexpr double kMinStep = 1e-5;  // a shorter step has no direction [m]

/// Normal force [N] while the object moves by `step` [m].
double press_on(const Problem& problem, const PressedRow& at, const Eigen::Vector2d& step) {
  const double along = step.norm() < kMinStep ? 0 : at.tip.heading.dot(step.normalized());
  return dragging_force(problem.hand, at.depth, at.tip.pitch, along, problem.support.friction(),
                        weight(problem));
}

}  // namespace

double press_force(const Hand& hand, double depth, double pitch) {
  if (hand.finger_model == FingerModel::impedance)
    return std::max(0.0, hand.wrist_stiffness * depth);
  if (hand.finger_model != FingerModel::flexure) return hand.press_force;
  const double flexed = yielded_pitch(hand, depth, pitch);
  return std::max(
      0.0, hand.flexure_stiffness * (pitch - flexed) / (hand.flexure_length * std::cos(flexed)));
}

double dragging_force(const Hand& hand, double depth, double pitch, double along, double friction,
                      double weight) {
  if (hand.finger_model != FingerModel::flexure) return press_force(hand, depth, pitch);
  // Moments about the flexure: k (pitch - b') = L cos b' N - L sin b' along friction (N + weight).
  const double lever = along * friction * std::tan(yielded_pitch(hand, depth, pitch));
  if (lever >= 1) return std::numeric_limits<double>::infinity();
  return std::max(0.0, (press_force(hand, depth, pitch) + lever * weight) / (1 - lever));
}

double max_turn_per_length(const Problem& problem, double radius, double press) {
  if (press <= 0) return 0;
  const double drag = drag_ratio(problem, press);
  const double R = drag * drag, lever = 4 * radius / problem.hand.pad_width;
  if (R >= 1) return 0;
  const double excess = R * lever * lever - 1;
  if (excess <= 0) return std::numeric_limits<double>::infinity();
  return std::sqrt((1 - R) / excess) / radius;
}

double drag_load(const Problem& problem, const Plan& plan) {
  return drag_load(problem, pressed_rows(problem, plan));
}

double drag_load(const Problem& problem, const std::vector<PressedRow>& rows) {
  double largest = 0;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    poll();
    const PressedRow& now = rows[row];
    const Eigen::Vector2d step = now.p_SC - rows[row - 1].p_SC;
    if (step.norm() < kMinStep) continue;
    const double press = press_on(problem, now, step);
    const Planar X_ST =
        effective_tip(problem.hand, now.tip, problem.object.top(), rows.front().tip.pitch);
    const Eigen::Vector2d p_TC = (now.p_SM - X_ST.translation()) / (1 + press / weight(problem));
    const double e = step.normalized().dot(Eigen::Vector2d(p_TC.y(), -p_TC.x()));
    const double w = problem.hand.pad_width / 4;
    largest = std::max(largest, drag_ratio(problem, press) * std::hypot(1, e / w));
  }
  return largest;
}

Trailing trailing(const Problem& problem, const Plan& plan) {
  return trailing(problem, pressed_rows(problem, plan));
}

Trailing trailing(const Problem& problem, const std::vector<PressedRow>& rows) {
  Trailing found;
  if (problem.hand.finger_model != FingerModel::impedance) return found;
  const double K = problem.hand.wrist_stiffness, mu_s = problem.support.friction(),
               mu_p = problem.hand.pad_friction;
  for (const PressedRow& row : rows) {
    const double press = press_force(problem.hand, row.depth, row.tip.pitch);
    found.left = mu_s * (press + weight(problem)) / K;
    found.sliding = std::max(found.sliding, found.left);
  }
  if (mu_p > mu_s)  // otherwise the pad slips as soon as it lifts
    found.left = std::min(found.left, mu_s * mu_p * weight(problem) / ((mu_p - mu_s) * K));
  return found;
}

Turning turning(const Problem& problem, const Plan& plan) {
  return turning(problem, pressed_rows(problem, plan));
}

Turning turning(const Problem& problem, const std::vector<PressedRow>& rows) {
  Turning found;
  found.allowed_turn_rate = std::numeric_limits<double>::infinity();
  for (std::size_t row = 1; row < rows.size(); ++row) {
    poll();
    const PressedRow &before = rows[row - 1], &now = rows[row];
    const Eigen::Vector2d step = now.p_SC - before.p_SC;
    const double distance = step.norm();
    const double turn = std::abs(std::remainder(now.yaw - before.yaw, 2 * M_PI));
    const double allowed = max_turn_per_length(problem, now.radius, press_on(problem, now, step));
    if (distance >= kMinStep) found.max_turn_rate = std::max(found.max_turn_rate, turn / distance);
    found.allowed_turn_rate = std::min(found.allowed_turn_rate, allowed);
    if (std::isfinite(allowed)) found.lag += std::max(0.0, turn - allowed * distance);
  }
  return found;
}

}  // namespace graspless::slide
