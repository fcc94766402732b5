// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "graspless/fingertip/fingertip.hpp"

#include "fingertip/assemble.hpp"
#include "fingertip/model/clearance.hpp"
#include "fingertip/planner.hpp"

namespace graspless::fingertip {

/// Searches several paths of one object for the cheapest plan. What they share (locations,
/// instants, stabilities) is worked out once.
class GoalSearch {
 public:
  GoalSearch(SearchContext& context, planning::Clock& clock);

  /// Paths to be looked at by run(), but those on which the object hits something. All tumble over
  /// the same edges; `tumbles` does nothing else (one pose: there are none).
  void add(const std::vector<Path>& paths, const Path& tumbles);
  /// Searches the paths added: without regrasps by ascending lower bound until that reaches the
  /// best cost; when that fails, with regrasps until it comes near. Whether the search is over: a
  /// plan is there, or time is out.
  bool run();
  /// The best plan, or why there is none.
  Plan plan();

 private:
  struct Candidate {
    Path path;
    double bound;   // of the cost [m]
    double pieces;  // of the displacement, with any number of regrasps [m]
    double most;    // that (9) can come to over all arcs [m]
    int sequence;
  };
  /// What paths over the same edges share.
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
