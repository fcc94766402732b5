// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// State that all parts of the lazy search share.
#include "fingertip/lazy/state.hpp"

#include <algorithm>
#include <limits>
#include <new>

#include "graspless/watch.hpp"

namespace graspless::fingertip {

LazyState::LazyState(const PoseGraph& graph_in, std::vector<Evaluator>& evaluators,
                     planning::Clock& clock_in, Statistics& statistics_in, double limit_in)
    : graph(graph_in),
      count(graph_in.num_fingers),
      min_stability(static_cast<float>(graph_in.options.min_stability)),
      clock(clock_in),
      statistics(statistics_in),
      crew(graph_in.options.threads),
      bounds(graph_in, evaluators.front().instants()),
      displacements(graph_in),
      candidates(graph_in, bounds, displacements),
      hubs(graph_in, bounds, displacements, candidates),
      limit(limit_in),
      pool_(evaluators, crew) {}

void LazyState::record(const std::vector<StabilityQuery>& queries) {
  for (const StabilityQuery& query : queries) {
    bounds.add(query.instant, query.functionals, query.placement);
    query.of == StabilityQuery::Of::candidate ? candidates.record(query) : hubs.record(query);
  }
}

void LazyState::solve(std::vector<StabilityQuery>& queries) {
  pool_.start(queries);
  pool_.finish();
  record(queries);
}

void LazyState::start(std::vector<StabilityQuery>& queries) {
  in_flight_.swap(queries);
  if (!in_flight_.empty()) pool_.start(in_flight_);
}

void LazyState::record_last() {
  record(solved_);
  solved_.clear();
}

void LazyState::finish() {
  if (!in_flight_.empty()) pool_.finish();
  solved_.swap(in_flight_);
  in_flight_.clear();
}

void LazyState::cancel() {
  pool_.cancel();
  in_flight_.clear();
  solved_.clear();
}

std::int64_t LazyState::note_memory() {
  constexpr std::int64_t kUnopened = 64;  // bytes of a placement in the frontier, and of its growth
  const std::int64_t bytes =
      bounds.memory() + candidates.memory() + hubs.memory() + unopened * kUnopened;
  statistics.memory = std::max(statistics.memory, bytes);
  return bytes;
}

void LazyState::watch_memory() {
  if (static_cast<double>(note_memory()) > graph.options.max_memory) throw std::bad_alloc();
}

std::vector<Node> nodes_of(const LazyState& lazy, int first, int second, int pose) {
  std::vector<Node> nodes;
  for (int q = 0; q <= pose; ++q) nodes.push_back({q, lazy.candidates.placement(first)});
  for (int q = second == first ? pose + 1 : pose; q < lazy.graph.num_poses(); ++q) {
    nodes.push_back({q, lazy.candidates.placement(second)});
  }
  return nodes;
}

Route best_solved(LazyState& lazy) {
  const int K = lazy.graph.num_arcs();
  Route best;
  best.cost = lazy.limit;
  const auto take = [&](double cost, int first, int second, int pose) {
    if (cost >= best.cost) return;
    best.found = true;
    best.cost = cost;
    best.nodes = nodes_of(lazy, first, second, pose);
  };
  Candidates& candidates = lazy.candidates;
  for (int c = 0; c < candidates.size(); ++c) {
    poll();
    if (candidates.is_solved(c, 0, K)) take(candidates.after(c, 0), c, c, K);
  }
  for (int hub = 0; hub < lazy.hubs.size(); ++hub) {
    poll();
    for (int pose = 1; pose < K; ++pose) {
      if (!lazy.hubs.is_stable(hub, pose)) continue;
      int first = -1, second = -1;
      for (const Hubs::Member& member : lazy.hubs.members(hub)) {
        const int c = member.candidate;
        if (c < 0) continue;
        if (candidates.is_solved(c, 0, pose) &&
            (first < 0 || candidates.before(c, pose) < candidates.before(first, pose))) {
          first = c;
        }
        if (candidates.is_solved(c, pose, K) &&
            (second < 0 || candidates.after(c, pose) < candidates.after(second, pose))) {
          second = c;
        }
      }
      if (first < 0 || second < 0) continue;
      take(candidates.before(first, pose) + candidates.after(second, pose) +
               lazy.graph.options.regrasp_cost,
           first, second, pose);
    }
  }
  return best;
}

void share_stabilities(const PoseGraph& graph, const Route& route,
                       std::vector<Evaluator>& evaluators) {
  Evaluator& first = evaluators.front();
  for (std::size_t i = 1; i < route.nodes.size(); ++i) {
    const Node &from = route.nodes[i - 1], &to = route.nodes[i];
    for (std::size_t k = 1; k < evaluators.size(); ++k) {
      for (int f = 0; from.pose == to.pose && f < num_fingers(from.placement); ++f) {
        const Placement kept = without(from.placement, from.placement[f]);
        first.adopt(evaluators[k], graph.rest_instant(to.pose), kept);
      }
      for (int j = 0; from.pose < to.pose && j < graph.options.samples_per_arc; ++j) {
        first.adopt(evaluators[k], graph.instant(from.pose, j), to.placement);
      }
    }
  }
}

}  // namespace graspless::fingertip
