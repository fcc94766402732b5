// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/lazy/displacements.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "fingertip/cases.hpp"
#include "fingertip/instance.hpp"

namespace graspless::fingertip {
namespace {

TEST(Displacements, AddUpToTheWholePathFromEveryPose) {
  const Instance instance(tumble_case(true), Options{});
  const Displacements displacements(instance.graph);
  const int K = instance.graph.num_arcs();
  for (int l = 0; l < instance.locations.size(); ++l) {
    const double whole = displacements.before(l)[K];
    EXPECT_EQ(displacements.before(l)[0], 0);
    EXPECT_EQ(displacements.after(l)[K], 0);
    for (int pose = 0; pose <= K; ++pose) {
      const double sum = displacements.before(l)[pose] + displacements.after(l)[pose];
      if (whole < kInfinity) {
        EXPECT_NEAR(sum, whole, 1e-9);
      } else {
        EXPECT_EQ(sum, kInfinity);
      }
    }
    EXPECT_LE(displacements.least_arc(l) * K, whole);
    EXPECT_LE(displacements.least_whole(), whole);
  }
  EXPECT_LE(displacements.least(), displacements.least_whole());
}

TEST(Displacements, AreThoseOfTheFingerThatMovesFarthest) {
  Instance instance(tumble_case(false), Options{});
  instance.graph.block(4, 7);
  const Displacements displacements(instance.graph);
  EXPECT_EQ(displacements.before(7)[3], 3 * 3 * displacements.in_part(0, {7, -1, -1, -1}));
  EXPECT_EQ(displacements.before(7)[4], kInfinity);
  EXPECT_EQ(displacements.after(7)[4], kInfinity);
  for (const int other : {20, 100, 200}) {
    const double both = displacements.in_part(9, {7, other, -1, -1});
    EXPECT_EQ(both, std::max(displacements.in_part(9, {7, -1, -1, -1}),
                             displacements.in_part(9, {other, -1, -1, -1})));
  }
}

}  // namespace
}  // namespace graspless::fingertip
