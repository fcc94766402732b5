// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::benchmarks {

/// A place where a hand touches an object.
struct GraspContact {
  Eigen::Vector3d p_O;  ///< [m]
  Eigen::Vector3d n_O;  ///< into the object, unit
};

/// Epsilon of a grasp (Ferrari and Canny 1992): the radius of the largest ball of wrenches that
/// contacts of unit normal force resist, found by descent from many directions: the true one may be
/// a little smaller. Torques are divided by `size` [m]. 0 without force closure.
double grasp_quality(const std::vector<GraspContact>& contacts, const Eigen::Vector3d& center_O,
                     double size, double friction);

}  // namespace graspless::benchmarks
