// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Thickness of loops of known size, and which of them run around a handle.
#include <gtest/gtest.h>

#include "geometry/clouds.hpp"
#include "geometry/cycles/shortest_basis.hpp"

namespace graspless::geometry {
namespace {

/// A hoop about z of rectangular section; a cloud of its surface.
Eigen::Matrix3Xd hoop(double diameter, double width, double height, double spacing) {
  const int n = static_cast<int>(std::ceil(M_PI * diameter / spacing));
  const int across = std::max(1, static_cast<int>(std::ceil(width / spacing)));
  const int up = std::max(1, static_cast<int>(std::ceil(height / spacing)));
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j <= across; ++j) {
      for (int k = 0; k <= up; ++k) {
        if (j > 0 && j < across && k > 0 && k < up) continue;
        const double u = 2 * M_PI * (i + 0.5 * ((j + k) % 2)) / n;
        const double r = diameter / 2 + width * (static_cast<double>(j) / across - 0.5);
        points.emplace_back(r * std::cos(u), r * std::sin(u), height * k / up);
      }
    }
  }
  return Eigen::Map<Eigen::Matrix3Xd>(points[0].data(), 3,
                                      static_cast<Eigen::Index>(points.size()));
}

struct Found {
  std::vector<double> thickness, lengths;
  std::vector<bool> is_meridian;
  int left() const {
    return static_cast<int>(std::count(is_meridian.begin(), is_meridian.end(), false));
  }
};

/// Holes and meridians in K_d, shortest first.
Found look(const Eigen::Matrix3Xd& cloud, double d, const std::vector<RayImage>& rays = {},
           bool all_sides = false) {
  LoopOptions options;
  options.max_edge_length = d;
  options.all_sides = all_sides;
  const Loops loops = shortest_loops(cloud, options, rays);
  std::vector<std::pair<Loop, bool>> all;
  for (const Loop& loop : loops.found) all.emplace_back(loop, false);
  for (const Loop& loop : loops.meridians) all.emplace_back(loop, true);
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return a.first.length < b.first.length; });
  Found found;
  for (const auto& [loop, is_meridian] : all) {
    found.thickness.push_back(loop.thickness);
    found.lengths.push_back(loop.length);
    found.is_meridian.push_back(is_meridian);
  }
  return found;
}

TEST(Thickness, OfARingIsThatOfItsTube) {
  for (const double tube : {0.01, 0.02, 0.03}) {
    const Found found = look(torus(0.15, tube, 0.008), 0.018);
    ASSERT_GE(found.thickness.size(), 1u);
    EXPECT_NEAR(found.thickness.back(), 2 * tube, 0.25 * 2 * tube);  // the last runs along
  }
}

TEST(Thickness, OfAStripIsItsWidth) {
  const Found found = look(hoop(0.3, 0.05, 0.004, 0.008), 0.02, {}, true);
  ASSERT_EQ(found.thickness.size(), 1u);
  EXPECT_NEAR(found.thickness[0], 0.05, 0.25 * 0.05);
}

TEST(Thickness, IsTakenAtTheThinnestPlace) {
  const Eigen::Matrix3Xd even = torus(0.15, 0.03, 0.008);
  Eigen::Matrix3Xd uneven = even;
  for (auto p : uneven.colwise()) {  // the tube thins to a third about +x
    const double u = std::atan2(p[1], p[0]), share = 1 - 2.0 / 3 * std::exp(-u * u / 2);
    const Eigen::Vector3d middle(0.15 * std::cos(u), 0.15 * std::sin(u), 0);
    p = middle + share * (p - middle);
  }
  const Found found = look(uneven, 0.018);
  ASSERT_GE(found.thickness.size(), 1u);
  EXPECT_NEAR(found.thickness.back(), 0.02, 0.3 * 0.02);
}

TEST(Thickness, StandsNoise) {
  const Found found = look(noisy(torus(0.15, 0.02, 0.008), 0.001, 1), 0.018);
  ASSERT_GE(found.thickness.size(), 1u);
  EXPECT_NEAR(found.thickness.back(), 0.04, 0.3 * 0.04);
}

TEST(Thickness, IsNotThatOfWhatLiesBeside) {
  const Eigen::Matrix3Xd ring = torus(0.15, 0.01, 0.008);
  const Eigen::Matrix3Xd ball = moved(sphere_cloud(0.1, 2500), {0, 0, 0.2});
  const Found found = look(side_by_side({ring, ball}), 0.018);
  ASSERT_GE(found.thickness.size(), 1u);
  EXPECT_NEAR(found.thickness.back(), 0.02, 0.25 * 0.02);
}

TEST(Meridians, OfAThickRingAreLeftOut) {
  for (const double tube : {0.03, 0.05, 0.08}) {
    SCOPED_TRACE(tube);
    const Found found = look(torus(0.15, tube, 0.01), 0.022);
    ASSERT_EQ(found.is_meridian.size(), 2u);
    EXPECT_EQ(found.left(), 1);
    const std::size_t around = found.is_meridian[0] ? 0 : 1;
    EXPECT_NEAR(found.lengths[around], 2 * M_PI * tube, 0.15 * 2 * M_PI * tube);
  }
}

TEST(Meridians, StandNoise) {
  const Found found = look(noisy(torus(0.15, 0.05, 0.01), 0.0015, 1), 0.025);
  ASSERT_EQ(found.is_meridian.size(), 2u);
  EXPECT_EQ(found.left(), 1);
}

TEST(Meridians, AThinRingHasNone) {
  const Found found = look(torus(0.15, 0.008, 0.008), 0.02);
  ASSERT_EQ(found.is_meridian.size(), 1u);
  EXPECT_EQ(found.left(), 1);
}

TEST(Meridians, ARingSeenFromOneSideKeepsItsLoop) {
  const Eigen::Matrix3Xd whole = torus(0.15, 0.05, 0.01);
  std::vector<int> seen;
  for (int i = 0; i < whole.cols(); ++i) {
    if (whole(2, i) > -0.005) seen.push_back(i);
  }
  const Eigen::Matrix3Xd cloud = whole(Eigen::all, seen);
  const Found found = look(cloud, 0.022, rays_from_viewpoints(cloud, Eigen::Vector3d(0, 0, 1)));
  ASSERT_EQ(found.is_meridian.size(), 1u);
  EXPECT_EQ(found.left(), 1);
  EXPECT_TRUE(look(cloud, 0.022).is_meridian.empty());  // nobody knows where the camera was
}

TEST(Meridians, EachOfTwoThickRingsKeepsOneLoop) {
  const Found found = look(
      side_by_side({torus(0.15, 0.05, 0.01), moved(torus(0.12, 0.04, 0.01), {0.4, 0, 0})}), 0.022);
  ASSERT_EQ(found.is_meridian.size(), 4u);
  EXPECT_EQ(found.left(), 2);
}

template <class IsIn>
Eigen::Matrix3Xd without(const Eigen::Matrix3Xd& cloud, const IsIn& is_in) {
  std::vector<int> outside;
  for (int i = 0; i < cloud.cols(); ++i) {
    if (!is_in(Eigen::Vector3d(cloud.col(i)))) outside.push_back(i);
  }
  return cloud(Eigen::all, outside);
}

/// Inside a ring about z.
bool in_ring(const Eigen::Vector3d& p, double radius, double tube) {
  return std::hypot(std::hypot(p.x(), p.y()) - radius, p.z()) < tube;
}

TEST(Meridians, ADoubleRingKeepsTwoLoops) {
  const Eigen::Vector3d beside(0.27, 0, 0);  // the rings run into one another
  const Eigen::Matrix3Xd ring = torus(0.15, 0.04, 0.01);
  const Eigen::Matrix3Xd both = side_by_side(
      {without(ring, [&](const auto& p) { return in_ring(p - beside, 0.15, 0.04); }),
       moved(without(ring, [&](const auto& p) { return in_ring(p + beside, 0.15, 0.04); }),
             beside)});
  const Found found = look(both, 0.022);
  ASSERT_EQ(found.is_meridian.size(), 4u);
  EXPECT_EQ(found.left(), 2);
}

TEST(Meridians, ABallWithAThickHandleKeepsOneLoop) {
  // The handle: the part of a ring, 5 cm thick, that is outside the ball.
  const auto in_body = [](const Eigen::Vector3d& p) {
    return (p - Eigen::Vector3d(-0.15, 0, 0)).norm() < 0.15;
  };
  const Eigen::Matrix3Xd body = moved(sphere_cloud(0.15, 4000), {-0.15, 0, 0});
  const Eigen::Matrix3Xd cloud =
      side_by_side({without(body, [](const auto& p) { return in_ring(p, 0.1, 0.025); }),
                    without(torus(0.1, 0.025, 0.008), in_body)});
  const Found found = look(cloud, 0.02);
  ASSERT_EQ(found.is_meridian.size(), 2u);
  EXPECT_EQ(found.left(), 1);
}

}  // namespace
}  // namespace graspless::geometry
