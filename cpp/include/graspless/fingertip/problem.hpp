// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <limits>
#include <optional>
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

/// Solid half-space that the object may touch and the fingertips may not: a floor or a wall.
struct Plane {
  std::string name = "floor";
  Eigen::Vector3d n_W = Eigen::Vector3d::UnitZ();  ///< unit normal, out of the solid
  double offset = 0;                               ///< n_W . p of the points p on its surface [m]
  /// Friction between object and plane. By default it is Problem::friction, and all such planes
  /// share one coefficient. The coefficient of a plane with its own interval varies independently.
  std::optional<FrictionInterval> friction = std::nullopt;
};

using collision::Obstacle;  // neither object nor fingertips may touch it

/// Fingertips: equal spheres in one-point contact that neither slide nor roll.
struct Fingers {
  int count = 2;                           ///< number of fingers, 1 to 4
  double radius = 0.01;                    ///< [m]
  double max_normal_force = 10;            ///< f_max: limit of each finger's normal force [N]
  FrictionInterval friction = {0.7, 0.7};  ///< between fingertip and object
  /// Largest distance between the centres of two fingertips [m], which the hand's opening sets.
  double max_span = std::numeric_limits<double>::infinity();
  /// Contact point of each finger at the start, in O [m]: on the object's surface to
  /// kStartTolerance. Empty: the planner chooses. Not for a Goal.
  std::vector<Eigen::Vector3d> start = {};
};

constexpr double kStartTolerance = 1e-4;  // of Fingers::start [m]

/// Motion with one degree of freedom: the object passes through poses in order. It moves along a
/// screw (constant twist) from each pose to the next.
struct Path {
  std::vector<Eigen::Isometry3d> X_WO;
};

/// Motion on the floor (the first plane) from start to goal through a lattice of positions and
/// yaws. Every pose has the 26 poses around it as neighbours. Start and goal lie on the lattice.
/// Yaws that differ by a full turn are the same.
struct Lattice {
  Eigen::Isometry3d X_WO_start = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d X_WO_goal = Eigen::Isometry3d::Identity();
  /// First and last values of the lattice, relative to the start: position of O's origin along x
  /// and y of W, and yaw [m, m, rad].
  Eigen::Vector3d lower = Eigen::Vector3d::Zero(), upper = Eigen::Vector3d::Zero();
  std::array<int, 3> counts = {30, 30, 30};
};

/// Goal pose of the object, on any face. The planner finds the smallest number of tumbles and the
/// edges to tumble over. It also finds when to make one straight slide and one turn, if they are
/// needed. The plan is optimal among these paths. A Lattice can also move around obstacles.
struct Goal {
  Eigen::Isometry3d X_WO_start = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d X_WO_goal = Eigen::Isometry3d::Identity();
  double slide_step = 0.01;    ///< longest step of a slide [m]
  double turn_step = 0.05236;  ///< largest step of a turn or a tumble [rad]
  int max_tumbles = 3;
};

using Motion = std::variant<Path, Lattice, Goal>;

constexpr int kMaxPoses = 100000;  ///< largest number of poses of a Path

/// Returns a straight slide from X_WO_start by `translation_W` [m] in equal segments. Throws
/// std::invalid_argument unless X_WO_start is rigid, there are 1 to kMaxPoses - 1 segments, and the
/// translation is finite and not zero.
GRASPLESS_API Path slide_path(const Eigen::Isometry3d& X_WO_start,
                              const Eigen::Vector3d& translation_W, int segments);
/// Returns a tumble over an edge or a turn on the floor, in equal segments: a rotation by `angle`
/// [rad, right-handed] about the line through `point_W` along `axis_W`. A segment turns by 3 rad at
/// most. Throws std::invalid_argument that names the argument unless X_WO_start is rigid, there are
/// 1 to kMaxPoses - 1 segments, enough for the angle, all is finite, and neither axis nor angle is
/// zero.
GRASPLESS_API Path turn_path(const Eigen::Isometry3d& X_WO_start, const Eigen::Vector3d& point_W,
                             const Eigen::Vector3d& axis_W, double angle, int segments);
/// Joins paths into one. Throws std::invalid_argument unless each starts where the one before it
/// ends (to 1e-6 m and rad).
GRASPLESS_API Path join(const std::vector<Path>& paths);

/// Task of the planner: bring `object` through `motion` with fingertips alone.
struct Problem {
  Object object;
  Fingers fingers;
  std::vector<Plane> planes;               ///< the floor first, then walls
  FrictionInterval friction = {0.5, 0.5};  ///< between object and planes without their own
  Motion motion;
  std::vector<Obstacle> obstacles = {};
  Eigen::Vector3d gravity_W = {0, 0, -9.8};  ///< [m/s^2]
};

/// Throws std::invalid_argument that names the field, the value and the choices in these cases:
/// - a value is not finite, or radius, mass or force limit is not positive;
/// - friction is negative or more than 1e4, or has more than kMaxUncertainSurfaces intervals;
/// - a path has fewer than two poses or more than kMaxPoses;
/// - the object touches no plane or penetrates one;
/// - the goal lies in a wall or off the lattice;
/// - a contact patch turns about an axis that it cannot follow.
GRASPLESS_API void validate(const Problem& problem);

}  // namespace graspless::fingertip
