// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/lattice/bounds.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "fingertip/model/screw.hpp"
#include "fingertip/planner.hpp"

namespace graspless::fingertip {
namespace {

TEST(LatticeBounds, NeverBelowTheStabilityAndRefuseMuch) {
  const Eigen::Isometry3d X_WO(Eigen::Translation3d(0, 0, 0.025));
  const Problem problem{Object::box("block", {0.05, 0.06, 0.05}, 1), {}, {Plane{}}, {0.5, 0.5},
                        slide_path(X_WO, {0.1, 0, 0}, 10),           {}};
  Options options;
  options.locations_per_side = 4;
  SearchContext context(problem, options);
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<int> instants;
  for (int i = 0; i < 6; ++i) {
    mechanics::Vector6d twist_O;
    twist_O << normal(random), normal(random), 0, 0, 0, 20 * normal(random);
    instants.push_back(context.instants.add(moving_state(X_WO, twist_O)));
  }
  const PoseGraph graph(problem, std::get<Path>(problem.motion), context.locations,
                        context.instants, options);
  LatticeBounds bounds(graph, context.evaluators.front());
  int refused = 0, unstable = 0;
  for (int i = 0; i < 3000; ++i) {
    const auto any = [&] { return static_cast<int>(random() % context.locations.size()); };
    const int a = any(), b = any(), instant = instants[random() % instants.size()];
    if (!context.locations.are_apart(a, b)) continue;
    const Placement placement = with(with(kNoFingers, a), b);
    const double bound = bounds.bound(instant, placement);
    const double z = bounds.solve(instant, placement);
    if (z > 0) {
      EXPECT_GE(bound, z * (1 - 1e-6));
      EXPECT_GE(bounds.bound(instant, placement), z * (1 - 1e-6));
    }
    if (i < 1000 || z > 0) continue;
    ++unstable;
    if (bound < options.min_stability) ++refused;
  }
  // Once they have learnt, most programs without a solution need not be solved.
  EXPECT_GT(refused, unstable * 0.6);
}

}  // namespace
}  // namespace graspless::fingertip
