// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A function u(t) whose second derivative is at most U'' keeps within U'' w^2 / 8 of the straight
// line between its values at the ends of an interval of width w, and its first derivative keeps
// within U'' w / 2 of that line's slope. Both hold for vectors.
#include "slide/check/finger_span.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graspless::slide {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Range of a function, and bounds on its derivatives.
struct Range {
  double min, max, first, second;

  double largest() const { return std::max(std::abs(min), std::abs(max)); }
  /// Smallest cosine of an angle whose sine the function is; 0 if the sine leaves [-1, 1].
  double least_cosine() const {
    const double most = largest();
    return most < 1 ? std::sqrt(1 - most * most) : 0;
  }
};

double off(double second, double width) { return width > 0 ? second * width * width / 8 : 0; }

double steepest(double change, double second, double width) {
  return width > 0 ? change / width + second * width / 2 : 0;
}

Range between(double from, double to, double second, double width) {
  const double beyond = off(second, width);
  return {std::min(from, to) - beyond, std::max(from, to) + beyond,
          steepest(std::abs(to - from), second, width), second};
}

double arc_sine(double sine) { return std::asin(std::clamp(sine, -1.0, 1.0)); }

/// Bounds on the first and second derivative of the contact's distance from the commanded tip,
///   L (cos(bent) - cos(pitch)) + r (touch_pitch - bent),
/// as a function of the sines of both angles.
Range shift_of(const Hand& hand, const Range& bent, const Range& pitch) {
  const double L = hand.flexure_length, r = hand.tip_radius;
  const double c = bent.least_cosine(), C = pitch.least_cosine();
  if (c == 0 || C == 0) return {0, 0, kInfinity, kInfinity};
  const double by_bent = (L * bent.largest() + r) / c, by_pitch = L * pitch.largest() / C;
  const double curved = (L + r * bent.largest()) / (c * c * c) * bent.first * bent.first +
                        L / (C * C * C) * pitch.first * pitch.first;
  return {0, 0, by_bent * bent.first + by_pitch * pitch.first,
          curved + by_bent * bent.second + by_pitch * pitch.second};
}

}  // namespace

FingerSpan finger_span(const Hand& hand, const ReplayedFinger& from, const ReplayedFinger& to,
                       const scene::FrameRates& rates, double width) {
  const double bend = rates.turn * rates.turn;  // of directions fixed in the finger
  const Range depth = between(from.depth, to.depth, rates.curvature, width);
  const Range pitch = between(std::sin(from.pitch), std::sin(to.pitch), bend, width);
  const Range roll = between(std::sin(from.roll), std::sin(to.roll), bend, width);
  const bool flexes = hand.finger_model == FingerModel::flexure;
  const double L = hand.flexure_length;
  const Range bent =
      flexes ? between(std::sin(from.pitch) - from.depth / L, std::sin(to.pitch) - to.depth / L,
                       bend + rates.curvature / L, width)
             : pitch;
  FingerSpan span{};
  span.min_depth = depth.min;
  span.max_depth = depth.max;
  span.min_pitch = arc_sine(pitch.min);
  span.max_pitch = arc_sine(pitch.max);
  span.max_roll = arc_sine(roll.largest());
  span.min_bent = arc_sine(bent.min);
  span.max_bent = arc_sine(bent.max);
  span.min_other_finger_up = between(from.other_finger_up, to.other_finger_up, bend, width).min;
  span.commanded_off = off(rates.curvature, width);

  // The heading is the horizontal part v of X_F, turned and scaled to length 1: its derivatives are
  // at most |v'| / |v| and |v''| / |v| + 3 |v'|^2 / |v|^2.
  const double level = roll.least_cosine();
  const double heading_bend = level > 0 ? bend / level + 3 * bend / (level * level) : kInfinity;
  const double turn_rate = steepest((to.heading - from.heading).norm(), heading_bend, width);
  span.heading_off = off(heading_bend, width);
  span.turn = turn_rate * width;

  const Range shift = flexes ? shift_of(hand, bent, pitch) : Range{0, 0, 0, 0};
  const double longest = (from.effective - from.commanded).norm() + shift.first * width;
  const double contact_bend =
      rates.curvature + shift.second + 2 * shift.first * turn_rate + longest * heading_bend;
  span.effective_off = off(contact_bend, width);
  span.effective_path =
      steepest((to.effective - from.effective).norm(), contact_bend, width) * width;
  return span;
}

}  // namespace graspless::slide
