// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "graspless/mechanics/contact.hpp"

#include "complaint.hpp"

namespace graspless::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const Vector3d kMoments(2, 3, 4);

TEST(WrenchScale, MeasuresMomentsByTheRadiiOfGyration) {
  const Matrix6d scale = wrench_scale(2, kMoments.asDiagonal());
  Vector6d diagonal;
  diagonal << 1, 1, 1, 1, std::sqrt(2 / 3.0), std::sqrt(0.5);
  EXPECT_TRUE(scale.isApprox(Matrix6d(diagonal.asDiagonal()), 1e-15)) << scale;
}

TEST(WrenchScale, KeepsTheAxesOfABoxWithEqualMoments) {
  const Matrix6d scale = wrench_scale(1, Vector3d(4, 2, 4).asDiagonal());
  EXPECT_EQ((scale.topLeftCorner<3, 3>()), Matrix3d::Identity());
}

TEST(WrenchScale, ItsSquareIsTheMetricOfEquationEight) {
  const Matrix3d R(Eigen::AngleAxisd(0.8, Vector3d(1, -2, 3).normalized()));
  const Matrix3d J = R * kMoments.asDiagonal() * R.transpose();
  const Matrix6d scale = wrench_scale(2, J);
  Matrix6d metric = Matrix6d::Identity();
  metric.bottomRightCorner<3, 3>() = 2 * J.inverse();
  EXPECT_TRUE((scale.transpose() * scale).isApprox(metric, 1e-12));
}

TEST(WrenchScale, AxesAreThoseNearestToTheObjects) {
  const Matrix3d R(Eigen::AngleAxisd(0.3, Vector3d(1, 2, 3).normalized()));
  const Matrix6d scale = wrench_scale(1, R * Vector3d(4, 2, 3).asDiagonal() * R.transpose());
  EXPECT_TRUE((scale.topLeftCorner<3, 3>().isApprox(R.transpose(), 1e-12)));
}

TEST(WrenchScale, FreeAxesStayNearTheObjects) {
  // A rod along a slanted axis: the two other axes are free.
  const Matrix3d R(Eigen::AngleAxisd(0.3, Vector3d::UnitY()));
  const Matrix3d spun = R * Eigen::AngleAxisd(1.0, Vector3d::UnitZ());
  const Matrix3d J = spun * Vector3d(4, 4, 1).asDiagonal() * spun.transpose();
  const Matrix6d scale = wrench_scale(1, J);
  EXPECT_TRUE((scale.topLeftCorner<3, 3>().isApprox(R.transpose(), 1e-12)));
}

TEST(WrenchScale, RefusesWhatNoBodyHas) {
  expect_refused([] { wrench_scale(-1, kMoments.asDiagonal()); }, "mass must lie in");
  expect_refused([] { wrench_scale(1, Vector3d(1, 1, 3).asDiagonal()); }, "inertia_O must have no");
  expect_refused([] { wrench_scale(1, Vector3d(0, 1, 1).asDiagonal()); }, "positive definite");
  expect_refused([] { wrench_scale(1, Vector3d(1e-20, 1, 1).asDiagonal()); },
                 "too little for a mass");
  expect_refused(
      [] {
        Matrix3d J = kMoments.asDiagonal();
        J(0, 1) = 1;
        wrench_scale(1, J);
      },
      "symmetric");
  expect_refused([] { wrench_scale(1, Matrix3d::Constant(std::nan(""))); }, "finite");
}

TEST(DisturbanceDirections, FacetsTouchTheUnitSphere) {
  const Matrix6Xd l = disturbance_directions();
  ASSERT_EQ(l.cols(), 76);
  // The support function is k max(|y|_inf, |y|_1 / sqrt 6): at least 1 on the sphere, 1 somewhere.
  const double k = 2 * std::sqrt(3 - std::sqrt(6.0));
  double least = 10;
  for (int trial = 0; trial < 20000; ++trial) {
    const Vector6d y = Vector6d::Random().normalized();
    const double support = (l.transpose() * y).maxCoeff();
    EXPECT_NEAR(support, k * std::max(y.cwiseAbs().maxCoeff(), y.lpNorm<1>() / std::sqrt(6.0)),
                1e-12);
    least = std::min(least, support);
  }
  EXPECT_GE(least, 1 - 1e-12);
  // A facet's normal: two components a, one b with 2 a + b = sqrt 6 a.
  Vector6d facet = Vector6d::Zero();
  facet.head<3>() << 1, 1, std::sqrt(6.0) - 2;
  EXPECT_NEAR((l.transpose() * facet.normalized()).maxCoeff(), 1, 1e-12);
}

}  // namespace
}  // namespace graspless::mechanics
