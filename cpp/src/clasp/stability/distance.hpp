// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/shape.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::clasp {

/// Distance of a point in the frame of a link [m]. One above `limit` may be infinite.
using Distance = std::function<double(const Eigen::Vector3d& p_L, double limit)>;

/// Distance of a point outside a shape. Meshes are surfaces.
Distance distance_to(const geometry::PlacedShape& placed);

/// Segment that a capsule or a sphere has at its middle: all points within the radius belong to it.
struct Axis {
  Eigen::Vector3d from, along;  ///< one end, and the way to the other [m]
  double radius;                ///< [m]
};

/// Shape of a link, and a ball around it.
struct Body {
  int link;
  Distance distance;
  Eigen::Vector3d center_L;
  double radius;   ///< [m]
  bool is_convex;  ///< then the distance is a convex function, too
  std::optional<Axis> axis_L = std::nullopt;

  /// Lower bound on the distance of a point [m]; cheap.
  double at_least(const Eigen::Vector3d& p_L) const { return (p_L - center_L).norm() - radius; }
};
Body body_of(const robot::LinkShape& shape);

/// Unit gradient by finite differences at a point whose distance is at most `gap`; zero where there
/// is none.
Eigen::Vector3d gradient(const Distance& distance, const Eigen::Vector3d& p_L, double gap);

/// Distance of points from bodies at one configuration. Refers to the bodies.
class Gap {
 public:
  Gap(const std::vector<Body>& bodies, const robot::Poses& X_WL);
  /// Distance of a point [m]; infinite if it is surely above `limit`.
  double at(const Eigen::Vector3d& p_W, double limit) const;
  /// Unit normal of the bodies at a point whose distance is `gap`; zero where there is none.
  Eigen::Vector3d normal(const Eigen::Vector3d& p_W, double gap) const;

 private:
  const std::vector<Body>& bodies_;
  robot::Poses X_LW_;
};

/// Triangle, and a ball around it.
struct Facet {
  explicit Facet(const Eigen::Matrix3d& corners)
      : corners(corners),
        center(corners.rowwise().mean()),
        size((corners.colwise() - center).colwise().norm().maxCoeff()) {}

  Eigen::Matrix3d corners;
  Eigen::Vector3d center;
  double size;  ///< radius of the ball [m]
};

/// Calls visit(p) for points on a triangle, at most `spacing` apart [m].
template <typename Visit>
void visit_points(const Eigen::Matrix3d& corners, double spacing, Visit visit) {
  const Eigen::Vector3d a = corners.col(0), u = corners.col(1) - a, v = corners.col(2) - a;
  const double longest = std::max({u.norm(), v.norm(), (u - v).norm()});
  const int n = std::clamp(static_cast<int>(std::ceil(longest / spacing)), 1, 60);
  for (int i = 0; i <= n; ++i) {
    for (int k = 0; i + k <= n; ++k) visit(Eigen::Vector3d(a + (i * u + k * v) / n));
  }
}

}  // namespace graspless::clasp
