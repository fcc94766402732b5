// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <vector>

#include <Eigen/Geometry>

/// Point clouds whose holes are known.
namespace graspless::geometry {

inline Eigen::Matrix3Xd side_by_side(std::initializer_list<Eigen::Matrix3Xd> clouds) {
  Eigen::Index n = 0;
  for (const auto& cloud : clouds) n += cloud.cols();
  Eigen::Matrix3Xd all(3, n);
  n = 0;
  for (const auto& cloud : clouds) {
    all.middleCols(n, cloud.cols()) = cloud;
    n += cloud.cols();
  }
  return all;
}

inline Eigen::Matrix3Xd moved(const Eigen::Matrix3Xd& cloud, const Eigen::Vector3d& by) {
  return cloud.colwise() + by;
}

inline Eigen::Matrix3Xd random_cloud(int n, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::uniform_real_distribution<double> u(0, 1);
  return Eigen::Matrix3Xd::NullaryExpr(3, n, [&] { return u(rng); });
}

inline Eigen::Matrix3Xd noisy(Eigen::Matrix3Xd cloud, double sigma, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::normal_distribution<double> normal(0, sigma);
  for (double& value : cloud.reshaped()) value += normal(rng);
  return cloud;
}

/// The surface of a ring about z: points in rows around a tube, about `spacing` apart.
inline Eigen::Matrix3Xd torus(double radius, double tube, double spacing) {
  const auto count = [&](double r) {
    return std::max(3, static_cast<int>(std::ceil(2 * M_PI * r / spacing)));
  };
  std::vector<Eigen::Vector3d> points;
  const int rows = count(tube);
  for (int i = 0; i < rows; ++i) {
    const double v = 2 * M_PI * i / rows, r = radius + tube * std::cos(v);
    const int n = count(r);
    for (int k = 0; k < n; ++k) {
      const double u = 2 * M_PI * (k + 0.5 * (i % 2) + 0.01 * std::sin(7 * k + i)) / n;
      points.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
    }
  }
  return Eigen::Map<Eigen::Matrix3Xd>(points[0].data(), 3,
                                      static_cast<Eigen::Index>(points.size()));
}

/// A sphere's surface (a spiral).
inline Eigen::Matrix3Xd sphere_cloud(double radius, int n) {
  Eigen::Matrix3Xd cloud(3, n);
  for (int i = 0; i < n; ++i) {
    const double z = 1 - (2.0 * i + 1) / n, a = 2.399963229728653 * i;
    cloud.col(i) << std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a), z;
  }
  return radius * cloud;
}

}  // namespace graspless::geometry
