// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/height_map.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "geometry/polygons.hpp"

namespace graspless::geometry {
namespace {

using Eigen::Index, Eigen::Vector2d, Eigen::Vector3d;

HeightMap random_map(std::mt19937_64& rng) {
  std::uniform_int_distribution<int> count(1, 12), level(-2, 5);
  HeightMap map;
  map.corner = {-0.03, 0.02};
  map.cell = 0.004;
  map.heights.setZero(count(rng), count(rng));
  for (double& height : map.heights.reshaped()) height = std::max(0, level(rng)) * 0.01;
  map.heights(0, 0) = 0.02;
  return map;
}

bool is_in(const PlacedShape& placed, const Vector3d& p) {
  const Vector3d half = std::get<Box>(placed.shape).size / 2;
  return ((placed.X_BG.inverse() * p).cwiseAbs().array() <= half.array()).all();
}

/// The range near a point is that of all cells, looked at one by one.
TEST(HeightMap, RangeNearAPoint) {
  std::mt19937_64 rng(5);
  std::uniform_real_distribution<double> x(-0.05, 0.04), y(0, 0.09), r(0, 0.03);
  for (int i = 0; i < 200; ++i) {
    const HeightMap map = random_map(rng);
    const Vector2d p(x(rng), y(rng));
    const double radius = r(rng), here = map.at(p);
    double least = here > 0 ? here : std::numeric_limits<double>::infinity(), largest = here;
    for (Index a = 0; a < map.heights.rows(); ++a) {
      for (Index b = 0; b < map.heights.cols(); ++b) {
        const Vector2d cell(static_cast<double>(a) + 0.5, static_cast<double>(b) + 0.5);
        const double height = map.heights(a, b);
        if (height == 0 || (map.corner + map.cell * cell - p).norm() > radius) continue;
        least = std::min(least, height);
        largest = std::max(largest, height);
      }
    }
    const auto range = map.range_near(p, radius);
    EXPECT_EQ(range.second, largest);
    EXPECT_EQ(range.first, largest > 0 ? least : 0);
  }
}

TEST(HeightMap, ColumnsFillItAndDoNotOverlap) {
  std::mt19937_64 rng(1);
  std::uniform_real_distribution<double> x(-0.04, 0.03), y(0.01, 0.08), z(0, 0.06);
  for (int i = 0; i < 50; ++i) {
    const HeightMap map = random_map(rng);
    const auto boxes = columns(map, 0.01);
    for (int k = 0; k < 100; ++k) {
      const Vector3d p(x(rng), y(rng), z(rng));
      const auto hits = std::count_if(boxes.begin(), boxes.end(),
                                      [&](const PlacedShape& box) { return is_in(box, p); });
      EXPECT_EQ(hits, p.z() <= map.at(p.head<2>()) ? 1 : 0);
    }
  }
}

TEST(HeightMap, ColumnsAreRoundedUpButNotAboveTheTop) {
  HeightMap map;
  map.cell = 0.01;
  map.heights.resize(1, 3);
  map.heights << 0.0041, 0.0079, 0.0095;
  const auto boxes = columns(map, 0.004);
  ASSERT_EQ(boxes.size(), 2U);  // the first two cells share one
  EXPECT_NEAR(std::get<Box>(boxes[0].shape).size.z(), 0.008, 1e-12);
  EXPECT_NEAR(std::get<Box>(boxes[0].shape).size.y(), 0.02, 1e-12);
  EXPECT_NEAR(std::get<Box>(boxes[1].shape).size.z(), 0.0095, 1e-12);
}

TEST(HeightMap, NamesWhatIsWrong) {
  const auto refused = [](const auto& change) {
    std::mt19937_64 rng(1);
    HeightMap map = random_map(rng);
    change(map);
    return complaint([&] { validate(map, "map"); });
  };
  std::mt19937_64 rng(1);
  EXPECT_NO_THROW(validate(random_map(rng), "map"));
  EXPECT_NE(refused([](HeightMap& m) { m.cell = 0; }).find("map.cell must"), std::string::npos);
  EXPECT_NE(refused([](HeightMap& m) { m.heights(0, 0) = -1; }).find("map.heights must lie"),
            std::string::npos);
  EXPECT_NE(refused([](HeightMap& m) { m.heights.setZero(); }).find("map.heights must have one"),
            std::string::npos);
  EXPECT_NE(refused([](HeightMap& m) { m.undersides = m.heights + 1e-3; }).find("undersides"),
            std::string::npos);
  EXPECT_NE(refused([](HeightMap& m) { m.undersides.setZero(1, 77); }).find("undersides"),
            std::string::npos);
}

/// A wall along y, 10 mm thick and 60 mm high, on the plane, and cameras that look down on it.
constexpr double kThick = 0.01, kHigh = 0.06, kLong = 0.1;

double wall_height(double x) { return std::abs(x) <= kThick / 2 ? kHigh : 0; }

/// Depth at which a ray enters the wall; infinite if it passes.
double enters(const Vector3d& from, const Vector3d& along) {
  double in = 0, out = std::numeric_limits<double>::infinity();
  const Vector3d low(-kThick / 2, -kLong / 2, 0), high(kThick / 2, kLong / 2, kHigh);
  for (int i = 0; i < 3; ++i) {
    const double a = (low[i] - from[i]) / along[i], b = (high[i] - from[i]) / along[i];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in < out ? in : std::numeric_limits<double>::infinity();
}

struct Seen {
  Eigen::Matrix3Xd points;
  std::vector<RayImage> rays;
};

/// Adds what a camera at x = `side`, as high above the plane, sees.
void look(double side, Seen& seen) {
  constexpr int kPixels = 161;
  RayImage image;
  image.K << 700, 0, kPixels / 2, 0, 700, kPixels / 2, 0, 0, 1;
  const Vector3d eye(side, 0.001, 0.6), z = (Vector3d(0, 0.001, 0.02) - eye).normalized(),
                                        x = z.cross(Vector3d::UnitZ()).normalized();
  image.X_OC.linear() << x, z.cross(x), z;
  image.X_OC.translation() = eye;
  image.ends.setConstant(kPixels, kPixels, std::numeric_limits<float>::infinity());
  std::vector<Vector3d> points;
  for (int v = 0; v < kPixels; ++v) {
    for (int u = 0; u < kPixels; ++u) {
      const Vector3d along = image.X_OC.linear() * image.K.inverse() * Vector3d(u, v, 1);
      const double depth = enters(eye, along);
      if (!std::isfinite(depth)) continue;
      image.ends(v, u) = static_cast<float>(-depth);
      points.emplace_back(eye + depth * along);
    }
  }
  const Index old = seen.points.cols();
  seen.points.conservativeResize(3, old + static_cast<Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    seen.points.col(old + static_cast<Index>(k)) = points[k];
  seen.rays.push_back(image);
}

/// Outline of the wall and of 50 mm to both sides of it.
HeightMap map_of(const Seen& seen) {
  const double x = 0.05, y = kLong / 2;
  const Polygon around(columns({{-x, -y}, {x, -y}, {x, y}, {-x, y}}));
  return seen_heights(seen.points, seen.rays, around, kHigh, 0.0025);
}

TEST(SeenHeights, AreAsHighAsTheShadowAndNeverTooLow) {
  Seen seen;
  look(-0.6, seen);  // at 45 degrees
  const HeightMap map = map_of(seen);
  for (double x = -0.045; x < 0.045; x += 0.0025) {
    const double height = map.at({x, 0.0});
    const double behind = x - kThick / 2;
    const double shadow = behind > 0 ? std::max(0.0, kHigh - behind * kHigh / 0.06) : 0;
    EXPECT_GE(height, wall_height(x) - 1e-3) << x;
    if (behind > 0.005) {
      EXPECT_NEAR(height, shadow, 0.008) << x;
    }
    if (x < -kThick / 2 - 0.0025) {
      EXPECT_LT(height, 0.004) << x;
    }
  }
}

TEST(SeenHeights, ASecondCameraLowersTheShadow) {
  Seen one, both;
  look(-0.6, one);
  look(-0.6, both);
  look(0.6, both);
  const HeightMap a = map_of(one), b = map_of(both);
  EXPECT_GT(a.at({0.015, 0.0}), 0.04);
  EXPECT_LT(b.at({0.015, 0.0}), 0.006);
  EXPECT_GT(b.at({0.0, 0.0}), kHigh - 1e-3);
  // A face is known as far down as it was seen.
  EXPECT_LT(b.underside_at({-0.0049, 0.01}), 0.005);
  EXPECT_LT(std::min(b.underside_at({0.0049, 0.01}), b.underside_at({0.0051, 0.01})), 0.005);
  EXPECT_GT(a.underside_at({0.0026, 0.01}), kHigh - 1e-3);
}

/// The object may be solid above a gap between rays, even if a ray passes below.
TEST(SeenHeights, OnlyAnUnbrokenRowOfRaysLowersACell) {
  Seen seen;
  look(-0.6, seen);
  EXPECT_LT(map_of(seen).at({-0.03, 0.0}), 0.004);
  RayImage& image = seen.rays[0];
  image.ends = (image.ends < 0).select(RayImage::Ends::Zero(161, 161), image.ends);
  EXPECT_EQ(map_of(seen).at({-0.03, 0.0}), kHigh);  // those to the wall pass 25 to 60 mm above
}

TEST(SeenHeights, RaysOfUnknownEndCountAsFarAsTheyAreClear) {
  Seen seen;
  look(-0.6, seen);
  RayImage& image = seen.rays[0];
  const RayImage::Ends passes = image.ends.isInf().cast<float>();
  image.ends = image.ends.isInf().select(RayImage::Ends::Zero(161, 161), image.ends);
  EXPECT_NEAR(map_of(seen).at({-0.03, 0.0}), 0.025, 0.003);  // below the rays to the wall's foot
  image.clear = passes;                                      // up to 1 m, which is beyond the plane
  EXPECT_LT(map_of(seen).at({-0.03, 0.0}), 0.004);
  image.clear *= -1;
  EXPECT_NE(complaint([&] { map_of(seen); }).find("clear"), std::string::npos);
}

/// A ray that hardly falls is as long as it likes; what counts is its way over the map.
TEST(SeenHeights, RaysAtTheHorizonTakeNoTime) {
  RayImage level;
  level.K << 1e9, 0, 0, 0, 1e9, 0, 0, 0, 1;
  level.ends = RayImage::Ends::Constant(1, 1, std::numeric_limits<float>::infinity());
  level.X_OC.translation() = Vector3d(-1, 0, 0.03);
  level.X_OC.linear() << 0, 0, 1, -1, 0, 0, 0, -1, -1e-12;
  const Polygon outline(Eigen::Matrix2Xd{{0.0, 0.1, 0.1, 0.0}, {-0.05, -0.05, 0.05, 0.05}});
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Constant(3, 1, 0.05);
  const HeightMap map = seen_heights(points, {level}, outline, 0.05, 0.002);
  EXPECT_EQ(map.at({0.02, 0.02}), 0.05);  // no ray
  EXPECT_EQ(map.underside_at({0.02, 0.02}), 0.05);
}

TEST(SeenHeights, RefuseATopThatIsNoneAndTooManyVoxels) {
  const Polygon outline(Eigen::Matrix2Xd{{0.0, 0.9, 0.9, 0.0}, {0.0, 0.0, 0.9, 0.9}});
  for (const double top : {0.0, -0.1, std::numeric_limits<double>::quiet_NaN(), 1.0}) {
    const auto asked = [&] { seen_heights(Eigen::Matrix3Xd(3, 0), {}, outline, top, 0.001); };
    EXPECT_NE(complaint(asked).find("top must be positive"), std::string::npos);
  }
  std::mt19937_64 rng(2);
  EXPECT_NE(complaint([&] { columns(random_map(rng), 0); }).find("step"), std::string::npos);
}

}  // namespace
}  // namespace graspless::geometry
