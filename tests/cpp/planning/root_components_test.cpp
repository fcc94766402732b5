// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/root_components.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace graspless::planning {
namespace {

TEST(RootComponents, JoinsEveryPairExactlyOnce) {
  RootComponents components;
  EXPECT_EQ(components.join({10, 20, 1, 2}), (std::vector<std::pair<int, int>>{{1, 2}}));
  EXPECT_TRUE(components.join({11, 21, 1, 2}).empty());
  EXPECT_EQ(components.join({30, 40, 3, 4}), (std::vector<std::pair<int, int>>{{3, 4}}));
  auto fresh = components.join({12, 41, 1, 4});  // now 1 and 3, 2 and 4 hang together
  std::sort(fresh.begin(), fresh.end());
  EXPECT_EQ(fresh, (std::vector<std::pair<int, int>>{{1, 4}, {3, 2}}));
}

TEST(RootComponents, RoutesCrossBridgesInTurn) {
  RootComponents components;
  components.join({10, 20, 1, 2});
  components.join({12, 41, 1, 4});
  components.join({30, 40, 3, 4});
  const auto route = components.route(3, 2);  // 3 - 4 - 1 - 2
  ASSERT_EQ(route.size(), 3u);
  EXPECT_EQ(route[0].start_root, 3);
  EXPECT_EQ(route[0].goal_root, 4);
  EXPECT_EQ(route[1].start_root, 1);
  EXPECT_EQ(route[1].goal_root, 4);
  EXPECT_EQ(route[2].goal_root, 2);
  EXPECT_TRUE(components.route(3, 99).empty());
}

}  // namespace
}  // namespace graspless::planning
