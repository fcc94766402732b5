// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// What all parts of the fast search share, and its beginning and end.
#include "fingertip/lazy/search.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace graspless::fingertip {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The cheapest route of which everything is solved, when there is no time for more.
Route best_solved(FastSearch& search) {
  const int K = search.query.num_arcs();
  Route best;
  best.cost = search.limit;
  const auto take = [&](double cost, int first, int second, int pose) {
    if (cost >= best.cost) return;
    best.found = true;
    best.cost = cost;
    best.nodes = nodes_of(search, first, second, pose);
  };
  Candidates& candidates = search.candidates;
  for (int c = 0; c < candidates.size(); ++c) {
    if (candidates.is_solved(c, 0, K)) take(candidates.after(c, 0), c, c, K);
  }
  for (int hub = 0; hub < search.hubs.size(); ++hub) {
    for (int pose = 1; pose < K; ++pose) {
      if (!search.hubs.rests(hub, pose)) continue;
      int first = -1, second = -1;
      for (const int c : search.hubs.members(hub)) {
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
               search.query.options.regrasp_cost,
           first, second, pose);
    }
  }
  return best;
}

/// Lets the first evaluator know what the others have found out about the route.
void gather_known(const PathQuery& query, const Route& route, std::vector<Evaluator>& evaluators) {
  for (std::size_t i = 1; i < route.nodes.size(); ++i) {
    const Node &from = route.nodes[i - 1], &to = route.nodes[i];
    for (std::size_t lane = 1; lane < evaluators.size(); ++lane) {
      if (from.pose == to.pose) {
        for (const std::int32_t finger : from.placement) {
          if (finger < 0) break;
          evaluators.front().adopt(evaluators[lane], query.rest_instant(to.pose),
                                   without(from.placement, finger));
        }
      }
      for (int j = 0; from.pose < to.pose && j < query.options.samples_per_arc; ++j) {
        evaluators.front().adopt(evaluators[lane], query.instant(from.pose, j), to.placement);
      }
    }
  }
}

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
      limit(limit_in),
      lanes_(evaluators, query_in.options.threads) {
  for (int arc = 0; arc < query.num_arcs(); ++arc) {
    double least = kInfinity;
    for (const int location : clear_locations(query, arc, arc + 1)) {
      least = std::min(least, query.displacement(arc, location));
    }
    least_displacement += least * query.options.samples_per_arc;
  }
}

void FastSearch::learn(const std::vector<Question>& questions) {
  for (const Question& question : questions) {
    supports.add(question.instant, question.supports, question.placement);
    question.of == Question::Of::candidate ? candidates.learn(question) : hubs.learn(question);
  }
}

void FastSearch::solve(std::vector<Question>& questions) {
  lanes_.start(questions);
  lanes_.finish();
  learn(questions);
}

void FastSearch::start(std::vector<Question>& questions) {
  in_flight_.swap(questions);
  if (!in_flight_.empty()) lanes_.start(in_flight_);
}

void FastSearch::learn_last() {
  learn(solved_);
  solved_.clear();
}

void FastSearch::finish() {
  if (!in_flight_.empty()) lanes_.finish();
  solved_.swap(in_flight_);
  in_flight_.clear();
}

std::int64_t FastSearch::note_memory(std::int64_t more_candidates) {
  constexpr std::int64_t kUnopened = 64;  // bytes of a placement in the frontier, and of its growth
  const std::int64_t bytes = supports.memory() + candidates.memory() + hubs.memory() +
                             unopened * kUnopened + more_candidates * Candidates::bytes_each(query);
  statistics.memory = std::max(statistics.memory, bytes);
  return bytes;
}

void FastSearch::watch_memory(std::int64_t more_candidates) {
  const std::int64_t bytes = note_memory(more_candidates);
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
                       if (found.size() % FastSearch::kWatch == 0) {
                         search.watch_memory(static_cast<std::int64_t>(found.size()));
                       }
                       return true;
                     });
  search.watch_memory(static_cast<std::int64_t>(found.size()));
  search.candidates.reserve(found.size());
  for (const Placement& placement : found) search.candidates.open(placement);
}

std::vector<Node> nodes_of(const FastSearch& search, int first, int second, int pose) {
  std::vector<Node> nodes;
  for (int q = 0; q <= pose; ++q) nodes.push_back({q, search.candidates.placement(first)});
  for (int q = second == first ? pose + 1 : pose; q < search.query.num_poses(); ++q) {
    nodes.push_back({q, search.candidates.placement(second)});
  }
  return nodes;
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
  Route route = search_best_first(search);
  if (!route.is_complete) {
    const double lower_bound = route.lower_bound;
    route = best_solved(search);
    route.lower_bound = route.found ? std::min(lower_bound, route.cost) : lower_bound;
  }
  search.note_memory();
  gather_known(query, route, evaluators);
  statistics.supports += search.supports.count();
  statistics.nodes += search.candidates.size();
  return route;
}

}  // namespace graspless::fingertip
