// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/perception/render.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include "graspless/geometry/pose.hpp"
#include "graspless/watch.hpp"

#include "geometry/box_mesh.hpp"
#include "geometry/convex_hull.hpp"

namespace graspless::perception {
namespace {

using RayKernel = CGAL::Simple_cartesian<double>;
using RayTriangles = std::vector<RayKernel::Triangle_3>;
using RayPrimitive = CGAL::AABB_triangle_primitive<RayKernel, RayTriangles::const_iterator>;
using RayTree = CGAL::AABB_tree<CGAL::AABB_traits<RayKernel, RayPrimitive>>;

constexpr double kLeastDepth = 1e-3;  // of a depth [m]: the image of what is nearer has no bounds

RayKernel::Point_3 to_point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }
Eigen::Vector3d from_point(const RayKernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

geometry::Mesh triangulated(const geometry::Shape& shape, const std::string& what) {
  geometry::validate(shape, what);
  if (const auto* mesh = std::get_if<geometry::Mesh>(&shape)) return *mesh;
  if (const auto* convex = std::get_if<geometry::Convex>(&shape)) {
    return geometry::convex_hull(convex->vertices);
  }
  if (const auto* box = std::get_if<geometry::Box>(&shape)) return geometry::box_mesh(box->size);
  throw std::invalid_argument(what +
                              " has no triangles; it must be a Box, Convex or Mesh to be rendered");
}

/// Rectangle of pixels: columns [left, right), rows [top, bottom).
struct Window {
  int left, right, top, bottom;
};

/// Pixels in which points (in C) can be seen.
Window window_of(const Eigen::Matrix3Xd& p_CP, const Camera& camera) {
  if (p_CP.row(2).minCoeff() < kLeastDepth) {
    if (p_CP.row(2).maxCoeff() < kLeastDepth) return {0, 0, 0, 0};
    return {0, camera.width, 0, camera.height};
  }
  const Eigen::Matrix3Xd uv = camera.K * p_CP;
  const Eigen::ArrayXd u = uv.row(0).array() / uv.row(2).array();
  const Eigen::ArrayXd v = uv.row(1).array() / uv.row(2).array();
  const auto pixel = [](double at, int size) {
    return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(size)));
  };
  return {pixel(std::floor(u.minCoeff()), camera.width),
          pixel(std::ceil(u.maxCoeff()) + 1, camera.width),
          pixel(std::floor(v.minCoeff()), camera.height),
          pixel(std::ceil(v.maxCoeff()) + 1, camera.height)};
}

/// Draws one shape, in front of what was drawn so far.
class Painter {
 public:
  Painter(const Camera& camera, Rendering& result)
      : camera_(camera), K_inverse_(camera.K.inverse()), result_(result) {}

  void draw(const geometry::Mesh& mesh, const Eigen::Isometry3d& X_CG, int label) {
    const Eigen::Matrix3Xd p_CP = X_CG * mesh.vertices;
    RayTriangles triangles;
    for (const auto& corners : mesh.triangles.colwise()) {
      const auto at = [&](int i) { return to_point(p_CP.col(corners[i])); };
      const RayKernel::Triangle_3 triangle(at(0), at(1), at(2));
      if (!triangle.is_degenerate()) triangles.push_back(triangle);
    }
    if (triangles.empty()) return;
    const RayTree tree(triangles.cbegin(), triangles.cend());
    const Window window = window_of(p_CP, camera_);
    for (int v = window.top; v < window.bottom; ++v) {
      for (int u = window.left; u < window.right; ++u) {
        poll();
        draw_pixel(tree, u, v, label);
      }
    }
  }

 private:
  void draw_pixel(const RayTree& tree, int u, int v, int label) {
    const Eigen::Vector3d ray_C = K_inverse_ * Eigen::Vector3d(u, v, 1);  // z is 1
    const RayKernel::Ray_3 ray(RayKernel::Point_3(0, 0, 0),
                               RayKernel::Vector_3(ray_C.x(), ray_C.y(), ray_C.z()));
    const auto found = tree.first_intersected_primitive(ray);
    if (!found) return;
    const RayKernel::Triangle_3& triangle = **found;
    const Eigen::Vector3d a = from_point(triangle[0]);
    const Eigen::Vector3d normal =
        (from_point(triangle[1]) - a).cross(from_point(triangle[2]) - a).normalized();
    const double along = normal.dot(ray_C);
    if (along == 0) return;  // the ray lies in the triangle's plane
    const auto z = static_cast<float>(normal.dot(a) / along);
    float& depth = result_.depth(v, u);
    if (!(z > 0) || (depth > 0 && z >= depth)) return;
    depth = z;
    result_.label(v, u) = label;
    result_.cosine(v, u) = static_cast<float>(std::min(1.0, std::abs(along) / ray_C.norm()));
  }

  const Camera& camera_;
  Eigen::Matrix3d K_inverse_;
  Rendering& result_;
};

}  // namespace

Rendering render(const std::vector<Body>& bodies, const Eigen::Isometry3d& X_WC,
                 const Camera& camera) {
  validate(camera);
  geometry::require_pose(X_WC, "X_WC");
  Rendering result{DepthImage::Zero(camera.height, camera.width),
                   LabelImage::Constant(camera.height, camera.width, -1),
                   DepthImage::Zero(camera.height, camera.width)};
  Painter painter(camera, result);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::string what = "bodies[" + std::to_string(i) + "]";
    geometry::require_pose(bodies[i].X_WB, what + ".X_WB");
    for (std::size_t j = 0; j < bodies[i].shapes.size(); ++j) {
      const geometry::PlacedShape& placed = bodies[i].shapes[j];
      const std::string name = what + ".shapes[" + std::to_string(j) + "]";
      geometry::require_pose(placed.X_BG, name + ".X_BG");
      painter.draw(triangulated(placed.shape, name), X_WC.inverse() * bodies[i].X_WB * placed.X_BG,
                   static_cast<int>(i));
    }
  }
  return result;
}

}  // namespace graspless::perception
