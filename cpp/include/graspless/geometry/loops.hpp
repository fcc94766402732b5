// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/geometry/complex.hpp"
#include "graspless/geometry/ray_image.hpp"

namespace graspless::geometry {

/// A closed polyline on a cloud: an element of a shortest basis of H_1(K_d) (gamma of Stork 2013,
/// Sections III-B and IV-A), moved onto the surface where it crosses open space.
struct Loop {
  Eigen::Matrix3Xd points;    ///< corners in order, 3 x n [m]; the last connects to the first
  std::vector<int> vertices;  ///< indices of the corners in the input cloud
  double length = 0;          ///< length of the closed polyline [m]
  /// The loop's homology class exists in K_d for d in (birth, death] [m]. A large ratio
  /// death / birth means a reliable hole. A body wider than `death` does not pass the hole. For a
  /// downsampled cloud, K_d is the complex of the downsampled points.
  double birth = 0, death = 0;
  /// Thickness of the handle that the loop runs along, at its thinnest cross-section [m]. A hand
  /// must close around it. 0 if unknown.
  double thickness = 0;
  /// Width of the same handle in its narrowest direction [m]. Two jaws must open farther. 0 if
  /// unknown.
  double width = 0;
  /// Longest step between neighbouring corners that are too far apart to be on one surface [m]; 0
  /// if the loop runs along the surface throughout. The object may come free there.
  double gap = 0;
  /// d of the complex in which it is shortest [m]: the loop's own scale.
  double max_edge_length = 0;
  /// Share of the directions in which a ray from the middle of the hole leaves the object, on the
  /// side where fewer do. The inside of a solid is closed on at least one side.
  double openness = 0;
  /// Length of the longest step around the hole, relative to the next one. Evenly spread points
  /// have about 1. Large values mean that the object is open there, or was not seen.
  double jump = 0;
  /// Area across the rays that passed through it [m^2], for the camera that saw most of it. Rays
  /// that end on the object prove nothing. 0 without rays.
  double seen_through = 0;
  /// Share of its length that lies where no ray reached the object, in [0, 1]. 0 without rays.
  double unseen = 0;
  std::string reason;  ///< why it is uncertain or discarded; empty for a hole that was found
};

/// Options of shortest_loops().
struct LoopOptions {
  /// d of K_d [m], in [0, 10000]. 0: each hole has its own.
  double max_edge_length = 0;
  /// Least width of a hole that counts as found, relative to the gaps between the points near it:
  /// its death over the median birth of the gaps; above 1.
  double min_ratio = 2.25;
  /// Largest number of points without downsampling, in [100, 10^6]. A larger cloud is downsampled
  /// to about max_points / 2, and independent random points to a third, unless rays or
  /// max_edge_length are given.
  int max_points = 5000;
  /// Shorten the loops of a cloud of more than `max_points` on all its points, at most 10^6.
  bool polish = false;
  /// Discard loops that run around a thick handle instead of along it.
  bool drop_meridians = true;
  /// Number of threads that share the polishing, in [1, 256]. Loops do not depend on it.
  int threads = 1;
  /// The points are of all sides of the object: no loop is the edge of what a camera saw. No
  /// effect with rays.
  bool all_sides = false;
};

/// Throws std::invalid_argument that names the option, its value and the allowed range.
GRASPLESS_API void validate(const LoopOptions& options);

enum class LoopStatus {
  found,             ///< at least one loop was found
  no_reliable_hole,  ///< no class of H_1 is a hole for certain
};

/// Result of shortest_loops(): the loops of a cloud and the complex they were found in.
struct Loops {
  LoopStatus status = LoopStatus::no_reliable_hole;
  std::string reason;           ///< explanation of the status in one sentence
  std::vector<Loop> found;      ///< loops of the holes, shortest first
  std::vector<Loop> uncertain;  ///< loops that may be holes, each with a reason; shortest first
  std::vector<Loop> meridians;  ///< discarded loops: they run around a handle, not along it
  bool has_rays = false;        ///< true if rays of cameras decided which loops are holes
  int noise = 0;                ///< number of classes that do not live long enough to be listed
  Complex complex;              ///< K_d of the cloud, after downsampling, for most of the holes
  /// The part of K_d at the cloud's own resolution: edges no longer than twice the local spacing,
  /// and their triangles. d follows the holes; where it is large, K_d fills open space. Clouds
  /// without holes have one, too.
  Complex surface;
  BettiCurve betti;  ///< Betti curve of the same points
  Plateau plateau;   ///< values of d at which the holes of `complex` exist
  std::vector<std::string> warnings;
};

/// Finds the loops through the holes of the object that a cloud was taken from: a shortest basis of
/// H_1(K_d; Z_2) (Dey, Sun, Wang 2010; Stork 2013, Section IV-A). Exact for clouds of up to
/// `max_points` that are not thinned. `points`: 3 x n [m]. Throws std::invalid_argument on fewer
/// than 20 distinct points, values that are not finite, points in a plane, more than 10^7 points
/// (10^6 with `polish`), or invalid options or rays.
///
/// `rays`: of the cameras that saw the points. A loop is then a hole if rays passed through it: if
/// they are linked with it and do not end on the object. Without them the distances between the
/// points decide, which is right for points from all sides only.
GRASPLESS_API Loops shortest_loops(const Eigen::Matrix3Xd& points, const LoopOptions& options = {},
                                   const std::vector<RayImage>& rays = {});

/// A point of a loop where a hand may clasp, with its tangent: (p, p') of Stork 2013, Section IV-A.
struct ClaspTarget {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();     ///< point on the loop [m]
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX();  ///< unit vector along the loop
};

/// Returns `count` targets at equal arc length, the first at the loop's first corner. Each tangent
/// is the chord over an arc as long as the distance between targets, so it does not follow the
/// zigzag of the cloud. `loop`: corners of the closed polyline, 3 x n [m]. Throws
/// std::invalid_argument unless `count` is 1 to 10^6 and the loop has at least 3 corners and a
/// positive length.
GRASPLESS_API std::vector<ClaspTarget> clasp_targets(const Eigen::Matrix3Xd& loop, int count);

}  // namespace graspless::geometry
