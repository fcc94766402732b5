// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The triangles are projected along a ray's direction. A point lies below a triangle if its
// projection lies in the triangle's, by the crossings of a second ray in the plane, and the
// triangle is higher there. An edge is crossed or not by the same arithmetic in all triangles that
// share it, so a ray near an edge never passes between them or counts them twice.
#include "collision/enclosure.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "graspless/watch.hpp"

#include "geometry/disjoint_sets.hpp"

namespace graspless::collision {
namespace {

/// A rotation along whose axes the sides of a real object hardly ever lie.
Eigen::Matrix3d to_ray() {
  return Eigen::Quaterniond(0.8147, 0.3218, -0.4163, 0.2391).normalized().toRotationMatrix();
}

}  // namespace

bool Enclosure::contains(const Eigen::Vector3d& p) const {
  once_([this] { prepare(); });
  if (mesh_.triangles.cols() == 0) return false;
  const Eigen::Vector3d turned = to_ray() * p;
  const Eigen::Vector2i at = cell(turned.head<2>());
  if ((at.array() < 0).any() || (at.array() >= num_cells_.array()).any()) return false;
  bool inside = false;
  for (const int i : cells_[at.y() * num_cells_.x() + at.x()]) {
    inside ^= covers(i, turned.head<2>()) && lies_below(i, turned);
  }
  return inside;
}

const Eigen::Matrix3Xd& Enclosure::vertex_of_each_part() const {
  once_([this] { prepare(); });
  return parts_;
}

void Enclosure::prepare() const {
  weld();
  find_parts();
  if (!is_closed()) {
    mesh_ = {};
    return;
  }
  Eigen::Matrix3Xd turned = to_ray() * mesh_.vertices;
  fill_grid(turned.topRows<2>());
  mesh_.vertices = std::move(turned);  // last: a preparation that was stopped begins anew
}

/// Gives vertices at the same place the same index.
void Enclosure::weld() const {
  const Eigen::Matrix3Xd& v = mesh_.vertices;
  std::vector<int> order(v.cols());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) { return std::make_tuple(v(0, i), v(1, i), v(2, i)); };
  poll();
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return std::make_pair(key(i), i) < std::make_pair(key(j), j); });
  std::vector<int> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_new = i == 0 || key(order[i]) != key(order[i - 1]);
    first[order[i]] = is_new ? order[i] : first[order[i - 1]];
  }
  for (auto& index : mesh_.triangles.reshaped()) index = first[index];
}

bool Enclosure::is_closed() const {
  std::vector<std::pair<int, int>> edges;
  for (const auto& triangle : mesh_.triangles.colwise()) {
    for (int k = 0; k < 3; ++k) {
      const int i = triangle[k], j = triangle[(k + 1) % 3];
      if (i != j) edges.emplace_back(std::min(i, j), std::max(i, j));
    }
  }
  poll();
  std::sort(edges.begin(), edges.end());
  for (auto it = edges.begin(); it != edges.end();) {
    const auto end = std::upper_bound(it, edges.end(), *it);
    if ((end - it) % 2 != 0) return false;
    it = end;
  }
  return !edges.empty();
}

/// `flat`: the vertices in the plane across the ray.
void Enclosure::fill_grid(const Eigen::Matrix2Xd& flat) const {
  corner_ = flat.rowwise().minCoeff();
  constexpr double kTiny = 1e-9;
  const Eigen::Vector2d size = (flat.rowwise().maxCoeff() - corner_).cwiseMax(kTiny);
  const double side = std::sqrt(size.prod() / static_cast<double>(mesh_.triangles.cols()));
  constexpr double kMostCells = 1024;  // along an axis
  for (int axis = 0; axis < 2; ++axis) {
    num_cells_[axis] = static_cast<int>(std::clamp(size[axis] / side, 1.0, kMostCells));
    scale_[axis] = num_cells_[axis] / size[axis];
  }
  cells_.assign(num_cells_.prod(), {});
  for (Eigen::Index i = 0; i < mesh_.triangles.cols(); ++i) {
    poll();
    const Eigen::Matrix<double, 2, 3> corners = flat(Eigen::all, mesh_.triangles.col(i));
    const Eigen::Vector2i most = num_cells_.array() - 1;
    const Eigen::Vector2i from = cell(corners.rowwise().minCoeff()).cwiseMin(most);
    const Eigen::Vector2i to = cell(corners.rowwise().maxCoeff()).cwiseMin(most);
    for (int y = from.y(); y <= to.y(); ++y) {
      for (int x = from.x(); x <= to.x(); ++x) {
        cells_[y * num_cells_.x() + x].push_back(static_cast<int>(i));
      }
    }
  }
}

Eigen::Vector2i Enclosure::cell(const Eigen::Vector2d& p) const {
  const Eigen::Array2d at = (p - corner_).array() * scale_.array();
  return at.floor().max(-1.0).min(1e6).matrix().cast<int>();
}

/// True if p lies in the projection of a triangle.
bool Enclosure::covers(Eigen::Index triangle, const Eigen::Vector2d& p) const {
  bool inside = false;
  for (int k = 0; k < 3; ++k) {
    const auto [i, j] =
        std::minmax<int>(mesh_.triangles(k, triangle), mesh_.triangles((k + 1) % 3, triangle));
    const Eigen::Vector2d a = mesh_.vertices.col(i).head<2>(), b = mesh_.vertices.col(j).head<2>();
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    inside ^= a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()) > p.x();
  }
  return inside;
}

/// True if p, which lies in the projection of a triangle, lies below it.
bool Enclosure::lies_below(Eigen::Index triangle, const Eigen::Vector3d& p) const {
  const Eigen::Vector3d a = mesh_.vertices.col(mesh_.triangles(0, triangle)),
                        b = mesh_.vertices.col(mesh_.triangles(1, triangle)),
                        c = mesh_.vertices.col(mesh_.triangles(2, triangle));
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  return normal.z() != 0 && (a - p).dot(normal) / normal.z() > 0;
}

void Enclosure::find_parts() const {
  constexpr std::size_t kMost = 64;  // more are loose triangles, which bound nothing
  geometry::DisjointSets connected(static_cast<int>(mesh_.vertices.cols()));
  for (const auto& triangle : mesh_.triangles.colwise()) {
    for (int k = 1; k < 3; ++k) connected.join(triangle[k], triangle[0]);
  }
  std::vector<int> parts;
  for (Eigen::Index i = 0; i < mesh_.triangles.cols() && parts.size() < kMost; ++i) {
    const int part = connected.root(mesh_.triangles(0, i));
    if (std::find(parts.begin(), parts.end(), part) == parts.end()) parts.push_back(part);
  }
  parts_ = mesh_.vertices(Eigen::all, parts);
}

}  // namespace graspless::collision
