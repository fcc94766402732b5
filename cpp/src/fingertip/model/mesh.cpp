// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From the triangles of a file to a solid: vertices merged, every edge shared by two triangles that
// run along it in opposite directions, outward; its volume, centre and inertia, and its flat faces.
#include "fingertip/model/mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "graspless/fingertip/object.hpp"
#include "graspless/mechanics/contact.hpp"
#include "graspless/watch.hpp"

#include "text.hpp"

namespace graspless::fingertip {
namespace {

// Vertices nearer than this part of the mesh's size are one: more than STL's single precision.
constexpr double kMergeTolerance = 1e-7;
// A solid of less volume than this part of its size's cube is none.
constexpr double kMinVolume = 1e-9;

[[noreturn]] void refuse(const std::string& what, const std::string& fault) {
  throw std::invalid_argument(what + " " + fault);
}

double diagonal(const Eigen::Matrix3Xd& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

/// Without vertices that no triangle uses. They are no part of the object.
geometry::Mesh used(const geometry::Mesh& mesh) {
  std::vector<int> index(mesh.vertices.cols(), -1);
  for (const int vertex : mesh.triangles.reshaped()) index[vertex] = 0;
  geometry::Mesh out{Eigen::Matrix3Xd(3, mesh.vertices.cols()), mesh.triangles};
  int count = 0;
  for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i) {
    if (index[i] < 0) continue;
    index[i] = count;
    out.vertices.col(count++) = mesh.vertices.col(i);
  }
  out.vertices.conservativeResize(3, count);
  for (int& vertex : out.triangles.reshaped()) vertex = index[vertex];
  return out;
}

/// Formats such as STL write a vertex once for each of its triangles.
geometry::Mesh merged(const geometry::Mesh& mesh) {
  const double cell = std::max(kMergeTolerance * diagonal(mesh.vertices), 1e-300);
  const Eigen::Vector3d corner = mesh.vertices.rowwise().minCoeff();
  std::map<std::array<std::int64_t, 3>, int> known;
  std::vector<int> index(mesh.vertices.cols());
  geometry::Mesh out{Eigen::Matrix3Xd(3, mesh.vertices.cols()),
                     Eigen::Matrix3Xi(3, mesh.triangles.cols())};
  for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i) {
    poll();
    const Eigen::Vector3d at = (mesh.vertices.col(i) - corner) / cell;
    const auto [entry, is_new] =
        known.try_emplace({std::llround(at.x()), std::llround(at.y()), std::llround(at.z())},
                          static_cast<int>(known.size()));
    if (is_new) out.vertices.col(entry->second) = mesh.vertices.col(i);
    index[i] = entry->second;
  }
  out.vertices.conservativeResize(3, static_cast<Eigen::Index>(known.size()));
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    poll();
    Eigen::Vector3i t;
    for (int k = 0; k < 3; ++k) t[k] = index[mesh.triangles(k, i)];
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) out.triangles.col(count++) = t;
  }
  out.triangles.conservativeResize(3, count);
  return out;
}

void require_closed(const geometry::Mesh& mesh, const std::string& what) {
  const auto edge = [](int from, int to) {
    return static_cast<std::uint64_t>(from) << 32U | static_cast<std::uint64_t>(to);
  };
  const auto between = [&](int from, int to) {
    std::string text = "the edge between (";
    for (const int v : {from, to}) {
      for (int k = 0; k < 3; ++k) {
        text += figure(mesh.vertices(k, v)) + (k < 2 ? ", " : ")");
      }
      if (v == from) text += " and (";
    }
    return text;
  };
  std::unordered_map<std::uint64_t, int> edges;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    poll();
    for (int k = 0; k < 3; ++k) {
      const int from = mesh.triangles(k, i), to = mesh.triangles((k + 1) % 3, i);
      if (++edges[edge(from, to)] == 1) continue;
      refuse(what, "must be oriented throughout, with two triangles at each edge, but " +
                       between(from, to) + " is passed twice in one direction");
    }
  }
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    poll();
    for (int k = 0; k < 3; ++k) {
      const int from = mesh.triangles(k, i), to = mesh.triangles((k + 1) % 3, i);
      if (edges.count(edge(to, from)) > 0) continue;
      refuse(what, "must be watertight, but " + between(from, to) + " borders a hole");
    }
  }
}

constexpr double kFlatness = 1e-6;    // how far corners may lie off a face's plane, by its size
constexpr double kCosine = 1 - 5e-5;  // of the angle between normals in a face: 0.01 rad

/// Twice the area along the outward normal.
Eigen::Vector3d area_vector(const geometry::Mesh& mesh, int triangle) {
  const auto t = mesh.triangles.col(triangle);
  const Eigen::Vector3d a = mesh.vertices.col(t[0]);
  return (mesh.vertices.col(t[1]) - a).cross(mesh.vertices.col(t[2]) - a);
}

/// Returns true if a triangle lies in the plane through `p` with outward normal n.
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

geometry::Mesh closed_mesh(const geometry::Mesh& mesh, const std::string& what) {
  if (mesh.triangles.cols() > Object::kMaxTriangles) {
    refuse(what, "must have at most " + std::to_string(Object::kMaxTriangles) + " triangles, not " +
                     std::to_string(mesh.triangles.cols()));
  }
  geometry::validate(mesh, what);
  geometry::Mesh out = merged(used(mesh));
  if (out.triangles.cols() == 0) refuse(what, "must have a volume, but is a point or a line");
  require_closed(out, what);
  const double size = diagonal(out.vertices);
  const double volume = mass_properties(out).volume;
  const double least = kMinVolume * size * size * size;
  if (volume < 0) out.triangles.row(1).swap(out.triangles.row(2));
  require_outward(out, least, what);
  if (!(std::abs(volume) > least)) {
    refuse(what, "must have a volume, but has " + figure(volume) + " m^3 at a size of " +
                     figure(size) + " m");
  }
  return out;
}

MassProperties mass_properties(const geometry::Mesh& mesh) {
  // Tetrahedra from one point to every triangle; a point amid the mesh keeps the terms small.
  const Eigen::Vector3d origin =
      (mesh.vertices.rowwise().maxCoeff() + mesh.vertices.rowwise().minCoeff()) / 2;
  const Eigen::Matrix3d canonical = (Eigen::Matrix3d::Ones() + Eigen::Matrix3d::Identity()) / 120;
  MassProperties all;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  Eigen::Vector3d first = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    poll();
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = mesh.vertices.col(mesh.triangles(k, i)) - origin;
    const double det = corners.determinant();
    all.volume += det / 6;
    first += det / 24 * corners.rowwise().sum();
    second += det * corners * canonical * corners.transpose();
  }
  const Eigen::Vector3d center = first / all.volume;
  second -= all.volume * center * center.transpose();
  all.center = origin + center;
  all.inertia = second.trace() * Eigen::Matrix3d::Identity() - second;
  return all;
}

std::vector<Face> find_faces(const geometry::Mesh& mesh, double size) {
  const int count = static_cast<int>(mesh.triangles.cols());
  const Eigen::Matrix3Xi across = neighbours(mesh);
  std::vector<Eigen::Vector3d> areas;
  for (int i = 0; i < count; ++i) areas.push_back(area_vector(mesh, i));
  std::vector<int> seeds(count);
  std::iota(seeds.begin(), seeds.end(), 0);
  const auto area = [&](int i) -> const Eigen::Vector3d& { return areas[i]; };
  // The largest triangle of a face knows its plane best.
  std::stable_sort(seeds.begin(), seeds.end(),
                   [&](int a, int b) { return area(a).norm() > area(b).norm(); });
  std::vector<bool> taken(count, false);
  std::vector<Face> faces;
  for (const int seed : seeds) {
    poll();
    if (taken[seed] || area(seed).isZero(0)) continue;
    const Eigen::Vector3d n = area(seed).normalized();
    const Eigen::Vector3d p = mesh.vertices.col(mesh.triangles(0, seed));
    std::vector<int> group{seed};
    taken[seed] = true;
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (int k = 0; k < 3; ++k) {
        const int other = across(k, group[next]);
        if (taken[other]) continue;
        if (!lies_in(mesh, other, area(other), p, n, kFlatness * size)) continue;
        taken[other] = true;
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
