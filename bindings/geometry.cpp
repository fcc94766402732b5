// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <random>
#include <stdexcept>

#include <pybind11/native_enum.h>

#include "graspless/geometry/band.hpp"
#include "graspless/geometry/complex.hpp"
#include "graspless/geometry/linking.hpp"
#include "graspless/geometry/loops.hpp"
#include "graspless/geometry/point_cloud.hpp"
#include "graspless/geometry/polygon.hpp"
#include "graspless/geometry/sampling.hpp"
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

/// A closed curve: a Loop that was found, or its corners.
using LoopOrRows = std::variant<Loop, Array>;

Eigen::Matrix3Xd to_loop(const LoopOrRows& loop, const std::string& name) {
  if (const auto* found = std::get_if<Loop>(&loop)) return found->points;
  return to_points3(std::get<Array>(loop), name);
}

std::vector<Eigen::Matrix3Xd> to_curves(const std::vector<Array>& curves) {
  std::vector<Eigen::Matrix3Xd> columns;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    columns.push_back(to_points3(curves[i], "curves[" + std::to_string(i) + "]"));
  }
  return columns;
}

py::array_t<int> to_array(const std::vector<int>& values) {
  return py::array_t<int>(static_cast<py::ssize_t>(values.size()), values.data());
}

void bind_complex(py::module_& m) {
  py::class_<Complex>(m, "Complex",
                      "K_d of a cloud: the edges and triangles of its Delaunay triangulation whose "
                      "edges are all shorter than d.")
      .def_property_readonly(
          "points", [](const Complex& self) -> Rows3 { return self.points.transpose(); },
          "(N, 3) [m].")
      .def_property_readonly(
          "edges",
          [](const Complex& self) -> Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor> {
            return self.edges.transpose();
          },
          "(E, 2) indices of points, the smaller first; sorted.")
      .def_property_readonly(
          "triangles", [](const Complex& self) -> Rows3i { return self.triangles.transpose(); },
          "(T, 3) indices of points, ascending; sorted. Those inside the object too.")
      .def_readonly("max_edge_length", &Complex::max_edge_length, "d [m].")
      .def("__repr__", [](const Complex& self) {
        return "<Complex of " + std::to_string(self.edges.cols()) + " edges and " +
               std::to_string(self.triangles.cols()) + " triangles shorter than " +
               text(self.max_edge_length) + " m>";
      });

  py::class_<BettiCurve>(m, "BettiCurve",
                         "How many independent loops K_d has: a step function of d.\n\n"
                         "loops[i] for d above max_edge_length[i] up to the next, that included.")
      .def_property_readonly(
          "max_edge_length", [](const BettiCurve& self) { return self.max_edge_length; },
          "Where the number changes, ascending [m].")
      .def_property_readonly(
          "loops", [](const BettiCurve& self) { return self.loops; }, "How many there are.")
      .def("__repr__", [](const BettiCurve& self) {
        return "<BettiCurve of " + std::to_string(self.loops.size()) + " steps>";
      });

  py::class_<Plateau>(m, "Plateau", "A stretch of d over which the same loops live.")
      .def_readonly("lower", &Plateau::lower, "The least d [m].")
      .def_readonly("upper", &Plateau::upper, "The greatest d [m].")
      .def_readonly("loops", &Plateau::loops, "How many; 0 where no plateau was chosen.")
      .def_property_readonly("ratio", &Plateau::ratio, "upper / lower: how sure the loops are.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"lower", "upper", "loops"});
      });

  py::class_<Filtration>(m, "Filtration",
                         "The Delaunay triangulation of a cloud, its simplices in order of their "
                         "longest edge: every K_d at once.")
      .def(py::init([](const Array& points, const std::string& what) {
             const Eigen::Matrix3Xd columns = to_points3(points, what);
             const py::gil_scoped_release release;
             return Filtration(columns, what);
           }),
           py::arg("points"), py::arg("what") = "points",
           "points: (N, 3) [m]; equal points count once. what: their name in errors.\n\n"
           "Raises ValueError when there are fewer than 4 distinct points, one is not finite, or "
           "all lie in a plane.")
      .def_property_readonly(
          "points", [](const Filtration& self) -> Rows3 { return self.points().transpose(); },
          "(N, 3) as given [m].")
      .def_property_readonly("num_vertices", &Filtration::num_vertices, "Distinct points.")
      .def("complex", &Filtration::complex, py::arg("max_edge_length"), "K_d for d [m].")
      .def(
          "persistence",
          [](const Filtration& self) {
            const auto& pairs = self.persistence();
            Rows2 rows(static_cast<Eigen::Index>(pairs.size()), 2);
            for (std::size_t i = 0; i < pairs.size(); ++i) {
              rows.row(static_cast<Eigen::Index>(i)) << pairs[i].birth, pairs[i].death;
            }
            return rows;
          },
          "(K, 2) birth and death [m] of every class of H_1 over Z_2, longest ratio first.")
      .def("betti", &Filtration::betti, "The whole Betti-1 curve.")
      .def("plateaus", &Filtration::plateaus, py::arg("lasting") = kLasting,
           "Stretches of d with at least one lasting loop, widest ratio first.\n\n"
           "A loop lasts whose ratio death / birth is at least `lasting`; 1 counts all.")
      .def(
          "span",
          [](const Filtration& self, const std::vector<int>& cycle, double max_edge_length) {
            const PersistencePair span = self.span(cycle, max_edge_length);
            return std::make_pair(span.birth, span.death);
          },
          py::arg("cycle"), py::arg("max_edge_length"),
          "Birth and death [m] of the class in K_d of a closed walk: indices of points, the first "
          "not repeated.\n\n"
          "Equal where it is filled in K_d. Raises ValueError on a step that is no edge.")
      .def("__repr__", [](const Filtration& self) {
        return "<Filtration of " + std::to_string(self.num_vertices()) + " points>";
      });
}

void bind_loops(py::module_& m) {
  py::class_<Loop>(m, "Loop",
                   "A closed polyline on a cloud: one of the shortest that tell its holes apart.")
      .def_property_readonly(
          "points", [](const Loop& self) -> Rows3 { return self.points.transpose(); },
          "(K, 3) corners in order; the last is joined to the first [m].")
      .def_property_readonly(
          "vertices", [](const Loop& self) { return self.vertices; },
          "The same, as indices of the cloud given.")
      .def_readonly("length", &Loop::length, "[m].")
      .def_readonly("birth", &Loop::birth, "The hole is there for d above this [m].")
      .def_readonly("death", &Loop::death, "The hole is filled for d above this [m].")
      .def_readonly("thickness", &Loop::thickness,
                    "Of what the loop runs along, at its thinnest place [m].")
      .def("__repr__", [](const Loop& self) {
        return "<Loop of " + std::to_string(self.points.cols()) + " corners, " + text(self.length) +
               " m>";
      });

  py::class_<LoopOptions> options(m, "LoopOptions", "How to look for loops.");
  bind_fields(options, "Any field by keyword; the others keep their defaults.",
              Field{"max_edge_length", &LoopOptions::max_edge_length,
                    "d [m]; 0 takes the widest plateau of the Betti curve."},
              Field{"lowest_plateau", &LoopOptions::lowest_plateau,
                    "Instead, the lowest plateau with at least lowest_ratio: splits less sure "
                    "holes off, and takes patches that the camera missed for holes."},
              Field{"lowest_ratio", &LoopOptions::lowest_ratio, "See lowest_plateau."},
              Field{"min_ratio", &LoopOptions::min_ratio,
                    "Below this ratio of the plateau there is no reliable hole."},
              Field{"max_points", &LoopOptions::max_points,
                    "Clouds with more points are thinned to about half of this."},
              Field{"polish", &LoopOptions::polish,
                    "After thinning: shorten the loops on the whole cloud."},
              Field{"drop_meridians", &LoopOptions::drop_meridians,
                    "Leave out loops that run around a thick handle instead of along it."});

  py::native_enum<LoopStatus>(m, "LoopStatus", "enum.Enum", "How a search for loops ended.")
      .value("found", LoopStatus::found, "There are loops.")
      .value("no_reliable_hole", LoopStatus::no_reliable_hole, "None that can be relied on.")
      .finalize();

  py::class_<Loops>(m, "Loops", "The loops of a cloud, and what they were taken from.")
      .def_readonly("status", &Loops::status, "Whether loops were found.")
      .def_readonly("reason", &Loops::reason, "One sentence, for people.")
      .def_property_readonly(
          "loops", [](const Loops& self) { return self.loops; }, "Shortest first.")
      .def_property_readonly(
          "meridians", [](const Loops& self) { return self.meridians; },
          "Left out: they run around a thick handle, not along it.")
      .def_readonly("complex", &Loops::complex, "K_d, of the thinned cloud where it was thinned.")
      .def_readonly("betti", &Loops::betti, "The Betti curve of the same cloud.")
      .def_readonly("plateau", &Loops::plateau, "The one chosen; zero where d was given.")
      .def_property_readonly(
          "warnings", [](const Loops& self) { return self.warnings; }, "For people.")
      .def("__repr__", [](const Loops& self) { return "<Loops: " + self.reason + ">"; });

  py::class_<ClaspTarget> target(m, "ClaspTarget", "A place on a loop where a hand may clasp.");
  bind_fields(target, "Any field by keyword; the others keep their defaults.",
              Field{"point", &ClaspTarget::point, "(3,) [m]."},
              Field{"tangent", &ClaspTarget::tangent, "(3,) unit, along the loop."});
}

Loops shortest_loops_released(const Array& points, const LoopOptions& options) {
  const Eigen::Matrix3Xd columns = to_points3(points, "points");
  const py::gil_scoped_release release;
  return shortest_loops(columns, options);
}

void bind_shortest_loops(py::module_& m) {
  const LoopOptions defaults;
  m.def(
      "shortest_loops",
      [](const Array& points, std::optional<double> max_edge_length, bool lowest_plateau,
         double lowest_ratio, double min_ratio, int max_points, bool polish, bool drop_meridians) {
        return shortest_loops_released(
            points, {max_edge_length.value_or(0), lowest_plateau, lowest_ratio, min_ratio,
                     max_points, polish, drop_meridians});
      },
      py::arg("points"), py::arg("max_edge_length") = py::none(), py::kw_only(),
      py::arg("lowest_plateau") = defaults.lowest_plateau,
      py::arg("lowest_ratio") = defaults.lowest_ratio, py::arg("min_ratio") = defaults.min_ratio,
      py::arg("max_points") = defaults.max_points, py::arg("polish") = defaults.polish,
      py::arg("drop_meridians") = defaults.drop_meridians,
      "The shortest loops through the holes of what a cloud was taken from: a shortest basis of "
      "H_1(K_d; Z_2).\n\n"
      "points: (N, 3) [m]. max_edge_length: d [m]; None takes the widest plateau of the Betti "
      "curve. The keywords are those of LoopOptions.\n\n"
      "Not found is a status, see Loops.reason. Raises ValueError on fewer than 20 distinct "
      "points, values that are not finite, points in a plane, or more than 10^7 points.\n\n"
      ">>> for loop in shortest_loops(points).loops: print(loop.length, loop.points)");
  m.def("shortest_loops", &shortest_loops_released, py::arg("points"), py::arg("options"),
        "The same with all options in one.");
  m.def(
      "clasp_targets",
      [](const LoopOrRows& loop, int count) { return clasp_targets(to_loop(loop, "loop"), count); },
      py::arg("loop"), py::arg("count"),
      "`count` ClaspTargets at equal arc length of a Loop or of corners (K, 3), the first at the "
      "first corner.");
}

void bind_linking(py::module_& m) {
  py::class_<VirtualLinking>(m, "VirtualLinking", "Virtual linking with its derivative.")
      .def_readonly("value", &VirtualLinking::value, "Eq. (2), signed.")
      .def_readonly("linking_number", &VirtualLinking::linking_number,
                    "Of the loop and the closed curve.")
      .def_property_readonly(
          "gradient", [](const VirtualLinking& self) -> Rows3 { return self.gradient.transpose(); },
          "(K, 3): row i by corner i of the curve [1/m].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"value", "linking_number"});
      });

  py::class_<PreparedLoop>(m, "PreparedLoop", "A closed loop prepared for many questions.")
      .def(py::init([](const LoopOrRows& loop) { return PreparedLoop(to_loop(loop, "loop")); }),
           py::arg("loop"), "loop: a Loop, or its corners (K, 3) [m].")
      .def_property_readonly(
          "points", [](const PreparedLoop& self) -> Rows3 { return self.points().transpose(); },
          "(K, 3) [m].")
      .def(
          "gauss_linking",
          [](const PreparedLoop& self, const std::vector<Array>& curves, bool are_closed) {
            return self.gauss_linking(to_curves(curves), are_closed);
          },
          py::arg("curves"), py::arg("are_closed") = true,
          "The Gauss integral of the loop with each curve, (K, 3) [m].")
      .def(
          "linking_numbers",
          [](const PreparedLoop& self, const std::vector<Array>& curves) {
            return self.linking_numbers(to_curves(curves));
          },
          py::arg("curves"), "The linking number of the loop with each closed curve, (K, 3) [m].")
      .def("__repr__", [](const PreparedLoop& self) {
        return count("PreparedLoop", self.points().cols(), "corners");
      });

  m.def(
      "gauss_linking",
      [](const LoopOrRows& a, const LoopOrRows& b, bool a_is_closed, bool b_is_closed) {
        return gauss_linking(to_loop(a, "a"), a_is_closed, to_loop(b, "b"), b_is_closed);
      },
      py::arg("a"), py::arg("b"), py::kw_only(), py::arg("a_is_closed") = true,
      py::arg("b_is_closed") = true,
      "The Gauss linking integral of two polylines, (K, 3) [m]; an integer where both are "
      "closed.\n\n"
      "Segments that touch or lie on one line count 0: the value is finite.");
  m.def(
      "linking_number",
      [](const LoopOrRows& a, const LoopOrRows& b) {
        return linking_number(to_loop(a, "a"), to_loop(b, "b"));
      },
      py::arg("a"), py::arg("b"),
      "How often two closed polylines, (K, 3) [m], wind around one another: by signed crossings.");
  m.def(
      "virtual_linking",
      [](const LoopOrRows& loop, const Array& curve) {
        return virtual_linking(to_loop(loop, "loop"), to_points3(curve, "curve"));
      },
      py::arg("loop"), py::arg("curve"),
      "Virtual linking (Stork, Pokorny, Kragic 2013, eq. 2) of a closed loop and an open curve, "
      "(K, 3) [m]; signed.");
  m.def(
      "virtual_linking_gradient",
      [](const LoopOrRows& loop, const Array& curve) {
        return virtual_linking_gradient(to_loop(loop, "loop"), to_points3(curve, "curve"));
      },
      py::arg("loop"), py::arg("curve"), "Virtual linking with its derivative by the corners.");
}

void bind_sampling(py::module_& m) {
  m.def(
      "sample_surface",
      [](const std::vector<PlacedShape>& shapes, int count, std::uint64_t seed) -> Rows3 {
        const py::gil_scoped_release release;
        return sample_surface(shapes, count, seed).transpose();
      },
      py::arg("shapes"), py::arg("count"), py::arg("seed") = 1,
      "`count` points (N, 3) [m] spread evenly over the outer surface of the shapes' union.\n\n"
      "The same seed gives the same points.");
  m.def(
      "visible_points",
      [](const Array& points, const Array& viewpoint) {
        return to_array(
            visible_points(to_points3(points, "points"), to_vector3(viewpoint, "viewpoint")));
      },
      py::arg("points"), py::arg("viewpoint"),
      "Indices of the points (N, 3) that are seen from viewpoint, (3,) [m]; ascending.");
  m.def(
      "spacing", [](const Array& points) { return spacing(to_points3(points, "points")); },
      py::arg("points"), "The median distance from a point to its nearest other point [m].");
  m.def(
      "downsample",
      [](const Array& points, double cell) {
        return to_array(downsample(to_points3(points, "points"), cell));
      },
      py::arg("points"), py::arg("cell"),
      "Indices of one point (N, 3) a cubic cell of side `cell` [m]; ascending.");
}

}  // namespace

void bind_geometry(py::module_ m) {
  bind_shapes(m);
  bind_polygon(m);
  bind_band(m);
  bind_complex(m);
  bind_loops(m);
  bind_shortest_loops(m);
  bind_linking(m);
  bind_sampling(m);
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
