// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Pieces of a closed mesh: solids, and cavities inside them.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/watch.hpp"

#include "fingertip/model/mesh.hpp"
#include "text.hpp"

namespace graspless::fingertip {
namespace {

/// Part of a mesh that no edge joins to the others.
struct Piece {
  std::vector<int> triangles;
  Eigen::AlignedBox3d box;
  double volume = 0;  // negative if its triangles face inwards [m^3]
};

std::vector<Piece> pieces_of(const geometry::Mesh& mesh) {
  const Eigen::Matrix3Xi across = neighbours(mesh);
  const Eigen::Vector3d origin = mesh.vertices.rowwise().mean();
  std::vector<bool> taken(across.cols(), false);
  std::vector<Piece> pieces;
  for (int seed = 0; seed < static_cast<int>(across.cols()); ++seed) {
    if (taken[seed]) continue;
    taken[seed] = true;
    Piece piece;
    piece.triangles = {seed};
    for (std::size_t next = 0; next < piece.triangles.size(); ++next) {
      poll();
      const int triangle = piece.triangles[next];
      Eigen::Matrix3d corners;
      for (int k = 0; k < 3; ++k) {
        corners.col(k) = mesh.vertices.col(mesh.triangles(k, triangle));
        piece.box.extend(Eigen::Vector3d(corners.col(k)));
        const int other = across(k, triangle);
        if (taken[other]) continue;
        taken[other] = true;
        piece.triangles.push_back(other);
      }
      piece.volume += (corners.colwise() - origin).determinant() / 6;
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// How often a piece winds around a point: 1 inside, or -1 if it is inside out; 0 outside; between
/// them on its surface.
double winding(const geometry::Mesh& mesh, const Piece& piece, const Eigen::Vector3d& p) {
  double angle = 0;  // solid, by van Oosterom and Strackee
  for (const int triangle : piece.triangles) {
    poll();
    Eigen::Matrix3d to;
    for (int k = 0; k < 3; ++k) to.col(k) = mesh.vertices.col(mesh.triangles(k, triangle)) - p;
    const Eigen::Vector3d a = to.col(0), b = to.col(1), c = to.col(2);
    const double la = a.norm(), lb = b.norm(), lc = c.norm(), det = to.determinant();
    if (std::abs(det) <= 1e-12 * la * lb * lc) continue;  // in the triangle's plane
    angle += 2 * std::atan2(det, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4 * M_PI);
}

/// True if `inner` lies inside `outer`; it may touch the surface from within.
bool is_inside(const geometry::Mesh& mesh, const Piece& inner, const Piece& outer) {
  constexpr std::size_t kSamples = 6;
  if (!outer.box.contains(inner.box)) return false;
  double least = 1, most = 0;
  const double sign = outer.volume > 0 ? 1 : -1;
  const std::size_t step = std::max<std::size_t>(1, inner.triangles.size() / kSamples);
  for (std::size_t i = 0; i < inner.triangles.size(); i += step) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      middle += mesh.vertices.col(mesh.triangles(k, inner.triangles[i])) / 3;
    }
    const double around = sign * winding(mesh, outer, middle);
    least = std::min(least, around);
    most = std::max(most, around);
  }
  return least > 0.25 && most > 0.75;
}

}  // namespace

Eigen::Matrix3Xi neighbours(const geometry::Mesh& mesh) {
  const auto edge = [](int from, int to) {
    return static_cast<std::uint64_t>(from) << 32U | static_cast<std::uint64_t>(to);
  };
  std::unordered_map<std::uint64_t, int> owner;
  const int count = static_cast<int>(mesh.triangles.cols());
  for (int i = 0; i < count; ++i) {
    poll();
    for (int k = 0; k < 3; ++k) {
      owner[edge(mesh.triangles(k, i), mesh.triangles((k + 1) % 3, i))] = i;
    }
  }
  Eigen::Matrix3Xi across(3, count);
  for (int i = 0; i < count; ++i) {
    poll();
    for (int k = 0; k < 3; ++k) {
      across(k, i) = owner.at(edge(mesh.triangles((k + 1) % 3, i), mesh.triangles(k, i)));
    }
  }
  return across;
}

void require_outward(const geometry::Mesh& mesh, double least_volume, const std::string& what) {
  const std::vector<Piece> pieces = pieces_of(mesh);
  for (const Piece& piece : pieces) {
    if (piece.volume >= -least_volume) continue;
    int around = 0;  // solids about it, less the cavities about it
    for (const Piece& other : pieces) {
      if (&other != &piece && is_inside(mesh, piece, other)) around += other.volume > 0 ? 1 : -1;
    }
    if (around > 0) continue;  // a cavity
    const Eigen::Vector3d at = piece.box.center();
    throw std::invalid_argument(
        what + " must be oriented throughout, but its piece of " +
        std::to_string(piece.triangles.size()) + " triangles about (" + figure(at.x()) + ", " +
        figure(at.y()) + ", " + figure(at.z()) +
        ") is inside out with respect to the rest, and is no cavity: reverse the "
        "order of the corners of its triangles");
  }
}

}  // namespace graspless::fingertip
