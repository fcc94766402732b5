// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/require_points.hpp"

#include <sstream>
#include <stdexcept>

#include "graspless/geometry/shape.hpp"

namespace graspless::geometry {

void require_points(const Eigen::Matrix3Xd& points, const std::string& what) {
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    if ((points.col(i).array().abs() <= kMaxLength).all()) continue;
    std::ostringstream fault;
    fault << what << " must be within " << kMaxLength << " m of the origin, but point " << i
          << " is (" << points.col(i).transpose() << ")";
    throw std::invalid_argument(fault.str());
  }
}

}  // namespace graspless::geometry
