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

namespace graspless::collision {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangle = Kernel::Triangle_3;
using Triangles = std::vector<Triangle>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Boxes = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

// A triangle thinner than this is given that width, for CGAL needs its normal [m].
constexpr double kMinWidth = 1e-9;

// Points of the surface from which a search may begin.
constexpr Eigen::Index kHints = 64;

Kernel::Point_3 to_cgal(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

/// Some vector of length kMinWidth at right angles to `axis`.
Eigen::Vector3d aside(const Eigen::Vector3d& axis) { return kMinWidth * axis.unitOrthogonal(); }

Triangle with_width(Eigen::Vector3d a, Eigen::Vector3d b, Eigen::Vector3d c) {
  const Eigen::Vector3d sides[] = {b - a, c - b, a - c};
  const auto longest = *std::max_element(
      std::begin(sides), std::end(sides),
      [](const auto& s, const auto& t) { return s.squaredNorm() < t.squaredNorm(); });
  const double length = longest.norm();
  if (length < kMinWidth) {
    return {to_cgal(a), to_cgal(a + kMinWidth * Eigen::Vector3d::UnitX()),
            to_cgal(a + kMinWidth * Eigen::Vector3d::UnitY())};
  }
  if (sides[0].cross(sides[1]).norm() >= kMinWidth * length) {
    return {to_cgal(a), to_cgal(b), to_cgal(c)};
  }
  // On one line: the ends of the longest side, and a third corner beside its middle.
  const int first = (longest == sides[0]) ? 0 : (longest == sides[1]) ? 1 : 2;
  const Eigen::Vector3d& p = first == 0 ? a : first == 1 ? b : c;
  return {to_cgal(p), to_cgal(p + longest), to_cgal(p + longest / 2 + aside(longest))};
}

}  // namespace

struct ClearanceTree::Impl {
  Triangles triangles;
  Boxes boxes;
  std::once_flag built;

  const Boxes& tree() {
    std::call_once(built, [this] {
      boxes.insert(triangles.cbegin(), triangles.cend());
      boxes.do_not_accelerate_distance_queries();  // hints are as good, and cost nothing to build
      boxes.build();
    });
    return boxes;
  }
};

ClearanceTree::ClearanceTree(const geometry::Mesh& mesh) : impl_(std::make_unique<Impl>()) {
  const Eigen::Index count = mesh.triangles.cols();
  impl_->triangles.reserve(static_cast<std::size_t>(count));
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto corners = mesh.triangles.col(i);
    impl_->triangles.push_back(with_width(mesh.vertices.col(corners[0]),
                                          mesh.vertices.col(corners[1]),
                                          mesh.vertices.col(corners[2])));
  }
  hints_.resize(3, std::min(kHints, count));
  for (Eigen::Index i = 0; i < hints_.cols(); ++i) {
    const Kernel::Point_3& p =
        impl_->triangles[static_cast<std::size_t>(i * count / hints_.cols())].vertex(0);
    hints_.col(i) << p.x(), p.y(), p.z();
  }
}

ClearanceTree::~ClearanceTree() = default;

double ClearanceTree::distance(const Eigen::Vector3d& point, Eigen::Vector3d& near) const {
  const auto nearest = impl_->tree().closest_point(to_cgal(point), to_cgal(near));
  near << nearest.x(), nearest.y(), nearest.z();
  return (point - near).norm();
}

double ClearanceTree::distance(const Eigen::Vector3d& point) const {
  Eigen::Index best = 0;
  (hints_.colwise() - point).colwise().squaredNorm().minCoeff(&best);
  Eigen::Vector3d near = hints_.col(best);
  return distance(point, near);
}

}  // namespace graspless::collision
