// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/geometry/complex.hpp"

namespace graspless::geometry {

/// A closed polyline on a cloud: one of a shortest basis of the first homology group of K_d.
struct Loop {
  Eigen::Matrix3Xd points;    ///< corners in order; the last is joined to the first [m]
  std::vector<int> vertices;  ///< the same, as columns of the cloud given
  double length = 0;          ///< [m]
  /// The loop's class lives in K_d for birth < d <= death [m]: death / birth says how sure it is,
  /// and what is wider than the death does not pass. Of a thinned cloud: in its complex.
  double birth = 0, death = 0;
  /// How thick what the loop runs along is, at its thinnest place [m]; a hand must close around it.
  double thickness = 0;
};

/// How to look for loops.
struct LoopOptions {
  /// d [m]; 0 takes the widest plateau, and the lowest one with the same loops (they are finer).
  double max_edge_length = 0;
  /// Instead of the widest, the lowest plateau whose ratio is at least `lowest_ratio`: splits less
  /// sure holes off, and takes patches that the camera missed for holes.
  bool lowest_plateau = false;
  double lowest_ratio = 1.4;
  /// Below this ratio upper / lower of the plateau there is no reliable hole.
  double min_ratio = 1.2;
  /// Clouds with more points are thinned to about max_points / 2 before loops are looked for.
  int max_points = 5000;
  /// After thinning: shorten the loops on the whole cloud, of at most 10^6 points.
  bool polish = false;
  /// Leave out loops that run around a thick handle instead of along it.
  bool drop_meridians = true;
};

/// Throws std::invalid_argument that names the option, its value and what it may be.
GRASPLESS_API void validate(const LoopOptions& options);

enum class LoopStatus {
  found,
  no_reliable_hole,  ///< see Loops::betti
};

/// The loops of a cloud, and what they were taken from.
struct Loops {
  LoopStatus status = LoopStatus::no_reliable_hole;
  std::string reason;           ///< one sentence, for people
  std::vector<Loop> loops;      ///< shortest first
  std::vector<Loop> meridians;  ///< left out: they run around a handle, not along it
  Complex complex;              ///< K_d, of the thinned cloud where it was thinned
  BettiCurve betti;             ///< of the same cloud
  Plateau plateau;              ///< the one chosen; zero where d was given
  std::vector<std::string> warnings;
};

/// The shortest basis of H_1(K_d; Z_2): loops through the holes of what the cloud was taken from
/// (Dey, Sun, Wang 2010), exact up to `max_points`. Points are the columns [m]. Throws
/// std::invalid_argument on fewer than 20 distinct points, values that are not finite, points in a
/// plane, more than 10^7 points (10^6 to polish), or bad options.
GRASPLESS_API Loops shortest_loops(const Eigen::Matrix3Xd& points, const LoopOptions& options = {});

/// A place on a loop where a hand may clasp: p and p' of the paper.
struct ClaspTarget {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();     ///< [m]
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();  ///< unit
};

/// `count` targets at equal arc length, the first at the loop's first corner. Tangents are the
/// chords of the loop over an arc as long as their distance, so that they do not follow the zigzag
/// of the cloud. Throws std::invalid_argument unless count is positive and the loop has length.
GRASPLESS_API std::vector<ClaspTarget> clasp_targets(const Eigen::Matrix3Xd& loop, int count);

}  // namespace graspless::geometry
