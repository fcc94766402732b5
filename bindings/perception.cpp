// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "graspless/perception/render.hpp"
#include "graspless/perception/scene.hpp"

#include "conversions.hpp"
#include "fields.hpp"

namespace graspless::bindings {
namespace {

using namespace perception;

void bind_camera(py::module_& m) {
  py::class_<Camera>(m, "Camera",
                     "A pinhole camera without distortion. Its frame C has x right, y down and z "
                     "forward.\n\nWhole numbers of pixels are centres of pixels.")
      .def(py::init([](int width, int height, double angle) {
             const Camera camera = camera_with_view(width, height, angle);
             validate(camera);
             return camera;
           }),
           py::arg("width") = 640, py::arg("height") = 480, py::arg("angle") = 1.0471975511965976,
           "width, height: size of the image [pixels], in [16, 20000]. angle: horizontal field of "
           "view [rad].\n\n"
           "Raises ValueError unless both fields of view lie in [5, 170] degrees.")
      .def_static(
          "from_matrix",
          [](const Array& K, int width, int height) {
            const Camera camera{width, height, to_matrix3(K, "K")};
            validate(camera);
            return camera;
          },
          py::arg("K"), py::arg("width"), py::arg("height"),
          "Creates a camera from its matrix K, (3, 3) [pixels].\n\nRaises ValueError if K is not "
          "that of a pinhole camera of this size.")
      .def_readonly("width", &Camera::width, "Number of columns.")
      .def_readonly("height", &Camera::height, "Number of rows.")
      .def_property_readonly("K", shown(&Camera::K), "(3, 3) camera matrix [pixels].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"width", "height", "K"});
      });
}

void bind_rendering(py::module_& m) {
  py::class_<Body>(m, "Body", "A body of a rendered scene: boxes, convex hulls and meshes.")
      .def(py::init([](std::vector<geometry::PlacedShape> shapes, const Array& X_WB) {
             return Body{std::move(shapes), to_pose(X_WB, "X_WB")};
           }),
           py::arg("shapes"), pose_arg("X_WB"),
           "shapes: PlacedShapes in the body's frame B. X_WB: (4, 4) pose in the world.")
      .def_readonly("shapes", &Body::shapes, "PlacedShapes in the body's frame B.")
      .def_property_readonly("X_WB", shown(&Body::X_WB), "(4, 4) pose in the world.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"shapes", "X_WB"});
      });
  py::class_<Rendering>(m, "Rendering", "First hits of the rays through the centres of all pixels.")
      .def_property_readonly(
          "depth", [](const Rendering& self) -> DepthImage { return self.depth; },
          "(H, W) depths along the optical axis [m]; 0 if a ray meets nothing.")
      .def_property_readonly(
          "label", [](const Rendering& self) -> LabelImage { return self.label; },
          "(H, W) indices of the bodies; -1 if a ray meets nothing.")
      .def_property_readonly(
          "cosine", [](const Rendering& self) -> DepthImage { return self.cosine; },
          "(H, W) cosines of the angles between ray and surface normal, in [0, 1].")
      .def("__repr__", [](const Rendering& self) {
        return "<Rendering of " + std::to_string(self.depth.cols()) + " x " +
               std::to_string(self.depth.rows()) + " pixels>";
      });
  m.def(
      "cast_rays",
      [](const std::vector<Body>& bodies, const Array& X_WC, const Camera& camera) {
        const Eigen::Isometry3d pose = to_pose(X_WC, "X_WC");
        const py::gil_scoped_release release;
        return render(bodies, pose, camera);
      },
      py::arg("bodies"), py::arg("X_WC"), py::arg_v("camera", Camera{}, "Camera()"),
      R"(Casts one ray through the centre of each pixel (CGAL's AABB trees).

Parameters
----------
bodies : list of Body
X_WC : (4, 4) array
    Pose of the camera's optical frame C in the world.
camera : Camera, optional
    By default 640 x 480 pixels with a horizontal field of view of 60 degrees.

Returns
-------
Rendering
    Exact depths, without noise.

Raises
------
ValueError
    If a shape is a sphere or a capsule, or a pose or shape is not valid.
)");
}

DepthImage to_image(const FloatImage& depth) {
  if (depth.ndim() != 2) {
    throw std::invalid_argument("depth has " + std::to_string(depth.ndim()) +
                                " dimensions; it must have shape (H, W)");
  }
  return Eigen::Map<const DepthImage>(depth.data(), depth.shape(0), depth.shape(1));
}

geometry::Polygon to_ring(const Array& rows, const std::string& name) {
  return geometry::Polygon(to_points2(rows, name), name);
}

Rows2 from_ring(const geometry::Polygon& polygon) { return polygon.vertices().transpose(); }

void bind_view(py::module_& m) {
  py::class_<View> cls(m, "View", "A depth image and the camera that took it.");
  bind_pickling(cls, {"depth", "K", "X_WC"});
  cls.def(py::init([](const FloatImage& depth, const Array& K, const Array& X_WC) {
            return View{to_image(depth), to_matrix3(K, "K"), to_pose(X_WC, "X_WC")};
          }),
          py::arg("depth"), py::arg("K"), py::arg("X_WC"),
          "depth: (H, W) depths along the optical axis [m]; 0 or not finite: none. K: (3, 3) "
          "camera matrix [pixels]. X_WC: (4, 4) pose of the optical frame in the world, z "
          "forward.")
      .def_property_readonly("depth", shown(&View::depth), "(H, W) depths [m], float32.")
      .def_property_readonly("K", shown(&View::K), "(3, 3) camera matrix [pixels].")
      .def_property_readonly("X_WC", shown(&View::X_WC),
                             "(4, 4) pose of the optical frame in the world.")
      .def("__repr__", [](const View& self) {
        return "<View of " + std::to_string(self.depth.cols()) + " x " +
               std::to_string(self.depth.rows()) + " pixels>";
      });
}

void bind_support(py::module_& m) {
  py::class_<Support> cls(
      m, "Support",
      "A level or tilted plane that objects lie on, with a label for each edge.\n\n"
      "Its frame S has z out of the plane.");
  bind_pickling(cls, {"name", "polygon", "edges", "X_WS", "height_error", "angle_error", "noise",
                      "least_thickness"});
  cls.def(py::init([](const std::string& name, const Array& polygon, std::vector<EdgeLabel> edges,
                      const Array& X_WS, double height_error, double angle_error, double noise,
                      double least_thickness) {
            Support support{name,
                            to_ring(polygon, "polygon"),
                            std::move(edges),
                            to_pose(X_WS, "X_WS"),
                            height_error,
                            angle_error,
                            noise,
                            least_thickness};
            if (support.edges.size() != static_cast<std::size_t>(support.polygon.size())) {
              throw std::invalid_argument("edges has " + std::to_string(support.edges.size()) +
                                          " labels; it must have one per edge of the polygon, " +
                                          std::to_string(support.polygon.size()));
            }
            // A clockwise ring has been reversed, and so are its edges: the last one stays last.
            const Eigen::Vector2d first(polygon.at(0, 0), polygon.at(0, 1));
            if (support.polygon.vertices().col(0) != first) {
              std::reverse(support.edges.begin(), support.edges.end() - 1);
            }
            return support;
          }),
          py::kw_only(), py::arg("name"), py::arg("polygon"), py::arg("edges"), py::arg("X_WS"),
          py::arg("height_error") = 0.0, py::arg("angle_error") = 0.0, py::arg("noise") = 0.0,
          py::arg("least_thickness") = 0.0, "Any field by keyword.")
      .def_readonly("name", &Support::name, "Name: support_0 is the largest.")
      .def_property_readonly(
          "polygon", [](const Support& self) -> const Rows2 { return from_ring(self.polygon); },
          "(N, 2) corners in S [m], counter-clockwise.")
      .def_property_readonly("edges", as_tuple(&Support::edges),
                             "Label of each edge: edge i runs from corner i to the next.")
      .def_property_readonly("X_WS", shown(&Support::X_WS), "(4, 4) pose in the world.")
      .def_readonly("height_error", &Support::height_error,
                    "Standard error of the plane's height at its centre [m].")
      .def_readonly("angle_error", &Support::angle_error, "Standard error of its tilt [rad].")
      .def_readonly("noise", &Support::noise,
                    "Standard deviation of the depth that was measured on it [m].")
      .def_readonly("least_thickness", &Support::least_thickness,
                    "Least thickness of an object that would have been seen on it [m].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"name", "edges", "least_thickness"});
      });
}

void bind_seen_object(py::module_& m) {
  py::class_<Object> cls(m, "Object",
                         "A thing that stands on a support or lies on it.\n\nIts frame O has its "
                         "origin in the support's plane, below the centroid of the outline, z out "
                         "of the plane, and x along its longest extent.");
  bind_pickling(cls,
                {"name", "support", "outline", "X_WO", "thickness", "thickness_error", "is_flat",
                 "position_error", "yaw_error", "points", "rays", "touches_border", "warnings"});
  cls.def(py::init([](const std::string& name, const std::string& support, const Array& outline,
                      const Array& X_WO, double thickness, double thickness_error, bool is_flat,
                      double position_error, double yaw_error, const Array& points,
                      std::vector<geometry::RayImage> rays, bool touches_border,
                      std::vector<std::string> warnings) {
            for (std::size_t i = 0; i < rays.size(); ++i)
              validate(rays[i], "rays[" + std::to_string(i) + "]");
            return Object{name,
                          support,
                          to_ring(outline, "outline"),
                          to_pose(X_WO, "X_WO"),
                          thickness,
                          thickness_error,
                          is_flat,
                          position_error,
                          yaw_error,
                          to_points3(points, "points"),
                          std::move(rays),
                          touches_border,
                          std::move(warnings)};
          }),
          py::kw_only(), py::arg("name"), py::arg("support"), py::arg("outline"), py::arg("X_WO"),
          py::arg("thickness"), py::arg("thickness_error"), py::arg("is_flat"),
          py::arg("position_error"), py::arg("yaw_error"), py::arg("points"),
          py::arg("rays") = std::vector<geometry::RayImage>{}, py::arg("touches_border") = false,
          py::arg("warnings") = std::vector<std::string>{}, "Any field by keyword.")
      .def_readonly("name", &Object::name, "Name: object_0 is nearest to the first camera.")
      .def_readonly("support", &Object::support, "Name of the support.")
      .def_property_readonly(
          "outline", [](const Object& self) -> const Rows2 { return from_ring(self.outline); },
          "(N, 2) corners of the projection of what was seen onto the support, in O [m].")
      .def_property_readonly("X_WO", shown(&Object::X_WO), "(4, 4) pose in the world.")
      .def_readonly("thickness", &Object::thickness, "Height of the top above the support [m].")
      .def_readonly("thickness_error", &Object::thickness_error,
                    "Standard error of the thickness [m].")
      .def_readonly("is_flat", &Object::is_flat,
                    "True if all that was seen of the top is equally high.")
      .def_readonly("position_error", &Object::position_error,
                    "Standard error of the outline's position along the support [m].")
      .def_readonly("yaw_error", &Object::yaw_error, "Standard error of the direction of x [rad].")
      .def_property_readonly("points", shown(&Object::points),
                             "(N, 3) points of all pixels of the object, in O [m].")
      .def_property_readonly(
          "rays", as_tuple(&Object::rays),
          "Rays of each camera that saw it, around it, in O. They tell holes from rims and from\n"
          "edges of what was seen.")
      .def_readonly("touches_border", &Object::touches_border,
                    "True if the image cuts the object off.")
      .def_property_readonly("warnings", as_tuple(&Object::warnings),
                             "Reasons to doubt the outline, one sentence each.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"name", "support", "thickness", "thickness_error", "is_flat"});
      });

  py::class_<Unseen> unseen(m, "Unseen", "Space over a support that no ray reached.");
  bind_pickling(unseen, {"behind", "vertices"});
  unseen
      .def(py::init([](const std::string& behind, const Array& vertices) {
             return Unseen{behind, {to_points3(vertices, "vertices")}};
           }),
           py::kw_only(), py::arg("behind"), py::arg("vertices"), "Any field by keyword.")
      .def_readonly("behind", &Unseen::behind,
                    "Name of the object that hides it; empty: a patch without depth.")
      .def_property_readonly(
          "vertices",
          [](const Unseen& self) -> const Rows3 { return self.shape.vertices.transpose(); },
          "(N, 3) corners of a convex hull in the world [m].")
      .def("__repr__", [](const py::object& self) { return represent(self, {"behind"}); });
}

void bind_scene_class(py::module_& m) {
  py::class_<Scene> cls(m, "Scene",
                        "Supports, objects and unseen space in depth images. False if nothing "
                        "trustworthy was found.");
  cls.def(py::init([](Status status, const std::string& reason, std::vector<Support> supports,
                      std::vector<Object> objects, std::vector<Unseen> unseen,
                      std::vector<std::string> warnings, std::optional<double> stamp) {
            return Scene{status,
                         reason,
                         std::move(supports),
                         std::move(objects),
                         std::move(unseen),
                         std::move(warnings),
                         stamp};
          }),
          py::kw_only(), py::arg("status"), py::arg("reason"), py::arg("supports"),
          py::arg("objects"), py::arg("unseen"), py::arg("warnings"),
          py::arg("stamp") = std::nullopt, "Any field by keyword.");
  bind_pickling(cls, {"status", "reason", "supports", "objects", "unseen", "warnings", "stamp"});
  cls.def_readonly("status", &Scene::status, "Outcome.")
      .def_readonly("reason", &Scene::reason,
                    "Result, or the reason why there is none and what to do; one sentence or two.")
      .def_property_readonly("supports", as_tuple(&Scene::supports),
                             "Supports, from the largest to the smallest.")
      .def_property_readonly("objects", as_tuple(&Scene::objects),
                             "Objects, the nearest to the first camera first.")
      .def_property_readonly("unseen", as_tuple(&Scene::unseen), "Space that no ray reached.")
      .def_property_readonly("warnings", as_tuple(&Scene::warnings),
                             "Doubts about what was found, one sentence each.")
      .def_readwrite("stamp", &Scene::stamp,
                     "Time at which the images were taken [s since 1970]; None if unknown.")
      .def(
          "__bool__", [](const Scene& self) { return static_cast<bool>(self); },
          "True if at least one support was found.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"status", "reason", "supports", "objects"});
      });
  m.def(
      "perceive",
      [](const std::vector<View>& views, const Options& options) {
        const Options now = options;
        const py::gil_scoped_release release;
        return perceive(views, now);
      },
      py::arg("views"), py::arg_v("options", Options{}, "Options()"),
      "Finds supports and objects in depth images of a still scene, a list of Views. Finding "
      "nothing is a status.\n\nRaises ValueError if a camera, pose or option is not valid.");
}

}  // namespace

void bind_perception(py::module_ m) {
  bind_camera(m);
  bind_rendering(m);
  bind_options_struct<Options>(m, "Options", "Options of perceive().");
  bind_choices<Status>(m, "Status", "Outcome of perceive().");
  bind_choices<EdgeLabel>(m, "EdgeLabel", "Reason why a support ends at an edge.");
  bind_view(m);
  bind_support(m);
  bind_seen_object(m);
  bind_scene_class(m);
}

}  // namespace graspless::bindings
