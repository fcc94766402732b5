// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A* over poses and placements together.
#include "fingertip/lattice/graph.hpp"

#include <algorithm>
#include <limits>

namespace graspless::fingertip {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t ix(int i) { return static_cast<std::size_t>(i); }

}  // namespace

LatticeGraph::LatticeGraph(Workshop& workshop, LatticeSpace& space, LatticeBounds& bounds,
                           LatticeDistances& distances)
    : workshop_(workshop),
      space_(space),
      bounds_(bounds),
      distances_(distances),
      count_(workshop.problem.fingers.count) {}

double LatticeGraph::num_nodes() const {
  double nodes = space_.num_poses();
  for (int i = 0; i < count_; ++i) nodes *= (workshop_.locations.size() - i) / (i + 1.0);
  return nodes;
}

int LatticeGraph::id_of(const Placement& placement) {
  const auto [entry, is_new] = ids_.try_emplace(placement, static_cast<int>(placements_.size()));
  if (is_new) {
    placements_.push_back(placement);
    costs_.emplace_back();
  }
  return entry->second;
}

const Placement& LatticeGraph::placement(Key key) const {
  return placements_[static_cast<std::size_t>(key / space_.num_poses())];
}

int LatticeGraph::pose(Key key) const { return static_cast<int>(key % space_.num_poses()); }

LatticeCosts& LatticeGraph::costs(Key key) {
  auto& costs = costs_[static_cast<std::size_t>(key / space_.num_poses())];
  if (!costs) {
    costs = std::make_unique<LatticeCosts>(space_, bounds_, workshop_.options, placement(key));
  }
  return *costs;
}

bool LatticeGraph::is_clear(int pose, const Placement& placement) {
  for (int i = 0; i < num_fingers(placement); ++i) {
    if (!space_.is_clear(pose, placement[ix(i)])) return false;
  }
  return true;
}

/// (11): the way of the spheres that stay, or a regrasp; in haste the way all the same.
double LatticeGraph::left(int pose, const Placement& placement) {
  double most = 0;
  for (int i = 0; i < num_fingers(placement); ++i) {
    most = std::max(most, distances_.to_goal(placement[ix(i)], kInfinity)[pose]);
  }
  if (manner_.haste == 1) most = std::min(most, manner_.regrasp_cost);
  return most * (1 - 1e-12);
}

void LatticeGraph::push(double g, int pose, const Placement& placement, Key parent, int move) {
  const Key key = static_cast<Key>(id_of(placement)) * space_.num_poses() + pose;
  const auto node = nodes_.find(key);
  if (node != nodes_.end() && (node->second.is_closed || node->second.g <= g)) return;
  const double rest = left(pose, placement);
  if (rest == kInfinity) return;
  heap_.push_back({g + manner_.haste * rest, g, key, parent, move});
  std::push_heap(heap_.begin(), heap_.end());
}

/// All placements that keep these fingers, with the others on locations from `first` on.
void LatticeGraph::push_all(double g, int pose, const Placement& kept, int first, Key parent) {
  const int missing = count_ - num_fingers(kept);
  if (missing == 0) return push(g, pose, kept, parent, -1);
  for (int l = first; l < workshop_.locations.size(); ++l) {
    if (!space_.is_clear(pose, l)) continue;
    if (std::any_of(kept.begin(), kept.end(), [&](int other) {
          return other >= 0 && (other == l || !workshop_.locations.are_apart(other, l));
        })) {
      continue;
    }
    push_all(g, pose, with(kept, l), missing > 1 ? l + 1 : 0, parent);
  }
}

/// Makes sure of an entry's cost; false when it has to wait for its turn again, or goes.
bool LatticeGraph::settle(Entry& entry) {
  if (entry.move < 0) return true;
  LatticeCosts& arc = costs(entry.parent);
  const int from = pose(entry.parent);
  if (!arc.is_solved(from, entry.move)) arc.solve(from, entry.move);
  const double g = nodes_.at(entry.parent).g + arc.cost(from, entry.move);
  if (g <= entry.g) return true;
  if (g < kInfinity) {
    entry.f += g - entry.g;
    entry.g = g;
    heap_.push_back(entry);
    std::push_heap(heap_.begin(), heap_.end());
  }
  return false;
}

void LatticeGraph::expand(Key key, double g) {
  const int from = pose(key);
  const Placement fingers = placement(key);
  for (int move = 0; move < LatticeSpace::kMoves; ++move) {
    const int to = space_.next(from, move);
    if (to < 0) continue;
    const double cost = costs(key).cost(from, move);
    if (cost < kInfinity && is_clear(to, fingers)) push(g + cost, to, fingers, key, move);
  }
}

/// Each finger may leave if the others hold the object at rest.
void LatticeGraph::lift_fingers(Key key, double g) {
  const int at = pose(key);
  const Placement fingers = placement(key);
  const int rest = space_.rest_instant(at);
  for (int i = 0; i < count_; ++i) {
    const Placement kept = without(fingers, fingers[ix(i)]);
    const Key hub = static_cast<Key>(id_of(kept)) * space_.num_poses() + at;
    const auto known = nodes_.find(hub);
    if (known != nodes_.end() && known->second.is_closed) continue;
    if (refused_.count(hub) > 0 || bounds_.solve(rest, kept) <= 0) continue;
    push(g + manner_.regrasp_cost, at, kept, key, -1);
  }
}

Route LatticeGraph::search(const Manner& manner, planning::Clock& clock, Statistics& statistics) {
  manner_ = manner;
  double bound = refused_.empty() ? kInfinity : 0;  // from when nothing was refused
  for (;;) {
    Key goal = -1;
    Route route = search_once(clock, statistics, goal);
    if (!refused_.empty()) {
      // A hub refused before one move might do before another.
      route.is_complete = false;
      route.lower_bound = std::min(route.lower_bound, bound);
    }
    if (!route.found || holds_at_rest(goal)) return route;
    bound = std::min(bound, route.lower_bound);
  }
}

/// Whether the fingers kept hold the object in each regrasp also with cones along the way to go:
/// the search does not know that yet when it comes to a hub. One that fails is refused.
bool LatticeGraph::holds_at_rest(Key goal) {
  int next_move = -1;
  for (Key key = goal; key >= 0; key = nodes_.at(key).parent) {
    const Node& node = nodes_.at(key);
    if (node.move >= 0) next_move = node.move;
    if (num_fingers(placement(key)) == count_ || next_move < 0) continue;
    if (bounds_.solve(space_.rest_instant(pose(key), next_move), placement(key)) > 0) continue;
    refused_.insert(key);
    return false;
  }
  return true;
}

Route LatticeGraph::search_once(planning::Clock& clock, Statistics& statistics, Key& goal) {
  heap_.clear();
  nodes_.clear();
  push_all(0, space_.start(), kNoFingers, 0, -1);
  Route route;
  while (!heap_.empty()) {
    if (nodes_.size() >= manner_.max_nodes || clock.is_out() || !clock.spend()) return route;
    std::pop_heap(heap_.begin(), heap_.end());
    Entry entry = heap_.back();
    heap_.pop_back();
    const auto known = nodes_.find(entry.key);
    if (known != nodes_.end() && known->second.is_closed) continue;
    route.lower_bound = std::max(route.lower_bound, entry.f);
    if (!settle(entry)) continue;
    nodes_[entry.key] = {entry.g, entry.parent, entry.move, true};
    ++statistics.nodes;
    if (num_fingers(placement(entry.key)) < count_) {
      push_all(entry.g, pose(entry.key), placement(entry.key), 0, entry.key);
      continue;
    }
    if (pose(entry.key) == space_.goal()) {
      goal = entry.key;
      return route_to(goal);
    }
    expand(entry.key, entry.g);
    lift_fingers(entry.key, entry.g);
  }
  route.is_complete = true;
  route.lower_bound = kInfinity;
  return route;
}

Route LatticeGraph::route_to(Key goal) const {
  Route route;
  route.found = route.is_complete = true;
  route.cost = nodes_.at(goal).g;
  for (Key key = goal; key >= 0; key = nodes_.at(key).parent) {
    if (num_fingers(placement(key)) < count_) {
      route.cost += workshop_.options.regrasp_cost - manner_.regrasp_cost;
    } else {
      route.nodes.push_back({pose(key), placement(key)});
    }
  }
  std::reverse(route.nodes.begin(), route.nodes.end());
  route.lower_bound = route.cost;
  return route;
}

}  // namespace graspless::fingertip
