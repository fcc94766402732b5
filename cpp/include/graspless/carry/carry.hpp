// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/carry/options.hpp"
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

enum class Status { solved, start_in_collision, not_found, interrupted };

/// Table of the values: name and text.
constexpr auto choices(Status) {
  using planning::Choice;
  return std::array{
      Choice{Status::solved, "solved", "A plan was found."},
      Choice{Status::start_in_collision, "start_in_collision",
             "The robot touches something in its start configuration."},
      Choice{Status::not_found, "not_found", "The arm cannot follow the whole path."},
      Choice{Status::interrupted, "interrupted", "The query was stopped from outside."}};
}
GRASPLESS_API std::string to_string(Status status);

/// A stretch of motion: rows of `positions` follow each other by at most 0.05 rad in any joint.
struct Segment {
  std::string name;                             ///< carry
  std::vector<Eigen::VectorXd> positions;       ///< all joints [rad or m]
  std::vector<Eigen::Isometry3d> object_poses;  ///< X_WO at each row
};

/// Counters of the search; fields() describes them.
struct Statistics {
  double seconds = 0;
  std::int64_t iterations = 0;
  std::int64_t ik_calls = 0;
  std::int64_t collision_checks = 0;
  std::map<std::string, std::int64_t> refusals;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Statistics&) {
  using planning::Field;
  return std::make_tuple(
      Field{"seconds", &Statistics::seconds, "s", "Wall-clock time."},
      Field{"iterations", &Statistics::iterations, "", "Configurations expanded by the search."},
      Field{"ik_calls", &Statistics::ik_calls, "", "Calls of the inverse kinematics."},
      Field{"collision_checks", &Statistics::collision_checks, "",
            "Configurations checked against every body."},
      Field{"refusals", &Statistics::refusals, "", "Number of rejected steps by reason."});
}

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
