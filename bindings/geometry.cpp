// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <filesystem>
#include <optional>
#include <random>
#include <stdexcept>

#include <pybind11/native_enum.h>
#include <pybind11/stl/filesystem.h>

#include "graspless/geometry/band.hpp"
#include "graspless/geometry/complex.hpp"
#include "graspless/geometry/height_map.hpp"
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

/// Reads a format that the core does not know.
Mesh read_in_python(const std::string& path) {
  const py::gil_scoped_acquire acquire;
  try {
    return py::module_::import("graspless._mesh_reader").attr("read")(path).cast<Mesh>();
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_ValueError)) throw;
    throw std::invalid_argument(py::str(error.value()).cast<std::string>());
  }
}

void bind_shapes(py::module_& m) {
  py::class_<Box>(m, "Box", "A box centred at its frame's origin, sides along the axes.")
      .def(py::init([](const Array& size) {
             return validated(Box{to_vector3(size, "box size")}, "box");
           }),
           py::arg("size"), "size: (3,) side lengths [m], each in [1e-6, 10000].")
      .def_property_readonly("size", shown(&Box::size), "(3,) side lengths [m].")
      .def("__repr__", [](const py::object& self) { return represent(self, {"size"}); });

  py::class_<Sphere>(m, "Sphere", "A sphere centred at its frame's origin.")
      .def(py::init([](double radius) { return validated(Sphere{radius}, "sphere"); }),
           py::arg("radius"), "radius: radius [m], in [1e-6, 10000].")
      .def_readonly("radius", &Sphere::radius, "Radius [m].")
      .def("__repr__", [](const py::object& self) { return represent(self, {"radius"}); });

  py::class_<Capsule>(
      m, "Capsule",
      "All points within radius of the segment from (0, 0, -length/2) to (0, 0, length/2).")
      .def(py::init([](double radius, double length) {
             return validated(Capsule{radius, length}, "capsule");
           }),
           py::arg("radius"), py::arg("length"),
           "radius, length: [m], each in [1e-6, 10000]. length: of the segment.")
      .def_readonly("radius", &Capsule::radius, "Radius [m].")
      .def_readonly("length", &Capsule::length,
                    "Length of the segment, without the two half spheres [m].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"radius", "length"});
      });

  py::class_<Convex>(m, "Convex", "The convex hull of a set of points.")
      .def(py::init([](const Array& vertices) {
             return validated(Convex{to_points3(vertices, "convex vertices")}, "convex");
           }),
           py::arg("vertices"), "vertices: (N, 3) points that span a volume [m].")
      .def_property_readonly("vertices", shown(&Convex::vertices), "(N, 3) points [m].")
      .def("__repr__",
           [](const Convex& shape) { return count("Convex", shape.vertices.cols(), "points"); });

  py::class_<Mesh>(m, "Mesh",
                   "A triangle surface. One that is closed bounds a solid: what is wholly inside "
                   "touches it. Of any other, only the surface collides.")
      .def(py::init([](const Array& vertices, const Array& triangles) {
             return validated(Mesh{to_points3(vertices, "mesh vertices"),
                                   to_triangles(triangles, "mesh triangles")},
                              "mesh");
           }),
           py::arg("vertices"), py::arg("triangles"),
           "vertices: (N, 3) [m]. triangles: (M, 3) vertex indices.")
      .def_property_readonly("vertices", shown(&Mesh::vertices), "(N, 3) vertices [m].")
      .def_property_readonly("triangles", shown(&Mesh::triangles),
                             "(M, 3) vertex indices of the triangles.")
      .def("__repr__",
           [](const Mesh& mesh) { return count("Mesh", mesh.triangles.cols(), "triangles"); });

  py::class_<PlacedShape>(m, "PlacedShape", "A shape fixed in the frame of a body B.")
      .def(py::init([](const Shape& shape, const Array& X_BG) {
             return PlacedShape{shape, to_pose(X_BG, "X_BG")};
           }),
           py::arg("shape"), pose_arg("X_BG"),
           "shape: Box, Sphere, Capsule, Convex or Mesh. X_BG: (4, 4) pose of its frame G in B.")
      .def_readonly("shape", &PlacedShape::shape, "Box, Sphere, Capsule, Convex or Mesh.")
      .def_property_readonly("X_BG", shown(&PlacedShape::X_BG),
                             "(4, 4) pose of the shape's frame G in B.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"shape", "X_BG"});
      });

  set_mesh_reader(read_in_python);
  m.def(
      "read_mesh",
      [](const std::filesystem::path& path, const std::variant<double, Array>& scale) {
        return read_mesh(path.string(), to_scale(scale));
      },
      py::arg("path"), py::arg("scale") = 1.0,
      R"(Reads a triangle mesh. Polygons are triangulated.

Parameters
----------
path : str or Path
    File of type .stl, .obj, .off or .ply; with the extra `robots` also .dae, .glb or .gltf.
scale : float or (3,) array, optional
    Factor for all coordinates, or one per axis. Converts the unit of the file to metres.

Returns
-------
Mesh
    Vertices in [m].

Raises
------
ValueError
    If the file is missing, unreadable or empty; names the path.
)");
}

void bind_polygon(py::module_& m) {
  py::class_<Polygon> polygon(
      m, "Polygon",
      "A simple polygon in the plane with counter-clockwise vertices, convex or not.");
  py::class_<Polygon::Edge>(m, "Edge", "An edge of a polygon.")
      .def_readonly("index", &Polygon::Edge::index, "Index of its first vertex.")
      .def_property_readonly("a", shown(&Polygon::Edge::a), "(2,) first end point [m].")
      .def_property_readonly("b", shown(&Polygon::Edge::b), "(2,) second end point [m].")
      .def_property_readonly("inward", shown(&Polygon::Edge::inward),
                             "(2,) unit normal pointing inside.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"index", "a", "b", "inward"});
      });
  polygon
      .def(
          py::init([](const Array& vertices, const std::string& what) {
            return Polygon(to_points2(vertices, what), what);
          }),
          py::arg("vertices"), py::arg("what") = "polygon",
          "vertices: (N, 2) [m]; a clockwise list is reversed. what: name used in error "
          "messages.\n\n"
          "Raises ValueError on fewer than three vertices, a value that is not finite, a repeated\n"
          "vertex, or a boundary that crosses or touches itself.")
      .def_property_readonly("vertices", shown(&Polygon::vertices),
                             "(N, 2) vertices, counter-clockwise [m].")
      .def("__len__", &Polygon::size, "Number of vertices.")
      .def_property_readonly("area", &Polygon::area, "Area [m^2], positive.")
      .def_property_readonly("centroid", &Polygon::centroid, "(2,) centroid of the area [m].")
      .def_property_readonly("is_convex", &Polygon::is_convex, "True if no corner is reflex.")
      .def(
          "contains",
          [](const Polygon& self, const Array& p) { return self.contains(to_vector2(p, "p")); },
          py::arg("p"), "True if the point p, (2,) [m], lies inside.")
      .def(
          "depth",
          [](const Polygon& self, const Array& p) { return self.depth(to_vector2(p, "p")); },
          py::arg("p"),
          "Signed distance from p, (2,), to the boundary [m]: positive inside, negative outside.")
      .def("edge", &Polygon::edge, py::arg("index"), "Edge from vertex `index` to the next.")
      .def(
          "nearest_edge",
          [](const Polygon& self, const Array& p) { return self.nearest_edge(to_vector2(p, "p")); },
          py::arg("p"), "Edge nearest to p, (2,) [m].")
      .def("convex_parts", &Polygon::convex_parts, py::call_guard<py::gil_scoped_release>(),
           "Convex polygons that cover this one without overlap.")
      .def("__repr__",
           [](const Polygon& self) { return count("Polygon", self.size(), "vertices"); });
}

void bind_band(py::module_& m) {
  py::class_<Band>(
      m, "Band",
      "The points of a polygon near its edges: the polygon minus its contraction by `width`.\n\n"
      "P_g of Hang, Morgan, Dollar 2019, Section IV-B.")
      .def(py::init<const Polygon&, double>(), py::arg("polygon"), py::arg("width"),
           py::call_guard<py::gil_scoped_release>(),
           "width: width of the band [m], in [1e-6, 10000].")
      .def_property_readonly("polygon", &Band::polygon, "The polygon.")
      .def_property_readonly("width", &Band::width, "Width of the band [m].")
      .def_property_readonly("core", &Band::core,
                             "Pieces of the contracted polygon; empty if nothing is left.")
      .def_property_readonly(
          "exact", &Band::exact,
          "False if the contraction failed verification. Then `core` is empty, and `contains`\n"
          "and `sample` use the distance to the boundary.")
      .def(
          "contains",
          [](const Band& self, const Array& p) { return self.contains(to_vector2(p, "p")); },
          py::arg("p"), "True if the point p, (2,) [m], lies in the band.")
      .def(
          "sample",
          [](const Band& self, std::uint64_t seed, double margin) {
            std::mt19937_64 rng(seed);
            return self.sample(rng, margin);
          },
          py::arg("seed"), py::arg("margin") = 0.0,
          R"(Draws a random point of the band, uniform by area if `exact`.

Parameters
----------
seed : int
    The same seed gives the same point.
margin : float, optional
    Smallest distance to the boundary of the polygon [m].

Returns
-------
(2,) array or None
    [m]. None after 1000 failed draws, as when the margin leaves no room.
)")
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
                      "Simplicial complex K_d of a cloud: the edges and triangles of its Delaunay "
                      "triangulation\nwith all edges shorter than d (Stork, Pokorny, Kragic 2013, "
                      "Section IV-A).")
      .def_property_readonly("points", shown(&Complex::points), "(N, 3) vertices [m].")
      .def_property_readonly("edges", shown(&Complex::edges),
                             "(E, 2) point indices, the smaller first; sorted.")
      .def_property_readonly(
          "triangles", shown(&Complex::triangles),
          "(T, 3) point indices, ascending; sorted. Includes triangles inside the object.")
      .def_readonly("max_edge_length", &Complex::max_edge_length, "d [m].")
      .def("__repr__", [](const Complex& self) {
        return "<Complex of " + std::to_string(self.edges.cols()) + " edges and " +
               std::to_string(self.triangles.cols()) + " triangles shorter than " +
               text(self.max_edge_length) + " m>";
      });

  py::class_<BettiCurve>(m, "BettiCurve",
                         "Number of independent loops of K_d as a step function of d.\n\n"
                         "It is loops[i] for d in (max_edge_length[i], max_edge_length[i + 1]], "
                         "and 0 below.")
      .def_property_readonly("max_edge_length", shown(&BettiCurve::max_edge_length),
                             "Values of d where the number changes, ascending [m].")
      .def_property_readonly("loops", shown(&BettiCurve::loops),
                             "Number of loops above each value.")
      .def("__repr__", [](const BettiCurve& self) {
        return "<BettiCurve of " + std::to_string(self.loops.size()) + " steps>";
      });

  py::class_<Plateau>(m, "Plateau",
                      "Interval of d over which the set of lasting loops does not change.")
      .def_readonly("lower", &Plateau::lower, "Lower bound of d [m], excluded.")
      .def_readonly("upper", &Plateau::upper, "Upper bound of d [m], included.")
      .def_readonly("loops", &Plateau::loops,
                    "Number of lasting loops; 0 if no plateau was selected.")
      .def_property_readonly("ratio", &Plateau::ratio,
                             "upper / lower. A large ratio means reliable loops.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"lower", "upper", "loops"});
      });

  py::class_<Filtration>(m, "Filtration",
                         "The Delaunay triangulation of a cloud with its simplices ordered by "
                         "longest edge.\n\nIt represents K_d for every d.")
      .def(py::init([](const Array& points, const std::string& what) {
             const Eigen::Matrix3Xd columns = to_points3(points, what);
             const py::gil_scoped_release release;
             return Filtration(columns, what);
           }),
           py::arg("points"), py::arg("what") = "points",
           "points: (N, 3) [m]; equal points count once. what: name used in error messages.\n\n"
           "Raises ValueError if there are fewer than 4 distinct points, if one is not finite, or "
           "if\nall lie in a plane.")
      .def_property_readonly("points", shown(&Filtration::points), "(N, 3) input points [m].")
      .def_property_readonly("num_vertices", &Filtration::num_vertices,
                             "Number of distinct points.")
      .def("complex", &Filtration::complex, py::arg("max_edge_length"),
           "Returns K_d for d = max_edge_length [m].\n\nRaises ValueError if it is "
           "negative.")
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
          "Persistence pairs of H_1 over Z_2: (K, 2) birth and death [m].\n\n"
          "Largest ratio death / birth first. Omits pairs that die at birth.")
      .def("betti", &Filtration::betti,
           "Number of independent loops for every d (first Betti number).")
      .def("plateaus", &Filtration::plateaus, py::arg("lasting_ratio") = kLastingRatio,
           "Plateaus of the Betti curve with at least one lasting loop, largest ratio first.\n\n"
           "lasting_ratio: smallest ratio death / birth of a lasting loop; 1 counts every loop.\n\n"
           "Raises ValueError if it is less than 1.")
      .def(
          "span",
          [](const Filtration& self, const std::vector<int>& cycle, double max_edge_length) {
            const PersistencePair span = self.span(cycle, max_edge_length);
            return std::make_pair(span.birth, span.death);
          },
          py::arg("cycle"), py::arg("max_edge_length"),
          R"(Birth and death of the homology class of a closed walk in K_d.

Parameters
----------
cycle : list of int
    Point indices of the walk, without repeating the first.
max_edge_length : float
    d of K_d [m].

Returns
-------
(float, float)
    Birth and death [m]. Equal if the walk is filled in K_d.

Raises
------
ValueError
    If a step of the walk is not an edge of K_d, or if it has fewer than 3.
)")
      .def("__repr__", [](const Filtration& self) {
        return "<Filtration of " + std::to_string(self.num_vertices()) + " points>";
      });
}

using Ends = decltype(RayImage::ends);
using BoolImage = py::array_t<bool, py::array::c_style | py::array::forcecast>;

RayImage to_ray_image(const FloatImage& ends, const Array& K, const Array& X_OC,
                      const std::optional<FloatImage>& clear = std::nullopt) {
  if (ends.ndim() != 2) {
    throw std::invalid_argument("ends has " + std::to_string(ends.ndim()) +
                                " dimensions; it must have shape (H, W)");
  }
  RayImage rays;
  rays.ends = Eigen::Map<const Ends>(ends.data(), ends.shape(0), ends.shape(1));
  if (clear && clear->ndim() != 2) throw std::invalid_argument("clear must have shape (H, W)");
  if (clear) rays.clear = Eigen::Map<const Ends>(clear->data(), clear->shape(0), clear->shape(1));
  rays.K = to_matrix3(K, "K");
  rays.X_OC = to_pose(X_OC, "X_OC");
  validate(rays, "rays");
  return rays;
}

/// A depth image is 0 or not finite where it has no measurement.
RayImage rays_of_depth(const FloatImage& depth, const BoolImage& is_object, const Array& K,
                       const Array& X_OC) {
  if (is_object.ndim() != 2 || depth.ndim() != 2 || is_object.shape(0) != depth.shape(0) ||
      is_object.shape(1) != depth.shape(1)) {
    throw std::invalid_argument("is_object must have the shape (H, W) of depth");
  }
  FloatImage ends(std::vector<py::ssize_t>{depth.shape(0), depth.shape(1)});
  for (py::ssize_t i = 0; i < depth.size(); ++i) {
    const float z = depth.data()[i];
    const bool is_seen = z > 0 && std::isfinite(z);
    ends.mutable_data()[i] = !is_seen ? 0 : is_object.data()[i] ? -z : z;
  }
  return to_ray_image(ends, K, X_OC);
}

void bind_ray_image(py::module_& m) {
  py::class_<RayImage> cls(m, "RayImage",
                           "Rays of a camera around an object. They show where the object is, and "
                           "where it is open.");
  bind_pickling(cls, {"ends", "K", "X_OC", "clear"});
  cls.def(py::init(&to_ray_image), py::arg("ends"), py::arg("K"), py::arg("X_OC"),
          py::arg("clear") = py::none(),
          "ends: (H, W) depth at which the ray of each pixel ends, along the optical axis [m]. "
          "Negative: the ray ends on the object, at minus this depth. Infinite: it passes the "
          "object. 0: unknown. K: (3, 3) camera matrix of this image [pixels]. X_OC: (4, 4) pose "
          "of the optical frame in the frame of the object's points, z forward. clear: (H, W) "
          "depth up to which a ray of unknown end met nothing [m]; 0: nobody knows.")
      .def_static("from_depth", &rays_of_depth, py::arg("depth"), py::arg("is_object"),
                  py::arg("K"), py::arg("X_OC"),
                  "Makes rays from a depth image.\n\ndepth: (H, W) [m]; 0 or not finite: unknown. "
                  "is_object: (H, W), true for the pixels of the object. K: (3, 3) camera matrix "
                  "[pixels]. X_OC: (4, 4) pose of the optical frame in the frame of the object's "
                  "points, z forward.")
      .def_property_readonly(
          "ends", shown(&RayImage::ends),
          "(H, W) depths of the ends [m], float32. Negative: on the object; infinite: passes; 0: "
          "unknown.")
      .def_property_readonly(
          "clear",
          [](const RayImage& self) -> const Ends {
            return self.clear.size() > 0 ? self.clear
                                         : Ends(Ends::Zero(self.ends.rows(), self.ends.cols()));
          },
          "(H, W) depths up to which rays of unknown end met nothing [m], float32; 0: nobody "
          "knows.")
      .def_property_readonly("K", shown(&RayImage::K), "(3, 3) camera matrix [pixels].")
      .def_property_readonly(
          "X_OC", shown(&RayImage::X_OC),
          "(4, 4) pose of the optical frame in the frame of the object's points.")
      .def("__repr__", [](const RayImage& self) {
        return "<RayImage of " + std::to_string(self.ends.cols()) + " x " +
               std::to_string(self.ends.rows()) + " pixels>";
      });
}

void bind_rays_from_viewpoints(py::module_& m) {
  m.def(
      "rays_from_viewpoints",
      [](const Array& points, const Array& viewpoints) {
        const Eigen::Matrix3Xd p = to_points3(points, "points");
        const Eigen::Matrix3Xd eyes = to_points3(viewpoints, "viewpoints");
        const py::gil_scoped_release release;
        return rays_from_viewpoints(p, eyes);
      },
      py::arg("points"), py::arg("viewpoints"),
      R"(Makes rays of cameras of which only the positions are known.

A ray ends on the object if a point is within two spacings of it in the image, and passes it
otherwise. The cloud must have all that the cameras saw of the object, and nothing else. Depth
images are better: a patch that a camera did not see, such as dark material, looks open here.

Parameters
----------
points : (N, 3) array
    Points of the object [m], in any frame.
viewpoints : (K, 3) array
    Positions of the cameras in the same frame [m].

Returns
-------
list of RayImage
    One for each viewpoint, for `shortest_loops`.

Raises
------
ValueError
    If there are fewer than 20 points, one is not finite, or a viewpoint is among the points: they
    must lie within 60 degrees of the direction to their middle.
)");
}

using HeightRows = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

void bind_height_map(py::module_& m) {
  py::class_<HeightMap>(
      m, "HeightMap",
      "Heights over the plane z = 0 of a frame O, one for each square cell: the solid between them "
      "and the plane.\n\nA vessel that is open at the top can be described so; an overhang is "
      "filled.")
      .def(
          py::init([](const Eigen::Vector2d& corner, double cell, const HeightRows& heights,
                      const std::optional<HeightRows>& undersides) {
            HeightMap map;
            map.corner = corner;
            map.cell = cell;
            map.heights = heights;
            if (undersides) map.undersides = *undersides;
            validate(map, "map");
            return map;
          }),
          py::arg("corner"), py::arg("cell"), py::arg("heights"),
          py::arg("undersides") = py::none(),
          "corner: (2,) least x and y of the first cell [m]. cell: side of a cell [m]. heights: "
          "(nx, ny) [m], the first index along x; 0: nothing is there. undersides: (nx, ny) lowest "
          "height at which each cell was seen [m]; None: the cells are known to be solid down to "
          "the plane.\n\nRaises ValueError unless "
          "there are 1 to 10^6 cells of at least 1e-4 m, none with a negative height and one with "
          "a height of at least 1e-6 m.")
      .def_property_readonly("corner", shown(&HeightMap::corner),
                             "(2,) least x and y of the first cell [m].")
      .def_property_readonly("cell", shown(&HeightMap::cell), "Side of a cell [m].")
      .def_property_readonly(
          "heights", [](const HeightMap& self) -> const HeightRows { return self.heights; },
          "(nx, ny) heights [m].")
      .def_property_readonly(
          "undersides",
          [](const HeightMap& self) -> std::optional<const HeightRows> {
            if (self.undersides.size() == 0) return std::nullopt;
            return self.undersides;
          },
          "(nx, ny) lowest heights at which the cells were seen [m]; None: they are known to be "
          "solid.")
      .def("at", &HeightMap::at, py::arg("p_O"),
           "Returns the height at a point, (2,) in O; 0 beyond the cells [m].")
      .def("__repr__", [](const HeightMap& self) {
        return "<HeightMap of " + std::to_string(self.heights.rows()) + " x " +
               std::to_string(self.heights.cols()) + " cells>";
      });
  m.def("columns", &columns, py::arg("map"), py::arg("step"),
        "Returns boxes that fill a map, as PlacedShapes in O.\n\nCells of nearly the same height "
        "share one: each box is as high as the next multiple of `step` [m], but not higher than "
        "the highest cell.\n\nRaises ValueError unless `step` is at least 1e-6 m.");
  m.def(
      "seen_heights",
      [](const Array& points, const std::vector<RayImage>& rays, const Polygon& outline, double top,
         double cell) {
        const Eigen::Matrix3Xd p = to_points3(points, "points");
        const py::gil_scoped_release release;
        return seen_heights(p, rays, outline, top, cell);
      },
      py::arg("points"), py::arg("rays"), py::arg("outline"), py::arg("top"), py::arg("cell"),
      R"(Returns the HeightMap of an object as cameras saw it.

A cell is as high as its highest point. Where the cameras saw no point, the object is as high as it
may be: up to the lowest of the rays that pass over the cell, one below the other, or up to the top.
Nothing was seen of such a cell: its underside is its height.

Parameters
----------
points : array (N, 3)
    Points on the object, in O [m].
rays : list of RayImage
    Rays of the cameras, in O.
outline : Polygon
    Outline of the object in O [m]. Cells beyond its convex hull without points have the height 0.
top : float
    Height of the object [m].
cell : float
    Side of a cell [m].

Raises
------
ValueError
    If a point is not finite, or the map would have more than 1000 cells along a side, more than
    2e7 voxels of two cells' height below the top, or no height.
)");
}

void bind_loops(py::module_& m) {
  py::class_<Loop>(m, "Loop",
                   "A closed polyline on a cloud: an element of a shortest basis of H_1(K_d).")
      .def_property_readonly("points", shown(&Loop::points),
                             "(K, 3) corners in order [m]; the last connects to the first.")
      .def_property_readonly("vertices", shown(&Loop::vertices),
                             "Indices of the corners in the input cloud.")
      .def_readonly("length", &Loop::length, "Length of the closed polyline [m].")
      .def_readonly("birth", &Loop::birth, "The loop exists in K_d for d above this value [m].")
      .def_readonly(
          "death", &Loop::death,
          "The loop is filled in K_d for d above this value [m]. A body wider than this does not\n"
          "pass the hole.")
      .def_readonly(
          "thickness", &Loop::thickness,
          "Thickness of the handle that the loop runs along, at its thinnest cross-section [m];\n"
          "0 if unknown.")
      .def_readonly(
          "width", &Loop::width,
          "Width of the same handle in its narrowest direction [m]; 0 if unknown. Two jaws must\n"
          "open farther.")
      .def_readonly("gap", &Loop::gap,
                    "Longest step of the loop through open space [m]; 0 if it runs along the "
                    "surface throughout. The object may come free there.")
      .def_readonly("max_edge_length", &Loop::max_edge_length,
                    "d of the complex in which it is shortest [m]: the loop's own scale.")
      .def_readonly(
          "openness", &Loop::openness,
          "Share of the directions in which a ray from the middle of the hole leaves the object, "
          "on\n"
          "the side where fewer do. The inside of a solid is closed on at least one side.")
      .def_readonly(
          "jump", &Loop::jump,
          "Length of the longest step around the hole, relative to the next one. Evenly spread\n"
          "points have about 1. Large values mean that the object is open there, or was not seen.")
      .def_readonly("seen_through", &Loop::seen_through,
                    "Area across the rays that passed through it [m^2], for the camera that saw "
                    "most of it. Rays\nthat end on the object prove nothing. 0 without rays.")
      .def_readonly("unseen", &Loop::unseen,
                    "Share of its length that lies where no ray reached the object, in [0, 1]. 0 "
                    "without rays.")
      .def_readonly("reason", &Loop::reason,
                    "Reason why it is uncertain or discarded; empty for a hole that was found.")
      .def("__repr__", [](const Loop& self) {
        return "<Loop of " + std::to_string(self.points.cols()) + " corners, " + text(self.length) +
               " m>";
      });

  bind_ray_image(m);
  bind_height_map(m);
  bind_rays_from_viewpoints(m);
  py::class_<LoopOptions> options(m, "LoopOptions", "Options of shortest_loops().");
  bind_fields(
      options, "Any field by keyword; the others keep their defaults.",
      Field{"max_edge_length", &LoopOptions::max_edge_length,
            "d of K_d [m], in [0, 10000]. 0: each hole has its own."},
      Field{"min_ratio", &LoopOptions::min_ratio,
            "Least width of a hole that counts as found, relative to the gaps between the points\n"
            "near it: its death over the median birth of the gaps; above 1."},
      Field{"max_points", &LoopOptions::max_points,
            "Largest number of points without downsampling, in [100, 10^6]. A larger cloud is\n"
            "downsampled to about half of this."},
      Field{"polish", &LoopOptions::polish,
            "Shorten the loops of a downsampled cloud on all its points, at most 10^6."},
      Field{"drop_meridians", &LoopOptions::drop_meridians,
            "Discard loops that run around a thick handle instead of along it."},
      Field{"threads", &LoopOptions::threads,
            "Number of threads that share the polishing, in [1, 256]. Loops do not depend on it."},
      Field{"all_sides", &LoopOptions::all_sides,
            "The points are of all sides of the object: no loop is the edge of what a camera saw.\n"
            "No effect with rays."});

  py::native_enum<LoopStatus>(m, "LoopStatus", "graspless._named.Named",
                              "Outcome of shortest_loops().")
      .value("found", LoopStatus::found, "At least one loop was found.")
      .value("no_reliable_hole", LoopStatus::no_reliable_hole,
             "No class of H_1 is a hole for certain.")
      .finalize();

  py::class_<Loops>(m, "Loops", "Result of shortest_loops().")
      .def_readonly("status", &Loops::status, "Outcome of the search.")
      .def_readonly("reason", &Loops::reason, "Explanation of the status in one sentence.")
      .def_property_readonly("found", shown(&Loops::found), "Loops of the holes, shortest first.")
      .def_property_readonly("uncertain", shown(&Loops::uncertain),
                             "Loops that may be holes, each with a reason; shortest first.")
      .def_property_readonly("meridians", shown(&Loops::meridians),
                             "Discarded loops: they run around a thick handle, not along it.")
      .def_readonly("has_rays", &Loops::has_rays,
                    "True if rays of cameras decided which loops are holes.")
      .def_readonly("noise", &Loops::noise,
                    "Number of classes that do not live long enough to be listed.")
      .def_readonly("complex", &Loops::complex,
                    "K_d of the cloud, after downsampling, for most of the holes.")
      .def_readonly("surface", &Loops::surface,
                    "Part of K_d at the cloud's own resolution: edges no longer than twice the "
                    "local spacing, and their triangles.")
      .def_readonly("betti", &Loops::betti, "Betti curve of the same points.")
      .def_readonly(
          "plateau", &Loops::plateau,
          "Values of d at which the holes of `complex` exist; zero if max_edge_length was\n"
          "given.")
      .def_property_readonly("warnings", shown(&Loops::warnings),
                             "Warnings about the cloud and the result.")
      .def("__repr__", [](const Loops& self) { return "<Loops: " + self.reason + ">"; });

  py::class_<ClaspTarget> target(m, "ClaspTarget",
                                 "A point of a loop where a hand may clasp, with its tangent.");
  bind_fields(target, "Any field by keyword; the others keep their defaults.",
              Field{"point", &ClaspTarget::point, "(3,) point on the loop [m]."},
              Field{"tangent", &ClaspTarget::tangent, "(3,) unit vector along the loop."});
}

Loops shortest_loops_released(const Array& points, const LoopOptions& options,
                              const std::vector<RayImage>& rays) {
  const Eigen::Matrix3Xd columns = to_points3(points, "points");
  const LoopOptions now = options;
  const py::gil_scoped_release release;
  return shortest_loops(columns, now, rays);
}

void bind_shortest_loops(py::module_& m) {
  const LoopOptions defaults;
  m.def(
      "shortest_loops",
      [](const Array& points, std::optional<double> max_edge_length, double min_ratio,
         int max_points, bool polish, bool drop_meridians, int threads, bool all_sides,
         const std::vector<RayImage>& rays) {
        return shortest_loops_released(points,
                                       {max_edge_length.value_or(0), min_ratio, max_points, polish,
                                        drop_meridians, threads, all_sides},
                                       rays);
      },
      py::arg("points"), py::arg("max_edge_length") = py::none(), py::kw_only(),
      py::arg("min_ratio") = defaults.min_ratio, py::arg("max_points") = defaults.max_points,
      py::arg("polish") = defaults.polish, py::arg("drop_meridians") = defaults.drop_meridians,
      py::arg("threads") = defaults.threads, py::arg("all_sides") = defaults.all_sides,
      py::arg("rays") = std::vector<RayImage>{},
      R"(Finds the shortest loops through the holes of the object that a cloud was taken from.

They are shortest bases of H_1(K_d; Z_2) (Dey, Sun, Wang 2010; Stork, Pokorny, Kragic 2013,
Section IV-A), where every hole has a d of its own.

Parameters
----------
points : (N, 3) array
    Points on the object's surface [m], in any frame.
max_edge_length : float, optional
    d of K_d [m]. None: each hole has its own.
min_ratio, max_points, polish, drop_meridians, threads, all_sides : optional
    See LoopOptions.
rays : list of RayImage, optional
    Rays of the cameras that saw the points. A loop is then a hole if rays passed through it.
    Without them the distances between the points decide, which is right for points from all
    sides only: without `all_sides`, no loop is found if one camera could have seen nearly all
    points.

Returns
-------
Loops
    In the frame of the points. Finding no loop is a status; see Loops.reason.

Raises
------
ValueError
    If there are fewer than 20 distinct points or more than 10^7 (10^6 with `polish`), if one is
    not finite, if all lie in a plane, or if an option is out of range.

Examples
--------
>>> for loop in shortest_loops(points).found: print(loop.length, loop.points)
)");
  m.def("shortest_loops", &shortest_loops_released, py::arg("points"), py::arg("options"),
        py::arg("rays") = std::vector<RayImage>{}, "Same, with all options in a LoopOptions.");
  m.def(
      "clasp_targets",
      [](const LoopOrRows& loop, int count) { return clasp_targets(to_loop(loop, "loop"), count); },
      py::arg("loop"), py::arg("count"),
      R"(Places clasp targets on a loop at equal arc length (G_gamma of Stork 2013, Section IV-A).

Parameters
----------
loop : Loop or (K, 3) array
    Closed loop, or its corners [m].
count : int
    Number of targets, 1 to 10^6.

Returns
-------
list of ClaspTarget
    In the frame of the loop. The first target is at the first corner.

Raises
------
ValueError
    If `count` is out of range, or the loop has fewer than 3 corners or no length.
)");
}

void bind_linking(py::module_& m) {
  py::class_<VirtualLinking>(m, "VirtualLinking",
                             "Virtual linking, eq. (2) of Stork 2013, with its gradient.")
      .def_readonly("value", &VirtualLinking::value, "VLk of eq. (2), signed.")
      .def_readonly("linking_number", &VirtualLinking::linking_number,
                    "Linking number of the loop and the curve closed by its chord.")
      .def_property_readonly("gradient", shown(&VirtualLinking::gradient),
                             "(K, 3) gradient with respect to the corners of the curve [1/m].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"value", "linking_number"});
      });

  py::class_<PreparedLoop>(m, "PreparedLoop",
                           "A closed loop preprocessed for many linking queries.")
      .def(py::init([](const LoopOrRows& loop) { return PreparedLoop(to_loop(loop, "loop")); }),
           py::arg("loop"),
           "loop: a Loop, or its corners (K, 3) [m].\n\nRaises ValueError if it has fewer than 3 "
           "corners or is not finite.")
      .def_property_readonly("points", shown(&PreparedLoop::points), "(K, 3) corners [m].")
      .def(
          "gauss_linking",
          [](const PreparedLoop& self, const std::vector<Array>& curves, bool are_closed) {
            return self.gauss_linking(to_curves(curves), are_closed);
          },
          py::arg("curves"), py::arg("are_closed") = true,
          "Gauss linking integral of the loop with each curve, (K, 3) [m].")
      .def(
          "linking_numbers",
          [](const PreparedLoop& self, const std::vector<Array>& curves) {
            return self.linking_numbers(to_curves(curves));
          },
          py::arg("curves"), "Linking number of the loop with each closed curve, (K, 3) [m].")
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
      R"(Gauss linking integral of two polylines, eq. (1) of Stork, Pokorny, Kragic 2013.

Parameters
----------
a, b : Loop or (K, 3) array
    Corners of the polylines [m], in one frame. A closed one does not repeat its first corner.
a_is_closed, b_is_closed : bool, optional
    True if the last corner connects to the first.

Returns
-------
float
    An integer up to rounding if both are closed. Pairs of segments that touch or are collinear
    contribute 0, so the value is finite.

Raises
------
ValueError
    If a polyline has fewer than 2 corners (3 if closed) or is not finite.
)");
  m.def(
      "linking_number",
      [](const LoopOrRows& a, const LoopOrRows& b) {
        return linking_number(to_loop(a, "a"), to_loop(b, "b"));
      },
      py::arg("a"), py::arg("b"),
      R"(Linking number of two closed polylines, by signed crossings.

Parameters
----------
a, b : Loop or (K, 3) array
    Corners of the closed polylines [m], in one frame, without repeating the first.

Returns
-------
int
    Eq. (1) of Stork, Pokorny, Kragic 2013 as an exact integer.

Raises
------
ValueError
    If a polyline has fewer than 3 corners or is not finite.
)");
  m.def(
      "virtual_linking",
      [](const LoopOrRows& loop, const Array& curve) {
        return virtual_linking(to_loop(loop, "loop"), to_points3(curve, "curve"));
      },
      py::arg("loop"), py::arg("curve"),
      R"(Virtual linking of a closed loop and an open curve, eq. (2) of Stork, Pokorny, Kragic 2013.

Parameters
----------
loop : Loop or (K, 3) array
    Closed loop, or its corners [m].
curve : (K, 3) array
    Corners of the open curve [m], in the frame of the loop.

Returns
-------
float
    VLk, signed: 0 if the loop does not run through the closed curve, Lk if the ends meet.

Raises
------
ValueError
    If the loop has fewer than 3 corners, the curve fewer than 2, or one is not finite.
)");
  m.def(
      "virtual_linking_gradient",
      [](const LoopOrRows& loop, const Array& curve) {
        return virtual_linking_gradient(to_loop(loop, "loop"), to_points3(curve, "curve"));
      },
      py::arg("loop"), py::arg("curve"),
      "Virtual linking with its gradient with respect to the curve's corners; see "
      "virtual_linking.");
}

void bind_sampling(py::module_& m) {
  m.def(
      "sample_surface",
      [](const std::vector<PlacedShape>& shapes, int count, std::uint64_t seed) -> Rows3 {
        const py::gil_scoped_release release;
        return sample_surface(shapes, count, seed).transpose();
      },
      py::arg("shapes"), py::arg("count"), py::arg("seed") = 1,
      R"(Samples points evenly on the outer surface of a union of shapes (Yuksel 2015).

Parameters
----------
shapes : list of PlacedShape
    Shapes in the frame B of a body. Points inside another shape are omitted. A mesh has no inside.
count : int
    Number of points, in [1, 10^7]. More than 100,000 are drawn by Poisson disc sampling, and are a
    little less even.
seed : int, optional
    The same seed gives the same points.

Returns
-------
(count, 3) array
    Points in B [m].

Raises
------
ValueError
    If `count` is out of range, a shape is invalid, or there is almost no outer surface.
)");
  m.def(
      "visible_points",
      [](const Array& points, const Array& viewpoint) {
        return to_array(
            visible_points(to_points3(points, "points"), to_vector3(viewpoint, "viewpoint")));
      },
      py::arg("points"), py::arg("viewpoint"),
      R"(Finds the points visible from a viewpoint (hidden point removal; Katz, Tal, Basri 2007).

Parameters
----------
points : (N, 3) array
    [m].
viewpoint : (3,) array
    In the frame of the points [m]; must not be one of them.

Returns
-------
array of int
    Indices of the visible points, ascending.

Raises
------
ValueError
    If a value is not finite or the viewpoint is one of the points.
)");
  m.def(
      "spacing", [](const Array& points) { return spacing(to_points3(points, "points")); },
      py::arg("points"),
      "Median distance between nearest neighbours among points, (N, 3) [m]. Equal points count "
      "once.\n\n0 if no two points differ. Raises ValueError if a value is not finite.");
  m.def(
      "downsample",
      [](const Array& points, double cell) {
        return to_array(downsample(to_points3(points, "points"), cell));
      },
      py::arg("points"), py::arg("cell"),
      R"(Downsamples a cloud to one point per cubic cell: the point nearest to the cell's mean.

Parameters
----------
points : (N, 3) array
    [m].
cell : float
    Side of a cell [m], in (0, 10000].

Returns
-------
array of int
    Indices of the points kept, ascending.

Raises
------
ValueError
    If `cell` is out of range or a point is not finite.
)");
}

/// Many rotations at once: in numpy, each of some dozen steps takes a microsecond.
void bind_rotations(py::module_& m) {
  m.def(
      "quaternions",
      [](const Array& X) {
        if (X.ndim() != 3 || X.shape(1) != 4 || X.shape(2) != 4)
          throw std::invalid_argument("X must have shape (N, 4, 4)");
        Rows rows(X.shape(0), 4);
        for (py::ssize_t i = 0; i < X.shape(0); ++i) {
          const Pose pose = Eigen::Map<const Pose>(X.data(i, 0, 0));
          const auto q = Eigen::Quaterniond(pose.topLeftCorner<3, 3>()).normalized();
          Eigen::RowVector4d wxyz(q.w(), q.x(), q.y(), q.z());
          Eigen::Index first = 0;
          while (first < 3 && std::abs(wxyz[first]) <= 1e-12) ++first;
          rows.row(i) = wxyz[first] < 0 ? -wxyz : wxyz;
        }
        return rows;
      },
      py::arg("X"),
      "Unit quaternions (N, 4), w x y z, of rotations or poses (N, 4, 4). The first component that "
      "is not 0 is positive.");
  m.def(
      "rotations",
      [](const Array& wxyz) {
        if (wxyz.ndim() != 2 || wxyz.shape(1) != 4)
          throw std::invalid_argument("wxyz must have shape (N, 4)");
        Poses X(static_cast<std::size_t>(wxyz.shape(0)), Eigen::Isometry3d::Identity());
        for (std::size_t i = 0; i < X.size(); ++i) {
          const double* q = wxyz.data(static_cast<py::ssize_t>(i), 0);
          Eigen::Quaterniond unit(q[0], q[1], q[2], q[3]);
          unit.coeffs().stableNormalize();
          X[i].linear() = unit.toRotationMatrix();
        }
        return from_poses(X);
      },
      py::arg("wxyz"), "Rotations (N, 4, 4) of quaternions (N, 4), w x y z, normalised first.");
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
  bind_rotations(m);
  m.def(
      "sample_grid",
      [](const Polygon& polygon, double spacing) -> Rows2 {
        return sample_grid(polygon, spacing).transpose();
      },
      py::arg("polygon"), py::arg("spacing"),
      R"(Points of a square grid inside a polygon.

Parameters
----------
polygon : Polygon
spacing : float
    Distance between grid points [m], positive.

Returns
-------
(N, 2) array
    [m]. If the grid misses the polygon: its first vertex.

Raises
------
ValueError
    If `spacing` is not positive or gives more than 10^7 points.
)");
  m.def(
      "outline",
      [](const Array& points, const std::string& what) {
        const Eigen::Matrix2Xd columns = to_points2(points, what);
        const py::gil_scoped_release release;
        return outline(columns, what);
      },
      py::arg("points"), py::arg("what") = "points",
      R"(Outer boundary of planar points: their tightest alpha shape in one simple piece.

Parameters
----------
points : (N, 2) array
    [m].
what : str, optional
    Name used in error messages.

Returns
-------
Polygon
    Simplified by less than the point spacing. Holes are filled.

Raises
------
ValueError
    If there are fewer than three points, if one is not finite, if all lie on a line, or if they
    form several pieces.
)");
}

}  // namespace graspless::bindings
