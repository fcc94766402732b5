// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/friction/pad.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::slide {
namespace {

// Half widths of independent intervals add up as their root sum square, times this, and to their
// sum at most: 99 % of the sums of two uniform values with equal spreads are below.
constexpr double kLikely = 1.25;

constexpr double kLeastPress = 1e-9;  // relative to the weight

/// N / (m g) while the pad moves along a unit vector, or in no direction.
double press_along(const Problem& problem, const Pad& pad, const Eigen::Vector2d& way) {
  const double press = dragging_force(problem.hand, pad.depth, pad.pitch, pad.heading.dot(way),
                                      problem.support.friction(), weight(problem));
  return std::max(kLeastPress, press / weight(problem));
}

}  // namespace

double combined(const std::array<double, 4>& spreads) {
  double sum = 0, squares = 0;
  for (const double spread : spreads) {
    sum += spread;
    squares += spread * spread;
  }
  return std::min(sum, kLikely * std::sqrt(squares));
}

double weakness(const Problem& problem, const Options& options, double press, double spread) {
  const double share = weight(problem) / (weight(problem) + press);  // of the support's pressure
  return combined({options.friction_spread, options.friction_spread, share * options.mass_spread,
                   share * spread});
}

Pads::Pads(const Problem& problem, const Options& options)
    : problem_(problem), options_(options), longest_(problem.hand) {
  longest_.flexure_length *= 1 + options.flexure_spread;
}

Pads::Softness Pads::softness(double depth, double pitch, double press) const {
  constexpr double kStep = 1e-4;  // of the depth [m]
  const Hand& hand = problem_.hand;
  const double deeper =
      combined({options_.height_spread, options_.thickness_spread * problem_.object.thickness()});
  if (hand.finger_model == FingerModel::impedance) return {deeper / std::max(depth, kStep), 0};
  if (hand.finger_model != FingerModel::flexure || press <= 0) return {0, 0};
  const auto shift = [&](const Hand& of, double at) {
    return contact_shift(of, at, pitch, options_.pitch);
  };
  const double by_depth = (press_force(hand, depth + kStep, pitch) / press - 1) / kStep * deeper;
  const double by_length = press_force(longest_, depth, pitch) / press - 1;
  const double shifted = shift(hand, depth);
  return {combined({options_.flexure_spread, std::abs(by_depth), std::abs(by_length)}),
          combined({std::abs(shift(hand, depth + kStep) - shifted) / kStep * deeper,
                    std::abs(shift(longest_, depth) - shifted)})};
}

Pad Pads::at(const Planar& X_ST, double depth, double pitch) const {
  const double press = press_force(problem_.hand, depth, pitch);
  const Softness soft = softness(depth, pitch, press);
  const Eigen::Vector2d heading = X_ST.linear().col(0);
  return {X_ST.translation(),
          heading,
          std::atan2(heading.y(), heading.x()),
          depth,
          pitch,
          slide::weakness(problem_, options_, press, soft.press),
          soft.shift,
          1};
}

Pad Pads::at(const PressedRow& row) const {
  const double top = problem_.object.top();
  Pad pad =
      at(effective_tip(problem_.hand, row.tip, top, options_.pitch), row.depth, row.tip.pitch);
  pad.radius = row.radius / problem_.object.mean_distance(row.X_SO.inverse() * row.p_SC);
  return pad;
}

Leg::Leg(const Problem& problem, const Pad& from, const Pad& to) : from_(from), to_(to) {
  const Eigen::Vector2d way = to.position - from.position;
  const double length = way.norm();
  const Eigen::Vector2d along = length > 0 ? Eigen::Vector2d(way / length) : way;
  twist_ << way, std::remainder(to.yaw - from.yaw, 2 * M_PI);
  press_from_ = press_along(problem, from, along);
  press_to_ = press_along(problem, to, along);
}

}  // namespace graspless::slide
