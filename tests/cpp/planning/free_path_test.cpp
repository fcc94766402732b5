// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/free_path.hpp"

#include <gtest/gtest.h>

namespace graspless::planning {
namespace {

/// The unit square with a wall that leaves a gap at the top.
FreeSpace walled() {
  FreeSpace space;
  space.lower = Eigen::Vector2d(0, 0);
  space.upper = Eigen::Vector2d(1, 1);
  space.is_free = [](const Eigen::VectorXd& q) {
    return std::abs(q[0] - 0.5) > 0.05 || q[1] > 0.9;
  };
  space.is_motion_free = [is_free = space.is_free](const Eigen::VectorXd& a,
                                                   const Eigen::VectorXd& b) {
    for (int i = 0; i <= 200; ++i) {
      if (!is_free(a + (b - a) * i / 200)) return false;
    }
    return true;
  };
  space.is_out = [] { return false; };
  return space;
}

TEST(FindFreePath, GoesStraightWhereItCan) {
  std::mt19937_64 rng(1);
  const auto path =
      find_free_path(walled(), Eigen::Vector2d(0.1, 0.1), Eigen::Vector2d(0.1, 0.9), 0, rng);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->size(), 2u);
}

TEST(FindFreePath, FindsTheGap) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937_64 rng(seed);
    const Eigen::Vector2d from(0.1, 0.1), to(0.9, 0.1);
    EXPECT_FALSE(find_free_path(walled(), from, to, 0, rng));
    const auto path = find_free_path(walled(), from, to, 5000, rng);
    ASSERT_TRUE(path) << "seed " << seed;
    EXPECT_EQ(path->front(), Eigen::VectorXd(from));
    EXPECT_EQ(path->back(), Eigen::VectorXd(to));
    for (std::size_t i = 1; i < path->size(); ++i) {
      EXPECT_TRUE(walled().is_motion_free((*path)[i - 1], (*path)[i]));
    }
  }
}

TEST(FindFreePath, TestsItsEndsOnce) {
  FreeSpace space = walled();
  const Eigen::Vector2d from(0.1, 0.1), to(0.9, 0.1);
  int tested = 0;
  space.is_free = [&, is_free = space.is_free](const Eigen::VectorXd& q) {
    return q == from || q == to ? ++tested <= 2 : is_free(q);
  };
  std::mt19937_64 rng(1);
  EXPECT_TRUE(find_free_path(space, from, to, 5000, rng));
}

TEST(FindFreePath, EndsWhenTimeIsOutOrAnEndIsTaken) {
  std::mt19937_64 rng(1);
  FreeSpace space = walled();
  EXPECT_FALSE(
      find_free_path(space, Eigen::Vector2d(0.1, 0.1), Eigen::Vector2d(0.5, 0.1), 5000, rng));
  space.is_out = [] { return true; };
  EXPECT_FALSE(
      find_free_path(space, Eigen::Vector2d(0.1, 0.1), Eigen::Vector2d(0.9, 0.1), 5000, rng));
}

}  // namespace
}  // namespace graspless::planning
