// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "graspless/mechanics/stability.hpp"

#include "mechanics/sets.hpp"

namespace graspless::mechanics {
namespace {

using Eigen::Vector3d;

/// The paper's first experiment: a box 5 x 10 x 5 that slides along +x.
ContactSet sliding_box(double max_force, const std::vector<Finger>& places) {
  ContactSet set;
  for (const double x : {-2.5, 2.5}) {
    for (const double y : {-5., 5.}) {
      set.contacts.push_back(
          {Vector3d(x, y, -2.5), Vector3d::UnitZ(), 0.5, ContactMode::slide, Vector3d::UnitX()});
    }
  }
  set.fingers = places;
  for (Finger& finger : set.fingers) {
    finger.friction = 0.7;
    finger.max_normal_force = max_force;
  }
  set.known_wrench_O = gravity_wrench(1, Vector3d(0, 0, -9.8));
  set.wrench_scale = wrench_scale(1, Vector3d(125, 50, 125).asDiagonal().toDenseMatrix() / 12);
  return set;
}

double cell(int i, double size) { return ((i + 0.5) / 7 - 0.5) * size; }

Finger above(int x, int y) {
  Finger finger;
  finger.p_OC = Vector3d(cell(x, 5), cell(y, 10), 2.5);
  finger.n_O = -Vector3d::UnitZ();
  return finger;
}

Finger behind(int y, int z) {
  Finger finger;
  finger.p_OC = Vector3d(-2.5, cell(y, 10), cell(z, 5));
  finger.n_O = Vector3d::UnitX();
  return finger;
}

TEST(ControlModes, OneFingerPressesAndOnePushes) {
  ControlModes best;
  ContactSet best_set;
  for (int top = 0; top < 49; ++top) {
    for (int back = 7; back < 49; ++back) {  // a fingertip of radius 1 above the floor
      const ContactSet set = sliding_box(10, {above(top % 7, top / 7), behind(back % 7, back / 7)});
      const ControlModes modes = best_control_modes(set);
      if (!modes.found || modes.stability.z <= best.stability.z) continue;
      best = modes;
      best_set = set;
    }
  }
  EXPECT_NEAR(best.stability.z, 6.0778, 5e-5);
  EXPECT_EQ(best.modes, (std::vector<FingerMode>{FingerMode::force, FingerMode::position}));

  // The other way round is as stable, wherever the fingers stand in the list.
  const std::vector<FingerMode> other{FingerMode::position, FingerMode::force};
  EXPECT_NEAR(max_stability(best_set, other).z, best.stability.z, 1e-9);
  EXPECT_EQ(best_control_modes(best_set, other).modes, other) << "previous modes win a tie";
  std::swap(best_set.fingers[0], best_set.fingers[1]);
  EXPECT_EQ(best_control_modes(best_set).modes, other);
}

TEST(ControlModes, WeakFingersBothPushFromBehind) {
  ControlModes best;
  for (int one = 0; one < 49; ++one) {
    for (int two = 0; two < one; ++two) {
      const ControlModes modes =
          best_control_modes(sliding_box(5, {behind(one % 7, one / 7), behind(two % 7, two / 7)}));
      if (modes.found && modes.stability.z > best.stability.z) best = modes;
    }
  }
  EXPECT_NEAR(best.stability.z, 2.311, 5e-4);
  EXPECT_EQ(best.modes, std::vector<FingerMode>(2, FingerMode::position));
}

TEST(ControlModes, IsTheBestOfAllThatCannotJam) {
  Sets sets(21);
  int found = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const int fingers = sets.whole(0, 4);
    const ContactSet set = trial % 2 == 0 ? sets.box(fingers) : sets.any(fingers);
    double best = 0;
    for (unsigned mask = 0; mask < 1U << fingers; ++mask) {
      std::vector<FingerMode> modes;
      for (int i = 0; i < fingers; ++i) {
        modes.push_back((mask >> i & 1U) != 0 ? FingerMode::force : FingerMode::position);
      }
      if (internal_force_is_bounded(set, modes)) best = std::max(best, max_stability(set, modes).z);
    }
    const ControlModes modes = best_control_modes(set);
    EXPECT_EQ(modes.found, best > 0);
    EXPECT_TRUE(same(modes.stability.z, best)) << trial;
    found += modes.found;
    EXPECT_TRUE(!modes.found || internal_force_is_bounded(set, modes.modes));
  }
  EXPECT_GT(found, 20);
}

TEST(ControlModes, EnginesAgree) {
  Sets sets(22);
  for (int trial = 0; trial < 15; ++trial) {
    const ContactSet set = sets.box(2);
    const ControlModes fast = best_control_modes(set);
    const ControlModes reference =
        best_control_modes(set, {}, disturbance_directions(), Engine::reference);
    EXPECT_EQ(fast.found, reference.found);
    EXPECT_EQ(fast.modes, reference.modes);
    EXPECT_TRUE(same(fast.stability.z, reference.stability.z));
  }
}

TEST(ControlModes, ManySetsAtOnceAreAsOneByOne) {
  Sets sets(23);
  std::vector<ContactSet> all;
  for (int i = 0; i < 30; ++i) all.push_back(i % 2 == 0 ? sets.box(i % 4) : sets.any(i % 4));
  const auto together = best_control_modes(all);
  ASSERT_EQ(together.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ControlModes alone = best_control_modes(all[i]);
    EXPECT_EQ(together[i].found, alone.found);
    EXPECT_EQ(together[i].modes, alone.modes);
    EXPECT_TRUE(same(together[i].stability.z, alone.stability.z));
  }
}

}  // namespace
}  // namespace graspless::mechanics
