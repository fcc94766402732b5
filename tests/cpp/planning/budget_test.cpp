// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/budget.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

namespace graspless::planning {
namespace {

TEST(Budget, IterationsAreSpentExactly) {
  Budget budget;
  budget.iterations = 3;
  Clock clock(budget);
  int rounds = 0;
  while (clock.spend()) ++rounds;
  EXPECT_EQ(rounds, 3);
  EXPECT_EQ(clock.iterations(), 3);
  EXPECT_FALSE(clock.was_interrupted());
}

TEST(Budget, EndsByTheClock) {
  Budget budget;
  budget.seconds = 0.02;
  Clock clock(budget);
  while (clock.spend()) {
  }
  EXPECT_GE(clock.seconds(), 0.02);
}

TEST(Budget, EndsWhenInterrupted) {
  Budget budget;
  budget.seconds = std::numeric_limits<double>::infinity();
  int asked = 0;
  budget.interrupted = [&] { return ++asked == 2; };
  Clock clock(budget);
  while (clock.spend()) {
  }
  EXPECT_TRUE(clock.was_interrupted());
  EXPECT_EQ(asked, 2);
}

TEST(Budget, RefusesNonsense) {
  Budget budget;
  budget.seconds = 0;
  EXPECT_THROW(Clock{budget}, std::invalid_argument);
  budget.seconds = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(Clock{budget}, std::invalid_argument);
  budget.seconds = 1;
  budget.iterations = -1;
  EXPECT_THROW(Clock{budget}, std::invalid_argument);
}

}  // namespace
}  // namespace graspless::planning
