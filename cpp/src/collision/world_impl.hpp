// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Data of a World, and its tests of one pair. world.cpp validates arguments.
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "graspless/collision/world.hpp"

#include "collision/bounds.hpp"
#include "collision/fcl_shape.hpp"
#include "collision/separation.hpp"

namespace graspless::collision {

struct Solid::Data {
  std::vector<CollisionShape> shapes;
  double radius = 0;           ///< largest distance of a point from the body's origin [m]
  bool has_enclosure = false;  ///< a shape has one
};

struct Body {
  std::string name;
  Solid solid;
};

/// An axis-aligned box in the world.
struct WorldBox {
  Eigen::Vector3d middle, half;
};

/// Bodies a < b, tested with b moved by `shift_W`.
struct Pair {
  int a, b;
  Eigen::Vector3d shift_W = Eigen::Vector3d::Zero();
  double clearance = 0;  // [m]; no farther apart counts as touching
  // Of each pair of shapes: of their hulls alone, and of their triangles, too.
  mutable std::vector<Witnesses> witnesses, tight_witnesses;
};

struct World::Impl {
  std::vector<Body> bodies;
  std::vector<Eigen::Isometry3d> poses;
  std::vector<WorldBox> boxes;        // one per body
  std::vector<int> first_placement;   // first placement of each body
  std::vector<Placement> placements;  // one per shape
  std::vector<Pair> pairs;
  std::set<std::pair<int, int>> tested;  // the bodies of `pairs`
  std::vector<double> bounds;
  FclTest test;
  int checks = 0;
  int failures = 0;
  int revision = 0;

  void require_body(int body, const char* what) const;
  int find(int a, int b) const;
  int require_pair(int a, int b) const;  ///< throws std::invalid_argument if it is not tested
  void place(int body);
  /// Calls visit(shape a, placement a, shape b, placement b, their witnesses) until it returns
  /// true; returns true if it did. With `tight`, the witnesses are those of triangles, too.
  template <typename Visit>
  bool any_shapes(const Pair& pair, Visit visit, bool tight = false) const;
  bool fcl_touch(const CollisionShape& a, const Placement& at_a, const CollisionShape& b,
                 const Placement& at_b, const Eigen::Vector3d& shift_W);
  /// True if the bodies' boxes show that a pair neither touches nor swallows.
  bool is_far(const Pair& pair) const;
  bool touch(const Pair& pair);
  bool touch_by_fcl(const Pair& pair);
  bool swallows(const Pair& pair) const;
  /// With `tight`, the hulls of all shapes are used, not only those of meshes, and the triangles of
  /// surfaces.
  double bound(const Pair& pair, double enough, bool tight) const;
};

}  // namespace graspless::collision
