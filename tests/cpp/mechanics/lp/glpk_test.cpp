// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/lp/glpk.hpp"

#include <gtest/gtest.h>

#include "mechanics/lp/program.hpp"

namespace graspless::mechanics {
namespace {

/// What solve_lp() never lets through ends the process in GLPK itself. Here it is a false.
TEST(Glpk, AFatalErrorIsCaught) {
  LinearProgram twice;
  twice.add_variable(0, 1, 1);
  twice.add_row(0, 1);
  twice.set(0, 0, 1);
  twice.set(0, 0, 2);
  LinearProgram outside = twice;
  outside.entries = {{7, 0, 1.0}};
  LpBasis basis;
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(find_basis(twice, GlpkMethod{}, &basis));
    EXPECT_FALSE(find_basis(outside, GlpkMethod{}, &basis));
  }
  LinearProgram good = twice;
  good.entries.pop_back();
  EXPECT_EQ(solve_lp(good).objective, 1);  // and GLPK still works
}

}  // namespace
}  // namespace graspless::mechanics
