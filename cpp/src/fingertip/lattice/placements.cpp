// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Section 4 turned round for lattices: placements first, poses second, stabilities last.
#include <algorithm>
#include <limits>
#include <random>

#include "fingertip/lattice/pose_search.hpp"
#include "fingertip/lattice/search.hpp"

namespace graspless::fingertip {
namespace {

constexpr int kSamples = 300;

/// A location, and the least displacement of its sphere [m].
struct Reach {
  double distance;
  int location;
  bool operator<(const Reach& other) const {
    return distance < other.distance || (distance == other.distance && location < other.location);
  }
};

class PlacementSearch {
 public:
  PlacementSearch(const PoseGraph& graph, LatticeBounds& bounds, RemainingDistance& remaining,
                  planning::Clock& clock, Statistics& statistics)
      : graph_(graph),
        bounds_(bounds),
        clock_(clock),
        statistics_(statistics),
        pose_search_(graph, remaining) {
    for (int l = 0; l < graph.locations.size(); ++l) {
      if (!graph.is_clear(graph.start(), l) || !graph.is_clear(graph.goal(), l)) continue;
      const double distance =
          (graph.center_W(graph.goal(), l) - graph.center_W(graph.start(), l)).norm();
      reaches_.push_back({distance, l});
    }
    std::sort(reaches_.begin(), reaches_.end());
    route_.cost = kInfinity;
  }

  Route run() {
    const int count = graph_.num_fingers;
    find_any(count);
    // All placements whose farthest sphere is this one have the same bound.
    for (std::size_t last = 0; last < reaches_.size(); ++last) {
      if (reaches_[last].distance >= route_.cost) break;
      if (!extend(with(kNoFingers, reaches_[last].location), last, count - 1)) {
        route_.lower_bound = std::min(route_.cost, reaches_[last].distance);
        return route_;
      }
    }
    route_.is_complete = !clock_.is_out();
    if (route_.is_complete) route_.lower_bound = route_.cost;
    return route_;
  }

 private:
  /// A first route from random placements, so that the rest can be refused by their bounds.
  void find_any(int count) {
    std::mt19937 random(1);
    for (int i = 0; i < kSamples && !clock_.is_out(); ++i) {
      // Only placements that could be cheaper than what is there.
      const auto end = std::lower_bound(reaches_.begin(), reaches_.end(), Reach{route_.cost, -1});
      const auto choices = static_cast<std::size_t>(end - reaches_.begin());
      Placement placement = kNoFingers;
      for (int k = 0; k < count && choices > 0; ++k) {
        const int location = reaches_[random() % choices].location;
        if (has_room(graph_, graph_.start(), placement, location)) {
          placement = with(placement, location);
        }
      }
      if (num_fingers(placement) == count) examine(placement, true);
    }
  }

  /// Adds `missing` fingers on locations before `last`; false when time is up.
  bool extend(const Placement& placement, std::size_t last, int missing) {
    if (missing == 0) {
      if (clock_.is_out() || !clock_.spend()) return false;
      examine(placement, false);
      return true;
    }
    for (std::size_t i = 0; i < last; ++i) {
      const int location = reaches_[i].location;
      if (!has_room(graph_, graph_.start(), placement, location)) continue;
      if (!extend(with(placement, location), i, missing - 1)) return false;
    }
    return true;
  }

  void examine(const Placement& placement, bool soon) {
    if (!has_arc(placement, graph_.start(), true) || !has_arc(placement, graph_.goal(), false)) {
      return;
    }
    PlacementCosts costs(graph_, bounds_, placement);
    const PosePath path = soon ? pose_search_.find_soon(costs, route_.cost, clock_, statistics_)
                               : pose_search_.find(costs, route_.cost, clock_, statistics_);
    if (!path.found) return;
    route_.found = true;
    route_.cost = path.cost;
    route_.nodes.clear();
    for (const int pose : path.poses) route_.nodes.push_back({pose, placement});
  }

  /// True if the bounds allow an arc from a pose, or to it.
  bool has_arc(const Placement& placement, int pose, bool from) {
    for (int move = 0; move < graph_.num_moves(); ++move) {
      const int other = from ? graph_.next(pose, move) : graph_.previous(pose, move);
      if (other < 0) continue;
      const int kind = graph_.kind(from ? pose : other, move);
      if (kind < 0) continue;
      const std::vector<int>& instants = graph_.instants(kind);
      if (std::all_of(instants.begin(), instants.end(), [&](int instant) {
            return bounds_.bound(instant, placement) >= graph_.options.min_stability;
          })) {
        return true;
      }
    }
    return false;
  }

  const PoseGraph& graph_;
  LatticeBounds& bounds_;
  planning::Clock& clock_;
  Statistics& statistics_;
  PoseSearch pose_search_;
  std::vector<Reach> reaches_;  // ascending
  Route route_;
};

}  // namespace

Route search_placements(const PoseGraph& graph, LatticeBounds& bounds, RemainingDistance& remaining,
                        planning::Clock& clock, Statistics& statistics) {
  return PlacementSearch(graph, bounds, remaining, clock, statistics).run();
}

}  // namespace graspless::fingertip
