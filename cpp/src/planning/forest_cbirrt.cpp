// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/forest_cbirrt.hpp"

#include <cmath>
#include <limits>

#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include "graspless/watch.hpp"

#include "planning/forest.hpp"
#include "planning/root_components.hpp"

namespace graspless::planning {

namespace ob = ompl::base;

namespace {

/// A state that is freed at the end of its scope.
class OwnedState {
 public:
  explicit OwnedState(const ob::SpaceInformationPtr& si) : si_(si), state_(si->allocState()) {}
  ~OwnedState() { si_->freeState(state_); }
  OwnedState(const OwnedState&) = delete;
  OwnedState& operator=(const OwnedState&) = delete;
  operator ob::State*() const { return state_; }

 private:
  const ob::SpaceInformationPtr& si_;
  ob::State* state_;
};

constexpr double kAnyCost = std::numeric_limits<double>::infinity();

double uniform(std::mt19937_64& rng) { return std::uniform_real_distribution<double>(0, 1)(rng); }

}  // namespace

// Replaces Planner::checkValidity(), which requires a start state; here a start region suffices.
void ForestCBiRRT::check_problem() const {
  if (!pdef_) throw ompl::Exception(getName(), "no problem definition set");
  if (!dynamic_cast<const ob::GoalSampleableRegion*>(pdef_->getGoal().get())) {
    throw ompl::Exception(getName(), "the goal must be a GoalSampleableRegion");
  }
  if (!start_region_ && pdef_->getStartStateCount() == 0) {
    throw ompl::Exception(getName(), "needs a start region or at least one start state");
  }
}

void ForestCBiRRT::add_given_starts() {
  while (const State* state = pis_.nextStart()) start_forest_->add_root(state);
}

ob::PlannerStatus ForestCBiRRT::solve(const ob::PlannerTerminationCondition& ptc) {
  if (!isSetup()) setup();
  check_problem();
  add_given_starts();
  if (connect_first_ && connect_partners(ptc)) return ob::PlannerStatus::EXACT_SOLUTION;
  const OwnedState q_rand(si_);
  Meeting meeting;
  Forest* a = next_;                                                                // 1
  Forest* b = a == start_forest_.get() ? goal_forest_.get() : start_forest_.get();  // 1
  for (; !ptc; std::swap(a, b)) {                                                   // 2, 18
    if (can_add_root() || a->size() == 0) {                                         // 3, Eq. (5)
      const int root = add_from_region(*a);                                         // 4
      if (root >= 0 && connect_first_) {
        const auto pair = add_partner(start_for(*a, root), kAnyCost);
        if (pair && is_solved_by(*pair)) return ob::PlannerStatus::EXACT_SOLUTION;
      }
    }
    if (a->size() == 0 || b->size() == 0) continue;
    random_config_ ? random_config_(rng_, q_rand) : sampler_->sampleUniform(q_rand);  // 6
    const int near_a = a->nearest(q_rand);                                            // 7
    const int new_a = extend(*a, near_a, q_rand);                                     // 8
    const int near_b = b->nearest(a->state(new_a));                                   // 9
    const int new_b = extend(*b, near_b, a->state(new_a));                            // 10
    if (!si_->equalStates(a->state(new_a), b->state(new_b))) continue;                // 11
    meeting = a == start_forest_.get() ? Meeting{new_a, new_b} : Meeting{new_b, new_a};
    if (solves(meeting)) return ob::PlannerStatus::EXACT_SOLUTION;  // 12 - 15
  }
  next_ = a;
  if (start_forest_->size() == 0) return ob::PlannerStatus::INVALID_START;
  if (goal_forest_->size() == 0) return ob::PlannerStatus::INVALID_GOAL;
  return ob::PlannerStatus::TIMEOUT;
}

bool ForestCBiRRT::can_add_root() {
  const double num_roots = static_cast<double>(num_start_roots() + num_goal_roots());
  return std::exp(-num_roots / root_scale_) > uniform(rng_);
}

int ForestCBiRRT::add_from_region(Forest& forest) {
  const auto* region = &forest == start_forest_.get()
                           ? start_region_.get()
                           : dynamic_cast<const ob::GoalSampleableRegion*>(pdef_->getGoal().get());
  if (!region || forest.roots().size() >= region->maxSampleCount()) return -1;
  const OwnedState state(si_);
  return draw(*region, state) ? forest.add_root(state) : -1;
}

bool ForestCBiRRT::draw(const ob::GoalSampleableRegion& region, State* state) const {
  if (const auto* ours = dynamic_cast<const SampleableRegion*>(&region))
    return ours->try_sample(state);
  if (!region.canSample()) return false;
  region.sampleGoal(state);
  return si_->isValid(state);
}

// Precedes Algorithm 1 with set_connect_first(). Most queries end here, before a tree has grown.
// The cheapest pairs of the first starts are tried first. Where obstacles are in their way, any
// other pair is as good, and trees find a way around. Where hardly any goal fits a start, trees
// do not help, and more starts are drawn.
bool ForestCBiRRT::connect_partners(const ob::PlannerTerminationCondition& ptc) {
  constexpr int kStarts = 200, kMostStarts = 500, kFewPairs = 3;
  if (!start_region_ && start_forest_->size() == 0) return false;
  const std::vector<int> given = start_forest_->roots();
  std::vector<Pair> pairs;  // each cheaper than those before
  int to_compare = start_region_ ? kCompared : 1, num_tried = 0, most = kMostStarts;
  for (int i = 0; i < most && !ptc; ++i) {
    const int start = start_region_ ? add_from_region(*start_forest_)
                                    : given[static_cast<std::size_t>(i) % given.size()];
    if (start >= 0) --to_compare;
    if (const auto pair = add_partner(start, pairs.empty() ? kAnyCost : pairs.back().cost)) {
      pairs.push_back(*pair);
    }
    if (to_compare > 0 && i + 1 < most) continue;
    for (; !pairs.empty(); pairs.pop_back(), ++num_tried) {
      if (is_solved_by(pairs.back())) return true;
    }
    to_compare = 1;
    if (num_tried >= kFewPairs) most = kStarts;
  }
  return false;
}

// The root itself if it is a start, or a random start otherwise: a goal that was sampled on its own
// hardly ever fits a start. -1 if there is none.
int ForestCBiRRT::start_for(const Forest& forest, int root) {
  if (&forest == start_forest_.get()) return root;
  const auto& starts = start_forest_->roots();
  if (starts.empty()) return -1;
  return starts[static_cast<std::size_t>(uniform(rng_) * static_cast<double>(starts.size()))];
}

// Samples a goal that fits a start root.
std::optional<ForestCBiRRT::Pair> ForestCBiRRT::add_partner(int start, double max_cost) {
  const auto* region = dynamic_cast<const SampleableRegion*>(pdef_->getGoal().get());
  if (!region || start < 0) return std::nullopt;
  const OwnedState goal(si_);
  const auto cost = region->try_sample_partner(start_forest_->state(start), goal, max_cost);
  if (!cost) return std::nullopt;
  return Pair{start, goal_forest_->add_root(goal), *cost};
}

// True if the straight way from start to goal connects the two, and solves the problem.
bool ForestCBiRRT::is_solved_by(const Pair& pair) {
  const State* goal = goal_forest_->state(pair.goal);
  const int reached = extend(*start_forest_, pair.start, goal);
  if (!si_->equalStates(start_forest_->state(reached), goal)) return false;
  return solves({reached, pair.goal});
}

// ConstrainedExtend() of CBiRRT: takes steps towards the target, each projected onto the
// constraint, until the target is reached or a step fails. Returns the last node.
int ForestCBiRRT::extend(Forest& forest, int from, const State* target) {
  const State* start = &forest == start_forest_.get() ? forest.state(forest.root(from)) : nullptr;
  const OwnedState next(si_);
  int last = from;
  double left = si_->distance(forest.state(last), target);
  while (left > 0) {
    poll();
    const State* current = forest.state(last);
    si_->getStateSpace()->interpolate(current, target, std::min(1.0, range_ / left), next);
    if (project_ && !project_(next)) break;
    const double now_left = si_->distance(next, target);
    constexpr double kProgress = 1e-3;  // a projection may undo all progress of a step
    constexpr double kReached = 1e-12;  // the target may be nearer than that
    const bool is_nearer = now_left < kReached || now_left <= left - kProgress * range_;
    if (!is_nearer || si_->distance(current, next) > 2 * range_) break;
    if (!is_motion_valid(start, current, next)) break;
    last = forest.add(next, last);
    left = now_left < kReached ? 0 : now_left;
  }
  return last;
}

bool ForestCBiRRT::is_motion_valid(const State* start, const State* from, const State* to) const {
  return motion_check_ ? motion_check_(start, from, to) : si_->checkMotion(from, to);
}

bool ForestCBiRRT::solves(const Meeting& meeting) {
  const int start = start_forest_->root(meeting.start_node);
  const int goal = goal_forest_->root(meeting.goal_node);                                    // 12
  if (!connect_first_) return is_pair_valid(start, goal) && accept(start, goal, {meeting});  // 13
  auto connected = components_->join({meeting.start_node, meeting.goal_node, start, goal});
  if (connected.empty())
    connected.emplace_back(start, goal);  // already connected, now by another path
  for (const auto& [s, g] : connected) {
    if (!is_pair_valid(s, g)) continue;
    std::vector<Meeting> route{meeting};
    if (s != start || g != goal) {
      route.clear();
      for (const Bridge& bridge : components_->route(s, g)) {
        route.push_back({bridge.start_node, bridge.goal_node});
      }
    }
    if (accept(s, g, route)) return true;
  }
  return false;
}

bool ForestCBiRRT::is_pair_valid(int start_root, int goal_root) {
  if (refused_.count({start_root, goal_root})) return false;
  ++num_pairs_;
  const bool valid = pdef_->getGoal()->isStartGoalPairValid(start_forest_->state(start_root),
                                                            goal_forest_->state(goal_root));
  if (!valid) refused_.emplace(start_root, goal_root);
  return valid;
}

// 14: extracts the path through the meetings. Its motions outside the start's own tree are checked
// again, now that the start is known.
bool ForestCBiRRT::accept(int start_root, int goal_root, const std::vector<Meeting>& route) {
  const State* start = start_forest_->state(start_root);
  auto path = std::make_shared<ompl::geometric::PathGeometric>(si_);
  const auto append = [&](const Forest& forest, int from, int to) {
    for (int node : forest.path(from, to)) {
      const bool repeats = path->getStateCount() > 0 &&
                           si_->equalStates(path->getStates().back(), forest.state(node));
      if (!repeats) path->append(forest.state(node));
    }
    return path->getStateCount();
  };
  bool in_start = true;
  int at = start_root;
  std::size_t known = 0;
  for (const Meeting& meeting : route) {
    const std::size_t count = in_start ? append(*start_forest_, at, meeting.start_node)
                                       : append(*goal_forest_, at, meeting.goal_node);
    if (known == 0) known = count;
    in_start = !in_start;
    at = in_start ? meeting.start_node : meeting.goal_node;
  }
  append(*goal_forest_, at, goal_root);
  if (path_check_ ? !path_check_(path->getStates())
                  : !are_motions_valid(start, path->getStates(), known)) {
    return false;
  }
  pdef_->addSolutionPath(path, false, 0.0, getName());
  return true;
}

bool ForestCBiRRT::are_motions_valid(const State* start, const std::vector<State*>& path,
                                     std::size_t first) const {
  for (std::size_t i = first; motion_check_ && i < path.size(); ++i) {
    if (!motion_check_(start, path[i - 1], path[i])) return false;
  }
  return true;
}

}  // namespace graspless::planning
