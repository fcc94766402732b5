// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/linking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "geometry/linking/curves.hpp"

namespace graspless::geometry {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

Vector3d corner(const Matrix3Xd& curve, int i) {
  return curve.col(i % static_cast<int>(curve.cols()));
}

int num_segments(const Matrix3Xd& curve, bool is_closed) {
  return static_cast<int>(curve.cols()) - (is_closed ? 0 : 1);
}

/// The asin form of Klenin and Langowski (2000), their (15) and (16), as they write it.
double by_arcsines(const Matrix3Xd& a, bool a_is_closed, const Matrix3Xd& b, bool b_is_closed) {
  double sum = 0;
  for (int i = 0; i < num_segments(a, a_is_closed); ++i) {
    for (int j = 0; j < num_segments(b, b_is_closed); ++j) {
      const Vector3d p1 = corner(a, i), p2 = corner(a, i + 1);
      const Vector3d p3 = corner(b, j), p4 = corner(b, j + 1);
      const Vector3d r13 = p3 - p1, r14 = p4 - p1, r23 = p3 - p2, r24 = p4 - p2;
      const Vector3d n[4] = {r13.cross(r14).normalized(), r14.cross(r24).normalized(),
                             r24.cross(r23).normalized(), r23.cross(r13).normalized()};
      double angle = 0;
      for (int k = 0; k < 4; ++k) {
        angle += std::asin(std::clamp(n[k].dot(n[(k + 1) % 4]), -1.0, 1.0));
      }
      sum += (p4 - p3).cross(p2 - p1).dot(r13) > 0 ? angle : -angle;
    }
  }
  return sum / (4 * M_PI);
}

/// Eq. (1) with the midpoints of n x n parts of every pair of segments.
double by_quadrature(const Matrix3Xd& a, bool a_is_closed, const Matrix3Xd& b, bool b_is_closed,
                     int n) {
  double sum = 0;
  for (int i = 0; i < num_segments(a, a_is_closed) * n; ++i) {
    const Vector3d u = corner(a, i / n + 1) - corner(a, i / n);
    const Vector3d p = corner(a, i / n) + u * ((i % n + 0.5) / n);
    for (int j = 0; j < num_segments(b, b_is_closed) * n; ++j) {
      const Vector3d v = corner(b, j / n + 1) - corner(b, j / n);
      const Vector3d r = p - corner(b, j / n) - v * ((j % n + 0.5) / n);
      sum += r.dot(u.cross(v)) / std::pow(r.norm(), 3);
    }
  }
  return sum / (4 * M_PI * n * n);
}

TEST(Linking, IsWhatTheIntegralSays) {
  const Matrix3Xd a = circle(Vector3d::Zero(), kX, kY, 1, 9);
  const Matrix3Xd b = circle(kX, kX, kZ, 0.9, 7), arc = b.leftCols(4);
  EXPECT_NEAR(by_quadrature(a, true, b, true, 60), gauss_linking(a, true, b, true), 1e-4);
  EXPECT_NEAR(by_quadrature(a, true, arc, false, 60), gauss_linking(a, true, arc, false), 1e-4);
  EXPECT_NEAR(by_quadrature(arc, false, a.leftCols(6), false, 60),
              gauss_linking(arc, false, a.leftCols(6), false), 1e-4);
  EXPECT_NE(0, linking_number(a, b));
}

TEST(Linking, AgreesWithTheFormOfKleninAndLangowski) {
  std::mt19937_64 rng(1);
  for (int i = 0; i < 200; ++i) {
    const Matrix3Xd a = random_curve(2 + i % 9, rng), b = random_curve(3 + i % 150, rng);
    const bool closed = i % 2 == 0 && a.cols() > 2;
    EXPECT_NEAR(by_arcsines(a, closed, b, true), gauss_linking(a, closed, b, true), 1e-10);
    EXPECT_NEAR(by_arcsines(a, closed, b, false), gauss_linking(a, closed, b, false), 1e-10);
  }
}

TEST(Linking, OfHopf) {
  const Matrix3Xd a = circle(Vector3d::Zero(), kX, kY, 1, 20), b = circle(kX, kX, kZ, 1, 20);
  EXPECT_EQ(1, std::abs(linking_number(a, b)));
  EXPECT_EQ(-linking_number(a, b), linking_number(a, b.rowwise().reverse()));
  EXPECT_NEAR(linking_number(a, b), gauss_linking(a, true, b, true), 1e-13);
}

TEST(Linking, OfTorusLinks) {
  for (int k = -4; k <= 4; ++k) {
    const Matrix3Xd a = torus_strand(k, 0, 64), b = torus_strand(k, M_PI, 64);
    EXPECT_EQ(std::abs(k), std::abs(linking_number(a, b)));
    EXPECT_EQ(linking_number(a, b),
              -linking_number(torus_strand(-k, 0, 64), torus_strand(-k, M_PI, 64)));
    EXPECT_NEAR(linking_number(a, b), gauss_linking(a, true, b, true), 1e-12);
  }
}

/// Two strands side by side along the circle of radius 3, whose ends hook into each other.
Matrix3Xd whitehead_double(int corners) {
  Matrix3Xd points(3, 2 * corners);
  for (int i = 0; i < corners; ++i) {
    const double degrees = -10 + 380.0 * i / (corners - 1);
    const double turn = std::clamp((degrees - 20) / 320, 0.0, 1.0) * M_PI / 2;
    const double angle = degrees * M_PI / 180, aside = 0.3 * std::cos(turn);
    const Vector3d out(std::cos(angle), std::sin(angle), 0), up = 0.3 * std::sin(turn) * kZ;
    points.col(i) = (3 - aside) * out + up;
    points.col(2 * corners - 1 - i) = (3 + aside) * out - up;
  }
  return points;
}

/// They cannot be pulled apart, but run through each other one way as often as the other.
TEST(Linking, OfWhiteheadIsZero) {
  const Matrix3Xd strands = whitehead_double(60), ring = circle(-3 * kX, kX, kZ, 1, 12);
  EXPECT_EQ(0, linking_number(ring, strands));
  EXPECT_NEAR(0, gauss_linking(ring, true, strands, true), 1e-12);
  EXPECT_NEAR(1, std::abs(gauss_linking(ring, true, strands.leftCols(60), false)), 0.1);
}

TEST(Linking, OfWhatLiesApartIsZero) {
  const Matrix3Xd a = circle(Vector3d::Zero(), kX, kY, 1, 12);
  for (const Vector3d& p : {Vector3d(3, 0, 0), Vector3d(0, 0, 0.5), Vector3d(0, 0, 0)}) {
    const Matrix3Xd b = circle(p, kX, kY, 0.5, 8);
    EXPECT_EQ(0, linking_number(a, b));
    EXPECT_NEAR(0, gauss_linking(a, true, b, true), 1e-14);
  }
}

TEST(Linking, IntegralAndCrossingsAgree) {
  std::mt19937_64 rng(2);
  double residual = 0;
  int linked = 0;
  for (int i = 0; i < 20000; ++i) {
    const Matrix3Xd a = random_curve(8, rng), b = random_curve(30, rng);
    const double integral = gauss_linking(a, true, b, true);
    const int number = linking_number(a, b);
    ASSERT_EQ(std::lround(integral), number) << i;
    residual = std::max(residual, std::abs(integral - number));
    linked += number != 0 ? 1 : 0;
  }
  EXPECT_LT(residual, 1e-12);
  EXPECT_GT(linked, 10000);
}

TEST(Linking, TakesCurvesInAnyOrder) {
  std::mt19937_64 rng(3);
  for (int i = 0; i < 50; ++i) {
    const Matrix3Xd a = random_curve(9, rng), b = random_curve(3 + 7 * i, rng);
    EXPECT_EQ(linking_number(a, b), linking_number(b, a));
    EXPECT_NEAR(gauss_linking(a, false, b, true), gauss_linking(b, true, a, false), 1e-12);
    const Matrix3Xd back = b.rowwise().reverse();
    EXPECT_EQ(linking_number(a, b), -linking_number(a, back));
    EXPECT_NEAR(gauss_linking(a, false, b, true), -gauss_linking(a, false, back, true), 1e-12);
    Matrix3Xd turned = b;  // begins elsewhere
    for (int j = 0; j < b.cols(); ++j) turned.col(j) = corner(b, j + 2);
    EXPECT_EQ(linking_number(a, b), linking_number(a, turned));
  }
}

TEST(Linking, AddsUpOverPieces) {
  std::mt19937_64 rng(4);
  for (int i = 0; i < 50; ++i) {
    const Matrix3Xd a = random_curve(40, rng), b = random_curve(150 + i, rng), whole = opened(b);
    const int cut = 5 + 2 * i;
    const double one = gauss_linking(a, true, whole.leftCols(cut + 1), false);
    const double other = gauss_linking(a, true, whole.rightCols(whole.cols() - cut), false);
    EXPECT_NEAR(linking_number(a, b), one + other, 1e-12);
  }
}

TEST(Linking, DoesNotDependOnPlaceOrUnit) {
  std::mt19937_64 rng(5);
  for (const double unit : {1e-150, 1e-6, 1.0, 1000.0, 1e150}) {
    const Matrix3Xd a = random_curve(8, rng), b = random_curve(30, rng);
    const Eigen::Isometry3d X = random_motion(rng);
    const Matrix3Xd a2 = unit * (X * a), b2 = unit * (X * b);
    EXPECT_EQ(linking_number(a, b), linking_number(a2, b2));
    EXPECT_NEAR(gauss_linking(a, false, b, false), gauss_linking(a2, false, b2, false), 1e-11);
  }
  const Matrix3Xd far = circle(Vector3d(1e4, 0, 0), kX, kY, 0.1, 9);
  EXPECT_EQ(1, std::abs(linking_number(far, circle(Vector3d(1e4 + 0.1, 0, 0), kX, kZ, 0.1, 9))));
}

TEST(Linking, OfAnOpenCurveChangesSlowly) {
  const Matrix3Xd loop = circle(Vector3d::Zero(), kX, kY, 1, 50);
  double before = 0;
  for (int i = 0; i <= 400; ++i) {  // a stick pushed through
    Matrix3Xd stick(3, 3);
    stick.col(0) << 0.3, 0.1, -2;
    stick.col(1) << 0.2, 0, -1;
    stick.col(2) << 0.1, 0, -1 + i * 0.005;
    const double now = gauss_linking(loop, true, stick, false);
    if (i > 0) {
      EXPECT_LT(std::abs(now - before), 0.005);
    }
    before = now;
  }
  EXPECT_GT(std::abs(before), 0.5);
}

/// What touches or lies on one line counts nothing, wherever it is turned to.
TEST(Linking, OfTouchingSegmentsIsZero) {
  std::mt19937_64 rng(6);
  Matrix3Xd a(3, 2), crossing(3, 2), collinear(3, 2), tip(3, 2), parallel(3, 2);
  a << -1, 1, 0, 0, 0, 0;
  crossing << 0.25, 0.25, -1, 1, 0, 0;
  collinear << 0.5, 3, 0, 0, 0, 0;
  tip << 1, 2, 0, 1, 0, 1;
  parallel << -1, 1, 0.5, 0.5, 0, 0;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Isometry3d X = i == 0 ? Eigen::Isometry3d::Identity() : random_motion(rng);
    for (const Matrix3Xd& b : {crossing, collinear, tip, parallel, a}) {
      EXPECT_NEAR(0, gauss_linking(X * a, false, X * b, false), 1e-9) << i;
    }
  }
}

TEST(Linking, OfCurvesThatTouchIsFinite) {
  std::mt19937_64 rng(7);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Isometry3d X = i == 0 ? Eigen::Isometry3d::Identity() : random_motion(rng);
    const Matrix3Xd a = X * circle(Vector3d::Zero(), kX, kY, 1, 12);
    for (const double angle : {0.0, 0.3, M_PI / 2}) {  // touches where the planes meet
      const Vector3d v = std::cos(angle) * kX + std::sin(angle) * kZ;
      Matrix3Xd b = X * circle(2 * kX, kX, v, 1, 12);
      b.col(4) = a.col(0);
      EXPECT_LE(std::abs(gauss_linking(a, true, b, true)), 1.001);
      EXPECT_LE(std::abs(linking_number(a, b)), 1);
    }
    EXPECT_LE(std::abs(gauss_linking(a, true, a, true)), 1e-9);  // flat
    EXPECT_LE(std::abs(linking_number(a, a)), 1);
  }
}

TEST(Linking, IgnoresCornersGivenTwiceAndStraightOnes) {
  const Matrix3Xd a = circle(Vector3d::Zero(), kX, kY, 1, 6);
  Matrix3Xd doubled(3, 18);
  for (int i = 0; i < 6; ++i) {
    doubled.col(3 * i) = doubled.col(3 * i + 1) = a.col(i);
    doubled.col(3 * i + 2) = (a.col(i) + corner(a, i + 1)) / 2;
  }
  for (const double aside : {0.0, 0.1}) {  // the first lies in planes of the other
    const Matrix3Xd b = circle(kX + aside * kY, kX, kZ, 1, 9);
    EXPECT_EQ(linking_number(a, b), linking_number(doubled, b));
    EXPECT_EQ(linking_number(b, a), linking_number(b, doubled));
    EXPECT_NEAR(gauss_linking(a, true, b, true), gauss_linking(doubled, true, b, true), 1e-13);
  }
  const Matrix3Xd point = Matrix3Xd::Constant(3, 5, 0.25);
  EXPECT_EQ(0, linking_number(a, point));
  EXPECT_EQ(0, gauss_linking(a, true, point, true));
}

TEST(Linking, CrossesItself) {
  Matrix3Xd eight(3, 4);  // a figure of eight in the plane y = 0
  eight << 0, 2, 2, 0, 0, 0, 0, 0, -1, 1, -1, 1;
  const Matrix3Xd loop = circle(Vector3d(0.5, 0, 0), kX, kY, 0.3, 30);
  EXPECT_NEAR(linking_number(loop, eight), gauss_linking(loop, true, eight, true), 1e-12);
}

TEST(Linking, RefusesWhatIsNoCurve) {
  const Matrix3Xd loop = circle(Vector3d::Zero(), kX, kY, 1, 5), one = Matrix3Xd::Zero(3, 1);
  Matrix3Xd bad = loop;
  bad(1, 2) = std::nan("");
  expect_refused([&] { gauss_linking(loop, true, one, false); },
                 "b must have at least 2 corners, not 1");
  expect_refused([&] { linking_number(loop.leftCols(2), loop); },
                 "a must have at least 3 corners, not 2");
  expect_refused([&] { gauss_linking(bad, true, loop, true); }, "a must be finite");
  expect_refused([&] { PreparedLoop{bad}; }, "loop must be finite");
  expect_refused([&] { PreparedLoop{loop}.linking_number(bad); }, "curve must be finite");
}

}  // namespace
}  // namespace graspless::geometry
