// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>

#include <pybind11/native_enum.h>

#include "graspless/mechanics/contact_patch.hpp"
#include "graspless/mechanics/equilibrium.hpp"
#include "graspless/mechanics/friction_interval.hpp"
#include "graspless/mechanics/stability.hpp"
#include "graspless/mechanics/withstands.hpp"

#include "conversions.hpp"
#include "fields.hpp"

namespace graspless::bindings {

template <>
struct Python<mechanics::Vector6d> {
  using Given = Array;
  static mechanics::Vector6d from(const Array& value, const char* name) {
    return to_vector(value, name, 6);
  }
  static const mechanics::Vector6d& shown(const mechanics::Vector6d& value) { return value; }
};

namespace {

using namespace mechanics;

using Matrix6Rows = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using MaybeArray = std::optional<Array>;

// As kUnit of cpp/src/mechanics/contacts/contact.cpp: what validate() would refuse is mended.
constexpr double kUnit = 1e-9;

Eigen::Vector3d to_direction(const MaybeArray& values, const std::string& name) {
  return values ? to_vector3(*values, name) : Eigen::Vector3d::Zero();
}

Eigen::MatrixXd to_matrix(const Array& values, const std::string& name, Eigen::Index rows,
                          Eigen::Index columns) {
  if (values.ndim() != 2 || (rows >= 0 && values.shape(0) != rows) || values.shape(1) != columns) {
    throw std::invalid_argument(name + " must have shape (" +
                                (rows < 0 ? "N" : std::to_string(rows)) + ", " +
                                std::to_string(columns) + ")");
  }
  const Eigen::Map<const Rows> map(values.data(), values.shape(0), values.shape(1));
  if (!map.allFinite()) throw std::invalid_argument(name + " must be finite");
  return map;
}

Matrix6Xd to_directions(const MaybeArray& values) {
  if (!values) return disturbance_directions();
  return to_matrix(*values, "directions", -1, 6).transpose();
}

bool is_unit(const Eigen::Vector3d& n_O) { return std::abs(n_O.norm() - 1) <= kUnit; }

/// The set with unit normals, and a GrasplessWarning when that changed one.
ContactSet with_unit_normals(const ContactSet& set) {
  bool unit = true;
  for (const Contact& contact : set.contacts) unit = unit && is_unit(contact.n_O);
  for (const Finger& finger : set.fingers) unit = unit && is_unit(finger.n_O);
  if (unit) return set;
  ContactSet mended = normalized(set);
  const py::object category = py::module_::import("graspless.errors").attr("GrasplessWarning");
  if (PyErr_WarnEx(category.ptr(), "normals n_O are not of length 1: they were normalised", 1) <
      0) {
    throw py::error_already_set();
  }
  return mended;
}

void bind_contacts(py::module_& m) {
  py::native_enum<ContactMode>(m, "ContactMode", "graspless._named.Named",
                               "Motion of the object at a contact with the environment, Eq. (1).")
      .value("stick", ContactMode::stick, "No sliding: any force within the friction cone.")
      .value("slide", ContactMode::slide,
             "Sliding: a force along the cone's edge opposite to the motion.")
      .finalize();
  py::native_enum<FingerMode>(m, "FingerMode", "graspless._named.Named",
                              "Control mode of a finger, Eq. (2).")
      .value("position", FingerMode::position,
             "Position control: any force within the cone and the limit, as a passive reaction.")
      .value("force", FingerMode::force,
             "Force control: a commanded normal force, and any tangential force within the cone.")
      .finalize();

  py::class_<Contact> contact(m, "Contact",
                              "Point contact between the object and its environment.");
  contact.def(py::init([](const Array& p_OC, const Array& n_O, double friction, ContactMode mode,
                          const MaybeArray& t_O) {
                return Contact{to_vector3(p_OC, "p_OC"), to_vector3(n_O, "n_O"), friction, mode,
                               to_direction(t_O, "t_O")};
              }),
              py::kw_only(), py::arg("p_OC"), py::arg("n_O"), py::arg("friction") = 0.5,
              py::arg("mode") = ContactMode::stick, py::arg("t_O") = py::none(),
              "Parameters\n"
              "----------\n"
              "p_OC : array (3,)\n"
              "    Contact point in the object's frame O [m].\n"
              "n_O : array (3,)\n"
              "    Unit normal in O, pointing into the object.\n"
              "friction : float\n"
              "    Coefficient of friction, not negative.\n"
              "mode : ContactMode\n"
              "    Sticking or sliding.\n"
              "t_O : array (3,), optional\n"
              "    Direction along the surface, in O, of any length. For a sliding contact it is "
              "the direction\n"
              "    in which the object moves and must be given. For a sticking contact it is the "
              "direction of\n"
              "    the first edge of the friction cone; `tangent` chooses one by default.");
  bind_field(contact, Field{"p_OC", &Contact::p_OC, "(3,) contact point in O [m]."});
  bind_field(contact,
             Field{"n_O", &Contact::n_O, "(3,) unit normal in O, pointing into the object."});
  bind_field(contact, Field{"friction", &Contact::friction, "Coefficient of friction."});
  bind_field(contact, Field{"mode", &Contact::mode, "Sticking or sliding."});
  bind_field(contact,
             Field{"t_O", &Contact::t_O,
                   "(3,) direction of sliding, or of the first edge of the cone, in O. Zero lets "
                   "`tangent` choose."});
  contact.def("__repr__", [](const py::object& self) {
    return represent(self, {"p_OC", "n_O", "friction", "mode", "t_O"});
  });

  py::class_<Finger> finger(
      m, "Finger", "Fingertip in one-point contact with the object. It does not slide, Eq. (2).");
  finger.def(py::init([](const Array& p_OC, const Array& n_O, double friction, double limit,
                         const MaybeArray& t_O) {
               return Finger{to_vector3(p_OC, "p_OC"), to_vector3(n_O, "n_O"), friction, limit,
                             to_direction(t_O, "t_O")};
             }),
             py::kw_only(), py::arg("p_OC"), py::arg("n_O"), py::arg("friction") = 0.5,
             py::arg("max_normal_force") = 10.0, py::arg("t_O") = py::none(),
             "Parameters\n"
             "----------\n"
             "p_OC : array (3,)\n"
             "    Contact point in the object's frame O [m].\n"
             "n_O : array (3,)\n"
             "    Unit normal in O, pointing into the object.\n"
             "friction : float\n"
             "    Coefficient of friction, not negative.\n"
             "max_normal_force : float\n"
             "    Upper limit f_max of the normal force [N].\n"
             "t_O : array (3,), optional\n"
             "    Direction of the first edge of the friction cone, in O; `tangent` chooses one by "
             "default.");
  bind_field(finger, Field{"p_OC", &Finger::p_OC, "(3,) contact point in O [m]."});
  bind_field(finger,
             Field{"n_O", &Finger::n_O, "(3,) unit normal in O, pointing into the object."});
  bind_field(finger, Field{"friction", &Finger::friction, "Coefficient of friction."});
  bind_field(finger, Field{"max_normal_force", &Finger::max_normal_force,
                           "Upper limit f_max of the normal force [N]."});
  bind_field(
      finger,
      Field{"t_O", &Finger::t_O,
            "(3,) direction of the first edge of the cone, in O. Zero lets `tangent` choose."});
  finger.def("__repr__", [](const py::object& self) {
    return represent(self, {"p_OC", "n_O", "friction", "max_normal_force", "t_O"});
  });
}

void bind_contact_set(py::module_& m) {
  py::class_<ContactSet> set(
      m, "ContactSet",
      "All contacts of an object at one instant of a quasi-static motion, in its frame O.");
  set.def(py::init([](std::vector<Contact> contacts, std::vector<Finger> fingers,
                      const MaybeArray& com_O, const MaybeArray& known_wrench_O,
                      const MaybeArray& scale, int cone_edges) {
            ContactSet made;
            made.contacts = std::move(contacts);
            made.fingers = std::move(fingers);
            made.com_O = to_direction(com_O, "com_O");
            if (known_wrench_O) {
              made.known_wrench_O = to_vector(*known_wrench_O, "known_wrench_O", 6);
            }
            if (scale) made.wrench_scale = to_matrix(*scale, "wrench_scale", 6, 6);
            made.cone_edges = cone_edges;
            return made;
          }),
          py::kw_only(), py::arg("contacts"), py::arg("fingers"), py::arg("com_O") = py::none(),
          py::arg("known_wrench_O") = py::none(), py::arg("wrench_scale") = py::none(),
          py::arg("cone_edges") = 6,
          "Parameters\n"
          "----------\n"
          "contacts : sequence of Contact\n"
          "    Contacts with the environment.\n"
          "fingers : sequence of Finger\n"
          "    Fingertips, four at most.\n"
          "com_O : array (3,), optional\n"
          "    Centre of mass in O, about which moments are taken [m]. Zero by default.\n"
          "known_wrench_O : array (6,), optional\n"
          "    Q_known of Eq. (3): known force and moment about the centre of mass, in O [N, N m], "
          "for\n"
          "    instance `gravity_wrench`. Zero by default.\n"
          "wrench_scale : array (6, 6), optional\n"
          "    R^1/2 of Eq. (7): the matrix that scales wrenches before they are measured, for "
          "instance\n"
          "    `wrench_scale`. The identity by default.\n"
          "cone_edges : int\n"
          "    Number of edges of each polyhedral friction cone, 3 to 1000.\n\n"
          "Raises\n"
          "------\n"
          "ValueError\n"
          "    An array has the wrong shape or is not finite. `validate` checks the other rules.");
  bind_field(set, Field{"contacts", &ContactSet::contacts,
                        "Contacts with the environment. The tuple holds copies."});
  bind_field(set, Field{"fingers", &ContactSet::fingers, "Fingertips. The tuple holds copies."});
  bind_field(set, Field{"com_O", &ContactSet::com_O, "(3,) centre of mass in O [m]."});
  bind_field(set, Field{"known_wrench_O", &ContactSet::known_wrench_O,
                        "(6,) known wrench Q_known in O about the centre of mass [N, N m]."});
  set.def_property(
      "wrench_scale", [](const ContactSet& self) -> const Matrix6Rows { return self.wrench_scale; },
      [](ContactSet& self, const Array& scale) {
        self.wrench_scale = to_matrix(scale, "wrench_scale", 6, 6);
      },
      "(6, 6) matrix R^1/2 that scales a wrench in O about the centre of mass before it is "
      "measured.");
  bind_field(set, Field{"cone_edges", &ContactSet::cone_edges,
                        "Number of edges of each polyhedral friction cone."});
  set.def("__repr__", [](const py::object& self) {
    return represent(self, {"contacts", "fingers", "cone_edges"});
  });

  m.def(
      "validate", [](const ContactSet& set) { validate(set); }, py::arg("set"),
      "Checks a contact set.\n\n"
      "Parameters\n"
      "----------\n"
      "set : ContactSet\n"
      "    Contact set to check.\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    A value is not finite, a coefficient of friction is not in [0, 1e4], a force limit is\n"
      "    not in [1e-6, 1e6] N,\n"
      "    a normal is not a unit vector, a sliding contact has no direction along the surface, a "
      "cone\n"
      "    has fewer than three edges, there are more than four fingers, or the scale is singular. "
      "The\n"
      "    message names the field and its value.");
  m.def(
      "normalized", [](const ContactSet& set) { return normalized(set); }, py::arg("set"),
      "Scales all normals of a contact set to unit length.\n\n"
      "Parameters\n"
      "----------\n"
      "set : ContactSet\n"
      "    Contact set with normals of any length but zero.\n\n"
      "Returns\n"
      "-------\n"
      "ContactSet\n"
      "    Copy of the set with unit normals.\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    A normal has length zero or is not finite.");
}

void bind_cones(py::module_& m) {
  m.def(
      "tangent",
      [](const Array& n_O, const MaybeArray& t_O) -> Eigen::Vector3d {
        return tangent(to_vector3(n_O, "n_O"), to_direction(t_O, "t_O"));
      },
      py::arg("n_O"), py::arg("t_O") = py::none(),
      "Returns a unit tangent at a contact.\n\n"
      "Parameters\n"
      "----------\n"
      "n_O : array (3,)\n"
      "    Unit normal in O.\n"
      "t_O : array (3,), optional\n"
      "    Direction whose part along the surface is used, in O. Where that part vanishes, or by\n"
      "    default, the first grid axis of a face with this normal takes its place.\n\n"
      "Returns\n"
      "-------\n"
      "array (3,)\n"
      "    Unit vector in O, perpendicular to n_O.");
  m.def(
      "friction_cone",
      [](const Array& n_O, double friction, int edges, const MaybeArray& t_O) -> Rows3 {
        const Eigen::Vector3d n = to_vector3(n_O, "n_O");
        if (edges < 3) throw std::invalid_argument("edges must be at least 3");
        return friction_cone(n, friction, edges, tangent(n, to_direction(t_O, "t_O"))).transpose();
      },
      py::arg("n_O"), py::arg("friction"), py::arg("edges") = 6, py::arg("t_O") = py::none(),
      "Returns the edges of the polyhedral cone inscribed in Coulomb's cone, Section 2.2.\n\n"
      "Parameters\n"
      "----------\n"
      "n_O : array (3,)\n"
      "    Unit normal in O.\n"
      "friction : float\n"
      "    Coefficient of friction, not negative.\n"
      "edges : int\n"
      "    Number of edges, at least 3.\n"
      "t_O : array (3,), optional\n"
      "    Direction in O towards which the first edge leans, as in `tangent`.\n\n"
      "Returns\n"
      "-------\n"
      "array (edges, 3)\n"
      "    Unit vectors c_1 ... c_s in O, counter-clockwise about n_O at equal angles.\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    There are fewer than three edges, or an array has the wrong shape or is not finite.\n"
      "    The length of n_O and the sign of friction are not checked.");
  m.def(
      "wrench_scale",
      [](double mass, const Array& inertia_O) -> Matrix6Rows {
        return wrench_scale(mass, Eigen::Matrix3d(to_matrix(inertia_O, "inertia_O", 3, 3)));
      },
      py::arg("mass"), py::arg("inertia_O"),
      "Returns the scale of wrenches R^1/2 of Eqs. (7) and (8).\n\n"
      "It keeps forces and divides moments by sqrt(J_i / M), both along the principal axes of the\n"
      "inertia.\n\n"
      "Parameters\n"
      "----------\n"
      "mass : float\n"
      "    Mass M [kg].\n"
      "inertia_O : array (3, 3)\n"
      "    Inertia J about the centre of mass, in O [kg m^2].\n\n"
      "Returns\n"
      "-------\n"
      "array (6, 6)\n"
      "    Matrix that scales a wrench in O about the centre of mass.\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    The mass is not positive, or the inertia is not symmetric, not positive definite or "
      "violates\n"
      "    the triangle inequality.");
  m.def(
      "gravity_wrench",
      [](double mass, const Array& gravity_O) -> Vector6d {
        return gravity_wrench(mass, to_vector3(gravity_O, "gravity_O"));
      },
      py::arg("mass"), py::arg("gravity_O"),
      "Returns the wrench of gravity about the centre of mass.\n\n"
      "Parameters\n"
      "----------\n"
      "mass : float\n"
      "    Mass [kg].\n"
      "gravity_O : array (3,)\n"
      "    Acceleration of gravity in O [m/s^2].\n\n"
      "Returns\n"
      "-------\n"
      "array (6,)\n"
      "    Force and moment in O [N, N m]. The moment is zero.\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    The mass is not in [1e-9, 1e5] kg, or a value of gravity_O is beyond 1000 m/s^2.");
  m.def(
      "disturbance_directions", []() -> Rows6 { return disturbance_directions().transpose(); },
      "Returns the directions of disturbances l_1 ... l_N of Problem (6), with N = 76 as in "
      "Section 5.\n\n"
      "Returns\n"
      "-------\n"
      "array (76, 6)\n"
      "    Vertices of a polyhedron around the unit sphere in scaled wrench space.");
}

void bind_patches(py::module_& m) {
  py::class_<Plane> plane(
      m, "Plane", "Solid half-space that the object rests on or leans against: a floor or a wall.");
  plane.def(
      py::init([](const std::string& name, const MaybeArray& n_W, double offset, double friction) {
        Plane made;
        made.name = name;
        if (n_W) made.n_W = to_vector3(*n_W, "n_W");
        made.offset = offset;
        made.friction = friction;
        return made;
      }),
      py::kw_only(), py::arg("name") = "floor", py::arg("n_W") = py::none(),
      py::arg("offset") = 0.0, py::arg("friction") = 0.5,
      "Parameters\n"
      "----------\n"
      "name : str\n"
      "    Name in error messages.\n"
      "n_W : array (3,), optional\n"
      "    Unit normal in the world W, pointing out of the solid. Upwards by default.\n"
      "offset : float\n"
      "    n_W . p of the points p on its surface [m].\n"
      "friction : float\n"
      "    Coefficient of friction.");
  bind_field(plane, Field{"name", &Plane::name, "Name in error messages."});
  bind_field(plane, Field{"n_W", &Plane::n_W,
                          "(3,) unit normal in the world, pointing out of the solid."});
  bind_field(plane, Field{"offset", &Plane::offset, "n_W . p of the points p on its surface [m]."});
  bind_field(plane, Field{"friction", &Plane::friction, "Coefficient of friction."});
  plane.def("__repr__", [](const py::object& self) {
    return represent(self, {"name", "n_W", "offset", "friction"});
  });

  py::class_<BodyState> state(m, "BodyState", "Pose and velocity of an object at one instant.");
  state.def(
      py::init([](const Array& X_WO, const MaybeArray& twist_W, bool at_rest) {
        BodyState made;
        made.X_WO = to_pose(X_WO, "X_WO");
        if (twist_W) made.twist_W = to_vector(*twist_W, "twist_W", 6);
        made.at_rest = at_rest;
        return made;
      }),
      py::kw_only(), pose_arg("X_WO"), py::arg("twist_W") = py::none(), py::arg("at_rest") = false,
      "Parameters\n"
      "----------\n"
      "X_WO : array (4, 4)\n"
      "    Pose of the object in the world W. The identity by default.\n"
      "twist_W : array (6,), optional\n"
      "    Velocity of O's origin, then angular velocity, in W per unit of the motion's "
      "parameter.\n"
      "    Zero by default.\n"
      "at_rest : bool\n"
      "    The object stands still. Every contact then sticks, and the twist only determines the\n"
      "    directions of the cones.");
  bind_field(state, Field{"X_WO", &BodyState::X_WO, "(4, 4) pose in the world."});
  bind_field(state, Field{"twist_W", &BodyState::twist_W,
                          "(6,) velocity of O's origin, then angular velocity, in the world."});
  bind_field(state, Field{"at_rest", &BodyState::at_rest, "True if the object stands still."});
  state.def("__repr__", [](const py::object& self) {
    return represent(self, {"X_WO", "twist_W", "at_rest"});
  });

  py::class_<ContactPatches> patches(m, "ContactPatches", "Contacts of a polyhedron with planes.");
  bind_fields(patches, "Any field by keyword.",
              Field{"contacts", &ContactPatches::contacts,
                    "Vertices of the contact patches, in O. The tuple holds copies."},
              Field{"plane", &ContactPatches::plane, "Index of each contact's plane."},
              Field{"fault", &ContactPatches::fault,
                    "Reason why the vertices do not represent the patches; empty if they do."},
              Field{"turns_in_plane", &ContactPatches::turns_in_plane,
                    "True if a face turns about its normal while it slides. Its vertices then "
                    "understate friction."});
  m.def(
      "contact_patches",
      [](const Array& vertices_O, const Array& com_O, const std::vector<Plane>& planes,
         const BodyState& state, double tolerance) {
        return contact_patches(to_points3(vertices_O, "vertices_O"), to_vector3(com_O, "com_O"),
                               planes, state, tolerance);
      },
      py::arg("vertices_O"), py::arg("com_O"), py::arg("planes"), py::arg("state"),
      py::arg("tolerance") = 1e-6,
      "Finds the contacts of a convex hull with planes, Section 5.\n\n"
      "A vertex within the tolerance of a plane touches it. A touching vertex that leaves its "
      "plane is\n"
      "ignored, one that moves along it slides, and one that does not move sticks.\n\n"
      "Parameters\n"
      "----------\n"
      "vertices_O : array (N, 3)\n"
      "    Points whose convex hull is the object, in O [m].\n"
      "com_O : array (3,)\n"
      "    Centre of mass in O [m].\n"
      "planes : sequence of Plane\n"
      "    Floor and walls.\n"
      "state : BodyState\n"
      "    Pose and velocity of the object.\n"
      "tolerance : float\n"
      "    Distance from a plane within which a vertex touches it [m].\n\n"
      "Returns\n"
      "-------\n"
      "ContactPatches\n"
      "    Contacts, the plane of each, and a fault if vertices cannot represent the patches.\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    An array has the wrong shape or is not finite, a plane is invalid, or the pose is not "
      "rigid.");
}

void bind_stability(py::module_& m) {
  py::native_enum<Engine>(m, "Engine", "graspless._named.Named", "Solver of the linear programs.")
      .value("fast", Engine::fast, "Decomposed by directions and warm-started.")
      .value("reference", Engine::reference,
             "The programs as the paper writes them, solved by GLPK.")
      .finalize();
  py::class_<Stability> stability(
      m, "Stability",
      "Largest disturbance that a contact set withstands, the answer to Problem (6).");
  bind_fields(
      stability, "Any field by keyword.",
      Field{"z", &Stability::z,
            "Largest z such that the disturbance z l_i can be balanced for every direction l_i "
            "[N].\n\n"
            "0 if there is no equilibrium or it has no margin; inf if the contacts can balance "
            "anything."},
      Field{
          "commanded_forces", &Stability::commanded_forces,
          "(n,) commanded normal forces f_com of fingers in force control, 0 for the others [N]."},
      Field{"binding_directions", &Stability::binding_directions,
            "Row indices of the directions that limit z."});
  py::class_<ControlModes> modes(
      m, "ControlModes", "Control modes of greatest stability that cannot jam, Section 3.4.");
  bind_fields(
      modes, "Any field by keyword.",
      Field{"found", &ControlModes::found, "True if some combination cannot jam and has z > 0."},
      Field{"modes", &ControlModes::modes, "One control mode for each finger."},
      Field{"stability", &ControlModes::stability, "Stability under these modes."});
  modes.def(
      "__bool__", [](const ControlModes& self) { return self.found; }, "Returns `found`.");

  m.def(
      "max_stability",
      [](const ContactSet& set, const std::vector<FingerMode>& modes, const MaybeArray& directions,
         Engine engine) {
        const ContactSet unit = with_unit_normals(set);
        const Matrix6Xd l = to_directions(directions);
        const py::gil_scoped_release release;
        return max_stability(unit, modes, l, engine);
      },
      py::arg("set"), py::arg("modes"), py::kw_only(), py::arg("directions") = py::none(),
      py::arg("engine") = Engine::fast,
      "Computes the stability of a contact set under given control modes, Problem (6).\n\n"
      "Parameters\n"
      "----------\n"
      "set : ContactSet\n"
      "    Contacts with the environment and n fingers. Normals that are not unit vectors are\n"
      "    normalised with a UserWarning.\n"
      "modes : sequence of FingerMode\n"
      "    One control mode for each finger.\n"
      "directions : array (N, 6), optional\n"
      "    Directions of disturbances in scaled wrench space, which positively span it. By "
      "default\n"
      "    `disturbance_directions`.\n"
      "engine : Engine\n"
      "    Solver of the linear programs.\n\n"
      "Returns\n"
      "-------\n"
      "Stability\n"
      "    z and the commanded normal forces [N].\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    The contact set, the number of modes or the directions are invalid.");
  m.def(
      "internal_force_is_bounded",
      [](const ContactSet& set, const std::vector<FingerMode>& modes, Engine engine) {
        const ContactSet unit = with_unit_normals(set);
        const py::gil_scoped_release release;
        return internal_force_is_bounded(unit, modes, engine);
      },
      py::arg("set"), py::arg("modes"), py::kw_only(), py::arg("engine") = Engine::fast,
      "Tests whether contacts and position-controlled fingers cannot jam, Problem (5).\n\n"
      "They jam if contact forces of arbitrary size can cancel each other.\n\n"
      "Parameters\n"
      "----------\n"
      "set : ContactSet\n"
      "    Contacts with the environment and n fingers. Normals that are not unit vectors are\n"
      "    normalised with a UserWarning.\n"
      "modes : sequence of FingerMode\n"
      "    One control mode for each finger.\n"
      "engine : Engine\n"
      "    Solver of the linear programs.\n\n"
      "Returns\n"
      "-------\n"
      "bool\n"
      "    True if nothing can jam.\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    The contact set or the number of modes is invalid.");
  m.def(
      "best_control_modes",
      [](const ContactSet& set, const std::vector<FingerMode>& previous,
         const MaybeArray& directions, Engine engine) {
        const ContactSet unit = with_unit_normals(set);
        const Matrix6Xd l = to_directions(directions);
        const py::gil_scoped_release release;
        return best_control_modes(unit, previous, l, engine);
      },
      py::arg("set"), py::kw_only(), py::arg("previous") = std::vector<FingerMode>{},
      py::arg("directions") = py::none(), py::arg("engine") = Engine::fast,
      "Finds the control modes of greatest stability that cannot jam, Section 3.4.\n\n"
      "`previous` wins ties. Other ties go to force control of fingers that press into the "
      "environment\n"
      "and position control of fingers that oppose the motion. `directions` (N, 6) are those of\n"
      "`max_stability`. Normals that are not unit vectors are normalised with a UserWarning. "
      "Raises\n"
      "ValueError if the contact set, `previous` or the directions are invalid.");
  m.def(
      "best_control_modes",
      [](const std::vector<ContactSet>& sets, const MaybeArray& directions, Engine engine) {
        std::vector<ContactSet> unit;
        for (const ContactSet& set : sets) unit.push_back(with_unit_normals(set));
        const Matrix6Xd l = to_directions(directions);
        const py::gil_scoped_release release;
        return best_control_modes(unit, l, engine);
      },
      py::arg("sets"), py::kw_only(), py::arg("directions") = py::none(),
      py::arg("engine") = Engine::fast,
      "Finds the best control modes of many contact sets, each on its own.");
}

/// Binds a number that fingers as springs promise.
void bind_promise(py::module_& m, const char* name, decltype(&withstands) number,
                  const std::string& what, const std::string& returns) {
  const std::string doc =
      what +
      "Parameters\n"
      "----------\n"
      "set : ContactSet\n"
      "    Contacts with the environment and n fingers. Normals that are not unit vectors are\n"
      "    normalised with a UserWarning.\n"
      "modes : sequence of FingerMode\n"
      "    One control mode for each finger.\n"
      "nominal : Equilibrium\n"
      "    Nominal forces, for instance from `compliant_equilibrium`.\n"
      "compliance : Compliance\n"
      "    Stiffness of the contacts.\n"
      "points_O : array (N, 3), optional\n"
      "    Points of the object in O that must not yield by more than `max_yield` [m]. By default\n"
      "    there are none.\n"
      "max_yield : float\n"
      "    Distance by which the springs may let these points move [m].\n"
      "directions : array (N, 6), optional\n"
      "    Directions of disturbances in scaled wrench space. By default "
      "`disturbance_directions`.\n\n"
      "Returns\n"
      "-------\n"
      "float\n" +
      returns +
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    The contact set, the modes, the nominal forces, the stiffness, the points or the "
      "directions are\n"
      "    invalid.";
  m.def(
      name,
      [number](const ContactSet& set, const std::vector<FingerMode>& modes,
               const Equilibrium& nominal, const Compliance& compliance, const MaybeArray& points_O,
               double max_yield, const MaybeArray& directions) {
        const ContactSet unit = with_unit_normals(set);
        const Matrix6Xd l = to_directions(directions);
        const Compliance springs = compliance;
        Yield yield;
        if (points_O) yield = {to_points3(*points_O, "points_O"), max_yield};
        const py::gil_scoped_release release;
        return number(unit, modes, nominal, springs, yield, l);
      },
      py::arg("set"), py::arg("modes"), py::arg("nominal"),
      py::arg_v("compliance", Compliance{}, "Compliance()"), py::kw_only(),
      py::arg("points_O") = py::none(), py::arg("max_yield") = 1e-3,
      py::arg("directions") = py::none(), doc.c_str());
}

void bind_equilibrium(py::module_& m) {
  py::class_<Equilibrium> equilibrium(
      m, "Equilibrium",
      "Contact forces that balance a contact set, well inside their cones and limits.");
  equilibrium
      .def(py::init([](const Array& contact_forces_O, const Array& finger_forces_O, double margin) {
             return Equilibrium{to_points3(contact_forces_O, "contact_forces_O"),
                                to_points3(finger_forces_O, "finger_forces_O"), margin};
           }),
           py::arg("contact_forces_O"), py::arg("finger_forces_O"), py::arg("margin") = 0.0,
           "Forces of one's own, for instance measured ones.\n\n"
           "Parameters\n"
           "----------\n"
           "contact_forces_O : array (m, 3)\n"
           "    Force on the object at each contact, in O [N].\n"
           "finger_forces_O : array (n, 3)\n"
           "    Force on the object at each finger, in O [N].\n"
           "margin : float\n"
           "    As below [N].\n\n"
           "Raises\n"
           "------\n"
           "ValueError\n"
           "    An array has another shape.")
      .def_property_readonly("contact_forces_O", shown(&Equilibrium::contact_forces_O),
                             "(m, 3) force on the object at each contact, in O [N].")
      .def_property_readonly("finger_forces_O", shown(&Equilibrium::finger_forces_O),
                             "(n, 3) force on the object at each finger, in O [N].")
      .def_readonly("margin", &Equilibrium::margin,
                    "Largest t such that all cone coefficients are at least t, and fingers in "
                    "position control\n"
                    "stay at least t below their limits [N].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"margin", "contact_forces_O", "finger_forces_O"});
      });
  bind_options_struct<Compliance>(
      m, "Compliance",
      "Stiffness of the springs that model the contacts. Only ratios matter to the stability.");
  m.def(
      "interior_equilibrium",
      [](const ContactSet& set, const std::vector<FingerMode>& modes,
         const Array& commanded_forces) {
        const ContactSet unit = with_unit_normals(set);
        const Eigen::VectorXd forces = to_vector(commanded_forces, "commanded_forces");
        const py::gil_scoped_release release;
        return interior_equilibrium(unit, modes, forces);
      },
      py::arg("set"), py::arg("modes"), py::arg("commanded_forces"),
      "Finds contact forces that balance without disturbance, deep inside all cones and limits.\n\n"
      "The paper leaves these nominal forces open. Among the equilibria with at least 0.9 of the\n"
      "largest margin, this one has the least sum of squares of cone coefficients beyond that "
      "margin.\n\n"
      "Parameters\n"
      "----------\n"
      "set : ContactSet\n"
      "    Contacts with the environment and n fingers. Normals that are not unit vectors are\n"
      "    normalised with a UserWarning.\n"
      "modes : sequence of FingerMode\n"
      "    One control mode for each finger.\n"
      "commanded_forces : array (n,)\n"
      "    Commanded normal forces [N]. Entries of fingers in position control are ignored.\n\n"
      "Returns\n"
      "-------\n"
      "Equilibrium or None\n"
      "    None if there is no equilibrium.\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    The contact set, the modes or the forces are invalid.");
  m.def(
      "compliant_equilibrium",
      [](const ContactSet& set, const std::vector<FingerMode>& modes, const Array& commanded_forces,
         const Compliance& compliance, const MaybeArray& directions) {
        const ContactSet unit = with_unit_normals(set);
        const Eigen::VectorXd forces = to_vector(commanded_forces, "commanded_forces");
        const Matrix6Xd l = to_directions(directions);
        const Compliance springs = compliance;
        const py::gil_scoped_release release;
        return compliant_equilibrium(unit, modes, forces, springs, l);
      },
      py::arg("set"), py::arg("modes"), py::arg("commanded_forces"),
      py::arg_v("compliance", Compliance{}, "Compliance()"), py::kw_only(),
      py::arg("directions") = py::none(),
      "Finds the equilibrium whose `compliant_stability` is as large as possible.\n\n"
      "Like `interior_equilibrium`, but each contact keeps as much reserve as disturbances take "
      "from it\n"
      "when the contacts are springs. Not in the paper.\n\n"
      "Parameters\n"
      "----------\n"
      "set : ContactSet\n"
      "    Contacts with the environment and n fingers. Normals that are not unit vectors are\n"
      "    normalised with a UserWarning.\n"
      "modes : sequence of FingerMode\n"
      "    One control mode for each finger.\n"
      "commanded_forces : array (n,)\n"
      "    Commanded normal forces [N]. Entries of fingers in position control are ignored.\n"
      "compliance : Compliance\n"
      "    Stiffness of the contacts.\n"
      "directions : array (N, 6), optional\n"
      "    Directions of disturbances in scaled wrench space. By default "
      "`disturbance_directions`.\n\n"
      "Returns\n"
      "-------\n"
      "Equilibrium or None\n"
      "    None if there is no equilibrium.\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    The contact set, the modes, the forces, the stiffness or the directions are invalid.");
  m.def(
      "compliant_stability",
      [](const ContactSet& set, const std::vector<FingerMode>& modes, const Equilibrium& nominal,
         const Compliance& compliance, const MaybeArray& directions) {
        const ContactSet unit = with_unit_normals(set);
        const Matrix6Xd l = to_directions(directions);
        const Compliance springs = compliance;
        const py::gil_scoped_release release;
        return compliant_stability(unit, modes, nominal, springs, l);
      },
      py::arg("set"), py::arg("modes"), py::arg("nominal"),
      py::arg_v("compliance", Compliance{}, "Compliance()"), py::kw_only(),
      py::arg("directions") = py::none(),
      "Computes a stability margin with contacts as springs about their nominal forces.\n\n"
      "Unlike z of Problem (6), it does not assume that passive friction redistributes freely. Not "
      "in\n"
      "the paper.\n\n"
      "Parameters\n"
      "----------\n"
      "set : ContactSet\n"
      "    Contacts with the environment and n fingers. Normals that are not unit vectors are\n"
      "    normalised with a UserWarning.\n"
      "modes : sequence of FingerMode\n"
      "    One control mode for each finger.\n"
      "nominal : Equilibrium\n"
      "    Nominal forces, for instance from `compliant_equilibrium`.\n"
      "compliance : Compliance\n"
      "    Stiffness of the contacts.\n"
      "directions : array (N, 6), optional\n"
      "    Directions of disturbances in scaled wrench space. By default "
      "`disturbance_directions`.\n\n"
      "Returns\n"
      "-------\n"
      "float\n"
      "    Largest disturbance [N] under which no contact slips or lets go and no finger exceeds "
      "its\n"
      "    limit. 0 if the springs do not hold the object.\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    The contact set, the modes, the nominal forces, the stiffness or the directions are "
      "invalid.");
  bind_promise(
      m, "withstands", &withstands,
      "Computes the largest disturbance that the contacts withstand.\n\n"
      "Fingers are springs about their nominal forces, so they cannot choose how to share a\n"
      "disturbance. The environment sticks, or its friction gives way. Fingers are in their "
      "places:\n"
      "see `place_tolerance`. Not in the paper; see docs/internals/withstands.md.\n\n",
      "    Largest disturbance [N] in every direction. 0 if the springs do not hold the "
      "object.\n\n");
  bind_promise(
      m, "place_tolerance", [](const auto&... given) { return promise(given...).place_tolerance; },
      "Computes an error of the fingers' places that the contacts tolerate.\n\n"
      "In its place relative to the object, a finger has its nominal force; out of it, its spring\n"
      "presses or pulls more. With errors of up to e, the contacts still withstand `withstands`\n"
      "(1 - e / `place_tolerance`). Not in the paper; see docs/internals/withstands.md.\n\n",
      "    Distance [m] by which every finger may be out of its place, in any direction, without "
      "a\n"
      "    disturbance; often more is tolerated. At most 1; 0 if nothing is withstood.\n\n");
}

void bind_friction_interval(py::module_& m) {
  py::class_<FrictionInterval> interval(m, "FrictionInterval",
                                        "Bounds of an uncertain coefficient of friction.");
  interval.def(py::init([](double lower, double upper) {
                 return FrictionInterval{lower, upper};
               }),
               py::arg("lower"), py::arg("upper"),
               "Parameters\n"
               "----------\n"
               "lower, upper : float\n"
               "    Bounds with 0 <= lower <= upper.");
  bind_field(interval, Field{"lower", &FrictionInterval::lower, "Lower bound."});
  bind_field(interval, Field{"upper", &FrictionInterval::upper, "Upper bound."});
  interval.def("__repr__", [](const py::object& self) {
    return represent(self, {"lower", "upper"});
  });
  py::class_<Surfaces> surfaces(
      m, "Surfaces",
      "Surfaces of the environment, such as the floor and a wall.\n\n"
      "All contacts with a surface share its coefficient of friction. The coefficients of "
      "different\n"
      "surfaces vary independently.");
  bind_fields(surfaces, "Any field by keyword.",
              Field{"friction", &Surfaces::friction,
                    "Bounds of the coefficient of each surface. At most 6 may have lower < upper."},
              Field{"of_contact", &Surfaces::of_contact, "Index of each contact's surface."});
  py::class_<FrictionVerdict> verdict(m, "FrictionVerdict",
                                      "Verdict on a contact set over intervals of friction.");
  bind_fields(verdict, "Any field by keyword.",
              Field{"holds", &FrictionVerdict::holds,
                    "True if z >= needed is proven and nothing can jam, for all coefficients."},
              Field{"least_stability", &FrictionVerdict::least_stability,
                    "Proven lower bound on z over the intervals [N], if the set holds."},
              Field{"environment", &FrictionVerdict::environment,
                    "Coefficient of each surface of the environment at which the set fails, if it "
                    "does."},
              Field{"fingers", &FrictionVerdict::fingers,
                    "Coefficient of the fingers at which the set fails, if it does."},
              Field{"reason", &FrictionVerdict::reason, "Reason of the failure in words."});
  verdict.def(
      "__bool__", [](const FrictionVerdict& self) { return self.holds; }, "Returns `holds`.");
  m.def(
      "holds_over_friction",
      [](const ContactSet& set, const std::vector<FingerMode>& modes, const Array& commanded_forces,
         const std::variant<FrictionInterval, Surfaces>& environment,
         const FrictionInterval& fingers, double needed, const MaybeArray& directions) {
        const ContactSet unit = with_unit_normals(set);
        const Eigen::VectorXd forces = to_vector(commanded_forces, "commanded_forces");
        const Matrix6Xd l = to_directions(directions);
        const FrictionInterval fin = fingers;
        const auto env = environment;
        const py::gil_scoped_release release;
        return std::visit(
            [&](const auto& given) {
              return holds_over_friction(unit, modes, forces, given, fin, needed, l);
            },
            env);
      },
      py::arg("set"), py::arg("modes"), py::arg("commanded_forces"), py::kw_only(),
      py::arg("environment"), py::arg("fingers"), py::arg("needed"),
      py::arg("directions") = py::none(),
      "Proves that a contact set holds over intervals of friction, or finds where it fails.\n\n"
      "The set holds if z >= needed and nothing can jam, for all coefficients in the intervals. "
      "All\n"
      "fingers share one coefficient. The coefficients in `set` are ignored. Not in the "
      "paper.\n\n"
      "Parameters\n"
      "----------\n"
      "set : ContactSet\n"
      "    Contacts with the environment and n fingers. Normals that are not unit vectors are\n"
      "    normalised with a UserWarning.\n"
      "modes : sequence of FingerMode\n"
      "    One control mode for each finger.\n"
      "commanded_forces : array (n,)\n"
      "    Commanded normal forces [N]. Entries of fingers in position control are ignored.\n"
      "environment : FrictionInterval or Surfaces\n"
      "    Bounds of the coefficient that all contacts share, or of the coefficient of each "
      "surface.\n"
      "fingers : FrictionInterval\n"
      "    Bounds of the coefficient of the fingers.\n"
      "needed : float\n"
      "    Stability that is needed, not negative [N].\n"
      "directions : array (N, 6), optional\n"
      "    Directions of disturbances in scaled wrench space. By default "
      "`disturbance_directions`.\n\n"
      "Returns\n"
      "-------\n"
      "FrictionVerdict\n"
      "    Proven bound on z, or the coefficients at which the set fails.\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    The contact set, the modes, the forces, an interval, `needed` or the directions are "
      "invalid.");
}

void require_shape(const Array& array, const std::string& name,
                   const std::vector<py::ssize_t>& shape) {
  bool fits = array.ndim() == static_cast<py::ssize_t>(shape.size());
  for (std::size_t i = 0; fits && i < shape.size(); ++i) {
    fits = array.shape(static_cast<py::ssize_t>(i)) == shape[i];
  }
  if (fits) return;
  std::string text;
  for (const py::ssize_t size : shape) text += (text.empty() ? "" : ", ") + std::to_string(size);
  throw std::invalid_argument(name + " must have shape (" + text + ")");
}

Eigen::Vector3d vector_at(const Array& array, py::ssize_t set, py::ssize_t row) {
  return Eigen::Map<const Eigen::Vector3d>(array.data(set, row, 0));
}

std::vector<ContactSet> contact_sets(const ContactSet& common, const Array& points,
                                     const Array& normals, const Array& friction,
                                     const Array& sliding, const Array& finger_points,
                                     const Array& finger_normals, const Array& finger_friction,
                                     const Array& max_normal_force) {
  if (points.ndim() != 3) throw std::invalid_argument("points must have shape (N, m, 3)");
  if (finger_points.ndim() != 3) {
    throw std::invalid_argument("finger_points must have shape (N, n, 3)");
  }
  const py::ssize_t N = points.shape(0), m = points.shape(1), n = finger_points.shape(1);
  require_shape(points, "points", {N, m, 3});
  require_shape(normals, "normals", {N, m, 3});
  require_shape(friction, "friction", {N, m});
  require_shape(sliding, "sliding", {N, m, 3});
  require_shape(finger_points, "finger_points", {N, n, 3});
  require_shape(finger_normals, "finger_normals", {N, n, 3});
  require_shape(finger_friction, "finger_friction", {N, n});
  require_shape(max_normal_force, "max_normal_force", {N, n});
  std::vector<ContactSet> sets(static_cast<std::size_t>(N), common);
  for (py::ssize_t i = 0; i < N; ++i) {
    ContactSet& set = sets[static_cast<std::size_t>(i)];
    for (py::ssize_t k = 0; k < m; ++k) {
      const Eigen::Vector3d t_O = vector_at(sliding, i, k);
      const ContactMode mode = t_O.isZero(0) ? ContactMode::stick : ContactMode::slide;
      set.contacts.push_back(
          {vector_at(points, i, k), vector_at(normals, i, k), *friction.data(i, k), mode, t_O});
    }
    for (py::ssize_t k = 0; k < n; ++k) {
      set.fingers.push_back({vector_at(finger_points, i, k), vector_at(finger_normals, i, k),
                             *finger_friction.data(i, k), *max_normal_force.data(i, k),
                             Eigen::Vector3d::Zero()});
    }
  }
  return sets;
}

void bind_batch(py::module_& m) {
  m.def("contact_sets", &contact_sets, py::arg("common"), py::kw_only(), py::arg("points"),
        py::arg("normals"), py::arg("friction"), py::arg("sliding"), py::arg("finger_points"),
        py::arg("finger_normals"), py::arg("finger_friction"), py::arg("max_normal_force"),
        "Makes N contact sets of m contacts and n fingers each from arrays, all in the object's "
        "frame O.\n\n"
        "Parameters\n"
        "----------\n"
        "common : ContactSet\n"
        "    Contact set whose other fields all sets share.\n"
        "points, normals : array (N, m, 3)\n"
        "    Contacts with the environment [m], and their normals, which point into the object.\n"
        "friction : array (N, m)\n"
        "    Coefficients of friction.\n"
        "sliding : array (N, m, 3)\n"
        "    Direction in which the object slides at each contact; zero where it sticks.\n"
        "finger_points, finger_normals : array (N, n, 3)\n"
        "    Fingertips [m], and their normals, which point into the object.\n"
        "finger_friction : array (N, n)\n"
        "    Coefficients of friction of the fingers.\n"
        "max_normal_force : array (N, n)\n"
        "    Upper limits f_max of the normal forces [N].\n\n"
        "Returns\n"
        "-------\n"
        "list of ContactSet\n"
        "    N contact sets.\n\n"
        "Raises\n"
        "------\n"
        "ValueError\n"
        "    An array has the wrong shape.");
}

}  // namespace

void bind_mechanics(py::module_ m) {
  bind_contacts(m);
  bind_contact_set(m);
  bind_cones(m);
  bind_patches(m);
  bind_stability(m);
  bind_equilibrium(m);
  bind_friction_interval(m);
  bind_batch(m);
}

}  // namespace graspless::bindings
