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

/// Carrying or dragging what the hand holds along a straight way. The object keeps its place to the
/// hand: a lift, or a quasi-static drag in which nothing slips.
namespace graspless::carry {

using collision::Obstacle;

/// What the object lies on when the carry begins, and may be drawn over.
struct Rest {
  std::string obstacle;
  Eigen::Vector3d normal_W = Eigen::Vector3d::UnitZ();  ///< out of it, towards the object
};

/// What is given: take `object` to X_WO_goal.
struct Problem {
  robot::Robot robot;
  std::string arm = "arm";  ///< group of joints that move, base to wrist; all others stand still
  std::string frame;        ///< link that the object keeps its place to; the arm carries it
  /// What is held: shapes in O, and X_WB is X_WO when the carry begins. It is not tested against
  /// the links that keep their place to `frame`: how they hold it is another planner's.
  Obstacle object;
  Eigen::Isometry3d X_WO_goal = Eigen::Isometry3d::Identity();
  std::vector<Obstacle> obstacles;
  std::vector<Rest> rests_on;
  Eigen::VectorXd q_start;  ///< where the robot stands, all joints [rad or m]
};

/// Throws std::invalid_argument that names the field, the value and the choices.
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

/// What was found, or why not.
struct Plan {
  Status status = Status::not_found;
  std::string reason;  ///< one sentence, for people
  std::vector<std::string> joint_names;
  std::vector<Segment> segments;
  double reached = 0;  ///< how much of the way was possible, 0 to 1
  Statistics statistics;
  explicit operator bool() const { return status == Status::solved; }
};

/// Plans a motion of the arm that takes the object along the straight way to its goal: positions on
/// a line, attitudes about one axis. The redundancy of a seven-joint arm and `max_twist` are what
/// it searches through: a depth-first search over the way and those two, the straightest first.
/// Throws std::invalid_argument on a bad problem, options or budget; not finding a plan is a
/// status. There is no randomness in it.
GRASPLESS_API Plan plan(const Problem& problem, const Options& options = {},
                        const planning::Budget& budget = {});

/// Replays a plan against its problem at steps of 0.01 rad with none of the search's code. Each
/// entry says which segment and row fails and how; an empty list means the plan holds.
GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                             const Options& options = {});

}  // namespace graspless::carry
