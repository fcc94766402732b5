// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

constexpr FingerMode kPosition = FingerMode::position, kForce = FingerMode::force;

/// The paper's cuboid, 5 x 10 x 5 and of mass 1, that slides along +x over a floor with a force or
/// a pushing finger: on its top, a little ahead of the middle, and behind in the middle.
inline ContactSet sliding_cuboid(double top_x = 5.0 / 7) {
  ContactSet set;
  const Eigen::Vector3d inertia(125.0 / 12, 50.0 / 12, 125.0 / 12);
  set.wrench_scale.diagonal().tail<3>() = inertia.cwiseInverse().cwiseSqrt();
  set.known_wrench_O[2] = -9.8;
  for (const double x : {-2.5, 2.5}) {
    for (const double y : {-5.0, 5.0}) {
      set.contacts.push_back({{x, y, -2.5},
                              Eigen::Vector3d::UnitZ(),
                              0.5,
                              ContactMode::slide,
                              Eigen::Vector3d::UnitX()});
    }
  }
  set.fingers.push_back(
      {{top_x, 0, 2.5}, -Eigen::Vector3d::UnitZ(), 0.7, 10, Eigen::Vector3d::Zero()});
  set.fingers.push_back({{-2.5, 0, 0}, Eigen::Vector3d::UnitX(), 0.7, 10, Eigen::Vector3d::Zero()});
  return set;
}

/// The same at rest: all contacts stick.
inline ContactSet resting_cuboid() {
  ContactSet set = sliding_cuboid();
  for (Contact& contact : set.contacts) contact.mode = ContactMode::stick;
  return set;
}

/// A body of no weight between two fingers on a line.
inline ContactSet pinched() {
  ContactSet set;
  for (const double side : {-1.0, 1.0}) {
    Finger finger;
    finger.p_OC = Eigen::Vector3d(side, 0, 0);
    finger.n_O = Eigen::Vector3d(-side, 0, 0);
    set.fingers.push_back(finger);
  }
  return set;
}

/// Contacts on a floor below and fingers around a body of about 1 m, weighed down by 10 N.
inline ContactSet random_contact_set(std::mt19937* rng, int num_contacts, int num_fingers) {
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vector = [&] { return Eigen::Vector3d(u(*rng), u(*rng), u(*rng)); };
  ContactSet set;
  set.known_wrench_O[2] = -10;
  for (int i = 0; i < num_contacts; ++i) {
    Contact contact;
    contact.p_OC = Eigen::Vector3d(u(*rng), u(*rng), -1);
    contact.friction = 0.3 + 0.4 * std::abs(u(*rng));
    contact.mode = u(*rng) > 0 ? ContactMode::stick : ContactMode::slide;
    contact.t_O = Eigen::Vector3d(1, 0.2, 0);
    set.contacts.push_back(contact);
  }
  for (int i = 0; i < num_fingers; ++i) {
    Finger finger;
    const Eigen::Vector3d out = vector().normalized();
    finger.p_OC = out;
    finger.n_O = (-out + 0.3 * vector()).normalized();
    finger.friction = 0.4 + 0.4 * std::abs(u(*rng));
    finger.max_normal_force = 8 + 4 * u(*rng);
    set.fingers.push_back(finger);
  }
  return set;
}

/// All combinations of control modes of n fingers.
inline std::vector<std::vector<FingerMode>> all_modes(int n) {
  std::vector<std::vector<FingerMode>> all;
  for (unsigned mask = 0; mask < 1U << n; ++mask) {
    std::vector<FingerMode> modes;
    for (int i = 0; i < n; ++i) {
      modes.push_back((mask >> i & 1U) != 0 ? FingerMode::force : FingerMode::position);
    }
    all.push_back(modes);
  }
  return all;
}

}  // namespace graspless::mechanics
