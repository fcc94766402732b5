// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/distance.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <variant>
#include <vector>

#include "graspless/collision/clearance.hpp"

#include "clasp/free_space/link_spheres.hpp"

namespace graspless::clasp {
namespace {

constexpr double kDifference = 1e-5;  // of finite differences [m]

std::optional<Axis> axis_of(const geometry::PlacedShape& placed) {
  if (const auto* sphere = std::get_if<geometry::Sphere>(&placed.shape))
    return Axis{placed.X_BG.translation(), Eigen::Vector3d::Zero(), sphere->radius};
  const auto* capsule = std::get_if<geometry::Capsule>(&placed.shape);
  if (!capsule) return std::nullopt;
  const Eigen::Vector3d along = capsule->length * placed.X_BG.linear().col(2);
  return Axis{placed.X_BG.translation() - along / 2, along, capsule->radius};
}

}  // namespace

Distance distance_to(const geometry::PlacedShape& placed) {
  const Eigen::Isometry3d X_GB = placed.X_BG.inverse();
  if (const auto* mesh = std::get_if<geometry::Mesh>(&placed.shape)) {
    auto surface = std::make_shared<collision::Clearance>(*mesh);
    return [surface, X_GB](const Eigen::Vector3d& p, double limit) {
      return surface->distance(X_GB * p, limit);
    };
  }
  if (const auto* box = std::get_if<geometry::Box>(&placed.shape)) {
    return [half = Eigen::Vector3d(box->size / 2), X_GB](const Eigen::Vector3d& p, double) {
      const Eigen::Vector3d beyond = (X_GB * p).cwiseAbs() - half;
      return beyond.cwiseMax(0).norm() + std::min(beyond.maxCoeff(), 0.0);
    };
  }
  if (const auto* capsule = std::get_if<geometry::Capsule>(&placed.shape)) {
    return [radius = capsule->radius, half = capsule->length / 2, X_GB](const Eigen::Vector3d& p,
                                                                        double) {
      Eigen::Vector3d beyond = X_GB * p;
      beyond.z() -= std::clamp(beyond.z(), -half, half);
      return beyond.norm() - radius;
    };
  }
  return [shape = covered(placed, MeshInside::hull)](const Eigen::Vector3d& p, double) {
    return -shape.depth(p);
  };
}

Body body_of(const robot::LinkShape& shape) {
  const bool is_convex = !std::holds_alternative<geometry::Mesh>(shape.placed.shape);
  Body body{shape.link, distance_to(shape.placed), Eigen::Vector3d::Zero(), 0,
            is_convex,  axis_of(shape.placed)};
  const std::vector<Sphere> spheres = covered(shape.placed, MeshInside::hull).spheres;
  for (const Sphere& sphere : spheres)
    body.center_L += sphere.center / static_cast<double>(spheres.size());
  for (const Sphere& sphere : spheres)
    body.radius = std::max(body.radius, (sphere.center - body.center_L).norm() + sphere.radius);
  return body;
}

Eigen::Vector3d gradient(const Distance& distance, const Eigen::Vector3d& p_L, double gap) {
  const double limit = gap + 2 * kDifference;
  Eigen::Vector3d g;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d step = kDifference * Eigen::Vector3d::Unit(k);
    g[k] = distance(p_L + step, limit) - distance(p_L - step, limit);
  }
  const double length = g.norm();
  return length > 0 ? Eigen::Vector3d(g / length) : Eigen::Vector3d::Zero();
}

Gap::Gap(const std::vector<Body>& bodies, const robot::Poses& X_WL) : bodies_(bodies) {
  for (const Body& body : bodies) X_LW_.push_back(X_WL[body.link].inverse());
}

double Gap::at(const Eigen::Vector3d& p_W, double limit) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const Eigen::Vector3d p_L = X_LW_[i] * p_W;
    const double beyond = std::min(least, limit);
    if (bodies_[i].at_least(p_L) <= beyond)
      least = std::min(least, bodies_[i].distance(p_L, beyond));
  }
  return least;
}

Eigen::Vector3d Gap::normal(const Eigen::Vector3d& p_W, double gap) const {
  return gradient([this](const Eigen::Vector3d& p, double limit) { return at(p, limit); }, p_W,
                  gap);
}

}  // namespace graspless::clasp
