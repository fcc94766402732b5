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

/// Validates both. Called by plan() and check().
GRASPLESS_API void validate(const Problem& problem, const Options& options);

/// plan() ends with all but not_realized, which is for callers of realize(), and the last two,
/// which are for resume().
enum class Status {
  solved,
  no_location,
  unstable,
  out_of_time,
  interrupted,
  not_realized,
  out_of_memory,
  off_path,
  at_goal
};

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
             "The fingertips have a plan, but the robot of the task cannot carry it out."},
      Choice{Status::out_of_memory, "out_of_memory",
             "The search would need more memory than options.max_memory."},
      Choice{Status::off_path, "off_path",
             "The object of a plan to resume is too far from the poses of its segment."},
      Choice{Status::at_goal, "at_goal", "The object of a plan to resume is where it should be."}};
}
GRASPLESS_API std::string to_string(Status status);

/// State of a finger at one instant.
struct FingerState {
  bool touches = true;                             ///< false while the finger regrasps
  Eigen::Vector3d p_OC = Eigen::Vector3d::Zero();  ///< contact point [m]
  Eigen::Vector3d n_O = Eigen::Vector3d::UnitZ();  ///< unit normal, into the object
  FingerMode mode = FingerMode::position;
  double commanded_force = 0;  ///< f_com in force control, else 0 [N]
  Eigen::Vector3d nominal_force_O = Eigen::Vector3d::Zero();  ///< for feed-forward [N]
};

/// One instant of a plan: a sample of an arc, or a rest while a finger regrasps.
struct Row {
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  std::vector<FingerState> fingers;
  /// z [N]. If friction is an interval, it is the least over the evaluated coefficients; for the
  /// whole interval, only min_stability is proven. Modes and commanded forces hold for the whole
  /// interval. Nominal forces are those at its lower end.
  double stability = 0;
  double compliant_stability = 0;  ///< see mechanics::compliant_stability [N]
  double nominal_margin = 0;       ///< mechanics::Equilibrium::margin [N]
  /// Largest disturbance that the row withstands while fingers are in their places, see
  /// mechanics::withstands [N]. At the first and the last row of a segment it is less what gravity
  /// changes in O up to the segment's end, where nominal forces stay as they are.
  double withstands = 0;
  /// Error of every finger's place that the row tolerates without a disturbance, see
  /// mechanics::Promise [m]. With an error of e it withstands
  /// withstands (1 - e / place_tolerance). Less at the ends of a segment, as withstands is.
  double place_tolerance = 0;
};

/// Part of a plan during which no finger changes its place, or one regrasp.
struct Segment {
  std::string name;  ///< slide, turn, tumble or regrasp
  /// Poses of the lattice, first to last. The motion from X_WO[k] to X_WO[k + 1] has P equal parts;
  /// row k * P + j lies in the middle of part j. A regrasp has one pose and one row.
  std::vector<Eigen::Isometry3d> X_WO;
  std::vector<Row> rows;
  int finger = -1;  ///< regrasp: index of the finger that moves to its place in the next segment
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
  std::int64_t placements = 0;
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
            "Nodes that the search of a graph expanded; 0 for the fast search of a path."},
      Field{"placements", &Statistics::placements, "",
            "Placements of the fingers that the fast search of a path considered."},
      Field{"supports", &Statistics::supports, "",
            "Wrench functionals that bound the stability from above."},
      Field{"candidates", &Statistics::candidates, "",
            "Motions of the object tried on the way to a Goal."},
      Field{"memory", &Statistics::memory, "bytes", "Largest memory of the search's tables."});
}

/// Smallest change of one parameter that makes a failed search succeed.
struct Relaxation {
  /// fingers.friction, fingers.max_normal_force, friction, min_stability, or the friction of a
  /// plane such as planes[1] 'wall'.friction
  std::string field;
  double value = 0;  ///< value nearest to the given one that helps, to 1 %
};

/// Result of plan(): a plan, or the reason why there is none.
struct Plan {
  Status status = Status::out_of_time;
  std::string reason;  ///< one sentence for the user
  double cost = 0;     ///< by Eqs. (9) and (10) [m]
  /// Lower bound on the cost of every plan on this lattice [m]; equals `cost` if the plan is
  /// optimal. For a Goal, it holds for the motions of the object that were considered.
  double lower_bound = 0;
  int regrasps = 0;
  /// Least Row::withstands: the largest disturbance that the plan withstands everywhere [N].
  double withstands = 0;
  /// Least Row::place_tolerance [m].
  double place_tolerance = 0;
  std::vector<Segment> segments;
  std::vector<std::string> warnings;
  /// Segment and row of least stability; -1 without a plan.
  int weakest_segment = -1, weakest_row = -1;
  /// If not solved: the limit that blocks (reach of the lattice, geometry, friction, force limit or
  /// stability), and the smallest single changes that help.
  std::string limit;
  std::vector<Relaxation> relaxations;
  Statistics statistics;
  explicit operator bool() const { return status == Status::solved; }
};

/// Plans the places, control modes and regrasps of the fingers (Section 4). If time runs out after
/// a plan was found, the status is `solved` with lower_bound < cost. Throws std::invalid_argument
/// on a bad problem, options or budget.
GRASPLESS_API Plan plan(const Problem& problem, const Options& options = {},
                        const planning::Budget& budget = {});

/// Checks a plan: derives every row anew from the problem, without the code of the search. Contacts
/// come from geometry, z and jamming from the reference engine, clearances from FCL, and the cost
/// from its definition. Also checks nominal forces and continuity. It shares validate(), the public
/// functions of mechanics (contacts, nominal forces, compliant stability, friction intervals),
/// collision and geometry with the planner. It does not prove `lower_bound` again. Returns one
/// fault per entry, with segment and row; empty if the plan is valid.
/// `options`: those of plan().
[[nodiscard]] GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                                           const Options& options = {});

}  // namespace graspless::fingertip
