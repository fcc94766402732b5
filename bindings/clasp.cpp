// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/clasp.hpp"

#include <filesystem>

#include <pybind11/stl/filesystem.h>

#include "graspless/clasp/sample_objects.hpp"

#include "conversions.hpp"
#include "fields.hpp"
#include "planning.hpp"
#include "segments.hpp"

namespace graspless::bindings {
namespace {

using namespace clasp;

Eigen::Matrix3Xd columns(const std::vector<Eigen::Vector3d>& points) {
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    result.col(static_cast<Eigen::Index>(i)) = points[i];
  }
  return result;
}

std::vector<Eigen::Vector3d> to_marks(const std::optional<Array>& rows) {
  if (!rows || rows->size() == 0) return {};
  const Eigen::Matrix3Xd points = to_points3(*rows, "marks");
  std::vector<Eigen::Vector3d> marks;
  for (Eigen::Index i = 0; i < points.cols(); ++i) marks.emplace_back(points.col(i));
  return marks;
}

/// [N, curves], checked against the rows of positions.
Eigen::MatrixXd to_linking(const Array& values, std::size_t rows, const std::string& segment) {
  if (values.ndim() != 2 || static_cast<std::size_t>(values.shape(0)) != rows) {
    throw std::invalid_argument("segment '" + segment + "' has " + std::to_string(rows) +
                                " positions; virtual_linking must have shape (" +
                                std::to_string(rows) + ", curves)");
  }
  return Eigen::Map<const Rows>(values.data(), values.shape(0), values.shape(1)).transpose();
}

void bind_hand(py::module_& m) {
  py::class_<CurveNode> node(m, "CurveNode", "A corner of a finger curve, fixed to a link.");
  bind_fields(node, "Any field by keyword; the others keep their defaults.",
              Field{"link", &CurveNode::link, "Name of a link of the robot."},
              Field{"p_L", &CurveNode::p_L, "(3,) position in the link's frame [m]."});
  py::class_<Finger> finger(
      m, "Finger",
      "A finger: the corners of its part of the finger curve, from the palm to the tip.");
  bind_fields(finger, "Any field by keyword; the others keep their defaults.",
              Field{"name", &Finger::name, "Name used in error messages and pictures."},
              Field{"nodes", &Finger::nodes, "CurveNodes from the palm to the tip."});
  py::class_<Hand> hand(
      m, "Hand",
      "Description of a hand for the planner (Stork, Pokorny, Kragic 2013, Section IV-B).\n\n"
      "Names of links, groups and states refer to the robot. Every finger opposes the thumb:\n"
      "finger curve i runs from the tip of finger i to the palm and along the thumb to its tip.");
  bind_fields(
      hand, "Any field by keyword; the others keep their defaults.",
      Field{"arm", &Hand::arm, "Group of the joints that carry the hand, base to wrist."},
      Field{"hand", &Hand::hand, "Group of the joints that close the hand."},
      Field{"frame", &Hand::frame, "Link of the palm, H."},
      Field{"forward_H", &Hand::forward_H, "(3,) unit vector towards the handle, in H (v_fwd)."},
      Field{"sideways_H", &Hand::sideways_H, "(3,) unit vector along the handle, in H (v_swd)."},
      Field{"fingers", &Hand::fingers, "Fingers that oppose the thumb."},
      Field{"thumb", &Hand::thumb, "Finger that the others oppose."},
      Field{"open", &Hand::open,
            "State of the hand's joints at the start of the search: pre-shape."},
      Field{
          "pre_shapes", &Hand::pre_shapes,
          "States of further pre-shapes. The search tries them, in turn with the first, if it has "
          "clasped nothing in 20 cycles a loop."},
      Field{"closed", &Hand::closed, "State towards which the joints close."});
  m.def("hand_from_yaml", &hand_from_yaml, py::arg("text"), py::arg("what") = "hand",
        R"(Reads a hand from YAML. docs/task-files.md has the grammar.

Parameters
----------
text : str
    YAML document.
what : str, optional
    Name used in error messages.

Returns
-------
Hand

Raises
------
ValueError
    Names the line, the field, the value and the choices.
)");
  m.def(
      "hand_from_yaml_file",
      [](const std::filesystem::path& path) { return hand_from_yaml_file(path.string()); },
      py::arg("path"),
      "Reads a hand from a YAML file; see hand_from_yaml. The folder urdf/ has examples.");
  m.def("with_palm_corners", &with_palm_corners, py::arg("hand"), py::arg("robot"),
        R"(Adds corners in the palm to fingers whose joints move their first corners against it.

Fingers of a parallel gripper need them. Other hands are returned as they are.

Parameters
----------
hand : Hand
robot : robot.Robot

Returns
-------
Hand

Raises
------
ValueError
    If a link, group or state is unknown.
)");
}

void bind_object(py::module_& m) {
  using geometry::LoopOptions;
  py::class_<Object>(m, "Object",
                     "An object known from a point cloud: its loops (Stork, Pokorny, Kragic 2013,\n"
                     "Section IV-A), and its surface at the cloud's own resolution as collision "
                     "model.")
      .def_static(
          "from_cloud",
          [](const std::string& name, const Array& p_OP, const LoopOptions& options,
             const std::vector<geometry::RayImage>& rays) {
            const Eigen::Matrix3Xd points = to_points3(p_OP, "p_OP");
            const LoopOptions now = options;
            const py::gil_scoped_release release;
            return Object::from_cloud(name, points, now, rays);
          },
          py::arg("name"), py::arg("p_OP"), py::arg_v("options", LoopOptions{}, "LoopOptions()"),
          py::arg("rays") = std::vector<geometry::RayImage>{},
          R"(Finds the loops of a cloud and builds its collision model.

Parameters
----------
name : str
    Name used in error messages and pictures.
p_OP : (N, 3) array
    Points on the surface, in O [m].
options : geometry.LoopOptions, optional
rays : list of geometry.RayImage, optional
    Rays of the cameras that saw the points, in O. See geometry.shortest_loops.

Returns
-------
Object
    An object without a reliable hole is valid; plan() reports it as a status.

Raises
------
ValueError
    As geometry.shortest_loops.
)")
      .def_property_readonly("name", &Object::name, "Name used in error messages and pictures.")
      .def_property_readonly("points", shown(&Object::points), "(N, 3) input cloud, in O [m].")
      .def_property_readonly("loops", shown(&Object::loops), "geometry.Loops in O; a copy.")
      .def_property_readonly("loop_options", shown(&Object::loop_options),
                             "geometry.LoopOptions used to find the loops; a copy.")
      .def_property_readonly("rays", shown(&Object::rays),
                             "geometry.RayImages that decided which loops are holes, in O; a copy.")
      .def_property_readonly(
          "surface", shown(&Object::surface),
          "Collision surface, in O [m]: the triangles of loops.surface, and narrow ones for edges "
          "and points "
          "without a triangle.")
      .def_property_readonly("spacing", &Object::spacing,
                             "Median distance of neighbouring points of the surface [m].")
      .def("__repr__", [](const Object& self) {
        return "<Object '" + self.name() + "' of " + std::to_string(self.points().cols()) +
               " points and " + std::to_string(self.loops().found.size()) + " loops>";
      });
  m.def("sample_object_names", &sample_object_names,
        "Names of the sample objects with holes: purse, bag, travel_bag, lawn_mower, chair.");
  m.def("sample_object", &sample_object, py::arg("name"), py::arg("scale") = 1.0,
        R"(Shapes of a sample object, standing on the floor z = 0 of O.

Parameters
----------
name : str
    One of sample_object_names().
scale : float, optional
    Factor on the real size, in (0, 1000].

Returns
-------
list of geometry.PlacedShape
    In O [m].

Raises
------
ValueError
    Lists the names, or states the range of `scale`.
)");
}

void bind_problem(py::module_& m) {
  py::class_<Problem>(
      m, "Problem",
      "A clasp planning problem: put the hand through a hole of the object and close it.")
      .def(py::init([](const robot::Robot& robot, const Hand& hand, const Object& object,
                       const Array& X_WO, const Array& q_start,
                       const std::vector<Obstacle>& obstacles, const std::vector<int>& loops,
                       const std::optional<Array>& marks, const std::optional<Array>& pull_W) {
             return Problem{robot,
                            hand,
                            object,
                            to_pose(X_WO, "X_WO"),
                            obstacles,
                            to_configuration(robot, q_start, "q_start"),
                            loops,
                            to_marks(marks),
                            Python<decltype(Problem::pull_W)>::from(pull_W, "pull_W")};
           }),
           py::arg("robot"), py::arg("hand"), py::arg("object"), py::arg("X_WO"),
           py::arg("q_start"), py::arg("obstacles") = std::vector<Obstacle>{},
           py::arg("loops") = std::vector<int>{}, py::arg("marks") = py::none(),
           py::arg("pull_W") = py::none(),
           R"(Parameters
----------
robot : robot.Robot
hand : Hand
object : Object
X_WO : (4, 4) array
    Pose of the object in W.
q_start : (dof,) array
    Start configuration of all joints [rad or m].
obstacles : list of Obstacle, optional
loops : list of int, optional
    Indices in object.loops.found of the loops that may be clasped; empty: all.
marks : (N, 3) array, optional
    Points in O [m]. The hand clasps at the loop points nearest to them; none: anywhere.
pull_W : (3,) array, optional
    Direction in W in which the clasped object will be pulled. Unsuitable targets are excluded.

Raises
------
ValueError
    If a shape is wrong. plan() validates the values.
)")
      .def_property_readonly("robot", shown(&Problem::robot), "The robot.")
      .def_property_readonly("hand", shown(&Problem::hand), "A copy of the hand.")
      .def_property_readonly("object", shown(&Problem::object), "The object to clasp.")
      .def_property_readonly("X_WO", shown(&Problem::X_WO), "(4, 4) pose of the object in W.")
      .def_property_readonly("q_start", shown(&Problem::q_start),
                             "(dof,) start configuration [rad or m].")
      .def_readonly("obstacles", &Problem::obstacles, "Obstacles in W.")
      .def_readonly("loops", &Problem::loops,
                    "Indices of the loops that may be clasped; empty: all.")
      .def_property_readonly(
          "marks",
          [](const Problem& self) -> const Rows3 { return columns(self.marks).transpose(); },
          "(N, 3) points in O near which to clasp [m]; none: anywhere.")
      .def_property_readonly("pull_W", shown(&Problem::pull_W),
                             "(3,) direction of the later pull in W, or None.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"robot", "object", "obstacles", "loops", "pull_W"});
      });
}

void bind_stability(py::module_& m) {
  bind_options_struct<StabilityOptions>(
      m, "StabilityOptions",
      "Options of the stability test (Stork, Pokorny, Kragic 2013, Section V-A).\n\n"
      "The hand does not move. The object makes random moves, each until it hits the hand.");
  py::class_<Stability> found(m, "Stability", "Result of the stability test.");
  bind_fields(
      found, "Any field by keyword; the others keep their defaults.",
      Field{"secure", &Stability::secure,
            "True if the loop escaped in no sequence and, for a hand of two fingers, if its motors "
            "withstand the load."},
      Field{"escapes", &Stability::escapes, "Number of sequences in which the loop escaped."},
      Field{"withstands", &Stability::withstands,
            "Largest force that may act suddenly in any direction, with moments in proportion as "
            "in the options, before a joint of the hand gives way at its effort limit [N]; 1e6 if "
            "none does, 0 if that was not tested or the loop escaped."},
      Field{"opens_first", &Stability::opens_first,
            "The joint that gives way first; empty if none does."},
      Field{"margin", &Stability::margin, "1: the object cannot move; 0 or less: it escaped."},
      Field{"checks", &Stability::checks, "Number of poses checked."});
}

void bind_certificate(py::module_& m) {
  bind_options_struct<CertificateOptions>(m, "CertificateOptions", "Options of certificate().");
  py::class_<Certificate> found(
      m, "Certificate",
      "Bounds on the opening through which a loop can leave a hand that does not move.\n\n"
      "The opening is the largest clearance that the object can keep from the hand on its way out\n"
      "[m]. If it is negative, the object must enter the hand as deep as that.");
  bind_fields(
      found, "Any field by keyword; the others keep their defaults.",
      Field{"caged", &Certificate::caged,
            "True if upper is below 0: no motion takes the loop out of the hand."},
      Field{"lower", &Certificate::lower, "Clearance on a way out that was found [m]."},
      Field{"upper", &Certificate::upper,
            "Proven bound [m]; 1e6 if no ring of the hand is linked with the loop."},
      Field{"thickness", &Certificate::thickness,
            "Diameter of a ball that fits into the object all along the loop [m]; 0: nothing is "
            "known to be inside the object there."},
      Field{"gap", &Certificate::gap,
            "Widest gap in the ring of the hand [m]; negative where its balls overlap."},
      Field{"between", &Certificate::between, "Links on both sides of the gap."},
      Field{"moves", &Certificate::moves, "Number of moves that were tried."});
  m.def(
      "certificate",
      [](const Problem& problem, const Array& q, int loop, const CertificateOptions& options) {
        const Eigen::VectorXd given = to_configuration(problem.robot, q, "q");
        const CertificateOptions now = options;
        const py::gil_scoped_release release;
        return certificate(problem, given, loop, now);
      },
      py::arg("problem"), py::arg("q"), py::arg("loop"),
      py::arg_v("options", CertificateOptions{}, "CertificateOptions()"),
      R"(Bounds the opening through which a loop can leave the hand, which does not move.

The upper bound is proven: a ring of the hand is linked with the loop, and the object is thicker
than the widest gap of the ring by twice the amount below 0. The lower bound is the clearance on
a way out that random moves found.

Parameters
----------
problem : Problem
q : (dof,) array
    Configuration of all joints [rad or m].
loop : int
    Index in problem.object.loops.found.
options : CertificateOptions, optional

Returns
-------
Certificate

Raises
------
ValueError
    If the problem, the loop, the configuration or an option is invalid.
)");
}

void bind_pinch(py::module_& m) {
  py::class_<Pinch> found(m, "Pinch", "Result of the test of a pinch.");
  bind_fields(found, "Any field by keyword; the others keep their defaults.",
              Field{"holds", &Pinch::holds,
                    "True if both fingers touch, and their forces resist every wrench, and the "
                    "whole load."},
              Field{"strength", &Pinch::strength,
                    "Largest force in any direction that is resisted for each newton of a finger."},
              Field{"press", &Pinch::press,
                    "Normal force of each finger at half the effort limits of the joints [N]."},
              Field{"load", &Pinch::load,
                    "Largest multiple of the load, acting suddenly, that friction resists at that "
                    "force."},
              Field{"gap", &Pinch::gap,
                    "Gap between the object and the finger that is farther from it [m]."});
  m.def(
      "test_pinch",
      [](const Problem& problem, const Array& q, double friction, const StabilityOptions& options) {
        const Eigen::VectorXd given = to_configuration(problem.robot, q, "q");
        const StabilityOptions now = options;
        const py::gil_scoped_release release;
        return test_pinch(problem, given, friction, now);
      },
      py::arg("problem"), py::arg("q"), py::arg("friction") = Options{}.friction,
      py::arg_v("options", StabilityOptions{}, "StabilityOptions()"),
      R"(Tests if friction holds the object between the two fingers of a hand.

Each finger presses with 1 N on two points of its contact with the object's surface.

Parameters
----------
problem : Problem
    Its hand has one finger besides the thumb.
q : (dof,) array
    Configuration of all joints [rad or m].
friction : float, optional
    Coefficient of friction, in [0, 10].
options : StabilityOptions, optional
    Force and torque of the load.

Returns
-------
Pinch

Raises
------
ValueError
    If the problem, the hand, the configuration, the friction or the load is invalid, or a
    joint of the hand has no effort limit.
)");
}

void bind_segment(py::module_& m) {
  bind_segment_class<Segment>(m, "reach or close.")
      .def(py::init(
               [](const std::string& name, const Array& positions, const Array& virtual_linking) {
                 Configurations rows = to_configurations(positions, "positions");
                 const Eigen::MatrixXd linking = to_linking(virtual_linking, rows.size(), name);
                 return Segment{name, std::move(rows), linking};
               }),
           py::arg("name"), py::arg("positions"), py::arg("virtual_linking"),
           "positions: (N, dof) [rad or m]. virtual_linking: (N, curves).")
      .def_property_readonly(
          "virtual_linking", shown(&Segment::virtual_linking),
          "(N, curves) |VLk| of every finger curve with the loop clasped, at each row.");
}

void bind_tree(py::module_& m) {
  py::class_<Tree>(m, "Tree", "The search tree that contains the clasp, for visualisation.")
      .def(py::init([](const std::optional<Array>& p_W, const std::vector<int>& parents,
                       const std::vector<int>& path) {
             Tree tree;
             if (p_W && p_W->size() > 0) tree.p_W = to_points3(*p_W, "p_W");
             tree.parents = parents;
             tree.path = path;
             return tree;
           }),
           py::arg("p_W") = py::none(), py::arg("parents") = std::vector<int>{},
           py::arg("path") = std::vector<int>{},
           "p_W: (N, 3) [m]. parents: (N,) node indices. path: node indices from the root to the "
           "clasp.")
      .def_property_readonly("p_W", shown(&Tree::p_W),
                             "(N, 3) centre of the finger curves at every node, in W [m].")
      .def_readonly("parents", &Tree::parents,
                    "Index of every node's parent; the root is its own parent.")
      .def_readonly("path", &Tree::path, "Indices of the nodes from the root to the clasp.")
      .def(
          "__len__", [](const Tree& self) { return self.p_W.cols(); }, "Number of nodes.")
      .def("__repr__", [](const Tree& self) {
        return "<Tree of " + std::to_string(self.p_W.cols()) + " nodes>";
      });
}

void bind_plan(py::module_& m) {
  bind_plan_class<Plan>(
      m, {"status", "reason", "segments", "loop", "stability"},
      Field{"joint_names", &Plan::joint_names, "The robot's joints, in the order of positions."},
      Field{"segments", &Plan::segments, "Segments of the motion, in order."},
      Field{"loop", &Plan::loop,
            "Index of the clasped loop in object.loops.found; -1 without a plan."},
      Field{"fingers", &Plan::fingers,
            "Names of the fingers that clasp the loop together with the thumb."},
      Field{"pre_shape", &Plan::pre_shape,
            "Pre-shape with which the search began, a state of the hand's joints; empty in old "
            "plans: hand.open. The hand may be partly closed when it arrives."},
      Field{"target", &Plan::target, "Clasped geometry.ClaspTarget, in O; a copy."},
      Field{"min_linking", &Plan::min_linking,
            "Threshold of virtual linking that the plan fulfils."},
      Field{"stability", &Plan::stability, "Result of the stability test at the last row; a copy."},
      Field{"pinch", &Plan::pinch,
            "Result of the test of a pinch at the last row, if only friction holds; or None."},
      Field{"certificate", &Plan::certificate,
            "Certificate of the last row, or None if no time was left; a copy."},
      Field{"tree", &Plan::tree, "Search tree that contains the clasp; a copy."},
      Field{"warnings", &Plan::warnings, "Warnings about the plan."});
}

void bind_hang(py::module_& m) {
  py::class_<Hang> found(m, "Hang",
                         "Pose in which an object hangs in a closed hand that carries it.");
  found.def_readonly("holds", &Hang::holds, "True if the hand holds it up.")
      .def_property_readonly("X_WO", shown(&Hang::X_WO),
                             "(4, 4) pose in the world where it comes to rest.")
      .def_readonly("drop", &Hang::drop,
                    "Distance by which the mean of its surface is lower there [m].")
      .def_readonly("swing", &Hang::swing, "Angle by which it is turned there [rad].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"holds", "drop", "swing"});
      });
  m.def(
      "find_hang",
      [](const Problem& problem, const Array& q, int loop) {
        const Eigen::VectorXd given = to_configuration(problem.robot, q, "q");
        const py::gil_scoped_release release;
        return find_hang(problem, given, loop);
      },
      py::arg("problem"), py::arg("q"), py::arg("loop"),
      R"(Lets the object sink by its own weight, without friction, until the closed hand holds it up.

The weight acts on the mean of the points of the object's surface. Nothing else touches the object, and no joint
gives way.

Parameters
----------
problem : Problem
q : (dof,) array
    Configuration of all joints [rad or m].
loop : int
    Index in problem.object.loops.found.

Returns
-------
Hang

Raises
------
ValueError
    If the problem, the loop or the configuration is invalid.
)");
}

void bind_planner(py::module_& m) {
  m.def(
      "validate", [](const Hand& hand, const robot::Robot& robot) { clasp::validate(hand, robot); },
      py::arg("hand"), py::arg("robot"),
      "Raises ValueError if the hand does not fit the robot; names the field, the value and the "
      "choices.");
  bind_front_door<Problem, Options, Plan>(
      m,
      "Plans a motion of arm and hand that ends in a clasp: reach, then close until contact\n"
      "(Stork, Pokorny, Kragic 2013, Section IV). Failure to find a plan is a status.",
      "Replays a plan without the code of the search, and returns its faults: joint limits,\n"
      "collisions, linking by the double integral, closing until contact, and the stability test.");
  bind_certify<Problem, Options, Plan>(m, "nothing touches.");
  m.def(
      "test_stability",
      [](const Problem& problem, const Array& q, int loop, const StabilityOptions& options) {
        const Eigen::VectorXd given = to_configuration(problem.robot, q, "q");
        const StabilityOptions now = options;
        const py::gil_scoped_release release;
        return test_stability(problem, given, loop, now);
      },
      py::arg("problem"), py::arg("q"), py::arg("loop"),
      py::arg_v("options", StabilityOptions{}, "StabilityOptions()"),
      R"(Tests if a loop stays in the hand: random moves try to separate object and hand.

Stork, Pokorny, Kragic 2013, Section V-A.

Parameters
----------
problem : Problem
q : (dof,) array
    Configuration of all joints [rad or m].
loop : int
    Index in problem.object.loops.found.
options : StabilityOptions, optional

Returns
-------
Stability

Raises
------
ValueError
    If the problem, the loop, the configuration or an option is invalid.
)");
}

}  // namespace

void bind_clasp(py::module_ m) {
  bind_hand(m);
  bind_object(m);
  bind_problem(m);
  bind_stability(m);
  bind_pinch(m);
  bind_hang(m);
  bind_certificate(m);
  bind_options_struct<Options>(m, "Options", "Options of the search.");
  bind_segment(m);
  bind_tree(m);
  bind_statistics_struct<Statistics>(m);
  bind_choices<Status>(m, "Status", "Outcome of a query.");
  bind_plan(m);
  bind_planner(m);
}

}  // namespace graspless::bindings
