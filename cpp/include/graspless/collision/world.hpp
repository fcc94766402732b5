// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/solid.hpp"
#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::collision {

/// Bodies at poses, and the pairs of them that must not touch. Independent of robots.
///
/// Each query goes through a fixed list of pairs and tests the shapes' axis-aligned boxes before
/// FCL's boolean test; for one arm this is faster than a broad phase. FCL's signed distance is
/// never called, because it aborts on flush shapes (docs/architecture.md). Results are exact,
/// except for shapes within 1e-6 m of touching, where either result is possible. A mesh is tested
/// as a surface; what lies inside a closed one touches it, too. Not thread-safe: give each thread a
/// copy (copies share shapes).
class GRASPLESS_API World {
 public:
  World();
  World(const World& other);
  World& operator=(const World& other);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  /// Adds a body of one or more shapes at the identity pose; returns its index. Throws
  /// std::invalid_argument if geometry::validate rejects a shape or the name is already taken.
  int add_body(const std::string& name, const std::vector<geometry::PlacedShape>& shapes);
  int add_body(const std::string& name, const Solid& solid);
  int num_bodies() const;
  int body(const std::string& name) const;  ///< throws std::invalid_argument that lists the bodies
  const std::string& name(int body) const;
  void set_pose(int body, const Eigen::Isometry3d& X_WB);
  const Eigen::Isometry3d& pose(int body) const;
  double radius(int body) const;  ///< largest distance of a point of the body from its origin [m]

  /// Tests bodies a and b against each other from now on. No effect if they already are.
  void add_pair(int a, int b);
  void remove_pair(int a, int b);
  /// Allows contact up to a depth: body a may press into body b by up to `depth` [m] along
  /// -normal_W. In this pair, b is tested as if it were moved by `depth` along -normal_W. A depth
  /// of 0 ends the allowance. Throws std::invalid_argument on a negative depth, a pair that is not
  /// tested, or a zero normal.
  void allow_contact(int a, int b, const Eigen::Vector3d& normal_W, double depth);
  /// Demands more than touching: in this pair, the bodies count as touching unless they are proven
  /// to be more than `clearance` [m] apart, by bounds that fall short of the distance by up to 10 %
  /// (more for meshes). A clearance of 0 ends the demand. all_collisions() ignores it. Throws
  /// std::invalid_argument on a negative clearance or a pair that is not tested.
  void keep_apart(int a, int b, double clearance);
  int num_pairs() const;
  /// The bodies of a pair, the smaller index first. This, shift(), distance_bound(),
  /// proven_distance(), touches() and swallows() throw std::invalid_argument unless the index of
  /// the pair is in [0, num_pairs()).
  std::pair<int, int> pair(int index) const;
  std::vector<std::pair<int, int>> pairs() const;
  /// Displacement of the second body of a pair in its tests, in W [m]: the allowance.
  const Eigen::Vector3d& shift(int pair) const;
  /// Counter that grows when a body, a pair or an allowance is added or removed.
  int revision() const;

  /// True if any tested pair touches.
  bool collides();
  /// Returns the first touching pair found.
  std::optional<std::pair<int, int>> first_collision();
  /// Returns every touching pair. FCL alone decides, for all shapes whose boxes along the axes of W
  /// overlap: our distance bounds have no part in it. Used by check().
  std::vector<std::pair<int, int>> all_collisions();

  /// Returns a lower bound on the distance of each tested pair, in the order of pairs() [m]; 0 if
  /// nothing better is known. Cheap: uses bounding boxes and, for spheres and capsules, the exact
  /// distance of their axes.
  const std::vector<double>& distance_bounds();

  /// Same as collides() and distance_bounds(), for one pair. A bound of at least `enough` [m] is
  /// not improved further. The clearance of the pair is taken off it.
  bool touches(int pair);
  /// True if a body of a pair that does not touch lies within a closed mesh of the other.
  /// collides() and its like count this as touching, touches() does not.
  bool swallows(int pair) const;
  double distance_bound(int pair, double enough = std::numeric_limits<double>::infinity()) const;
  /// A bound on the distance itself, slower and closer to it than distance_bound(): from the convex
  /// hulls of all shapes, not of meshes alone.
  double proven_distance(int pair, double enough) const;

  /// Number of configurations tested so far by collides() and first_collision().
  int num_checks() const;
  /// Number of shape pairs on which FCL threw an exception; they count as touching.
  int num_failures() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graspless::collision
