// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/lattice/space.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "fingertip/lattice/problem.hpp"
#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {
namespace {

TEST(LatticeSpace, MovesUndoEachOtherAndLeadWhereTheySay) {
  const Problem problem = lattice_problem();
  const Options options;
  Workshop workshop(problem, options);
  LatticeSpace space(workshop, std::get<Lattice>(problem.motion));
  EXPECT_TRUE(space.X_WO(space.start()).isApprox(std::get<Lattice>(problem.motion).X_WO_start));
  EXPECT_TRUE(space.X_WO(space.goal()).isApprox(std::get<Lattice>(problem.motion).X_WO_goal));
  for (int pose = 0; pose < space.num_poses(); ++pose) {
    for (int move = 0; move < LatticeSpace::kMoves; ++move) {
      const int to = space.next(pose, move);
      if (to < 0) continue;
      EXPECT_EQ(space.next(to, LatticeSpace::reverse(move)), pose);
      const Eigen::Vector3d step = space.X_WO(to).translation() - space.X_WO(pose).translation();
      EXPECT_LE(step.cwiseAbs().maxCoeff(), 0.0200001);
    }
  }
  for (int l = 0; l < workshop.locations.size(); ++l) {
    const Eigen::Vector3d center_W = space.X_WO(space.goal()) * workshop.locations[l].center_O;
    EXPECT_TRUE(space.center_W(space.goal(), l).isApprox(center_W, 1e-12));
  }
}

TEST(LatticeSpace, ArcsOnTheOpenFloorShareTheirMechanics) {
  const Problem problem = lattice_problem();
  const Options options;
  Workshop workshop(problem, options);
  LatticeSpace space(workshop, std::get<Lattice>(problem.motion));
  for (int pose = 0; pose < space.num_poses(); ++pose) {
    for (int move = 0; move < LatticeSpace::kMoves; ++move) {
      const int to = space.next(pose, move), kind = space.arc_kind(pose, move);
      EXPECT_EQ(kind < 0, to < 0);
      if (to < 0) continue;
      // What the arc's own last sample says.
      const Eigen::Isometry3d X_WO = space.X_WO(pose);
      const auto twist_O = screw_between(X_WO, space.X_WO(to));
      const int instant =
          workshop.instants.add(moving_state(along_screw(X_WO, twist_O, 5.0 / 6), twist_O));
      ASSERT_EQ(space.instants(kind), std::vector<int>{instant});
      for (int l = 0; l < workshop.locations.size(); l += 50) {
        EXPECT_NEAR(space.displacement(space.yaw(pose), move, l),
                    sphere_speed(twist_O, workshop.locations[l]), 1e-12);
      }
    }
  }
  EXPECT_LE(space.num_kinds(), space.num_yaws() * LatticeSpace::kMoves);
}

}  // namespace
}  // namespace graspless::fingertip
