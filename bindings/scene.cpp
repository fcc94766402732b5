// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/scene/scene.hpp"

#include "graspless/scene/certificate.hpp"
#include "graspless/scene/link_contacts.hpp"

#include "conversions.hpp"
#include "fields.hpp"

namespace graspless::bindings {
namespace {

using scene::Scene;
using Shapes = std::vector<geometry::PlacedShape>;

int body_index(const Scene& scene, const Key& body) {
  return bindings::body_index(scene.world(), body, "scene");
}

void bind_bodies(py::class_<Scene>& cls) {
  cls.def(
         "add_obstacle",
         [](Scene& self, const std::string& name, const Shapes& shapes, const Array& X_WB,
            bool touches_base) {
           return self.add_obstacle(name, shapes, to_pose(X_WB, "X_WB"), touches_base);
         },
         py::arg("name"), py::arg("shapes"), pose_arg("X_WB"), py::arg("touches_base") = true,
         "Adds a fixed body that no link may touch. Returns its index in the world.\n\nX_WB: (4, "
         "4) pose in the world. "
         "touches_base: True if the root link, and links rigid with it, may touch it.")
      .def("add_object", py::overload_cast<const std::string&, const Shapes&>(&Scene::add_object),
           py::arg("name"), py::arg("shapes"),
           "Adds a movable body that no link may touch. Returns its index in the world.\n\nIt is "
           "tested against obstacles and other objects only where `world.add_pair` says so.")
      .def(
          "move_object",
          [](Scene& self, const Key& body, const Array& X_WO) {
            self.move_object(body_index(self, body), to_pose(X_WO, "X_WO"));
          },
          py::arg("body"), py::arg("X_WO"),
          "Moves an object to the pose X_WO, (4, 4), in the world, and detaches it.")
      .def(
          "attach",
          [](Scene& self, const Key& body, const Key& link, const Array& X_LO,
             const std::vector<Key>& touching) {
            std::vector<int> links;
            for (const Key& key : touching) {
              links.push_back(frame_index(self.robot(), key, "touching"));
            }
            self.attach(body_index(self, body), frame_index(self.robot(), link, "link"),
                        to_pose(X_LO, "X_LO"), links);
          },
          py::arg("body"), py::arg("link"), py::arg("X_LO"), py::arg("touching"),
          "Lets an object move with a link, at the pose X_LO, (4, 4), in the link's frame. Links "
          "in touching may touch it meanwhile.")
      .def(
          "detach", [](Scene& self, const Key& body) { self.detach(body_index(self, body)); },
          py::arg("body"), "Detaches an object from its link; it stays where it is.")
      .def(
          "link_body",
          [](const Scene& self, const Key& link) {
            return self.link_body(frame_index(self.robot(), link, "link"));
          },
          py::arg("link"),
          "Returns the index in the world of a link's body; -1 for a link without shapes.");
}

void bind_queries(py::class_<Scene>& cls) {
  cls.def(
         "is_free",
         [](Scene& self, const Array& q) {
           return self.is_free(to_configuration(self.robot(), q, "q"));
         },
         py::arg("q"),
         "Returns True if q, (dof,) [rad or m], is within the joint limits and nothing touches.")
      .def(
          "is_free",
          [](Scene& self, const Array& q1, const Array& q2, double resolution) {
            return self.is_free(to_configuration(self.robot(), q1, "q1"),
                                to_configuration(self.robot(), q2, "q2"), resolution);
          },
          py::arg("q1"), py::arg("q2"), py::arg("resolution") = 0.01,
          "Returns True if the straight motion from q1 to q2, (dof,) [rad or m], is free, checked "
          "at joint steps of resolution [rad or m].")
      .def(
          "collision",
          [](Scene& self, const Array& q) -> std::optional<std::pair<std::string, std::string>> {
            auto names = self.collision(to_configuration(self.robot(), q, "q"));
            if (names.first.empty()) return std::nullopt;
            return names;
          },
          py::arg("q"),
          "Returns the names of the first pair that touches at q, (dof,), or None. Joint limits "
          "are not checked.")
      .def_property_readonly(
          "poses", shown(&Scene::poses),
          "(num_frames, 4, 4) link poses in the world at the configuration checked last.");
}

void bind_edge_certificate(py::module_& m) {
  using scene::EdgeCertificate, scene::Doubt;
  bind_choices<scene::Verdict>(m, "Verdict", "Reasons why an edge is not proven.");
  py::class_<Doubt>(m, "Doubt", "An edge of a plan that is not proven. str() is one sentence.")
      .def_readonly("segment", &Doubt::segment, "Name of the segment.")
      .def_readonly("row", &Doubt::row,
                    "The edge leads to this row from the one before; 0: from the last row of the "
                    "segment before.")
      .def_readonly("t", &Doubt::t, "Place on the edge: 0 at the row before, 1 at `row`.")
      .def_readonly("verdict", &Doubt::verdict, "Refuted or undecided.")
      .def_readonly("condition", &Doubt::condition,
                    "Pair of bodies that touches, or quantity that leaves its band.")
      .def_readonly(
          "amount", &Doubt::amount,
          "Refuted: depth of the collision, or how far the quantity is outside its band. "
          "Undecided: the distance that is proven for a pair, or how far the bounds reach "
          "out of the band.")
      .def_readonly("unit", &Doubt::unit, "Unit of `amount`: m or rad.")
      .def("__str__", &Doubt::text)
      .def("__repr__", [](const Doubt& self) { return "<Doubt '" + self.text() + "'>"; })
      .def(py::pickle(
          [](const Doubt& self) {
            return std::make_tuple(self.segment, self.row, self.t, self.verdict, self.condition,
                                   self.amount, self.unit);
          },
          [](const std::tuple<std::string, std::size_t, double, scene::Verdict, std::string, double,
                              std::string>& state) {
            return std::apply([](const auto&... field) { return Doubt{field...}; }, state);
          }));
  py::class_<EdgeCertificate>(
      m, "EdgeCertificate",
      "Result of a proof over the edges of a plan: straight motions in joint space from row to "
      "row. True if every edge is proven.")
      .def(py::init<>(), "A certificate of no edges.")
      .def(
          "__bool__", [](const EdgeCertificate& self) { return static_cast<bool>(self); },
          "True if every edge is proven.")
      .def_readonly("num_edges", &EdgeCertificate::num_edges, "Number of edges.")
      .def_property_readonly("num_certified", &EdgeCertificate::num_certified,
                             "Number of edges without a doubt.")
      .def_readonly("doubts", &EdgeCertificate::doubts, "Doubts in the order of the edges.")
      .def("__repr__",
           [](const EdgeCertificate& self) {
             return "<EdgeCertificate of " + std::to_string(self.num_certified()) + " of " +
                    std::to_string(self.num_edges) + " edges>";
           })
      .def(py::pickle(
          [](const EdgeCertificate& self) { return std::make_pair(self.num_edges, self.doubts); },
          [](const std::pair<std::size_t, std::vector<Doubt>>& state) {
            return EdgeCertificate{state.first, state.second};
          }));
}

}  // namespace

void bind_scene(py::module_ m) {
  bind_edge_certificate(m);
  py::class_<Scene> cls(
      m, "Scene",
      "A robot among obstacles and objects. Not thread-safe: give each thread a copy.\n\n"
      "A body is given by its name or its index in the world. Links with shapes are bodies.");
  cls.def(py::init<const robot::Robot&>(), py::arg("robot"),
          "Creates a scene with this robot alone.")
      .def(
          "__copy__", [](const Scene& self) { return Scene(self); },
          "Returns a copy that shares the shapes.")
      .def_property_readonly("robot", shown(&Scene::robot), "Robot of the scene.")
      .def_property_readonly("world", py::overload_cast<>(&Scene::world),
                             py::return_value_policy::reference_internal,
                             "World that holds the scene's bodies.")
      .def("__repr__", [](const Scene& self) {
        return "<Scene of '" + self.robot().name() + "', " +
               std::to_string(self.world().num_bodies()) + " bodies>";
      });
  bind_bodies(cls);
  bind_queries(cls);
  m.def(
      "sample_contacts",
      [](const robot::Robot& robot, int samples, std::uint64_t seed,
         const std::vector<int>& links) {
        scene::LinkContacts found = scene::sample_contacts(robot, samples, seed, links);
        return std::make_pair(std::move(found.always), std::move(found.never));
      },
      py::arg("robot"), py::arg("samples") = 10000, py::arg("seed") = 1,
      py::arg("links") = std::vector<int>{}, py::call_guard<py::gil_scoped_release>(),
      "Tests a robot's links against each other in random configurations within its limits.\n\n"
      "Returns two lists of pairs of link indices: those that touch in at least 95 % of the "
      "samples, and those for which no contact was found, neither in the samples nor, with more "
      "than three joints between the links, by minimizing their distance from twelve "
      "configurations. links: indices; only pairs with one of them are tested. Raises ValueError "
      "unless 0 < samples <= 10^6 and the links exist.");
}

}  // namespace graspless::bindings
