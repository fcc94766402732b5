// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>
#include <urdf_model/link.h>

#include "graspless/geometry/shape.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::robot {

Eigen::Isometry3d to_isometry(const urdf::Pose& pose);

/// Returns the collision shapes of a link, placed in its frame. A cylinder with a sphere of its
/// radius at either end becomes a capsule, which URDF itself cannot express. Any other cylinder
/// becomes a circumscribed prism of 24 sides. Throws std::invalid_argument that names the link.
std::vector<geometry::PlacedShape> link_shapes(const urdf::Link& link,
                                               const Robot::Options& options);

}  // namespace graspless::robot
