// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/ordered_hull.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace graspless::geometry {
namespace {

constexpr double kFlat = 1e-9;  // of the hull's size

using Triangle = std::array<int, 3>;
using Edge = std::pair<int, int>;

/// Corners in order of x, y, z.
Mesh with_sorted_corners(const Mesh& hull) {
  const Eigen::Index n = hull.vertices.cols();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
    const auto p = hull.vertices.col(a), q = hull.vertices.col(b);
    return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
  });
  Eigen::VectorXi place(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    place[order[static_cast<std::size_t>(i)]] = static_cast<int>(i);
  }
  return {hull.vertices(Eigen::all, order),
          hull.triangles.unaryExpr([&](int vertex) { return place[vertex]; })};
}

/// How far a point lies from the plane of a triangle.
double height(const Mesh& mesh, Eigen::Index triangle, int vertex) {
  const auto corner = [&](int k) -> Eigen::Vector3d {
    return mesh.vertices.col(mesh.triangles(k, triangle));
  };
  const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
  return std::abs(normal.dot(mesh.vertices.col(vertex) - corner(0)));
}

/// Facets of triangles that lie in one plane, each by the number of one of its triangles.
std::vector<int> facets(const Mesh& mesh) {
  const Eigen::Vector3d extent =
      mesh.vertices.rowwise().maxCoeff() - mesh.vertices.rowwise().minCoeff();
  std::map<Edge, std::pair<int, int>> opposite;  // of a directed edge: triangle and third corner
  for (int i = 0; i < mesh.triangles.cols(); ++i) {
    for (int k = 0; k < 3; ++k) {
      opposite[{mesh.triangles(k, i), mesh.triangles((k + 1) % 3, i)}] = {
          i, mesh.triangles((k + 2) % 3, i)};
    }
  }
  std::vector<int> facet(static_cast<std::size_t>(mesh.triangles.cols()));
  std::iota(facet.begin(), facet.end(), 0);
  const auto root = [&](int i) {
    while (facet[static_cast<std::size_t>(i)] != i) i = facet[static_cast<std::size_t>(i)];
    return i;
  };
  for (const auto& [edge, beside] : opposite) {
    const auto other = opposite.find({edge.second, edge.first});
    if (other == opposite.end()) continue;
    const bool is_flat = height(mesh, beside.first, other->second.second) < kFlat * extent.norm();
    if (is_flat) facet[static_cast<std::size_t>(root(beside.first))] = root(other->second.first);
  }
  for (std::size_t i = 0; i < facet.size(); ++i) facet[i] = root(static_cast<int>(i));
  return facet;
}

/// Of every facet, the corner that follows each along its boundary.
std::map<int, std::map<int, int>> boundaries(const Mesh& mesh, const std::vector<int>& facet) {
  std::map<Edge, int> owner;
  for (int i = 0; i < mesh.triangles.cols(); ++i) {
    for (int k = 0; k < 3; ++k) {
      owner[{mesh.triangles(k, i), mesh.triangles((k + 1) % 3, i)}] =
          facet[static_cast<std::size_t>(i)];
    }
  }
  std::map<int, std::map<int, int>> next;
  for (const auto& [edge, of] : owner) {
    const auto twin = owner.find({edge.second, edge.first});
    if (twin == owner.end() || twin->second != of) next[of][edge.first] = edge.second;
  }
  return next;
}

}  // namespace

Mesh ordered(const Mesh& hull) {
  Mesh mesh = with_sorted_corners(hull);
  std::vector<Triangle> triangles;
  for (const auto& [facet, next] : boundaries(mesh, facets(mesh))) {
    const int first = next.begin()->first;
    int a = next.begin()->second;
    for (std::size_t i = 2; i < next.size(); ++i) {
      const int b = next.at(a);
      triangles.push_back({first, a, b});
      a = b;
    }
  }
  std::sort(triangles.begin(), triangles.end());
  mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    mesh.triangles.col(static_cast<Eigen::Index>(i)) =
        Eigen::Map<Eigen::Vector3i>(triangles[i].data());
  }
  return mesh;
}

}  // namespace graspless::geometry
