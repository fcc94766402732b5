// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <random>
#include <stdexcept>

#include "graspless/geometry/band.hpp"
#include "graspless/geometry/point_cloud.hpp"
#include "graspless/geometry/polygon.hpp"
#include "graspless/geometry/shape.hpp"

#include "conversions.hpp"

namespace graspless::bindings {
namespace {

using namespace geometry;

template <class T>
T validated(T shape, const char* what) {
  validate(shape, what);
  return shape;
}

std::string text(double value) { return py::repr(py::float_(value)); }

std::string count(const char* name, Eigen::Index n, const char* what) {
  return std::string("<") + name + " of " + std::to_string(n) + " " + what + ">";
}

Eigen::Vector3d to_scale(const std::variant<double, Array>& scale) {
  if (const auto* factor = std::get_if<double>(&scale)) {
    return Eigen::Vector3d::Constant(*factor);
  }
  return to_vector3(std::get<Array>(scale), "scale");
}

void bind_shapes(py::module_& m) {
  py::class_<Box>(m, "Box", "A box centred at its frame's origin, sides along the axes.")
      .def(py::init([](const Array& size) {
             return validated(Box{to_vector3(size, "box size")}, "box");
           }),
           py::arg("size"), "size: (3,) side lengths [m], positive.")
      .def_property_readonly(
          "size", [](const Box& box) { return box.size; }, "(3,) side lengths [m].")
      .def("__repr__", [](const py::object& self) { return represent(self, {"size"}); });

  py::class_<Sphere>(m, "Sphere", "A sphere centred at its frame's origin.")
      .def(py::init([](double radius) { return validated(Sphere{radius}, "sphere"); }),
           py::arg("radius"), "radius: [m], positive.")
      .def_readonly("radius", &Sphere::radius, "[m].")
      .def("__repr__", [](const py::object& self) { return represent(self, {"radius"}); });

  py::class_<Capsule>(
      m, "Capsule",
      "All points within radius of the segment from (0, 0, -length/2) to (0, 0, length/2).")
      .def(py::init([](double radius, double length) {
             return validated(Capsule{radius, length}, "capsule");
           }),
           py::arg("radius"), py::arg("length"), "radius, length: [m], positive.")
      .def_readonly("radius", &Capsule::radius, "[m].")
      .def_readonly("length", &Capsule::length, "Of the segment, without the two half spheres [m].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"radius", "length"});
      });

  py::class_<Convex>(m, "Convex", "The convex hull of a set of points.")
      .def(py::init([](const Array& vertices) {
             return validated(Convex{to_points3(vertices, "convex vertices")}, "convex");
           }),
           py::arg("vertices"), "vertices: (N, 3) points [m] that span a volume.")
      .def_property_readonly(
          "vertices", [](const Convex& shape) -> Rows3 { return shape.vertices.transpose(); },
          "(N, 3) [m].")
      .def("__repr__",
           [](const Convex& shape) { return count("Convex", shape.vertices.cols(), "points"); });

  py::class_<Mesh>(
      m, "Mesh",
      "A triangle surface. Only the surface collides: a body wholly inside does not touch it.")
      .def(py::init([](const Array& vertices, const Indices& triangles) {
             return validated(Mesh{to_points3(vertices, "mesh vertices"),
                                   to_triangles(triangles, "mesh triangles")},
                              "mesh");
           }),
           py::arg("vertices"), py::arg("triangles"),
           "vertices: (N, 3) [m]. triangles: (M, 3) indices of vertices.")
      .def_property_readonly(
          "vertices", [](const Mesh& mesh) -> Rows3 { return mesh.vertices.transpose(); },
          "(N, 3) [m].")
      .def_property_readonly(
          "triangles", [](const Mesh& mesh) -> Rows3i { return mesh.triangles.transpose(); },
          "(M, 3) indices of vertices.")
      .def("__repr__",
           [](const Mesh& mesh) { return count("Mesh", mesh.triangles.cols(), "triangles"); });

  py::class_<PlacedShape>(m, "PlacedShape", "A shape fixed in the frame of a body B.")
      .def(py::init([](const Shape& shape, const Array& X_BG) {
             return PlacedShape{shape, to_pose(X_BG, "X_BG")};
           }),
           py::arg("shape"), pose_arg("X_BG"),
           "X_BG: (4, 4) pose of the shape's own frame G in the body.")
      .def_readonly("shape", &PlacedShape::shape, "Box, Sphere, Capsule, Convex or Mesh.")
      .def_property_readonly(
          "X_BG", [](const PlacedShape& placed) { return from_pose(placed.X_BG); },
          "(4, 4) pose of the shape's own frame G in the body.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"shape", "X_BG"});
      });

  m.def(
      "read_mesh",
      [](const std::string& path, const std::variant<double, Array>& scale) {
        return read_mesh(path, to_scale(scale));
      },
      py::arg("path"), py::arg("scale") = 1.0,
      "Reads a triangle mesh (.stl, .obj, .off, .ply); scale is one factor or one per axis.\n\n"
      "Raises ValueError that names the path when it is missing, unreadable or empty.");
}

void bind_polygon(py::module_& m) {
  py::class_<Polygon> polygon(m, "Polygon",
                              "A simple polygon in the plane, counter-clockwise, convex or not.");
  py::class_<Polygon::Edge>(m, "Edge", "An edge of a polygon.")
      .def_readonly("index", &Polygon::Edge::index, "It leads from vertex `index` to the next.")
      .def_property_readonly(
          "a", [](const Polygon::Edge& edge) { return edge.a; }, "(2,) first end [m].")
      .def_property_readonly(
          "b", [](const Polygon::Edge& edge) { return edge.b; }, "(2,) second end [m].")
      .def_property_readonly(
          "inward", [](const Polygon::Edge& edge) { return edge.inward; },
          "(2,) unit normal that points inside.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"index", "a", "b", "inward"});
      });
  polygon
      .def(
          py::init([](const Array& vertices, const std::string& what) {
            return Polygon(to_points2(vertices, what), what);
          }),
          py::arg("vertices"), py::arg("what") = "polygon",
          "vertices: (N, 2) [m]; a clockwise list is reversed. what: its name in errors.\n\n"
          "Raises ValueError on fewer than three vertices, a value that is not finite, a repeated\n"
          "vertex, or a boundary that crosses or touches itself.")
      .def_property_readonly(
          "vertices", [](const Polygon& self) -> Rows2 { return self.vertices().transpose(); },
          "(N, 2) [m], counter-clockwise.")
      .def("__len__", &Polygon::size, "Number of vertices.")
      .def_property_readonly("area", &Polygon::area, "[m^2], positive.")
      .def_property_readonly("centroid", &Polygon::centroid, "(2,) centroid of the area [m].")
      .def_property_readonly("is_convex", &Polygon::is_convex, "Whether no corner is reflex.")
      .def(
          "contains",
          [](const Polygon& self, const Array& p) { return self.contains(to_vector2(p, "p")); },
          py::arg("p"), "Whether the point p, (2,) [m], lies inside.")
      .def(
          "depth",
          [](const Polygon& self, const Array& p) { return self.depth(to_vector2(p, "p")); },
          py::arg("p"),
          "Distance from p, (2,), to the boundary [m]; positive inside, negative outside.")
      .def(
          "edge",
          [](const Polygon& self, int index) {
            if (index < 0 || index >= self.size()) {
              throw std::invalid_argument("index is " + std::to_string(index) +
                                          "; the polygon has edges 0 to " +
                                          std::to_string(self.size() - 1));
            }
            return self.edge(index);
          },
          py::arg("index"), "The edge from vertex `index` to the next.")
      .def(
          "nearest_edge",
          [](const Polygon& self, const Array& p) { return self.nearest_edge(to_vector2(p, "p")); },
          py::arg("p"), "The edge nearest to p, (2,) [m].")
      .def("convex_parts", &Polygon::convex_parts, py::call_guard<py::gil_scoped_release>(),
           "Convex polygons that cover this one without overlap.")
      .def("__repr__",
           [](const Polygon& self) { return count("Polygon", self.size(), "vertices"); });
}

void bind_band(py::module_& m) {
  py::class_<Band>(m, "Band",
                   "The points of a polygon near its edges: what its contraction leaves out.")
      .def(py::init<const Polygon&, double>(), py::arg("polygon"), py::arg("width"),
           py::call_guard<py::gil_scoped_release>(),
           "width: how far the band reaches from the edges [m], positive.")
      .def_property_readonly("polygon", &Band::polygon, "The polygon it was made from.")
      .def_property_readonly("width", &Band::width, "[m].")
      .def_property_readonly("core", &Band::core,
                             "The contracted polygon, in pieces; empty where nothing is left.")
      .def_property_readonly("exact", &Band::exact,
                             "False where the contraction failed verification.")
      .def(
          "contains",
          [](const Band& self, const Array& p) { return self.contains(to_vector2(p, "p")); },
          py::arg("p"), "Whether the point p, (2,) [m], lies in the band.")
      .def(
          "sample",
          [](const Band& self, std::uint64_t seed, double margin) {
            std::mt19937_64 rng(seed);
            return self.sample(rng, margin);
          },
          py::arg("seed"), py::arg("margin") = 0.0,
          "A point of the band, (2,), at least margin [m] inside the boundary, or None when none "
          "was found.\n\n"
          "Uniform by area where exact; the same seed gives the same point.")
      .def("__repr__",
           [](const Band& self) { return "<Band of width " + text(self.width()) + " m>"; });
}

}  // namespace

void bind_geometry(py::module_ m) {
  bind_shapes(m);
  bind_polygon(m);
  bind_band(m);
  m.def(
      "sample_grid",
      [](const Polygon& polygon, double spacing) -> Rows2 {
        return sample_grid(polygon, spacing).transpose();
      },
      py::arg("polygon"), py::arg("spacing"),
      "Points (N, 2) on a square grid of `spacing` [m] inside a polygon; never empty.");
  m.def(
      "outline",
      [](const Array& points, const std::string& what) {
        const Eigen::Matrix2Xd columns = to_points2(points, what);
        const py::gil_scoped_release release;
        return outline(columns, what);
      },
      py::arg("points"), py::arg("what") = "points",
      "The outer boundary of planar points (N, 2) [m]: their tightest alpha shape in one simple "
      "piece.\n\n"
      "Holes are filled. Raises ValueError when the points are fewer than three, not finite or on "
      "a line.");
}

}  // namespace graspless::bindings
