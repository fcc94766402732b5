// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Placements first, poses second, stabilities last: without regrasps.
#include "fingertip/lattice/search.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include "fingertip/lattice/way.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSamples = 300;

/// A location, and how far its sphere has to go at least.
struct Reach {
  double distance;
  int location;
  bool operator<(const Reach& other) const {
    return distance < other.distance || (distance == other.distance && location < other.location);
  }
};

class PlacementSearch {
 public:
  PlacementSearch(Workshop& workshop, LatticeSpace& space, LatticeBounds& bounds,
                  LatticeDistances& distances, planning::Clock& clock, Statistics& statistics)
      : workshop_(workshop),
        space_(space),
        bounds_(bounds),
        clock_(clock),
        statistics_(statistics),
        astar_(space, distances) {
    for (int l = 0; l < workshop.locations.size(); ++l) {
      if (!space.is_clear(space.start(), l) || !space.is_clear(space.goal(), l)) continue;
      const double distance =
          (space.center_W(space.goal(), l) - space.center_W(space.start(), l)).norm();
      reaches_.push_back({distance, l});
    }
    std::sort(reaches_.begin(), reaches_.end());
    route_.cost = kInfinity;
  }

  Route run() {
    const int count = workshop_.problem.fingers.count;
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
        if (fits(placement, location)) placement = with(placement, location);
      }
      if (num_fingers(placement) == count) look_at(placement, true);
    }
  }

  bool fits(const Placement& placement, int location) const {
    return std::none_of(placement.begin(), placement.end(), [&](int other) {
      return other >= 0 && (other == location || !workshop_.locations.are_apart(other, location));
    });
  }

  /// Adds `missing` fingers on locations before `last`; false when time is up.
  bool extend(const Placement& placement, std::size_t last, int missing) {
    if (missing == 0) {
      if (clock_.is_out() || !clock_.spend()) return false;
      look_at(placement, false);
      return true;
    }
    for (std::size_t i = 0; i < last; ++i) {
      const int location = reaches_[i].location;
      if (!fits(placement, location)) continue;
      if (!extend(with(placement, location), i, missing - 1)) return false;
    }
    return true;
  }

  void look_at(const Placement& placement, bool soon) {
    if (!can_leave(placement, space_.start(), 1) || !can_leave(placement, space_.goal(), -1)) {
      return;
    }
    LatticeCosts costs(space_, bounds_, workshop_.options, placement);
    const LatticeWay way = soon ? astar_.find_soon(costs, route_.cost, clock_, statistics_)
                                : astar_.find(costs, route_.cost, clock_, statistics_);
    if (!way.found) return;
    route_.found = true;
    route_.cost = way.cost;
    route_.nodes.clear();
    for (const int pose : way.poses) route_.nodes.push_back({pose, placement});
  }

  /// Whether the bounds allow a first move, or a last one.
  bool can_leave(const Placement& placement, int pose, int direction) {
    for (int move = 0; move < LatticeSpace::kMoves; ++move) {
      const int other = space_.next(pose, direction > 0 ? move : LatticeSpace::reverse(move));
      if (other < 0) continue;
      const int kind = space_.arc_kind(direction > 0 ? pose : other, move);
      if (kind < 0) continue;
      const std::vector<int>& instants = space_.instants(kind);
      if (std::all_of(instants.begin(), instants.end(), [&](int instant) {
            return bounds_.bound(instant, placement) >= workshop_.options.min_stability;
          })) {
        return true;
      }
    }
    return false;
  }

  Workshop& workshop_;
  LatticeSpace& space_;
  LatticeBounds& bounds_;
  planning::Clock& clock_;
  Statistics& statistics_;
  LatticeAstar astar_;
  std::vector<Reach> reaches_;  // ascending
  Route route_;
};

}  // namespace

Route search_placements(Workshop& workshop, LatticeSpace& space, LatticeBounds& bounds,
                        LatticeDistances& distances, planning::Clock& clock,
                        Statistics& statistics) {
  return PlacementSearch(workshop, space, bounds, distances, clock, statistics).run();
}

}  // namespace graspless::fingertip
