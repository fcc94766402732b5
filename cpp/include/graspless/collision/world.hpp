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

/// Bodies at poses, and which pairs of them must not touch. Knows no robot.
///
/// Each query walks a static list of pairs, with the shapes' axis-aligned boxes in front of FCL's
/// boolean test: for one arm that beats a broad phase. FCL's signed distance is never called (it
/// aborts on flush shapes; docs/architecture.md). Answers are exact but for shapes within 1e-6 m of
/// just touching, where either may come. A mesh is tested as a surface, unless it is closed and
/// convex: then it is tested as the solid it bounds. A World is not shared between threads; copy it
/// instead (copies share shapes).
class GRASPLESS_API World {
 public:
  World();
  World(const World& other);
  World& operator=(const World& other);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  ~World();

  /// Adds a body of one or more shapes, at the identity; returns its index. Throws
  /// std::invalid_argument on a shape that geometry::validate refuses or a name already taken.
  int add_body(const std::string& name, const std::vector<geometry::PlacedShape>& shapes);
  int add_body(const std::string& name, const Solid& solid);
  int num_bodies() const;
  int body(const std::string& name) const;  ///< throws std::invalid_argument that lists the bodies
  const std::string& name(int body) const;
  void set_pose(int body, const Eigen::Isometry3d& X_WB);
  const Eigen::Isometry3d& pose(int body) const;
  double radius(int body) const;  ///< no point of the body is farther from its origin [m]

  /// Tests bodies a and b against each other from now on (no effect when they already are).
  void add_pair(int a, int b);
  void remove_pair(int a, int b);
  /// A contact allowance that ends at a stated depth: in the pair (a, b), body b is tested as if it
  /// stood `depth` [m] further along `-normal_W`, so a may press that far into b along the normal
  /// and no further. depth 0 ends the allowance. Throws std::invalid_argument on a negative depth,
  /// a pair not tested or a zero normal.
  void allow_contact(int a, int b, const Eigen::Vector3d& normal_W, double depth);
  int num_pairs() const;
  std::pair<int, int> pair(int index) const;  ///< the smaller body index first
  std::vector<std::pair<int, int>> pairs() const;
  /// How far the second body of a pair is moved in its tests [m]: the allowance.
  const Eigen::Vector3d& shift(int pair) const;
  int revision()
      const;  ///< grows whenever a body, a pair or an allowance comes or goes, not with its depth

  /// Whether any tested pair touches.
  bool collides();
  /// The first touching pair found.
  std::optional<std::pair<int, int>> first_collision();
  /// Every touching pair, by FCL alone without the boxes in front: what check() uses.
  std::vector<std::pair<int, int>> all_collisions();

  /// For each tested pair (in the order of pairs()), a lower bound on its distance [m], 0 where
  /// nothing better is known. Cheap: from the boxes and, for spheres and capsules, the exact
  /// distance of their axes.
  const std::vector<double>& distance_bounds();

  /// As collides() and distance_bounds(), for one pair. A bound of `enough` [m] is not made better.
  bool touches(int pair);
  double distance_bound(int pair, double enough = std::numeric_limits<double>::infinity()) const;

  /// Configurations tested so far by collides() and first_collision().
  int num_checks() const;
  /// Shape pairs on which FCL gave up with an exception; they count as touching.
  int num_failures() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graspless::collision
