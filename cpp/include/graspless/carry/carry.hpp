// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Carries or drags a held object along a straight path, or puts it down. The object does not move
// relative to the hand: a lift, or a quasi-static drag without slip in the hand. A loose object may
// also hang in it.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/carry/options.hpp"
#include "graspless/carry/places.hpp"
#include "graspless/collision/obstacle.hpp"
#include "graspless/export.hpp"
#include "graspless/planning/budget.hpp"
#include "graspless/robot/robot.hpp"
#include "graspless/scene/certificate.hpp"

namespace graspless::carry {

using collision::Obstacle;

/// Obstacle that the object rests on at the start and may be dragged over.
struct Rest {
  std::string obstacle;
  Eigen::Vector3d normal_W =
      Eigen::Vector3d::UnitZ();  ///< unit normal of its surface, towards the object
};

/// Task of the planner: carry `object` from object.X_WB to X_WO_goal, or put it down at a place.
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
  /// Places where the object is put down, instead of a straight path to X_WO_goal, which does not
  /// count.
  std::optional<Places> places = std::nullopt;
  /// Pose of a loose object at the start, as it hangs in the hand: between this pose and
  /// object.X_WB, it may be anywhere. On the way, nothing may touch it at either pose. On a
  /// straight path, that which it touches there at the start does not count. While it is lowered
  /// onto a place, it may be lower than the support by `height` there, and it ends as it was at the
  /// start.
  std::optional<Eigen::Isometry3d> X_WO_hanging = std::nullopt;
};

/// Throws std::invalid_argument that names the field, its value and what is allowed.
GRASPLESS_API void validate(const Problem& problem);

enum class Status { solved, start_in_collision, not_found, no_place, interrupted, out_of_memory };

/// Table of the values: name and text.
constexpr auto choices(Status) {
  using planning::Choice;
  return std::array{
      Choice{Status::solved, "solved", "A plan was found."},
      Choice{Status::start_in_collision, "start_in_collision",
             "The robot touches something in its start configuration."},
      Choice{Status::not_found, "not_found", "The arm cannot follow the whole path."},
      Choice{Status::no_place, "no_place",
             "The object cannot be put down at any of the places: nothing holds it there, or the "
             "hand cannot come there, open and withdraw."},
      Choice{Status::interrupted, "interrupted", "The query was stopped from outside."},
      Choice{Status::out_of_memory, "out_of_memory",
             "The search would need more memory than options.max_memory."}};
}
GRASPLESS_API std::string to_string(Status status);

/// Part of a motion: Robot::step() between rows of `positions` is 0.05 rad at most.
struct Segment {
  std::string name;                             ///< carry; or transfer, lower, open or retreat
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

/// Result of plan(): a motion, or the reason why there is none.
struct Plan {
  Status status = Status::not_found;
  std::string reason;  ///< one sentence for the user
  std::vector<std::string> joint_names;
  std::vector<Segment> segments;
  double reached = 0;  ///< fraction of the path that the arm could follow, in [0, 1]
  int place = -1;      ///< index of the place where the object is put down; -1: none
  Statistics statistics;
  explicit operator bool() const { return status == Status::solved; }
};

/// Plans a motion of the arm that carries the object along a straight path to its goal: its origin
/// moves along a line, and its attitude turns about one axis. A depth-first search chooses the
/// value of a seven-joint arm's free joint and the twist (up to `max_twist`) along the path; it
/// tries straight ahead first. With places, it puts the object down at the first of them that
/// works: it moves on any free path that tilts the object little, straight down, opens the hand and
/// withdraws it straight. Throws std::invalid_argument on a bad problem, options or budget.
/// Finding no plan is a status, not an error. The same seed and iterations give the same plan.
GRASPLESS_API Plan plan(const Problem& problem, const Options& options = {},
                        const planning::Budget& budget = {});

/// Checks a plan against its problem by an independent replay at joint steps of 0.01 rad. Returns
/// one fault per entry, with segment and row; empty if the plan is valid.
/// `options`: those of plan().
[[nodiscard]] GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                                           const Options& options = {});

/// Proves what check() samples: on every edge of a plan, for every t, nothing touches that may not,
/// and the object keeps to its straight path, or tilts no more than it may. See slide::certify().
/// Throws std::invalid_argument if the plan is not solved or malformed.
[[nodiscard]] GRASPLESS_API scene::EdgeCertificate certify(const Problem& problem, const Plan& plan,
                                                           const Options& options = {});

}  // namespace graspless::carry
