// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/slide.hpp"

#include "graspless/slide/resume.hpp"
#include "graspless/slide/surroundings.hpp"
#include "graspless/slide/torsion.hpp"
#include "graspless/slide/tube.hpp"

#include "conversions.hpp"
#include "fields.hpp"
#include "planning.hpp"
#include "segments.hpp"

namespace graspless::bindings {
namespace {

using namespace slide;
using geometry::Polygon;

using Outline = py::typing::Union<Polygon, Array>;

Polygon to_polygon(const Outline& given, const std::string& name) {
  if (py::isinstance<Polygon>(given)) {
    return given.cast<Polygon>();
  }
  const Array rows = Array::ensure(given);
  if (!rows) {
    throw std::invalid_argument(name + " must be a Polygon or an array of shape (N, 2)");
  }
  return Polygon(to_points2(rows, name), name);
}

void bind_object(py::module_& m) {
  py::class_<Object>(
      m, "Object",
      "An object that lies or stands on a support: a prism over its outline. Slides take "
      "thin ones only.\n\nIts frame O has z up, the underside in the plane z = 0.")
      .def_static(
          "from_polygon",
          [](const std::string& name, const Outline& outline, double thickness, double spacing) {
            return Object::from_polygon(name, to_polygon(outline, "outline"), thickness, spacing);
          },
          py::arg("name"), py::arg("outline"), py::arg("thickness"), py::arg("spacing") = 0.006,
          "Creates an object from its outline, a Polygon or (N, 2) in O [m], and its thickness "
          "[m].\n\n"
          "Contact points form a grid of `spacing` [m]. The centre of mass is the centroid of the "
          "outline, at half the thickness. The mass is 0.05 kg: see with_mass.\n\nRaises "
          "ValueError on a bad outline, or on a "
          "thickness over three quarters of the object's width.")
      .def_static(
          "prism",
          [](const std::string& name, const Outline& outline, double thickness, double spacing) {
            return Object::prism(name, to_polygon(outline, "outline"), thickness, spacing);
          },
          py::arg("name"), py::arg("outline"), py::arg("thickness"), py::arg("spacing") = 0.006,
          "Creates an object of any height, which may be pinched. Arguments as those of "
          "from_polygon.\n\nRaises ValueError on a bad outline or thickness.")
      .def_static(
          "from_cloud",
          [](const std::string& name, const Array& p_OP, double thickness) {
            const Eigen::Matrix3Xd points = to_points3(p_OP, "p_OP");
            const py::gil_scoped_release release;
            return Object::from_cloud(name, points, thickness);
          },
          py::arg("name"), py::arg("p_OP"), py::arg("thickness") = 0.0,
          "Creates an object from points on its top surface, (N, 3) in O [m]: P_o of Hang et al. "
          "2019, Section IV-A. The thickness [m] is their median height unless given. The centre "
          "of mass is their mean, at half the thickness. The mass is 0.05 kg: see with_mass.\n\n"
          "Raises ValueError if there are fewer than three points, if they are not finite or lie "
          "on a line, or if the object is not thin.")
      .def_property_readonly("name", &Object::name, "Name in errors and pictures.")
      .def_property_readonly("points", shown(&Object::points),
                             "(N, 2) contact points, x-y in O [m].")
      .def_property_readonly("outline", shown(&Object::outline), "Polygon in O [m].")
      .def_property_readonly("is_thin", &Object::is_thin,
                             "True if the thickness is at most three quarters of the least width.")
      .def_property_readonly("thickness", &Object::thickness,
                             "Thickness, that of the highest part [m].")
      .def_property_readonly(
          "top", &Object::top,
          "Height of the face on which a finger presses [m]: the thickness of a prism, or that of "
          "the level part of the heights that has the most points.")
      .def_property_readonly("com", shown(&Object::com), "(3,) centre of mass in O [m].")
      .def_property_readonly("mass", &Object::mass, "Mass [kg]; 0.05 by default.")
      .def_property_readonly(
          "shapes", &Object::shapes,
          "PlacedShapes in O: prisms over the outline's convex parts, or columns of the "
          "heights.")
      .def(
          "with_com",
          [](const Object& self, const Array& com_O) {
            return self.with_com(to_vector3(com_O, "com_O"));
          },
          py::arg("com_O"),
          "Returns a copy with another centre of mass, (3,) in O [m].\n\nRaises ValueError outside "
          "the object: beside the convex hull of its outline, below 0 or above the thickness.")
      .def("with_mass", &Object::with_mass, py::arg("mass"),
           "Returns a copy with another mass [kg].")
      .def_property_readonly("heights", shown(&Object::heights),
                             "geometry.HeightMap of the object in O; None if it is a prism.")
      .def("with_heights", &Object::with_heights, py::arg("heights_O"),
           "Returns a copy that is as high as a geometry.HeightMap in O, and no longer a prism."
           "\n\nRaises ValueError if the map is higher than the thickness.")
      .def_property_readonly(
          "is_hollow", &Object::is_hollow,
          "True if the underside may be hollow: the object may rest on the rim of its outline "
          "alone.")
      .def("with_hollow", &Object::with_hollow, py::arg("is_hollow"),
           "Returns a copy whose underside may be hollow, or is flat.")
      .def("scaled", &Object::scaled, py::arg("scale"),
           "Returns a copy scaled in its plane. Thickness and mass stay the same.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"name", "outline", "thickness", "mass"});
      });

  m.def(
      "center_of_mass",
      [](const Array& points, const Array& masses) -> Eigen::Vector3d {
        return center_of_mass(to_points3(points, "points"), to_vector(masses, "masses"));
      },
      py::arg("points"), py::arg("masses"),
      "Returns the centre of mass, (3,) [m], of point masses at points, (N, 3) [m], with masses "
      "(N,).\n\nRaises ValueError unless the masses are not negative and have a positive sum.");
}

void bind_support(py::module_& m) {
  py::class_<Support>(
      m, "Support",
      "A flat surface to slide on: a polygon in the plane z = 0 of its frame S, z up.")
      .def(py::init([](const Outline& polygon, const Array& X_WS, double slab, double band_width,
                       double friction, const std::optional<std::vector<int>>& usable_edges) {
             return Support(to_polygon(polygon, "polygon"), to_pose(X_WS, "X_WS"), slab, band_width,
                            friction, usable_edges);
           }),
           py::arg("polygon"), py::arg("X_WS"), py::arg("slab") = 0.04,
           py::arg("band_width") = 0.06, py::arg("friction") = 0.3,
           py::arg("usable_edges") = py::none(),
           "polygon: a Polygon or (N, 2) [m]. X_WS: (4, 4) pose in the world, tilted by at most 60 "
           "degrees.\n"
           "slab: thickness of the table top [m]. band_width: width of the band along the edges "
           "where slides may end [m]. friction: coefficient of friction between object and "
           "support, in [1e-6, 10000].\n"
           "usable_edges: indices of the polygon's edges over which objects may stick out; by "
           "default "
           "all. Edge i runs from vertex i to the next, counter-clockwise.\n\nRaises ValueError "
           "that names the argument.")
      .def_property_readonly("polygon", shown(&Support::polygon),
                             "Polygon of the surface in S [m]: Q of the paper.")
      .def_property_readonly("goal_band", shown(&Support::goal_band),
                             "Band of the polygon where slides may end, in S: P_g of the paper.")
      .def_property_readonly("X_WS", shown(&Support::X_WS), "(4, 4) pose in the world.")
      .def_property_readonly("slab", &Support::slab, "Thickness of the table top [m].")
      .def_property_readonly("friction", &Support::friction,
                             "Coefficient of friction between object and support.")
      .def_property_readonly(
          "usable_edges",
          [](const Support& self) {
            py::list edges;
            for (int i = 0; i < self.polygon().size(); ++i) {
              if (self.is_usable(i)) edges.append(i);
            }
            return py::typing::Tuple<int, py::ellipsis>(py::tuple(edges));
          },
          "Indices of the polygon's edges over which objects may stick out.")
      .def_property_readonly("normal_W", &Support::normal_W,
                             "(3,) unit normal in the world, out of the surface.")
      .def_property_readonly("shapes", &Support::shapes, "PlacedShapes in S, below z = 0.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"polygon", "X_WS", "slab"});
      });
}

void bind_hand(py::module_& m) {
  bind_choices<FingerModel>(
      m, "FingerModel", "Model of how the sliding finger yields when it presses on the object.");
  bind_options_struct<Hand>(m, "Hand",
                            "Description of the hand: links, frames, groups and states of the "
                            "robot, and its sliding pad.");
}

void bind_problem(py::module_& m) {
  py::class_<Problem>(
      m, "Problem",
      "Task of the planner: slide the object to an edge of the support and grasp it there; or to "
      "X_WO_end, and leave it there.")
      .def(py::init([](const robot::Robot& robot, const Hand& hand, const Object& object,
                       const Support& support, const Array& X_WO_start, const Array& q_home,
                       const std::vector<Obstacle>& obstacles,
                       const std::optional<Array>& X_WO_end) {
             return Problem{robot,
                            hand,
                            object,
                            support,
                            to_pose(X_WO_start, "X_WO_start"),
                            obstacles,
                            to_configuration(robot, q_home, "q_home"),
                            MaybePose::from(X_WO_end, "X_WO_end")};
           }),
           py::arg("robot"), py::arg("hand"), py::arg("object"), py::arg("support"),
           py::arg("X_WO_start"), py::arg("q_home"), py::arg("obstacles") = std::vector<Obstacle>{},
           py::arg("X_WO_end") = py::none(),
           "X_WO_start: (4, 4) pose of the object, flat on the support. q_home: (dof,) "
           "configuration at the start [rad or m]. obstacles: bodies that neither arm nor object "
           "may touch. X_WO_end: (4, 4) pose at which the object is left, flat on the support; by "
           "default it is grasped over an edge.")
      .def_property_readonly("robot", shown(&Problem::robot), "Robot that moves.")
      .def_property_readonly("hand", shown(&Problem::hand), "Hand of the robot; a copy.")
      .def_property_readonly("object", shown(&Problem::object), "Thin object to slide.")
      .def_property_readonly("support", shown(&Problem::support),
                             "Surface that the object lies on.")
      .def_property_readonly("X_WO_start", shown(&Problem::X_WO_start),
                             "(4, 4) pose of the object in the world.")
      .def_property_readonly(
          "X_WO_end", shown(&Problem::X_WO_end),
          "(4, 4) pose in the world at which the object is left; None: it is grasped.")
      .def_property_readonly("q_home", shown(&Problem::q_home),
                             "(dof,) configuration at the start [rad or m].")
      .def_readonly("obstacles", &Problem::obstacles,
                    "Bodies that neither the arm nor the sliding object may touch.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"robot", "object", "support", "obstacles"});
      });
}

void bind_turning(py::module_& m) {
  py::class_<Turning> turning_class(
      m, "Turning", "Turn rates of a plan's slide, per distance that the object moves.");
  bind_fields(
      turning_class, "Sets any field by keyword; the others are zero.",
      Field{"max_turn_rate", &Turning::max_turn_rate, "Largest turn rate of the slide [rad/m]."},
      Field{"allowed_turn_rate", &Turning::allowed_turn_rate,
            "Turn rate that the pad can impose everywhere [rad/m]."},
      Field{"lag", &Turning::lag,
            "Angle by which the object may lag behind the finger in total [rad]."});
  m.def(
      "depth_band",
      [](const Hand& hand, const Options& options) {
        const DepthBand band = depth_band(hand, options);
        return std::pair(band.min, band.max);
      },
      py::arg("hand"), py::arg_v("options", Options{}, "Options()"),
      "Returns the least and the largest depth of the commanded fingertip below the object's top "
      "face [m]: those of the options, or of the finger's model.");
  m.def("validate", py::overload_cast<const Problem&, const Options&>(&validate),
        py::arg("problem"), py::arg("options"),
        "Also requires that the finger can yield by the depth, and that its shapes fit its tip "
        "frame.\n\nRaises ValueError that names the field.");
  m.def("turning", &turning, py::arg("problem"), py::arg("plan"),
        "Returns how fast a plan's slide turns, and how fast the pad's friction can turn the "
        "object.\n\nModel: ellipsoidal limit surfaces of pad and support (Howe, Cutkosky 1996).");
  m.def("tube", &tube, py::arg("problem"), py::arg("plan"),
        py::arg_v("options", Options{}, "Options()"),
        "Returns where the object can be during a plan's slide: a Tube.\n\n"
        "Model: its motion under ellipsoidal limit surfaces of pad and support (Howe, Cutkosky "
        "1996) is integrated for the friction, press, mass and centre of mass that the spreads of "
        "the options allow. Empty if there is no slide.");
}

void bind_tube(py::module_& m) {
  py::class_<Tube> tube_class(
      m, "Tube",
      "Bounds on where the object can be, relative to the plan, at each row of the slide.");
  bind_fields(tube_class, "Sets any field by keyword; the others are empty.",
              Field{"position", &Tube::position,
                    "Largest distances of the object's origin from its planned position [m]."},
              Field{"angle", &Tube::angle,
                    "Largest angles of the object from its planned orientation [rad]."});
}

void bind_interruption(py::module_& m) {
  py::class_<Interruption>(
      m, "Interruption",
      "State in which a slide was interrupted, with the finger pressed on the object.")
      .def(py::init([](const Array& q, const Array& X_WO, const std::optional<Array>& X_WO_goal) {
             return Interruption{to_vector(q, "q"), to_pose(X_WO, "X_WO"),
                                 MaybePose::from(X_WO_goal, "X_WO_goal")};
           }),
           py::arg("q"), py::arg("X_WO"), py::arg("X_WO_goal") = py::none(),
           "q: (dof,) commanded joints [rad or m]. X_WO: (4, 4) measured pose of the object in the "
           "world. X_WO_goal: (4, 4) pose at the goal of the plan that was interrupted.")
      .def_property_readonly("q", shown(&Interruption::q), "(dof,) commanded joints [rad or m].")
      .def_property_readonly("X_WO", shown(&Interruption::X_WO),
                             "(4, 4) measured pose of the object in the world.")
      .def_property_readonly(
          "X_WO_goal", shown(&Interruption::X_WO_goal),
          "(4, 4) pose of the object at the goal of the plan that was interrupted, or None.")
      .def("__repr__", [](const py::object& self) {
        return represent(self, {"q", "X_WO", "X_WO_goal"});
      });
}

void bind_surroundings(py::module_& m) {
  py::class_<Surroundings>(
      m, "Surroundings",
      "Bodies that a robot must not touch while it follows a slide: support, obstacles, and "
      "itself.\n\n"
      "Contacts between robot and object are not looked at. The object must not touch obstacles.")
      .def(py::init<const Problem&, const Options&>(), py::arg("problem"),
           py::arg_v("options", Options{}, "Options()"),
           "The finger may press on the support as deep as in a plan with these options.\n\n"
           "Raises ValueError that names the field of a bad problem.")
      .def(
          "touching",
          [](Surroundings& self, const std::string& segment, const Array& q, const Array& X_WO,
             double rise) {
            return self.touching(segment, to_vector(q, "q"), to_pose(X_WO, "X_WO"), rise);
          },
          py::arg("segment"), py::arg("q"), py::arg("X_WO"), py::arg("rise") = 0.0,
          "Returns the names of touching pairs, \"a - b\".\n\nsegment: of a plan; decides which "
          "contacts are allowed. q: (dof,) joints [rad or m]. X_WO: (4, 4) pose of the object. "
          "rise: of the support along its normal [m].\n\nRaises ValueError that names the "
          "argument.")
      .def("__repr__", [](const Surroundings& self) {
        const Problem& problem = self.problem();
        return "<Surroundings of '" + problem.object.name() + "', " +
               std::to_string(problem.obstacles.size()) + " obstacles>";
      });
}

using GoOn = Plan (*)(const Problem&, const Interruption&, const Options&, const planning::Budget&);

/// Binds a search that goes on from an interruption.
void bind_search(py::module_& m, const char* name, GoOn search, const char* text) {
  m.def(
      name,
      [search](const Problem& problem, const Interruption& at, const Options& options,
               const StoppableBudget& budget) {
        return run_interruptibly(budget,
                                 [&problem, at, options, search](const planning::Budget& b) {
                                   return search(problem, at, options, b);
                                 });
      },
      py::arg("problem"), py::arg("at"), py::arg_v("options", Options{}, "Options()"),
      py::arg_v("budget", StoppableBudget{}, "Budget()"), text);
}

void bind_resume(py::module_& m) {
  bind_search(m, "resume", resume,
              "Plans the rest of an interrupted slide, without lifting the finger: slide, lift, "
              "reach, grasp and close.\n\nA state from which no slide can go on is a status: "
              "off_support, contact_lost or start_in_collision.\n\nRaises ValueError on a bad "
              "problem, options or interruption.");
  bind_search(m, "restart", restart,
              "Plans an interrupted slide anew: retreat, approach, press, slide, lift, reach, "
              "grasp and close.\n\nA state from which no slide can begin is a status.\n\nRaises "
              "ValueError on a bad problem, options or interruption.");
}

void bind_plan(py::module_& m) {
  bind_plan_class<Plan>(
      m, {"status", "reason", "segments"},
      Field{"joint_names", &Plan::joint_names, "The robot's joints, in the order of positions."},
      Field{"resumed", &Plan::resumed,
            "Interruption from which the plan goes on; None if it begins at the problem's "
            "q_home."},
      Field{"segments", &Plan::segments, "Segments of the motion, in order."},
      Field{"max_mass", &Plan::max_mass,
            "Largest mass that the fingers bear when they lift the object [kg]. None for a problem "
            "with an end, and if a joint that must bear it has no effort limit, or one that is a "
            "placeholder: a finger would press with more than 500 N."},
      Field{"overhang", &Plan::overhang,
            "Length of the object beyond the edge at the goal [m]; 0 for a problem with an end."},
      Field{"tube", &Plan::tube,
            "Bounds on where the object can be at each row of the slide; empty: not stated."},
      Field{"warnings", &Plan::warnings, "Warnings about the plan."},
      Field{"X_WO_goal", &Plan::X_WO_goal,
            "(4, 4) pose of the object in the world after the slide."},
      Field{"X_WH_grasp", &Plan::X_WH_grasp,
            "(4, 4) pose of the grasp frame H in the world at the grasp; the identity for a "
            "problem with an end, which has no grasp."});
}

}  // namespace

void bind_slide(py::module_ m) {
  bind_object(m);
  bind_support(m);
  bind_hand(m);
  bind_problem(m);
  bind_choices<Search>(m, "Search", "Search algorithms.");
  bind_options_struct<Options>(m, "Options", "Options of the search.");
  bind_motion_segment<Segment>(m, "approach, press, slide, lift, reach, grasp, close or retreat.");
  bind_statistics_struct<Statistics>(m);
  bind_choices<Status>(m, "Status", "Outcome of a query.");
  bind_interruption(m);
  bind_tube(m);
  bind_plan(m);
  bind_turning(m);
  bind_front_door<Problem, Options, Plan>(
      m,
      "Plans the motion: approach, press, slide, lift, reach, grasp and close (Hang et al. 2019, "
      "Section IV-C).\n\nFinding no plan is a status, not an error.",
      "Checks a plan against its problem by an independent replay.");
  bind_certify<Problem, Options, Plan>(m,
                                       "nothing touches that may not, and the fingertip, its "
                                       "contact and the hand keep their bands.");
  bind_resume(m);
  bind_surroundings(m);
}

}  // namespace graspless::bindings
