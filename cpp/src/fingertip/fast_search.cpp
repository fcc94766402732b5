// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The search of Section 4 turned round: placements first, poses second, stabilities last.
#include "fingertip/fast_search.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <stdexcept>
#include <string>
#include <tuple>

namespace graspless::fingertip {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;    // of costs summed in another order
constexpr std::size_t kWatch = 4096;  // placements from one look at the memory to the next
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
    while (!frontier_.empty() && frontier_.top().cost < search_.limit) {
      if (search_.clock.is_out() || !search_.clock.spend()) return give_up();
      if (gather(questions)) return finished_;
      search_.solve(questions);
      for (const Entry& entry : waiting_) push_again(entry);
    }
    Route none;
    none.is_complete = true;
    none.lower_bound = frontier_.empty() ? kInfinity : search_.limit;
    return none;
  }

 private:
  void push(const Entry& entry) {
    if (entry.cost < kInfinity) frontier_.push(entry);
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
                         if (++search_.unopened % kWatch == 0) search_.watch_memory();
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
    for (int c = 0; c < search_.candidates.size(); ++c) search_.hubs.add(c);
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
    waiting_.clear();
    while (questions.size() < kBatch && !frontier_.empty()) {
      const Entry entry = frontier_.top();
      if (entry.cost >= search_.limit) break;
      if (is_stage(entry) && !questions.empty()) break;
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
        if (waiting_.empty()) return finish(entry);
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
    finished_.nodes = nodes(entry);
    return true;
  }

  std::vector<Node> nodes(const Entry& entry) {
    std::vector<Node> nodes;
    const int K = search_.query.num_arcs();
    int first = entry.index, second = entry.index, change = K;
    if (entry.kind == Entry::Kind::hub) {
      const Hubs::Regrasp regrasp = search_.hubs.best(entry.index, entry.pose);
      first = regrasp.before;
      second = regrasp.after;
      change = entry.pose;
    }
    for (int q = 0; q <= change; ++q) nodes.push_back({q, search_.candidates.placement(first)});
    if (second == first) change = change < K ? change + 1 : K + 1;
    if (entry.kind == Entry::Kind::direct) return nodes;
    for (int q = change; q <= K; ++q) nodes.push_back({q, search_.candidates.placement(second)});
    return nodes;
  }

  Route give_up() {
    Route route;
    route.lower_bound = frontier_.empty() ? kInfinity : frontier_.top().cost;
    return route;
  }

  FastSearch& search_;
  std::priority_queue<Entry> frontier_;
  std::vector<Placement> unopened_;
  std::vector<double> ways_;  // of each location, all the way [m]
  std::vector<Entry> waiting_;
  Route finished_;
};

}  // namespace

FastSearch::FastSearch(const PathQuery& query_in, std::vector<Evaluator>& evaluators,
                       planning::Clock& clock_in, Statistics& statistics_in, double limit_in)
    : query(query_in),
      count(query_in.num_fingers),
      clock(clock_in),
      statistics(statistics_in),
      supports(query_in, evaluators.front().instants()),
      candidates(query_in, supports),
      hubs(query_in, supports, candidates),
      lanes(evaluators, query_in.options.threads),
      limit(limit_in) {
  for (int arc = 0; arc < query.num_arcs(); ++arc) {
    double least = kInfinity;
    for (const int location : clear_locations(query, arc, arc + 1)) {
      least = std::min(least, query.displacement(arc, location));
    }
    least_displacement += least * query.options.samples_per_arc;
  }
}

void FastSearch::solve(std::vector<Question>& questions) {
  lanes.solve(questions);
  for (const Question& question : questions) {
    supports.add(question.instant, question.supports, question.placement);
    question.of == Question::Of::candidate ? candidates.learn(question) : hubs.learn(question);
  }
}

void FastSearch::watch_memory(std::int64_t more_candidates) {
  constexpr std::int64_t kUnopened = 64;  // bytes of a placement in the frontier, and of its growth
  const std::int64_t bytes = supports.memory() + candidates.memory() + unopened * kUnopened +
                             more_candidates * Candidates::bytes_each(query);
  statistics.memory = std::max(statistics.memory, bytes);
  if (static_cast<double>(bytes) > query.options.max_memory) {
    throw std::length_error("options.max_memory: the search needs more than " +
                            std::to_string(query.options.max_memory) +
                            " bytes for placements that may be stable; take fewer locations");
  }
}

void open_all(FastSearch& search, const std::vector<int>& locations,
              const std::vector<int>& instants) {
  std::vector<Placement> found;
  for_each_placement(search.query, search.supports, search.count, locations, instants,
                     [&](const Placement& placement) {
                       found.push_back(placement);
                       if (found.size() % kWatch == 0) {
                         search.watch_memory(static_cast<std::int64_t>(found.size()));
                       }
                       return true;
                     });
  search.watch_memory(static_cast<std::int64_t>(found.size()));
  search.candidates.reserve(found.size());
  for (const Placement& placement : found) search.candidates.open(placement);
}

std::vector<int> clear_locations(const PathQuery& query, int first, int last) {
  std::vector<int> clear;
  for (int location = 0; location < query.locations.size(); ++location) {
    bool is_clear = true;
    for (int pose = first; pose <= last && is_clear; ++pose) {
      is_clear = query.is_clear(pose, location);
    }
    if (is_clear) clear.push_back(location);
  }
  return clear;
}

Route search_fast(const PathQuery& query, std::vector<Evaluator>& evaluators,
                  planning::Clock& clock, Statistics& statistics, double limit) {
  FastSearch search(query, evaluators, clock, statistics, limit);
  const Route route = BestFirst(search).run();
  search.watch_memory();
  statistics.supports += search.supports.count();
  statistics.nodes += search.candidates.size();
  return route;
}

}  // namespace graspless::fingertip
