// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/resolution.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "graspless/geometry/loops.hpp"
#include "graspless/geometry/sampling.hpp"
#include "graspless/geometry/shape.hpp"

#include "geometry/clouds.hpp"

namespace graspless::geometry {
namespace {

using Eigen::Vector3d;

constexpr double kRadius = 0.01;  // of the bars of a frame [m]

struct Bar {
  Vector3d a, b;
};

PlacedShape capsule(const Bar& bar) {
  PlacedShape placed{Capsule{kRadius, (bar.b - bar.a).norm()}};
  placed.X_BG.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), bar.b - bar.a).toRotationMatrix();
  placed.X_BG.translation() = (bar.a + bar.b) / 2;
  return placed;
}

Eigen::Matrix3Xd cloud_of(const std::vector<Bar>& bars, int count) {
  std::vector<PlacedShape> shapes;
  for (const Bar& bar : bars) shapes.push_back(capsule(bar));
  return sample_surface(shapes, count);
}

/// Distance of a point from the material of the bars [m].
double distance(const std::vector<Bar>& bars, const Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Bar& bar : bars) {
    const Vector3d along = bar.b - bar.a;
    const double at = std::clamp(along.dot(p - bar.a) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - bar.a - at * along).norm() - kRadius);
  }
  return std::max(least, 0.0);
}

/// Largest distance of a loop from the material of the bars [m].
double farthest(const std::vector<Bar>& bars, const Loop& loop) {
  double farthest = 0;
  for (Eigen::Index i = 0; i < loop.points.cols(); ++i) {
    const Vector3d a = loop.points.col(i), b = loop.points.col((i + 1) % loop.points.cols());
    for (const double t : {0.25, 0.5, 0.75})
      farthest = std::max(farthest, distance(bars, a + t * (b - a)));
  }
  return farthest;
}

/// A frame of bars with slots 8 and 16 cm wide beside a hole of 50 cm.
std::vector<Bar> slotted_frame() {
  const double x[] = {0, 0.1, 0.28, 0.8}, height = 0.5;
  std::vector<Bar> bars{{{0, 0, 0}, {x[3], 0, 0}}, {{0, 0, height}, {x[3], 0, height}}};
  for (const double at : x) bars.push_back({{at, 0, 0}, {at, 0, height}});
  return bars;
}

TEST(Resolution, SlotsThatKFillsAreOpen) {
  const std::vector<Bar> bars = slotted_frame();
  const Eigen::Matrix3Xd cloud = cloud_of(bars, 2000);
  const double step = spacing(cloud);
  LoopOptions options;
  options.max_edge_length = 0.2;
  const Loops found = shortest_loops(cloud, options);
  ASSERT_EQ(found.found.size(), 1u);  // the slots are filled
  const auto middle = [&](const Complex& complex, const Eigen::Vector3i& corners) {
    return Vector3d(complex.points(Eigen::all, corners).rowwise().mean());
  };
  double most = 0;
  for (const auto& corners : found.complex.triangles.colwise())
    most = std::max(most, distance(bars, middle(found.complex, corners)));
  EXPECT_GT(most, 0.05);
  ASSERT_GT(found.surface.triangles.cols(), 3000);
  for (const auto& corners : found.surface.triangles.colwise())
    EXPECT_LT(distance(bars, middle(found.surface, corners)), 1.5 * step);
  EXPECT_LT(farthest(bars, found.found[0]), step);
  EXPECT_EQ(found.found[0].gap, 0);
  EXPECT_TRUE(found.warnings.empty());
  EXPECT_NEAR(found.found[0].thickness, 2 * kRadius, 0.003);
  EXPECT_NEAR(found.found[0].length, 2 * (0.5 + 0.5), 0.1);
}

TEST(Resolution, PolishedLoopsOfLargeCloudsStayOnTheMaterial) {
  const std::vector<Bar> bars = slotted_frame();
  const Eigen::Matrix3Xd cloud = cloud_of(bars, 6000);
  LoopOptions options;
  options.max_edge_length = 0.2;
  options.polish = true;
  const Loops found = shortest_loops(cloud, options);
  ASSERT_EQ(found.found.size(), 1u);
  EXPECT_LT(farthest(bars, found.found[0]), spacing(found.surface.points));
}

TEST(Resolution, LoopAcrossAnOpeningTellsItsGap) {
  // A square frame whose lower bar is missing but for its ends.
  const std::vector<Bar> bars{{{0.1, 0, 0}, {0, 0, 0}},
                              {{0, 0, 0}, {0, 0, 0.4}},
                              {{0, 0, 0.4}, {0.4, 0, 0.4}},
                              {{0.4, 0, 0.4}, {0.4, 0, 0}},
                              {{0.4, 0, 0}, {0.3, 0, 0}}};
  LoopOptions options;
  options.max_edge_length = 0.25;
  const Loops found = shortest_loops(cloud_of(bars, 1500), options);
  EXPECT_TRUE(found.found.empty());
  ASSERT_EQ(found.uncertain.size(), 1u);
  EXPECT_NEAR(found.uncertain[0].gap, 0.2 - 2 * kRadius, 0.02);
  EXPECT_NE(found.uncertain[0].reason.find("it closes across a gap of 0.1"), std::string::npos);
}

TEST(Resolution, EvenAndNoisyCloudsKeepTheirSurfaceAndLoops) {
  for (const double noise : {0.0, 0.002}) {
    const Eigen::Matrix3Xd cloud = noisy(torus(0.1, 0.012, 0.008), noise, 1);
    const Loops found = shortest_loops(cloud);
    ASSERT_EQ(found.found.size(), 1u);
    EXPECT_EQ(found.found[0].gap, 0);
    EXPECT_GE(found.surface.triangles.cols(), 2 * cloud.cols());  // as many as a closed one has
    EXPECT_LE(found.surface.triangles.cols(), found.complex.triangles.cols());
  }
}

TEST(Resolution, FarPointsAreAlone) {
  Eigen::Matrix3Xd cloud = torus(0.1, 0.012, 0.008);
  cloud.conservativeResize(3, cloud.cols() + 1);
  cloud.rightCols(1) << 0, 0, 0.06;
  LoopOptions options;
  options.max_edge_length = 0.15;
  const Complex complex = Filtration(cloud).complex(options.max_edge_length);
  const Complex surface = surface_of(complex, Resolution(complex));
  const int last = static_cast<int>(cloud.cols()) - 1;
  EXPECT_TRUE((complex.edges.row(1).array() == last).any());
  EXPECT_FALSE((surface.edges.array() == last).any());
  EXPECT_FALSE((surface.triangles.array() == last).any());
  EXPECT_EQ(surface.points, cloud);
}

}  // namespace
}  // namespace graspless::geometry
