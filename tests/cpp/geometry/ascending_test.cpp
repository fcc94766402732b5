// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/ascending.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace graspless::geometry {
namespace {

std::vector<int> by_comparisons(const std::vector<double>& numbers) {
  std::vector<int> order(numbers.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return numbers[a] < numbers[b]; });
  return order;
}

TEST(Ascending, IsTheOrderOfAStableSort) {
  std::mt19937_64 rng(1);
  std::normal_distribution<double> normal;
  for (const std::size_t count : {0u, 1u, 2u, 100u, 5000u}) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i)
      numbers.push_back(normal(rng) * std::pow(10, 6 * normal(rng)));
    EXPECT_EQ(ascending(numbers), by_comparisons(numbers));
    for (double& number : numbers) number = std::round(4 * normal(rng));  // many equal ones
    EXPECT_EQ(ascending(numbers), by_comparisons(numbers));
  }
}

TEST(Ascending, TakesEveryKindOfNumber) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<double> numbers{0.0,        -0.0,  5e-324, -5e-324, kInfinity,
                                    -kInfinity, 1e308, -1e308, 0.0,     -0.0};
  EXPECT_EQ(ascending(numbers), by_comparisons(numbers));
  EXPECT_EQ(ascending(std::vector<double>(300, 2.5)), by_comparisons(std::vector<double>(300)));
}

}  // namespace
}  // namespace graspless::geometry
