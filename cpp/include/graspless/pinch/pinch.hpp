// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pinches an object where it stands: two opposite faces of its outline, or of a wall of its
// heights, between the fingers.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"
#include "graspless/pinch/options.hpp"
#include "graspless/planning/budget.hpp"
#include "graspless/scene/certificate.hpp"
#include "graspless/slide/problem.hpp"

namespace graspless::pinch {

/// The same task as that of a slide: an object, given as a prism over its outline or by its
/// heights, on a support. A pinch does not look at X_WO_end.
using Problem = slide::Problem;

enum class Status {
  solved,
  start_in_collision,
  too_wide,
  too_flat,
  too_slippery,
  too_heavy,
  unknown_force,
  no_room,
  not_reached,
  interrupted,
  out_of_memory
};

/// Table of the values: name and text.
constexpr auto choices(Status) {
  using planning::Choice;
  return std::array{
      Choice{Status::solved, "solved", "A plan was found."},
      Choice{Status::start_in_collision, "start_in_collision",
             "The robot touches something in its start configuration."},
      Choice{Status::too_wide, "too_wide",
             "The object is wider than the hand opens, or as thin as it closes, everywhere."},
      Choice{Status::too_flat, "too_flat",
             "The fingers touch the object's faces above its top, or not above the support."},
      Choice{
          Status::too_slippery, "too_slippery",
          "No two faces are opposite each other, or those that fit the hand are too far from the "
          "centre of mass."},
      Choice{Status::too_heavy, "too_heavy",
             "Held by faces or a wall that fit the hand, the object would turn in the hand or slip "
             "out."},
      Choice{Status::unknown_force, "unknown_force",
             "The URDF has no effort limit for a joint that closes the hand, and "
             "options.grip_force is not given."},
      Choice{Status::no_room, "no_room",
             "Beside each wall that fits the hand, an open finger would stand in the object."},
      Choice{Status::not_reached, "not_reached",
             "The arm reaches no hand pose, or something is in the way."},
      Choice{Status::interrupted, "interrupted", "The query was stopped from outside."},
      Choice{Status::out_of_memory, "out_of_memory",
             "The search would need more memory than options.max_memory."}};
}
GRASPLESS_API std::string to_string(Status status);

/// Part of a motion: Robot::step() between rows of `positions` is 0.05 rad at most.
struct Segment {
  std::string name;                             ///< approach, grasp or close
  std::vector<Eigen::VectorXd> positions;       ///< all joints [rad or m]
  std::vector<Eigen::Isometry3d> object_poses;  ///< X_WO at each row
};

/// Counters of the search; fields() describes them.
struct Statistics {
  double seconds = 0;
  std::int64_t iterations = 0;
  std::int64_t faces = 0;
  std::int64_t ik_calls = 0;
  std::int64_t collision_checks = 0;
  std::map<std::string, std::int64_t> refusals;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Statistics&) {
  using planning::Field;
  return std::make_tuple(
      Field{"seconds", &Statistics::seconds, "s", "Wall-clock time."},
      Field{"iterations", &Statistics::iterations, "", "Hand poses that were tried."},
      Field{"faces", &Statistics::faces, "", "Pairs of opposite faces that fit the hand."},
      Field{"ik_calls", &Statistics::ik_calls, "", "Calls of the inverse kinematics."},
      Field{"collision_checks", &Statistics::collision_checks, "",
            "Configurations checked against every body."},
      Field{"refusals", &Statistics::refusals, "", "Number of rejected hand poses by reason."});
}

/// Result of plan(): a motion, or the reason why there is none.
struct Plan {
  Status status = Status::not_reached;
  std::string reason;  ///< one sentence for the user
  std::vector<std::string> joint_names;
  std::vector<Segment> segments;
  Eigen::Isometry3d X_WH_grasp = Eigen::Isometry3d::Identity();  ///< pose of H at the pinch
  Eigen::Matrix3Xd contacts_O;  ///< the two contacts, in O; no columns unless solved [m]
  double opening = 0;           ///< of the open hand [m]
  double friction = 0;          ///< coefficient that the pinch needs
  /// Largest mass that the pads hold [kg]; nothing if nobody knows the force of the hand.
  std::optional<double> max_mass;
  Statistics statistics;
  explicit operator bool() const { return status == Status::solved; }
};

/// Plans the motion: approach, grasp and close. The hand comes from above or from a side; the
/// fingers close along the support. Throws std::invalid_argument on a bad problem, options or
/// budget. Finding no plan is a status, not an error. The same seed and iterations give the same
/// plan, bit by bit.
GRASPLESS_API Plan plan(const Problem& problem, const Options& options = {},
                        const planning::Budget& budget = {});

/// Checks a plan against its problem by an independent replay at joint steps of 0.01 rad. Returns
/// one fault per entry, with segment and row; empty if the plan is valid.
/// `options`: those of plan().
[[nodiscard]] GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                                           const Options& options = {});

/// Proves what check() samples: on every edge of a plan, for every t, nothing touches that may not.
/// See slide::certify(). Throws std::invalid_argument if the plan is not solved or malformed.
[[nodiscard]] GRASPLESS_API scene::EdgeCertificate certify(const Problem& problem, const Plan& plan,
                                                           const Options& options = {});

}  // namespace graspless::pinch
