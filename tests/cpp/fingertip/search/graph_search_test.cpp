// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Dijkstra and A* against each other, the paper's costs, and a brute force over all routes.
#include "fingertip/search/graph_search.hpp"

#include <limits>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "fingertip/cases.hpp"
#include "fingertip/instance.hpp"
#include "fingertip/search/nodes.hpp"

namespace graspless::fingertip {
namespace {

/// The paper's tumble or slide on a coarse lattice, with walls, forces and prices drawn anew.
std::unique_ptr<Instance> coarse_instance(unsigned seed) {
  std::mt19937 rng(seed);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(rng);
  };
  Problem problem = seed % 3 == 0 ? slide_case(uniform(3, 12), 3) : tumble_case(seed % 3 == 1, 6);
  problem.fingers.radius = uniform(0.5, 1);
  problem.fingers.max_normal_force = uniform(5, 15);
  problem.fingers.count = seed % 5 == 0 ? 1 : 2;
  problem.friction = {uniform(0.4, 0.9), 0};
  problem.friction.upper = problem.friction.lower;
  for (std::size_t i = 1; i < problem.planes.size(); ++i) {
    problem.planes[i].offset = -2.5 - uniform(0, 2.5);
  }
  Options options;
  options.locations_per_side = 3;
  options.min_stability = uniform(0.05, 0.8);
  // Cheap and dear regrasps: where they are cheap, (11) as printed is not admissible.
  options.regrasp_cost = seed % 2 == 0 ? 100 : uniform(0.05, 3);
  return std::make_unique<Instance>(std::move(problem), std::move(options));
}

/// What a route costs by (9) and (10), each arc judged anew; infinite when one is not feasible.
double cost_of(Instance& instance, const Route& route) {
  const PoseGraph& graph = instance.graph;
  double cost = 0;
  for (std::size_t i = 0; i < route.nodes.size(); ++i) {
    const Node& node = route.nodes[i];
    if (!is_feasible(graph, node.pose, node.placement)) return INFINITY;
    if (i == 0) continue;
    const Node& before = route.nodes[i - 1];
    if (node.pose == before.pose) {
      Placement kept = kNoFingers;
      for (const int l : before.placement) {
        if (l >= 0 && std::count(node.placement.begin(), node.placement.end(), l) > 0) {
          kept = with(kept, l);
        }
      }
      EXPECT_EQ(num_fingers(kept), graph.num_fingers - 1);  // one finger at a time
      if (instance.evaluator.stability(graph.rest_instant(node.pose), kept) == 0) return INFINITY;
      cost += instance.options.regrasp_cost;
    } else {
      EXPECT_EQ(node.pose, before.pose + 1);
      EXPECT_EQ(node.placement, before.placement);
      std::vector<double> z;
      for (int j = 0; j < instance.options.samples_per_arc; ++j) {
        z.push_back(instance.evaluator.stability(graph.instant(before.pose, j), node.placement));
      }
      cost += arc_cost(graph, before.pose, node.placement, z);
    }
  }
  return cost;
}

TEST(FingertipGraphSearch, EnginesAgreeOnSmallInstances) {
  std::set<int> regrasps;
  int unsolvable = 0;
  for (unsigned seed = 16; seed <= 35; ++seed) {
    const auto instance = coarse_instance(seed);
    const Route dijkstra = instance->search(false), paper = instance->search(true);
    ASSERT_TRUE(dijkstra.is_complete && paper.is_complete) << seed;
    ASSERT_EQ(dijkstra.found, paper.found) << seed;
    if (!paper.found) {
      ++unsolvable;
      continue;
    }
    EXPECT_NEAR(paper.cost, dijkstra.cost, 1e-9) << seed;
    EXPECT_EQ(paper.lower_bound, paper.cost);
    for (const Route* route : {&dijkstra, &paper}) {
      EXPECT_NEAR(cost_of(*instance, *route), route->cost, 1e-9) << seed;
      EXPECT_EQ(route->nodes.front().pose, 0);
      EXPECT_EQ(route->nodes.back().pose, instance->graph.num_arcs());
    }
    regrasps.insert(num_regrasps(paper));
  }
  // The seeds ask for something: none, one and more regrasps, and what cannot be done.
  EXPECT_TRUE(regrasps.count(0) && regrasps.count(1) && *regrasps.rbegin() >= 2)
      << *regrasps.rbegin();
  EXPECT_GT(unsolvable, 0);
}

// Bellman and Ford on the graph as the paper draws it: no hubs, no queue.
TEST(FingertipGraphSearch, AgreesWithBruteForceOverTheWholeGraph) {
  int solved = 0;
  for (unsigned seed = 101; seed <= 106; ++seed) {
    const auto instance = coarse_instance(seed);
    Instance& it = *instance;
    std::vector<Placement> all;
    for (int a = 0; a < it.locations.size(); ++a) {
      if (it.graph.num_fingers == 1) all.push_back(with(kNoFingers, a));
      for (int b = a + 1; it.graph.num_fingers == 2 && b < it.locations.size(); ++b) {
        all.push_back(with(with(kNoFingers, a), b));
      }
    }
    std::map<Placement, double> cost;
    for (const Placement& p : all) cost[p] = is_feasible(it.graph, 0, p) ? 0 : INFINITY;
    for (int pose = 0; pose <= it.graph.num_arcs(); ++pose) {
      for (bool changed = true; changed;) {  // regrasps, until none is worth it
        changed = false;
        std::map<Placement, double> hub;
        for (const Placement& p : all) {
          for (int i = 0; i < it.graph.num_fingers; ++i) {
            const Placement kept = without(p, p[i]);
            const auto entry = hub.try_emplace(kept, INFINITY).first;
            entry->second = std::min(entry->second, cost[p]);
          }
        }
        for (const Placement& p : all) {
          if (!is_feasible(it.graph, pose, p)) continue;
          for (int i = 0; i < it.graph.num_fingers; ++i) {
            const Placement kept = without(p, p[i]);
            const double way = hub[kept] + it.options.regrasp_cost;
            if (!(way < cost[p] - 1e-12)) continue;
            if (it.evaluator.stability(it.graph.rest_instant(pose), kept) == 0) continue;
            cost[p] = way;
            changed = true;
          }
        }
      }
      if (pose == it.graph.num_arcs()) break;
      for (const Placement& p : all) {
        if (!std::isfinite(cost[p])) continue;
        std::vector<double> z;
        for (int j = 0; j < it.options.samples_per_arc; ++j) {
          z.push_back(it.evaluator.stability(it.graph.instant(pose, j), p));
        }
        cost[p] = is_feasible(it.graph, pose + 1, p) ? cost[p] + arc_cost(it.graph, pose, p, z)
                                                     : INFINITY;
      }
    }
    double best = INFINITY;
    for (const auto& [p, c] : cost) best = std::min(best, c);
    const Route route = it.search(true);
    EXPECT_EQ(route.found, std::isfinite(best)) << seed;
    if (!route.found) continue;
    ++solved;
    EXPECT_NEAR(route.cost, best, 1e-9) << seed;
  }
  EXPECT_GE(solved, 3);
}

TEST(FingertipGraphSearch, HeuristicIsConsistent) {
  for (const unsigned seed : {1U, 2U, 4U, 7U}) {
    const auto instance = coarse_instance(seed);
    const PoseGraph& graph = instance->graph;
    RemainingDistance remaining(graph);
    const Heuristic h(graph, remaining);
    const double X_regr = instance->options.regrasp_cost;
    std::mt19937 rng(seed);
    for (int i = 0; i < 2000; ++i) {
      std::uniform_int_distribution<int> location(0, instance->locations.size() - 1);
      Placement p = kNoFingers;
      while (num_fingers(p) < graph.num_fingers) {
        const int l = location(rng);
        p = with(without(p, l), l);
      }
      const int pose = std::uniform_int_distribution<int>(0, graph.num_arcs() - 1)(rng);
      const std::vector<double> z(3, 1e12);  // no arc is cheaper
      EXPECT_LE(h({pose, p}), arc_cost(graph, pose, p, z) + h({pose + 1, p}) + 1e-9);
      const Placement kept = without(p, p[0]);
      EXPECT_LE(h({pose, p}), X_regr + h({pose, kept}) + 1e-9);
      EXPECT_LE(h({pose, kept}), h({pose, p}) + 1e-9);
      EXPECT_EQ(h({graph.num_arcs(), p}) > 0,
                !is_feasible(graph, graph.num_arcs(), with(kNoFingers, p[0])) ||
                    (p[1] >= 0 && !graph.is_clear(graph.num_arcs(), p[1])));
    }
  }
}

TEST(FingertipGraphSearch, MaxRegraspsIsKept) {
  bool was_limited = false;
  for (unsigned seed = 1; seed <= 40 && !was_limited; ++seed) {
    const auto instance = coarse_instance(seed);
    const Route free = instance->search(true);
    const int count = num_regrasps(free);
    if (!free.found || count < 1) continue;
    instance->options.max_regrasps = count - 1;
    const Route limited = instance->search(true);
    if (!limited.found) continue;
    was_limited = true;
    EXPECT_LT(num_regrasps(limited), count);
    EXPECT_GT(limited.cost, free.cost);
    EXPECT_NEAR(limited.cost, instance->search(false).cost, 1e-9);
    EXPECT_NEAR(limited.cost, cost_of(*instance, limited), 1e-9);
  }
  EXPECT_TRUE(was_limited);
}

TEST(FingertipGraphSearch, OutOfBudgetStillBoundsTheCost) {
  const auto instance = coarse_instance(2);
  const Route whole = instance->search(true);
  ASSERT_TRUE(whole.found);
  planning::Budget budget;
  for (budget.iterations = 0; budget.iterations < 60; budget.iterations += 7) {
    const Route part = instance->search(true, budget);
    if (part.found) break;
    EXPECT_FALSE(part.is_complete);
    EXPECT_LE(part.lower_bound, whole.cost);
  }
}

TEST(FingertipGraphSearch, NodesAreNumbersAndBack) {
  const NodeCode code(31, 294, 3, 2);
  std::set<std::uint64_t> seen;
  for (const Node& node : {Node{0, {0, 1, 2, -1}}, Node{30, {7, 250, 293, -1}},
                           Node{30, {7, 250, -1, -1}}, Node{12, {5, -1, -1, -1}}}) {
    for (const int layer : {0, 1}) {
      int back_layer = -1;
      const std::uint64_t number = code.pack(node, layer);
      const Node back = code.unpack(number, &back_layer);
      EXPECT_EQ(back.pose, node.pose);
      EXPECT_EQ(back.placement, node.placement);
      EXPECT_EQ(back_layer, layer);
      EXPECT_TRUE(seen.insert(number).second);
    }
  }
  EXPECT_THROW(NodeCode(100000, 1000000, 4, 9), std::invalid_argument);
}

}  // namespace
}  // namespace graspless::fingertip
