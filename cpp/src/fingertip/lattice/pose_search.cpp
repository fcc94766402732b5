// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A* over the object's poses with the fingers at one placement.
#include <algorithm>
#include <cmath>

#include "fingertip/lattice/search.hpp"

namespace graspless::fingertip {
namespace {

constexpr int kAttempts = 8;        // to find a path by bounds alone
constexpr int kBetweenClocks = 16;  // poses between two looks at the clock

}  // namespace

PlacementCosts::PlacementCosts(const PoseGraph& graph, LatticeBounds& bounds,
                               const Placement& placement)
    : graph_(graph), bounds_(bounds), placement_(placement) {
  displacements_.reserve(graph.num_motions());
  for (int motion = 0; motion < graph.num_motions(); ++motion) {
    displacements_.push_back(displacement(graph, motion, placement));
  }
}

bool PlacementCosts::is_clear(int pose) const {
  for (int i = 0; i < num_fingers(placement_); ++i) {
    if (!graph_.is_clear(pose, placement_[i])) return false;
  }
  return true;
}

PlacementCosts::Weight& PlacementCosts::weight(int kind) {
  if (kind >= static_cast<int>(weights_.size())) weights_.resize(graph_.num_kinds());
  Weight& weight = weights_[kind];
  if (weight.value >= 0) return weight;
  z_.clear();
  for (const int instant : graph_.instants(kind)) {
    const double z = bounds_.bound(instant, placement_);
    z_.push_back(z < graph_.options.min_stability ? 0 : z);
  }
  weight.value = arc_weight(graph_, z_);
  weight.is_solved = weight.value == kInfinity;
  return weight;
}

double PlacementCosts::cost(int pose, int move) {
  const int kind = graph_.kind(pose, move);
  if (kind < 0) return kInfinity;
  const double value = weight(kind).value;
  if (value == kInfinity || !is_arc_clear(graph_, pose, move, placement_)) return kInfinity;
  return displacements_[graph_.motion(pose, move)] * value;
}

bool PlacementCosts::is_solved(int pose, int move) {
  return weight(graph_.kind(pose, move)).is_solved;
}

double PlacementCosts::solve(int pose, int move) {
  const int kind = graph_.kind(pose, move);
  Weight& known = weight(kind);
  if (known.is_solved) return cost(pose, move);
  z_.clear();
  for (const int instant : graph_.instants(kind)) {
    z_.push_back(bounds_.solve(instant, placement_));
    if (z_.back() <= 0) break;
  }
  known.value = z_.back() > 0 ? arc_weight(graph_, z_) : kInfinity;
  known.is_solved = true;
  return cost(pose, move);
}

PoseSearch::PoseSearch(const PoseGraph& graph, RemainingDistance& remaining)
    : graph_(graph), remaining_(remaining), states_(graph.num_poses()) {}

void PoseSearch::begin(const Placement& placement, double limit) {
  ++round_;
  heap_.clear();
  to_goal_.clear();
  for (const std::int32_t location : placement) {
    if (location >= 0) to_goal_.push_back(remaining_.to_goal(location, limit));
  }
}

double PoseSearch::heuristic(int pose) const {
  double most = 0;
  for (const double* distances : to_goal_) most = std::max(most, distances[pose]);
  return most * (1 - 1e-12);
}

/// What this round knows of a pose.
PoseSearch::State& PoseSearch::state(int pose) {
  State& state = states_[pose];
  if (state.round != round_) {
    state = State{};
    state.round = round_;
    state.rest = heuristic(pose);
  }
  return state;
}

void PoseSearch::push(const Entry& entry) {
  heap_.push_back(entry);
  std::push_heap(heap_.begin(), heap_.end());
}

void PoseSearch::expand(PlacementCosts& costs, int pose, double g, const Settings& settings) {
  for (int move = 0; move < graph_.num_moves(); ++move) {
    const int to = graph_.next(pose, move);
    if (to < 0) continue;
    State& there = state(to);
    if (there.is_closed) continue;
    const double g_to = g + costs.cost(pose, move);
    if (!(g_to < there.g && g_to + there.rest < settings.limit)) continue;
    if (!there.is_clear && !costs.is_clear(to)) {
      there.is_closed = true;
      continue;
    }
    there.is_clear = true;
    if (!settings.exact || costs.is_solved(pose, move)) there.g = g_to;
    push({g_to + there.rest, g_to, to, pose, move});
  }
}

PosePath PoseSearch::find(PlacementCosts& costs, double limit, planning::Clock& clock,
                          Statistics& statistics) {
  PosePath best;
  if (!costs.is_clear(graph_.start()) || !costs.is_clear(graph_.goal())) return best;
  // By the bounds alone first: most placements fail at that.
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    PosePath path = search(costs, {limit, false}, clock, statistics);
    if (!path.found) return best;
    if (!solve_all(costs, path)) continue;
    if (path.cost >= limit) break;
    limit = path.cost;
    best = std::move(path);
    break;
  }
  PosePath path = search(costs, {limit, true}, clock, statistics);
  return path.found ? path : best;
}

/// Solves the arcs of a path, and its cost; false when one is impossible.
bool PoseSearch::solve_all(PlacementCosts& costs, PosePath& path) {
  path.cost = 0;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const int pose = path.poses[i], move = path.moves[i];
    path.cost += costs.solve(pose, move);
    if (path.cost == kInfinity) return false;
  }
  return true;
}

PosePath PoseSearch::search(PlacementCosts& costs, const Settings& settings, planning::Clock& clock,
                            Statistics& statistics) {
  begin(costs.placement(), settings.limit);
  const double least = state(graph_.start()).rest;
  if (least >= settings.limit) return {};
  push({least, 0, graph_.start(), -1, -1});
  for (int taken = 0; !heap_.empty(); ++taken) {
    if (taken % kBetweenClocks == 0 && clock.is_out()) break;
    std::pop_heap(heap_.begin(), heap_.end());
    const Entry entry = heap_.back();
    heap_.pop_back();
    State& here = state(entry.pose);
    if (here.is_closed) continue;
    if (settings.exact && entry.from >= 0) {
      // It may have been pushed with a bound.
      const double g = state(entry.from).g + costs.solve(entry.from, entry.move);
      if (g > entry.g) {
        const double f = g + here.rest;
        if (f < settings.limit) push({f, g, entry.pose, entry.from, entry.move});
        continue;
      }
    }
    here.is_closed = true;
    here.g = entry.g;
    here.parent = entry.from;
    here.move = entry.move;
    ++statistics.nodes;
    if (entry.pose == graph_.goal()) return path_to_goal();
    expand(costs, entry.pose, entry.g, settings);
  }
  return {};
}

PosePath PoseSearch::path_to_goal() const {
  PosePath path;
  path.found = true;
  path.cost = states_[graph_.goal()].g;
  for (int pose = graph_.goal(); pose >= 0; pose = states_[pose].parent) {
    path.poses.push_back(pose);
    const State& state = states_[pose];
    if (state.parent >= 0) path.moves.push_back(state.move);
  }
  std::reverse(path.poses.begin(), path.poses.end());
  std::reverse(path.moves.begin(), path.moves.end());
  return path;
}

}  // namespace graspless::fingertip
