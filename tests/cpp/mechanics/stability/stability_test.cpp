// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/mechanics/stability.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "mechanics/sets.hpp"

namespace graspless::mechanics {
namespace {

using Eigen::Vector3d;

TEST(Stability, AgreesWithTheReferenceEngine) {
  Sets sets(1);
  int positive = 0;
  for (int trial = 0; trial < 80; ++trial) {
    const int fingers = sets.whole(1, 3);
    const ContactSet set = trial % 2 == 0 ? sets.box(fingers) : sets.any(fingers);
    const auto modes = sets.modes(fingers);
    const double reference =
        max_stability(set, modes, disturbance_directions(), Engine::reference).z;
    EXPECT_TRUE(same(max_stability(set, modes).z, reference)) << trial;
    positive += reference > 0;
  }
  EXPECT_GT(positive, 30);
}

TEST(Stability, JammingAgreesWithTheReferenceEngine) {
  Sets sets(2);
  int bounded = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const int fingers = sets.whole(0, 4);
    const ContactSet set = trial % 2 == 0 ? sets.box(fingers) : sets.any(fingers);
    const auto modes = sets.modes(fingers);
    const bool reference = internal_force_is_bounded(set, modes, Engine::reference);
    EXPECT_EQ(internal_force_is_bounded(set, modes), reference) << trial;
    bounded += reference;
  }
  EXPECT_GT(bounded, 50);
  EXPECT_LT(bounded, 250);
}

/// z of a set under two changes.
struct Pair {
  double before, after;
};

template <typename Change>
std::vector<Pair> under(unsigned seed, Change change) {
  Sets sets(seed);
  std::vector<Pair> pairs;
  for (int trial = 0; trial < 100; ++trial) {
    ContactSet set = trial % 2 == 0 ? sets.box(2) : sets.any(2);
    auto modes = sets.modes(2);
    const double before = max_stability(set, modes).z;
    change(set, modes, sets);
    pairs.push_back({before, max_stability(set, modes).z});
  }
  return pairs;
}

TEST(Stability, GrowsWithAllForces) {
  for (const Pair& z : under(3, [](ContactSet&set, auto&, Sets&) {
         for (Finger& finger : set.fingers) finger.max_normal_force *= 3;
         set.known_wrench_O *= 3;
       })) {
    EXPECT_TRUE(same(z.after, 3 * z.before)) << z.after << " " << z.before;
  }
}

TEST(Stability, KnowsNoUnitOfLength) {
  for (const Pair& z : under(4, [](ContactSet&set, auto&, Sets&) {
         for (Finger& finger : set.fingers) finger.p_OC *= 0.01;
         for (Contact& contact : set.contacts) contact.p_OC *= 0.01;
         set.wrench_scale.bottomRows<3>() *= 100;
       })) {
    EXPECT_TRUE(same(z.after, z.before)) << z.after << " " << z.before;
  }
}

TEST(Stability, NeverFallsWithStrongerFingers) {
  for (const Pair& z : under(5, [](ContactSet&set, auto&, Sets&sets) {
         set.fingers[0].max_normal_force *= sets.real(1, 2);
         set.fingers[1].max_normal_force *= sets.real(1, 2);
       })) {
    EXPECT_TRUE(z.after >= z.before || same(z.after, z.before)) << z.after << " " << z.before;
  }
}

TEST(Stability, NeverFallsWithRougherFingers) {
  for (const Pair& z : under(6, [](ContactSet&set, auto&, Sets&sets) {
         for (Finger& finger : set.fingers) finger.friction *= sets.real(1, 2);
       })) {
    EXPECT_TRUE(z.after >= z.before || same(z.after, z.before)) << z.after << " " << z.before;
  }
}

TEST(Stability, PositionControlIsAtLeastAsStable) {
  for (const Pair& z :
       under(7, [](ContactSet&, auto&modes, Sets&) { modes.assign(2, FingerMode::position); })) {
    EXPECT_TRUE(z.after >= z.before || same(z.after, z.before)) << z.after << " " << z.before;
  }
}

TEST(Stability, NeverFallsWithAnotherPassiveFinger) {
  for (const Pair& z : under(8, [](ContactSet&set, auto&modes, Sets&sets) {
         set.fingers.push_back(sets.box(1).fingers[0]);
         modes.push_back(FingerMode::position);
       })) {
    EXPECT_TRUE(z.after >= z.before || same(z.after, z.before)) << z.after << " " << z.before;
  }
}

TEST(Stability, IsTheSameInAMirror) {
  const auto mirror = [](Vector3d& v) { v.y() = -v.y(); };
  for (const Pair& z : under(9, [&](ContactSet&set, auto&, Sets&) {
         for (Contact& contact : set.contacts) {
           mirror(contact.p_OC), mirror(contact.n_O), mirror(contact.t_O);
         }
         for (Finger& finger : set.fingers) {
           finger.t_O = tangent(finger.n_O, finger.t_O);
           mirror(finger.p_OC), mirror(finger.n_O), mirror(finger.t_O);
         }
         Vector3d force = set.known_wrench_O.head<3>();
         mirror(force);
         set.known_wrench_O.head<3>() = force;
       })) {
    EXPECT_TRUE(same(z.after, z.before)) << z.after << " " << z.before;
  }
}

TEST(Stability, CommandedForcesKeepWithinTheirLimits) {
  Sets sets(10);
  for (int trial = 0; trial < 100; ++trial) {
    const ContactSet set = sets.any(3);
    const auto modes = sets.modes(3);
    const Stability stability = max_stability(set, modes);
    ASSERT_EQ(stability.commanded_forces.size(), 3);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double f = stability.commanded_forces[i];
      const auto finger = static_cast<std::size_t>(i);
      EXPECT_GE(f, 0);
      EXPECT_LE(f, modes[finger] == FingerMode::force ? set.fingers[finger].max_normal_force : 0);
    }
    EXPECT_EQ(stability.binding_directions.empty(),
              stability.z == 0 || !std::isfinite(stability.z));
  }
}

TEST(Stability, NothingHoldsWhatNothingTouches) {
  ContactSet set;
  set.known_wrench_O = gravity_wrench(1, Vector3d(0, 0, -9.8));
  EXPECT_EQ(max_stability(set, {}).z, 0);
  EXPECT_TRUE(internal_force_is_bounded(set, {}));
  EXPECT_FALSE(best_control_modes(set).found);
}

TEST(Stability, ABoxThatOnlyTheFloorHoldsHasItsWeightAsMargin) {
  // Lifted by z l_d with l_d = (0, 0, k): the floor cannot pull, so z <= M g / k.
  Sets sets(11);
  ContactSet set = sets.box(0);
  while (set.contacts.size() != 4 || set.contacts[0].mode == ContactMode::slide) set = sets.box(0);
  for (Contact& contact : set.contacts) contact.friction = 1e4;
  const double k = 2 * std::sqrt(3 - std::sqrt(6.0));
  EXPECT_LE(max_stability(set, {}).z, 9.8 / k + 1e-9);
  EXPECT_GT(max_stability(set, {}).z, 0.1);
}

TEST(Stability, RefusesWhatItCannotMeasure) {
  Sets sets(12);
  const ContactSet set = sets.box(2);
  const std::vector<FingerMode> modes(2, FingerMode::position);
  expect_refused([&] { max_stability(set, {}); },
                 "modes must have 2 entries, one for each finger, not 0");
  expect_refused([&] { internal_force_is_bounded(set, {}); }, "modes must have 2 entries");
  Matrix6Xd directions = disturbance_directions();
  expect_refused([&] { max_stability(set, modes, directions.leftCols<6>()); },
                 "directions must positively span");
  directions(0, 0) = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { max_stability(set, modes, directions); }, "directions must be finite");
  for (const double length : {0.0, 1e-4, 1e4, 1e300}) {
    directions = disturbance_directions();
    directions.col(5) = length * Vector6d::Unit(1);
    expect_refused([&] { max_stability(set, modes, directions); },
                   "with lengths in [0.001, 1000]; the length of directions[5] is ");
  }
  ContactSet bad = set;
  bad.contacts[0].friction = -1;
  expect_refused([&] { max_stability(bad, modes); }, "contacts[0].friction");
  expect_refused([&] { best_control_modes(std::vector<ContactSet>{set, bad}); }, "sets[1]");
  expect_refused([&] { best_control_modes(set, {FingerMode::force}); },
                 "previous must be empty or have");
}

}  // namespace
}  // namespace graspless::mechanics
