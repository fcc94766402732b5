// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "complaint.hpp"
#include "slide/placement.hpp"
#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

Problem on(const Support& all, const std::vector<int>& edges) {
  const Support some(all.polygon(), all.X_WS(), all.slab(), all.goal_band().width(), all.friction(),
                     edges);
  return make_problem(some, objects()[0], flat(0.62, 0, 0.3));
}

/// The first of tables(), with some edges: 0 is at y = -0.35 m, 1 at x = 1 m, 2 at y = 0.35 m.
Problem with_edges(const std::vector<int>& edges) { return on(tables()[0], edges); }

/// Edges of the round table on one side of y = 0.
std::vector<int> half(double side) {
  std::vector<int> edges;
  const geometry::Polygon& disc = tables()[1].polygon();
  for (int i = 0; i < disc.size(); ++i) {
    if ((disc.edge(i).a + disc.edge(i).b).y() * side > 0) edges.push_back(i);
  }
  return edges;
}

TEST(UsableEdges, PlansEndOverThemAndTheCheckRefusesOthers) {
  for (const double side : {-1.0, 1.0}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const Problem problem = on(tables()[1], half(side));
      const Plan found = plan(problem, {}, seeded(seed));
      ASSERT_TRUE(found) << found.reason;
      EXPECT_TRUE(check(problem, found).empty());
      EXPECT_GT(side * found.X_WH_grasp.translation().y(), 0);
      const auto faults = check(on(tables()[1], half(-side)), found);
      ASSERT_FALSE(faults.empty());
      EXPECT_NE(faults.front().find("edge of the support that is not usable"), std::string::npos);
    }
  }
}

TEST(UsableEdges, WithAllOfThemPlansAreAsBefore) {
  const Problem all = make_problem(tables()[0], objects()[0], flat(0.62, 0, 0.3));
  const Plan one = plan(all, {}, seeded(1)), other = plan(with_edges({0, 1, 2, 3}), {}, seeded(1));
  ASSERT_TRUE(one);
  EXPECT_EQ(one.X_WO_goal.matrix(), other.X_WO_goal.matrix());
}

TEST(UsableEdges, NothingMayStickOutOverAnotherEdge) {
  const Problem problem = with_edges({1});
  Planar corner = Planar::Identity();
  corner.translation() << 0.98, 0.33;  // over the edges 1 and 2
  const Placement place = placement(problem, {}, corner);
  EXPECT_TRUE(place.sticks_out);
  EXPECT_EQ(place.overhang, 0);
  EXPECT_EQ(place.fault, "edge not usable");
  EXPECT_GT(placement(with_edges({1, 2}), {}, corner).overhang, 0.01);
}

TEST(UsableEdges, MustBeThoseOfThePolygon) {
  expect_refused([] { with_edges({}); }, "usable_edges is empty");
  expect_refused([] { with_edges({4}); }, "usable_edges has 4; edges are numbered from 0 to 3");
  expect_refused([] { with_edges({-1}); }, "usable_edges has -1");
  expect_refused([] { with_edges({2, 2}); }, "usable_edges has 2 twice");
}

}  // namespace
}  // namespace graspless::slide
