// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Items are taken once each, whatever the number of threads, and all have ended when a job has.
#include "crew.hpp"

#include <atomic>
#include <chrono>
#include <cstddef>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "graspless/watch.hpp"

namespace graspless {
namespace {

TEST(Crew, TakesEveryItemOnce) {
  for (const int threads : {1, 2, 5}) {
    Crew crew(threads);
    for (const std::size_t count : {0UL, 1UL, 3UL, 1000UL}) {
      std::vector<int> taken(count, 0);  // each entry by one thread
      crew.share(count, [&](std::size_t i) { ++taken[i]; });
      EXPECT_EQ(taken, std::vector<int>(count, 1)) << threads << " threads";
    }
  }
}

TEST(Crew, HelpersTakeItemsWhileTheOthersWork) {
  Crew crew(2);
  std::atomic<bool> taken{false};
  Crew::Job job(1, [&](std::size_t) { taken = true; });
  crew.start(job);
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!taken && std::chrono::steady_clock::now() < until) std::this_thread::yield();
  EXPECT_TRUE(taken);  // finish() has not been called
  crew.finish(job);
}

TEST(Crew, DoesAnotherJobMeanwhile) {
  for (const int threads : {1, 2, 3}) {
    Crew crew(threads);
    std::atomic<int> first{0}, second{0};
    Crew::Job job(50, [&](std::size_t) { ++first; });
    crew.start(job);
    crew.share(200, [&](std::size_t) { ++second; });
    EXPECT_EQ(second, 200);
    crew.finish(job);
    EXPECT_EQ(first, 50);
  }
}

TEST(Crew, AnExceptionEndsTheJobAlone) {
  for (const int threads : {1, 3}) {
    Crew crew(threads);
    std::atomic<int> count{0};
    const auto own = std::this_thread::get_id();
    const auto fail_at_ten = [&](std::size_t i) {
      if (i == 10) throw std::runtime_error("ten");
      ++count;
      while (i > 10 && std::this_thread::get_id() != own) poll();  // ended by the exception, too
    };
    EXPECT_THROW(crew.share(100000, fail_at_ten), std::runtime_error);
    if (threads == 1) {
      EXPECT_EQ(count, 10);
    }
    EXPECT_LT(count, 50000);  // far from all
    count = 0;
    crew.share(7, [&](std::size_t) { ++count; });
    EXPECT_EQ(count, 7);
  }
}

TEST(Crew, CancelWaitsForItemsUnderWay) {
  Crew crew(2);
  std::atomic<bool> begun{false}, ended{false};
  Crew::Job job(100000, [&](std::size_t) {
    begun = true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ended = true;
  });
  crew.start(job);
  while (!begun) std::this_thread::yield();
  crew.cancel(job);
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace graspless
