// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Paths of one degree of freedom: slides, turns, and one after another.
#include <stdexcept>
#include <string>

#include "graspless/fingertip/problem.hpp"

#include "fingertip/model/screw.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kJoint = 1e-6;  // how well paths must meet [m, rad]

void require_segments(int segments) {
  if (segments >= 1) return;
  throw std::invalid_argument("segments must be one or more, not " + std::to_string(segments));
}

}  // namespace

Path slide_path(const Eigen::Isometry3d& X_WO_start, const Eigen::Vector3d& translation_W,
                int segments) {
  require_segments(segments);
  if (!(translation_W.allFinite() && translation_W.norm() > 0)) {
    throw std::invalid_argument("translation_W must be finite and not zero");
  }
  Path path;
  for (int i = 0; i <= segments; ++i) {
    Eigen::Isometry3d X_WO = X_WO_start;
    X_WO.translation() += translation_W * i / segments;
    path.X_WO.push_back(X_WO);
  }
  return path;
}

Path turn_path(const Eigen::Isometry3d& X_WO_start, const Eigen::Vector3d& point_W,
               const Eigen::Vector3d& axis_W, double angle, int segments) {
  require_segments(segments);
  if (!(axis_W.allFinite() && axis_W.norm() > 0 && point_W.allFinite())) {
    throw std::invalid_argument("axis_W must be finite and not zero, and point_W finite");
  }
  if (!(std::abs(angle) > 0 && std::isfinite(angle))) {
    throw std::invalid_argument("angle must be finite and not zero, not " + std::to_string(angle));
  }
  const Eigen::Translation3d to_point(point_W), from_point(-point_W);
  Path path;
  for (int i = 0; i <= segments; ++i) {
    const Eigen::AngleAxisd turn(angle * i / segments, axis_W.normalized());
    path.X_WO.push_back(to_point * turn * from_point * X_WO_start);
  }
  return path;
}

Path join(const std::vector<Path>& paths) {
  Path all;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (paths[i].X_WO.empty()) {
      throw std::invalid_argument("paths[" + std::to_string(i) + "] must not be empty");
    }
    auto first = paths[i].X_WO.begin();
    if (i > 0) {
      const mechanics::Vector6d gap = screw_between(all.X_WO.back(), *first);
      if (!(gap.cwiseAbs().maxCoeff() <= kJoint)) {
        throw std::invalid_argument("paths[" + std::to_string(i) +
                                    "] must start where the one before ends, but is " +
                                    std::to_string(gap.head<3>().norm()) + " m and " +
                                    std::to_string(gap.tail<3>().norm()) + " rad away");
      }
      ++first;
    }
    all.X_WO.insert(all.X_WO.end(), first, paths[i].X_WO.end());
  }
  return all;
}

}  // namespace graspless::fingertip
