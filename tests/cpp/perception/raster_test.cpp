// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/raster.hpp"

#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "perception/contour.hpp"

namespace graspless::perception {
namespace {

Raster random_mask(int size, double share, std::uint64_t seed) {
  Raster mask({0, 0}, 1, size, size);
  std::mt19937_64 rng(seed);
  std::bernoulli_distribution draw(share);
  for (auto& value : mask.values) value = draw(rng);
  return mask;
}

std::size_t count(const Raster& mask) {
  return static_cast<std::size_t>(std::count(mask.values.begin(), mask.values.end(), 1));
}

/// Labels by flooding, one cell after the other.
std::size_t flood(const Raster& mask, bool is_diagonal) {
  Raster left = mask;
  std::size_t pieces = 0;
  for (int y = 0; y < mask.ny; ++y) {
    for (int x = 0; x < mask.nx; ++x) {
      if (!left.at(x, y)) continue;
      ++pieces;
      std::vector<std::pair<int, int>> open{{x, y}};
      left.values[left.index(x, y)] = 0;
      while (!open.empty()) {
        const auto [a, b] = open.back();
        open.pop_back();
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            if ((dx != 0 && dy != 0 && !is_diagonal) || !left.at(a + dx, b + dy)) continue;
            left.values[left.index(a + dx, b + dy)] = 0;
            open.emplace_back(a + dx, b + dy);
          }
        }
      }
    }
  }
  return pieces;
}

TEST(Raster, PiecesAreThoseOfAFlood) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Raster mask = random_mask(25, 0.3 + 0.02 * static_cast<double>(seed), seed);
    for (const bool is_diagonal : {false, true}) {
      const Pieces pieces = pieces_of(mask, is_diagonal);
      EXPECT_EQ(pieces.size.size(), flood(mask, is_diagonal));
      std::size_t sum = 0;
      for (const std::size_t size : pieces.size) sum += size;
      EXPECT_EQ(sum, count(mask));
    }
  }
}

TEST(Raster, TheBoundaryEnclosesExactlyTheMask) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Raster mask = random_mask(24, 0.62, seed);
    keep_largest(mask);
    const auto steps = boundary_of(mask);
    double doubled = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const Step &a = steps[i], &b = steps[(i + 1) % steps.size()];
      EXPECT_EQ(std::abs(a.x - b.x) + std::abs(a.y - b.y), 1);
      EXPECT_EQ(mask.at(a.in_x, a.in_y), 1);
      EXPECT_EQ(mask.at(a.in_x + a.out_x, a.in_y + a.out_y), 0);
      doubled += a.x * b.y - a.y * b.x;
    }
    EXPECT_EQ(doubled, 2.0 * static_cast<double>(count(mask)));
    // It is simple: a polygon without tolerance has the same area.
    EXPECT_NEAR(simple_polygon(mask, steps, 0).area(), static_cast<double>(count(mask)), 1e-9);
  }
}

TEST(Raster, SimplifiedBoundariesStayWithinTheTolerance) {
  Raster disc({-1, -1}, 0.01, 200, 200);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) disc.values[disc.index(x, y)] = disc.center(x, y).norm() < 0.8;
  }
  const auto steps = boundary_of(disc);
  const auto polygon = simple_polygon(disc, steps, 0.03);
  EXPECT_LT(polygon.size(), 40);
  for (const auto& p : polygon.vertices().colwise()) EXPECT_NEAR(p.norm(), 0.8, 0.015);
  EXPECT_NEAR(polygon.area(), 3.14159 * 0.64, 0.1);
}

TEST(Raster, FittedEdgesOfATurnedSquareAreStraightAndKeepTheirLabels) {
  Raster square({-1, -1}, 0.01, 200, 200);
  const Eigen::Rotation2Dd turn(0.3);
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) {
      const Eigen::Vector2d p = turn.inverse() * square.center(x, y);
      square.values[square.index(x, y)] = p.cwiseAbs().maxCoeff() < 0.5;
    }
  }
  const auto steps = boundary_of(square);
  std::vector<EdgeLabel> labels;
  for (const Step& step : steps) {
    const Eigen::Vector2d p = turn.inverse() * square.center(step.in_x, step.in_y);
    labels.push_back(p.x() > 0.48 ? EdgeLabel::occluded : EdgeLabel::real);
  }
  const LabelledPolygon fitted = fitted_polygon(square, steps, labels, 0.02, 0.05);
  ASSERT_EQ(fitted.labels.size(), static_cast<std::size_t>(fitted.polygon.size()));
  double occluded = 0;
  for (int i = 0; i < fitted.polygon.size(); ++i) {
    const auto edge = fitted.polygon.edge(i);
    const Eigen::Vector2d a = turn.inverse() * edge.a, b = turn.inverse() * edge.b;
    EXPECT_NEAR(std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff()), 0.5, 0.01);
    if (fitted.labels[i] == EdgeLabel::occluded) occluded += (b - a).norm();
  }
  EXPECT_NEAR(occluded, 1, 0.06);
  EXPECT_NEAR(fitted.polygon.area(), 1, 0.01);
}

TEST(Raster, StripsAreClearedAndCornersKept) {
  for (const double angle : {0.0, 0.3, M_PI / 4}) {
    Raster square({0, 0}, 1, 120, 120);
    for (int y = 0; y < 120; ++y) {
      for (int x = 0; x < 120; ++x) {
        const Eigen::Vector2d p =
            Eigen::Rotation2Dd(angle) * (square.center(x, y) - Eigen::Vector2d(60, 60));
        square.values[square.index(x, y)] = p.cwiseAbs().maxCoeff() < 30;
      }
    }
    Raster opened = square;
    clear_strips(opened, 5);
    EXPECT_EQ(opened.values, square.values);
    Raster with_strip = square;  // eight cells wide, from the square to the border
    for (int y = 56; y < 64; ++y) {
      for (int x = 60; x < 120; ++x) with_strip.values[with_strip.index(x, y)] = 1;
    }
    clear_strips(with_strip, 5);
    for (int x = 112; x < 120; ++x) EXPECT_EQ(with_strip.at(x, 60), 0);
    EXPECT_LE(count(with_strip), count(square) + 8 * 10);
    EXPECT_GE(count(with_strip), count(square));
  }
}

}  // namespace
}  // namespace graspless::perception
