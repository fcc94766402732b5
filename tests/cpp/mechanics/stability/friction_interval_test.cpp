// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/mechanics/friction_interval.hpp"

#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "mechanics/contact_sets.hpp"
#include "mechanics/stability/fixed_forces.hpp"

namespace graspless::mechanics {
namespace {

ContactSet with_friction(ContactSet set, double environment, double fingers) {
  for (Contact& contact : set.contacts) contact.friction = environment;
  for (Finger& finger : set.fingers) finger.friction = fingers;
  return set;
}

/// The axes alone, to be quick.
Matrix6Xd axes() { return disturbance_directions().leftCols(12); }

double z_at(const ContactSet& set, const std::vector<FingerMode>& modes,
            const Eigen::VectorXd& forces, double environment, double fingers) {
  return FixedForces(with_friction(set, environment, fingers), modes, forces).stability(axes());
}

/// Against samples of the intervals: a proof is true everywhere, a counter-example at itself.
TEST(FrictionInterval, AgreesWithSamples) {
  std::mt19937 rng(8);
  int proofs = 0, refutations = 0;
  for (int trial = 0; trial < 40; ++trial) {
    ContactSet set = trial % 2 == 0 ? sliding_cuboid() : random_contact_set(&rng, 4, 2);
    for (Finger& finger : set.fingers) finger.max_normal_force = 10;
    const std::vector<FingerMode> modes = {kForce, kPosition};
    const Eigen::Vector2d forces(4 + 0.1 * trial, 0);
    const FrictionInterval environment{0.3, 0.3 + 0.01 * trial}, fingers{0.5, 0.7};
    const double needed = 0.3;
    const FrictionVerdict verdict =
        holds_over_friction(set, modes, forces, environment, fingers, needed, axes());
    if (!verdict.holds) {
      ++refutations;
      const ContactSet at = with_friction(set, verdict.environment, verdict.fingers);
      const bool jams = !internal_force_is_bounded(at, modes);
      EXPECT_TRUE(jams || z_at(set, modes, forces, verdict.environment, verdict.fingers) < needed)
          << verdict.reason;
      EXPECT_NE(verdict.reason, "");
      continue;
    }
    ++proofs;
    EXPECT_GE(verdict.least_stability, needed - 1e-9);
    for (int i = 0; i <= 6; ++i) {
      for (const double finger : {0.5, 0.6, 0.7}) {
        const double mu = environment.lower + (environment.upper - environment.lower) * i / 6;
        EXPECT_GE(z_at(set, modes, forces, mu, finger), verdict.least_stability - 1e-8);
        EXPECT_TRUE(internal_force_is_bounded(with_friction(set, mu, finger), modes));
      }
    }
  }
  EXPECT_GT(proofs, 5);
  EXPECT_GT(refutations, 5);
}

TEST(FrictionInterval, APointIsTheStabilityItself) {
  const ContactSet set = sliding_cuboid();
  const std::vector<FingerMode> modes = {kForce, kPosition};
  const Eigen::Vector2d forces(10, 0);
  const double z = z_at(set, modes, forces, 0.5, 0.7);
  ASSERT_GT(z, 1);
  const auto verdict = [&](double needed) {
    return holds_over_friction(set, modes, forces, {0.5, 0.5}, {0.7, 0.7}, needed, axes());
  };
  EXPECT_TRUE(verdict(z).holds);
  EXPECT_NEAR(verdict(z - 0.1).least_stability, z, 1e-9);
  EXPECT_FALSE(verdict(z + 1e-6).holds);
}

/// A weak point between good ends: pushing needs friction on the floor within bounds of both sides.
TEST(FrictionInterval, FindsTheCoefficientThatFails) {
  const ContactSet set = sliding_cuboid();
  const std::vector<FingerMode> modes = {kForce, kPosition};
  const FrictionVerdict verdict =
      holds_over_friction(set, modes, Eigen::Vector2d(10, 0), {0.2, 1.5}, {0.7, 0.7}, 0.5, axes());
  ASSERT_FALSE(verdict.holds);
  EXPECT_NE(verdict.reason.find("at friction"), std::string::npos) << verdict.reason;
  EXPECT_LT(z_at(set, modes, Eigen::Vector2d(10, 0), verdict.environment, verdict.fingers), 0.5);
}

TEST(FrictionInterval, WideConesJam) {
  const FrictionVerdict verdict =
      holds_over_friction(sliding_cuboid(), {kPosition, kPosition}, Eigen::Vector2d::Zero(),
                          {0.4, 0.5}, {0.6, 0.7}, 0.1, axes());
  EXPECT_FALSE(verdict.holds);
  EXPECT_EQ(verdict.fingers, 0.7);
  EXPECT_NE(verdict.reason.find("without bound"), std::string::npos);
}

TEST(FrictionInterval, GaugeOfAPolyhedron) {
  const Matrix6Xd directions = disturbance_directions();
  for (Eigen::Index d = 0; d < directions.cols(); ++d) {
    EXPECT_NEAR(gauge(directions, 3 * directions.col(d)), 3, 1e-9);
  }
  std::mt19937 rng(9);
  std::normal_distribution<double> normal;
  std::vector<Vector6d> wrenches;
  double largest = 0;
  for (int i = 0; i < 30; ++i) {
    Vector6d w;
    for (double& x : w) x = normal(rng);
    EXPECT_LE(gauge(directions, w), w.norm() + 1e-9);  // the polyhedron holds the unit ball
    EXPECT_LE(gauge(directions, 2 * w), 2 * gauge(directions, w) + 1e-9);
    wrenches.push_back(w);
    largest = std::max(largest, gauge(directions, w));
  }
  EXPECT_NEAR(largest_gauge(directions, wrenches), largest, 1e-12);
}

TEST(FrictionInterval, BadInputIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto ask = [](const FrictionInterval& environment, const FrictionInterval& fingers,
                      double needed) {
    return [=] {
      holds_over_friction(sliding_cuboid(), {kForce, kPosition}, Eigen::Vector2d(10, 0),
                          environment, fingers, needed, axes());
    };
  };
  expect_refused(ask({-0.1, 1}, {0.5, 0.5}, 1), "environment must be an interval");
  expect_refused(ask({0.5, 0.4}, {0.5, 0.5}, 1), "environment must be an interval");
  expect_refused(ask({0.5, 0.5}, {0.5, nan}, 1), "fingers must be an interval");
  expect_refused(ask({0.5, 0.5}, {0.5, 0.5}, -1), "needed");
  expect_refused(ask({0.5, 0.5}, {0.5, 0.5}, nan), "needed");
}

}  // namespace
}  // namespace graspless::mechanics
