// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Section 4 turned round for paths: placements first, poses second, stabilities last.
//
// An entry of the queue stands for a route, or for many. Its cost is a lower bound: (9) with an
// upper bound in place of each stability z_j that is not solved yet, and (10). The cheapest entry
// is refined until nothing about it is open; then its cost is exact and no route is cheaper.
#include "fingertip/lazy/search.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

#include "fingertip/lazy/state.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kRounding = 1e-9;    // of costs summed in another order
constexpr std::size_t kWaiting = 16;  // entries that wait for stabilities
constexpr std::size_t kBatch = 4;     // stabilities requested together

struct Entry {
  enum class Kind {
    candidate,     // one placement all the way
    placement,     // the same before it is a candidate, by its displacement
    hub,           // all routes with one regrasp, at this pose with these fingers kept
    one_regrasp,   // all routes with one regrasp
    more_regrasps  // all other routes
  };
  double cost;
  Kind kind;
  int index = -1;                             // of the candidate, placement or hub
  int pose = -1;                              // of the hub
  bool operator<(const Entry& other) const {  // the top of a std heap is its greatest
    return std::tie(other.cost, other.kind, other.index, other.pose) <
           std::tie(cost, kind, index, pose);
  }
  bool is_stage() const { return kind >= Kind::one_regrasp; }
};

class LazySearch {
 public:
  explicit LazySearch(LazyState& lazy)
      : lazy_(lazy),
        X_regr_(lazy.graph.options.regrasp_cost),
        max_regrasps_(lazy.graph.options.max_regrasps) {}

  Route run() {
    list_placements();         // Figure 5(a): cost (9)
    if (max_regrasps_ >= 1) {  // Figure 5(b): cost (10)
      push({lazy_.least_displacement + X_regr_, Entry::Kind::one_regrasp});
    }
    std::vector<StabilityQuery> queries;
    bool is_finished = refine(queries);
    while (!is_finished && least_cost() < lazy_.limit) {
      if (lazy_.clock.is_out() || !lazy_.clock.spend()) return unfinished(least_cost());
      lazy_.start(queries);  // Problem (6), in other threads
      lazy_.record_last();   // meanwhile bounds from the last
      for (const Entry& entry : last_waiting_) push_again(entry);
      last_waiting_.swap(waiting_);
      waiting_.clear();
      is_finished = refine(queries);
      lazy_.finish();
    }
    if (!is_finished) return none();
    return route_.is_complete ? route_ : unfinished(route_.lower_bound);
  }

 private:
  /// Refines the cheapest entries, and collects the stabilities that this takes. True if the
  /// cheapest entry is exact: route_ is the optimum.
  bool refine(std::vector<StabilityQuery>& queries) {
    queries.clear();
    while (queries.size() < kBatch && waiting_.size() < kWaiting && !queue_.empty()) {
      const Entry entry = queue_.top();
      if (entry.cost >= lazy_.limit) break;
      if (entry.is_stage() && !(waiting_.empty() && last_waiting_.empty())) break;
      queue_.pop();
      if (entry.kind == Entry::Kind::one_regrasp) {
        list_hubs();  // now that no route without regrasps can be cheaper
      } else if (entry.kind == Entry::Kind::more_regrasps) {
        route_ = search_many_regrasps(lazy_, max_regrasps_);
        return true;
      } else if (entry.kind == Entry::Kind::placement) {
        open(entry);
      } else if (tighten(entry) || cost(entry) > entry.cost) {
        push_again(entry);  // by functionals that other placements have left behind: no LP
      } else if (request(entry, queries)) {
        waiting_.push_back(entry);  // its most critical samples are solved: LPs (5) and (6)
      } else if (least_cost() >= entry.cost) {
        return finish(entry);  // all is solved, and nothing that waits can be cheaper
      } else {
        waiting_.push_back(entry);
        break;
      }
    }
    return false;
  }

  void push(const Entry& entry) {
    if (entry.cost < kInfinity) queue_.push(entry);
  }
  void push_again(Entry entry) {
    entry.cost = cost(entry);
    push(entry);
  }

  /// Least cost of the queue and of the entries that wait for stabilities.
  double least_cost() const {
    double least = queue_.empty() ? kInfinity : queue_.top().cost;
    for (const auto* waiting : {&waiting_, &last_waiting_}) {
      for (const Entry& entry : *waiting) least = std::min(least, entry.cost);
    }
    return least;
  }

  double cost(const Entry& entry) {
    switch (entry.kind) {
      case Entry::Kind::candidate:
        return lazy_.candidates.after(entry.index, 0);
      case Entry::Kind::hub:
        return lazy_.hubs.best(entry.index, entry.pose).cost;
      default:
        return entry.cost;
    }
  }

  /// Lists placements that can carry the object all the way, as far as a few instants tell.
  void list_placements() {
    const std::vector<int> locations = clear_locations(lazy_.graph, 0, lazy_.graph.num_arcs());
    const std::vector<int>& all = lazy_.candidates.instants();
    std::vector<int> instants = {all.front(), all.back(), all[all.size() / 2]};
    if (all.size() < instants.size()) instants = all;
    seed_bounds(lazy_, locations, instants);
    sum_displacements();
    std::vector<Entry> entries;
    for_each_placement(lazy_.graph, lazy_.bounds, lazy_.count, locations, instants,
                       [&](const Placement& placement) {
                         entries.push_back({least_cost_of(placement), Entry::Kind::placement,
                                            static_cast<int>(placements_.size())});
                         placements_.push_back(placement);
                         if (++lazy_.unopened % LazyState::kWatch == 0) lazy_.watch_memory();
                         return true;
                       });
    queue_ = std::priority_queue<Entry>(std::less<Entry>(), std::move(entries));
  }

  void sum_displacements() {
    displacements_.assign(static_cast<std::size_t>(lazy_.graph.locations.size()), 0.0);
    for (int arc = 0; arc < lazy_.graph.num_arcs(); ++arc) {
      for (int l = 0; l < lazy_.graph.locations.size(); ++l) {
        displacements_[static_cast<std::size_t>(l)] +=
            lazy_.graph.displacement(arc, l) * lazy_.graph.options.samples_per_arc;
      }
    }
  }

  /// A placement's least cost all the way, without a look at each arc.
  double least_cost_of(const Placement& placement) const {
    double longest = 0;
    for (int i = 0; i < lazy_.count; ++i) {
      const std::int32_t location = placement[static_cast<std::size_t>(i)];
      longest = std::max(longest, displacements_[static_cast<std::size_t>(location)]);
    }
    const std::vector<int>& instants = lazy_.candidates.instants();
    if (instants.size() == 1) {
      const auto z = static_cast<double>(lazy_.bounds.bound(instants.front(), placement));
      if (z < lazy_.graph.options.min_stability) return kInfinity;
      longest *= 1 + lazy_.graph.options.stability_weight / z;
    }
    return longest * (1 - kRounding);
  }

  void open(Entry entry) {
    const Placement& placement = placements_[static_cast<std::size_t>(entry.index)];
    const double now = least_cost_of(placement);
    if (now > entry.cost) {
      entry.cost = now;
      push(entry);
    } else {
      push_again({0, Entry::Kind::candidate, lazy_.candidates.open(placement)});
    }
  }

  /// Lists placements that can carry the object from the start, or to the goal, and their hubs.
  void list_hubs() {
    const int K = lazy_.graph.num_arcs();
    for (const int arc : {0, K - 1}) {
      const std::vector<int> locations = clear_locations(lazy_.graph, arc, arc + 1);
      seed_bounds(lazy_, locations, lazy_.candidates.instants(arc));
      open_all(lazy_, locations, lazy_.candidates.instants(arc));
    }
    lazy_.hubs.link();
    for (int pose = 1; pose < K; ++pose) {
      for (int hub = 0; hub < lazy_.hubs.size(); ++hub) {
        push_again({0, Entry::Kind::hub, hub, pose});
      }
    }
    if (max_regrasps_ >= 2) {
      push({lazy_.least_displacement + 2 * X_regr_, Entry::Kind::more_regrasps});
    }
  }

  /// Takes up new bounds of the entry's samples; true if they change its cost.
  bool tighten(const Entry& entry) {
    if (entry.kind == Entry::Kind::candidate) return lazy_.candidates.refresh(entry.index);
    const Hubs::Regrasp regrasp = lazy_.hubs.best(entry.index, entry.pose);
    if (regrasp.cost == kInfinity) return true;
    const bool before = lazy_.candidates.refresh(regrasp.before);
    return lazy_.candidates.refresh(regrasp.after) || before;
  }

  /// Requests stabilities that are open, at rest first; false if none is.
  bool request(const Entry& entry, std::vector<StabilityQuery>& queries) {
    const int K = lazy_.graph.num_arcs();
    if (entry.kind == Entry::Kind::candidate) {
      return lazy_.candidates.request(entry.index, 0, K, queries);
    }
    if (lazy_.hubs.request(entry.index, entry.pose, queries)) return true;
    const Hubs::Regrasp regrasp = lazy_.hubs.best(entry.index, entry.pose);
    const bool before = lazy_.candidates.request(regrasp.before, 0, entry.pose, queries);
    return lazy_.candidates.request(regrasp.after, entry.pose, K, queries) || before;
  }

  bool finish(const Entry& entry) {
    route_.found = route_.is_complete = true;
    route_.cost = route_.lower_bound = entry.cost;
    if (entry.kind == Entry::Kind::candidate) {
      route_.nodes = nodes_of(lazy_, entry.index, entry.index, lazy_.graph.num_arcs());
    } else {
      const Hubs::Regrasp regrasp = lazy_.hubs.best(entry.index, entry.pose);
      route_.nodes = nodes_of(lazy_, regrasp.before, regrasp.after, entry.pose);
    }
    return true;
  }

  /// There is no route below the limit.
  Route none() const {
    Route route;
    route.is_complete = true;
    route.lower_bound = least_cost() < kInfinity ? lazy_.limit : kInfinity;
    return route;
  }

  /// Out of time: the cheapest route that happens to be solved, if any.
  Route unfinished(double lower_bound) const {
    Route route = best_solved(lazy_);
    route.lower_bound = route.found ? std::min(lower_bound, route.cost) : lower_bound;
    return route;
  }

  LazyState& lazy_;
  const double X_regr_;
  const int max_regrasps_;
  std::priority_queue<Entry> queue_;
  std::vector<Placement> placements_;
  std::vector<double> displacements_;          // of each location, all the way [m]
  std::vector<Entry> waiting_, last_waiting_;  // for stabilities, of this round and the last
  Route route_;
};

/// Lets the first evaluator know what the others have found out about the route.
void share_stabilities(const PoseGraph& graph, const Route& route,
                       std::vector<Evaluator>& evaluators) {
  Evaluator& first = evaluators.front();
  for (std::size_t i = 1; i < route.nodes.size(); ++i) {
    const Node &from = route.nodes[i - 1], &to = route.nodes[i];
    for (std::size_t k = 1; k < evaluators.size(); ++k) {
      for (int f = 0; from.pose == to.pose && f < num_fingers(from.placement); ++f) {
        const Placement kept = without(from.placement, from.placement[static_cast<std::size_t>(f)]);
        first.adopt(evaluators[k], graph.rest_instant(to.pose), kept);
      }
      for (int j = 0; from.pose < to.pose && j < graph.options.samples_per_arc; ++j) {
        first.adopt(evaluators[k], graph.instant(from.pose, j), to.placement);
      }
    }
  }
}

}  // namespace

Route search_fast(const PoseGraph& graph, std::vector<Evaluator>& evaluators,
                  planning::Clock& clock, Statistics& statistics, double limit) {
  LazyState lazy(graph, evaluators, clock, statistics, limit);
  const Route route = LazySearch(lazy).run();
  lazy.note_memory();
  share_stabilities(graph, route, evaluators);
  statistics.supports += lazy.bounds.count();
  statistics.nodes += lazy.candidates.size();
  return route;
}

}  // namespace graspless::fingertip
