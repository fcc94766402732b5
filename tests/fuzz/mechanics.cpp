// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <sstream>

#include <Eigen/Geometry>

#include "graspless/mechanics/equilibrium.hpp"
#include "graspless/mechanics/stability.hpp"

#include "fuzz/targets.hpp"

namespace graspless::fuzz {
namespace {

using namespace mechanics;

/// A unit vector along an axis, between axes, or anywhere.
Eigen::Vector3d normal(Bytes& bytes) {
  const Eigen::Vector3d n = bytes.vector(-1, 1);
  return n.norm() > 1e-3 && n.allFinite() ? n.normalized() : n;
}

template <typename Touch>
void draw_touch(Bytes& bytes, Touch& touch) {
  touch.p_OC = bytes.vector(-1, 1);
  touch.n_O = normal(bytes);
  touch.friction = bytes.number(0, 1);
  if (bytes.chance(2)) touch.t_O = bytes.vector(-1, 1);
}

ContactSet contact_set(Bytes& bytes) {
  ContactSet set;
  set.contacts.resize(static_cast<std::size_t>(bytes.whole(0, 6)));
  for (Contact& contact : set.contacts) {
    draw_touch(bytes, contact);
    if (bytes.chance(3)) contact.mode = ContactMode::slide;
  }
  set.fingers.resize(static_cast<std::size_t>(bytes.whole(0, 3)));
  for (Finger& finger : set.fingers) {
    draw_touch(bytes, finger);
    finger.max_normal_force = bytes.number(1, 20);
  }
  set.com_O = bytes.vector(-0.5, 0.5);
  set.known_wrench_O.head<3>() = bytes.vector(-10, 10);
  if (bytes.chance(4)) set.known_wrench_O.tail<3>() = bytes.vector(-10, 10);
  if (bytes.chance(2)) {
    set.wrench_scale = wrench_scale(bytes.number(0.1, 10), bytes.vector(0.1, 0.2).asDiagonal());
  }
  set.cone_edges = bytes.whole(3, 8);
  return set;
}

std::vector<FingerMode> finger_modes(Bytes& bytes, std::size_t count) {
  std::vector<FingerMode> modes(count);
  for (FingerMode& mode : modes) {
    mode = bytes.chance(2) ? FingerMode::force : FingerMode::position;
  }
  return modes;
}

/// Largest force or scaled moment that can act on the object.
double largest_wrench(const ContactSet& set) {
  double largest = (set.wrench_scale * set.known_wrench_O).cwiseAbs().maxCoeff();
  for (const Finger& finger : set.fingers) {
    const double arm = 1 + (finger.p_OC - set.com_O).norm();
    largest =
        std::max(largest, finger.max_normal_force * arm * set.wrench_scale.cwiseAbs().maxCoeff());
  }
  return largest;
}

void require_valid(const Stability& stability, const ContactSet& set) {
  require(stability.z >= 0, "z is a number of 0 or more");
  require(stability.commanded_forces.allFinite(), "commanded forces are finite");
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    const double force = stability.commanded_forces[static_cast<Eigen::Index>(i)];
    require(force >= 0 && force <= set.fingers[i].max_normal_force * (1 + 1e-9),
            "commanded forces are within the limits");
  }
}

void require_engines_agree(const ContactSet& set, const std::vector<FingerMode>& modes,
                           const Matrix6Xd& directions) {
  const Stability fast = max_stability(set, modes, directions, Engine::fast);
  const Stability reference = max_stability(set, modes, directions, Engine::reference);
  require_valid(fast, set);
  require_valid(reference, set);
  const double difference = std::abs(fast.z - reference.z);
  const double slack = 1e-9 * std::max(1.0, reference.z) + 1e-12 * largest_wrench(set);
  std::ostringstream law;
  law.precision(12);
  law << "both engines give the same z, " << fast.z << " and " << reference.z;
  require(fast.z == reference.z || difference <= slack, law.str());
  require(internal_force_is_bounded(set, modes, Engine::fast) ==
              internal_force_is_bounded(set, modes, Engine::reference),
          "both engines agree whether forces are bounded");
}

void require_equilibrium(const ContactSet& set, const std::vector<FingerMode>& modes) {
  const Stability stability = max_stability(set, modes);
  const auto found = interior_equilibrium(set, modes, stability.commanded_forces);
  if (!found) return;
  require(found->contact_forces_O.allFinite() && found->finger_forces_O.allFinite(),
          "forces of an equilibrium are finite");
  require(compliant_stability(set, modes, *found) >= 0, "a compliant margin is 0 or more");
}

}  // namespace

void solve_mechanics(Bytes bytes) {
  accepts([&] {
    const ContactSet set = contact_set(bytes);
    validate(set);
    const auto modes = finger_modes(bytes, set.fingers.size());
    // Twelve directions are the axes; all of them cost the reference engine six times as much.
    const Matrix6Xd directions = disturbance_directions();
    require_engines_agree(set, modes, bytes.chance(8) ? directions : directions.leftCols(12));
    require_equilibrium(set, modes);
    best_control_modes(set);
  });
}

}  // namespace graspless::fuzz
