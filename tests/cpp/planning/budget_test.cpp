// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/budget.hpp"

#include <limits>
#include <new>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "graspless/watch.hpp"

namespace graspless::planning {
namespace {

TEST(Budget, IterationsAreSpentExactly) {
  Budget budget;
  budget.iterations = 3;
  Clock clock(budget);
  int rounds = 0;
  while (!clock.ran_out() && clock.spend()) ++rounds;
  EXPECT_EQ(rounds, 3);
  EXPECT_EQ(clock.iterations(), 3);
  EXPECT_EQ(clock.note(), "");
  EXPECT_TRUE(clock.ran_out());
  EXPECT_FALSE(clock.is_out());
  EXPECT_FALSE(clock.was_interrupted());
}

TEST(Budget, EndsByTheClock) {
  Budget budget;
  budget.seconds = 0.02;
  Clock clock(budget);
  while (clock.spend()) {
  }
  EXPECT_GE(clock.seconds(), 0.02);
  EXPECT_EQ(clock.note(), "; the time limit ended the search");
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
  EXPECT_EQ(clock.note(), "");
  EXPECT_EQ(asked, 2);
}

TEST(Budget, EndsWorkThatOnlyPolls) {
  Budget budget;
  budget.seconds = 0.01;
  Clock clock(budget);
  EXPECT_FALSE(clock.run([] {
    for (;;) poll();
  }));
  EXPECT_GE(clock.seconds(), 0.01);
  EXPECT_EQ(clock.reason(), "the time was over before the search could begin or end");
}

TEST(Budget, PassesOnWhatAWatchOfTheCallerStops) {
  Clock clock(Budget{});
  const Watch watch([] { throw Stop{}; });
  EXPECT_THROW(clock.run([] {
    for (;;) poll();
  }),
               Stop);
}

TEST(Budget, TheTimeEndsNoSearchWhoseIterationsAreSpent) {
  Budget budget;
  budget.seconds = 0.02;
  budget.iterations = 2;
  Clock clock(budget);
  while (clock.spend()) {
  }
  while (!clock.is_out()) {
  }
  EXPECT_EQ(clock.note(), "");
}

TEST(Budget, GivesMoreTimeToWhatConcludes) {
  const auto endless = [] {
    for (;;) poll();
  };
  Budget budget;
  budget.seconds = 0.01;
  Clock clock(budget);
  EXPECT_TRUE(clock.run([&] { EXPECT_FALSE(clock.conclude(endless)); }));  // within a search
  EXPECT_GE(clock.seconds(), budget.seconds + 0.04);
}

TEST(Budget, GivesTimeInProportionToTheRows) {
  Budget budget;
  budget.seconds = 0.01;
  Clock clock(budget);
  EXPECT_TRUE(clock.run([&] {
    while (!clock.is_out()) poll();
    const auto slow = [&] {
      while (clock.seconds() < 0.2) poll();
    };
    EXPECT_TRUE(clock.conclude(slow, 100));
    announce_memory(2e6);  // checks at once: the search may end in order
  }));
  EXPECT_FALSE(clock.conclude(
      [] {
        for (;;) poll();
      },
      10));
  EXPECT_GE(clock.seconds(), 0.2 + 0.04 + 0.1);
}

TEST(Budget, SignalsEndWhatConcludes) {
  Budget budget;
  budget.seconds = 0.01;
  bool signal = false;
  budget.interrupted = [&] { return signal; };
  Clock clock(budget);
  while (!clock.is_out()) {
  }
  const auto endless = [&] {
    for (;;) {
      signal = clock.seconds() > 0.1;
      poll();
    }
  };
  EXPECT_FALSE(clock.conclude(endless, 1'000'000));
  EXPECT_TRUE(clock.was_interrupted());
  EXPECT_GE(clock.seconds(), 0.1);
}

TEST(Budget, MemoryEndsWhatConcludes) {
  Budget budget;
  budget.seconds = 0.01;
  Clock clock(budget, 1e6);
  while (!clock.is_out()) {
  }
  EXPECT_FALSE(clock.conclude([] { announce_memory(1e9); }, 1'000'000));
  EXPECT_TRUE(clock.is_out_of_memory());
}

TEST(Budget, LetsWorkEndInOrderFirst) {
  Budget budget;
  budget.seconds = 0.01;
  Clock clock(budget);
  bool ended_in_order = false;
  EXPECT_TRUE(clock.run([&] {
    while (!clock.is_out()) poll();
    ended_in_order = true;
  }));
  EXPECT_TRUE(ended_in_order);
}

TEST(Budget, InnerWorkLeavesTimeToConclude) {
  Budget budget;
  budget.seconds = 0.01;
  Clock clock(budget);
  bool concluded = false;
  EXPECT_TRUE(clock.run([&] {
    EXPECT_FALSE(clock.run([] {
      for (;;) poll();
    }));
    poll();
    concluded = true;
  }));
  EXPECT_TRUE(concluded);
}

TEST(Budget, EndsWorkThatGrows) {
  Clock clock(Budget{}, 1e6);
  std::vector<std::vector<char>> grown;
  EXPECT_FALSE(clock.run([&] {
    for (int i = 0; i < 2000; ++i) {
      grown.emplace_back(1 << 20, 1);
      poll();
    }
  }));
  EXPECT_TRUE(clock.is_out_of_memory());
  EXPECT_TRUE(clock.is_out());
  EXPECT_EQ(clock.reason(), "the search needs more memory than options.max_memory = 1 MB");
}

TEST(Budget, EndsWorkBeforeItGrowsInOneStep) {
  Clock clock(Budget{}, 1e6);
  bool has_room = false, has_grown = false;
  EXPECT_FALSE(clock.run([&] {
    poll();  // the next look at the memory is not due for milliseconds
    announce_memory(1e5);
    has_room = true;
    announce_memory(1e9);
    has_grown = true;
  }));
  EXPECT_TRUE(has_room);
  EXPECT_FALSE(has_grown);
  EXPECT_TRUE(clock.is_out_of_memory());
  EXPECT_EQ(announced_memory(), 0);
}

TEST(Budget, TakesAFailedAllocationForTheLimit) {
  Clock clock(Budget{});
  EXPECT_FALSE(clock.run([] { throw std::bad_alloc(); }));
  EXPECT_TRUE(clock.is_out_of_memory());
  EXPECT_FALSE(clock.was_interrupted());
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
