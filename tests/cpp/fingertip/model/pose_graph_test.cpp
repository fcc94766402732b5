// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/model/pose_graph.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "fingertip/cases.hpp"
#include "fingertip/instance.hpp"
#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {
namespace {

TEST(PoseGraph, PathIsAChain) {
  const Instance instance(tumble_case(false, 6), Options{});
  const PoseGraph& graph = instance.graph;
  EXPECT_TRUE(graph.is_path());
  EXPECT_EQ(graph.num_poses(), 7);
  EXPECT_EQ(graph.start(), 0);
  EXPECT_EQ(graph.goal(), 6);
  for (int pose = 0; pose < graph.num_poses(); ++pose) {
    EXPECT_EQ(graph.previous(pose, 0), pose - 1);
    EXPECT_EQ(graph.next(pose, 0), pose == graph.goal() ? -1 : pose + 1);
    EXPECT_EQ(graph.kind(pose, 0) < 0, pose == graph.goal());
    EXPECT_TRUE(graph.is_free(pose));
  }
}

TEST(PoseGraph, MovesOfALatticeUndoEachOtherAndLeadWhereTheySay) {
  const LatticeInstance instance(7);
  const PoseGraph& graph = instance.graph;
  const auto& lattice = std::get<Lattice>(instance.problem.motion);
  EXPECT_FALSE(graph.is_path());
  EXPECT_TRUE(graph.X_WO(graph.start()).isApprox(lattice.X_WO_start));
  EXPECT_TRUE(graph.X_WO(graph.goal()).isApprox(lattice.X_WO_goal));
  for (int pose = 0; pose < graph.num_poses(); ++pose) {
    for (int move = 0; move < graph.num_moves(); ++move) {
      const int to = graph.next(pose, move);
      if (to < 0) continue;
      EXPECT_EQ(graph.previous(to, move), pose);
      const Eigen::Vector3d step = graph.X_WO(to).translation() - graph.X_WO(pose).translation();
      EXPECT_LE(step.cwiseAbs().maxCoeff(), 0.0200001);
    }
  }
}

TEST(PoseGraph, ArcsOnTheOpenFloorShareTheirMechanics) {
  LatticeInstance instance(7);
  const PoseGraph& graph = instance.graph;
  for (int pose = 0; pose < graph.num_poses(); ++pose) {
    for (int move = 0; move < graph.num_moves(); ++move) {
      const int to = graph.next(pose, move), kind = graph.kind(pose, move);
      EXPECT_EQ(kind < 0, to < 0);
      if (to < 0) continue;
      // The mechanics of the arc's own last sample.
      const Eigen::Isometry3d X_WO = graph.X_WO(pose);
      const auto twist_O = screw_between(X_WO, graph.X_WO(to));
      const int instant =
          instance.context.instants.add(moving_state(along_screw(X_WO, twist_O, 5.0 / 6), twist_O));
      ASSERT_EQ(graph.instants(kind), std::vector<int>{instant});
      for (int l = 0; l < graph.locations.size(); l += 50) {
        EXPECT_NEAR(graph.displacement(graph.motion(pose, move), l),
                    sphere_speed(twist_O, graph.locations[l]) / 3, 1e-12);
      }
    }
  }
  EXPECT_EQ(graph.num_motions(), 9 * 26);
  EXPECT_LE(graph.num_kinds(), graph.num_motions());
}

}  // namespace
}  // namespace graspless::fingertip
