// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/perception/render.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "perception/scenes.hpp"

namespace graspless::perception {
namespace {

using geometry::PlacedShape;

/// Looks straight down from `height` [m].
Eigen::Isometry3d above(double height) {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.linear() = Eigen::Vector3d(1, -1, -1).asDiagonal();
  X_WC.translation().z() = height;
  return X_WC;
}

TEST(Render, DepthIsThatOfThePlaneAlongTheAxis) {
  const Rendering seen = render({box_at({10, 10, 2}, {0, 0, -1})}, above(1.25));
  EXPECT_NEAR(seen.depth.minCoeff(), 1.25, 1e-6);
  EXPECT_NEAR(seen.depth.maxCoeff(), 1.25, 1e-6);
  EXPECT_TRUE((seen.label == 0).all());
  EXPECT_NEAR(seen.cosine(239, 319), 1, 1e-4);
  // A corner's ray is inclined by its own direction.
  const Camera camera;
  const Eigen::Vector3d ray = camera.K.inverse() * Eigen::Vector3d(0, 0, 1);
  EXPECT_NEAR(seen.cosine(0, 0), 1 / ray.norm(), 1e-6);
}

TEST(Render, TheNearestBodyHidesTheOthersInAnyOrder) {
  const Body table = box_at({4, 4, 2}, {0, 0, -1});
  const Body thing = box_at({0.2, 0.1, 0.3}, {0, 0, 0.15});
  const Rendering seen = render({table, thing}, above(1));
  const Rendering swapped = render({thing, table}, above(1));
  EXPECT_TRUE((seen.depth == swapped.depth).all());
  EXPECT_TRUE((seen.label == 1 - swapped.label).all());
  // The thing's top is a rectangle of 0.2 m x 0.1 m, seen from 0.7 m.
  const double f = Camera{}.K(0, 0);
  const double expected = 0.2 * 0.1 * f * f / (0.7 * 0.7);
  EXPECT_NEAR(static_cast<double>((seen.label == 1).count()), expected, 0.02 * expected);
}

TEST(Render, IsUnchangedByAMotionOfTheWholeWorld) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  X.translation() << 0.3, -2, 1;
  std::vector<Body> bodies{box_at({4, 4, 2}, {0, 0, -1}), box_at({0.2, 0.1, 0.3}, {0.1, 0, 0.15})};
  const Rendering before = render(bodies, above(1));
  for (Body& body : bodies) body.X_WB = X * body.X_WB;
  const Rendering after = render(bodies, X * above(1));
  // Rays along an edge may fall on either side of it.
  EXPECT_LT((before.label != after.label).count(), 30);
  EXPECT_LT(((before.depth - after.depth).abs() > 1e-5f && before.label == after.label).count(), 1);
}

TEST(Render, SeesNothingBehindTheCameraOrBeyondTheScene) {
  const Rendering seen = render({box_at({1, 1, 1}, {0, 0, 3})}, above(1));
  EXPECT_TRUE((seen.label == -1).all());
  EXPECT_TRUE((seen.depth == 0).all());
  EXPECT_TRUE((render({}, above(1)).label == -1).all());
}

TEST(Render, RefusesWhatItCannotDrawByName) {
  const std::vector<Body> ball{{{PlacedShape{geometry::Sphere{0.1}}}}};
  EXPECT_NE(complaint([&] { render(ball, above(1)); }).find("bodies[0].shapes[0]"),
            std::string::npos);
  Camera camera;
  camera.K(0, 2) = 700;
  EXPECT_NE(complaint([&] { render({}, above(1), camera); }).find("principal point is 700"),
            std::string::npos);
  camera = Camera{};
  camera.K(0, 0) = 0.5;
  EXPECT_NE(complaint([&] { render({}, above(1), camera); }).find("field of view"),
            std::string::npos);
  camera = Camera{8, 480};
  EXPECT_NE(complaint([&] { render({}, above(1), camera); }).find("width is 8"), std::string::npos);
  EXPECT_NE(complaint([&] { camera_with_view(640, 480, 4); }).find("angle is 4"),
            std::string::npos);
}

TEST(Camera, FieldOfViewIsTheAngleBetweenTheOuterEdgesOfThePixels) {
  const Camera camera = camera_with_view(640, 480, 1.0471975511965976);
  EXPECT_TRUE(camera.K.isApprox(Camera{}.K, 1e-9));
  EXPECT_NEAR(2 * std::atan(320 / camera.K(0, 0)), 1.0471975511965976, 1e-12);
}

}  // namespace
}  // namespace graspless::perception
