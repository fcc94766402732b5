// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/ordered_hull.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/convex_hull.hpp"

namespace graspless::geometry {
namespace {

/// Rings of points on an ellipsoid: its facets are flat quadrangles, its ends flat polygons.
Eigen::Matrix3Xd rings(int across, int around) {
  Eigen::Matrix3Xd p(3, across * around);
  for (int i = 0; i < across; ++i) {
    for (int k = 0; k < around; ++k) {
      const double a = M_PI * (i + 0.5) / across, b = 2 * M_PI * k / around;
      p.col(i * around + k) << 0.25 * std::cos(a), 0.13 * std::sin(a) * std::cos(b),
          0.13 * std::sin(a) * std::sin(b);
    }
  }
  return p;
}

double area(const Mesh& mesh) {
  double sum = 0;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    const Eigen::Vector3d a = mesh.vertices.col(mesh.triangles(0, i));
    const Eigen::Vector3d b = mesh.vertices.col(mesh.triangles(1, i));
    const Eigen::Vector3d c = mesh.vertices.col(mesh.triangles(2, i));
    sum += (b - a).cross(c - a).norm() / 2;
  }
  return sum;
}

TEST(OrderedHull, IsTheSameWhateverTheOrderOfPoints) {
  const Eigen::Matrix3Xd points = rings(9, 12);
  const Mesh first = ordered(convex_hull(points));
  std::vector<Eigen::Index> order(static_cast<std::size_t>(points.cols()));
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Eigen::Index>(i);
  std::mt19937_64 rng(1);
  for (int trial = 0; trial < 20; ++trial) {
    std::shuffle(order.begin(), order.end(), rng);
    const Mesh again = ordered(convex_hull(points(Eigen::all, order)));
    ASSERT_EQ(again.vertices, first.vertices);
    ASSERT_EQ(again.triangles, first.triangles);
  }
}

TEST(OrderedHull, IsTheSameBody) {
  const Mesh hull = convex_hull(rings(7, 10));
  const Mesh found = ordered(hull);
  EXPECT_EQ(found.triangles.cols(), hull.triangles.cols());
  EXPECT_NEAR(area(found), area(hull), 1e-12);
  EXPECT_TRUE(is_convex(found, hull));
}

}  // namespace
}  // namespace graspless::geometry
