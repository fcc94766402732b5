// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A* over the object's poses with the fingers at one placement.
#include "fingertip/lattice/way.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::fingertip {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kAttempts = 8;    // at a way by bounds alone
constexpr double kHaste = 2.5;  // what is left counts so many times when any way will do

std::size_t ix(int i) { return static_cast<std::size_t>(i); }

}  // namespace

LatticeCosts::LatticeCosts(LatticeSpace& space, LatticeBounds& bounds, const Options& options,
                           const Placement& placement)
    : space_(space),
      bounds_(bounds),
      options_(options),
      placement_(placement),
      count_(num_fingers(placement)) {
  speeds_.reserve(ix(space.num_yaws()) * LatticeSpace::kMoves);
  for (int yaw = 0; yaw < space.num_yaws(); ++yaw) {
    for (int move = 0; move < LatticeSpace::kMoves; ++move) {
      double speed = 0;
      for (int i = 0; i < count_; ++i) {
        speed = std::max(speed, space.displacement(yaw, move, placement[ix(i)]));
      }
      speeds_.push_back(speed);
    }
  }
}

bool LatticeCosts::is_clear(int pose) {
  for (int i = 0; i < count_; ++i) {
    if (!space_.is_clear(pose, placement_[ix(i)])) return false;
  }
  return true;
}

LatticeCosts::Weight& LatticeCosts::weight(int kind) {
  if (ix(kind) >= weights_.size()) weights_.resize(ix(space_.num_kinds()));
  Weight& weight = weights_[ix(kind)];
  if (weight.value >= 0) return weight;
  const std::vector<int>& instants = space_.instants(kind);
  weight.value = 1;
  for (const int instant : instants) {
    const double z = bounds_.bound(instant, placement_);
    const double share = 1 / static_cast<double>(instants.size());
    weight.value += z < options_.min_stability ? kInfinity : options_.stability_weight / z * share;
  }
  weight.is_solved = weight.value == kInfinity;
  return weight;
}

double LatticeCosts::cost(int pose, int move) {
  const int kind = space_.arc_kind(pose, move);
  if (kind < 0) return kInfinity;
  const double value = weight(kind).value;
  if (value == kInfinity) return kInfinity;
  return speeds_[ix(space_.yaw(pose) * LatticeSpace::kMoves + move)] * value;
}

bool LatticeCosts::is_solved(int pose, int move) {
  return weight(space_.arc_kind(pose, move)).is_solved;
}

void LatticeCosts::solve(int pose, int move) {
  const int kind = space_.arc_kind(pose, move);
  Weight& known = weight(kind);
  const std::vector<int>& instants = space_.instants(kind);
  double value = 1;
  for (const int instant : instants) {
    const double z = bounds_.solve(instant, placement_);
    if (z <= 0) {
      value = kInfinity;
      break;
    }
    value += options_.stability_weight / z / static_cast<double>(instants.size());
  }
  known.value = value;
  known.is_solved = true;
}

LatticeAstar::LatticeAstar(LatticeSpace& space, LatticeDistances& distances)
    : space_(space),
      distances_(distances),
      best_(ix(space.num_poses())),
      parent_(ix(space.num_poses())),
      move_(ix(space.num_poses())),
      stamp_(ix(space.num_poses()), 0),
      closed_(ix(space.num_poses()), 0) {}

void LatticeAstar::begin(const Placement& placement, double limit) {
  ++round_;
  heap_.clear();
  to_goal_.clear();
  for (const std::int32_t location : placement) {
    if (location >= 0) to_goal_.push_back(distances_.to_goal(location, limit));
  }
}

double LatticeAstar::left(int pose) const {
  double most = 0;
  for (const double* distances : to_goal_) most = std::max(most, distances[pose]);
  return most * (1 - 1e-12);
}

void LatticeAstar::push(const Entry& entry) {
  heap_.push_back(entry);
  std::push_heap(heap_.begin(), heap_.end());
}

void LatticeAstar::expand(LatticeCosts& costs, int pose, double g, const Manner& manner) {
  for (int move = 0; move < LatticeSpace::kMoves; ++move) {
    const int to = space_.next(pose, move);
    if (to < 0 || closed_[ix(to)] == round_) continue;
    const double cost = costs.cost(pose, move);
    if (cost == kInfinity) continue;
    const double g_to = g + cost;
    if (stamp_[ix(to)] == round_ && g_to >= best_[ix(to)]) continue;
    const double rest = left(to);
    if (!(g_to + rest < manner.limit) || !costs.is_clear(to)) continue;
    if (!manner.exact || costs.is_solved(pose, move)) {
      stamp_[ix(to)] = round_;
      best_[ix(to)] = g_to;
    }
    push({g_to + manner.haste * rest, g_to, to, pose, move});
  }
}

LatticeWay LatticeAstar::find(LatticeCosts& costs, double limit, planning::Clock& clock,
                              Statistics& statistics) {
  LatticeWay best;
  if (!costs.is_clear(space_.start()) || !costs.is_clear(space_.goal())) return best;
  // By the bounds alone first: most placements fail at that.
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    LatticeWay way = search(costs, {limit, false, 1}, clock, statistics);
    if (!way.found) return best;
    if (!solve_all(costs, way)) continue;
    if (way.cost >= limit) break;
    limit = way.cost;
    best = std::move(way);
    break;
  }
  LatticeWay way = search(costs, {limit, true, 1}, clock, statistics);
  return way.found ? way : best;
}

LatticeWay LatticeAstar::find_soon(LatticeCosts& costs, double limit, planning::Clock& clock,
                                   Statistics& statistics) {
  if (!costs.is_clear(space_.start()) || !costs.is_clear(space_.goal())) return {};
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    LatticeWay way = search(costs, {limit, false, kHaste}, clock, statistics);
    if (!way.found || (solve_all(costs, way) && way.cost < limit)) return way;
  }
  return {};
}

/// Solves the arcs of a way, and its cost; false when one is impossible.
bool LatticeAstar::solve_all(LatticeCosts& costs, LatticeWay& way) {
  way.cost = 0;
  for (std::size_t i = 0; i < way.moves.size(); ++i) {
    const int pose = way.poses[i], move = way.moves[i];
    if (!costs.is_solved(pose, move)) costs.solve(pose, move);
    way.cost += costs.cost(pose, move);
    if (way.cost == kInfinity) return false;
  }
  return true;
}

LatticeWay LatticeAstar::search(LatticeCosts& costs, const Manner& manner, planning::Clock& clock,
                                Statistics& statistics) {
  begin(costs.placement(), manner.limit);
  if (left(space_.start()) >= manner.limit) return {};
  push({left(space_.start()), 0, space_.start(), -1, -1});
  while (!heap_.empty() && !clock.is_out()) {
    std::pop_heap(heap_.begin(), heap_.end());
    Entry entry = heap_.back();
    heap_.pop_back();
    if (closed_[ix(entry.pose)] == round_) continue;
    if (manner.exact && entry.from >= 0) {
      if (!costs.is_solved(entry.from, entry.move)) costs.solve(entry.from, entry.move);
      // It may have been pushed with a bound.
      const double more = best_[ix(entry.from)] + costs.cost(entry.from, entry.move) - entry.g;
      if (more > 0) {
        entry.g += more;
        entry.f += more;
        if (entry.f < manner.limit) push(entry);
        continue;
      }
    }
    closed_[ix(entry.pose)] = stamp_[ix(entry.pose)] = round_;
    best_[ix(entry.pose)] = entry.g;
    parent_[ix(entry.pose)] = entry.from;
    move_[ix(entry.pose)] = entry.move;
    ++statistics.nodes;
    if (entry.pose == space_.goal()) return way_to_goal();
    expand(costs, entry.pose, entry.g, manner);
  }
  return {};
}

LatticeWay LatticeAstar::way_to_goal() const {
  LatticeWay way;
  way.found = true;
  way.cost = best_[ix(space_.goal())];
  for (int pose = space_.goal(); pose >= 0; pose = parent_[ix(pose)]) {
    way.poses.push_back(pose);
    if (parent_[ix(pose)] >= 0) way.moves.push_back(move_[ix(pose)]);
  }
  std::reverse(way.poses.begin(), way.poses.end());
  std::reverse(way.moves.begin(), way.moves.end());
  return way;
}

}  // namespace graspless::fingertip
