// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/path.hpp"

#include <gtest/gtest.h>

namespace graspless::planning {
namespace {

Eigen::VectorXd at(double x, double y) { return Eigen::Vector2d(x, y); }

/// Straight motions in the plane outside a disc.
std::optional<Path> around_disc(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  for (int i = 0; i <= 100; ++i) {
    if ((a + (b - a) * i / 100).norm() < 0.5) return std::nullopt;
  }
  return Path{a, b};
}

TEST(Shortcut, ShortensAndKeepsEndsAndConstraint) {
  Path detour{at(-1, 0), at(-1, 2), at(0, 2), at(1, 2), at(1, 0)};
  std::mt19937_64 rng(1);
  const Path shorter = shortcut(subdivided(detour, 0.1), around_disc, 400, rng);
  EXPECT_LT(length(shorter), 0.8 * length(detour));
  EXPECT_EQ(shorter.front(), detour.front());
  EXPECT_EQ(shorter.back(), detour.back());
  for (std::size_t i = 1; i < shorter.size(); ++i) {
    EXPECT_TRUE(around_disc(shorter[i - 1], shorter[i]));
  }
}

TEST(Shortcut, LeavesAPathWithoutShortcutsAlone) {
  const Path path{at(0, 0), at(1, 0), at(1, 1)};
  std::mt19937_64 rng(1);
  const Connect never = [](const auto&, const auto&) -> std::optional<Path> {
    return std::nullopt;
  };
  EXPECT_EQ(shortcut(path, never, 50, rng), path);
}

TEST(Shortcut, RefusesConfigurationsOfDifferentSizes) {
  const Path path{at(0, 0), Eigen::VectorXd::Zero(3), at(1, 1)};
  std::mt19937_64 rng(1);
  EXPECT_THROW(length(path), std::invalid_argument);
  EXPECT_THROW(shortcut(path, around_disc, 50, rng), std::invalid_argument);
}

TEST(Subdivided, StepsAreSmallAndOnTheWay) {
  const Path path{at(0, 0), at(1, 0.5), at(1, 0.5), at(0.9, 0.5)};
  const Path fine = subdivided(path, 0.05);
  EXPECT_NEAR(length(fine), length(path), 1e-12);
  for (std::size_t i = 1; i < fine.size(); ++i) {
    EXPECT_LE((fine[i] - fine[i - 1]).lpNorm<Eigen::Infinity>(), 0.05 + 1e-12);
  }
  EXPECT_TRUE(subdivided({}, 0.1).empty());
  for (const double step : {0.0, -1.0, std::nan(""), 1e-9})
    EXPECT_THROW(subdivided(path, step), std::invalid_argument) << step;
  EXPECT_THROW(subdivided(path, 0.1, Eigen::VectorXd::Ones(3)), std::invalid_argument);
  EXPECT_THROW(subdivided({at(0, 0), Eigen::VectorXd::Zero(3)}, 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace graspless::planning
