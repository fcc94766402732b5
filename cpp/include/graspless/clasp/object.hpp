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

class Core;

/// An object known from a point cloud: its loops, and its surface as collision model. The surface
/// is the part of K_d (Stork 2013, Section IV-A) at the cloud's own resolution: solid where points
/// are, and free where it is open. Immutable; copies share their data.
class GRASPLESS_API Object {
 public:
  /// A copy shares all data. Moving copies, so that no object is left empty.
  Object(const Object&) = default;
  Object& operator=(const Object&) = default;

  /// `p_OP`: points on the surface, 3 x n in O [m]. `rays`: of the cameras that saw them, in O. An
  /// object without a reliable hole is valid; plan() reports it as a status. Throws like
  /// geometry::shortest_loops().
  static Object from_cloud(const std::string& name, const Eigen::Matrix3Xd& p_OP,
                           const geometry::LoopOptions& options = {},
                           const std::vector<geometry::RayImage>& rays = {});

  const std::string& name() const;
  const Eigen::Matrix3Xd& points() const;  ///< input cloud, 3 x n in O [m]
  const geometry::Loops& loops() const;    ///< in O
  const geometry::LoopOptions& loop_options() const;
  const std::vector<geometry::RayImage>& rays() const;
  /// Collision surface, in O [m]: the triangles of loops().surface, and narrow triangles for edges
  /// without a triangle (1 mm wide, at most a tenth of the edge) and points without an edge (1 mm).
  /// A surface has no inside, so a body wholly inside the object does not touch it.
  const geometry::Mesh& surface() const;
  const collision::Solid& solid() const;  ///< surface() for FCL; built on first use
  /// Distance bounds from surface(); built on first use. A copy has a grid of its own.
  const collision::Clearance& clearance() const;
  /// Same without the triangles wholly inside: equal for every point outside, and cheaper.
  const collision::Clearance& outer_clearance() const;
  /// Same with a grid that former borrowers filled, for one thread. It returns to the object, which
  /// keeps one.
  std::shared_ptr<collision::Clearance> borrow_outer_clearance() const;
  const Core& core() const;  ///< what the surface shuts off from outside; built on first use
  double spacing() const;    ///< median distance of neighbouring points of the surface [m]

 private:
  struct Data;
  explicit Object(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

}  // namespace graspless::clasp
