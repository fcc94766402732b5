// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/pose.hpp"

#include <stdexcept>

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {

void require_pose(const Eigen::Isometry3d& X, const std::string& field) {
  const Eigen::Matrix3d R = X.linear();
  const bool is_near = X.translation().cwiseAbs().maxCoeff() <= kMaxLength;
  if (X.matrix().allFinite() && is_near && (R * R.transpose()).isIdentity(1e-6) &&
      R.determinant() > 0) {
    return;
  }
  throw std::invalid_argument(field +
                              " must be a rigid pose within 1e4 m: finite, with a rotation");
}

}  // namespace graspless::geometry
