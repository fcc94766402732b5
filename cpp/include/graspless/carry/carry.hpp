// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/collision/obstacle.hpp"
#include "graspless/export.hpp"
#include "graspless/planning/budget.hpp"
#include "graspless/robot/robot.hpp"

/// Carries or drags a held object along a straight path. The object does not move relative to the
/// hand: a lift, or a quasi-static drag without slip in the hand.
namespace graspless::carry {

using collision::Obstacle;

/// An obstacle that the object rests on at the start and may be dragged over.
struct Rest {
  std::string obstacle;
  Eigen::Vector3d normal_W =
      Eigen::Vector3d::UnitZ();  ///< unit normal of its surface, towards the object
};

/// The task: carry `object` from object.X_WB to X_WO_goal.
struct Problem {
  robot::Robot robot;
  std::string arm = "arm";  ///< group of joints that move, base to wrist; all others stay
  std::string frame;        ///< link that holds the object; the arm moves it
  /// The held object: its shapes in O, and as X_WB its pose X_WO at the start. It may touch links
  /// that do not move relative to `frame`: they hold it.
  Obstacle object;
  Eigen::Isometry3d X_WO_goal = Eigen::Isometry3d::Identity();
  std::vector<Obstacle> obstacles;
  std::vector<Rest> rests_on;
  Eigen::VectorXd q_start;  ///< configuration at the start, all joints [rad or m]
};

/// Throws std::invalid_argument that names the field, its value and what is allowed.
GRASPLESS_API void validate(const Problem& problem);

/// How to search.
struct Options {
  double step = 0.005;            ///< along the way, between poses of the object looked at [m]
  double tolerance = 5e-4;        ///< how far O may leave the straight way [m]
  double angle_tolerance = 2e-3;  ///< how far the object may turn off it [rad]
  double max_twist = 0;           ///< how far hand and object may turn about the way,
                                  ///< at its end too [rad]
  double contact_depth = 1e-3;    ///< how far the object may reach into what it rests on [m]
  double resolution = 0.01;       ///< largest joint step between checked configurations [rad]
};

/// Throws std::invalid_argument that names the field, its value and what it may be.
GRASPLESS_API void validate(const Options& options);

enum class Status {
  solved,
  start_in_collision,  ///< where it stands, something touches
  not_found,           ///< the arm cannot go all the way
  interrupted,
};
GRASPLESS_API std::string to_string(Status status);

/// A stretch of motion: rows of `positions` follow each other by at most 0.05 rad in any joint.
struct Segment {
  std::string name;                             ///< carry
  std::vector<Eigen::VectorXd> positions;       ///< all joints [rad or m]
  std::vector<Eigen::Isometry3d> object_poses;  ///< X_WO at each row
};

/// What the search did.
struct Statistics {
  double seconds = 0;
  std::int64_t iterations = 0;  ///< configurations gone on from
  std::int64_t ik_calls = 0;
  std::int64_t collision_checks = 0;             ///< configurations tested in full
  std::map<std::string, std::int64_t> refusals;  ///< why steps failed
};

/// Result of plan(): a motion, or the reason why there is none.
struct Plan {
  Status status = Status::not_found;
  std::string reason;  ///< one sentence for the user
  std::vector<std::string> joint_names;
  std::vector<Segment> segments;
  double reached = 0;  ///< fraction of the path that the arm could follow, in [0, 1]
  Statistics statistics;
  explicit operator bool() const { return status == Status::solved; }
};

/// Plans a motion of the arm that carries the object along a straight path to its goal: its origin
/// moves along a line, its attitude turns about one axis. A depth-first search chooses the value of
/// a seven-joint arm's free joint and the twist (up to `max_twist`) along the path; it tries
/// straight ahead first. Throws std::invalid_argument on a bad problem, options or budget. Finding
/// no plan is a status, not an error. The search is deterministic.
GRASPLESS_API Plan plan(const Problem& problem, const Options& options = {},
                        const planning::Budget& budget = {});

/// Checks a plan against its problem by an independent replay at joint steps of 0.01 rad. Returns
/// one fault per entry, with segment and row; empty if the plan is valid.
GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                             const Options& options = {});

}  // namespace graspless::carry
