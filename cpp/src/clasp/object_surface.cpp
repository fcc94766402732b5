// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/object_surface.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace graspless::clasp {
namespace {

constexpr double kWidth = 0.001;  // of the triangle that stands for an edge [m]

std::uint64_t edge_key(int low, int high) {
  return (static_cast<std::uint64_t>(low) << 32) | static_cast<std::uint32_t>(high);
}

/// Edges of the complex that bound no triangle.
std::vector<int> bare_edges(const geometry::Complex& complex) {
  std::unordered_set<std::uint64_t> bounding;
  bounding.reserve(static_cast<std::size_t>(3 * complex.triangles.cols()));
  for (Eigen::Index i = 0; i < complex.triangles.cols(); ++i) {
    const auto corners = complex.triangles.col(i);  // ascending
    bounding.insert(edge_key(corners[0], corners[1]));
    bounding.insert(edge_key(corners[0], corners[2]));
    bounding.insert(edge_key(corners[1], corners[2]));
  }
  std::vector<int> bare;
  for (Eigen::Index i = 0; i < complex.edges.cols(); ++i) {
    if (bounding.count(edge_key(complex.edges(0, i), complex.edges(1, i))) == 0) {
      bare.push_back(static_cast<int>(i));
    }
  }
  return bare;
}

/// The third corner of the triangle that stands for the edge from a to b.
Eigen::Vector3d beside(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  return (a + b) / 2 + std::min(kWidth, along.norm() / 10) * along.unitOrthogonal();
}

geometry::Mesh specks(const Eigen::Matrix3Xd& points) {
  const Eigen::Index count = points.cols();
  geometry::Mesh mesh;
  mesh.vertices.resize(3, 3 * count);
  mesh.vertices << points, points.colwise() + kWidth * Eigen::Vector3d::UnitX(),
      points.colwise() + kWidth * Eigen::Vector3d::UnitY();
  mesh.triangles.resize(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const int corner = static_cast<int>(i), step = static_cast<int>(count);
    mesh.triangles.col(i) << corner, corner + step, corner + 2 * step;
  }
  return mesh;
}

/// The triangles of a complex by their corners, and the points that make a triangle with an edge.
class TriangleTable {
 public:
  explicit TriangleTable(const geometry::Complex& complex) : points_(complex.points) {
    const auto& triangles = complex.triangles;
    apexes_.reserve(static_cast<std::size_t>(2 * triangles.cols()));
    for (Eigen::Index i = 0; i < triangles.cols(); ++i) {
      const auto corners = triangles.col(i);  // ascending
      apexes_[edge_key(corners[0], corners[1])].push_back(corners[2]);
      apexes_[edge_key(corners[0], corners[2])].push_back(corners[1]);
      apexes_[edge_key(corners[1], corners[2])].push_back(corners[0]);
    }
  }

  /// Whether there is a tetrahedron of triangles on either side of this one.
  bool is_walled_in(int a, int b, int c) const {
    const Eigen::Vector3d p = points_.col(a);
    const Eigen::Vector3d normal = (points_.col(b) - p).cross(Eigen::Vector3d(points_.col(c) - p));
    bool above = false, below = false;
    for (const int d : apexes_.at(edge_key(a, b))) {
      if (d == c || !has(a, c, d) || !has(b, c, d)) continue;
      const double side = normal.dot(Eigen::Vector3d(points_.col(d) - p));
      above = above || side > 0;
      below = below || side < 0;
    }
    return above && below;
  }

 private:
  bool has(int a, int b, int c) const {
    const auto found = apexes_.find(edge_key(std::min(a, b), std::max(a, b)));
    return found != apexes_.end() &&
           std::find(found->second.begin(), found->second.end(), c) != found->second.end();
  }

  const Eigen::Matrix3Xd& points_;
  std::unordered_map<std::uint64_t, std::vector<int>> apexes_;
};

}  // namespace

geometry::Mesh shell_of(const geometry::Complex& complex) {
  const TriangleTable table(complex);
  geometry::Mesh mesh = surface_of(complex);
  if (complex.edges.cols() == 0) return mesh;
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    const Eigen::Vector3i corners = mesh.triangles.col(i);
    const bool is_of_complex = i < complex.triangles.cols();
    if (is_of_complex && table.is_walled_in(corners[0], corners[1], corners[2])) continue;
    mesh.triangles.col(kept++) = corners;
  }
  mesh.triangles.conservativeResize(3, kept);
  return mesh;
}

geometry::Mesh surface_of(const geometry::Complex& complex) {
  if (complex.edges.cols() == 0) return specks(complex.points);
  const std::vector<int> bare = bare_edges(complex);
  const auto extra = static_cast<Eigen::Index>(bare.size());
  geometry::Mesh mesh;
  mesh.vertices.resize(3, complex.points.cols() + extra);
  mesh.vertices.leftCols(complex.points.cols()) = complex.points;
  mesh.triangles.resize(3, complex.triangles.cols() + extra);
  mesh.triangles.leftCols(complex.triangles.cols()) = complex.triangles;
  for (Eigen::Index i = 0; i < extra; ++i) {
    const auto edge = complex.edges.col(bare[static_cast<std::size_t>(i)]);
    const Eigen::Index corner = complex.points.cols() + i;
    mesh.vertices.col(corner) = beside(complex.points.col(edge[0]), complex.points.col(edge[1]));
    mesh.triangles.col(complex.triangles.cols() + i) << edge[0], edge[1], static_cast<int>(corner);
  }
  return mesh;
}

}  // namespace graspless::clasp
