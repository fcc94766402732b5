// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/collision/clearance.hpp"
#include "graspless/collision/solid.hpp"
#include "graspless/export.hpp"
#include "graspless/geometry/loops.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::clasp {

/// An object known by a cloud of points: its loops, and K_d as what must not be touched. Immutable;
/// copies share.
class GRASPLESS_API Object {
 public:
  /// Points on the surface, in O (3 x n) [m]. Throws as geometry::shortest_loops does. An object
  /// without a reliable hole is still an object: plan() says so.
  static Object from_cloud(const std::string& name, const Eigen::Matrix3Xd& p_OP,
                           const geometry::LoopOptions& options = {});

  const std::string& name() const;
  const Eigen::Matrix3Xd& points() const;  ///< the cloud, as given, in O [m]
  const geometry::Loops& loops() const;    ///< in O
  const geometry::LoopOptions& loop_options() const;
  /// What must not be touched, in O: the triangles of K_d, triangles 1 mm wide (a tenth of the edge
  /// where that is less) along edges of K_d that bound none, and triangles 1 mm wide at points
  /// without an edge. A surface has no inside: what is wholly in the object does not touch it.
  const geometry::Mesh& surface() const;
  const collision::Solid& solid() const;  ///< the surface, for FCL; made when first asked
  /// Of the surface; made when first asked. A copy has a grid of its own.
  const collision::Clearance& clearance() const;
  /// Of the surface less what lies wholly within it: equal for every point outside, and cheaper.
  const collision::Clearance& outer_clearance() const;
  double spacing() const;  ///< between the points of K_d [m]

 private:
  struct Data;
  explicit Object(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

}  // namespace graspless::clasp
