// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/lazy/growing.hpp"

#include <algorithm>
#include <numeric>
#include <queue>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace graspless::fingertip {
namespace {

TEST(Growing, KeepsItsValuesWhileItGrows) {
  Growing<int> values;
  EXPECT_TRUE(values.empty());
  for (int i = 0; i < 100'000; ++i) values.push_back(i);
  for (int i = 0; i < 100; ++i) values.push_back(values.front());  // which may move
  ASSERT_EQ(values.size(), 100'100U);
  for (std::size_t i = 0; i < 100'000; ++i) ASSERT_EQ(values[i], static_cast<int>(i));
  EXPECT_EQ(std::accumulate(values.begin() + 100'000, values.end(), 0), 0);
  values.pop_back();
  EXPECT_EQ(values.size(), 100'099U);
  const Growing<int> moved(std::move(values));
  EXPECT_EQ(moved.size(), 100'099U);
  EXPECT_EQ(moved.back(), 0);
}

TEST(Growing, IsTheContainerOfAQueue) {
  std::mt19937 rng(1);
  std::priority_queue<int> expected;
  std::priority_queue<int, Growing<int>> queue;
  for (int i = 0; i < 5000; ++i) {
    const int value = static_cast<int>(rng() % 1000);
    expected.push(value);
    queue.push(value);
  }
  for (; !expected.empty(); expected.pop(), queue.pop()) ASSERT_EQ(queue.top(), expected.top());
  EXPECT_TRUE(queue.empty());
}

}  // namespace
}  // namespace graspless::fingertip
