// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/shape.hpp"

#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "geometry/convex_hull.hpp"
#include "geometry/require_points.hpp"
#include "text.hpp"

namespace graspless::geometry {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& fault) {
  throw std::invalid_argument(what + " " + fault);
}

void require_length(double value, const std::string& what) {
  if (value >= kMinLength && value <= kMaxLength) return;
  std::ostringstream fault;
  fault << "must be in [" << kMinLength << ", " << kMaxLength << "] m, not " << value;
  refuse(what, fault.str());
}

void check(const Box& box, const std::string& what) {
  for (int axis = 0; axis < 3; ++axis) {
    require_length(box.size[axis], what + ".size[" + std::to_string(axis) + "]");
  }
}

void check(const Sphere& sphere, const std::string& what) {
  require_length(sphere.radius, what + ".radius");
}

void check(const Capsule& capsule, const std::string& what) {
  require_length(capsule.radius, what + ".radius");
  require_length(capsule.length, what + ".length");
}

void check(const Convex& convex, const std::string& what) {
  if (convex.vertices.cols() < 4) {
    refuse(what + ".vertices",
           "must be four points or more, not " + std::to_string(convex.vertices.cols()));
  }
  require_points(convex.vertices, what + ".vertices");
  if (!spans_volume(convex.vertices)) {
    refuse(what + ".vertices", "must span a volume, but lie in a plane");
  }
}

void check(const Mesh& mesh, const std::string& what) {
  const Eigen::Index count = mesh.vertices.cols();
  if (mesh.triangles.cols() == 0) refuse(what + ".triangles", "must not be empty");
  require_points(mesh.vertices, what + ".vertices");
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    const auto triangle = mesh.triangles.col(i);
    if (triangle.minCoeff() >= 0 && triangle.maxCoeff() < count) continue;
    std::ostringstream fault;
    fault << "must be indices of the " << count << " vertices, but column " << i << " is ("
          << triangle.transpose() << ")";
    refuse(what + ".triangles", fault.str());
  }
}

/// Extent of a shape centred at its frame along d, a unit vector of that frame [m].
struct Extent {
  Eigen::Vector3d d;
  double operator()(const Box& box) const { return d.cwiseAbs().dot(box.size) / 2; }
  double operator()(const Sphere& sphere) const { return sphere.radius; }
  double operator()(const Capsule& c) const { return c.radius + std::abs(d.z()) * c.length / 2; }
  double operator()(const Convex& hull) const { return of(hull.vertices); }
  double operator()(const Mesh& mesh) const { return of(mesh.vertices); }
  double of(const Eigen::Matrix3Xd& points) const {
    if (points.cols() == 0) return -std::numeric_limits<double>::infinity();
    return (d.transpose() * points).maxCoeff();
  }
};

/// Vertices of an icosahedron that contains the ball of a radius about the origin.
Eigen::Matrix3Xd around_ball(double radius) {
  const double golden = (1 + std::sqrt(5)) / 2;
  const double inscribed = golden * golden / std::sqrt(3);  // ball of the one with edges of 2
  Eigen::Matrix3Xd vertices(3, 12);
  int i = 0;
  for (const double one : {-1.0, 1.0}) {
    for (const double far : {-golden, golden}) {
      vertices.col(i++) << 0, one, far;
      vertices.col(i++) << one, far, 0;
      vertices.col(i++) << far, 0, one;
    }
  }
  return radius / inscribed * vertices;
}

/// Appends to `out` what contains all points within `padding` of a shape at a pose.
struct Grow {
  double padding;
  const Eigen::Isometry3d& X_BG;
  std::vector<PlacedShape>& out;

  void operator()(const Box& box) const {
    out.push_back({Box{box.size.array() + 2 * padding}, X_BG});
  }
  void operator()(const Sphere& sphere) const {
    out.push_back({Sphere{sphere.radius + padding}, X_BG});
  }
  void operator()(const Capsule& c) const {
    out.push_back({Capsule{c.radius + padding, c.length}, X_BG});
  }
  void operator()(const Convex& hull) const { out.push_back({around(hull.vertices), X_BG}); }
  void operator()(const Mesh& mesh) const {
    out.push_back({mesh, X_BG});  // whose inside counts
    for (const auto& triangle : mesh.triangles.colwise()) {
      Eigen::Matrix3d corners;
      for (int i = 0; i < 3; ++i) corners.col(i) = mesh.vertices.col(triangle[i]);
      out.push_back({around(corners), X_BG});
    }
  }
  Convex around(const Eigen::Matrix3Xd& points) const {
    const Eigen::Matrix3Xd ball = around_ball(padding);
    Eigen::Matrix3Xd sums(3, points.cols() * ball.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      sums.middleCols(i * ball.cols(), ball.cols()) = ball.colwise() + points.col(i);
    }
    return {sums};
  }
};

}  // namespace

std::vector<PlacedShape> grown(const std::vector<PlacedShape>& shapes, double padding) {
  require(padding >= 0 && padding <= kMaxLength, "padding", padding, "must lie in [0, 1e4] m");
  std::vector<PlacedShape> out;
  for (const PlacedShape& placed : shapes) {
    validate(placed.shape, "shapes");
    std::visit(Grow{padding, placed.X_BG, out}, placed.shape);
  }
  return out;
}

void validate(const Shape& shape, const std::string& what) {
  std::visit([&](const auto& kind) { check(kind, what); }, shape);
}

double extent(const PlacedShape& placed, const Eigen::Vector3d& direction_B) {
  const Eigen::Vector3d direction_G = placed.X_BG.linear().transpose() * direction_B;
  return direction_B.dot(placed.X_BG.translation()) + std::visit(Extent{direction_G}, placed.shape);
}

}  // namespace graspless::geometry
