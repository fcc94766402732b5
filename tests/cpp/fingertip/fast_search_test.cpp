// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The fast search against Dijkstra's.
#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "fingertip/path_query.hpp"

namespace graspless::fingertip {
namespace {

/// A problem with all that a search needs.
struct Instance {
  Instance(Problem problem_in, Options options_in)
      : problem(std::move(problem_in)),
        options(std::move(options_in)),
        locations(problem.object, problem.fingers, options),
        instants(problem, options),
        query(problem, std::get<Path>(problem.motion), locations, instants, options) {}

  Route dijkstra() {
    Evaluator evaluator(instants, locations, options);
    planning::Clock clock(planning::Budget{});
    Statistics statistics;
    return search_graph(query, evaluator, false, clock, statistics);
  }
  Route fast(int lanes = 2, const planning::Budget& budget = {}) {
    std::vector<Evaluator> evaluators;
    for (int i = 0; i < lanes; ++i) evaluators.emplace_back(instants, locations, options);
    planning::Clock clock(budget);
    Statistics statistics;
    return search_fast(query, evaluators, clock, statistics);
  }

  Problem problem;
  Options options;
  Locations locations;
  Instants instants;
  PathQuery query;
};

/// A box slid or tumbled, among walls and small obstacles that are in the way of its fingers.
std::unique_ptr<Instance> random_instance(unsigned seed) {
  std::mt19937 rng(seed);
  const auto uniform = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(rng);
  };
  const auto pick = [&](int a, int b) { return std::uniform_int_distribution<int>(a, b)(rng); };
  const Eigen::Vector3d size(uniform(3, 8), uniform(3, 10), uniform(3, 8));
  Problem problem{Object::box("box", size, uniform(0.5, 2)), {}, {}, {}, {}, {}};
  problem.fingers.count = pick(1, 10) == 1 ? 1 : pick(2, 10) <= 8 ? 2 : 3;
  problem.fingers.radius = uniform(0.3, 1);
  problem.fingers.max_normal_force = uniform(5, 20);
  problem.fingers.friction = {0.7, 0.7};
  problem.planes = {Plane{}};
  if (pick(0, 1) == 1)
    problem.planes.push_back({"behind", {1, 0, 0}, -size.x() / 2 - uniform(0.1, 1)});
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  X_WO.translation().z() = size.z() / 2;
  const int segments = problem.fingers.count == 3 ? 3 : pick(3, 7);
  if (pick(0, 2) == 0) {
    problem.motion = slide_path(X_WO, {uniform(2, 10), 0, 0}, segments);
  } else {
    problem.motion =
        turn_path(X_WO, {size.x() / 2, 0, 0}, {0, 1, 0}, uniform(0.5, 1) * M_PI / 2, segments);
  }
  for (int i = pick(0, 8); i > 0; --i) {
    Obstacle obstacle;
    obstacle.name = "obstacle" + std::to_string(i);
    obstacle.shapes = {
        {geometry::Box{Eigen::Vector3d::Constant(uniform(0.5, 4))}, Eigen::Isometry3d::Identity()}};
    obstacle.X_WB.translation() = Eigen::Vector3d(uniform(-6, 10), uniform(-6, 6), uniform(0, 9));
    problem.obstacles.push_back(obstacle);
  }
  Options options;
  options.locations_per_side = problem.fingers.count == 3 ? 2 : pick(2, 3);
  options.samples_per_arc = problem.fingers.count == 3 ? 1 : pick(1, 3);
  options.min_stability = uniform(0.05, 0.6);
  options.regrasp_cost = pick(0, 1) == 0 ? 100 : uniform(0.01, 1);
  options.max_regrasps = pick(1, 4);
  return std::make_unique<Instance>(std::move(problem), std::move(options));
}

int num_regrasps(const Route& route) {
  int count = 0;
  for (std::size_t i = 1; i < route.nodes.size(); ++i) {
    if (route.nodes[i].pose == route.nodes[i - 1].pose) ++count;
  }
  return count;
}

/// The cost of a route by (9) and (10), from its nodes; fails where the graph has no such arc.
double cost_of(Instance& instance, const Route& route) {
  const PathQuery& query = instance.query;
  Evaluator evaluator(instance.instants, instance.locations, instance.options);
  EXPECT_EQ(route.nodes.front().pose, 0);
  EXPECT_EQ(route.nodes.back().pose, query.num_arcs());
  double cost = 0;
  for (std::size_t i = 0; i < route.nodes.size(); ++i) {
    const Node& node = route.nodes[i];
    EXPECT_TRUE(is_feasible(query, node.pose, node.placement));
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
      EXPECT_GT(evaluator.stability(query.rest_instant(node.pose), kept), 0);
      cost += instance.options.regrasp_cost;
    } else {
      EXPECT_EQ(node.pose, last.pose + 1);
      EXPECT_EQ(node.placement, last.placement);
      std::vector<double> z;
      for (int j = 0; j < instance.options.samples_per_arc; ++j) {
        z.push_back(evaluator.stability(query.instant(last.pose, j), node.placement));
      }
      cost += arc_cost(query, last.pose, node.placement, z.data());
    }
  }
  return cost;
}

TEST(FastSearch, CostsWhatDijkstraCosts) {
  int solved = 0, with_one = 0, with_more = 0;
  const char* first = std::getenv("GRASPLESS_FAST_FROM");
  const char* last = std::getenv("GRASPLESS_FAST_TO");
  for (unsigned seed = first ? static_cast<unsigned>(std::atoi(first)) : 1;
       seed <= (last ? static_cast<unsigned>(std::atoi(last)) : 40); ++seed) {
    SCOPED_TRACE(seed);
    const auto instance = random_instance(seed);
    const Route expected = instance->dijkstra();
    const Route route = instance->fast();
    ASSERT_TRUE(expected.is_complete && route.is_complete);
    ASSERT_EQ(route.found, expected.found);
    if (!route.found) continue;
    EXPECT_NEAR(route.cost, expected.cost, 1e-9 * (1 + expected.cost));
    EXPECT_NEAR(route.cost, cost_of(*instance, route), 1e-9 * (1 + expected.cost));
    EXPECT_LE(num_regrasps(route), instance->options.max_regrasps);
    ++solved;
    if (num_regrasps(route) == 1) ++with_one;
    if (num_regrasps(route) >= 2) ++with_more;
  }
  RecordProperty("solved", solved);
  RecordProperty("one_regrasp", with_one);
  RecordProperty("more_regrasps", with_more);
  printf("solved %d, one regrasp %d, more %d\n", solved, with_one, with_more);
}

}  // namespace
}  // namespace graspless::fingertip
