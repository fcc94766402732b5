// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <vector>

#include "graspless/perception/render.hpp"
#include "graspless/perception/scene.hpp"

/// Rendered tables for the tests of perception.
namespace graspless::perception {

inline Body box_at(const Eigen::Vector3d& size, const Eigen::Vector3d& p_WB) {
  Body body{{geometry::PlacedShape{geometry::Box{size}}}};
  body.X_WB.translation() = p_WB;
  return body;
}

/// A table top of 0.7 m x 0.6 m at the height 0.4 m.
inline Body table() { return box_at({0.7, 0.6, 0.04}, {0, 0, 0.38}); }
inline Body floor() { return box_at({6, 6, 0.02}, {0, 0, -0.01}); }
/// A box on the table, with its centre above (x, y).
inline Body on_table(const Eigen::Vector3d& size, double x, double y) {
  return box_at(size, {x, y, 0.4 + size.z() / 2});
}

inline Eigen::Isometry3d look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d forward = (target - eye).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  X_WC.linear() << right, forward.cross(right), forward;
  X_WC.translation() = eye;
  return X_WC;
}

/// Sees all of the table.
inline Eigen::Isometry3d eye() { return look_at({-0.7, 0, 1.05}, {0, 0, 0.4}); }

/// Adds noise of 1 mm + 2 mm (z / 1 m)^2, times `noise`.
inline View with_noise(View view, double noise, std::uint64_t seed) {
  std::mt19937_64 rng(seed);
  std::normal_distribution<float> normal;
  for (Eigen::Index i = 0; i < view.depth.size(); ++i) {
    float& z = view.depth.data()[i];
    if (z > 0) z += static_cast<float>(noise) * (0.001f + 0.002f * z * z) * normal(rng);
  }
  return view;
}

/// A noisy image of bodies.
inline View view_of(const std::vector<Body>& bodies, const Eigen::Isometry3d& X_WC,
                    double noise = 1, std::uint64_t seed = 1) {
  return with_noise({render(bodies, X_WC).depth, Camera{}.K, X_WC}, noise, seed);
}

/// The support at the height of the table.
inline const Support* table_in(const Scene& scene) {
  for (const Support& support : scene.supports) {
    if (std::abs(support.X_WS.translation().z() - 0.4) < 0.01) return &support;
  }
  return nullptr;
}

}  // namespace graspless::perception
