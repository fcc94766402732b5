// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Plans to a pose with any face down: contact states first, then the cheapest plan over the paths
// that they allow.
#include "fingertip/goal/goal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "graspless/watch.hpp"

#include "fingertip/goal/contact_states.hpp"
#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {
namespace {

constexpr int kMaxSequences = 200;  // of one number of tumbles: a bound for hulls of many faces

Plan out_of_reach(int needed, const Goal& goal) {
  Plan plan;
  plan.status = Status::no_location;
  plan.limit = "reach of the lattice";
  plan.reason = needed < 0 ? "no sequence of tumbles leads to the goal's face"
                           : "the goal's face takes " + std::to_string(needed) +
                                 (needed == 1 ? " tumble" : " tumbles") + ", and max_tumbles is " +
                                 std::to_string(goal.max_tumbles);
  return plan;
}

/// Adds a warning that not all sequences of tumbles were searched, and drops claims about the
/// others.
void admit_truncation(Plan& plan) {
  const std::string what = "only the first " + std::to_string(kMaxSequences) +
                           " ways to tumble to the goal's face were looked at";
  plan.warnings.push_back(what);
  if (plan.status == Status::solved) return;
  plan.lower_bound = 0;
  plan.reason += "; " + what;
  if (plan.status != Status::interrupted) plan.status = Status::out_of_time;
}

// Part of the cost: if regrasps are needed, paths that could be cheaper by less are left out.
constexpr double kGap = 1e-3;

/// Name of a plane that the object's hull enters at this pose; empty: none.
std::string plane_entered(const Problem& problem, const Eigen::Isometry3d& X_WO) {
  const Eigen::Matrix3Xd corners_W = X_WO * problem.object.hull();
  for (const Plane& plane : problem.planes) {
    const double height = (plane.n_W.transpose() * corners_W).minCoeff() - plane.offset;
    if (height < -kContactTolerance * problem.object.size()) return plane.name;
  }
  return "";
}

}  // namespace

int standing_face(const Problem& problem, const ContactStates& states,
                  const Eigen::Isometry3d& X_WO, const std::string& field) {
  const Plane& floor = problem.planes.front();
  const double tolerance = kContactTolerance * problem.object.size();
  const int face = states.standing(X_WO, floor, tolerance);
  if (face < 0) {
    throw std::invalid_argument(
        field + ": must have a face of the object's convex hull flush on '" + floor.name + "'");
  }
  if (!states[face].is_stable) {
    throw std::invalid_argument(field + ": must have the centre of mass over the face on '" +
                                floor.name + "': there the object would tip over");
  }
  return face;
}

Plan plan_goal(SearchContext& context, const Goal& goal, planning::Clock& clock) {
  const Problem& problem = context.problem;
  const ContactStates states(problem.object);
  const int from = standing_face(problem, states, goal.X_WO_start, "motion.X_WO_start");
  const int to = standing_face(problem, states, goal.X_WO_goal, "motion.X_WO_goal");
  const int needed = states.tumbles_to(to)[from];
  if (needed < 0 || needed > goal.max_tumbles) return out_of_reach(needed, goal);

  GoalSearch search(context, clock);
  bool is_truncated = false;
  for (int tumbles = needed; tumbles <= goal.max_tumbles; ++tumbles) {
    auto sequences = tumble_sequences(states, from, to, tumbles, kMaxSequences + 1);
    if (sequences.size() > kMaxSequences) {
      is_truncated = true;
      sequences.resize(kMaxSequences);
    }
    for (const TumbleSequence& sequence : sequences) {
      search.add(goal_paths(problem, goal, states, from, sequence), tumbles_alone(goal, sequence));
    }
    if (search.run()) break;
  }
  Plan plan = search.plan();
  if (is_truncated) admit_truncation(plan);
  return plan;
}

GoalSearch::GoalSearch(SearchContext& context, planning::Clock& clock)
    : context_(context),
      clock_(clock),
      clearance_(context.problem),
      floor_problem_(context.problem),
      lower_bound_(kInfinity),
      best_cost_(kInfinity) {
  floor_problem_.planes.resize(1);
  floor_problem_.obstacles.clear();
}

void GoalSearch::add(const std::vector<Path>& paths, const Path& tumbles) {
  sequences_.push_back({tumbles, false, {}});
  if (tumbles.X_WO.size() < 2) sequences_.back().needs_regrasp = false;
  for (const Path& path : paths) {
    const std::string complaint = fault(path);
    if (complaint.empty()) {
      const Bounds least = bounds(path);
      const double bound = std::min(least.whole, least.pieces + context_.options.regrasp_cost);
      const int sequence = static_cast<int>(sequences_.size()) - 1;
      candidates_.push_back({path, bound, least.pieces, least.most, sequence});
    } else if (fault_.empty()) {
      fault_ = complaint;
    }
  }
}

/// Description of what the object runs into; empty: nothing.
std::string GoalSearch::fault(const Path& path) {
  const int P = context_.options.samples_per_arc;
  for (std::size_t i = 0; i < path.X_WO.size(); ++i) {
    poll();
    const bool is_last = i + 1 == path.X_WO.size();
    const auto twist_O = is_last ? mechanics::Vector6d(mechanics::Vector6d::Zero())
                                 : screw_between(path.X_WO[i], path.X_WO[i + 1]);
    for (int j = 0; j < (is_last ? 1 : 1 + P); ++j) {
      const Eigen::Isometry3d X_WO =
          j == 0 ? path.X_WO[i] : along_screw(path.X_WO[i], twist_O, (j - 0.5) / P);
      const std::string plane = plane_entered(context_.problem, X_WO);
      if (!plane.empty()) return "the object would enter plane '" + plane + "'";
    }
    std::string obstacle = clearance_.obstacle_at(path.X_WO[i]);
    if (obstacle.empty() && !is_last) {
      obstacle = clearance_.obstacle_along(path.X_WO[i], twist_O, P);
    }
    if (!obstacle.empty()) return "the object would touch '" + obstacle + "'";
  }
  return "";
}

/// Without regrasps some location goes all the way. With regrasps each arc may have its own.
GoalSearch::Bounds GoalSearch::bounds(const Path& path) const {
  std::vector<double> whole(context_.locations.size(), 0.0);
  Bounds bounds{kInfinity, 0, 0};
  for (std::size_t i = 0; i + 1 < path.X_WO.size(); ++i) {
    const auto twist_O = screw_between(path.X_WO[i], path.X_WO[i + 1]);
    double least = kInfinity, most = 0;
    for (int l = 0; l < context_.locations.size(); ++l) {
      const double moved = sphere_speed(twist_O, context_.locations[l]);
      whole[l] += moved;
      least = std::min(least, moved);
      most = std::max(most, moved);
    }
    bounds.pieces += least;
    bounds.most += most;
  }
  const Options& options = context_.options;
  bounds.most *= (1 + options.stability_weight / options.min_stability) * (1 + 1e-9);
  for (const double moved : whole) bounds.whole = std::min(bounds.whole, moved);
  return bounds;
}

bool GoalSearch::run() {
  std::stable_sort(candidates_.begin(), candidates_.end(),
                   [](const Candidate& a, const Candidate& b) { return a.bound < b.bound; });
  // Regrasps take most of the time: first all paths without, then with one, then the rest.
  const double X_regr = context_.options.regrasp_cost;
  for (const double limit : {X_regr, 2 * X_regr, kInfinity}) {
    for (Candidate& candidate : candidates_) {
      const double near = limit > X_regr ? best_cost_ * (1 - kGap) : best_cost_;
      if (clock_.is_out()) break;
      if (candidate.bound >= std::min(limit, near)) continue;
      if (!clock_.run([&] { look_at(candidate, std::min(limit, best_cost_)); })) break;
    }
    if (best_cost_ < kInfinity) break;
  }
  for (const Candidate& candidate : candidates_) {
    lower_bound_ = std::min(lower_bound_, candidate.bound);
  }
  candidates_.clear();
  return best_cost_ < kInfinity || clock_.is_out();
}

/// True if the tumbles alone, on the floor without obstacles, cannot be done with one placement. No
/// path over these edges can then, unless a wall supports the object on the way or the floor
/// slopes.
bool GoalSearch::needs_regrasp(Sequence& sequence) {
  const Problem& problem = context_.problem;
  if (!sequence.failed || problem.planes.size() > 1 || !is_level(problem)) return false;
  if (!sequence.needs_regrasp) {
    if (!on_floor_) on_floor_ = std::make_unique<SearchContext>(floor_problem_, context_.options);
    const PoseGraph graph(floor_problem_, sequence.tumbles, on_floor_->locations,
                          on_floor_->instants, context_.options);
    const Route route =
        search(graph, *on_floor_, clock_, statistics_, context_.options.regrasp_cost);
    sequence.needs_regrasp = route.is_complete && !route.found;
  }
  return *sequence.needs_regrasp;
}

void GoalSearch::look_at(Candidate& candidate, double limit) {
  const double X_regr = context_.options.regrasp_cost;
  Sequence& sequence = sequences_[candidate.sequence];
  // Then what a route costs says how many regrasps it has.
  const bool regrasps_dominate = candidate.most < X_regr;
  if (limit <= X_regr && regrasps_dominate && needs_regrasp(sequence)) {
    candidate.bound = std::max(candidate.bound, X_regr + candidate.pieces);
    return;
  }
  ++statistics_.candidates;
  std::optional<PoseGraph> graph;
  try {
    graph.emplace(context_.problem, candidate.path, context_.locations, context_.instants,
                  context_.options);
  } catch (const std::invalid_argument& error) {
    candidate.bound = kInfinity;
    if (fault_.empty()) fault_ = error.what();  // contacts that points cannot stand for
    return;
  }
  const bool needs_one = regrasps_dominate && candidate.bound >= X_regr;
  const Route route = search(*graph, context_, clock_, statistics_, limit, needs_one);
  candidate.bound = std::max(candidate.bound, route.lower_bound);
  if (route.is_complete && !route.found) {
    // Nothing costs less than the limit, so a route has more regrasps than the limit has room for.
    sequence.failed = true;
    const double regrasps = std::floor(limit / X_regr) * X_regr;
    candidate.bound =
        std::max({candidate.bound, limit, regrasps_dominate ? regrasps + candidate.pieces : 0.0});
  }
  if (!route.found || route.cost >= best_cost_) return;
  best_cost_ = route.cost;
  best_ = stages_of(*graph, route);
}

Plan GoalSearch::plan() {
  Plan plan;
  plan.statistics = statistics_;
  if (on_floor_) count(*on_floor_, clock_, plan.statistics);
  if (best_cost_ < kInfinity) {
    plan.lower_bound = lower_bound_;
    write_up(best_, context_, clock_, plan);
    const bool is_proven = lower_bound_ >= best_cost_;
    if (plan) plan.lower_bound = is_proven ? plan.cost : std::min(lower_bound_, plan.cost);
  } else {
    fail(plan);
  }
  return plan;
}

void GoalSearch::fail(Plan& plan) const {
  plan.lower_bound = lower_bound_;
  if (clock_.was_interrupted() || clock_.is_out_of_memory()) {
    blame_clock(clock_, plan);
  } else if (lower_bound_ < kInfinity) {
    plan.status = Status::out_of_time;
    plan.reason = "nothing found in time over " + std::to_string(statistics_.candidates) +
                  " motions of the object";
  } else if (statistics_.candidates == 0) {
    plan.status = Status::no_location;
    plan.limit = "geometry";
    plan.reason = "no motion of the object is free: " + fault_;
  } else {
    plan.status = Status::unstable;
    plan.reason = "none of " + std::to_string(statistics_.candidates) +
                  " motions of the object can be carried out by the fingers";
  }
}

}  // namespace graspless::fingertip
