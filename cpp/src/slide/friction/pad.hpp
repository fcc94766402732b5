// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "slide/friction/pressed.hpp"

/// How the pad moves and presses along a slide, and how uncertain that is.
namespace graspless::slide {

/// Returns the half width of a sum of independent errors, from their half widths.
double combined(const std::array<double, 4>& spreads);

/// One place of the pad on its way.
struct Pad {
  Eigen::Vector2d position, heading;
  double yaw, depth, pitch;
  double weakness;      ///< logarithm of the ratio of the weakest and the task's friction
  double shift_spread;  ///< of the contact [m]
  double radius;        ///< true mean distance of the object's points, over Object::mean_distance()
};

/// Makes the pads of a slide.
class Pads {
 public:
  Pads(const Problem& problem, const Options& options);

  /// The pad at an effective tip.
  Pad at(const Planar& X_ST, double depth, double pitch) const;
  Pad at(const PressedRow& row) const;

 private:
  /// Relative spread of the press, and the spread of the contact's shift [m].
  struct Softness {
    double press, shift;
  };
  Softness softness(double depth, double pitch, double press) const;

  const Problem& problem_;
  const Options& options_;
  Hand longest_;  // with the longest flexure
};

/// One point of the way of the pad.
struct PadPoint {
  Eigen::Vector2d position;
  double weight;            ///< of the object, relative to the press: m g / N
  double weakness, radius;  ///< as in Pad
};

/// Straight way of the pad between two places, on which the press changes evenly.
class Leg {
 public:
  Leg(const Problem& problem, const Pad& from, const Pad& to);

  const Eigen::Vector3d& twist() const { return twist_; }  ///< way [m] and turn [rad]
  /// Unit vector along the line contact, across the heading.
  Eigen::Vector2d line_at(double t) const {
    const double yaw = from_.yaw + t * twist_.z();
    return {-std::sin(yaw), std::cos(yaw)};
  }
  PadPoint at(double t) const {
    return {from_.position + t * twist_.head<2>(), weight_per_press(t),
            from_.weakness + t * (to_.weakness - from_.weakness),
            from_.radius + t * (to_.radius - from_.radius)};
  }

 private:
  /// 0 where the finger jams, and presses without limit.
  double weight_per_press(double t) const {
    if (std::isinf(press_from_) || std::isinf(press_to_))
      return (1 - t) / press_from_ + t / press_to_;
    return 1 / (press_from_ + t * (press_to_ - press_from_));
  }

  const Pad &from_, &to_;
  Eigen::Vector3d twist_;
  double press_from_, press_to_;  // relative to the weight
};

/// Returns the logarithm of the factor by which mu_s (N + m g) / (mu_p N) is larger in the worst
/// 1 % of the worlds. `spread` is that of the press, relative.
double weakness(const Problem& problem, const Options& options, double press, double spread);

}  // namespace graspless::slide
