// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/certificate/tight_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "graspless/geometry/linking.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kNever = std::numeric_limits<double>::infinity();

struct Graph {
  Matrix3Xd points;
  std::vector<SpatialEdge> edges;

  double width(int a, int b) const {
    for (const SpatialEdge& edge : edges) {
      if ((edge.a == a && edge.b == b) || (edge.a == b && edge.b == a)) return edge.width;
    }
    return kNever;
  }
  double widest(const std::vector<int>& cycle) const {
    double most = -kNever;
    for (std::size_t i = 0; i < cycle.size(); ++i)
      most = std::max(most, width(cycle[i], cycle[(i + 1) % cycle.size()]));
    return most;
  }
};

Matrix3Xd circle(int corners) {
  Matrix3Xd p(3, corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    p.col(i) << std::cos(angle), std::sin(angle), 0.1 * std::sin(3 * angle);
  }
  return p;
}

Graph random_graph(std::mt19937_64& rng, int points) {
  std::uniform_real_distribution<double> place(-1.6, 1.6), unit(0, 1);
  Graph graph{Matrix3Xd(3, points), {}};
  for (double& value : graph.points.reshaped()) value = place(rng);
  for (int a = 0; a < points; ++a) {
    for (int b = a + 1; b < points; ++b) {
      if (unit(rng) < 0.6) graph.edges.push_back({a, b, unit(rng) - 0.3});
    }
  }
  return graph;
}

/// Extends a way by every point that has not been visited; each cycle is seen from its least point.
void visit_cycles(const Graph& graph, std::vector<int>& way, const Matrix3Xd& curve, double& best) {
  const int n = static_cast<int>(graph.points.cols());
  if (way.size() >= 3 && graph.width(way.back(), way.front()) < best && graph.widest(way) < best &&
      geometry::linking_number(curve, graph.points(Eigen::all, way)) != 0) {
    best = graph.widest(way);
  }
  for (int next = way.front() + 1; next < n; ++next) {
    if (std::count(way.begin(), way.end(), next) > 0 || graph.width(way.back(), next) >= best)
      continue;
    way.push_back(next);
    visit_cycles(graph, way, curve, best);
    way.pop_back();
  }
}

TEST(TightCycle, IsAsTightAsTheBestOfAllCycles) {
  std::mt19937_64 rng(3);
  const Matrix3Xd curve = circle(23);
  int found = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Graph graph = random_graph(rng, 7);
    double best = kNever;
    for (int first = 0; first < 7; ++first) {
      std::vector<int> way{first};
      visit_cycles(graph, way, curve, best);
    }
    const std::vector<int> cycle = tightest_cycle(graph.points, graph.edges, curve);
    ASSERT_EQ(cycle.empty(), best == kNever) << trial;
    if (cycle.empty()) continue;
    ++found;
    EXPECT_EQ(graph.widest(cycle), best) << trial;
    EXPECT_NE(geometry::linking_number(curve, graph.points(Eigen::all, cycle)), 0) << trial;
  }
  EXPECT_GT(found, 100);
  EXPECT_LT(found, 300);
}

TEST(TightCycle, TheOrderOfTheEdgesDoesNotMatter) {
  std::mt19937_64 rng(4);
  Graph graph = random_graph(rng, 30);
  const Matrix3Xd curve = circle(40);
  const double width = graph.widest(tightest_cycle(graph.points, graph.edges, curve));
  for (int trial = 0; trial < 5; ++trial) {
    std::shuffle(graph.edges.begin(), graph.edges.end(), rng);
    EXPECT_EQ(graph.widest(tightest_cycle(graph.points, graph.edges, curve)), width);
  }
}

/// A square in a plane of symmetry of the curve: every sum of the cone could be in doubt.
TEST(TightCycle, SymmetriesDoNotMatter) {
  Matrix3Xd square(3, 4), curve(3, 4);
  square << 0, 0, 2, 2, 0, 0, 0, 0, -1, 1, 1, -1;
  curve << 1, 0, -1, 0, 0, 1, 0, -1, 0, 0, 0, 0;
  const std::vector<SpatialEdge> sides{{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 0, 4}};
  EXPECT_EQ(tightest_cycle(square, sides, curve).size(), 4);
  EXPECT_TRUE(tightest_cycle(square.colwise() + Vector3d(2, 0, 0), sides, curve).empty());
  EXPECT_TRUE(tightest_cycle(square, {sides[0], sides[1], sides[2]}, curve).empty());
}

}  // namespace
}  // namespace graspless::clasp
