// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <pybind11/native_enum.h>

#include "graspless/mechanics/contact_patch.hpp"
#include "graspless/mechanics/equilibrium.hpp"
#include "graspless/mechanics/friction_interval.hpp"
#include "graspless/mechanics/stability.hpp"

#include "conversions.hpp"

namespace graspless::bindings {
namespace {

using namespace mechanics;

using Rows6 = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;
using Matrix6Rows = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using MaybeArray = std::optional<Array>;

// As kUnit of cpp/src/mechanics/contact.cpp: what validate() would refuse is mended.
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

/// The set with unit normals, and a UserWarning when that changed one.
ContactSet with_unit_normals(const ContactSet& set) {
  bool unit = true;
  for (const Contact& contact : set.contacts) unit = unit && is_unit(contact.n_O);
  for (const Finger& finger : set.fingers) unit = unit && is_unit(finger.n_O);
  if (unit) return set;
  ContactSet mended = normalized(set);
  if (PyErr_WarnEx(PyExc_UserWarning, "normals n_O are not of length 1: they were normalised", 1) <
      0) {
    throw py::error_already_set();
  }
  return mended;
}

/// A vector member, copied both ways.
template <class Struct, class Vector>
void bind_vector(py::class_<Struct>& cls, const char* name, Vector Struct::*member,
                 const char* doc) {
  cls.def_property(
      name, [member](const Struct& self) -> Vector { return self.*member; },
      [member, name](Struct& self, const Array& values) {
        self.*member = to_vector(values, name, Vector::RowsAtCompileTime);
      },
      doc);
}

void bind_contacts(py::module_& m) {
  py::native_enum<ContactMode>(m, "ContactMode", "enum.Enum", "How the object moves at a contact.")
      .value("stick", ContactMode::stick, "Not: any force within the friction cone.")
      .value("slide", ContactMode::slide,
             "Along the surface: a force on the cone's edge against the motion.")
      .finalize();
  py::native_enum<FingerMode>(m, "FingerMode", "enum.Enum", "How a finger is controlled.")
      .value("position", FingerMode::position, "It gives any force within cone and limit.")
      .value("force", FingerMode::force,
             "It gives a commanded normal force, and any tangential one within the cone.")
      .finalize();

  py::class_<Contact> contact(m, "Contact", "A point where the object touches its environment.");
  contact.def(py::init([](const Array& p_OC, const Array& n_O, double friction, ContactMode mode,
                          const MaybeArray& t_O) {
                return Contact{to_vector3(p_OC, "p_OC"), to_vector3(n_O, "n_O"), friction, mode,
                               to_direction(t_O, "t_O")};
              }),
              py::kw_only(), py::arg("p_OC"), py::arg("n_O"), py::arg("friction") = 0.5,
              py::arg("mode") = ContactMode::stick, py::arg("t_O") = py::none(),
              "p_OC: (3,) [m]. n_O: (3,) normal into the object. friction: coefficient.\n\n"
              "t_O: (3,) along the surface. Sliding: where the object moves to there. Sticking: "
              "the first edge of the friction cone.");
  bind_vector(contact, "p_OC", &Contact::p_OC, "(3,) where, in O [m].");
  bind_vector(contact, "n_O", &Contact::n_O, "(3,) unit normal into the object, in O.");
  bind_field(contact, Field{"friction", &Contact::friction, "Coefficient of friction."});
  bind_field(contact, Field{"mode", &Contact::mode, "Whether it sticks or slides."});
  bind_vector(contact, "t_O", &Contact::t_O,
              "(3,) direction of sliding or of the cone's first edge, in O; zero: any.");
  contact.def("__repr__", [](const py::object& self) {
    return represent(self, {"p_OC", "n_O", "friction", "mode", "t_O"});
  });

  py::class_<Finger> finger(m, "Finger", "A fingertip that does not slide on the object.");
  finger.def(py::init([](const Array& p_OC, const Array& n_O, double friction, double limit,
                         const MaybeArray& t_O) {
               return Finger{to_vector3(p_OC, "p_OC"), to_vector3(n_O, "n_O"), friction, limit,
                             to_direction(t_O, "t_O")};
             }),
             py::kw_only(), py::arg("p_OC"), py::arg("n_O"), py::arg("friction") = 0.5,
             py::arg("max_normal_force") = 10.0, py::arg("t_O") = py::none(),
             "p_OC: (3,) [m]. n_O: (3,) normal into the object. friction: coefficient. "
             "max_normal_force: [N].\n\n"
             "t_O: (3,) first edge of the friction cone, along the surface.");
  bind_vector(finger, "p_OC", &Finger::p_OC, "(3,) where, in O [m].");
  bind_vector(finger, "n_O", &Finger::n_O, "(3,) unit normal into the object, in O.");
  bind_field(finger, Field{"friction", &Finger::friction, "Coefficient of friction."});
  bind_field(finger, Field{"max_normal_force", &Finger::max_normal_force,
                           "Limit of the normal force [N]."});
  bind_vector(finger, "t_O", &Finger::t_O, "(3,) the cone's first edge, in O; zero: any.");
  finger.def("__repr__", [](const py::object& self) {
    return represent(self, {"p_OC", "n_O", "friction", "max_normal_force", "t_O"});
  });
}

void bind_contact_set(py::module_& m) {
  py::class_<ContactSet> set(m, "ContactSet",
                             "All that touches an object at one instant of a slow motion, in its "
                             "frame O.");
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
          "contacts, fingers: Contacts and Fingers, at most four of these. com_O: (3,) centre of "
          "mass [m], zero unless given.\n"
          "known_wrench_O: (6,) force and moment about the centre of mass, such as "
          "gravity_wrench() [N, N m], zero unless given.\n"
          "wrench_scale: (6, 6) what wrenches are measured by, wrench_scale(); the identity unless "
          "given. cone_edges: of each friction cone.");
  bind_field(set, Field{"contacts", &ContactSet::contacts, "With the environment; copies."});
  bind_field(set, Field{"fingers", &ContactSet::fingers, "Copies."});
  bind_vector(set, "com_O", &ContactSet::com_O, "(3,) centre of mass in O [m].");
  bind_vector(set, "known_wrench_O", &ContactSet::known_wrench_O,
              "(6,) known wrench in O about the centre of mass [N, N m].");
  set.def_property(
      "wrench_scale", [](const ContactSet& self) -> Matrix6Rows { return self.wrench_scale; },
      [](ContactSet& self, const Array& scale) {
        self.wrench_scale = to_matrix(scale, "wrench_scale", 6, 6);
      },
      "(6, 6) what a wrench in O about the centre of mass is multiplied with to be measured.");
  bind_field(set, Field{"cone_edges", &ContactSet::cone_edges, "Edges of each friction cone."});
  set.def("__repr__", [](const py::object& self) {
    return represent(self, {"contacts", "fingers", "cone_edges"});
  });

  m.def(
      "validate", [](const ContactSet& set) { validate(set); }, py::arg("set"),
      "Raises ValueError that names the field at fault and its value.");
  m.def(
      "normalized", [](const ContactSet& set) { return normalized(set); }, py::arg("set"),
      "The same set with unit normals. Raises ValueError on one without a direction.");
}

void bind_cones(py::module_& m) {
  m.def(
      "tangent",
      [](const Array& n_O, const MaybeArray& t_O) -> Eigen::Vector3d {
        return tangent(to_vector3(n_O, "n_O"), to_direction(t_O, "t_O"));
      },
      py::arg("n_O"), py::arg("t_O") = py::none(),
      "(3,) unit tangent at a unit normal n_O: t_O without its normal part, or a grid axis of the "
      "face when that vanishes.");
  m.def(
      "friction_cone",
      [](const Array& n_O, double friction, int edges, const MaybeArray& t_O) -> Rows3 {
        const Eigen::Vector3d n = to_vector3(n_O, "n_O");
        if (edges < 3) throw std::invalid_argument("edges must be at least 3");
        return friction_cone(n, friction, edges, tangent(n, to_direction(t_O, "t_O"))).transpose();
      },
      py::arg("n_O"), py::arg("friction"), py::arg("edges") = 6, py::arg("t_O") = py::none(),
      "(edges, 3) unit edges of the cone inscribed in Coulomb's about a unit normal; the first "
      "lies "
      "over tangent(n_O, t_O).");
  m.def(
      "wrench_scale",
      [](double mass, const Array& inertia_O) -> Matrix6Rows {
        return wrench_scale(mass, Eigen::Matrix3d(to_matrix(inertia_O, "inertia_O", 3, 3)));
      },
      py::arg("mass"), py::arg("inertia_O"),
      "(6, 6) that leaves forces as they are and divides moments by sqrt(J_i / M) along the "
      "principal axes.\n\n"
      "mass: [kg]. inertia_O: (3, 3) about the centre of mass [kg m^2].");
  m.def(
      "gravity_wrench",
      [](double mass, const Array& gravity_O) -> Vector6d {
        return gravity_wrench(mass, to_vector3(gravity_O, "gravity_O"));
      },
      py::arg("mass"), py::arg("gravity_O"),
      "(6,) gravity's wrench on a mass [kg], for an acceleration (3,) in O [m/s^2].");
  m.def(
      "disturbance_directions", []() -> Rows6 { return disturbance_directions().transpose(); },
      "(76, 6) vertices of a polyhedron about the unit sphere of scaled wrenches.");
}

void bind_patches(py::module_& m) {
  py::class_<Plane> plane(m, "Plane", "A half-space that the object rests on: floor or wall.");
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
      "n_W: (3,) unit normal out of the solid, upward unless given. offset: n_W . p of its "
      "points [m]. friction: coefficient.");
  bind_field(plane, Field{"name", &Plane::name, "What errors call it."});
  bind_vector(plane, "n_W", &Plane::n_W, "(3,) unit normal out of the solid, in the world.");
  bind_field(plane, Field{"offset", &Plane::offset, "n_W . p of its points [m]."});
  bind_field(plane, Field{"friction", &Plane::friction, "Coefficient of friction."});
  plane.def("__repr__", [](const py::object& self) {
    return represent(self, {"name", "n_W", "offset", "friction"});
  });

  py::class_<BodyState> state(m, "BodyState", "How an object stands and moves at one instant.");
  state.def(py::init([](const Array& X_WO, const MaybeArray& twist_W, bool at_rest) {
              BodyState made;
              made.X_WO = to_pose(X_WO, "X_WO");
              if (twist_W) made.twist_W = to_vector(*twist_W, "twist_W", 6);
              made.at_rest = at_rest;
              return made;
            }),
            py::kw_only(), pose_arg("X_WO"), py::arg("twist_W") = py::none(),
            py::arg("at_rest") = false,
            "X_WO: (4, 4). twist_W: (6,) velocity of O's origin, then angular velocity, in the "
            "world.\n\n"
            "at_rest: it stands still, every contact sticks, and the twist only turns the cones.");
  state.def_property(
      "X_WO", [](const BodyState& self) { return from_pose(self.X_WO); },
      [](BodyState& self, const Array& X) { self.X_WO = to_pose(X, "X_WO"); },
      "(4, 4) pose in the world.");
  bind_vector(state, "twist_W", &BodyState::twist_W,
              "(6,) velocity of O's origin, then angular velocity, in the world.");
  bind_field(state, Field{"at_rest", &BodyState::at_rest, "Whether it stands still."});
  state.def("__repr__", [](const py::object& self) {
    return represent(self, {"X_WO", "twist_W", "at_rest"});
  });

  py::class_<ContactPatches> patches(m, "ContactPatches", "Where a polyhedron touches planes.");
  bind_fields(patches, "Any field by keyword.",
              Field{"contacts", &ContactPatches::contacts, "Corners of the patches; copies."},
              Field{"plane", &ContactPatches::plane, "Index of each contact's plane."},
              Field{"fault", &ContactPatches::fault,
                    "Why the corners cannot stand for the patches; empty when they can."},
              Field{"turns_in_plane", &ContactPatches::turns_in_plane,
                    "Whether a face turns about its normal: its corners understate friction."});
  m.def(
      "contact_patches",
      [](const Array& vertices_O, const Array& com_O, const std::vector<Plane>& planes,
         const BodyState& state, double tolerance) {
        return contact_patches(to_points3(vertices_O, "vertices_O"), to_vector3(com_O, "com_O"),
                               planes, state, tolerance);
      },
      py::arg("vertices_O"), py::arg("com_O"), py::arg("planes"), py::arg("state"),
      py::arg("tolerance") = 1e-6,
      "Contacts of the convex hull of vertices_O, (N, 3) [m], with planes. com_O: (3,) [m].\n\n"
      "A vertex within tolerance [m] of a plane touches it; one that leaves does not count, one "
      "that moves along slides.");
}

void bind_stability(py::module_& m) {
  py::native_enum<Engine>(m, "Engine", "enum.Enum", "Who solves the linear programs.")
      .value("fast", Engine::fast, "Decomposed by directions, warm started.")
      .value("reference", Engine::reference, "As the paper writes them, by GLPK.")
      .finalize();
  py::class_<Stability> stability(m, "Stability", "How much disturbance an instant withstands.");
  bind_fields(stability, "Any field by keyword.",
              Field{"z", &Stability::z,
                    "Largest z such that every z times a direction is balanced [N]; 0 without "
                    "equilibrium or margin, inf when contacts can balance anything."},
              Field{"commanded_forces", &Stability::commanded_forces,
                    "(n,) normal force of each finger in force control, 0 for the others [N]."},
              Field{"binding_directions", &Stability::binding_directions,
                    "Rows of the directions that keep z from growing."});
  py::class_<ControlModes> modes(m, "ControlModes",
                                 "The control modes of greatest stability that cannot jam.");
  bind_fields(modes, "Any field by keyword.",
              Field{"found", &ControlModes::found, "Whether there are any, with z > 0."},
              Field{"modes", &ControlModes::modes, "One FingerMode a finger."},
              Field{"stability", &ControlModes::stability, "With these modes."});
  modes.def(
      "__bool__", [](const ControlModes& self) { return self.found; }, "Whether found.");

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
      "Problem (6): the stability of a contact set under these control modes, one a finger.\n\n"
      "directions: (N, 6) that positively span the space; disturbance_directions() unless given.");
  m.def(
      "internal_force_is_bounded",
      [](const ContactSet& set, const std::vector<FingerMode>& modes, Engine engine) {
        const ContactSet unit = with_unit_normals(set);
        const py::gil_scoped_release release;
        return internal_force_is_bounded(unit, modes, engine);
      },
      py::arg("set"), py::arg("modes"), py::kw_only(), py::arg("engine") = Engine::fast,
      "Problem (5): whether contacts and position-controlled fingers cannot jam.");
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
      "The control modes of greatest stability that cannot jam; ties go to `previous`, then to "
      "force control of the fingers that press into the environment.");
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
      py::arg("engine") = Engine::fast, "The same for many contact sets.");
}

void bind_equilibrium(py::module_& m) {
  py::class_<Equilibrium> equilibrium(
      m, "Equilibrium", "Contact forces that balance, as far inside their limits as they go.");
  equilibrium
      .def_property_readonly(
          "contact_forces_O",
          [](const Equilibrium& self) -> Rows3 { return self.contact_forces_O.transpose(); },
          "(m, 3) on the object, in O [N].")
      .def_property_readonly(
          "finger_forces_O",
          [](const Equilibrium& self) -> Rows3 { return self.finger_forces_O.transpose(); },
          "(n, 3) on the object, in O [N].")
      .def_readonly("margin", &Equilibrium::margin,
                    "What every cone coefficient, and what is left to every limit, is at least "
                    "[N].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"margin", "contact_forces_O", "finger_forces_O"});
      });
  py::class_<Compliance> compliance(m, "Compliance",
                                    "Springs at the contacts, of which only ratios matter.");
  bind_fields(compliance, "Any field by keyword; the others keep their defaults.",
              Field{"environment_normal", &Compliance::environment_normal, "Along the normal."},
              Field{"environment_tangential", &Compliance::environment_tangential,
                    "Along the surface, where contacts stick."},
              Field{"finger_normal", &Compliance::finger_normal, "Of fingers in position control."},
              Field{"finger_tangential", &Compliance::finger_tangential, "Of all fingers."});
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
      "The Equilibrium deepest inside all cones and limits; None when there is none.\n\n"
      "commanded_forces: (n,) [N], looked at for fingers in force control.");
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
      "The Equilibrium with room where springs at the contacts will ask for it, so that "
      "compliant_stability() is large; None when there is none.\n\n"
      "commanded_forces: (n,) [N], looked at for fingers in force control.\n"
      "directions: (N, 6); disturbance_directions() unless given.");
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
      "The largest disturbance [N] that springs at the contacts carry from the nominal forces "
      "before one slips, lets go or passes its limit.\n\n"
      "Unlike z, it does not assume that passive friction redistributes freely.");
}

void bind_friction_interval(py::module_& m) {
  py::class_<FrictionInterval> interval(m, "FrictionInterval",
                                        "Bounds of a coefficient of friction.");
  interval.def(py::init([](double lower, double upper) {
                 return FrictionInterval{lower, upper};
               }),
               py::arg("lower"), py::arg("upper"), "0 < lower <= upper.");
  bind_field(interval, Field{"lower", &FrictionInterval::lower, "Least."});
  bind_field(interval, Field{"upper", &FrictionInterval::upper, "Greatest."});
  interval.def("__repr__", [](const py::object& self) {
    return represent(self, {"lower", "upper"});
  });
  py::class_<FrictionVerdict> verdict(
      m, "FrictionVerdict", "Whether a contact set holds for all coefficients of an interval.");
  bind_fields(
      verdict, "Any field by keyword.",
      Field{"holds", &FrictionVerdict::holds, "Whether it does, shown."},
      Field{"least_stability", &FrictionVerdict::least_stability,
            "A proven lower bound on z when it holds [N]."},
      Field{"environment", &FrictionVerdict::environment,
            "Coefficient of the environment at which it fails."},
      Field{"fingers", &FrictionVerdict::fingers, "Coefficient of the fingers at which it fails."},
      Field{"reason", &FrictionVerdict::reason, "How it fails, for people."});
  verdict.def(
      "__bool__", [](const FrictionVerdict& self) { return self.holds; }, "Whether it holds.");
  m.def(
      "holds_over_friction",
      [](const ContactSet& set, const std::vector<FingerMode>& modes, const Array& commanded_forces,
         const FrictionInterval& environment, const FrictionInterval& fingers, double needed,
         const MaybeArray& directions) {
        const ContactSet unit = with_unit_normals(set);
        const Eigen::VectorXd forces = to_vector(commanded_forces, "commanded_forces");
        const Matrix6Xd l = to_directions(directions);
        const FrictionInterval env = environment, fin = fingers;
        const py::gil_scoped_release release;
        return holds_over_friction(unit, modes, forces, env, fin, needed, l);
      },
      py::arg("set"), py::arg("modes"), py::arg("commanded_forces"), py::kw_only(),
      py::arg("environment"), py::arg("fingers"), py::arg("needed"),
      py::arg("directions") = py::none(),
      "Whether z >= needed [N], without jamming, for all coefficients within the intervals.\n\n"
      "All contacts share one coefficient, and so do all fingers; those of `set` are not looked "
      "at.");
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
        "N ContactSets of m contacts and n fingers each from arrays; whatever else they hold is "
        "that of `common`.\n\n"
        "points, normals: (N, m, 3). friction: (N, m). sliding: (N, m, 3) where the object slides "
        "to, zero where it sticks.\n"
        "finger_points, finger_normals: (N, n, 3). finger_friction, max_normal_force: (N, n).");
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
