// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/fingertip/fingertip.hpp"

#include "graspless/fingertip/resume.hpp"
#include "graspless/realize/realize.hpp"

#include "conversions.hpp"
#include "fields.hpp"
#include "planning.hpp"
#include "segments.hpp"

namespace graspless::bindings {

using Interval = mechanics::FrictionInterval;
using Directions = mechanics::Matrix6Xd;

/// One number, or both bounds.
template <>
struct Python<Interval> {
  using Given = std::variant<double, std::pair<double, double>>;
  static Interval from(const Given& value, const char* /*name*/) {
    if (const auto* number = std::get_if<double>(&value)) return {*number, *number};
    const auto& bounds = std::get<std::pair<double, double>>(value);
    return {bounds.first, bounds.second};
  }
  static std::pair<double, double> shown(const Interval& value) {
    return {value.lower, value.upper};
  }
  static py::arg_v arg(const char* name, const Interval& value) {
    return py::arg(name) = shown(value);
  }
};

/// Rows, as points are.
template <>
struct Python<Directions> {
  using Given = Array;
  static Directions from(const Array& rows, const char* name) {
    if (rows.ndim() != 2 || rows.shape(1) != 6) {
      throw std::invalid_argument(std::string(name) + " must have shape (N, 6)");
    }
    return Eigen::Map<const Rows6>(rows.data(), rows.shape(0), 6).transpose();
  }
  static Rows6 shown(const Directions& value) { return value.transpose(); }
  static py::arg_v arg(const char* name, const Directions& value) {
    return {name, Array::ensure(py::cast(shown(value))), "..."};  // 76 rows would fill a screen
  }
};

namespace {

using namespace fingertip;

/// A Mesh, a pair of arrays (vertices, triangles), or anything with `vertices` and `faces`.
geometry::Mesh to_mesh(const py::object& given) {
  if (py::isinstance<geometry::Mesh>(given)) return given.cast<geometry::Mesh>();
  py::object vertices, triangles;
  if (py::hasattr(given, "vertices") && py::hasattr(given, "faces")) {
    vertices = given.attr("vertices");
    triangles = given.attr("faces");
  } else if (py::isinstance<py::sequence>(given) && py::len(given) == 2) {
    vertices = given[py::int_(0)];
    triangles = given[py::int_(1)];
  } else {
    throw std::invalid_argument(
        "mesh must be a geometry.Mesh, a trimesh.Trimesh or a pair (vertices, triangles)");
  }
  const Array rows = Array::ensure(vertices);
  const Array faces = Array::ensure(triangles);
  if (!rows || !faces) {
    PyErr_Clear();
    throw std::invalid_argument(
        "mesh must have vertices of shape (N, 3) and triangles of shape (M, 3)");
  }
  return {to_points3(rows, "vertices"), to_triangles(faces, "triangles")};
}

void bind_object(py::module_& m) {
  py::class_<Face>(m, "Face", "Planar face of an object.")
      .def_property_readonly("n_O", shown(&Face::n_O),
                             "(3,) unit normal in O, pointing into the object.")
      .def_property_readonly("first_O", shown(&Face::first_O),
                             "(3,) unit vector of the first grid axis, along the face, in O.")
      .def_property_readonly("second_O", shown(&Face::second_O),
                             "(3,) unit vector of the second grid axis, n_O x first_O.")
      .def_readonly("offset", &Face::offset, "n_O . p of the points p on the face [m].")
      .def_readonly("triangles", &Face::triangles,
                    "Row indices of the face's triangles in the mesh.")
      .def_readonly("area", &Face::area, "Area [m^2].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"n_O", "offset", "area"});
      });

  py::class_<Object>(m, "Object",
                     "Rigid polyhedron to be moved: any closed mesh, in a frame O of your choice.")
      .def_static(
          "box",
          [](const std::string& name, const Array& size, double mass) {
            return Object::box(name, to_vector3(size, "size"), mass);
          },
          py::arg("name"), py::arg("size"), py::arg("mass"),
          "Creates a box of uniform density, centred at O.\n\n"
          "Parameters\n"
          "----------\n"
          "name : str\n"
          "    Name in error messages and pictures.\n"
          "size : (3,) array\n"
          "    Side lengths along the axes of O [m].\n"
          "mass : float\n"
          "    Mass [kg].\n\n"
          "Raises\n"
          "------\n"
          "ValueError\n"
          "    A length or the mass is not positive.")
      .def_static(
          "from_mesh",
          [](const std::string& name, const py::object& mesh, double mass) {
            const geometry::Mesh read = to_mesh(mesh);
            const py::gil_scoped_release release;
            return Object::from_mesh(name, read, mass);
          },
          py::arg("name"), py::arg("mesh"), py::arg("mass"),
          "Creates an object of uniform density from a closed mesh.\n\n"
          "Parameters\n"
          "----------\n"
          "name : str\n"
          "    Name in error messages and pictures.\n"
          "mesh : geometry.Mesh, trimesh.Trimesh, or pair of arrays (N, 3) and (M, 3)\n"
          "    Vertices in O [m] and triangles.\n"
          "mass : float\n"
          "    Mass [kg].\n\n"
          "Raises\n"
          "------\n"
          "ValueError\n"
          "    The mesh is not closed, has no volume or has too many triangles.")
      .def(
          "with_com",
          [](const Object& self, const Array& com_O) {
            return self.with_com(to_vector3(com_O, "com_O"));
          },
          py::arg("com_O"), "Returns a copy with another centre of mass, (3,) in O [m].")
      .def(
          "with_inertia",
          [](const Object& self, const Array& inertia_O) {
            return self.with_inertia(to_matrix3(inertia_O, "inertia_O"));
          },
          py::arg("inertia_O"),
          "Returns a copy with another inertia about its centre of mass, (3, 3) in O [kg m^2].")
      .def_property_readonly("name", &Object::name, "Name in error messages and pictures.")
      .def_property_readonly("mesh", shown(&Object::mesh),
                             "Closed mesh with outward triangles, in O [m].")
      .def_property_readonly("faces", &Object::faces,
                             "Faces. Coplanar neighbouring triangles form one face.")
      .def_property_readonly("hull", shown(&Object::hull),
                             "(N, 3) vertices of the convex hull, in O [m].")
      .def_property_readonly("is_convex", &Object::is_convex, "True if the object is convex.")
      .def_property_readonly("mass", &Object::mass, "Mass [kg].")
      .def_property_readonly("com", shown(&Object::com), "(3,) centre of mass in O [m].")
      .def_property_readonly("inertia", shown(&Object::inertia),
                             "(3, 3) inertia about the centre of mass, in O [kg m^2].")
      .def_property_readonly("size", &Object::size, "Diagonal of the bounding box [m].")
      .def("__repr__", [](const Object& self) {
        return "<Object '" + self.name() + "' of " + std::to_string(self.faces().size()) +
               " faces>";
      });
}

void bind_surroundings(py::module_& m) {
  using Friction = Python<std::optional<Interval>>;
  py::class_<Plane>(
      m, "Plane",
      "Solid half-space that the object may touch and fingertips may not: a floor or a wall.")
      .def(py::init([](const std::string& name, const Array& n_W, double offset,
                       const Friction::Given& friction) {
             return Plane{name, to_vector3(n_W, "n_W"), offset,
                          Friction::from(friction, "friction")};
           }),
           py::arg("name") = "floor", Python<Eigen::Vector3d>::arg("n_W", Plane{}.n_W),
           py::arg("offset") = 0.0, py::arg("friction") = py::none(),
           "Parameters\n"
           "----------\n"
           "name : str\n"
           "    Name in error messages.\n"
           "n_W : (3,) array\n"
           "    Unit normal in the world, pointing out of the solid.\n"
           "offset : float\n"
           "    n_W . p of the points p on its surface [m].\n"
           "friction : float or (lower, upper), optional\n"
           "    Coefficient of friction with the object. By default it is that of the problem,\n"
           "    which all such planes share. The coefficient of a plane with its own interval\n"
           "    varies independently.")
      .def_readonly("name", &Plane::name, "Name in error messages and pictures.")
      .def_property_readonly("n_W", shown(&Plane::n_W),
                             "(3,) unit normal in the world, pointing out of the solid.")
      .def_readonly("offset", &Plane::offset, "n_W . p of the points p on its surface [m].")
      .def_property_readonly(
          "friction", shown(&Plane::friction),
          "(lower, upper) coefficient of friction with the object; None: that of the problem.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"name", "n_W", "offset", "friction"});
      });

  py::class_<Fingers> fingers(
      m, "Fingers", "Fingertips: equal spheres in one-point contact that neither slide nor roll.");
  bind_fields(
      fingers, "Any field by keyword; the others keep their defaults.",
      Field{"count", &Fingers::count, "Number of fingers, 1 to 4."},
      Field{"radius", &Fingers::radius, "Radius [m]."},
      Field{"max_normal_force", &Fingers::max_normal_force,
            "Upper limit f_max of each finger's normal force [N]."},
      Field{"friction", &Fingers::friction,
            "Coefficient of friction between fingertip and object: a number, or (lower, upper)."},
      Field{"max_span", &Fingers::max_span,
            "Largest distance between the centres of two fingertips [m]."},
      Field{"start", &Fingers::start,
            "Contact point of each finger at the start, (3,) in O [m]; empty: anywhere."});
}

void bind_motion(py::module_& m) {
  py::class_<Path>(
      m, "Path",
      "Poses that the object passes through. It moves along a screw from each pose to the next.")
      .def(py::init([](const Array& X_WO) { return Path{to_poses(X_WO, "X_WO")}; }),
           py::arg("X_WO"), "X_WO: (K, 4, 4) poses of O in the world, two or more.")
      .def_property_readonly("X_WO", shown(&Path::X_WO), "(K, 4, 4) poses of O in the world.")
      .def(
          "__len__", [](const Path& self) { return self.X_WO.size(); }, "Number of poses.")
      .def("__repr__", [](const Path& self) {
        return "<Path of " + std::to_string(self.X_WO.size()) + " poses>";
      });

  py::class_<Lattice> lattice(
      m, "Lattice",
      "Motion on the floor from start to goal through a lattice of positions and yaws.");
  bind_fields(
      lattice, "Any field by keyword; the others keep their defaults.",
      Field{"X_WO_start", &Lattice::X_WO_start, "(4, 4) pose of O in the world."},
      Field{"X_WO_goal", &Lattice::X_WO_goal, "(4, 4) pose of O in the world."},
      Field{"lower", &Lattice::lower, "(3,) least x, y, yaw relative to the start [m, m, rad]."},
      Field{"upper", &Lattice::upper, "(3,) largest x, y, yaw relative to the start [m, m, rad]."},
      Field{"counts", &Lattice::counts, "Numbers of values of x, y and yaw."});

  py::class_<Goal> goal(
      m, "Goal",
      "Goal pose of the object, on any face. The planner finds the slides, turns and tumbles.");
  bind_fields(goal, "Any field by keyword; the others keep their defaults.",
              Field{"X_WO_start", &Goal::X_WO_start, "(4, 4) pose of O in the world."},
              Field{"X_WO_goal", &Goal::X_WO_goal, "(4, 4) pose of O in the world."},
              Field{"slide_step", &Goal::slide_step, "Longest step of a slide [m]."},
              Field{"turn_step", &Goal::turn_step, "Largest step of a turn or a tumble [rad]."},
              Field{"max_tumbles", &Goal::max_tumbles, "Maximum number of tumbles."});

  m.def(
      "slide_path",
      [](const Array& X_WO_start, const Array& translation_W, int segments) {
        return slide_path(to_pose(X_WO_start, "X_WO_start"),
                          to_vector3(translation_W, "translation_W"), segments);
      },
      py::arg("X_WO_start"), py::arg("translation_W"), py::arg("segments"),
      "Returns a straight slide from X_WO_start, (4, 4), by translation_W, (3,) in the world [m], "
      "in equal\n"
      "segments.");
  m.def(
      "turn_path",
      [](const Array& X_WO_start, const Array& point_W, const Array& axis_W, double angle,
         int segments) {
        return turn_path(to_pose(X_WO_start, "X_WO_start"), to_vector3(point_W, "point_W"),
                         to_vector3(axis_W, "axis_W"), angle, segments);
      },
      py::arg("X_WO_start"), py::arg("point_W"), py::arg("axis_W"), py::arg("angle"),
      py::arg("segments"),
      "Returns a tumble over an edge or a turn on the floor, in equal segments.\n\n"
      "It starts at X_WO_start, (4, 4), and turns by angle [rad, right-handed] about the line "
      "through\n"
      "point_W [m] along axis_W, both (3,) in the world.");
  m.def("join", &join, py::arg("paths"),
        "Joins paths into one. Each must start where the one before it ends.");
}

void bind_problem(py::module_& m) {
  using Friction = Python<Interval>;
  py::class_<Problem>(
      m, "Problem", "Task of the planner: bring an object through a motion with fingertips alone.")
      .def(py::init([](const Object& object, const Motion& motion, const Fingers& fingers,
                       const std::vector<Plane>& planes, const Friction::Given& friction,
                       const std::vector<Obstacle>& obstacles, const Array& gravity_W) {
             return Problem{object,
                            fingers,
                            planes,
                            Friction::from(friction, "friction"),
                            motion,
                            obstacles,
                            to_vector3(gravity_W, "gravity_W")};
           }),
           py::kw_only(), py::arg("object"), py::arg("motion"),
           py::arg_v("fingers", Fingers{}, "Fingers()"),
           py::arg_v("planes", std::vector<Plane>{Plane{}}, "[Plane()]"),
           Friction::arg("friction", {}), py::arg("obstacles") = std::vector<Obstacle>{},
           py::arg_v("gravity_W", Array(py::cast(Eigen::Vector3d(0, 0, -9.8))), "[0, 0, -9.8]"),
           "planes: the floor first, then walls. friction: coefficient between object and planes, "
           "a number or\n"
           "(lower, upper); a plane may have its own. gravity_W: (3,) acceleration of gravity in "
           "the\n"
           "world [m/s^2].")
      .def_property_readonly("object", shown(&Problem::object), "Object to move.")
      .def_property_readonly("fingers", shown(&Problem::fingers), "A copy of the fingers.")
      .def_readonly("planes", &Problem::planes, "The floor first, then walls.")
      .def_property_readonly(
          "friction", shown(&Problem::friction),
          "(lower, upper) coefficient of friction between object and planes without their own.")
      .def_property_readonly("motion", shown(&Problem::motion), "A Path, Lattice or Goal; a copy.")
      .def_readonly("obstacles", &Problem::obstacles, "Obstacles in the world.")
      .def_property_readonly("gravity_W", shown(&Problem::gravity_W),
                             "(3,) acceleration of gravity in the world [m/s^2].")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"object", "fingers", "planes", "friction", "motion", "obstacles"});
      });
}

/// The numbers of a finger in a row of an array: touches, p_OC, n_O, is in force control,
/// commanded_force, nominal_force_O.
using FingerNumbers = Eigen::Matrix<double, 12, 1>;

FingerNumbers to_numbers(const FingerState& finger) {
  FingerNumbers numbers;
  numbers << finger.touches, finger.p_OC, finger.n_O, finger.mode == mechanics::FingerMode::force,
      finger.commanded_force, finger.nominal_force_O;
  return numbers;
}

FingerState from_numbers(const FingerNumbers& numbers) {
  const bool is_force = numbers[7] != 0;
  return {numbers[0] != 0,
          numbers.segment<3>(1),
          numbers.segment<3>(4),
          is_force ? mechanics::FingerMode::force : mechanics::FingerMode::position,
          numbers[8],
          numbers.segment<3>(9)};
}

/// Rows as arrays: their poses [N, 4, 4], their margins [N, 5], their fingers [N, n, 12].
std::tuple<Array, Array, Array> to_arrays(const Segment& segment) {
  const auto N = static_cast<py::ssize_t>(segment.rows.size());
  const auto n = N == 0 ? 0 : static_cast<py::ssize_t>(segment.rows[0].fingers.size());
  Array margins({N, py::ssize_t{5}}), fingers({N, n, py::ssize_t{12}});
  double* margin = margins.mutable_data();
  double* number = fingers.mutable_data();
  Poses poses;
  for (const Row& row : segment.rows) {
    if (static_cast<py::ssize_t>(row.fingers.size()) != n) {
      throw std::invalid_argument("rows of segment '" + segment.name +
                                  "' must have the same number of fingers");
    }
    poses.push_back(row.X_WO);
    for (const double z : {row.stability, row.compliant_stability, row.nominal_margin,
                           row.withstands, row.place_tolerance}) {
      *margin++ = z;
    }
    for (const FingerState& finger : row.fingers) {
      number = std::copy_n(to_numbers(finger).data(), 12, number);
    }
  }
  return {from_poses(poses), margins, fingers};
}

/// Rows of the arrays of to_arrays().
std::vector<Row> from_arrays(const Array& object_poses, const Array& margins,
                             const Array& fingers) {
  const Poses poses = to_poses(object_poses, "object_poses");
  const auto N = static_cast<py::ssize_t>(poses.size());
  if (margins.ndim() != 2 || margins.shape(0) != N || margins.shape(1) != 5) {
    throw std::invalid_argument("margins must have shape (N, 5)");
  }
  if (fingers.ndim() != 3 || fingers.shape(0) != N || fingers.shape(2) != 12) {
    throw std::invalid_argument("fingers must have shape (N, n, 12)");
  }
  std::vector<Row> rows;
  for (py::ssize_t i = 0; i < N; ++i) {
    Row row{poses[static_cast<std::size_t>(i)],
            {},
            margins.at(i, 0),
            margins.at(i, 1),
            margins.at(i, 2),
            margins.at(i, 3),
            margins.at(i, 4)};
    for (py::ssize_t k = 0; k < fingers.shape(1); ++k) {
      row.fingers.push_back(from_numbers(Eigen::Map<const FingerNumbers>(fingers.data(i, k, 0))));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

void bind_rows(py::module_& m) {
  py::class_<FingerState> finger(m, "FingerState", "State of a finger at one instant.");
  bind_fields(finger, "Any field by keyword; the others keep their defaults.",
              Field{"touches", &FingerState::touches, "False while the finger regrasps."},
              Field{"p_OC", &FingerState::p_OC, "(3,) contact point in O [m]."},
              Field{"n_O", &FingerState::n_O, "(3,) unit normal in O, pointing into the object."},
              Field{"mode", &FingerState::mode, "Control mode: position or force."},
              Field{"commanded_force", &FingerState::commanded_force,
                    "Commanded normal force f_com in force control, else 0 [N]."},
              Field{"nominal_force_O", &FingerState::nominal_force_O,
                    "(3,) nominal force on the object, in O, for feed-forward [N]."});

  py::class_<Row> row(m, "Row", "One instant of a plan: a sample of an arc, or a regrasp.");
  bind_fields(
      row, "Any field by keyword; the others keep their defaults.",
      Field{"X_WO", &Row::X_WO, "(4, 4) pose of O in the world."},
      Field{"fingers", &Row::fingers, "One FingerState for each finger."},
      Field{"stability", &Row::stability,
            "Stability z [N]. If friction is an interval, it is the least over the "
            "evaluated coefficients; for\n"
            "the whole interval, only min_stability is proven."},
      Field{"compliant_stability", &Row::compliant_stability,
            "Margin by mechanics.compliant_stability [N]."},
      Field{"nominal_margin", &Row::nominal_margin,
            "Margin of the nominal forces, as in mechanics.Equilibrium [N]."},
      Field{"withstands", &Row::withstands,
            "Largest disturbance that the row withstands while fingers are in their places, "
            "by\nmechanics.withstands [N]."},
      Field{"place_tolerance", &Row::place_tolerance,
            "Error of every finger's place that the row tolerates, by\n"
            "mechanics.place_tolerance [m]."});

  m.def("_rows", &from_arrays, py::arg("object_poses"), py::arg("margins"), py::arg("fingers"),
        "Returns rows: poses (N, 4, 4), margins (N, 5), and 12 numbers per finger (N, n, 12).");
  py::class_<Segment>(m, "Segment",
                      "Part of the plan during which no finger changes its place, or one regrasp.")
      .def(py::init([](const std::string& name, const Array& X_WO, const std::vector<Row>& rows,
                       int finger) {
             return Segment{name, to_poses(X_WO, "X_WO"), rows, finger};
           }),
           py::arg("name"), py::arg("X_WO"), py::arg("rows"), py::arg("finger") = -1,
           "X_WO: (K, 4, 4) poses of the lattice, first to last. rows: instants. finger: index of "
           "the finger\n"
           "that regrasps.")
      .def("_to_arrays", &to_arrays,
           "Returns object_poses, margins and fingers as _rows() takes them.")
      .def_readonly("name", &Segment::name, "slide, turn, tumble or regrasp.")
      .def_property_readonly("X_WO", shown(&Segment::X_WO),
                             "(K, 4, 4) poses of the lattice in the world, first to last.")
      // Copies: a segment that keeps its rows, and is kept by them, would never be freed.
      .def_property_readonly("rows", shown(&Segment::rows), "Instants, in order.")
      .def_readonly("finger", &Segment::finger,
                    "Index of the finger that regrasps; -1 for a motion of the object.")
      .def(
          "__len__", [](const Segment& self) { return self.rows.size(); }, "Number of rows.")
      .def("__repr__", [](const Segment& self) {
        return "<Segment '" + self.name + "' of " + std::to_string(self.rows.size()) + " rows>";
      });
}

void bind_statistics(py::module_& m) {
  bind_statistics_struct<Statistics>(m);
  py::class_<Relaxation> relaxation(
      m, "Relaxation", "Smallest change of one parameter that makes a failed search succeed.");
  bind_fields(
      relaxation, "Any field by keyword; the others keep their defaults.",
      Field{"field", &Relaxation::field,
            "Name of the parameter: fingers.friction, fingers.max_normal_force, friction,\n"
            "planes[1] 'wall'.friction and the like, or "
            "min_stability."},
      Field{"value", &Relaxation::value, "Value nearest to the given one that helps, to 1 %."});
}

void bind_plan(py::module_& m) {
  bind_choices<Status>(m, "Status", "Outcome of a query.");
  bind_plan_class<Plan>(
      m, {"status", "reason", "cost", "regrasps", "segments"},
      Field{"cost", &Plan::cost, "Cost by Eqs. (9) and (10) [m]."},
      Field{"lower_bound", &Plan::lower_bound,
            "Lower bound on the cost of every plan on this lattice [m]; equals `cost` if the "
            "plan is optimal."},
      Field{"regrasps", &Plan::regrasps, "Number of regrasps."},
      Field{"withstands", &Plan::withstands, "Largest disturbance that every row withstands [N]."},
      Field{"place_tolerance", &Plan::place_tolerance,
            "Error of every finger's place that every row tolerates [m]."},
      Field{"segments", &Plan::segments, "Motions and regrasps, in order."},
      Field{"warnings", &Plan::warnings, "Warnings about the plan."},
      Field{"weakest_segment", &Plan::weakest_segment,
            "Index of the segment of least stability; -1 without a plan."},
      Field{"weakest_row", &Plan::weakest_row,
            "Index of the row of least stability in that segment; -1 without a plan."},
      Field{"limit", &Plan::limit, "Obstacles to a plan, if not solved."},
      Field{"relaxations", &Plan::relaxations, "Single changes that would help, if not solved."});
}

void bind_realization(py::module_& m) {
  py::class_<Carrier> carrier(m, "Carrier", "Parts of a robot that carry the fingertips.");
  bind_fields(
      carrier, "Any field by keyword; the others keep their defaults.",
      Field{"fingertips", &Carrier::fingertips,
            "Frames at the centres of the spheres, one for each finger."},
      Field{"links", &Carrier::links, "Links that may touch the object, for each fingertip."});
  bind_options_struct<RealizeOptions>(m, "RealizeOptions", "Options of realize().");

  bind_segment_class<JointSegment>(
      m, "approach, touch, slide, turn, tumble, release, reach or retreat.", "JointSegment",
      "Part of a joint motion.")
      .def(py::init([](const std::string& name, const Array& positions, const Array& X_WO,
                       int plan_segment, double scrub) {
             return with_equal_rows(JointSegment{name, to_configurations(positions, "positions"),
                                                 to_poses(X_WO, "X_WO"), plan_segment, scrub},
                                    &JointSegment::X_WO, "X_WO");
           }),
           py::arg("name"), py::arg("positions"), py::arg("X_WO"), py::arg("plan_segment") = -1,
           py::arg("scrub") = 0.0,
           "positions: (N, dof) [rad or m]. X_WO: (N, 4, 4) poses of O in the world.")
      .def_property_readonly("X_WO", shown(&JointSegment::X_WO),
                             "(N, 4, 4) pose of O in the world at each row.")
      .def_readonly("plan_segment", &JointSegment::plan_segment,
                    "Index of the plan's segment that it carries out, or -1.")
      .def_readonly("scrub", &JointSegment::scrub,
                    "Largest distance by which a turning fingertip slips on its contact [m].");

  py::class_<Realization> found(
      m, "Realization",
      "Joint paths that carry a plan's fingertips, or the reason why there are none.");
  bind_fields(
      found, "Any field by keyword; the others keep their defaults.",
      Field{"found", &Realization::found, "True if there are joint paths."},
      Field{"reason", &Realization::reason, "Segment, row and finger that fail, and the reason."},
      Field{"joint_names", &Realization::joint_names,
            "Names of the joints, in the order of the columns of positions."},
      Field{"finger_of_fingertip", &Realization::finger_of_fingertip,
            "Index of the plan's finger for each fingertip."},
      Field{"segments", &Realization::segments, "Parts of the joint motion, in order."});
  found.def(
      "__bool__", [](const Realization& self) { return static_cast<bool>(self); },
      "True if there are joint paths.");
}

void bind_resume(py::module_& m) {
  m.def(
      "resume",
      [](const Problem& problem, const Plan& plan, int segment, const Array& X_WO,
         const Options& options, const StoppableBudget& budget) {
        const Eigen::Isometry3d X = to_pose(X_WO, "X_WO");
        Rest rest = run_interruptibly(
            budget, [&problem, plan, segment, X, options](const planning::Budget& b) {
              return resume(problem, plan, segment, X, options, b);
            });
        return std::make_pair(std::move(rest.problem), std::move(rest.plan));
      },
      py::arg("problem"), py::arg("plan"), py::arg("segment"), py::arg("X_WO"), py::arg("options"),
      py::arg("budget"),
      "Plans the rest of a plan from a measured pose of the object, with the fingers where they "
      "are.\n\nReturns the rest as a problem of its own, and its plan. A state from which the plan "
      "does not go on is a status.\n\nRaises ValueError on a bad problem, plan, segment, pose or "
      "options.");
}

/// Binds a function that judges joint paths. It runs without the GIL, on copies of what Python
/// could change meanwhile.
template <typename Result>
void bind_judge(py::module_& m, const char* name,
                Result (*judge)(const Problem&, const Plan&, const robot::Robot&, const Carrier&,
                                const Realization&, const RealizeOptions&),
                const char* doc) {
  m.def(
      name,
      [judge](const Problem& problem, const Plan& plan, const robot::Robot& robot,
              const Carrier& carrier, const Realization& realization,
              const RealizeOptions& options) {
        const Plan plan_now = plan;
        const Carrier carrier_now = carrier;
        const Realization realization_now = realization;
        const RealizeOptions options_now = options;
        const py::gil_scoped_release release;
        return judge(problem, plan_now, robot, carrier_now, realization_now, options_now);
      },
      py::arg("problem"), py::arg("plan"), py::arg("robot"), py::arg("carrier"),
      py::arg("realization"), py::arg_v("options", RealizeOptions{}, "RealizeOptions()"), doc);
}

void bind_planner(py::module_& m) {
  const py::arg_v default_budget("budget", StoppableBudget{}, "Budget()");
  bind_front_door<Problem, Options, Plan>(
      m,
      "Plans the places, control modes and regrasps of the fingers (Maeda, Arai 2005, Section "
      "4).\n\n"
      "Finding no plan is a status, not an error.",
      "Checks a plan: derives every row anew from its problem, without the code of the search.");
  m.def(
      "validate",
      [](const Problem& problem, const Options& options) {
        const Options now = options;
        const py::gil_scoped_release release;
        validate(problem, now);
      },
      py::arg("problem"), py::arg("options"), "Raises ValueError like the other two.");
  const py::arg_v default_realize("options", RealizeOptions{}, "RealizeOptions()");
  const py::arg_v default_realize_options("realize_options", RealizeOptions{}, "RealizeOptions()");
  m.def(
      "realize",
      [](const Problem& problem, const Plan& plan, const robot::Robot& robot,
         const Carrier& carrier, const Array& q_home, const RealizeOptions& options,
         const StoppableBudget& budget) {
        const Eigen::VectorXd q = to_configuration(robot, q_home, "q_home");
        return run_interruptibly(
            budget, [&problem, &robot, plan, carrier, q, options](const planning::Budget& b) {
              return realize(problem, plan, robot, carrier, q, options, b);
            });
      },
      py::arg("problem"), py::arg("plan"), py::arg("robot"), py::arg("carrier"), py::arg("q_home"),
      default_realize, default_budget,
      "Finds joint paths of a robot that carry a plan's fingertips.\n\n"
      "They lead from q_home to the first grip, through every row and regrasp, and away. Failure "
      "to find\n"
      "them is a Realization with a reason, not an error. Releases the GIL: other Python threads "
      "can run.\n"
      "Ctrl-C raises KeyboardInterrupt.\n\n"
      "Parameters\n"
      "----------\n"
      "problem : Problem\n"
      "plan : Plan\n"
      "    Solved plan of the problem.\n"
      "robot : robot.Robot\n"
      "carrier : Carrier\n"
      "    Parts of the robot that carry the fingertips.\n"
      "q_home : (dof,) array\n"
      "    Configuration at the start [rad or m].\n"
      "options : RealizeOptions, optional\n"
      "budget : planning.Budget, optional\n\n"
      "Returns\n"
      "-------\n"
      "Realization\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    A frame is unknown, the home lies outside the joint limits, or the plan is not solved.");
  m.def(
      "plan_carried",
      [](const Problem& problem, const Options& options, const robot::Robot& robot,
         const Carrier& carrier, const Array& q_home, const RealizeOptions& realize_options,
         const StoppableBudget& budget) {
        const Eigen::VectorXd q = to_configuration(robot, q_home, "q_home");
        CarriedPlan found = run_interruptibly(budget, [&problem, options, &robot, carrier, q,
                                                       realize_options](const planning::Budget& b) {
          return plan_carried(problem, options, robot, carrier, q, realize_options, b);
        });
        return std::make_pair(std::move(found.plan), std::move(found.realization));
      },
      py::arg("problem"), py::arg("options"), py::arg("robot"), py::arg("carrier"),
      py::arg("q_home"), default_realize_options, default_budget,
      "Plans the fingertips and the joint paths that carry them.\n\n"
      "If the robot cannot carry the best plan out, plans whose fingertips are nearer together are "
      "tried.\n"
      "A plan that is not the best has a warning. If there are joint paths for none, the best plan "
      "is\n"
      "returned with the status not_realized. Releases the GIL: other Python threads can run. "
      "Ctrl-C\n"
      "raises KeyboardInterrupt.\n\n"
      "Parameters\n"
      "----------\n"
      "problem : Problem\n"
      "options : Options\n"
      "robot : robot.Robot\n"
      "carrier : Carrier\n"
      "    Parts of the robot that carry the fingertips.\n"
      "q_home : (dof,) array\n"
      "    Configuration at the start [rad or m].\n"
      "realize_options : RealizeOptions, optional\n"
      "budget : planning.Budget, optional\n\n"
      "Returns\n"
      "-------\n"
      "(Plan, Realization)\n\n"
      "Raises\n"
      "------\n"
      "ValueError\n"
      "    As plan() and realize() do.");
  bind_judge<std::vector<std::string>>(
      m, "check_realization", check,
      "Checks joint paths against problem and plan: limits, steps, fingertips, collisions.\n\n"
      "Returns one fault per entry; an empty list if the paths are valid.");
  bind_judge<scene::EdgeCertificate>(
      m, "certify_realization", certify,
      "Proves what check_realization() samples between the rows: nothing touches that may "
      "not, and the fingertips keep their tolerances.\n\n"
      "Returns a scene.EdgeCertificate. Raises ValueError if the paths were not found or are "
      "malformed.");
}

}  // namespace

void bind_fingertip(py::module_ m) {
  bind_object(m);
  bind_surroundings(m);
  bind_motion(m);
  bind_problem(m);
  bind_choices<Search>(
      m, "Search", "Search algorithms. All find the same cost, except on lattices with regrasps.");
  bind_options_struct<Options>(m, "Options", "Options of the search.");
  bind_rows(m);
  bind_statistics(m);
  bind_plan(m);
  bind_realization(m);
  bind_planner(m);
  bind_resume(m);
}

}  // namespace graspless::bindings
