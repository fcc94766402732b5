// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/clasp.hpp"

#include "graspless/clasp/sample_objects.hpp"

#include "conversions.hpp"
#include "fields.hpp"
#include "planning.hpp"

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
  py::class_<CurveNode> node(m, "CurveNode", "A corner of a finger curve, fixed in a link.");
  bind_fields(node, "Any field by keyword; the others keep their defaults.",
              Field{"link", &CurveNode::link, "Of the robot."},
              Field{"p_L", &CurveNode::p_L, "(3,) in the link's frame [m]."});
  py::class_<Finger> finger(
      m, "Finger", "A finger: the corners of its half of the curve, from the palm to the tip.");
  bind_fields(finger, "Any field by keyword; the others keep their defaults.",
              Field{"name", &Finger::name, "What errors and pictures call it."},
              Field{"nodes", &Finger::nodes, "CurveNodes from the palm to the tip."});
  py::class_<Hand> hand(
      m, "Hand",
      "What the planner must know of a hand. Links, groups and states are the robot's.\n\n"
      "Every finger opposes the thumb: finger curve i runs from the tip of finger i down to the "
      "palm and up\nthe thumb to its tip.");
  bind_fields(
      hand, "Any field by keyword; the others keep their defaults.",
      Field{"arm", &Hand::arm, "Group of joints that carry the hand, base to wrist."},
      Field{"hand", &Hand::hand, "Group of the hand's joints that close."},
      Field{"frame", &Hand::frame, "Link H of the palm."},
      Field{"forward_H", &Hand::forward_H, "(3,) unit, towards what is clasped, in H."},
      Field{"sideways_H", &Hand::sideways_H, "(3,) unit, along what is clasped, in H."},
      Field{"fingers", &Hand::fingers, "Those that oppose the thumb."},
      Field{"thumb", &Hand::thumb, "The finger that the others oppose."},
      Field{"open", &Hand::open, "State of the hand's joints with which the search begins."},
      Field{"closed", &Hand::closed, "State towards which every joint closes."});
  m.def("hand_from_yaml", &hand_from_yaml, py::arg("text"), py::arg("what") = "hand",
        "Reads a hand from YAML (the grammar: docs/task-files.md). what: its name in errors.\n\n"
        "Raises ValueError that names the line, the field, the value and the choices.");
  m.def("hand_from_yaml_file", &hand_from_yaml_file, py::arg("path"),
        "As hand_from_yaml, from a file; those beside the URDFs of graspless are examples.");
}

void bind_object(py::module_& m) {
  using geometry::LoopOptions;
  py::class_<Object>(m, "Object",
                     "An object known by a cloud of points: its loops, and K_d as what must not be "
                     "touched.")
      .def_static(
          "from_cloud",
          [](const std::string& name, const Array& p_OP, const LoopOptions& options) {
            const Eigen::Matrix3Xd points = to_points3(p_OP, "p_OP");
            const py::gil_scoped_release release;
            return Object::from_cloud(name, points, options);
          },
          py::arg("name"), py::arg("p_OP"), py::arg_v("options", LoopOptions{}, "LoopOptions()"),
          "Points on the surface, (N, 3) in O [m]. An object without a reliable hole is still an "
          "object: plan() says so.\n\n"
          "Raises ValueError as geometry.shortest_loops does.")
      .def_property_readonly("name", &Object::name, "What errors and pictures call it.")
      .def_property_readonly(
          "points", [](const Object& self) -> Rows3 { return self.points().transpose(); },
          "(N, 3) the cloud, as given, in O [m].")
      .def_property_readonly(
          "loops", [](const Object& self) { return self.loops(); },
          "geometry.Loops, in O: what was found and from what; a copy.")
      .def_property_readonly(
          "loop_options", [](const Object& self) { return self.loop_options(); },
          "How loops were looked for; a copy.")
      .def_property_readonly(
          "surface", [](const Object& self) { return self.surface(); },
          "Mesh of what must not be touched, in O: the triangles of K_d, and thin ones along edges "
          "that "
          "bound none.")
      .def_property_readonly("spacing", &Object::spacing, "Between the points of K_d [m].")
      .def("__repr__", [](const Object& self) {
        return "<Object '" + self.name() + "' of " + std::to_string(self.points().cols()) +
               " points and " + std::to_string(self.loops().loops.size()) + " loops>";
      });
  m.def("sample_object_names", &sample_object_names,
        "Objects with holes that come with graspless: purse, bag, travel_bag, lawn_mower, chair.");
  m.def("sample_object", &sample_object, py::arg("name"), py::arg("scale") = 1.0,
        "The PlacedShapes of one of sample_object_names(), at real size, on the floor z = 0 of "
        "O.\n\n"
        "Raises ValueError that lists the names.");
}

void bind_problem(py::module_& m) {
  py::class_<Problem>(m, "Problem",
                      "What is given: put the hand through a hole of the object and close it.")
      .def(py::init([](const robot::Robot& robot, const Hand& hand, const Object& object,
                       const Array& X_WO, const Array& q_start,
                       const std::vector<Obstacle>& obstacles, const std::vector<int>& loops,
                       const std::optional<Array>& marks, const std::optional<Array>& pull_W) {
             Problem problem{robot,       hand,
                             object,      to_pose(X_WO, "X_WO"),
                             obstacles,   to_configuration(robot, q_start, "q_start"),
                             loops,       to_marks(marks),
                             std::nullopt};
             if (pull_W) problem.pull_W = to_vector3(*pull_W, "pull_W");
             return problem;
           }),
           py::arg("robot"), py::arg("hand"), py::arg("object"), py::arg("X_WO"),
           py::arg("q_start"), py::arg("obstacles") = std::vector<Obstacle>{},
           py::arg("loops") = std::vector<int>{}, py::arg("marks") = py::none(),
           py::arg("pull_W") = py::none(),
           "X_WO: (4, 4) pose of the object in the world. q_start: (dof,) where the robot stands.\n"
           "loops: which of object.loops.loops may be clasped; empty: any. marks: (N, 3) points in "
           "O [m] near which\nto clasp; none: anywhere. pull_W: (3,) where the object shall be "
           "pulled afterwards, in the world.")
      .def_property_readonly(
          "robot", [](const Problem& self) { return self.robot; }, "The robot.")
      .def_property_readonly(
          "hand", [](const Problem& self) { return self.hand; }, "A copy of the hand.")
      .def_property_readonly(
          "object", [](const Problem& self) { return self.object; }, "What is clasped.")
      .def_property_readonly(
          "X_WO", [](const Problem& self) { return from_pose(self.X_WO); },
          "(4, 4) pose of the object in the world.")
      .def_property_readonly(
          "q_start", [](const Problem& self) -> Eigen::VectorXd { return self.q_start; },
          "(dof,) [rad or m].")
      .def_readonly("obstacles", &Problem::obstacles, "What else stands around.")
      .def_readonly("loops", &Problem::loops, "Which loops may be clasped; empty: any.")
      .def_property_readonly(
          "marks", [](const Problem& self) -> Rows3 { return columns(self.marks).transpose(); },
          "(N, 3) near which to clasp, in O [m]; none: anywhere.")
      .def_property_readonly(
          "pull_W", [](const Problem& self) { return self.pull_W; },
          "(3,) where the object shall be pulled, in the world, or None.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"robot", "object", "obstacles", "loops", "pull_W"});
      });
}

void bind_stability(py::module_& m) {
  bind_options_struct<StabilityOptions>(
      m, "StabilityOptions",
      "The stability test: the hand stands still, the object moves at random, each move until it "
      "hits the hand.");
  py::class_<Stability> found(m, "Stability", "Whether a clasp holds, and how well.");
  bind_fields(found, "Any field by keyword; the others keep their defaults.",
              Field{"secure", &Stability::secure, "No sequence of moves brought the loop out."},
              Field{"escapes", &Stability::escapes, "Sequences in which the loop came free."},
              Field{"margin", &Stability::margin,
                    "1 where the object cannot move, 0 or less where it escaped."},
              Field{"checks", &Stability::checks, "Poses looked at."});
}

void bind_segment(py::module_& m) {
  py::class_<Segment>(
      m, "Segment", "A stretch of motion: rows follow each other by at most 0.05 rad in any joint.")
      .def(py::init(
               [](const std::string& name, const Array& positions, const Array& virtual_linking) {
                 Configurations rows = to_configurations(positions, "positions");
                 const Eigen::MatrixXd linking = to_linking(virtual_linking, rows.size(), name);
                 return Segment{name, std::move(rows), linking};
               }),
           py::arg("name"), py::arg("positions"), py::arg("virtual_linking"),
           "positions: (N, dof) [rad or m]. virtual_linking: (N, curves).")
      .def_readonly("name", &Segment::name, "reach or close.")
      .def_property_readonly(
          "positions",
          [](const Segment& self) {
            return from_configurations(self.positions,
                                       self.positions.empty() ? 0 : self.positions.front().size());
          },
          "(N, dof) all joints [rad or m].")
      .def_property_readonly(
          "virtual_linking",
          [](const Segment& self) -> Rows { return self.virtual_linking.transpose(); },
          "(N, curves) |VLk| of every finger curve with the loop clasped, at each row.")
      .def(
          "__len__", [](const Segment& self) { return self.positions.size(); }, "Number of rows.")
      .def("__repr__", [](const Segment& self) {
        return "<Segment '" + self.name + "' of " + std::to_string(self.positions.size()) +
               " rows>";
      });
}

void bind_tree(py::module_& m) {
  py::class_<Tree>(m, "Tree", "The tree that led to the clasp, for pictures.")
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
           "p_W: (N, 3) [m]. parents: (N,) indices. path: indices from the root to the clasp.")
      .def_property_readonly(
          "p_W", [](const Tree& self) -> Rows3 { return self.p_W.transpose(); },
          "(N, 3) centre of the hand's curves in the world, a node a row [m].")
      .def_readonly("parents", &Tree::parents, "Index of a node's parent; its own for the root.")
      .def_readonly("path", &Tree::path, "Nodes from the root to the clasp.")
      .def(
          "__len__", [](const Tree& self) { return self.p_W.cols(); }, "Number of nodes.")
      .def("__repr__", [](const Tree& self) {
        return "<Tree of " + std::to_string(self.p_W.cols()) + " nodes>";
      });
}

void bind_plan(py::module_& m) {
  py::class_<Plan> plan(m, "Plan", "What was found, or why not. False unless solved.");
  plan.def(py::init<>(), "A plan without segments, to be filled from a file.")
      .def(
          "__bool__", [](const Plan& self) { return static_cast<bool>(self); },
          "Whether it is solved.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"status", "reason", "segments", "loop", "stability"});
      });
  const auto field = [&plan](const auto& described) { bind_field(plan, described); };
  field(Field{"status", &Plan::status, "How the query ended."});
  field(Field{"reason", &Plan::reason, "One sentence, for people."});
  field(Field{"joint_names", &Plan::joint_names, "The robot's joints, in the order of positions."});
  field(Field{"segments", &Plan::segments, "Stretches of motion, in order."});
  field(Field{"loop", &Plan::loop, "Clasped: index of object.loops.loops; -1 without a plan."});
  field(Field{"target", &Plan::target, "Clasped: a geometry.ClaspTarget in O; a copy."});
  field(Field{"min_linking", &Plan::min_linking, "The threshold in force."});
  field(Field{"stability", &Plan::stability, "Of the last row; a copy."});
  field(Field{"tree", &Plan::tree, "That led to the clasp; a copy."});
  field(Field{"warnings", &Plan::warnings, "What to be careful of."});
  field(Field{"statistics", &Plan::statistics, "What the search did."});
}

void bind_planner(py::module_& m) {
  m.def(
      "validate", [](const Hand& hand, const robot::Robot& robot) { clasp::validate(hand, robot); },
      py::arg("hand"), py::arg("robot"),
      "Raises ValueError that names the field, the value and the choices.");
  bind_front_door<Problem, Options, Plan>(
      m,
      "Plans a motion of arm and hand that ends in a clasp: reach, then close until contact.\n"
      "Not finding a plan is a status.",
      "Replays a plan against its problem with none of the search's code: limits, collisions, "
      "linking by the\ndouble integral, closing until contact, and the stability test.");
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
      "Whether the object's loop stays in the hand at q, (dof,): random moves that try to part "
      "them\n(Stork, Pokorny, Kragic 2013, Section V-A).\n\n"
      "Raises ValueError on a bad problem, loop or configuration.");
}

}  // namespace

void bind_clasp(py::module_ m) {
  bind_hand(m);
  bind_object(m);
  bind_problem(m);
  bind_stability(m);
  bind_options_struct<Options>(m, "Options", "Options of the search.");
  bind_segment(m);
  bind_tree(m);
  bind_statistics_struct<Statistics>(m);
  bind_choices<Status>(m, "Status", "How a query ended.");
  bind_plan(m);
  bind_planner(m);
}

}  // namespace graspless::bindings
