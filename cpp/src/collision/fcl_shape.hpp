// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Shapes prepared for queries. Wraps FCL: conversion of shapes to its geometry, and its boolean
// test.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <Eigen/Geometry>

#include "graspless/geometry/shape.hpp"

#include "collision/bounds.hpp"
#include "collision/enclosure.hpp"
#include "collision/hulls.hpp"
#include "once.hpp"

namespace fcl {
template <typename S>
class CollisionGeometry;
}

namespace graspless::collision {

/// FCL's form of a shape, in the core's frame. It is made at the first use, because most shapes of
/// an arm never come near anything, and the tree of a mesh takes milliseconds. Thread-safe.
class FclGeometry {
 public:
  using Made = std::shared_ptr<const fcl::CollisionGeometry<double>>;
  explicit FclGeometry(std::function<Made()> make) : make_(std::move(make)) {}
  const fcl::CollisionGeometry<double>* get() const;

 private:
  mutable Once once_;
  mutable std::function<Made()> make_;
  mutable Made made_;
};

/// A shape prepared for queries. Immutable, and shared between copies of a World.
struct CollisionShape {
  std::shared_ptr<const FclGeometry> geometry;
  std::shared_ptr<const HullTree> hulls;
  Core core;
  Eigen::Isometry3d X_BC = Eigen::Isometry3d::Identity();  ///< the core's frame in the body
  std::shared_ptr<const Enclosure> enclosure;              ///< of a surface, in the core's frame
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< of any other shape, in the core's frame
};

/// Throws std::invalid_argument that names `what` if geometry::validate rejects the shape or the
/// pose is not finite.
CollisionShape make_collision_shape(const geometry::PlacedShape& placed, const std::string& what);

enum class Touch { no, yes, failed };

/// FCL's boolean test, with scratch memory. Returns `failed` if FCL throws an exception.
class FclTest {
 public:
  FclTest();
  FclTest(const FclTest& other);
  FclTest& operator=(const FclTest&) = delete;
  ~FclTest();
  Touch operator()(const CollisionShape& a, const Eigen::Isometry3d& X_WA, const CollisionShape& b,
                   const Eigen::Isometry3d& X_WB);

 private:
  struct Scratch;
  std::unique_ptr<Scratch> scratch_;
};

}  // namespace graspless::collision
