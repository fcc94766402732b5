// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "graspless/geometry/linking.hpp"

#include "complaint.hpp"
#include "geometry/linking/curves.hpp"

namespace graspless::geometry {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

TEST(VirtualLinking, IsEquationTwo) {
  const Matrix3Xd loop = circle(Vector3d::Zero(), kX, kY, 1, 20);
  const Matrix3Xd finger = circle(kX, kX, kZ, 0.5, 10);
  const Matrix3Xd curve = finger.leftCols(8);
  const double chord = (curve.col(7) - curve.col(0)).norm();
  const double length = chord + 7 * (curve.col(1) - curve.col(0)).norm();
  const double expected = (1 - chord / length) * linking_number(loop, curve);
  EXPECT_NEAR(expected, virtual_linking(loop, curve), 1e-14);
  EXPECT_GT(std::abs(expected), 0.7);
  EXPECT_EQ(0, virtual_linking(loop, curve.colwise() + 3 * kX));
  EXPECT_NEAR(1, std::abs(virtual_linking(loop, opened(finger))), 1e-14);  // the tips meet
  EXPECT_EQ(0, virtual_linking(loop, Matrix3Xd::Constant(3, 5, 0.25)));
}

TEST(VirtualLinking, HasTheDerivativeOfDifferences) {
  std::mt19937_64 rng(8);
  constexpr double kStep = 1e-6;
  int linked = 0;
  for (int i = 0; i < 100; ++i) {
    const Matrix3Xd loop = random_curve(20, rng), curve = random_curve(7, rng);
    const VirtualLinking at = virtual_linking_gradient(loop, curve);
    EXPECT_DOUBLE_EQ(virtual_linking(loop, curve), at.value);
    linked += at.linking_number != 0 ? 1 : 0;
    for (int k = 0; k < curve.size(); ++k) {
      Matrix3Xd more = curve, less = curve;
      more.data()[k] += kStep;
      less.data()[k] -= kStep;
      const VirtualLinking high = virtual_linking_gradient(loop, more);
      const VirtualLinking low = virtual_linking_gradient(loop, less);
      if (high.linking_number != low.linking_number) continue;
      EXPECT_NEAR((high.value - low.value) / (2 * kStep), at.gradient.data()[k], 1e-6);
    }
  }
  EXPECT_GT(linked, 30);
}

TEST(VirtualLinking, HasAFiniteDerivativeEverywhere) {
  const Matrix3Xd loop = circle(Vector3d::Zero(), kX, kY, 1, 20);
  Matrix3Xd curve = opened(circle(kX, kX, kZ, 0.5, 10));
  curve.col(4) = curve.col(5);
  const VirtualLinking at = virtual_linking_gradient(loop, curve);
  EXPECT_EQ(1, std::abs(at.linking_number));
  EXPECT_TRUE(at.gradient.allFinite());
}

TEST(VirtualLinking, RefusesWhatIsNoCurve) {
  const Matrix3Xd loop = circle(Vector3d::Zero(), kX, kY, 1, 5);
  Matrix3Xd bad = loop;
  bad(1, 2) = std::nan("");
  expect_refused([&] { virtual_linking(loop, bad); }, "curve must be finite");
  expect_refused([&] { virtual_linking(bad, loop); }, "a must be finite");
  expect_refused([&] { closedness(loop.leftCols(1)); },
                 "curve must have at least 2 corners, not 1");
}

}  // namespace
}  // namespace graspless::geometry
