// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "graspless/pinch/pinch.hpp"

namespace graspless::pinch {

/// The link of one side of the hand that is farthest along a direction.
struct Foremost {
  int link = -1;
  double extent = -std::numeric_limits<double>::infinity();  // from the origin of W [m]
};

Foremost foremost(const Problem& problem, const robot::Poses& X_WL, const Eigen::Vector3d& d_W,
                  bool sliding);

/// Force of each finger at the end of a plan [N]: options.grip_force, or that of half the effort
/// limits of the hand's joints, by the Jacobians of both contacts. Nothing if a joint has no limit.
std::optional<double> finger_force(const Problem& problem, const Plan& plan,
                                   const Options& options);

/// Tests whether the pads bear the object between the contacts of a plan, and whether its max_mass
/// is as low as what they bear. `friction`: tangent of the faces' slopes. `rise`: of the contacts
/// above the middle of the pads [m]. Returns faults; none of an object without heights if nobody
/// knows the force of the hand.
std::vector<std::string> faults_of_load(const Problem& problem, const Plan& plan,
                                        const Options& options, double friction, double rise);

/// Tests whether the contacts of a plan lie on opposite faces of the outline, near enough to the
/// centre of mass. Returns faults.
std::vector<std::string> faults_of_faces(const Problem& problem, const Plan& plan,
                                         const Options& options);

/// Measures the wall between the contacts of a plan anew, on an object with heights: its thickness,
/// its slopes, how far it rises above the contacts, and the mass that the pads hold there. Returns
/// faults.
std::vector<std::string> faults_of_wall(const Problem& problem, const Plan& plan,
                                        const Options& options);

}  // namespace graspless::pinch
