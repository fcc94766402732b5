// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/object/surface.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "graspless/watch.hpp"

namespace graspless::clasp {
namespace {

constexpr double kWidth = 0.001;  // of the triangle that represents an edge or a point [m]
constexpr double kFlat = 1e-6;    // sine of the angle below which a tetrahedron is degenerate

std::uint64_t edge_key(int low, int high) {
  return (static_cast<std::uint64_t>(low) << 32) | static_cast<std::uint32_t>(high);
}

/// Indices of the edges that bound no triangle.
std::vector<int> bare_edges(const geometry::Complex& complex) {
  std::unordered_set<std::uint64_t> bounding;
  bounding.reserve(3 * complex.triangles.cols());
  for (Eigen::Index i = 0; i < complex.triangles.cols(); ++i) {
    poll();
    const auto corners = complex.triangles.col(i);  // ascending
    bounding.insert(edge_key(corners[0], corners[1]));
    bounding.insert(edge_key(corners[0], corners[2]));
    bounding.insert(edge_key(corners[1], corners[2]));
  }
  std::vector<int> bare;
  for (Eigen::Index i = 0; i < complex.edges.cols(); ++i) {
    poll();
    if (bounding.count(edge_key(complex.edges(0, i), complex.edges(1, i))) == 0) {
      bare.push_back(static_cast<int>(i));
    }
  }
  return bare;
}

/// Third corner of the triangle that represents the edge from a to b.
Eigen::Vector3d beside(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d along = b - a;
  return (a + b) / 2 + std::min(kWidth, along.norm() / 10) * along.unitOrthogonal();
}

/// Indices of the points without an edge.
std::vector<int> lone_points(const geometry::Complex& complex) {
  std::vector<bool> ends(complex.points.cols(), false);
  for (const int point : complex.edges.reshaped()) ends[point] = true;
  std::vector<int> lone;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (!ends[i]) lone.push_back(static_cast<int>(i));
  }
  return lone;
}

/// Lookup table of triangles: for each edge, the points that form a triangle with it.
class TriangleTable {
 public:
  explicit TriangleTable(const geometry::Complex& complex) : points_(complex.points) {
    const auto& triangles = complex.triangles;
    apexes_.reserve(2 * triangles.cols());
    for (Eigen::Index i = 0; i < triangles.cols(); ++i) {
      poll();
      const auto corners = triangles.col(i);  // ascending
      apexes_[edge_key(corners[0], corners[1])].push_back(corners[2]);
      apexes_[edge_key(corners[0], corners[2])].push_back(corners[1]);
      apexes_[edge_key(corners[1], corners[2])].push_back(corners[0]);
    }
  }

  /// True if there is a tetrahedron of triangles on both sides of this triangle.
  bool is_enclosed(int a, int b, int c) const {
    const Eigen::Vector3d p = points_.col(a);
    const Eigen::Vector3d normal = (points_.col(b) - p).cross(Eigen::Vector3d(points_.col(c) - p));
    bool above = false, below = false;
    for (const int d : apexes_.at(edge_key(a, b))) {
      if (d == c || !has(a, c, d) || !has(b, c, d)) continue;
      const Eigen::Vector3d to_apex = points_.col(d) - p;
      const double side = normal.dot(to_apex), flat = kFlat * normal.norm() * to_apex.norm();
      above = above || side > flat;
      below = below || side < -flat;
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

geometry::Mesh surface_of(const geometry::Complex& complex) {
  const std::vector<int> bare = bare_edges(complex), lone = lone_points(complex);
  const auto edges = static_cast<Eigen::Index>(bare.size());
  const auto points = static_cast<Eigen::Index>(lone.size());
  geometry::Mesh mesh;
  Eigen::Index corner = complex.points.cols(), triangle = complex.triangles.cols();
  mesh.vertices.resize(3, corner + edges + 2 * points);
  mesh.vertices.leftCols(corner) = complex.points;
  mesh.triangles.resize(3, triangle + edges + points);
  mesh.triangles.leftCols(triangle) = complex.triangles;
  const auto add_corner = [&](const Eigen::Vector3d& p) {
    mesh.vertices.col(corner) = p;
    return static_cast<int>(corner++);
  };
  for (const int i : bare) {
    const auto edge = complex.edges.col(i);
    mesh.triangles.col(triangle++) << edge[0], edge[1],
        add_corner(beside(complex.points.col(edge[0]), complex.points.col(edge[1])));
  }
  for (const int i : lone) {
    const Eigen::Vector3d p = complex.points.col(i);
    const int second = add_corner(p + kWidth * Eigen::Vector3d::UnitX());
    const int third = add_corner(p + kWidth * Eigen::Vector3d::UnitY());
    mesh.triangles.col(triangle++) << i, second, third;
  }
  return mesh;
}

geometry::Mesh shell_of(const geometry::Complex& complex) {
  const TriangleTable table(complex);
  geometry::Mesh mesh = surface_of(complex);
  Eigen::Index kept = 0;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    poll();
    const Eigen::Vector3i corners = mesh.triangles.col(i);
    const bool is_of_complex = i < complex.triangles.cols();
    if (is_of_complex && table.is_enclosed(corners[0], corners[1], corners[2])) continue;
    mesh.triangles.col(kept++) = corners;
  }
  mesh.triangles.conservativeResize(3, kept);
  return mesh;
}

}  // namespace graspless::clasp
