// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/mechanics/friction_interval.hpp"

#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "mechanics/contact_sets.hpp"
#include "mechanics/stability/fixed_forces.hpp"

namespace graspless::mechanics {
namespace {

ContactSet with_friction(ContactSet set, const std::vector<double>& environment, double fingers,
                         const std::vector<int>& surface = {}) {
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    const int s = surface.empty() ? 0 : surface[i];
    set.contacts[i].friction = environment[s];
  }
  for (Finger& finger : set.fingers) finger.friction = fingers;
  return set;
}

/// The axes alone, to be quick.
Matrix6Xd axes() { return disturbance_directions().leftCols(12); }

double z_at(const ContactSet& set, const std::vector<FingerMode>& modes,
            const Eigen::VectorXd& forces, const std::vector<double>& environment, double fingers,
            const std::vector<int>& surface = {}) {
  return FixedForces(with_friction(set, environment, fingers, surface), modes, forces)
      .stability(axes());
}

/// Against samples of the intervals: a proof is true everywhere, a counter-example at itself.
TEST(FrictionInterval, IsAPointIfOneNumberIsGiven) {
  EXPECT_EQ(FrictionInterval{0.3}.upper, 0.3);
  EXPECT_EQ(FrictionInterval{}.upper, 0.5);
}

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
        EXPECT_GE(z_at(set, modes, forces, {mu}, finger), verdict.least_stability - 1e-8);
        EXPECT_TRUE(internal_force_is_bounded(with_friction(set, {mu}, finger), modes));
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
  const double z = z_at(set, modes, forces, {0.5}, 0.7);
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

/// Two surfaces, such as floor and wall, whose coefficients vary independently.
TEST(FrictionInterval, SurfacesAgreeWithSamples) {
  std::mt19937 rng(18);
  int proofs = 0, refutations = 0;
  for (int trial = 0; trial < 40; ++trial) {
    ContactSet set = trial % 2 == 0 ? sliding_cuboid() : random_contact_set(&rng, 4, 2);
    for (Finger& finger : set.fingers) finger.max_normal_force = 10;
    const std::vector<FingerMode> modes = {kForce, kPosition};
    const Eigen::Vector2d forces(4 + 0.1 * trial, 0);
    const Surfaces surfaces{{{0.3, 0.3 + 0.01 * trial}, {0.2, 0.6 - 0.01 * trial}}, {0, 1, 1, 0}};
    const double needed = 0.3;
    const FrictionVerdict verdict =
        holds_over_friction(set, modes, forces, surfaces, {0.6, 0.6}, needed, axes());
    if (!verdict.holds) {
      ++refutations;
      ASSERT_EQ(verdict.environment.size(), 2U);
      const ContactSet at =
          with_friction(set, verdict.environment, verdict.fingers, surfaces.of_contact);
      EXPECT_TRUE(!internal_force_is_bounded(at, modes) ||
                  z_at(set, modes, forces, verdict.environment, 0.6, surfaces.of_contact) < needed)
          << verdict.reason;
      continue;
    }
    ++proofs;
    for (int i = 0; i <= 4; ++i) {
      for (int j = 0; j <= 4; ++j) {
        std::vector<double> mu;
        for (const auto& [interval, part] :
             {std::pair{surfaces.friction[0], i / 4.0}, std::pair{surfaces.friction[1], j / 4.0}}) {
          mu.push_back(interval.lower + (interval.upper - interval.lower) * part);
        }
        EXPECT_GE(z_at(set, modes, forces, mu, 0.6, surfaces.of_contact),
                  verdict.least_stability - 1e-8);
        EXPECT_TRUE(
            internal_force_is_bounded(with_friction(set, mu, 0.6, surfaces.of_contact), modes));
      }
    }
  }
  EXPECT_GT(proofs, 5);
  EXPECT_GT(refutations, 5);
}

/// One surface is the shared coefficient, to the last bit. More freedom never holds better.
TEST(FrictionInterval, SurfacesThatVaryAloneHoldNoBetter) {
  const ContactSet set = sliding_cuboid();
  const std::vector<FingerMode> modes = {kForce, kPosition};
  const Eigen::Vector2d forces(10, 0);
  const auto least = [&](const Surfaces& surfaces) {
    return holds_over_friction(set, modes, forces, surfaces, {0.7, 0.7}, 0.5, axes())
        .least_stability;
  };
  const FrictionInterval interval{0.45, 0.5};
  const double shared =
      holds_over_friction(set, modes, forces, interval, {0.7, 0.7}, 0.5, axes()).least_stability;
  ASSERT_GT(shared, 0.5);
  EXPECT_EQ(least({{interval}, {0, 0, 0, 0}}), shared);
  EXPECT_EQ(least({{{9, 9}, interval}, {1, 1, 1, 1}}), shared);  // no contact with the first
  const double alone = least({{interval, interval}, {0, 1, 0, 1}});
  EXPECT_LE(alone, shared);
  EXPECT_GT(alone, 0);
}

/// Mixtures of ends: each surface alone may be rough, but not both differ.
TEST(FrictionInterval, FindsAMixtureOfEndsThatFails) {
  const ContactSet set = sliding_cuboid();
  const std::vector<FingerMode> modes = {kForce, kPosition};
  const Eigen::Vector2d forces(10, 0);
  const FrictionInterval wide{0.1, 0.6};
  const std::vector<int> sides = {0, 1, 0, 1};
  const FrictionVerdict shared =
      holds_over_friction(set, modes, forces, wide, {0.7, 0.7}, 0.5, axes());
  ASSERT_TRUE(shared.holds) << shared.reason;
  // Between the least stability of the shared coefficient and that of a mixture.
  const double mixed = z_at(set, modes, forces, {0.1, 0.6}, 0.7, sides);
  ASSERT_LT(mixed, shared.least_stability);
  const double needed = (mixed + shared.least_stability) / 2;
  EXPECT_TRUE(holds_over_friction(set, modes, forces, wide, {0.7, 0.7}, needed, axes()).holds);
  const FrictionVerdict alone = holds_over_friction(
      set, modes, forces, Surfaces{{wide, wide}, sides}, {0.7, 0.7}, needed, axes());
  ASSERT_FALSE(alone.holds);
  EXPECT_NE(alone.environment[0], alone.environment[1]);
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
  expect_refused(ask({0.5, 2e4}, {0.5, 0.5}, 1), "0 <= lower <= upper <= 10000");
  const auto on = [](const Surfaces& surfaces, const Matrix6Xd& directions) {
    return [=] {
      holds_over_friction(sliding_cuboid(), {kForce, kPosition}, Eigen::Vector2d(10, 0), surfaces,
                          {0.5, 0.5}, 1, directions);
    };
  };
  expect_refused(on({{}, {0, 0, 0, 0}}, axes()), "environment must have one surface");
  expect_refused(on({{{0.5, 0.5}}, {0, 0, 0}}, axes()), "each of the 4 contacts, not of 3");
  expect_refused(on({{{0.5, 0.5}}, {0, 0, 1, 0}}, axes()), "must be 0 to 0, not 1");
  expect_refused(on({{{0.5, 0.5}}, {0, 0, -1, 0}}, axes()), "must be 0 to 0, not -1");
  expect_refused(on({{{0.5, 0.5}, {0.5, nan}}, {0, 0, 0, 0}}, axes()), "environment must be");
  expect_refused(on({std::vector<FrictionInterval>(7, {0.4, 0.5}), {0, 0, 0, 0}}, axes()),
                 "at most 6 surfaces with lower < upper, not 7");
  expect_refused(on({{{0.5, 0.5}}, {0, 0, 0, 0}}, 1e30 * axes()), "the length of directions[0]");
  expect_refused(on({{{0.5, 0.5}}, {0, 0, 0, 0}}, axes().leftCols(0)), "directions");
}

}  // namespace
}  // namespace graspless::mechanics
