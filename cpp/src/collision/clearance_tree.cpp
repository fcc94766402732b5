// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/clearance_tree.hpp"

#include <algorithm>
#include <limits>
#include <mutex>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include "graspless/watch.hpp"

namespace graspless::collision {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangle = Kernel::Triangle_3;
using Triangles = std::vector<Triangle>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Boxes = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

// Number of points of the surface at which a search may begin.
constexpr Eigen::Index kHints = 64;

constexpr double kBeyond = 1e-9;  // how far beyond the limit a search begins [m]

Kernel::Point_3 to_cgal(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

struct ClearanceTree::Impl {
  Triangles triangles;
  Boxes boxes;
  std::once_flag built;

  const Boxes& tree() {
    std::call_once(built, [this] {
      boxes.insert(triangles.cbegin(), triangles.cend());
      boxes.do_not_accelerate_distance_queries();  // hints are as fast, and cost nothing to build
      boxes.build();
    });
    return boxes;
  }
};

ClearanceTree::ClearanceTree(const std::vector<SurfaceTriangle>& triangles)
    : impl_(std::make_unique<Impl>()) {
  for (const SurfaceTriangle& triangle : triangles) {
    poll();
    const Eigen::Vector3d &a = triangle.a, b = a + triangle.ab, c = a + triangle.ac;
    impl_->triangles.emplace_back(to_cgal(a), to_cgal(b), to_cgal(c));
  }
  const auto count = static_cast<Eigen::Index>(triangles.size());
  hints_.resize(3, std::min(kHints, count));
  for (Eigen::Index i = 0; i < hints_.cols(); ++i) {
    hints_.col(i) = triangles[static_cast<std::size_t>(i * count / hints_.cols())].a;
  }
}

ClearanceTree::~ClearanceTree() = default;

double ClearanceTree::distance(const Eigen::Vector3d& point, double limit) const {
  Eigen::Index best = 0;
  const double squared = (hints_.colwise() - point).colwise().squaredNorm().minCoeff(&best);
  Eigen::Vector3d hint = hints_.col(best);
  const bool is_limited = squared > limit * limit;
  if (is_limited) hint = point + Eigen::Vector3d(limit + kBeyond, 0, 0);
  const auto found = impl_->tree().closest_point(to_cgal(point), to_cgal(hint));
  const Eigen::Vector3d nearest(found.x(), found.y(), found.z());
  const double distance = (point - nearest).norm();
  if (is_limited && distance > limit) return std::numeric_limits<double>::infinity();
  return distance;
}

}  // namespace graspless::collision
