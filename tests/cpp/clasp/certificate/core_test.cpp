// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/certificate/core.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "graspless/clasp/object.hpp"
#include "graspless/geometry/linking.hpp"

#include "clasp/ring_problem.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// A square that goes once through the hole of a ring about the x axis.
Matrix3Xd through_hole(double size) {
  Matrix3Xd square(3, 4);
  square << -size, size, size, -size, 0, 0, size, size, 0, 0, size, size;
  return square;
}

const geometry::Complex& complex_of(const Object& object) { return object.loops().complex; }

TEST(Core, OfARingIsAsThickAsItsPolygons) {
  for (const double thickness : {0.01, 0.02, 0.04}) {
    for (const int across : {8, 12}) {
      // As many rows as make the facets about square.
      const int round = static_cast<int>(across * 2 * 0.12 / thickness);
      const Object ring = Object::from_cloud("ring", ring_cloud(0.12, thickness, round, across));
      const CoreLoop core = Core(complex_of(ring)).loop(through_hole(0.3));
      // Consecutive rows are turned by half a side.
      EXPECT_LT(core.radius, thickness / 2 * std::cos(M_PI / across)) << thickness;
      EXPECT_GT(core.radius, 0.9 * thickness / 2 * std::cos(M_PI / across)) << thickness;
      EXPECT_EQ(std::abs(geometry::linking_number(core.points, through_hole(0.3))), 1);
    }
  }
}

TEST(Core, ContainsWhatLiesInTheTorus) {
  const Object ring = Object::from_cloud("ring", ring_cloud(0.12, 0.04, 72, 12));
  const Core core(complex_of(ring));
  std::mt19937_64 rng(2);
  std::uniform_real_distribution<double> place(-0.16, 0.16);
  int inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vector3d p(place(rng) / 4, place(rng), place(rng));
    const double away = std::hypot(std::hypot(p.y(), p.z()) - 0.12, p.x());
    if (away < 0.018) {
      EXPECT_TRUE(core.contains(p)) << p.transpose();
      ++inside;
    } else if (away > 0.03) {  // across the inner side, edges up to d long bridge the hollow
      EXPECT_FALSE(core.contains(p)) << p.transpose();
    }
  }
  EXPECT_GT(inside, 200);
}

/// The ball about every point of the loop lies in the material.
TEST(Core, BallsAlongTheLoopLieInside) {
  const Object ring = Object::from_cloud("ring", ring_cloud(0.12, 0.03, 50, 9));
  const Core core(complex_of(ring));
  const CoreLoop loop = core.loop(through_hole(0.3));
  ASSERT_GT(loop.radius, 0.012);
  std::mt19937_64 rng(2);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> unit(0, 1);
  for (Eigen::Index i = 0; i < loop.points.cols(); ++i) {
    const Vector3d next = loop.points.col((i + 1) % loop.points.cols());
    for (int k = 0; k < 20; ++k) {
      const Vector3d at = loop.points.col(i) + unit(rng) * (next - loop.points.col(i));
      const Vector3d out = Vector3d(normal(rng), normal(rng), normal(rng)).normalized();
      EXPECT_TRUE(core.contains(at + 0.999 * loop.radius * out));
    }
  }
}

TEST(Core, ACurveThatIsNotLinkedHasNoLoop) {
  const Object ring = Object::from_cloud("ring", ring_cloud(0.12, 0.02));
  const Core core(complex_of(ring));
  EXPECT_EQ(core.loop(through_hole(0.05)).points.cols(), 0);
  EXPECT_EQ(core.loop(through_hole(0.05)).radius, 0);
}

/// A band without thickness, as a camera sees it from one side, shuts nothing off.
TEST(Core, ABandHasNone) {
  Matrix3Xd band(3, 48 * 3);
  for (int i = 0; i < 48; ++i) {
    for (int k = 0; k < 3; ++k) {
      const double angle = 2 * M_PI * i / 48;
      band.col(3 * i + k) << 0.01 * k, 0.12 * std::cos(angle), 0.12 * std::sin(angle);
    }
  }
  const Object object = Object::from_cloud("band", band);
  const Core core(complex_of(object));
  EXPECT_EQ(core.loop(through_hole(0.3)).radius, 0);
  EXPECT_FALSE(core.contains({0.01, 0.12, 0}));
}

}  // namespace
}  // namespace graspless::clasp
