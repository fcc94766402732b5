// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/clearance_tree.hpp"

#include <algorithm>
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

double ClearanceTree::distance(const Eigen::Vector3d& point) const {
  Eigen::Index best = 0;
  (hints_.colwise() - point).colwise().squaredNorm().minCoeff(&best);
  const auto nearest =
      impl_->tree().closest_point(to_cgal(point), to_cgal(Eigen::Vector3d(hints_.col(best))));
  return (point - Eigen::Vector3d(nearest.x(), nearest.y(), nearest.z())).norm();
}

}  // namespace graspless::collision
