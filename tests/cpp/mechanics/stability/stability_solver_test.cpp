// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/mechanics/stability_solver.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "graspless/mechanics/equilibrium.hpp"

#include "complaint.hpp"
#include "mechanics/sets.hpp"

namespace graspless::mechanics {
namespace {

/// A contact set as the solver wants it.
struct Wrenches {
  explicit Wrenches(const ContactSet& set) : environment(environment_wrenches(set)) {
    const int n = static_cast<int>(set.fingers.size());
    for (int i = 0; i < n; ++i) fingers.push_back(finger_wrenches(set, i));
  }
  std::vector<const FingerWrenches*> pointers() const {
    std::vector<const FingerWrenches*> all;
    for (const FingerWrenches& finger : fingers) all.push_back(&finger);
    return all;
  }
  EnvironmentWrenches environment;
  std::vector<FingerWrenches> fingers;
};

ContactSet draw(Sets& sets, int trial, int fingers) {
  return trial % 2 == 0 ? sets.box(fingers) : sets.any(fingers);
}

TEST(StabilitySolver, WhatWasAskedBeforeDoesNotMatter) {
  Sets sets(31);
  StabilitySolver used;
  for (int trial = 0; trial < 300; ++trial) {
    const int fingers = sets.whole(0, 4);
    const Wrenches wrenches(draw(sets, trial, fingers));
    used.set({&wrenches.environment}, wrenches.pointers());
    StabilitySolver fresh;
    fresh.set({&wrenches.environment}, wrenches.pointers());
    for (ForceMask mask = 0; mask < 1U << fingers; mask += 1 + mask) {
      const double z = fresh.max_stability(mask).z;
      EXPECT_TRUE(same(used.max_stability(mask).z, z)) << trial;
      EXPECT_EQ(used.internal_force_is_bounded(mask), fresh.internal_force_is_bounded(mask));
    }
  }
}

TEST(StabilitySolver, RefusesWhatItWasNotGiven) {
  StabilitySolver solver;
  EXPECT_THROW(solver.evaluate(0), std::invalid_argument);
  EXPECT_THROW(solver.max_stability(0), std::invalid_argument);
  EXPECT_THROW(solver.internal_force_is_bounded(0), std::invalid_argument);
  EXPECT_THROW(solver.set({nullptr}, {}), std::invalid_argument);
  Sets sets(30);
  const Wrenches wrenches(sets.box(2));
  EXPECT_THROW(solver.set({&wrenches.environment}, {nullptr}), std::invalid_argument);
  solver.set({&wrenches.environment}, wrenches.pointers());
  EXPECT_NO_THROW(solver.evaluate(3));
  EXPECT_THROW(solver.evaluate(4), std::invalid_argument);
  EXPECT_THROW(finger_wrenches(sets.box(2), 2), std::invalid_argument);
}

TEST(StabilitySolver, ReachesEveryDirectionWithTheForcesItNames) {
  Sets sets(32);
  const Matrix6Xd directions = disturbance_directions();
  int tried = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const ContactSet set = draw(sets, trial, 2);
    const auto modes = sets.modes(2);
    const Stability stability = max_stability(set, modes);
    if (stability.z < 1e-3 || !std::isfinite(stability.z)) continue;
    ++tried;
    const auto holds = [&](int direction, double z) {
      ContactSet disturbed = set;
      disturbed.known_wrench_O -= set.wrench_scale.inverse() * z * directions.col(direction);
      return interior_equilibrium(disturbed, modes, stability.commanded_forces).has_value();
    };
    for (int d = 0; d < directions.cols(); ++d) {
      EXPECT_TRUE(holds(d, (1 - 1e-6) * stability.z)) << trial << " " << d;
    }
    for (int d : stability.binding_directions) {
      EXPECT_FALSE(holds(d, (1 + 1e-6) * stability.z)) << trial << " " << d;
    }
  }
  EXPECT_GT(tried, 15);
}

TEST(StabilitySolver, StopsOnlyWhenTheNeedCannotBeMet) {
  Sets sets(33);
  StabilitySolver solver;
  for (int trial = 0; trial < 100; ++trial) {
    const Wrenches wrenches(draw(sets, trial, 2));
    solver.set({&wrenches.environment}, wrenches.pointers());
    const double z = solver.max_stability(2).z;
    if (z == 0 || !std::isfinite(z)) continue;
    EXPECT_NEAR(solver.max_stability(2, 0.99 * z).z, z, 1e-10 * std::max(1.0, z));
    const double bound = solver.max_stability(2, 1.01 * z).z;
    EXPECT_LT(bound, 1.01 * z);
    EXPECT_GE(bound, z - 1e-10 * std::max(1.0, z));
  }
}

TEST(StabilitySolver, SupportsBoundEveryPlacementOfFingers) {
  Sets sets(34);
  const Matrix6Xd directions = disturbance_directions();
  for (int trial = 0; trial < 40; ++trial) {
    const Wrenches wrenches(draw(sets, trial, 2));
    StabilitySolver solver;
    solver.set({&wrenches.environment}, wrenches.pointers());
    solver.best_control_modes();
    const std::vector<Vector6d> supports = solver.supports();
    for (const Vector6d& y : supports) {
      EXPECT_TRUE(y.allFinite());
      if (wrenches.environment.generators.cols() > 0) {
        EXPECT_LE((wrenches.environment.generators.transpose() * y).maxCoeff(), 1e-10);
      }
    }
    Wrenches others = wrenches;
    others.fingers = Wrenches(draw(sets, trial, 2)).fingers;
    solver.set({&others.environment}, others.pointers());
    const double z = solver.max_stability(0).z;
    for (const Vector6d& y : supports) {
      double bound = y.dot(others.environment.known);
      for (const FingerWrenches& finger : others.fingers) {
        const Eigen::ArrayXd per_force =
            (finger.generators.transpose() * y).array() / finger.normal.array();
        bound += finger.max_normal_force * std::max(0.0, per_force.maxCoeff());
      }
      EXPECT_LE(z, std::max(0.0, bound / (directions.transpose() * y).maxCoeff()) + 1e-9);
    }
  }
  StabilitySolver solver;
  solver.clear_supports();
  EXPECT_TRUE(solver.supports().empty());
}

TEST(StabilitySolver, SeveralEnvironmentsShareOneForce) {
  Sets sets(35);
  for (int trial = 0; trial < 60; ++trial) {
    ContactSet set = draw(sets, trial, 2);
    const Wrenches one(set);
    for (Contact& contact : set.contacts) contact.friction *= 1.3;
    const Wrenches two(set);
    StabilitySolver solver;
    const auto ask = [&](const std::vector<const EnvironmentWrenches*>& environments,
                         ForceMask mask) {
      solver.set(environments, one.pointers());
      return solver.max_stability(mask).z;
    };
    for (ForceMask mask : {0U, 1U}) {
      const double first = ask({&one.environment}, mask), second = ask({&two.environment}, mask);
      const double both = ask({&one.environment, &two.environment}, mask);
      EXPECT_LE(both, std::min(first, second) * (1 + 1e-9) + 1e-9);
      EXPECT_TRUE(mask != 0 || same(both, std::min(first, second)));
      EXPECT_TRUE(same(ask({&one.environment, &one.environment}, mask), first));
    }
  }
}

TEST(StabilitySolver, WhatHoldsEverythingIsInfinitelyStable) {
  ContactSet set;  // a ball of contacts from all sides
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1., 1.}) {
      const Eigen::Vector3d n = side * Eigen::Vector3d::Unit(axis);
      set.contacts.push_back({-n, n, 0.5, ContactMode::stick, Eigen::Vector3d::Zero()});
    }
  }
  const Wrenches wrenches(set);
  StabilitySolver solver;
  solver.set({&wrenches.environment}, {});
  EXPECT_EQ(solver.max_stability(0).z, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(solver.internal_force_is_bounded(0));
  EXPECT_FALSE(solver.best_control_modes().found);
}

TEST(StabilitySolver, MeasuresAlongTheDirectionsItWasGiven) {
  // A box on sticking contacts: directions twice as long, half the z.
  Sets sets(36);
  for (int trial = 0; trial < 20; ++trial) {
    const Wrenches wrenches(draw(sets, trial, 1));
    StabilitySolver once, twice(2 * disturbance_directions());
    once.set({&wrenches.environment}, wrenches.pointers());
    twice.set({&wrenches.environment}, wrenches.pointers());
    EXPECT_TRUE(same(once.max_stability(1).z, 2 * twice.max_stability(1).z));
  }
}

TEST(StabilitySolver, CountsWhatItDoes) {
  Sets sets(37);
  const Wrenches wrenches(sets.any(2));
  StabilitySolver solver;
  solver.set({&wrenches.environment}, wrenches.pointers());
  solver.max_stability(0);
  solver.internal_force_is_bounded(0);
  EXPECT_EQ(solver.counters().evaluations, 1);
  EXPECT_EQ(solver.counters().bounded_tests, 1);
  EXPECT_GT(solver.counters().pivots, 0);
}

TEST(StabilitySolver, FindsNoStabilityInTwoEnvironmentsThatSpanNothing) {
  const EnvironmentWrenches environment;
  StabilitySolver solver;
  solver.set({&environment, &environment}, {});
  EXPECT_EQ(solver.evaluate(0).z, 0);
}

TEST(StabilitySolver, RefusesTooManyFingersAndNoEnvironment) {
  StabilitySolver solver;
  expect_refused([&] { solver.set({}, {}); }, "environments must not be empty");
  const EnvironmentWrenches environment;
  const FingerWrenches finger;
  expect_refused(
      [&] { solver.set({&environment}, std::vector<const FingerWrenches*>(5, &finger)); },
      "at most 4, not 5");
}

TEST(StabilitySolver, RefusesAFingerWithoutANormalForceForEachEdge) {
  StabilitySolver solver;
  const EnvironmentWrenches environment;
  FingerWrenches finger;
  finger.generators.setZero(6, 4);
  finger.normal.setZero(3);
  expect_refused([&] { solver.set({&environment}, {&finger}); }, "one normal force for each");
}

}  // namespace
}  // namespace graspless::mechanics
