// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/distance.hpp"

#include <memory>
#include <variant>

#include "graspless/collision/clearance.hpp"

#include "clasp/free_space/link_spheres.hpp"

namespace graspless::clasp {
namespace {

constexpr double kDifference = 1e-5;  // of finite differences [m]

}  // namespace

Distance distance_to(const geometry::PlacedShape& placed) {
  const Eigen::Isometry3d X_GB = placed.X_BG.inverse();
  if (const auto* mesh = std::get_if<geometry::Mesh>(&placed.shape)) {
    auto surface = std::make_shared<collision::Clearance>(*mesh);
    return [surface, X_GB](const Eigen::Vector3d& p) { return surface->distance(X_GB * p); };
  }
  if (const auto* box = std::get_if<geometry::Box>(&placed.shape)) {
    return [half = Eigen::Vector3d(box->size / 2), X_GB](const Eigen::Vector3d& p) {
      const Eigen::Vector3d beyond = (X_GB * p).cwiseAbs() - half;
      return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
    };
  }
  return [shape = covered(placed, MeshInside::hull)](const Eigen::Vector3d& p) {
    return -shape.depth(p);
  };
}

Eigen::Vector3d gradient(const Distance& distance, const Eigen::Vector3d& p_L) {
  Eigen::Vector3d g;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d step = kDifference * Eigen::Vector3d::Unit(k);
    g[k] = distance(p_L + step) - distance(p_L - step);
  }
  const double length = g.norm();
  return length > 0 ? Eigen::Vector3d(g / length) : Eigen::Vector3d::Zero();
}

}  // namespace graspless::clasp
