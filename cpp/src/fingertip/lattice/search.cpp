// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Section 4 turned round for lattices: placements first, poses second, stabilities last; without
// regrasps first, then with them: to the end in small graphs, greedily in large ones.
#include "fingertip/lattice/search.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "graspless/watch.hpp"

#include "fingertip/search/graph_search.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kSmallGraph = 3e5;         // nodes that are searched to the end
constexpr std::size_t kMaxNodes = 2000000;  // of a larger one
constexpr double kGreedOfRegrasps = 2.5;

/// A location, and the least displacement of its sphere [m].
struct Reach {
  double distance;
  int location;
  bool operator<(const Reach& other) const {
    return distance < other.distance || (distance == other.distance && location < other.location);
  }
};

/// The cheapest route without regrasps over all placements: by ascending lower bound, until that
/// reaches the best cost.
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

  /// The best route so far.
  const Route& route() const { return route_; }

  void run() {
    const int count = graph_.num_fingers;
    // All placements whose farthest sphere is this one have the same bound.
    for (std::size_t last = 0; last < reaches_.size(); ++last) {
      if (reaches_[last].distance >= route_.cost) break;
      if (!extend(with(kNoFingers, reaches_[last].location), last, count - 1)) {
        route_.lower_bound = std::min(route_.cost, reaches_[last].distance);
        return;
      }
    }
    route_.is_complete = !clock_.is_out();
    if (route_.is_complete) route_.lower_bound = route_.cost;
  }

 private:
  /// Adds `missing` fingers on locations before `last`; false when time is up.
  bool extend(const Placement& placement, std::size_t last, int missing) {
    if (missing == 0) {
      if (clock_.is_out() || !clock_.spend()) return false;
      examine(placement);
      return true;
    }
    for (std::size_t i = 0; i < last; ++i) {
      poll();
      const int location = reaches_[i].location;
      if (!has_room(graph_, graph_.start(), placement, location)) continue;
      if (!extend(with(placement, location), i, missing - 1)) return false;
    }
    return true;
  }

  void examine(const Placement& placement) {
    if (!has_arc(placement, graph_.start(), true) || !has_arc(placement, graph_.goal(), false)) {
      return;
    }
    PlacementCosts costs(graph_, bounds_, placement);
    const PosePath path = pose_search_.find(costs, route_.cost, clock_, statistics_);
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

/// Costs of arcs by bounds of stability, for all placements that a search meets.
class LazyArcCosts : public ArcCosts {
 public:
  LazyArcCosts(const PoseGraph& graph, LatticeBounds& bounds) : graph_(graph), bounds_(bounds) {}

  double cost(int pose, int move, const Placement& placement) override {
    return costs(placement).cost(pose, move);
  }
  double settle(int pose, int move, const Placement& placement) override {
    return costs(placement).solve(pose, move);
  }

 private:
  PlacementCosts& costs(const Placement& placement) {
    if (last_ == nullptr || last_->placement() != placement) {
      last_ = &all_.try_emplace(placement, graph_, bounds_, placement).first->second;
    }
    return *last_;
  }

  const PoseGraph& graph_;
  LatticeBounds& bounds_;
  std::map<Placement, PlacementCosts> all_;
  PlacementCosts* last_ = nullptr;
};

/// Number of nodes at most, hubs aside.
double num_nodes(const PoseGraph& graph) {
  double nodes = graph.num_poses();
  for (int i = 0; i < graph.num_fingers; ++i) nodes *= (graph.locations.size() - i) / (i + 1.0);
  return nodes;
}

/// Least displacement of any sphere: some finger goes all the way if there is but one regrasp.
double least_displacement(const PoseGraph& graph, RemainingDistance& remaining) {
  double least = std::numeric_limits<double>::infinity();
  for (int l = 0; l < graph.locations.size(); ++l) {
    least = std::min(least, remaining.to_goal(l)[graph.start()]);
  }
  return least;
}

/// A greedy search finds some route; a regrasp counts as much as part of the displacement, first
/// less and then more. The cost is not proven optimal then.
Route search_greedily(const PoseGraph& graph, Evaluator& evaluator, GraphSearch settings,
                      planning::Clock& clock, Statistics& statistics) {
  const Options& options = graph.options;
  const double least = least_displacement(graph, *settings.remaining);
  settings.greed = kGreedOfRegrasps;
  Route best;
  best.cost = std::numeric_limits<double>::infinity();
  for (const double share : {0.1, 1.0}) {
    settings.regrasp_cost = std::min(options.regrasp_cost, share * least);
    const Route route = search_graph(graph, evaluator, settings, clock, statistics);
    if (route.is_complete && !route.found) return route;  // there is none
    if (!route.found) break;
    if (num_regrasps(route) <= options.max_regrasps && route.cost < best.cost) best = route;
    if (best.found && num_regrasps(best) <= 1) break;
  }
  // Without regrasps all is known; with one, one finger at least goes all the way.
  const double displacement = graph.num_fingers > 1 ? least : 0;
  best.lower_bound =
      std::min(best.cost, options.regrasp_cost + std::min(displacement, options.regrasp_cost));
  best.is_complete = false;
  return best;
}

/// Routes with regrasps, if there are none without, or only dear ones; lower_bound holds for routes
/// with regrasps.
Route search_regrasps(const PoseGraph& graph, Evaluator& evaluator, LatticeBounds& bounds,
                      RemainingDistance& remaining, planning::Clock& clock,
                      Statistics& statistics) {
  LazyArcCosts costs(graph, bounds);
  GraphSearch settings;
  settings.lazy = &costs;
  settings.remaining = &remaining;
  settings.max_nodes = kMaxNodes;
  if (num_nodes(graph) <= kSmallGraph) {
    return search_graph(graph, evaluator, settings, clock, statistics);
  }
  return search_greedily(graph, evaluator, settings, clock, statistics);
}

/// The cheaper one of a route without regrasps and of those with some.
Route with_regrasps(const PoseGraph& graph, Evaluator& evaluator, LatticeBounds& bounds,
                    RemainingDistance& remaining, Route route, planning::Clock& clock,
                    Statistics& statistics) {
  const double X_regr = graph.options.regrasp_cost;
  if (graph.options.max_regrasps == 0 || (route.found && route.cost <= X_regr)) return route;
  if (!route.is_complete) {
    route.lower_bound = std::min(route.lower_bound, X_regr);
    return route;
  }
  if (!route.found) return search_regrasps(graph, evaluator, bounds, remaining, clock, statistics);
  RemainingDistance whole(graph);  // the tables so far leave out what costs more than the route
  Route other = search_regrasps(graph, evaluator, bounds, whole, clock, statistics);
  Route& best = other.found && other.cost < route.cost ? other : route;
  best.lower_bound = std::min(route.cost, other.lower_bound);
  best.is_complete = other.is_complete;
  return best;
}

}  // namespace

Route search_lattice(const PoseGraph& graph, Evaluator& evaluator, planning::Clock& clock,
                     Statistics& statistics) {
  LatticeBounds bounds(graph, evaluator);
  RemainingDistance remaining(graph);
  PlacementSearch placements(graph, bounds, remaining, clock, statistics);
  clock.run([&] { placements.run(); });
  Route route = placements.route();
  const auto regrasp = [&] {
    route = with_regrasps(graph, evaluator, bounds, remaining, route, clock, statistics);
  };
  if (!clock.run(regrasp)) {
    route.is_complete = false;
    route.lower_bound = std::min(route.lower_bound, graph.options.regrasp_cost);
  }
  statistics.supports += bounds.count();
  statistics.memory =
      std::max(statistics.memory, graph.memory() + bounds.memory() + remaining.memory());
  return route;
}

}  // namespace graspless::fingertip
