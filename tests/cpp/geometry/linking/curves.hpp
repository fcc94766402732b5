// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <random>

#include <Eigen/Geometry>

/// Curves that tests wind around one another.
namespace graspless::geometry {

inline const Eigen::Vector3d kX = Eigen::Vector3d::UnitX(), kY = Eigen::Vector3d::UnitY(),
                             kZ = Eigen::Vector3d::UnitZ();

/// Corners drawn from the normal distribution: a knot that nobody tied.
inline Eigen::Matrix3Xd random_curve(int corners, std::mt19937_64& rng) {
  std::normal_distribution<double> normal;
  return Eigen::Matrix3Xd::NullaryExpr(3, corners, [&] { return normal(rng); });
}

/// Round `center`, in the plane of the unit vectors `u` and `v`, turning from u to v.
inline Eigen::Matrix3Xd circle(const Eigen::Vector3d& center, const Eigen::Vector3d& u,
                               const Eigen::Vector3d& v, double radius, int corners) {
  Eigen::Matrix3Xd points(3, corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * (i + 0.25) / corners;
    points.col(i) = center + radius * (u * std::cos(angle) + v * std::sin(angle));
  }
  return points;
}

/// One of the two strands of the torus link (2, 2 k): once round the z axis, k times round the
/// circle of radius 1; `phase` 0 or pi tells the strands apart.
inline Eigen::Matrix3Xd torus_strand(int k, double phase, int corners) {
  Eigen::Matrix3Xd points(3, corners);
  for (int i = 0; i < corners; ++i) {
    const double t = 2 * M_PI * i / corners, r = 1 + 0.4 * std::cos(k * t + phase);
    points.col(i) << r * std::cos(t), r * std::sin(t), 0.4 * std::sin(k * t + phase);
  }
  return points;
}

/// The closed curve as an open one that comes back to where it began.
inline Eigen::Matrix3Xd opened(const Eigen::Matrix3Xd& closed) {
  Eigen::Matrix3Xd open(3, closed.cols() + 1);
  open << closed, closed.col(0);
  return open;
}

inline Eigen::Isometry3d random_motion(std::mt19937_64& rng) {
  std::normal_distribution<double> normal;
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  const Eigen::Quaterniond turn(normal(rng), normal(rng), normal(rng), normal(rng));
  X.linear() = turn.normalized().toRotationMatrix();
  X.translation() << normal(rng), normal(rng), normal(rng);
  return X;
}

}  // namespace graspless::geometry
