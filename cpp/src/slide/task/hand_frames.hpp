// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "graspless/slide/options.hpp"
#include "graspless/slide/problem.hpp"

namespace graspless::slide {

/// Throws std::invalid_argument that names the frame if F or H of the hand is not oriented as
/// docs/notation.md requires.
void check_hand_frames(const Problem& problem);

/// Throws std::invalid_argument with both lengths if the closed fingers stay farther apart than the
/// object is thick.
void check_closing(const Problem& problem);

/// The sliding finger's shapes, with the hand open, seen from its frame F.
class FingerProfile {
 public:
  explicit FingerProfile(const Problem& problem);
  /// Depth of the shapes below the origin of F at a pitch [m].
  double below(double pitch) const;
  /// Upper bound on below() for all pitches between two, up to a right angle apart [m].
  double below(double min_pitch, double max_pitch) const;

 private:
  std::vector<geometry::PlacedShape> shapes_;  // in F
};

/// Depth of the sliding finger's shapes below the contact that check() allows [m]: 5 mm for a rigid
/// finger, 8 mm for one that yields. The round end of a finger drawn as a capsule reaches that far
/// below its outermost point.
double allowed_sink(const Hand& hand);

/// Lengths along the object's normal of the open hand at a grasp: distance between the fingers,
/// thickness of one of their links, and how far they reach beyond the object's faces.
std::string jaw_lengths(const Problem& problem, const Eigen::VectorXd& q,
                        const Eigen::Isometry3d& X_WO, const std::string& link);

/// Throws std::invalid_argument that names the frame F if the finger's shapes do not reach it
/// within 3 mm, or sink deeper than allowed_sink(), anywhere in the bands of depth and pitch.
void check_finger_fits(const Problem& problem, const Options& options);

}  // namespace graspless::slide
