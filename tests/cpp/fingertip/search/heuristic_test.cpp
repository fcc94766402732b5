// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/search/heuristic.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "fingertip/cases.hpp"
#include "fingertip/instance.hpp"

namespace graspless::fingertip {
namespace {

/// The distances of all locations are the least over the arcs that go on from each pose.
void expect_least(const PoseGraph& graph) {
  RemainingDistance remaining(graph);
  for (int l = 0; l < graph.locations.size(); ++l) {
    const double* to_goal = remaining.to_goal(l);
    EXPECT_EQ(to_goal[graph.goal()], 0);
    for (int pose = 0; pose < graph.num_poses(); ++pose) {
      const double straight = (graph.center_W(pose, l) - graph.center_W(graph.goal(), l)).norm();
      EXPECT_GE(to_goal[pose], straight * (1 - 1e-9));
      if (pose == graph.goal()) continue;
      double least = kInfinity;
      for (int move = 0; move < graph.num_moves(); ++move) {
        const int to = graph.next(pose, move);
        if (to < 0) continue;
        const double arc =
            graph.options.samples_per_arc * graph.displacement(graph.motion(pose, move), l);
        least = std::min(least, arc + to_goal[to]);
      }
      EXPECT_NEAR(to_goal[pose], least, 1e-12);
    }
  }
}

TEST(RemainingDistance, IsTheLeastOverNeighbours) {
  expect_least(LatticeInstance(3).graph);
  expect_least(Instance(tumble_case(false, 6), Options{}).graph);
}

TEST(RemainingDistance, ALimitLeavesOutOnlyWhatCannotBeOnTheRoute) {
  const LatticeInstance instance(2);
  const PoseGraph& graph = instance.graph;
  RemainingDistance all(graph), limited(graph);
  const double* exact = all.to_goal(0);
  const double limit = exact[graph.start()] * 1.1;
  const double* some = limited.to_goal(0, limit);
  int left_out = 0;
  for (int pose = 0; pose < graph.num_poses(); ++pose) {
    if (some[pose] < kInfinity) {
      EXPECT_NEAR(some[pose], exact[pose], 1e-12);
      continue;
    }
    ++left_out;
    const double before = (graph.center_W(pose, 0) - graph.center_W(graph.start(), 0)).norm();
    EXPECT_GE(before + exact[pose], limit * (1 - 1e-9));
  }
  EXPECT_GT(left_out, 0);
}

}  // namespace
}  // namespace graspless::fingertip
