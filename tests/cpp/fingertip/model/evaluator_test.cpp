// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/model/evaluator.hpp"

#include <gtest/gtest.h>

#include "fingertip/cases.hpp"
#include "fingertip/instance.hpp"

namespace graspless::fingertip {
namespace {

TEST(Evaluator, BoundsWhatIsBelowTheStabilityNeeded) {
  Instance instance(slide_case(10, 2), Options{});
  const int at = instance.graph.instant(0, 0);
  int exact = 0, bounds = 0;
  for (int a = 0; a < instance.locations.size(); a += 3) {
    for (int b = a + 1; b < instance.locations.size(); b += 7) {
      if (!instance.locations.are_apart(a, b)) continue;
      const Placement placement{a, b, -1, -1};
      const double z = instance.evaluator.stability(at, placement);
      for (const double needed : {1.0, 3.0}) {
        Evaluator fresh(instance.instants, instance.locations, instance.options);
        const double found = fresh.stability(at, placement, needed);
        if (z >= needed) {
          EXPECT_NEAR(found, z, 1e-9);
          ++exact;
        } else {
          EXPECT_GE(found, z - 1e-9);
          EXPECT_LT(found, needed);
          bounds += found > z + 1e-6 ? 1 : 0;
        }
        EXPECT_NEAR(fresh.stability(at, placement), z, 1e-9);
      }
    }
  }
  EXPECT_GT(exact, 20);
  EXPECT_GT(bounds, 5);
}

}  // namespace
}  // namespace graspless::fingertip
