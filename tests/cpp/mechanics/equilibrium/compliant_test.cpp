// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "graspless/mechanics/equilibrium.hpp"
#include "graspless/mechanics/stability.hpp"

#include "complaint.hpp"
#include "mechanics/contact_sets.hpp"
#include "mechanics/equilibrium/springs.hpp"
#include "mechanics/stability/fixed_forces.hpp"

namespace graspless::mechanics {
namespace {

using Eigen::Vector3d;

/// On the edge of its cone, a force may leave it at once, cross it, or stay on it.
TEST(Compliant, ForcesOnTheEdgeOfTheirCone) {
  Spring spring;
  spring.n = Vector3d::UnitZ();
  const auto limit = [&](double friction, const Vector3d& force, const Vector3d& change) {
    spring.friction = friction;
    spring.changes = change;
    return spring.within_cone(force);
  };
  const Vector3d edge(0.5, 0, 1);
  EXPECT_EQ(limit(0.5, edge, {1, 0, 0}), 0);
  EXPECT_DOUBLE_EQ(limit(0.5, edge, {-1, 0, 0}), 1);
  EXPECT_EQ(limit(0.5, edge, {0, 1, 0}), 0);
  EXPECT_NEAR(limit(0.7195, {0.95145, -10.43715, 14.565}, {-0.39678, 1.43196, 0}), 13.88, 0.05);
  EXPECT_EQ(limit(0.5, edge, {0, 0, 1}), Spring::kUnlimited);
  EXPECT_EQ(limit(0, {0, 0, 1}, {1, 0, 0}), 0);
  EXPECT_EQ(limit(0, {0, 0, 1}, {0, 0, 1}), Spring::kUnlimited);
  EXPECT_DOUBLE_EQ(limit(0, {0, 0, 1}, {0, 0, -2}), 0.5);
}

TEST(Compliant, TwoPointsDoNotHoldATurnAboutTheirLine) {
  Equilibrium nominal;
  nominal.contact_forces_O.resize(3, 0);
  nominal.finger_forces_O.resize(3, 2);
  nominal.finger_forces_O << 4, -4, 0, 0, 0, 0;
  EXPECT_EQ(compliant_stability(pinched(), {kPosition, kPosition}, nominal), 0);
}

/// Four corners on the floor, alike and alike loaded: an upward pull lifts them all at once, a push
/// along the floor loads them alike until they slip, a torque about z too.
TEST(Compliant, KnownAnswersOfABodyAtRest) {
  ContactSet set = resting_cuboid();
  set.fingers.clear();
  const Equilibrium nominal = *interior_equilibrium(set, {}, Eigen::VectorXd());
  const auto along = [&](const Vector6d& direction) {
    return compliant_stability(set, {}, nominal, Compliance{}, direction);
  };
  // Springs supply what a direction says: down means that the floor presses less.
  EXPECT_NEAR(along(-Vector6d::Unit(2)), 9.8, 1e-9);
  // No shift without a tilt about the floor, which the normal springs resist: less than mu m g.
  EXPECT_LT(along(Vector6d::Unit(0)), 0.5 * 9.8);
  EXPECT_GT(along(Vector6d::Unit(0)), 1);
  const double radius = std::hypot(2.5, 5), scale = set.wrench_scale(5, 5);
  EXPECT_NEAR(along(Vector6d::Unit(5)), 0.5 * 9.8 * radius * scale, 1e-9);
}

/// Springs are one way among all in which forces may redistribute, if cones have many edges.
TEST(Compliant, NeverPromisesMoreThanFreeRedistribution) {
  const Matrix6Xd axes = disturbance_directions().leftCols(12);
  std::mt19937 rng(7);
  int compared = 0;
  for (int trial = 0; trial < 25; ++trial) {
    const ContactSet set = random_contact_set(&rng, 4, 2);
    ContactSet round = set;  // cones that come near Coulomb's
    round.cone_edges = 24;
    for (const auto& modes : all_modes(2)) {
      const Eigen::Vector2d commanded(2, 2);
      const auto nominal = interior_equilibrium(set, modes, commanded);
      if (!nominal || !internal_force_is_bounded(set, modes)) continue;
      const double compliant = compliant_stability(set, modes, *nominal, Compliance{}, axes);
      const FixedForces free(round, modes, commanded);
      EXPECT_LE(compliant, 1.01 * free.stability(axes) + 1e-9);
      compared += compliant > 0;
    }
  }
  EXPECT_GT(compared, 10);
}

TEST(Compliant, OnlyRatiosOfStiffnessMatter) {
  const ContactSet set = sliding_cuboid();
  const std::vector<FingerMode> modes = {kForce, kPosition};
  const Equilibrium nominal = *interior_equilibrium(set, modes, Eigen::Vector2d(10, 0));
  Compliance stiff;
  stiff.environment_normal *= 1e3;
  stiff.environment_tangential *= 1e3;
  stiff.finger_normal *= 1e3;
  stiff.finger_tangential *= 1e3;
  const double t = compliant_stability(set, modes, nominal);
  EXPECT_GT(t, 0.5);
  EXPECT_NEAR(compliant_stability(set, modes, nominal, stiff), t, 1e-9 * t);
}

/// At t every contact is still within its limits by the linear springs, just beyond one is not:
/// worked out anew with the springs as a plain linear system of displacements.
TEST(Compliant, IsWhereTheFirstLimitIsMet) {
  const ContactSet set = resting_cuboid();
  const std::vector<FingerMode> modes = {kForce, kPosition};
  const Equilibrium nominal = *interior_equilibrium(set, modes, Eigen::Vector2d(3, 0));
  const Compliance springs;
  const auto inside = [&](const Vector6d& demand) {
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(6, 6);
    std::vector<Eigen::Matrix<double, 3, 6>> jacobians;
    std::vector<Eigen::Matrix3d> springs_O;
    const auto add = [&](const Vector3d& p, const Vector3d& n, double normal, double tangential) {
      Eigen::Matrix<double, 3, 6> jacobian;
      for (int i = 0; i < 3; ++i) {
        jacobian.col(i) = Vector3d::Unit(i);
        jacobian.col(3 + i) = Vector3d::Unit(i).cross(p);
      }
      const Eigen::Matrix3d N = n * n.transpose();
      springs_O.push_back(normal * N + tangential * (Eigen::Matrix3d::Identity() - N));
      jacobians.push_back(jacobian);
      stiffness += jacobian.transpose() * springs_O.back() * jacobian;
    };
    for (const Contact& c : set.contacts) {
      add(c.p_OC, c.n_O, springs.environment_normal, springs.environment_tangential);
    }
    for (std::size_t i = 0; i < 2; ++i) {
      const Finger& f = set.fingers[i];
      add(f.p_OC, f.n_O, i == 0 ? 0 : springs.finger_normal, springs.finger_tangential);
    }
    const Vector6d moved = stiffness.ldlt().solve(set.wrench_scale.inverse() * -demand);
    double worst = -1e9;
    for (std::size_t i = 0; i < jacobians.size(); ++i) {
      const bool finger = i >= set.contacts.size();
      const std::size_t k = finger ? i - set.contacts.size() : i;
      const Vector3d n = finger ? set.fingers[k].n_O : set.contacts[k].n_O;
      const double mu = finger ? set.fingers[k].friction : set.contacts[k].friction;
      const Vector3d before =
          finger ? nominal.finger_forces_O.col(k) : nominal.contact_forces_O.col(k);
      const Vector3d force = before - springs_O[i] * jacobians[i] * moved;
      const double normal = n.dot(force);
      worst = std::max(worst, (force - normal * n).norm() - mu * normal);
      if (finger && modes[k] == kPosition) worst = std::max(worst, normal - 10);
    }
    return worst <= 0;
  };
  const Matrix6Xd directions = disturbance_directions();
  const double t = compliant_stability(set, modes, nominal);
  ASSERT_GT(t, 0.1);
  bool all_inside = true, all_beyond = true;
  for (Eigen::Index d = 0; d < directions.cols(); ++d) {
    all_inside = all_inside && inside((1 - 1e-6) * t * directions.col(d));
    all_beyond = all_beyond && inside((1 + 1e-6) * t * directions.col(d));
  }
  EXPECT_TRUE(all_inside);
  EXPECT_FALSE(all_beyond);
}

TEST(Compliant, BadInputIsNamed) {
  const ContactSet set = sliding_cuboid();
  const std::vector<FingerMode> modes = {kForce, kPosition};
  const Equilibrium nominal = *interior_equilibrium(set, modes, Eigen::Vector2d(10, 0));
  Compliance soft;
  soft.finger_normal = 0;
  for (const double bad : {0.0, -1.0, 1e-10, 1e10, std::nan("")}) {
    soft.finger_normal = bad;
    expect_refused([&] { compliant_stability(set, modes, nominal, soft); },
                   "compliance.finger_normal must lie in [1e-09, 1e+09] N/m, not ");
  }
  expect_refused([&] { compliant_stability(set, modes, Equilibrium{}); }, "nominal");
  expect_refused([&] { compliant_stability(set, {kForce}, nominal); }, "modes");
  expect_refused([&] { compliant_stability(set, modes, nominal, {}, Matrix6Xd(6, 0)); },
                 "directions");
}

}  // namespace
}  // namespace graspless::mechanics
