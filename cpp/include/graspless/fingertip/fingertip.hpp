// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/fingertip/options.hpp"
#include "graspless/fingertip/problem.hpp"
#include "graspless/mechanics/equilibrium.hpp"
#include "graspless/mechanics/stability.hpp"
#include "graspless/planning/budget.hpp"

namespace graspless::fingertip {

using mechanics::FingerMode;

/// Validates both, and that the search fits into max_memory. plan() and check() begin with this.
GRASPLESS_API void validate(const Problem& problem, const Options& options);

/// plan() ends with all but not_realized, which is for callers of realize().
enum class Status { solved, no_location, unstable, out_of_time, interrupted, not_realized };

/// Table of the values: name and text.
constexpr auto choices(Status) {
  using planning::Choice;
  return std::array{
      Choice{Status::solved, "solved", "A plan was found."},
      Choice{Status::no_location, "no_location",
             "No placement of the fingers is clear of floor, walls and each other."},
      Choice{Status::unstable, "unstable",
             "Clear placements exist, but none carries the object all the way."},
      Choice{Status::out_of_time, "out_of_time",
             "Nothing was found within the budget or the bounds of the search, and nothing was "
             "excluded."},
      Choice{Status::interrupted, "interrupted", "The query was stopped from outside."},
      Choice{Status::not_realized, "not_realized",
             "The fingertips have a plan, but the robot of the task cannot carry it out."}};
}
GRASPLESS_API std::string to_string(Status status);

/// A finger at one instant.
struct FingerState {
  bool touches = true;                             ///< false while it regrasps
  Eigen::Vector3d p_OC = Eigen::Vector3d::Zero();  ///< contact point [m]
  Eigen::Vector3d n_O = Eigen::Vector3d::UnitZ();  ///< into the object, unit
  FingerMode mode = FingerMode::position;
  double commanded_force = 0;  ///< f_com in force control, else 0 [N]
  Eigen::Vector3d nominal_force_O = Eigen::Vector3d::Zero();  ///< to feed forward [N]
};

/// One instant of a plan: a sample of an arc, or a rest while a finger regrasps.
struct Row {
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  std::vector<FingerState> fingers;
  /// z [N]; where friction is an interval, the least over the coefficients looked at: min_stability
  /// is what is proven for all of the interval. Modes and commanded forces hold for all of it,
  /// nominal forces are those at its lower end.
  double stability = 0;
  double compliant_stability = 0;  ///< see mechanics::compliant_stability [N]
  double nominal_margin = 0;       ///< mechanics::Equilibrium::margin [N]
};

/// A stretch of the plan with the fingers where they are, or one regrasp.
struct Segment {
  std::string name;  ///< slide, turn, tumble or regrasp
  /// Displacement: from the first pose through every lattice pose to the last; row k * P + j lies
  /// in the middle of the j-th of P equal parts of the motion from X_WO[k] to X_WO[k + 1]. Regrasp:
  /// one pose, one row.
  std::vector<Eigen::Isometry3d> X_WO;
  std::vector<Row> rows;
  int finger = -1;  ///< regrasp: who moves; it goes to where the next segment has it
};

/// Counters of the search; fields() describes them.
struct Statistics {
  double seconds = 0;
  std::int64_t locations = 0;
  std::int64_t z_evaluations = 0;
  std::int64_t bounded_tests = 0;
  std::int64_t pivots = 0;
  std::int64_t ill_conditioned = 0;
  std::int64_t nodes = 0;
  std::int64_t supports = 0;
  std::int64_t candidates = 0;
  std::int64_t memory = 0;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Statistics&) {
  using planning::Field;
  return std::make_tuple(
      Field{"seconds", &Statistics::seconds, "s", "Wall-clock time."},
      Field{"locations", &Statistics::locations, "", "Fingertip locations on the object."},
      Field{"z_evaluations",
            &Statistics::z_evaluations,
            "",
            "Evaluations of the stability, each over all directions.",
            {},
            "Problem (6)"},
      Field{"bounded_tests",
            &Statistics::bounded_tests,
            "",
            "Tests whether internal forces are bounded.",
            {},
            "Problem (5)"},
      Field{"pivots", &Statistics::pivots, "", "Pivots of the simplex method."},
      Field{"ill_conditioned", &Statistics::ill_conditioned, "",
            "Problems (5) and (6) with ill-conditioned contacts, solved by the reference engine."},
      Field{"nodes", &Statistics::nodes, "",
            "Nodes expanded by the search; for the fast search of a path, placements considered."},
      Field{"supports", &Statistics::supports, "",
            "Wrench functionals that bound the stability from above."},
      Field{"candidates", &Statistics::candidates, "",
            "Motions of the object tried on the way to a Goal."},
      Field{"memory", &Statistics::memory, "bytes", "Largest memory of the search's tables."});
}

/// What a failed search says of the way out.
struct Relaxation {
  std::string field;  ///< fingers.friction, fingers.max_normal_force, friction or min_stability
  double value = 0;   ///< the least change that helps, to 1 %
};

/// What was found, or why not.
struct Plan {
  Status status = Status::out_of_time;
  std::string reason;  ///< one sentence, for people
  double cost = 0;     ///< by (9) and (10) [m]
  /// No plan on this lattice is cheaper [m]; equals cost when optimal. For a Goal: none over the
  /// motions of the object that were considered.
  double lower_bound = 0;
  int regrasps = 0;
  std::vector<Segment> segments;
  std::vector<std::string> warnings;
  /// Where z is least: segment and row; -1 without a plan.
  int weakest_segment = -1, weakest_row = -1;
  /// Not solved: which limit blocks (reach of the lattice, geometry, friction, force limit,
  /// stability), and the smallest single changes that help.
  std::string limit;
  std::vector<Relaxation> relaxations;
  Statistics statistics;
  explicit operator bool() const { return status == Status::solved; }
};

/// Plans where the fingers press, which holds its position and which its force, and when to change
/// grip. Throws std::invalid_argument on a bad problem, options or budget. Out of time with a plan
/// in hand: solved, with lower_bound < cost.
GRASPLESS_API Plan plan(const Problem& problem, const Options& options = {},
                        const planning::Budget& budget = {});

/// Re-derives every row from the problem with none of the search's code: contacts from geometry, z
/// and jamming by the reference engine, nominal forces, clearances by FCL, cost by its definition,
/// continuity. Shared with the planner are validate(), mechanics' public functions (contacts,
/// nominal forces, compliant stability, friction intervals), collision and geometry. That nothing
/// is cheaper than lower_bound is not proven again. Each entry says which segment and row fails and
/// how; empty: the plan holds.
GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                             const Options& options = {});

}  // namespace graspless::fingertip
