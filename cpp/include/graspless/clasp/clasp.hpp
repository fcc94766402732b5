// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "graspless/clasp/options.hpp"
#include "graspless/clasp/problem.hpp"
#include "graspless/clasp/stability.hpp"
#include "graspless/export.hpp"
#include "graspless/planning/budget.hpp"

namespace graspless::clasp {

enum class Status {
  solved,
  start_in_collision,
  no_reliable_hole,
  no_target_in_reach,
  not_found,
  not_secure,
  interrupted,
};

/// Table of the values: name and text.
constexpr auto choices(Status) {
  using planning::Choice;
  return std::array{
      Choice{Status::solved, "solved", "A plan was found."},
      Choice{Status::start_in_collision, "start_in_collision",
             "The robot touches something in its start configuration."},
      Choice{Status::no_reliable_hole, "no_reliable_hole",
             "The point cloud shows no hole to clasp. Object.loops has its Betti numbers."},
      Choice{Status::no_target_in_reach, "no_target_in_reach",
             "Every target is farther away than the arm is long."},
      Choice{Status::not_found, "not_found", "No motion to a clasp was found within the budget."},
      Choice{Status::not_secure, "not_secure",
             "Clasps were found within the budget, and none passed the stability test."},
      Choice{Status::interrupted, "interrupted", "The query was stopped from outside."}};
}
GRASPLESS_API std::string to_string(Status status);

/// A stretch of motion: rows of `positions` follow each other by at most 0.05 rad in any joint.
struct Segment {
  std::string name;                        ///< reach or close
  std::vector<Eigen::VectorXd> positions;  ///< all joints [rad or m]
  /// |VLk| of every finger curve with the loop clasped, curves x rows.
  Eigen::MatrixXd virtual_linking;
};

/// The tree that led to the clasp, for pictures.
struct Tree {
  Eigen::Matrix3Xd p_W;      ///< centre of the hand's curves, a node a column [m]
  std::vector<int> parents;  ///< index of a node's parent; its own for the root
  std::vector<int> path;     ///< nodes from the root to the clasp
};

/// Counters of the search; fields() describes them.
struct Statistics {
  double seconds = 0;
  double stability_seconds = 0;
  std::int64_t cycles = 0;
  std::int64_t nodes = 0;
  std::int64_t restarts = 0;
  std::int64_t control_steps = 0;
  std::int64_t collision_checks = 0;
  std::int64_t fcl_checks = 0;
  std::int64_t stability_tests = 0;
  std::map<std::string, std::int64_t> refusals;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Statistics&) {
  using planning::Field;
  return std::make_tuple(
      Field{"seconds", &Statistics::seconds, "s", "Wall-clock time."},
      Field{"stability_seconds", &Statistics::stability_seconds, "s",
            "Part of the wall-clock time that was spent in stability tests."},
      Field{"cycles", &Statistics::cycles, "",
            "Cycles of Algorithm 1 after the pre-expansions, over all trees."},
      Field{"nodes", &Statistics::nodes, "", "Nodes of all trees."},
      Field{"restarts", &Statistics::restarts, "", "Number of trees given up."},
      Field{"control_steps",
            &Statistics::control_steps,
            "",
            "Steps of TS-CONTROL.",
            {},
            "Algorithm 4"},
      Field{"collision_checks", &Statistics::collision_checks, "", "Configurations checked."},
      Field{"fcl_checks", &Statistics::fcl_checks, "",
            "Checks of a link against the object by FCL, where the clearance left it open."},
      Field{"stability_tests", &Statistics::stability_tests, "", "Stability tests run."},
      Field{"refusals", &Statistics::refusals, "",
            "Number of rejected targets, connections and clasps by reason."});
}

/// What was found, or why not.
struct Plan {
  Status status = Status::not_found;
  std::string reason;  ///< one sentence, for people
  std::vector<std::string> joint_names;
  std::vector<Segment> segments;
  int loop = -1;                 ///< clasped: index of object.loops().loops
  geometry::ClaspTarget target;  ///< clasped, in O
  double min_linking = 0;        ///< the threshold in force, kept by the last row
  Stability stability;           ///< of the last row
  Tree tree;
  std::vector<std::string> warnings;
  Statistics statistics;
  explicit operator bool() const { return status == Status::solved; }
};

/// Plans a motion of arm and hand that ends in a clasp: reach, then close until contact. Throws
/// std::invalid_argument on a bad problem, options or budget; not finding a plan is a status. One
/// iteration of the budget is one cycle. Same seed and iterations: the same plan, bit by bit.
GRASPLESS_API Plan plan(const Problem& problem, const Options& options = {},
                        const planning::Budget& budget = {});

/// Replays a plan against its problem at steps of 0.01 rad with none of the search's code: limits,
/// collisions by FCL, linking by the double integral (1), that the target is one that was asked
/// for, that the fingers closed until contact. Shared with the search are the threshold derived
/// from the hand and the stability test, which is run anew; beside it the object is tugged at by
/// FCL alone. An empty list means the plan holds.
GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                             const Options& options = {});

}  // namespace graspless::clasp
