// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/scene/scene.hpp"

#include "graspless/scene/link_contacts.hpp"

#include "conversions.hpp"

namespace graspless::bindings {
namespace {

using scene::Scene;
using Shapes = std::vector<geometry::PlacedShape>;

int body_index(const Scene& scene, const Key& body) {
  if (const auto* name = std::get_if<std::string>(&body)) {
    return scene.world().body(*name);
  }
  const int index = std::get<int>(body);
  if (index < 0 || index >= scene.world().num_bodies()) {
    throw std::invalid_argument("body must be the index of one of the scene's " +
                                std::to_string(scene.world().num_bodies()) + " bodies, not " +
                                std::to_string(index));
  }
  return index;
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
           "Adds a movable body that no link may touch. Returns its index in the world.")
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
          "poses", [](const Scene& self) { return from_poses(self.poses()); },
          "(num_frames, 4, 4) link poses in the world at the configuration checked last.");
}

}  // namespace

void bind_scene(py::module_ m) {
  py::class_<Scene> cls(
      m, "Scene",
      "A robot among obstacles and objects. Not thread-safe: give each thread a copy.\n\n"
      "A body is given by its name or its index in the world. Links with shapes are bodies.");
  cls.def(py::init<const robot::Robot&>(), py::arg("robot"),
          "Creates a scene with this robot alone.")
      .def(
          "__copy__", [](const Scene& self) { return Scene(self); },
          "Returns a copy that shares the shapes.")
      .def_property_readonly(
          "robot", [](const Scene& self) { return self.robot(); }, "Robot of the scene.")
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
      "samples, and those that never touch. links: indices; only pairs with one of them are "
      "tested. Raises ValueError unless 0 < samples <= 10^6 and the links exist.");
}

}  // namespace graspless::bindings
