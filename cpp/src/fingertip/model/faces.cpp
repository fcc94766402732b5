// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Joins the triangles of a mesh to flat faces.
#include "fingertip/model/faces.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "graspless/mechanics/contact.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kFlatness = 1e-6;    // how far corners may lie off a face's plane, by its size
constexpr double kCosine = 1 - 5e-5;  // of the angle between normals in a face: 0.01 rad

/// Twice the area along the outward normal.
Eigen::Vector3d area_vector(const geometry::Mesh& mesh, int triangle) {
  const auto t = mesh.triangles.col(triangle);
  const Eigen::Vector3d a = mesh.vertices.col(t[0]);
  return (mesh.vertices.col(t[1]) - a).cross(mesh.vertices.col(t[2]) - a);
}

/// The triangle across each edge (3 x triangles).
Eigen::Matrix3Xi neighbours(const geometry::Mesh& mesh) {
  const auto edge = [](int from, int to) {
    return static_cast<std::uint64_t>(from) << 32U | static_cast<std::uint64_t>(to);
  };
  std::unordered_map<std::uint64_t, int> owner;
  const int count = static_cast<int>(mesh.triangles.cols());
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) {
      owner[edge(mesh.triangles(k, i), mesh.triangles((k + 1) % 3, i))] = i;
    }
  }
  Eigen::Matrix3Xi across(3, count);
  for (int i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) {
      across(k, i) = owner.at(edge(mesh.triangles((k + 1) % 3, i), mesh.triangles(k, i)));
    }
  }
  return across;
}

/// Whether a triangle lies in the plane through `p` with outward normal n.
bool lies_in(const geometry::Mesh& mesh, int triangle, const Eigen::Vector3d& area,
             const Eigen::Vector3d& p, const Eigen::Vector3d& n, double tolerance) {
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d corner = mesh.vertices.col(mesh.triangles(k, triangle));
    if (std::abs(n.dot(corner - p)) > tolerance) return false;
  }
  // The normal of a sliver says nothing.
  return area.norm() < tolerance * tolerance || area.dot(n) >= kCosine * area.norm();
}

Face make_face(const geometry::Mesh& mesh, std::vector<int> triangles) {
  std::sort(triangles.begin(), triangles.end());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int t : triangles) sum += area_vector(mesh, t);
  Face face;
  face.area = sum.norm() / 2;
  face.n_O = -sum.normalized();
  face.first_O = mechanics::tangent(face.n_O, Eigen::Vector3d::Zero());
  face.second_O = face.n_O.cross(face.first_O);
  for (const int t : triangles) {
    for (int k = 0; k < 3; ++k)
      face.offset += face.n_O.dot(mesh.vertices.col(mesh.triangles(k, t)));
  }
  face.offset /= 3 * static_cast<double>(triangles.size());
  face.triangles = std::move(triangles);
  return face;
}

}  // namespace

std::vector<Face> find_faces(const geometry::Mesh& mesh, double size) {
  const int count = static_cast<int>(mesh.triangles.cols());
  const Eigen::Matrix3Xi across = neighbours(mesh);
  std::vector<Eigen::Vector3d> areas;
  for (int i = 0; i < count; ++i) areas.push_back(area_vector(mesh, i));
  std::vector<int> seeds(static_cast<std::size_t>(count));
  std::iota(seeds.begin(), seeds.end(), 0);
  const auto area = [&](int i) -> const Eigen::Vector3d& {
    return areas[static_cast<std::size_t>(i)];
  };
  // The largest triangle of a face knows its plane best.
  std::stable_sort(seeds.begin(), seeds.end(),
                   [&](int a, int b) { return area(a).norm() > area(b).norm(); });
  std::vector<bool> taken(static_cast<std::size_t>(count), false);
  std::vector<Face> faces;
  for (const int seed : seeds) {
    if (taken[static_cast<std::size_t>(seed)] || area(seed).isZero(0)) continue;
    const Eigen::Vector3d n = area(seed).normalized();
    const Eigen::Vector3d p = mesh.vertices.col(mesh.triangles(0, seed));
    std::vector<int> group{seed};
    taken[static_cast<std::size_t>(seed)] = true;
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (int k = 0; k < 3; ++k) {
        const int other = across(k, group[next]);
        if (taken[static_cast<std::size_t>(other)]) continue;
        if (!lies_in(mesh, other, area(other), p, n, kFlatness * size)) continue;
        taken[static_cast<std::size_t>(other)] = true;
        group.push_back(other);
      }
    }
    faces.push_back(make_face(mesh, std::move(group)));
  }
  std::sort(faces.begin(), faces.end(),
            [](const Face& a, const Face& b) { return a.triangles.front() < b.triangles.front(); });
  return faces;
}

}  // namespace graspless::fingertip
