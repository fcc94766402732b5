// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "graspless/collision/clearance.hpp"
#include "graspless/watch.hpp"

#include "clasp/free_space/link_spheres.hpp"
#include "geometry/convex_hull.hpp"

namespace graspless::clasp {
namespace {

using Depth = std::function<double(const Eigen::Vector3d&)>;

constexpr double kCapsuleExcess = 0.0001;  // of the spheres beyond a capsule [m]
constexpr double kCell = 0.008;            // side of the cells of other shapes [m]
constexpr double kMaxCells = 600;          // approximate limit per shape

double no_depth(const Eigen::Vector3d&) { return -1; }

CoveredShape cover(const geometry::Sphere& sphere, MeshInside) {
  const double radius = sphere.radius;
  return {{{Eigen::Vector3d::Zero(), radius}},
          [radius](const Eigen::Vector3d& p) { return radius - p.norm(); }};
}

CoveredShape cover(const geometry::Capsule& capsule, MeshInside) {
  const double radius = capsule.radius, half = capsule.length / 2;
  const auto gaps =
      static_cast<int>(std::ceil(half / std::sqrt(kCapsuleExcess * (2 * radius + kCapsuleExcess))));
  const double step = capsule.length / gaps;
  CoveredShape shape;
  for (int i = 0; i <= gaps; ++i) {
    shape.spheres.push_back({{0, 0, i * step - half}, std::hypot(radius, step / 2)});
  }
  shape.depth = [radius, half](const Eigen::Vector3d& p) {
    return radius - (p - Eigen::Vector3d(0, 0, std::clamp(p.z(), -half, half))).norm();
  };
  return shape;
}

/// Spheres around the cells of the box from `low` to `high` that `keep` accepts.
template <typename Keep>
std::vector<Sphere> cells(const Eigen::Vector3d& low, const Eigen::Vector3d& high, Keep keep) {
  const Eigen::Vector3d size = (high - low).cwiseMax(1e-6);
  const double side = std::max(kCell, std::cbrt(size.prod() / kMaxCells));
  const Eigen::Vector3i count = (size / side).array().ceil().cast<int>();
  const Eigen::Vector3d cell = size.cwiseQuotient(count.cast<double>());
  const double radius = cell.norm() / 2;
  std::vector<Sphere> spheres;
  for (int x = 0; x < count.x(); ++x) {
    for (int y = 0; y < count.y(); ++y) {
      for (int z = 0; z < count.z(); ++z) {
        poll();
        const Eigen::Vector3d center =
            low + cell.cwiseProduct(Eigen::Vector3d(x + 0.5, y + 0.5, z + 0.5));
        if (keep(center, radius)) spheres.push_back({center, radius});
      }
    }
  }
  return spheres;
}

CoveredShape cover(const geometry::Box& box, MeshInside) {
  const Eigen::Vector3d half = box.size / 2;
  return {cells(-half, half, [](const auto&, double) { return true; }),
          [half](const Eigen::Vector3d& p) { return (half - p.cwiseAbs()).minCoeff(); }};
}

Depth hull_depth(const geometry::Mesh& hull) {
  return [planes = geometry::half_spaces(hull)](const Eigen::Vector3d& p) {
    return (planes.row(3) - p.transpose() * planes.topRows<3>()).minCoeff();
  };
}

CoveredShape cover_hull(const geometry::Mesh& hull) {
  const Depth depth = hull_depth(hull);
  const auto keep = [&](const Eigen::Vector3d& p, double radius) { return depth(p) > -radius; };
  return {cells(hull.vertices.rowwise().minCoeff(), hull.vertices.rowwise().maxCoeff(), keep),
          depth};
}

CoveredShape cover(const geometry::Convex& convex, MeshInside) {
  return cover_hull(geometry::convex_hull(convex.vertices));
}

CoveredShape cover(const geometry::Mesh& mesh, MeshInside inside) {
  if (geometry::spans_volume(mesh.vertices)) {
    const geometry::Mesh hull = geometry::convex_hull(mesh.vertices);
    if (inside == MeshInside::hull || geometry::is_convex(mesh, hull)) return cover_hull(hull);
  }
  const collision::Clearance surface(mesh);
  const auto keep = [&](const Eigen::Vector3d& p, double radius) {
    return surface.distance(p) <= 1.001 * radius;
  };
  return {cells(mesh.vertices.rowwise().minCoeff(), mesh.vertices.rowwise().maxCoeff(), keep),
          no_depth};
}

}  // namespace

CoveredShape covered(const geometry::PlacedShape& placed, MeshInside inside) {
  CoveredShape shape =
      std::visit([&](const auto& kind) { return cover(kind, inside); }, placed.shape);
  for (Sphere& sphere : shape.spheres) sphere.center = placed.X_BG * sphere.center;
  const Eigen::Isometry3d X_GB = placed.X_BG.inverse();
  shape.depth = [X_GB, depth = std::move(shape.depth)](const Eigen::Vector3d& p) {
    return depth(X_GB * p);
  };
  return shape;
}

}  // namespace graspless::clasp
