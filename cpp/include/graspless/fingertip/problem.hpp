// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/obstacle.hpp"
#include "graspless/export.hpp"
#include "graspless/fingertip/object.hpp"
#include "graspless/geometry/shape.hpp"
#include "graspless/mechanics/contact_patch.hpp"
#include "graspless/mechanics/friction_interval.hpp"

namespace graspless::fingertip {

using mechanics::FrictionInterval;

/// Floor or wall: a half-space that the object may touch and the fingertips may not.
struct Plane {
  std::string name = "floor";
  Eigen::Vector3d n_W = Eigen::Vector3d::UnitZ();  ///< out of the solid, unit
  double offset = 0;                               ///< n_W . p of its points [m]
};

using collision::Obstacle;  // neither object nor fingertips may touch it

/// The fingertips: equal spheres in one-point contact, which neither slide nor roll.
struct Fingers {
  int count = 2;                           ///< 1 to 4
  double radius = 0.01;                    ///< [m]
  double max_normal_force = 10;            ///< f_max of each [N]
  FrictionInterval friction = {0.7, 0.7};  ///< between fingertip and object
  /// The farthest that the centres of two fingertips may be apart [m]: how wide a hand opens.
  double max_span = std::numeric_limits<double>::infinity();
};

/// The object passes through these poses in order; from one to the next it moves along a screw
/// (constant twist). One degree of freedom.
struct Path {
  std::vector<Eigen::Isometry3d> X_WO;
};

/// The object slides and turns on the floor (the first plane) from start to goal through a lattice
/// of positions and yaws, each a neighbour of the 26 around it. Start and goal lie on it. Yaws a
/// whole turn apart are the same.
struct Lattice {
  Eigen::Isometry3d X_WO_start = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d X_WO_goal = Eigen::Isometry3d::Identity();
  /// Positions of O's origin relative to the start along x and y of W, and yaw relative to it: the
  /// lattice's first and last values [m, m, rad].
  Eigen::Vector3d lower = Eigen::Vector3d::Zero(), upper = Eigen::Vector3d::Zero();
  std::array<int, 3> counts = {30, 30, 30};
};

/// The object shall stand at X_WO_goal, any face down: the planner finds over which edges to tumble
/// it, the fewest that will do, and when to make the one straight slide and the one turn that are
/// needed beside. Optimal among these paths; for ways round obstacles take a Lattice.
struct Goal {
  Eigen::Isometry3d X_WO_start = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d X_WO_goal = Eigen::Isometry3d::Identity();
  double slide_step = 0.01;    ///< longest step of a slide [m]
  double turn_step = 0.05236;  ///< largest step of a turn or a tumble [rad]
  int max_tumbles = 3;
};

using Motion = std::variant<Path, Lattice, Goal>;

/// A straight slide from X_WO_start by `translation_W` [m] in equal segments.
GRASPLESS_API Path slide_path(const Eigen::Isometry3d& X_WO_start,
                              const Eigen::Vector3d& translation_W, int segments);
/// A turn about the line through `point_W` along `axis_W` by `angle` [rad, right hand] in equal
/// segments: a tumble over an edge, or a turn on the floor.
GRASPLESS_API Path turn_path(const Eigen::Isometry3d& X_WO_start, const Eigen::Vector3d& point_W,
                             const Eigen::Vector3d& axis_W, double angle, int segments);
/// One path after another. Throws std::invalid_argument unless each starts where the last one ended
/// (to 1e-6 m and rad).
GRASPLESS_API Path join(const std::vector<Path>& paths);

/// What is given: bring `object` through `motion` with fingertips alone.
struct Problem {
  Object object;
  Fingers fingers;
  std::vector<Plane> planes;               ///< the floor first, then walls
  FrictionInterval friction = {0.5, 0.5};  ///< between object and planes
  Motion motion;
  std::vector<Obstacle> obstacles;
  Eigen::Vector3d gravity_W = {0, 0, -9.8};  ///< [m/s^2]
};

/// Throws std::invalid_argument that names the field, the value and the choices: values that are
/// not finite, friction, radius, mass or force limit not positive, a path of fewer than two poses,
/// an object that floats (touches no plane) or penetrates one, a goal in a wall or off the lattice,
/// a motion in which a contact patch turns about an axis that it cannot follow.
GRASPLESS_API void validate(const Problem& problem);

}  // namespace graspless::fingertip
