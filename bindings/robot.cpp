// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/robot/robot.hpp"

#include <map>
#include <random>
#include <utility>

#include "graspless/robot/ik.hpp"
#include "graspless/robot/source.hpp"

#include "conversions.hpp"

namespace graspless::bindings {
namespace {

using robot::Ik;
using robot::Robot;
using Group = std::variant<std::string, std::vector<int>>;
using Packages = std::map<std::string, std::string>;

std::vector<int> joint_indices(const Robot& robot, const Group& group) {
  if (const auto* name = std::get_if<std::string>(&group)) {
    return robot.group(*name);
  }
  for (const int joint : std::get<std::vector<int>>(group)) {
    if (joint < 0 || joint >= robot.dof()) {
      throw std::invalid_argument("group names joint " + std::to_string(joint) + "; '" +
                                  robot.name() + "' has joints 0 to " +
                                  std::to_string(robot.dof() - 1));
    }
  }
  return std::get<std::vector<int>>(group);
}

void bind_loading(py::class_<Robot>& cls) {
  cls.def_static(
         "from_urdf",
         [](const std::string& xml, const std::string& srdf, const Packages& packages,
            const std::string& directory, const Array& X_WB) {
           const Robot::Options options{srdf, packages, directory, to_pose(X_WB, "X_WB")};
           const py::gil_scoped_release release;
           return Robot::from_urdf(xml, options);
         },
         py::arg("xml"), py::arg("srdf") = "", py::arg("packages") = Packages{},
         py::arg("directory") = "", pose_arg("X_WB"),
         "Reads URDF text. srdf: SRDF text with groups, states and disabled collisions. packages: "
         "where\n"
         "package://NAME/ points. directory: what relative mesh paths start from. X_WB: (4, 4) "
         "pose of the root.\n\n"
         "Raises ValueError that names the element at fault.")
      .def_static(
          "from_urdf_file",
          [](const std::string& path, const std::string& srdf, const Packages& packages,
             const Array& X_WB) {
            const Robot::Options options{srdf, packages, "", to_pose(X_WB, "X_WB")};
            const py::gil_scoped_release release;
            return Robot::from_urdf_file(path, options);
          },
          py::arg("path"), py::arg("srdf") = "", py::arg("packages") = Packages{}, pose_arg("X_WB"),
          "Reads a .urdf file; a .srdf of the same name beside it is read too unless srdf (text) "
          "is given.");
}

void bind_tables(py::class_<Robot>& cls) {
  cls.def_property_readonly("name", &Robot::name, "The URDF's name.")
      .def_property_readonly("dof", &Robot::dof, "Number of independent joints.")
      .def_property_readonly("joint_names", &Robot::joint_names,
                             "The independent joints, in the order of q.")
      .def_property_readonly(
          "lower", [](const Robot& self) -> Eigen::VectorXd { return self.lower(); },
          "(dof,) lower limits [rad or m]; a continuous joint has -pi.")
      .def_property_readonly(
          "upper", [](const Robot& self) -> Eigen::VectorXd { return self.upper(); },
          "(dof,) upper limits [rad or m]; a continuous joint has pi.")
      .def_property_readonly(
          "max_velocity", [](const Robot& self) -> Eigen::VectorXd { return self.max_velocity(); },
          "(dof,) [rad/s or m/s]; inf where the URDF has none.")
      .def_property_readonly(
          "max_effort", [](const Robot& self) -> Eigen::VectorXd { return self.max_effort(); },
          "(dof,) [Nm or N].")
      .def_property_readonly(
          "X_WB", [](const Robot& self) { return from_pose(self.X_WB()); },
          "(4, 4) pose of the root link in the world.")
      .def_property_readonly("urdf", &robot::urdf_of, "URDF text that the robot was read from.")
      .def_property_readonly(
          "srdf", [](const Robot& self) { return robot::options_of(self).srdf; },
          "SRDF text that the robot was read with; empty: none.")
      .def_property_readonly(
          "packages", [](const Robot& self) { return robot::options_of(self).packages; },
          "Folders that package://NAME/ points to; a copy.")
      .def_property_readonly(
          "directory", [](const Robot& self) { return robot::options_of(self).directory; },
          "Folder that relative mesh paths start from.")
      .def_property_readonly("frame_names", &Robot::frame_names,
                             "Every link, in the order of forward().")
      .def_property_readonly("group_names", &Robot::group_names, "Groups of the SRDF.")
      .def_property_readonly("state_names", &Robot::state_names, "Group states of the SRDF.")
      .def("frame", &Robot::frame, py::arg("name"), "Index of a link; ValueError lists the links.")
      .def(
          "parent",
          [](const Robot& self, const Key& frame) { return self.parent(frame_index(self, frame)); },
          py::arg("frame"), "Index of the parent link; -1 for the root.")
      .def("joint", &Robot::joint, py::arg("name"),
           "Index of an independent joint; ValueError lists the joints.")
      .def("group", &Robot::group, py::arg("name"),
           "Joint indices of a group; ValueError lists the groups.")
      .def(
          "state",
          [](const Robot& self, const std::string& name) -> Eigen::VectorXd {
            return self.state(name);
          },
          py::arg("name"),
          "(dof,) configuration of a group state; joints it does not name are 0, clamped to their "
          "limits.");
}

void bind_kinematics(py::class_<Robot>& cls) {
  cls.def(
         "forward",
         [](const Robot& self, const Array& q) {
           Poses X_WL;
           self.forward(to_configuration(self, q, "q"), X_WL);
           return from_poses(X_WL);
         },
         py::arg("q"),
         "(num_frames, 4, 4) poses of all links in the world at q, (dof,) [rad or m].")
      .def(
          "pose",
          [](const Robot& self, const Key& frame, const Array& q) {
            return from_pose(self.pose(frame_index(self, frame), to_configuration(self, q, "q")));
          },
          py::arg("frame"), py::arg("q"),
          "(4, 4) pose of a link, by name or index, in the world at q, (dof,).")
      .def(
          "jacobian",
          [](const Robot& self, const Key& frame, const Array& q) -> Rows {
            return self.jacobian(frame_index(self, frame), to_configuration(self, q, "q"));
          },
          py::arg("frame"), py::arg("q"),
          "(6, dof) Jacobian of a link's origin in the world at q, (dof,); linear rows first.")
      .def(
          "clamp",
          [](const Robot& self, const Array& q) {
            return self.clamp(to_configuration(self, q, "q"));
          },
          py::arg("q"), "q, (dof,), brought within the limits.")
      .def(
          "is_within",
          [](const Robot& self, const Array& q, double tolerance) {
            return self.is_within(to_configuration(self, q, "q"), tolerance);
          },
          py::arg("q"), py::arg("tolerance") = 1e-9,
          "Whether q, (dof,), is within the limits, with a slack of tolerance [rad or m].");
}

void bind_shapes(py::class_<Robot>& cls) {
  cls.def_property_readonly(
         "shapes",
         [](const Robot& self) {
           std::vector<std::pair<int, geometry::PlacedShape>> shapes;
           for (const robot::LinkShape& shape : self.shapes()) {
             shapes.emplace_back(shape.link, shape.placed);
           }
           return shapes;
         },
         "Collision shapes: pairs of a link's index and a shape placed in its frame.")
      .def_property_readonly(
          "ignored_pairs", &Robot::ignored_pairs,
          "Pairs of link indices, smaller first, that are never tested for collision.")
      .def(
          "reach",
          [](const Robot& self, const Key& link) -> Eigen::VectorXd {
            return self.reach(frame_index(self, link, "link"));
          },
          py::arg("link"),
          "(dof,) upper bound on how far any point of a link moves per unit of each joint [m/rad "
          "or 1].")
      .def("__repr__", [](const Robot& self) {
        return "<Robot '" + self.name() + "' with " + std::to_string(self.dof()) + " joints and " +
               std::to_string(self.frame_names().size()) + " links>";
      });
}

// An Ik with the robot that its arguments are checked against.
struct RobotIk {
  Robot robot;
  Ik ik;
};

void bind_ik(py::module_& m) {
  const Ik::Options defaults;
  py::class_<RobotIk>(
      m, "Ik",
      "Inverse kinematics of one frame by the joints of one serial group; other joints stay.\n\n"
      "Closed form for arms like the Barrett WAM, damped least squares for any other chain.")
      .def(py::init([](const Robot& robot, const Key& frame, const Group& group, double tolerance,
                       int max_iterations, int restarts, int free_samples) {
             const Ik::Options options{tolerance, max_iterations, restarts, free_samples};
             return RobotIk{
                 robot, Ik(robot, frame_index(robot, frame), joint_indices(robot, group), options)};
           }),
           py::arg("robot"), py::arg("frame"), py::arg("group"), py::kw_only(),
           py::arg("tolerance") = defaults.tolerance,
           py::arg("max_iterations") = defaults.max_iterations,
           py::arg("restarts") = defaults.restarts, py::arg("free_samples") = defaults.free_samples,
           "frame: a link's name or index. group: a group's name, or joint indices from the base "
           "outwards.\n"
           "tolerance: largest pose error of an answer [m, rad]. max_iterations: of least squares, "
           "per attempt.\n"
           "restarts: random seeds of least squares. free_samples: values of the free joint tried.")
      .def_property_readonly(
          "is_closed_form", [](const RobotIk& self) { return self.ik.is_closed_form(); },
          "Whether the chain has a closed form.")
      .def_property_readonly(
          "group", [](const RobotIk& self) { return self.ik.group(); },
          "Joint indices, from the base outwards.")
      .def(
          "solve_all",
          [](const RobotIk& self, const Array& X_WF, const Array& q, std::uint64_t seed) {
            const Eigen::Isometry3d X = to_pose(X_WF, "X_WF");
            const Eigen::VectorXd q_near = to_configuration(self.robot, q, "q");
            const py::gil_scoped_release release;
            std::mt19937_64 rng(seed);
            return from_configurations(self.ik.solve_all(X, q_near, rng), self.robot.dof());
          },
          py::arg("X_WF"), py::arg("q"), py::arg("seed") = 1,
          "(K, dof) all solutions found that put the frame at X_WF, (4, 4), nearest to q, (dof,), "
          "first.")
      .def(
          "solve_near",
          [](const RobotIk& self, const Array& X_WF, const Array& q) {
            return self.ik.solve_near(to_pose(X_WF, "X_WF"), to_configuration(self.robot, q, "q"));
          },
          py::arg("X_WF"), py::arg("q"),
          "(dof,) the one solution that continues from q, or None when it does not converge within "
          "the limits.")
      .def(
          "solve_free",
          [](const RobotIk& self, const Array& X_WF, double free_joint, const Array& q) {
            if (!self.ik.is_closed_form()) {
              throw std::invalid_argument(
                  "solve_free: this chain has no closed form (see is_closed_form)");
            }
            Configurations solutions;
            self.ik.solve_free(to_pose(X_WF, "X_WF"), free_joint,
                               to_configuration(self.robot, q, "q"), solutions);
            return from_configurations(solutions, self.robot.dof());
          },
          py::arg("X_WF"), py::arg("free_joint"), py::arg("q"),
          "(K, dof) all solutions within the limits for one value of the free joint, the group's "
          "third [rad].\n\n"
          "Raises ValueError for a chain without closed form.")
      .def("__repr__", [](const RobotIk& self) {
        return "<Ik of " + std::to_string(self.ik.group().size()) + " joints of '" +
               self.robot.name() + "', " +
               (self.ik.is_closed_form() ? "closed form>" : "damped least squares>");
      });
}

}  // namespace

void bind_robot(py::module_ m) {
  py::class_<Robot> cls(
      m, "Robot",
      "A rigid-body tree read from a URDF. Immutable; may be used from several threads.\n\n"
      "A configuration q holds its independent joints [rad or m]; mimic joints follow theirs.");
  bind_loading(cls);
  bind_tables(cls);
  bind_kinematics(cls);
  bind_shapes(cls);
  bind_ik(m);
}

}  // namespace graspless::bindings
