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
#include <queue>

namespace graspless::fingertip {
namespace {

struct Open {
  double f, g;
  std::uint64_t code;
  // Of equal f the node farther on, which ends the search sooner; of those the older code, so that
  // runs repeat.
  bool operator<(const Open& other) const {
    if (f != other.f) return f > other.f;
    if (g != other.g) return g < other.g;
    return code > other.code;
  }
};

/// Calls visit(placement) for every feasible placement at a pose that holds `kept`.
template <typename Visit>
void for_each_placement(const PathQuery& query, int pose, const Placement& kept, int first,
                        int missing, Visit visit) {
  if (missing == 0) return visit(kept);
  const auto is_free = [&](int location) {
    if (!query.is_clear(pose, location)) return false;
    for (int i = 0; i < num_fingers(kept); ++i) {
      const int other = kept[static_cast<std::size_t>(i)];
      if (other == location || !query.locations.are_apart(other, location)) return false;
    }
    return true;
  };
  for (int location = first; location < query.locations.size(); ++location) {
    if (!is_free(location)) continue;
    for_each_placement(query, pose, with(kept, location), location + 1, missing - 1, visit);
  }
}

class GraphSearch {
 public:
  GraphSearch(const PathQuery& query, Evaluator& evaluator, int num_fingers, int num_layers,
              bool heuristic)
      : query_(query),
        evaluator_(evaluator),
        num_fingers_(num_fingers),
        num_layers_(num_layers),
        code_(query.num_poses(), query.locations.size(), num_fingers, std::max(1, num_layers)),
        h_(query, heuristic) {}

  Route run(planning::Clock& clock, double limit) {
    const int goal = query_.num_arcs();
    Route route;
    open_start();  // 4.2: the virtual start node
    while (!open_.empty()) {
      route.lower_bound = std::max(route.lower_bound, open_.top().f);
      if (route.lower_bound >= limit) break;
      if (!clock.spend()) return route;
      const Open next = open_.top();
      open_.pop();
      if (next.g > table_.find(next.code).cost) continue;  // a cheaper way came later
      ++opened_;
      const Node node = code_.unpack(next.code, &layer_);
      const bool is_hub = fingertip::num_fingers(node.placement) < num_fingers_;
      if (is_hub) {
        set_down(node, next);
      } else if (node.pose == goal) {  // the virtual goal node
        return found(next);
      } else {
        displace(node, next);
        lift(node, next);
      }
    }
    route.is_complete = true;
    return route;
  }

  std::int64_t opened() const { return opened_; }
  std::int64_t memory() const {
    return static_cast<std::int64_t>(table_.memory() + most_open_ * sizeof(Open));
  }

 private:
  void open_start() {
    for_each_placement(query_, 0, kNoFingers, 0, num_fingers_, [&](const Placement& placement) {
      reach({0, placement}, 0, NodeTable::kNone, 0);
    });
  }

  void reach(const Node& node, int layer, std::uint64_t parent, double g) {
    const std::uint64_t code = code_.pack(node, layer);
    if (!table_.improve(code, parent, g)) return;
    open_.push({g + h_(node), g, code});
    most_open_ = std::max(most_open_, open_.size());
  }

  // Figure 5(a): the object moves on, the fingers stay; cost (9).
  void displace(const Node& node, const Open& from) {
    if (!is_feasible(query_, node.pose + 1, node.placement)) return;
    z_.clear();
    for (int j = 0; j < query_.options.samples_per_arc; ++j) {
      z_.push_back(evaluator_.stability(query_.instant(node.pose, j), node.placement));
      if (z_.back() == 0) return;  // z < z_min
    }
    const double cost = arc_cost(query_, node.pose, node.placement, z_.data());
    reach({node.pose + 1, node.placement}, layer_, from.code, from.g + cost);
  }

  // Figure 5(b), first half: a finger leaves; cost (10).
  void lift(const Node& node, const Open& from) {
    const int layer = num_layers_ == 0 ? 0 : layer_ + 1;
    if (num_layers_ > 0 && layer == num_layers_) return;
    for (int i = 0; i < num_fingers_; ++i) {
      const Placement kept = without(node.placement, node.placement[static_cast<std::size_t>(i)]);
      reach({node.pose, kept}, layer, from.code, from.g + query_.options.regrasp_cost);
    }
  }

  // Second half: z >= z_min of the object at rest without that finger, which then goes anywhere.
  void set_down(const Node& hub, const Open& from) {
    if (evaluator_.stability(query_.rest_instant(hub.pose), hub.placement) == 0) return;
    for (int location = 0; location < query_.locations.size(); ++location) {
      const Placement& kept = hub.placement;
      if (std::find(kept.begin(), kept.end(), location) != kept.end()) continue;
      const Node next{hub.pose, with(kept, location)};
      if (is_feasible(query_, next.pose, next.placement)) reach(next, layer_, from.code, from.g);
    }
  }

  Route found(const Open& last) {
    Route route;
    route.found = route.is_complete = true;
    route.cost = route.lower_bound = last.g;
    for (std::uint64_t code = last.code; code != NodeTable::kNone;
         code = table_.find(code).parent) {
      int layer = 0;
      const Node node = code_.unpack(code, &layer);
      if (fingertip::num_fingers(node.placement) == num_fingers_) route.nodes.push_back(node);
    }
    std::reverse(route.nodes.begin(), route.nodes.end());
    return route;
  }

  const PathQuery& query_;
  Evaluator& evaluator_;
  int num_fingers_, num_layers_;  // one layer a number of regrasps; 0: they are not counted
  NodeCode code_;
  Heuristic h_;
  NodeTable table_;
  std::priority_queue<Open> open_;
  std::vector<double> z_;
  int layer_ = 0;  // of the node being expanded
  std::int64_t opened_ = 0;
  std::size_t most_open_ = 0;
};

}  // namespace

Route search_graph(const PathQuery& query, Evaluator& evaluator, bool heuristic,
                   planning::Clock& clock, Statistics& statistics, double limit) {
  const auto search = [&](int num_layers) {
    GraphSearch graph(query, evaluator, query.num_fingers, num_layers, heuristic);
    Route route = graph.run(clock, limit);
    statistics.nodes += graph.opened();
    statistics.memory = std::max(statistics.memory, graph.memory());
    return route;
  };
  Route route = search(0);
  // Without counting regrasps the graph is smaller; count only where their number is too large.
  if (num_regrasps(route) <= query.options.max_regrasps) return route;
  return search(query.options.max_regrasps + 1);
}

}  // namespace graspless::fingertip
