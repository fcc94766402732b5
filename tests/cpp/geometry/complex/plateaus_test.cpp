// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/complex/plateaus.hpp"

#include <gtest/gtest.h>

namespace graspless::geometry {
namespace {

TEST(Plateaus, LieBetweenTheEndsOfLastingPairs) {
  const auto found = plateaus({{1, 8}, {2, 3}, {4, 4.1}}, 1.12);
  ASSERT_EQ(found.size(), 3u);  // widest ratio first
  EXPECT_EQ(found[0].lower, 3);
  EXPECT_EQ(found[0].upper, 8);
  EXPECT_EQ(found[0].loops, 1);
  EXPECT_EQ(found[1].lower, 1);
  EXPECT_EQ(found[1].loops, 1);
  EXPECT_EQ(found[2].lower, 2);
  EXPECT_EQ(found[2].loops, 2);
  EXPECT_EQ(plateaus({{1, 8}, {2, 3}, {4, 4.1}}, 1).size(), 5u);
  EXPECT_TRUE(plateaus({}, 1.12).empty());
}

TEST(Plateaus, LeaveOutWhereNothingLives) {
  const auto found = plateaus({{1, 2}, {5, 6}}, 1.12);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].upper, 2);
  EXPECT_EQ(found[1].lower, 5);
}

TEST(EdgeLength, IsALittleAboveTheLowerEnd) {
  EXPECT_DOUBLE_EQ(edge_length_on({2, 8, 1}, {{2, 8}, {1, 0}}), 2.1);
  // A plateau with less room: its middle.
  EXPECT_DOUBLE_EQ(edge_length_on({1, 1.0404, 1}, {{1, 1.0404}, {1, 0}}), 1.02);
}

TEST(EdgeLength, AvoidsWhereOthersLive) {
  // A second, short-lived loop from 2 to 2.2.
  EXPECT_DOUBLE_EQ(edge_length_on({2, 8, 1}, {{1, 2.2, 8}, {2, 1, 0}}), 2.2 * 1.05);
  // Nowhere alone: near the lower end all the same.
  EXPECT_DOUBLE_EQ(edge_length_on({2, 8, 1}, {{1, 8}, {2, 0}}), 2.1);
}

}  // namespace
}  // namespace graspless::geometry
