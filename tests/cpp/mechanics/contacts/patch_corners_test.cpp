// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/contacts/patch_corners.hpp"

#include <cmath>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace graspless::mechanics {
namespace {

using Eigen::Matrix2Xd;
using Eigen::Vector2d;

Matrix2Xd columns(const std::vector<Vector2d>& points) {
  Matrix2Xd matrix(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    matrix.col(i) = points[i];
  }
  return matrix;
}

TEST(PatchCorners, DropsInsideAndCollinear) {
  EXPECT_EQ(patch_corners(columns({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 1}}), 1e-9),
            (std::vector<int>{0, 2, 3, 5}));
}

TEST(PatchCorners, FewPoints) {
  EXPECT_TRUE(patch_corners(Matrix2Xd(2, 0), 1e-9).empty());
  EXPECT_EQ(patch_corners(columns({{3, 4}}), 1e-9), (std::vector<int>{0}));
  EXPECT_EQ(patch_corners(columns({{3, 4}, {3, 4}, {3, 4}}), 1e-9).size(), 1U);
  EXPECT_EQ(patch_corners(columns({{0, 1}, {0, 0}}), 1e-9), (std::vector<int>{0, 1}));
}

TEST(PatchCorners, LineWithNoiseKeepsItsEnds) {
  // Sorted by a coordinate that is noise, the ends would come in the middle.
  const Matrix2Xd line = columns({{0, 1}, {1e-17, 0}, {2e-17, 2}, {-1e-17, 0.5}});
  EXPECT_EQ(patch_corners(line, 1e-9), (std::vector<int>{1, 2}));
}

TEST(PatchCorners, ToleranceMergesWhatIsNear) {
  const Matrix2Xd points =
      columns({{0, 0}, {1, 0}, {1 + 1e-7, 1e-7}, {1, 1}, {0, 1}, {0.5, -1e-7}});
  EXPECT_EQ(patch_corners(points, 1e-6).size(), 4U);
  EXPECT_EQ(patch_corners(points, 1e-9).size(), 6U);
}

/// A point is a corner exactly when some direction has it as the only farthest one.
TEST(PatchCorners, AreThoseThatSupportALine) {
  std::mt19937 rng(3);
  std::uniform_int_distribution<int> grid(-3, 3);
  for (int trial = 0; trial < 200; ++trial) {
    std::set<std::pair<int, int>> distinct;
    while (distinct.size() < 8) distinct.emplace(grid(rng), grid(rng));
    std::vector<Vector2d> points;
    for (const auto& [x, y] : distinct) points.emplace_back(x, y);
    std::set<int> supporting;
    for (int k = 0; k < 3600; ++k) {
      const double angle = 2 * std::acos(-1.0) * (k + 0.5) / 3600;
      const Eigen::VectorXd far =
          columns(points).transpose() * Vector2d(std::cos(angle), std::sin(angle));
      Eigen::Index farthest = 0;
      far.maxCoeff(&farthest);
      supporting.insert(static_cast<int>(farthest));
    }
    EXPECT_EQ(patch_corners(columns(points), 1e-9),
              std::vector<int>(supporting.begin(), supporting.end()));
  }
}

}  // namespace
}  // namespace graspless::mechanics
