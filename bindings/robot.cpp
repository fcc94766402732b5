// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/robot/robot.hpp"

#include <filesystem>
#include <map>
#include <random>
#include <utility>

#include <pybind11/stl/filesystem.h>

#include "graspless/robot/description.hpp"
#include "graspless/robot/ik.hpp"

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
      throw std::invalid_argument("group must hold joint indices of '" + robot.name() + "', 0 to " +
                                  std::to_string(robot.dof() - 1) + ", not " +
                                  std::to_string(joint));
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
         "directory of each\n"
         "package://NAME/. directory: that relative mesh paths start from. X_WB: (4, 4) pose of "
         "the root in the world.\n\n"
         "Raises ValueError that names the faulty element.")
      .def_static(
          "from_urdf_file",
          [](const std::filesystem::path& path, const std::string& srdf, const Packages& packages,
             const Array& X_WB) {
            const Robot::Options options{srdf, packages, "", to_pose(X_WB, "X_WB")};
            const py::gil_scoped_release release;
            return Robot::from_urdf_file(path.string(), options);
          },
          py::arg("path"), py::arg("srdf") = "", py::arg("packages") = Packages{}, pose_arg("X_WB"),
          "Reads a .urdf file. Unless srdf (text) is given, also reads a .srdf file of the same "
          "name in the same directory.\n\nRaises ValueError that names the faulty element.");
}

void bind_tables(py::class_<Robot>& cls) {
  cls.def_property_readonly("name", &Robot::name, "Name in the URDF.")
      .def_property_readonly("dof", &Robot::dof, "Number of independent joints.")
      .def_property_readonly("joint_names", &Robot::joint_names,
                             "Independent joints, in the order of q.")
      .def_property_readonly("lower", shown(&Robot::lower),
                             "(dof,) lower limits [rad or m]; a continuous joint has -pi.")
      .def_property_readonly("upper", shown(&Robot::upper),
                             "(dof,) upper limits [rad or m]; a continuous joint has pi.")
      .def_property_readonly(
          "max_velocity", shown(&Robot::max_velocity),
          "(dof,) largest velocities [rad/s or m/s]; inf if the URDF has none, or 0.")
      .def_property_readonly("max_effort", shown(&Robot::max_effort),
                             "(dof,) largest efforts [Nm or N]; inf if the URDF has none, or 0.")
      .def_property_readonly("X_WB", shown(&Robot::X_WB),
                             "(4, 4) pose of the root link in the world.")
      .def_property_readonly("urdf", &Robot::urdf, "URDF text that the robot was read from.")
      .def_property_readonly(
          "srdf", [](const Robot& self) { return self.options().srdf; },
          "SRDF text that the robot was read with; empty: none.")
      .def_property_readonly(
          "packages", [](const Robot& self) { return self.options().packages; },
          "Folders that package://NAME/ points to; a copy.")
      .def_property_readonly(
          "directory", [](const Robot& self) { return self.options().directory; },
          "Folder that relative mesh paths start from.")
      .def_property_readonly("frame_names", &Robot::frame_names,
                             "All links, in the order of forward().")
      .def_property_readonly("group_names", &Robot::group_names, "Names of the SRDF's groups.")
      .def_property_readonly("state_names", &Robot::state_names,
                             "Names of the SRDF's group states.")
      .def_property_readonly(
          "warnings", &Robot::warnings,
          "Parts of URDF and SRDF that were ignored or changed, one sentence each: for instance\n"
          "links without a collision shape, or an entry of the SRDF that names an unknown link.")
      .def_property_readonly(
          "step_weights", shown(&Robot::step_weights),
          "(dof,) factors of the joints in the length of a step: 1 for a revolute joint, 10 rad/m "
          "for a prismatic one.")
      .def("frame", &Robot::frame, py::arg("name"),
           "Returns the index of a link.\n\nRaises ValueError that lists the links.")
      .def(
          "parent",
          [](const Robot& self, const Key& frame) { return self.parent(frame_index(self, frame)); },
          py::arg("frame"), "Returns the index of the parent link; -1 for the root.")
      .def("joint", &Robot::joint, py::arg("name"),
           "Returns the index of an independent joint.\n\nRaises ValueError that lists the joints.")
      .def("group", &Robot::group, py::arg("name"),
           "Returns the joint indices of a group.\n\nRaises ValueError that lists the groups, or "
           "says what is wrong with this one.")
      .def(
          "state",
          [](const Robot& self, const std::string& name,
             const std::optional<Array>& others) -> Eigen::VectorXd {
            return others ? self.state(name, to_configuration(self, *others, "others"))
                          : self.state(name);
          },
          py::arg("name"), py::arg("others") = py::none(),
          "Returns the configuration of a group state, (dof,). Joints that it does not name are as "
          "in others, or 0, clamped to their limits.\n\nRaises ValueError that lists the states, "
          "or says what is "
          "wrong with this one.");
}

void bind_description(py::module_& m) {
  using robot::Description;
  py::class_<Description>(m, "Description", "Texts of a robot's files.")
      .def(py::init<std::string, std::string, Packages, std::string>(), py::arg("urdf"),
           py::arg("srdf") = "", py::arg("packages") = Packages{}, py::arg("directory") = "",
           "urdf, srdf: texts. packages: directory of each package://NAME/. directory: that "
           "relative mesh paths start from.")
      .def_readwrite("urdf", &Description::urdf, "URDF text.")
      .def_readwrite("srdf", &Description::srdf, "SRDF text; empty: none.")
      .def_readwrite("packages", &Description::packages, "Directory of each package://NAME/.")
      .def_readwrite("directory", &Description::directory,
                     "Directory that relative mesh paths start from.")
      .def("__repr__", [](const Description& self) {
        return "<Description with a URDF of " + std::to_string(self.urdf.size()) + " characters>";
      });
  m.def(
      "find_packages",
      [](const Description& description) {
        const Description now = description;
        const py::gil_scoped_release release;
        return robot::find_packages(now);
      },
      py::arg("description"),
      "Returns the packages of a description, and those that its meshes name as "
      "package://NAME/...\n\n"
      "Looks in ROS_PACKAGE_PATH, in AMENT_PREFIX_PATH (share/NAME), and in the folders above "
      "the directory: one called NAME,\n"
      "one that contains NAME or, failing that, one that contains the mesh itself. The first "
      "folder that contains the mesh is used.\n\n"
      "Raises ValueError that says where a collision mesh's package was looked for.");
  m.def(
      "join",
      [](const Description& arm, const Description& gripper, const std::string& mount,
         const Array& X_MG, const std::string& prefix, const std::string& root) {
        const robot::Mount place{mount, to_pose(X_MG, "X_MG"), prefix, root};
        const Description arm_now = arm;
        const Description gripper_now = gripper;
        const py::gil_scoped_release release;
        return robot::join(arm_now, gripper_now, place);
      },
      py::arg("arm"), py::arg("gripper"), py::arg("mount"), pose_arg("X_MG"),
      py::arg("prefix") = "", py::arg("root") = "",
      "Returns the description of an arm with a gripper. A fixed joint carries the root link of "
      "the gripper.\n\n"
      "arm, gripper: descriptions. mount: link M of the arm. X_MG: (4, 4) pose of the gripper's "
      "root link in M.\n"
      "prefix: put before all names of the gripper; empty: ``gripper_``, before names that the arm "
      "has too. Paths of meshes\n"
      "become absolute. States of the same name are merged.\n"
      "root: link of the gripper to mount, with all that it carries and without its SRDF; empty: "
      "all links.\n\n"
      "Raises ValueError that names the faulty description, the unknown link, or names that "
      "clash.");
}

/// One Jacobian (6, dof) for q (dof,), or N of them for q (N, dof).
py::array_t<double> jacobians(const Robot& robot, int frame, const Array& q) {
  if (q.ndim() == 1) {
    return py::cast(Rows(robot.jacobian(frame, to_configuration(robot, q, "q"))));
  }
  const Configurations rows = to_configurations(q, "q");
  if (q.shape(1) != robot.dof()) {
    throw std::invalid_argument("q should have " + std::to_string(robot.dof()) +
                                " columns, one for each joint of '" + robot.name() + "', not " +
                                std::to_string(q.shape(1)));
  }
  py::array_t<double> result({q.shape(0), py::ssize_t{6}, q.shape(1)});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto size = static_cast<std::size_t>(6 * robot.dof());
    Eigen::Map<Rows>(result.mutable_data() + i * size, 6, robot.dof()) =
        robot.jacobian(frame, rows[i]);
  }
  return result;
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
         "Returns the poses of all links in the world, (num_frames, 4, 4), at q, (dof,) [rad or "
         "m].")
      .def(
          "pose",
          [](const Robot& self, const Key& frame, const Array& q) {
            return from_pose(self.pose(frame_index(self, frame), to_configuration(self, q, "q")));
          },
          py::arg("frame"), py::arg("q"),
          "Returns the pose of a link, given by name or index, in the world, (4, 4), at q, (dof,) "
          "[rad or m].")
      .def(
          "jacobian",
          [](const Robot& self, const Key& frame, const Array& q) {
            return jacobians(self, frame_index(self, frame), q);
          },
          py::arg("frame"), py::arg("q"),
          "Returns the Jacobian of a link's origin in the world, (6, dof), at q, (dof,); linear "
          "rows first. At many configurations, (N, dof), it is (N, 6, dof).")
      .def(
          "clamp",
          [](const Robot& self, const Array& q) {
            return self.clamp(to_configuration(self, q, "q"));
          },
          py::arg("q"), "Returns q, (dof,), clamped to the joint limits.")
      .def(
          "is_within",
          [](const Robot& self, const Array& q, double tolerance) {
            return self.is_within(to_configuration(self, q, "q"), tolerance);
          },
          py::arg("q"), py::arg("tolerance") = 1e-9,
          "Returns True if q, (dof,), is within the joint limits, up to tolerance [rad or m].");
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
         "Collision shapes: pairs of a link's index and a shape placed in the link's frame.")
      .def_property_readonly(
          "ignored_pairs", &Robot::ignored_pairs,
          "Pairs of link indices, smaller first, that are never tested for collision.")
      .def(
          "reach",
          [](const Robot& self, const Key& link) -> Eigen::VectorXd {
            return self.reach(frame_index(self, link, "link"));
          },
          py::arg("link"),
          "Returns an upper bound on how far any point of a link's shapes moves per unit of each "
          "joint, (dof,) [m/rad or 1]; of a link without shapes, its origin.")
      .def("__repr__", [](const Robot& self) {
        return "<Robot '" + self.name() + "' with " + std::to_string(self.dof()) + " joints and " +
               std::to_string(self.frame_names().size()) + " links>";
      });
}

// An Ik together with the robot, against which its arguments are checked.
struct RobotIk {
  Robot robot;
  Ik ik;
};

void bind_ik(py::module_& m) {
  const Ik::Options defaults;
  py::class_<RobotIk>(
      m, "Ik",
      "Inverse kinematics of one frame with the joints of one serial group; all other joints stay "
      "as given.\n\n"
      "Closed form for most arms of six or seven revolute joints, damped least squares for any "
      "other chain.")
      .def(py::init([](const Robot& robot, const Key& frame, const Group& group, double tolerance,
                       double lean, int max_iterations, int restarts, int free_samples) {
             const Ik::Options options{tolerance, max_iterations, restarts, free_samples, lean};
             return RobotIk{
                 robot, Ik(robot, frame_index(robot, frame), joint_indices(robot, group), options)};
           }),
           py::arg("robot"), py::arg("frame"), py::arg("group"), py::kw_only(),
           py::arg("tolerance") = defaults.tolerance, py::arg("lean") = defaults.lean,
           py::arg("max_iterations") = defaults.max_iterations,
           py::arg("restarts") = defaults.restarts, py::arg("free_samples") = defaults.free_samples,
           "frame: a link's name or index. group: a group's name, or joint indices from the base "
           "outwards.\n"
           "tolerance: largest pose error of a solution [m, rad]. lean: angle error that is "
           "allowed where least squares cannot turn the frame further, as with five joints; at "
           "most 0.1 [rad].\n"
           "max_iterations: of least squares, per attempt. "
           "restarts: random restarts of least squares. free_samples: values of the free joint "
           "tried in closed form, at most 10000.\n\nRaises ValueError if a joint of the group does "
           "not move the "
           "frame.")
      .def_property_readonly(
          "is_closed_form", [](const RobotIk& self) { return self.ik.is_closed_form(); },
          "True if the chain has a closed form.")
      .def_property_readonly(
          "free_joint", [](const RobotIk& self) { return self.ik.free_joint(); },
          "Index of the joint whose value solve_free() takes. None for six joints, and for a chain "
          "without closed form.")
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
          "Returns all solutions found that put the frame at X_WF, (4, 4), in the world: (K, dof), "
          "nearest to q, (dof,), first.")
      .def(
          "solve_near",
          [](const RobotIk& self, const Array& X_WF, const Array& q) {
            return self.ik.solve_near(to_pose(X_WF, "X_WF"), to_configuration(self.robot, q, "q"));
          },
          py::arg("X_WF"), py::arg("q"),
          "Returns the solution that continues from q, (dof,), or None if it does not converge "
          "within the limits.")
      .def(
          "solve_free",
          [](const RobotIk& self, const Array& X_WF, double value, const Array& q) {
            if (!self.ik.is_closed_form()) {
              throw std::invalid_argument(
                  "solve_free: this chain has no closed form; check is_closed_form first");
            }
            Configurations solutions;
            self.ik.solve_free(to_pose(X_WF, "X_WF"), value, to_configuration(self.robot, q, "q"),
                               solutions);
            return from_configurations(solutions, self.robot.dof());
          },
          py::arg("X_WF"), py::arg("free_joint"), py::arg("q"),
          "Returns all solutions within the limits for one value of the free joint [rad]: (K, "
          "dof). "
          "Without a free joint, the value is ignored.\n\n"
          "Raises ValueError for a chain without closed form.")
      .def("__repr__", [](const RobotIk& self) {
        return "<Ik of " + std::to_string(self.ik.group().size()) + " joints of '" +
               self.robot.name() + "', " +
               (self.ik.is_closed_form() ? "closed form>" : "damped least squares>");
      });
}

}  // namespace

void bind_robot(py::module_ m) {
  py::class_<Robot> cls(m, "Robot",
                        "A rigid-body tree read from a URDF. Immutable and thread-safe.\n\n"
                        "A configuration q holds the independent joints [rad or m]; mimic joints "
                        "follow the joints that they mimic.");
  bind_description(m);
  bind_loading(cls);
  bind_tables(cls);
  bind_kinematics(cls);
  bind_shapes(cls);
  bind_ik(m);
}

}  // namespace graspless::bindings
