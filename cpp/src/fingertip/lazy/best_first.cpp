// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The search of Section 4 turned round: placements first, poses second, stabilities last.
#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>

#include "fingertip/lazy/search.hpp"

namespace graspless::fingertip {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;    // of costs summed in another order
constexpr std::size_t kWaiting = 16;  // routes that wait for answers
constexpr std::size_t kBatch = 4;     // questions asked together

/// A route, or many, by the least they can cost.
struct Entry {
  enum class Kind { direct, unopened, hub, one_regrasp, more_regrasps };
  double cost;
  Kind kind;
  int index = -1;  // of the candidate, of the unopened placement, of the hub
  int pose = -1;   // of the hub
  bool operator<(const Entry& other) const {  // the top of a std heap is its greatest
    return std::tie(other.cost, other.kind, other.index, other.pose) <
           std::tie(cost, kind, index, pose);
  }
};

/// Routes with at most one regrasp, cheapest first.
class BestFirst {
 public:
  explicit BestFirst(FastSearch& search) : search_(search) {}

  Route run() {
    list_direct();
    if (search_.query.options.max_regrasps >= 1) {
      push({search_.least_displacement + search_.query.options.regrasp_cost,
            Entry::Kind::one_regrasp});
    }
    std::vector<Question> questions;
    bool is_finished = gather(questions);
    while (!is_finished && least_cost() < search_.limit) {
      if (search_.clock.is_out() || !search_.clock.spend()) return give_up();
      search_.start(questions);
      search_.learn_last();
      for (const Entry& entry : last_waiting_) push_again(entry);
      last_waiting_.swap(waiting_);
      waiting_.clear();
      is_finished = gather(questions);
      search_.finish();
    }
    if (is_finished) return finished_;
    Route none;
    none.is_complete = true;
    none.lower_bound = least_cost() < kInfinity ? search_.limit : kInfinity;
    return none;
  }

 private:
  void push(const Entry& entry) {
    if (entry.cost < kInfinity) frontier_.push(entry);
  }

  // Of all that is left: the frontier, and what waits for answers.
  double least_cost() const {
    double least = frontier_.empty() ? kInfinity : frontier_.top().cost;
    for (const auto* waiting : {&waiting_, &last_waiting_}) {
      for (const Entry& entry : *waiting) least = std::min(least, entry.cost);
    }
    return least;
  }

  double cost(const Entry& entry) {
    switch (entry.kind) {
      case Entry::Kind::direct:
        return search_.candidates.after(entry.index, 0);
      case Entry::Kind::hub:
        return search_.hubs.best(entry.index, entry.pose).cost;
      default:
        return entry.cost;
    }
  }
  void push_again(Entry entry) {
    entry.cost = cost(entry);
    push(entry);
  }

  // Placements that can carry the object all the way.
  void list_direct() {
    const std::vector<int> locations = clear_locations(search_.query, 0, search_.query.num_arcs());
    const std::vector<int>& all = search_.candidates.instants();
    std::vector<int> instants = {all.front(), all.back(), all[all.size() / 2]};
    if (all.size() < instants.size()) instants = all;
    seed_supports(search_, locations, instants);
    measure_ways();
    std::vector<Entry> entries;
    for_each_placement(search_.query, search_.supports, search_.count, locations, instants,
                       [&](const Placement& placement) {
                         entries.push_back({way(placement), Entry::Kind::unopened,
                                            static_cast<int>(unopened_.size())});
                         unopened_.push_back(placement);
                         if (++search_.unopened % FastSearch::kWatch == 0) search_.watch_memory();
                         return true;
                       });
    frontier_ = std::priority_queue<Entry>(std::less<Entry>(), std::move(entries));
  }

  void measure_ways() {
    ways_.assign(static_cast<std::size_t>(search_.query.locations.size()), 0.0);
    for (int arc = 0; arc < search_.query.num_arcs(); ++arc) {
      for (int l = 0; l < search_.query.locations.size(); ++l) {
        ways_[static_cast<std::size_t>(l)] +=
            search_.query.displacement(arc, l) * search_.query.options.samples_per_arc;
      }
    }
  }

  // The least cost of a placement all the way, at a glance.
  double way(const Placement& placement) const {
    double longest = 0;
    for (int i = 0; i < search_.count; ++i) {
      const std::int32_t location = placement[static_cast<std::size_t>(i)];
      longest = std::max(longest, ways_[static_cast<std::size_t>(location)]);
    }
    const std::vector<int>& instants = search_.candidates.instants();
    if (instants.size() == 1) {
      const auto z = static_cast<double>(search_.supports.bound(instants.front(), placement));
      if (z < search_.query.options.min_stability) return kInfinity;
      longest *= 1 + search_.query.options.stability_weight / z;
    }
    return longest * (1 - kRounding);
  }

  // Placements that can carry the object from the start, or to the goal, and their hubs.
  void list_hubs() {
    const int K = search_.query.num_arcs();
    for (const int arc : {0, K - 1}) {
      const std::vector<int> locations = clear_locations(search_.query, arc, arc + 1);
      seed_supports(search_, locations, search_.candidates.instants(arc));
      open_all(search_, locations, search_.candidates.instants(arc));
    }
    search_.hubs.link();
    for (int pose = 1; pose < K; ++pose) {
      for (int hub = 0; hub < search_.hubs.size(); ++hub) {
        push_again({0, Entry::Kind::hub, hub, pose});
      }
    }
    if (search_.query.options.max_regrasps >= 2) {
      push({search_.least_displacement + 2 * search_.query.options.regrasp_cost,
            Entry::Kind::more_regrasps});
    }
  }

  // Collects what is open about the cheapest routes; true when the cheapest has nothing open.
  bool gather(std::vector<Question>& questions) {
    questions.clear();
    while (questions.size() < kBatch && waiting_.size() < kWaiting && !frontier_.empty()) {
      const Entry entry = frontier_.top();
      if (entry.cost >= search_.limit) break;
      if (is_stage(entry) && !(waiting_.empty() && last_waiting_.empty())) break;
      frontier_.pop();
      if (entry.kind == Entry::Kind::one_regrasp) {
        list_hubs();
      } else if (entry.kind == Entry::Kind::more_regrasps) {
        finished_ = search_layers(search_, search_.query.options.max_regrasps);
        return true;
      } else if (entry.kind == Entry::Kind::unopened) {
        open(entry);
      } else if (refresh(entry)) {
        push_again(entry);
      } else if (const double now = cost(entry); now > entry.cost) {
        push_again(entry);
      } else if (!ask(entry, questions)) {
        if (least_cost() >= entry.cost) return finish(entry);  // of those that wait for answers too
        waiting_.push_back(entry);
        break;
      } else {
        waiting_.push_back(entry);
      }
    }
    return false;
  }

  void open(Entry entry) {
    const Placement& placement = unopened_[static_cast<std::size_t>(entry.index)];
    const double now = way(placement);
    if (now > entry.cost) {
      entry.cost = now;
      push(entry);
    } else {
      push_again({0, Entry::Kind::direct, search_.candidates.open(placement)});
    }
  }

  static bool is_stage(const Entry& entry) {
    return entry.kind == Entry::Kind::one_regrasp || entry.kind == Entry::Kind::more_regrasps;
  }

  bool refresh(const Entry& entry) {
    if (entry.kind == Entry::Kind::direct) return search_.candidates.refresh(entry.index);
    const Hubs::Regrasp regrasp = search_.hubs.best(entry.index, entry.pose);
    if (regrasp.cost == kInfinity) return true;
    const bool before = search_.candidates.refresh(regrasp.before);
    return search_.candidates.refresh(regrasp.after) || before;
  }

  bool ask(const Entry& entry, std::vector<Question>& questions) {
    const int K = search_.query.num_arcs();
    if (entry.kind == Entry::Kind::direct) {
      return search_.candidates.ask(entry.index, 0, K, questions);
    }
    if (search_.hubs.ask(entry.index, entry.pose, questions)) return true;
    const Hubs::Regrasp regrasp = search_.hubs.best(entry.index, entry.pose);
    const bool before = search_.candidates.ask(regrasp.before, 0, entry.pose, questions);
    return search_.candidates.ask(regrasp.after, entry.pose, K, questions) || before;
  }

  bool finish(const Entry& entry) {
    finished_.found = finished_.is_complete = true;
    finished_.cost = finished_.lower_bound = entry.cost;
    if (entry.kind == Entry::Kind::direct) {
      finished_.nodes = nodes_of(search_, entry.index, entry.index, search_.query.num_arcs());
    } else {
      const Hubs::Regrasp regrasp = search_.hubs.best(entry.index, entry.pose);
      finished_.nodes = nodes_of(search_, regrasp.before, regrasp.after, entry.pose);
    }
    return true;
  }

  Route give_up() {
    Route route;
    route.lower_bound = least_cost();
    return route;
  }

  FastSearch& search_;
  std::priority_queue<Entry> frontier_;
  std::vector<Placement> unopened_;
  std::vector<double> ways_;                   // of each location, all the way [m]
  std::vector<Entry> waiting_, last_waiting_;  // for answers, of this round and the last
  Route finished_;
};

}  // namespace

Route search_best_first(FastSearch& search) { return BestFirst(search).run(); }

}  // namespace graspless::fingertip
