// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Section 4: the manipulation-feasibility graph, made while it is searched, uniformly (Dijkstra) or
// by A* with the heuristic (11).
//
// Arcs for regrasping run through hubs (pose, kept fingers). To lift a finger costs X_regr, to set
// it down anywhere costs nothing: as the arcs between all placements that share the kept fingers,
// but in number linear in the locations instead of square.
#include "fingertip/search/graph_search.hpp"

#include <algorithm>
#include <new>
#include <optional>
#include <queue>
#include <set>
#include <utility>

#include "graspless/watch.hpp"

#include "fingertip/search/nodes.hpp"

namespace graspless::fingertip {
namespace {

constexpr std::int64_t kWatch = 1024;  // nodes from one check of the memory to the next

using Hub = std::pair<int, Placement>;  // pose and kept fingers

struct Open {
  double f, g;
  std::uint64_t code;
  std::uint64_t parent;  // if g is a bound; else kNone, and the table knows
  // Ties in f go to the node with the larger cost so far, which ends the search sooner, then to the
  // lower code, so that runs repeat.
  bool operator<(const Open& other) const {
    if (f != other.f) return f > other.f;
    if (g != other.g) return g < other.g;
    return code > other.code;
  }
};

/// Calls visit(placement) for every feasible placement at a pose that holds `kept`.
template <typename Visit>
void for_each_feasible(const PoseGraph& graph, int pose, const Placement& kept, int first,
                       int missing, Visit visit) {
  poll();
  if (missing == 0) return visit(kept);
  for (int location = first; location < graph.locations.size(); ++location) {
    if (!has_room(graph, pose, kept, location)) continue;
    for_each_feasible(graph, pose, with(kept, location), location + 1, missing - 1, visit);
  }
}

int move_between(const PoseGraph& graph, int from, int to) {
  int move = 0;
  while (graph.next(from, move) != to) ++move;
  return move;
}

/// One run of A* or Dijkstra's algorithm.
class GraphSearchRun {
 public:
  GraphSearchRun(const PoseGraph& graph, Evaluator& evaluator, const GraphSearch& settings,
                 int num_layers, const std::set<Hub>& excluded)
      : graph_(graph),
        evaluator_(evaluator),
        settings_(settings),
        num_layers_(num_layers),
        excluded_(excluded),
        X_regr_(graph.options.regrasp_cost),
        code_(graph.num_poses(), graph.locations.size(), graph.num_fingers,
              std::max(1, num_layers)),
        h_(graph, *settings.remaining, settings.greed) {
    if (settings.regrasp_cost >= 0) X_regr_ = settings.regrasp_cost;
  }

  Route run(planning::Clock& clock) {
    Route route;
    open_start();  // 4.2: the virtual start node
    while (!open_.empty()) {
      route.lower_bound = std::max(route.lower_bound, open_.top().f);
      if (route.lower_bound >= settings_.limit) break;
      if (num_nodes_ >= settings_.max_nodes || !clock.spend()) return route;
      const Open next = open_.top();
      open_.pop();
      if (!is_settled(next)) continue;
      if (++num_nodes_ % kWatch == 0) watch_memory();
      const Node node = code_.unpack(next.code, &layer_);
      if (num_fingers(node.placement) < graph_.num_fingers) {
        set_down(node, next);
      } else if (node.pose == graph_.goal()) {  // the virtual goal node
        return found(next);
      } else {
        displace(node, next);
        lift(node, next);
      }
    }
    route.is_complete = true;
    return route;
  }

  std::size_t num_nodes() const { return num_nodes_; }
  std::int64_t memory() const {
    return static_cast<std::int64_t>(table_.memory() + most_open_ * sizeof(Open));
  }

 private:
  void open_start() {
    for_each_feasible(graph_, graph_.start(), kNoFingers, 0, graph_.num_fingers,
                      [&](const Placement& placement) {
                        reach({graph_.start(), placement}, 0, NodeTable::kNone, 0);
                      });
  }

  void reach(const Node& node, int layer, std::uint64_t parent, double g) {
    const double h = settings_.heuristic ? h_(node) : 0;
    if (h == kInfinity) return;
    const std::uint64_t code = code_.pack(node, layer);
    if (table_.improve(code, parent, g)) push({g + h, g, code, NodeTable::kNone});
  }

  /// The same with a lower bound of g.
  void reach_lazily(const Node& node, int layer, std::uint64_t parent, double g) {
    const double h = settings_.heuristic ? h_(node) : 0;
    if (h == kInfinity) return;
    const std::uint64_t code = code_.pack(node, layer);
    const NodeTable::Entry& known = table_.find(code);
    if (known.code == code && known.cost <= g) return;
    push({g + h, g, code, parent});
  }

  void push(const Open& open) {
    open_.push(open);
    most_open_ = std::max(most_open_, open_.size());
  }

  /// True if the entry's cost is exact, and the least known to its node.
  bool is_settled(const Open& entry) {
    if (entry.parent == NodeTable::kNone) return entry.g <= table_.find(entry.code).cost;
    int layer = 0;
    const Node parent = code_.unpack(entry.parent, &layer);
    const Node node = code_.unpack(entry.code, &layer);
    const int move = move_between(graph_, parent.pose, node.pose);
    const double g =
        table_.find(entry.parent).cost + settings_.lazy->settle(parent.pose, move, node.placement);
    if (g <= entry.g) return table_.improve(entry.code, entry.parent, g);
    if (g < kInfinity) reach(node, layer, entry.parent, g);
    return false;
  }

  // Figure 5(a): the object moves on, the fingers stay; cost (9).
  void displace(const Node& node, const Open& from) {
    for (int move = 0; move < graph_.num_moves(); ++move) {
      const Node next{graph_.next(node.pose, move), node.placement};
      if (next.pose < 0 || !is_feasible(graph_, next.pose, next.placement)) continue;
      const double cost = settings_.lazy != nullptr
                              ? settings_.lazy->cost(node.pose, move, node.placement)
                              : evaluate(node.pose, move, node.placement);
      if (cost == kInfinity) continue;
      settings_.lazy != nullptr ? reach_lazily(next, layer_, from.code, from.g + cost)
                                : reach(next, layer_, from.code, from.g + cost);
    }
  }

  double evaluate(int pose, int move, const Placement& placement) {
    const int kind = graph_.kind(pose, move);
    if (kind < 0 || !is_arc_clear(graph_, pose, move, placement)) return kInfinity;
    z_.clear();
    for (const int instant : graph_.instants(kind)) {
      z_.push_back(evaluator_.stability(instant, placement));
      if (z_.back() == 0) return kInfinity;  // z < z_min
    }
    return arc_cost(graph_, graph_.motion(pose, move), placement, z_);
  }

  // Figure 5(b), first half: a finger leaves; cost (10).
  void lift(const Node& node, const Open& from) {
    const int layer = num_layers_ == 0 ? 0 : layer_ + 1;
    if (num_layers_ > 0 && layer == num_layers_) return;
    for (int i = 0; i < graph_.num_fingers; ++i) {
      const Placement kept = without(node.placement, node.placement[i]);
      if (excluded_.count({node.pose, kept}) > 0) continue;
      reach({node.pose, kept}, layer, from.code, from.g + X_regr_);
    }
  }

  // Second half: z >= z_min of the object at rest without that finger, which then goes anywhere.
  void set_down(const Node& hub, const Open& from) {
    if (evaluator_.stability(graph_.rest_instant(hub.pose), hub.placement) == 0) return;
    for_each_feasible(graph_, hub.pose, hub.placement, 0, 1, [&](const Placement& placement) {
      reach({hub.pose, placement}, layer_, from.code, from.g);
    });
  }

  Route found(const Open& last) {
    Route route;
    route.found = route.is_complete = true;
    route.cost = last.g;
    for (std::uint64_t code = last.code; code != NodeTable::kNone;
         code = table_.find(code).parent) {
      int layer = 0;
      const Node node = code_.unpack(code, &layer);
      if (num_fingers(node.placement) == graph_.num_fingers) {
        route.nodes.push_back(node);
      } else if (X_regr_ != graph_.options.regrasp_cost) {
        route.cost += graph_.options.regrasp_cost - X_regr_;
      }
    }
    std::reverse(route.nodes.begin(), route.nodes.end());
    route.lower_bound = route.cost;
    return route;
  }

  void watch_memory() const {
    if (static_cast<double>(memory()) > graph_.options.max_memory) throw std::bad_alloc();
  }

  const PoseGraph& graph_;
  Evaluator& evaluator_;
  const GraphSearch& settings_;
  int num_layers_;  // one layer a number of regrasps; 0: they are not counted
  const std::set<Hub>& excluded_;
  double X_regr_;
  NodeCode code_;
  Heuristic h_;
  NodeTable table_;
  std::priority_queue<Open> open_;
  std::vector<double> z_;
  int layer_ = 0;  // of the node being expanded
  std::size_t num_nodes_ = 0, most_open_ = 0;
};

/// A regrasp of a route during which the object does not hold with friction cones along the motion
/// that goes on from there.
std::optional<Hub> unstable_regrasp(const PoseGraph& graph, Evaluator& evaluator,
                                    const Route& route) {
  for (std::size_t i = route.nodes.size(); i-- > 1;) {
    const Node &before = route.nodes[i - 1], &node = route.nodes[i];
    if (before.pose != node.pose) continue;
    const auto next = std::find_if(route.nodes.begin() + i, route.nodes.end(),
                                   [&](const Node& later) { return later.pose != node.pose; });
    if (next == route.nodes.end()) continue;
    Placement kept = before.placement;
    for (const std::int32_t finger : before.placement) {
      const auto& fingers = node.placement;
      if (std::find(fingers.begin(), fingers.end(), finger) == fingers.end()) {
        kept = without(kept, finger);
      }
    }
    const int rest = graph.rest_instant(node.pose, next->pose);
    if (evaluator.stability(rest, kept) == 0) return Hub(node.pose, kept);
  }
  return std::nullopt;
}

/// Repeats the search without the regrasps that turn out to be unstable.
Route search_stable(const PoseGraph& graph, Evaluator& evaluator, const GraphSearch& settings,
                    int num_layers, planning::Clock& clock, Statistics& statistics) {
  std::set<Hub> excluded;
  double lower_bound = kInfinity;  // before anything was excluded
  while (true) {
    GraphSearchRun run(graph, evaluator, settings, num_layers, excluded);
    Route route = run.run(clock);
    statistics.nodes += static_cast<std::int64_t>(run.num_nodes());
    statistics.memory = std::max(statistics.memory, run.memory());
    if (!excluded.empty()) {
      // A regrasp that fails before one motion might do before another.
      route.is_complete = false;
      route.lower_bound = std::min(route.lower_bound, lower_bound);
    }
    const auto unstable = unstable_regrasp(graph, evaluator, route);
    if (!unstable) return route;
    excluded.insert(*unstable);
    lower_bound = std::min(lower_bound, route.lower_bound);
  }
}

}  // namespace

Route search_graph(const PoseGraph& graph, Evaluator& evaluator, const GraphSearch& settings_in,
                   planning::Clock& clock, Statistics& statistics) {
  RemainingDistance remaining(graph);
  GraphSearch settings = settings_in;
  if (settings.remaining == nullptr) settings.remaining = &remaining;
  Route route = search_stable(graph, evaluator, settings, 0, clock, statistics);
  // Without counting regrasps the graph is smaller; count only where their number is too large.
  const int max_regrasps = graph.options.max_regrasps;
  if (settings.greed > 1 || num_regrasps(route) <= max_regrasps) return route;
  return search_stable(graph, evaluator, settings, max_regrasps + 1, clock, statistics);
}

}  // namespace graspless::fingertip
