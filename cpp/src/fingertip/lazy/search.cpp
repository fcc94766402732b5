// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Section 4 turned round for paths: placements first, poses second, stabilities last.
//
// An entry of the frontier stands for a route, or for many. Its cost is a lower bound: (9) with an
// upper bound in place of each stability z_j that is not solved yet, and (10). The cheapest entry
// is refined until nothing about it is open; then its cost is exact and no route is cheaper.
// search_fast() is at the end.
#include "fingertip/lazy/search.hpp"

#include <algorithm>
#include <optional>
#include <queue>
#include <tuple>

#include "graspless/watch.hpp"

#include "fingertip/lazy/growing.hpp"
#include "fingertip/lazy/listing.hpp"
#include "fingertip/lazy/state.hpp"

namespace graspless::fingertip {
namespace {

constexpr std::size_t kWaiting = 16;  // entries that wait for stabilities
constexpr std::size_t kBatch = 4;     // stabilities requested together
constexpr std::size_t kHubs = 64;     // hubs whose members are compared together

struct Entry {
  enum class Kind {
    candidate,     // one placement all the way
    placement,     // the same before it is a candidate, by its displacement
    hub,           // all routes with one regrasp, at this pose with these fingers kept
    placements,    // all placements that are not listed yet
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
  bool is_stage() const { return kind >= Kind::placements; }
};

/// Entries by ascending cost, and those that wait for stabilities.
class Frontier {
 public:
  explicit Frontier(LazyState& lazy) : lazy_(lazy) {}

  /// False if the entries that wait must be solved first, or no entry is below the limit.
  bool has_next() const {
    if (waiting_.size() >= kWaiting || queue_.empty()) return false;
    const bool has_waiting = !waiting_.empty() || !last_waiting_.empty();
    return queue_.top().cost < lazy_.limit && !(queue_.top().is_stage() && has_waiting);
  }
  Entry pop() {
    const Entry entry = queue_.top();
    queue_.pop();
    return entry;
  }
  void push_again(Entry entry) {
    entry.cost = cost(entry);
    push(entry);
  }
  void wait(const Entry& entry) { waiting_.push_back(entry); }

  /// Takes back the entries whose stabilities have been solved, two rounds after their request.
  void take_back() {
    lazy_.record_last();
    for (const Entry& entry : last_waiting_) push_again(entry);
    last_waiting_.swap(waiting_);
    waiting_.clear();
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

  /// Enters all placements, unless a regrasp is needed, and all routes with regrasps.
  void begin(bool needs_regrasp) {
    if (!needs_regrasp) push({lazy_.displacements.least_whole(), Entry::Kind::placements});
    if (lazy_.graph.options.max_regrasps >= 1) {
      push({least_with_regrasps(), Entry::Kind::one_regrasp});
    }
  }

  /// Lists some of the placements that can carry the object all the way.
  void list_placements() {
    if (!listing_) listing_.emplace(lazy_);
    if (listing_->begins_anew()) first_placement_ = static_cast<int>(placements_.size());
    listing_->next([&](const Placement& placement, double cost) {
      push({cost, Entry::Kind::placement, static_cast<int>(placements_.size())});
      placements_.push_back(placement);
      if (++lazy_.unopened % LazyState::kWatch == 0) lazy_.watch_memory();
    });
    push({listing_->least_cost(), Entry::Kind::placements});
  }

  void open(Entry entry) {
    if (entry.index < first_placement_) return;
    const Placement& placement = placements_[entry.index];
    const double now = listing_->cost(placement);
    if (now > entry.cost) {
      entry.cost = now;
      push(entry);
    } else {
      push_again({0, Entry::Kind::candidate, lazy_.candidates.enter(placement)});
    }
  }

  /// Lists placements that can carry the object from the start, or to the goal, at their hubs.
  void list_hubs() {
    const int K = lazy_.graph.num_arcs();
    link_ends(lazy_);
    for (int pose = 1; pose < K; ++pose) {
      for (int hub = 0; hub < lazy_.hubs.size(); ++hub) {
        poll();
        push({lazy_.hubs.bound(hub, pose), Entry::Kind::hub, hub, pose});
      }
    }
    const Options& options = lazy_.graph.options;
    if (options.max_regrasps >= 2) {
      push({lazy_.displacements.least() + 2 * options.regrasp_cost, Entry::Kind::more_regrasps});
    }
  }

  bool is_untouched(const Entry& entry) const {
    return entry.kind == Entry::Kind::hub && lazy_.hubs.is_untouched(entry.index, entry.pose);
  }

  /// Compares the members of the next untouched hubs together, and enters these again.
  void compare(const Entry& first) {
    std::vector<HubPose> together{{first.index, first.pose}};
    for (; together.size() < kHubs && !queue_.empty() && is_untouched(queue_.top()); queue_.pop()) {
      together.push_back({queue_.top().index, queue_.top().pose});
    }
    lazy_.hubs.compare(together, lazy_.crew);
    for (const auto& [hub, pose] : together) {
      push({lazy_.hubs.bound(hub, pose), Entry::Kind::hub, hub, pose});
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

  Route route_of(const Entry& entry) const {
    Route route;
    route.found = route.is_complete = true;
    route.cost = route.lower_bound = entry.cost;
    if (entry.kind == Entry::Kind::candidate) {
      route.nodes = nodes_of(lazy_, entry.index, entry.index, lazy_.graph.num_arcs());
    } else {
      const Hubs::Regrasp regrasp = lazy_.hubs.best(entry.index, entry.pose);
      route.nodes = nodes_of(lazy_, regrasp.before, regrasp.after, entry.pose);
    }
    return route;
  }

 private:
  void push(const Entry& entry) {
    if (entry.cost < kInfinity) queue_.push(entry);
  }

  /// With one regrasp, all fingers but one stay all the way.
  double least_with_regrasps() const {
    const Displacements& displacements = lazy_.displacements;
    const Options& options = lazy_.graph.options;
    const double pieces = displacements.least();
    const double kept = lazy_.count > 1 ? displacements.least_whole() : pieces;
    const double one = kept + options.regrasp_cost;
    return options.max_regrasps >= 2 ? std::min(one, pieces + 2 * options.regrasp_cost) : one;
  }

  LazyState& lazy_;
  std::optional<Listing> listing_;
  std::priority_queue<Entry, Growing<Entry>> queue_;
  Growing<Placement> placements_;
  int first_placement_ = 0;                    // those before have been listed again
  std::vector<Entry> waiting_, last_waiting_;  // for stabilities, of this round and the last
};

/// The cheapest route that happens to be solved when time is out, if any.
Route unfinished(LazyState& lazy, double lower_bound) {
  Route route = best_solved(lazy);
  route.lower_bound = route.found ? std::min(lower_bound, route.cost) : lower_bound;
  return route;
}

/// Refines the cheapest entries, and collects the stabilities that this takes. Returns the optimum
/// once the cheapest entry is exact.
std::optional<Route> refine(LazyState& lazy, Frontier& frontier,
                            std::vector<StabilityQuery>& queries) {
  queries.clear();
  while (queries.size() < kBatch && frontier.has_next()) {
    poll();
    const Entry entry = frontier.pop();
    if (entry.kind == Entry::Kind::placements) {
      frontier.list_placements();  // Figure 5(a): cost (9)
    } else if (entry.kind == Entry::Kind::placement) {
      frontier.open(entry);  // bounded by its displacement all the way; now arc by arc
    } else if (entry.kind == Entry::Kind::one_regrasp) {
      frontier.list_hubs();  // Figure 5(b), cost (10): no route without regrasps is cheaper
    } else if (entry.kind == Entry::Kind::more_regrasps) {
      return search_many_regrasps(lazy);  // nor one with one
    } else if (frontier.is_untouched(entry)) {
      frontier.compare(entry);
    } else if (frontier.tighten(entry) || frontier.cost(entry) > entry.cost) {
      frontier.push_again(entry);  // by functionals that other placements have left behind: no LP
    } else if (frontier.request(entry, queries)) {
      frontier.wait(entry);  // for its most critical samples: LPs (5) and (6)
    } else if (frontier.least_cost() >= entry.cost) {
      return frontier.route_of(entry);  // all is solved, and nothing that waits is cheaper
    } else {
      frontier.wait(entry);
      break;
    }
  }
  return std::nullopt;
}

/// Best-first search. Other threads solve the stabilities of one round while the next is prepared.
Route search(LazyState& lazy, bool needs_regrasp) {
  Frontier frontier(lazy);
  frontier.begin(needs_regrasp);
  std::vector<StabilityQuery> queries;
  std::optional<Route> best = refine(lazy, frontier, queries);
  while (!best && frontier.least_cost() < lazy.limit) {
    if (lazy.clock.is_out() || !lazy.clock.spend()) return unfinished(lazy, frontier.least_cost());
    lazy.start(queries);
    frontier.take_back();  // with bounds from the stabilities of the last round
    best = refine(lazy, frontier, queries);
    lazy.finish();
  }
  if (best) return best->is_complete ? *best : unfinished(lazy, best->lower_bound);
  Route none;  // below the limit
  none.is_complete = true;
  none.lower_bound = frontier.least_cost() < kInfinity ? lazy.limit : kInfinity;
  return none;
}

}  // namespace

Route search_fast(const PoseGraph& graph, std::vector<Evaluator>& evaluators,
                  planning::Clock& clock, Statistics& statistics, double limit,
                  bool needs_regrasp) {
  LazyState lazy(graph, evaluators, clock, statistics, limit);
  Route route;
  if (!clock.run([&] { route = search(lazy, needs_regrasp); })) {
    lazy.cancel();
    route = unfinished(lazy, lazy.displacements.least());
  }
  lazy.note_memory();
  share_stabilities(graph, route, evaluators);
  statistics.supports += lazy.bounds.count();
  statistics.placements += lazy.candidates.size();
  return route;
}

}  // namespace graspless::fingertip
