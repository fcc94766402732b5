// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/projection.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace graspless::planning {
namespace {

/// Rows: the radius of (q0, q1), and q2 - sin(q0).
void rows(const Eigen::VectorXd& q, BandProjection::Values& value, BandProjection::Jacobian* J) {
  const double r = q.head<2>().norm();
  value << r, q[2] - std::sin(q[0]);
  if (!J) return;
  J->setZero(2, 3);
  J->row(0) << q[0] / r, q[1] / r, 0;
  J->row(1) << -std::cos(q[0]), 0, 1;
}

BandProjection::Values values(double a, double b) {
  BandProjection::Values v(2);
  v << a, b;
  return v;
}

BandProjection make(double play = 0.0) {
  return BandProjection(rows, {values(1 - play, 0), values(1 + play, 0), values(1e-6, 1e-6)},
                        {Eigen::Vector3d(-2, -2, -2), Eigen::Vector3d(2, 2, 2)}, 30);
}

TEST(BandProjection, BringsAlmostEverythingIntoTheBands) {
  std::mt19937_64 rng(1);
  std::uniform_real_distribution<double> u(-2, 2);
  const BandProjection projection = make();
  int done = 0;
  for (int i = 0; i < 1000; ++i) {
    Eigen::VectorXd q = Eigen::Vector3d(u(rng), u(rng), u(rng));
    if (!projection.project(q)) continue;
    ++done;
    EXPECT_TRUE(projection.is_satisfied(q));
    EXPECT_NEAR(q.head<2>().norm(), 1, 1e-8);
    EXPECT_LE(q.lpNorm<Eigen::Infinity>(), 2);
  }
  EXPECT_GT(done, 950);
}

TEST(BandProjection, LeavesWhatIsInsideAlone) {
  const BandProjection projection = make(0.5);
  Eigen::VectorXd q = Eigen::Vector3d(0.9, 0.3, std::sin(0.9));
  const Eigen::VectorXd before = q;
  ASSERT_TRUE(projection.project(q));
  EXPECT_EQ(q, before);
}

TEST(BandProjection, TakesTheShortWay) {
  const BandProjection projection = make();
  Eigen::VectorXd q = Eigen::Vector3d(0, 1.001, 0);  // the nearest point of the set is (0, 1, 0)
  ASSERT_TRUE(projection.project(q));
  EXPECT_TRUE(q.isApprox(Eigen::Vector3d(0, 1, 0), 1e-5));
}

TEST(BandProjection, GivesUpAgainstTheLimits) {
  const BandProjection projection(rows, {values(5, 0), values(5, 0), values(0, 0)},
                                  {Eigen::Vector3d(-2, -2, -2), Eigen::Vector3d(2, 2, 2)});
  Eigen::VectorXd q = Eigen::Vector3d(1, 1, 0);
  EXPECT_FALSE(projection.project(q));
  EXPECT_TRUE(q.allFinite());
}

TEST(BandProjection, RefusesNonsense) {
  const BandProjection::Limits limits{Eigen::Vector3d(-2, -2, -2), Eigen::Vector3d(2, 2, 2)};
  EXPECT_THROW(BandProjection(rows, {values(1, 1), values(0, 2), values(0, 0)}, limits),
               std::invalid_argument);
  EXPECT_THROW(
      BandProjection(rows, {values(0, 0), values(1, 1), BandProjection::Values(1)}, limits),
      std::invalid_argument);
  EXPECT_THROW(BandProjection(rows, {values(0, 0), values(1, 1), values(0, 0)},
                              {Eigen::VectorXd::Zero(17), Eigen::VectorXd::Ones(17)}),
               std::invalid_argument);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(4);
  EXPECT_THROW(make().project(q), std::invalid_argument);
}

}  // namespace
}  // namespace graspless::planning
