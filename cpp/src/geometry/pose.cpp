// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/pose.hpp"

#include <cmath>
#include <stdexcept>

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {

namespace {
constexpr double kOff = 1e-6;  // of the products of a rotation's columns, rounding included
}

bool is_pose(const Eigen::Isometry3d& X) {
  const Eigen::Vector3d x = X.linear().col(0), y = X.linear().col(1), z = X.linear().col(2);
  return (X.translation().array().abs() <= kMaxLength).all() &&
         std::abs(x.squaredNorm() - 1) <= kOff && std::abs(y.squaredNorm() - 1) <= kOff &&
         std::abs(x.dot(y)) <= kOff && (x.cross(y) - z).squaredNorm() <= kOff * kOff;
}

void require_pose(const Eigen::Isometry3d& X, const std::string& field) {
  if (is_pose(X)) return;
  throw std::invalid_argument(field +
                              " must be a rigid pose within 1e4 m: finite, with a rotation");
}

}  // namespace graspless::geometry
