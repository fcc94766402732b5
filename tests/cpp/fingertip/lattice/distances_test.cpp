// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/lattice/distances.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "fingertip/lattice/problem.hpp"

namespace graspless::fingertip {
namespace {

TEST(LatticeDistances, AreTheLeastOverNeighbours) {
  const Problem problem = lattice_problem();
  Options options;
  options.locations_per_side = 3;
  Workshop workshop(problem, options);
  LatticeSpace space(workshop, std::get<Lattice>(problem.motion));
  LatticeDistances distances(space, workshop.locations);
  for (int l = 0; l < workshop.locations.size(); ++l) {
    const double* to_goal = distances.to_goal(l, std::numeric_limits<double>::infinity());
    EXPECT_EQ(to_goal[space.goal()], 0);
    for (int pose = 0; pose < space.num_poses(); ++pose) {
      const double straight = (space.center_W(pose, l) - space.center_W(space.goal(), l)).norm();
      EXPECT_GE(to_goal[pose], straight * (1 - 1e-9));
      if (pose == space.goal()) continue;
      double least = std::numeric_limits<double>::infinity();
      for (int move = 0; move < LatticeSpace::kMoves; ++move) {
        const int to = space.next(pose, move);
        if (to < 0) continue;
        least = std::min(least, space.displacement(space.yaw(pose), move, l) + to_goal[to]);
      }
      EXPECT_NEAR(to_goal[pose], least, 1e-12);
    }
  }
}

TEST(LatticeDistances, ALimitLeavesOutOnlyWhatCannotBeOnTheWay) {
  const Problem problem = lattice_problem();
  Options options;
  options.locations_per_side = 2;
  Workshop workshop(problem, options);
  LatticeSpace space(workshop, std::get<Lattice>(problem.motion));
  LatticeDistances all(space, workshop.locations), limited(space, workshop.locations);
  int left_out = 0;
  for (int l = 0; l < workshop.locations.size(); ++l) {
    const double* exact = all.to_goal(l, std::numeric_limits<double>::infinity());
    const double limit = exact[space.start()] * 1.1;
    const double* some = limited.to_goal(l, limit);
    for (int pose = 0; pose < space.num_poses(); ++pose) {
      if (some[pose] < std::numeric_limits<double>::infinity()) {
        EXPECT_NEAR(some[pose], exact[pose], 1e-12);
        continue;
      }
      ++left_out;
      const double before = (space.center_W(pose, l) - space.center_W(space.start(), l)).norm();
      EXPECT_GE(before + exact[pose], limit * (1 - 1e-9));
    }
    // Locations one above the other share a table, so that the first limit holds for all of them.
    if (l > 0) break;
  }
  EXPECT_GT(left_out, 0);
}

}  // namespace
}  // namespace graspless::fingertip
