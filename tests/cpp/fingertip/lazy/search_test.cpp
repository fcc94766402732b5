// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The fast search against Dijkstra's.
#include "fingertip/lazy/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "fingertip/cases.hpp"
#include "fingertip/instance.hpp"

namespace graspless::fingertip {
namespace {

/// An instance that the fast search can be run on.
struct LazyInstance : Instance {
  using Instance::Instance;

  Route dijkstra() { return search(false); }
  Route fast(int lanes = kPoolSize, const planning::Budget& budget = {},
             double limit = std::numeric_limits<double>::infinity(), bool needs_regrasp = false) {
    std::vector<Evaluator> evaluators;
    for (int i = 0; i < lanes; ++i) evaluators.emplace_back(instants, locations, options);
    planning::Clock clock(budget);
    return search_fast(graph, evaluators, clock, statistics, limit, needs_regrasp);
  }
};

/// A box slid or tumbled. Each location is out of reach on some stretch of the way, so that
/// regrasps are needed.
std::unique_ptr<LazyInstance> random_instance(unsigned seed) {
  std::mt19937 rng(seed);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(rng);
  };
  const auto pick = [&](int a, int b) { return std::uniform_int_distribution<int>(a, b)(rng); };
  const Eigen::Vector3d size(uniform(3, 8), uniform(3, 10), uniform(3, 8));
  Problem problem{Object::box("box", size, uniform(0.5, 2)), {}, {}, {}, {}, {}};
  problem.fingers.count = std::vector<int>{1, 2, 2, 2, 2, 2, 2, 2, 3, 3}[seed % 10];
  problem.fingers.radius = uniform(0.3, 1);
  problem.fingers.max_normal_force = uniform(5, 20);
  problem.planes = {Plane{}};
  const bool has_three = problem.fingers.count == 3;
  const int segments = has_three ? 3 : pick(3, 7);
  const Eigen::Isometry3d X_WO(Eigen::Translation3d(0, 0, size.z() / 2));
  if (pick(0, 2) == 0) {
    problem.motion = slide_path(X_WO, {uniform(2, 10), 0, 0}, segments);
  } else {
    problem.motion = turn_path(X_WO, {size.x() / 2, 0, 0}, Eigen::Vector3d::UnitY(),
                               uniform(0.5, 1) * M_PI / 2, segments);
  }
  Options options;
  options.locations_per_side = has_three ? 2 : pick(2, 3);
  options.samples_per_arc = has_three ? 1 : pick(1, 3);
  options.min_stability = uniform(0.05, 0.4);
  options.regrasp_cost = pick(0, 1) == 0 ? 100 : uniform(0.01, 1);
  options.max_regrasps = pick(0, 4);
  auto instance = std::make_unique<LazyInstance>(std::move(problem), options);
  const int poses = instance->graph.num_poses(), locations = instance->locations.size();
  const int often = pick(0, 3);
  for (int location = 0; location < locations; ++location) {
    const int first = pick(0, poses - 1);
    const int last = pick(0, 1) == 0 ? poses - 1 : std::min(poses - 1, first + pick(0, 2));
    for (int pose = first; pose <= last && pick(0, 3) < often; ++pose) {
      instance->graph.block(pose, location);
    }
  }
  return instance;
}

/// The cost of a route by (9) and (10), from its nodes; fails where the graph has no such arc.
double cost_of(LazyInstance& instance, const Route& route) {
  const PoseGraph& graph = instance.graph;
  Evaluator evaluator(instance.instants, instance.locations, instance.options);
  EXPECT_EQ(route.nodes.front().pose, 0);
  EXPECT_EQ(route.nodes.back().pose, graph.num_arcs());
  double cost = 0;
  for (std::size_t i = 0; i < route.nodes.size(); ++i) {
    const Node& node = route.nodes[i];
    EXPECT_TRUE(is_feasible(graph, node.pose, node.placement));
    if (i == 0) continue;
    const Node& last = route.nodes[i - 1];
    if (node.pose == last.pose) {
      Placement kept = last.placement;
      for (const std::int32_t location : last.placement) {
        if (location >= 0 && std::find(node.placement.begin(), node.placement.end(), location) ==
                                 node.placement.end()) {
          kept = without(kept, location);
        }
      }
      EXPECT_EQ(num_fingers(kept), num_fingers(node.placement) - 1);
      EXPECT_GT(evaluator.stability(graph.rest_instant(node.pose), kept), 0);
      cost += instance.options.regrasp_cost;
    } else {
      EXPECT_EQ(node.pose, last.pose + 1);
      EXPECT_EQ(node.placement, last.placement);
      std::vector<double> z;
      for (int j = 0; j < instance.options.samples_per_arc; ++j) {
        z.push_back(evaluator.stability(graph.instant(last.pose, j), node.placement));
      }
      cost += arc_cost(graph, last.pose, node.placement, z);
    }
  }
  return cost;
}

/// How many instances were solved without a regrasp, with one, and with more.
std::array<int, 3> compare_with_dijkstra(unsigned first, unsigned last) {
  std::array<int, 3> solved{};
  for (unsigned seed = first; seed <= last; ++seed) {
    SCOPED_TRACE(seed);
    const auto instance = random_instance(seed);
    const Route expected = instance->dijkstra();
    const Route route = instance->fast();
    EXPECT_TRUE(expected.is_complete && route.is_complete);
    EXPECT_EQ(route.found, expected.found);
    if (!route.found || !expected.found) continue;
    EXPECT_NEAR(route.cost, expected.cost, 1e-9 * (1 + expected.cost));
    EXPECT_NEAR(route.cost, cost_of(*instance, route), 1e-9 * (1 + expected.cost));
    EXPECT_EQ(route.lower_bound, route.cost);
    EXPECT_LE(num_regrasps(route), instance->options.max_regrasps);
    ++solved[std::min(2, num_regrasps(route))];
  }
  return solved;
}

TEST(LazySearch, CostsWhatDijkstraCosts) {
  const std::array<int, 3> solved = compare_with_dijkstra(1, 60);
  for (const int count : solved) EXPECT_GT(count, 1);
}

TEST(LazySearch, CostsWhatDijkstraCostsMoreOften) {
  const std::array<int, 3> solved = compare_with_dijkstra(61, 260);
  for (const int count : solved) EXPECT_GT(count, 10);
}

std::unique_ptr<LazyInstance> instance_of(const Problem& problem) {
  return std::make_unique<LazyInstance>(problem, Options{});
}

TEST(LazySearch, CostsOfThePapersCases) {
  for (const Case& c : paper_cases()) {
    SCOPED_TRACE(c.name);
    const auto instance = instance_of(c.problem);
    const Route route = instance->fast();
    ASSERT_TRUE(route.found);
    EXPECT_NEAR(route.cost, c.cost, 1e-8);
    EXPECT_EQ(num_regrasps(route), c.regrasps);
    EXPECT_NEAR(route.cost, cost_of(*instance, route), 1e-9);
  }
}

TEST(LazySearch, FourFingersCostWhatDijkstraCosts) {
  for (const double max_normal_force : {3.0, 5.0, 10.0}) {
    Problem problem = slide_case(max_normal_force, 1);
    problem.fingers.count = 4;
    problem.fingers.radius = 0.5;
    Options options;
    options.locations_per_side = 2;
    options.samples_per_arc = 1;
    options.max_regrasps = 0;
    LazyInstance instance(problem, options);
    const Route expected = instance.dijkstra();
    const Route route = instance.fast();
    ASSERT_TRUE(expected.found && route.found);
    EXPECT_NEAR(route.cost, expected.cost, 1e-9);
    EXPECT_NEAR(route.cost, cost_of(instance, route), 1e-9);
  }
}

TEST(LazySearch, RepeatsWhateverTheThreads) {
  for (const auto& [has_side_wall, per_side] : {std::pair{false, 7}, {true, 7}, {true, 11}}) {
    Options options;
    options.locations_per_side = per_side;
    const auto instance = std::make_unique<LazyInstance>(tumble_case(has_side_wall), options);
    const Route first = instance->fast();
    for (const int threads : {1, 2, 3}) {
      instance->options.threads = threads;
      const Route again = instance->fast();
      EXPECT_EQ(again.cost, first.cost);
      ASSERT_EQ(again.nodes.size(), first.nodes.size());
      for (std::size_t i = 0; i < first.nodes.size(); ++i) {
        EXPECT_EQ(again.nodes[i].placement, first.nodes[i].placement);
      }
    }
  }
}

TEST(LazySearch, OutOfTimeBoundsTheCost) {
  const auto instance = instance_of(tumble_case(true));
  double last = 0;
  for (const int rounds : {0, 5, 20, 60, 120}) {
    planning::Budget budget;
    budget.iterations = rounds;
    const Route route = instance->fast(kPoolSize, budget);
    EXPECT_GE(route.lower_bound, last);
    EXPECT_LE(route.lower_bound, 117.3922089);
    if (route.found) {
      EXPECT_GE(route.cost, 117.3922088);
    }
    if (rounds == 0) {
      EXPECT_FALSE(route.is_complete || route.found);
    }
    last = route.lower_bound;
  }
  EXPECT_GT(last, 100);  // a regrasp has been shown to be needed by then
}

TEST(LazySearch, LooksNoFartherThanTheLimit) {
  const auto instance = instance_of(tumble_case(true));
  const Route below = instance->fast(kPoolSize, {}, 117.39);
  EXPECT_TRUE(below.is_complete);
  EXPECT_FALSE(below.found);
  EXPECT_NEAR(instance->fast(kPoolSize, {}, 117.4).cost, 117.392208834, 1e-8);
}

TEST(LazySearch, FindsTheSameWhereItKnowsThatARegraspIsNeeded) {
  int count = 0;
  for (unsigned seed = 1; seed <= 260; ++seed) {
    SCOPED_TRACE(seed);
    const auto instance = random_instance(seed);
    instance->options.max_regrasps = 0;
    if (instance->fast().found) continue;
    instance->options.max_regrasps = 3;
    const Route expected = instance->fast();
    const Route route = instance->fast(kPoolSize, {}, kInfinity, true);
    EXPECT_TRUE(route.is_complete);
    ASSERT_EQ(route.found, expected.found);
    if (!route.found) continue;
    EXPECT_NEAR(route.cost, expected.cost, 1e-9 * (1 + expected.cost));
    ++count;
  }
  EXPECT_GT(count, 10);
}

TEST(LazySearch, ShowsThatThereIsNone) {
  Options options;
  options.min_stability = 50;
  LazyInstance instance(tumble_case(false), options);
  const Route route = instance.fast();
  EXPECT_TRUE(route.is_complete);
  EXPECT_FALSE(route.found);
}

TEST(LazySearch, DoesNotOutgrowItsMemory) {
  Options options;
  options.max_memory = 1e5;
  const Plan plan = fingertip::plan(tumble_case(true), options);
  EXPECT_EQ(plan.status, Status::out_of_memory);
  EXPECT_NE(plan.reason.find("options.max_memory"), std::string::npos) << plan.reason;
  EXPECT_NE(plan.reason.find("locations_per_side"), std::string::npos) << plan.reason;
}

}  // namespace
}  // namespace graspless::fingertip
