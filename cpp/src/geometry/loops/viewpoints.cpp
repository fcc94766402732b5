// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays of cameras of which only the positions are known.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "graspless/geometry/ray_image.hpp"
#include "graspless/geometry/sampling.hpp"
#include "graspless/watch.hpp"

#include "geometry/require_points.hpp"

namespace graspless::geometry {
namespace {

constexpr Eigen::Index kFewestPoints = 20;  // points
constexpr double kWidestSlope = 1.7320508;  // tangent of 60 degrees
constexpr double kLongestSide = 1000;       // along a side
constexpr int kDrawn = 2;                   // of a point [pixels]
constexpr int kFrame = kDrawn + 3;          // around all points [pixels]

/// Pose of an optical frame at `eye` that looks at `target`.
Eigen::Isometry3d look_at(const Eigen::Vector3d& eye, const Eigen::Vector3d& target) {
  const Eigen::Vector3d z = (target - eye).normalized();
  const Eigen::Vector3d x = z.unitOrthogonal();
  Eigen::Isometry3d X_OC = Eigen::Isometry3d::Identity();
  X_OC.linear() << x, z.cross(x), z;
  X_OC.translation() = eye;
  return X_OC;
}

[[noreturn]] void refuse(Eigen::Index view) {
  throw std::invalid_argument("viewpoints[" + std::to_string(view) +
                              "] is among the points; they must lie within 60 degrees of one "
                              "direction");
}

/// Marks the pixels within reach of a point, which ends their rays.
void draw(double u, double v, float depth, RayImage& rays) {
  const auto column = static_cast<Eigen::Index>(std::lround(u));
  const auto row = static_cast<Eigen::Index>(std::lround(v));
  for (Eigen::Index y = row - kDrawn; y <= row + kDrawn; ++y) {
    for (Eigen::Index x = column - kDrawn; x <= column + kDrawn; ++x) {
      if (std::hypot(static_cast<double>(x) - u, static_cast<double>(y) - v) > kDrawn) continue;
      float& end = rays.ends(y, x);
      if (end > 0 || -end > depth) end = -depth;
    }
  }
}

RayImage rays_of(const Eigen::Matrix3Xd& points, const Eigen::Isometry3d& X_OC, Eigen::Index view) {
  const Eigen::Matrix3Xd p_C = X_OC.inverse() * points;
  if (!(p_C.row(2).minCoeff() > 0)) refuse(view);
  const Eigen::Matrix2Xd at = p_C.colwise().hnormalized();
  if (at.cwiseAbs().maxCoeff() > kWidestSlope) refuse(view);
  Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Zero(3, at.cols());
  flat.topRows<2>() = at;
  const Eigen::Vector2d low = at.rowwise().minCoeff(), size = at.rowwise().maxCoeff() - low;
  const double pixel = std::max(spacing(flat), size.maxCoeff() / kLongestSide);
  if (!(pixel > 0)) {
    throw std::invalid_argument("points must not all lie on one ray of viewpoints[" +
                                std::to_string(view) + "]");
  }
  RayImage rays;
  rays.X_OC = X_OC;
  const Eigen::Vector2d first = Eigen::Vector2d::Constant(kFrame) - low / pixel;
  rays.K << 1 / pixel, 0, first.x(), 0, 1 / pixel, first.y(), 0, 0, 1;
  const auto count = [&](double length) {
    return static_cast<Eigen::Index>(std::ceil(length / pixel)) + 2 * kFrame + 1;
  };
  rays.ends.setConstant(count(size.y()), count(size.x()), std::numeric_limits<float>::infinity());
  for (Eigen::Index i = 0; i < at.cols(); ++i) {
    if (i % 1024 == 0) poll();
    draw(at(0, i) / pixel + first.x(), at(1, i) / pixel + first.y(), static_cast<float>(p_C(2, i)),
         rays);
  }
  return rays;
}

}  // namespace

std::vector<RayImage> rays_from_viewpoints(const Eigen::Matrix3Xd& points,
                                           const Eigen::Matrix3Xd& viewpoints) {
  require_points(points, "points");
  require_points(viewpoints, "viewpoints");
  if (points.cols() < kFewestPoints) {
    throw std::invalid_argument("points must hold at least " + std::to_string(kFewestPoints) +
                                " points, not " + std::to_string(points.cols()));
  }
  const Eigen::Vector3d middle = (points.rowwise().minCoeff() + points.rowwise().maxCoeff()) / 2;
  std::vector<RayImage> result;
  for (Eigen::Index i = 0; i < viewpoints.cols(); ++i) {
    if ((viewpoints.col(i) - middle).norm() == 0) refuse(i);
    result.push_back(rays_of(points, look_at(viewpoints.col(i), middle), i));
  }
  return result;
}

}  // namespace graspless::geometry
