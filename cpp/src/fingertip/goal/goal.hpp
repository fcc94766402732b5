// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graspless/fingertip/fingertip.hpp"

#include "fingertip/goal/contact_states.hpp"
#include "fingertip/model/clearance.hpp"
#include "fingertip/model/locations.hpp"
#include "fingertip/planner.hpp"

namespace graspless::fingertip {

/// Plans a problem whose motion is a Goal: sequences of tumbles from the start's face to the
/// goal's, the fewest tumbles first, each with one slide and one turn before, between or after
/// (goal_paths); every path is searched as one of one degree of freedom by the engine of the
/// options. The answer is the best over the paths with the fewest tumbles that can be done, and
/// lower_bound holds for these paths. Where regrasps are needed, paths that could be cheaper by
/// less than a thousandth are left out: lower_bound is that much below the cost then.
Plan plan_goal(SearchContext& context, const Goal& goal, planning::Clock& clock);

/// The face that the object stands on by itself. Throws std::invalid_argument that begins with the
/// field when it stands on none, or would tip over.
int standing_face(const Problem& problem, const ContactStates& states,
                  const Eigen::Isometry3d& X_WO, const std::string& field);

/// The object's paths from start to goal that tumble over these edges, with slides and turns
/// before, between and after them where the object stands by itself.
///
/// Motions on the floor act on a pose from the left and tumbles from the right, so they commute:
/// whatever the order, all slides and turns together make the same motion of the floor,
/// X_WO_goal (X_WO_start tumbles)^-1, one turn and one slide. The paths differ in when each comes:
/// every pair of times, either order at one time, and both at once as a turn about the pole of the
/// motion.
std::vector<Path> goal_paths(const Problem& problem, const Goal& goal, const ContactStates& states,
                             int start_face, const TumbleSequence& tumbles);

/// The tumbles one after the other, without slides and turns.
Path tumbles_alone(const Goal& goal, const TumbleSequence& tumbles);

/// Searches several paths of one object for the cheapest plan. Locations, instants and stabilities
/// are computed once for all paths.
class GoalSearch {
 public:
  GoalSearch(SearchContext& context, planning::Clock& clock);

  /// Adds paths for run(), except those on which the object hits something. All tumble over the
  /// same edges. `tumbles` contains these tumbles alone, or one pose if there are none.
  void add(const std::vector<Path>& paths, const Path& tumbles);
  /// Searches the paths added: without regrasps by ascending lower bound until that reaches the
  /// best cost; if that fails, with regrasps until it comes near. True if the search is over: there
  /// is a plan, or time is out.
  bool run();
  /// The best plan, or the reason why there is none.
  Plan plan();

 private:
  struct Candidate {
    Path path;
    double bound;   // of the cost [m]
    double pieces;  // of the displacement, with any number of regrasps [m]
    double most;    // that (9) can come to over all arcs [m]
    int sequence;
  };
  /// Data that paths over the same edges share.
  struct Sequence {
    Path tumbles;
    bool failed = false;  // some path of it, without regrasps
    std::optional<bool> needs_regrasp;
  };
  struct Bounds {
    double whole, pieces;  // of the displacement without and with regrasps [m]
    double most;           // of the cost by (9)
  };
  Bounds bounds(const Path& path) const;
  std::string fault(const Path& path);
  bool needs_regrasp(Sequence& sequence);
  void look_at(Candidate& candidate, double limit);
  void fail(Plan& plan) const;

  SearchContext& context_;
  planning::Clock& clock_;
  Clearance clearance_;
  Problem floor_problem_;  // without walls and obstacles
  std::unique_ptr<SearchContext> on_floor_;
  Statistics statistics_;
  std::vector<Candidate> candidates_;  // not yet searched
  std::vector<Sequence> sequences_;
  std::string fault_;   // of a path that was refused
  double lower_bound_;  // over paths searched or passed over
  double best_cost_;
  std::vector<Stage> best_;
};

}  // namespace graspless::fingertip
