// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/slide/problem.hpp"

#include "scene/motion.hpp"

/// The finger in check(): at a configuration, and on a part of the straight motion between two.
namespace graspless::slide {

/// The finger relative to the support, computed from the pose of its frame alone.
struct ReplayedFinger {
  double depth, pitch, roll;
  double bent;             // pitch after the finger has yielded
  double other_finger_up;  // height of Y_F; the other finger must not point down
  Eigen::Vector2d commanded, effective, heading;
};

/// Bounds on the finger on a part of an edge. Its points keep within `..._off` of the straight line
/// between their places at both ends.
struct FingerSpan {
  double min_depth, max_depth, min_pitch, max_pitch, max_roll, min_bent, max_bent;
  double min_other_finger_up;
  double commanded_off, effective_off, heading_off;
  double effective_path;  ///< bound on the length of the contact's path [m]
  double turn;            ///< bound on the angle that the heading turns through [rad]
};

/// Bounds the finger between two configurations, from the finger at both and the rates of its frame
/// on the whole edge; `width` is the part of the edge that lies between them. Infinite where the
/// finger may bend by a right angle.
FingerSpan finger_span(const Hand& hand, const ReplayedFinger& from, const ReplayedFinger& to,
                       const scene::FrameRates& rates, double width);

}  // namespace graspless::slide
