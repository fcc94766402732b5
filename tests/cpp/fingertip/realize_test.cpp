// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/fingertip/realize.hpp"

#include <gtest/gtest.h>

#include "fingertip/realize_plans.hpp"

namespace graspless::fingertip {
namespace {

TEST(FingertipRealize, TheWamTumblesABlock) {
  const BlockTumble given;
  const Plan plan = solved({displacement("tumble", given.path, given.pinch)});
  const robot::Robot& robot = wam_tips();
  const Realization result = realize(given.problem, plan, robot, t42(), robot.state("home"));
  ASSERT_TRUE(result) << result.reason;
  for (const auto& s : result.segments) printf("%s %zu\n", s.name.c_str(), s.positions.size());
}

}  // namespace
}  // namespace graspless::fingertip
