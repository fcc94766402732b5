// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/mechanics/equilibrium.hpp"

#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "mechanics/contact_sets.hpp"

namespace graspless::mechanics {
namespace {

using Eigen::Vector3d;

/// What is left of balance, in O about the centre of mass.
Vector6d residual(const ContactSet& set, const Equilibrium& equilibrium) {
  Vector6d sum = set.known_wrench_O;
  const auto add = [&](const Vector3d& p_OC, const Vector3d& force) {
    sum.head<3>() += force;
    sum.tail<3>() += (p_OC - set.com_O).cross(force);
  };
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    add(set.contacts[i].p_OC, equilibrium.contact_forces_O.col(i));
  }
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    add(set.fingers[i].p_OC, equilibrium.finger_forces_O.col(i));
  }
  return sum;
}

double beyond_cone(const Vector3d& n_O, double friction, const Vector3d& force) {
  const double normal = n_O.dot(force);
  return (force - normal * n_O).norm() - friction * normal;
}

void expect_holds(const ContactSet& set, const std::vector<FingerMode>& modes,
                  const Eigen::VectorXd& commanded, const Equilibrium& found) {
  EXPECT_LT(residual(set, found).norm(), 1e-10);
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    const Contact& c = set.contacts[i];
    const Vector3d force = found.contact_forces_O.col(i);
    EXPECT_LE(beyond_cone(c.n_O, c.friction, force), 1e-10);
    if (c.mode == ContactMode::stick) continue;
    const Vector3d edge = c.n_O - c.friction * tangent(c.n_O, c.t_O);  // friction opposes motion
    EXPECT_LT((force - c.n_O.dot(force) * edge).norm(), 1e-10);
    EXPECT_GE(force.norm(), found.margin - 1e-10);
  }
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    const Finger& f = set.fingers[i];
    const Vector3d force = found.finger_forces_O.col(i);
    EXPECT_LE(beyond_cone(f.n_O, f.friction, force), 1e-10);
    const double normal = f.n_O.dot(force);
    if (modes[i] == kForce) {
      EXPECT_NEAR(normal, commanded[i], 1e-10);
    } else {
      EXPECT_LE(normal, f.max_normal_force - found.margin + 1e-10);
    }
  }
}

TEST(Equilibrium, BalancesWithinAllLimits) {
  std::mt19937 rng(6);
  int found_some = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const ContactSet set = random_contact_set(&rng, 3 + trial % 4, 1 + trial % 4);
    for (const auto& modes : all_modes(1 + trial % 4)) {
      const Eigen::VectorXd commanded =
          Eigen::VectorXd::Constant(static_cast<Eigen::Index>(modes.size()), 2);
      const auto found = interior_equilibrium(set, modes, commanded);
      if (!found) continue;
      ++found_some;
      expect_holds(set, modes, commanded, *found);
    }
  }
  EXPECT_GT(found_some, 50);
}

/// One finger may be commanded to press with 0 N: its force is none, and not one along the surface.
TEST(Equilibrium, ForSpringsBalancesWithinAllLimits) {
  std::mt19937 rng(8);
  int found_some = 0;
  for (int trial = 0; trial < 80; ++trial) {
    const int fingers = 1 + trial % 4;
    const ContactSet set = random_contact_set(&rng, 3 + trial % 4, fingers);
    for (const auto& modes : all_modes(fingers)) {
      Eigen::VectorXd commanded = Eigen::VectorXd::Constant(fingers, 2);
      if (trial >= 40) commanded[trial % fingers] = 0;
      const auto found = compliant_equilibrium(set, modes, commanded);
      // Its cones hold those of the other: where there is one of these there is one of those.
      EXPECT_TRUE(found || !interior_equilibrium(set, modes, commanded));
      if (!found) continue;
      ++found_some;
      expect_holds(set, modes, commanded, *found);
    }
  }
  EXPECT_GT(found_some, 50);
}

/// Motions within the equilibria of a set with two fingers: steps that change no balance.
Eigen::MatrixXd free_steps(const ContactSet& set, const Equilibrium& like) {
  const Eigen::Index contacts = like.contact_forces_O.size(), parts = contacts + 6;
  Eigen::MatrixXd balance(6, parts);
  for (Eigen::Index i = 0; i < parts; ++i) {
    Equilibrium unit = like;
    unit.contact_forces_O.setZero();
    unit.finger_forces_O.setZero();
    (i < contacts ? unit.contact_forces_O.data()[i] : unit.finger_forces_O.data()[i - contacts]) =
        1;
    balance.col(i) = residual(set, unit) - set.known_wrench_O;
  }
  return Eigen::MatrixXd::Identity(parts, parts) -
         balance.completeOrthogonalDecomposition().pseudoInverse() * balance;
}

/// The index that random steps, each from the best forces so far, come to.
double climbed(const ContactSet& set, const std::vector<FingerMode>& modes, Equilibrium forces) {
  const Eigen::MatrixXd inner = free_steps(set, forces);
  const Eigen::Index contacts = forces.contact_forces_O.cols();
  double most = compliant_stability(set, modes, forces);
  std::mt19937 rng(9);
  std::normal_distribution<double> draw;
  for (int trial = 0; trial < 4000; ++trial) {
    const double size = std::pow(10.0, -(trial % 4));
    const Eigen::VectorXd step =
        inner * Eigen::VectorXd::NullaryExpr(inner.rows(), [&] { return size * draw(rng); });
    Equilibrium other = forces;
    other.contact_forces_O += Eigen::Map<const Eigen::Matrix3Xd>(step.data(), 3, contacts);
    other.finger_forces_O += Eigen::Map<const Eigen::Matrix3Xd>(step.data() + 3 * contacts, 3, 2);
    const double found = compliant_stability(set, modes, other);
    if (found <= most) continue;
    most = found;
    forces = other;
  }
  EXPECT_LT(residual(set, forces).norm(), 1e-8);
  return most;
}

/// A search by random steps gains little on it, and much on even margins.
TEST(Equilibrium, ForSpringsIsAboutTheBestForThem) {
  const ContactSet set = resting_cuboid();
  const std::vector<FingerMode> modes = {kPosition, kPosition};
  const Equilibrium best = *compliant_equilibrium(set, modes, Eigen::Vector2d(0, 0));
  const Equilibrium even = *interior_equilibrium(set, modes, Eigen::Vector2d(0, 0));
  EXPECT_LE(climbed(set, modes, best), 1.1 * compliant_stability(set, modes, best));
  EXPECT_GT(climbed(set, modes, even), 1.1 * compliant_stability(set, modes, even));
}

TEST(Equilibrium, ForSpringsFollowsTheContactsContinuously) {
  ContactSet set = resting_cuboid();
  const std::vector<FingerMode> modes = {kForce, kPosition};
  const Eigen::Vector2d commanded(3, 0);
  const Equilibrium before = *compliant_equilibrium(set, modes, commanded);
  for (Contact& contact : set.contacts) contact.p_OC.x() += 1e-7;
  const Equilibrium after = *compliant_equilibrium(set, modes, commanded);
  EXPECT_LT((after.contact_forces_O - before.contact_forces_O).cwiseAbs().maxCoeff(), 1e-4);
  EXPECT_LT((after.finger_forces_O - before.finger_forces_O).cwiseAbs().maxCoeff(), 1e-4);
}

/// Two points do not hold a turn about their line: no spring asks for anything.
TEST(Equilibrium, WithoutSpringsThatHoldAllCountAlike) {
  const ContactSet set = pinched();
  const auto found = compliant_equilibrium(set, {kPosition, kPosition}, Eigen::Vector2d(0, 0));
  ASSERT_TRUE(found);
  EXPECT_GT(found->margin, 0.1);
  EXPECT_LT(residual(set, *found).norm(), 1e-10);
}

TEST(Equilibrium, ABodyAtRestSharesItsWeight) {
  ContactSet set = resting_cuboid();
  set.fingers.clear();
  const auto found = interior_equilibrium(set, {}, Eigen::VectorXd());
  ASSERT_TRUE(found);
  // All 24 coefficients alike: each contact presses with a quarter of the weight.
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(found->contact_forces_O.col(i).isApprox(Vector3d(0, 0, 9.8 / 4), 1e-9));
  }
  EXPECT_NEAR(found->margin, 9.8 / 24 * std::hypot(1, 0.5), 1e-9);
}

TEST(Equilibrium, ThereMayBeNone) {
  ContactSet set = sliding_cuboid();
  EXPECT_FALSE(interior_equilibrium(set, {kPosition, kForce}, Eigen::Vector2d(0, 0)));
  set.fingers.clear();
  EXPECT_FALSE(interior_equilibrium(set, {}, Eigen::VectorXd()));
  EXPECT_FALSE(interior_equilibrium(
      [] {
        ContactSet floats;
        floats.known_wrench_O[2] = -1;
        return floats;
      }(),
      {}, Eigen::VectorXd()));
}

TEST(Equilibrium, ACapWhereTheEnvironmentJams) {
  ContactSet set;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Contact contact;
      contact.p_OC = side * Vector3d::Unit(axis);
      contact.n_O = -contact.p_OC;
      set.contacts.push_back(contact);
    }
  }
  set.known_wrench_O[2] = -10;
  const auto found = interior_equilibrium(set, {}, Eigen::VectorXd());
  ASSERT_TRUE(found);
  EXPECT_GE(found->margin, 9 - 1e-9);  // nine tenths of the cap
  EXPECT_LT(residual(set, *found).norm(), 1e-10);
}

TEST(Equilibrium, BadInputIsNamed) {
  const ContactSet set = sliding_cuboid();
  const auto solve = [&](const std::vector<FingerMode>& modes, const Eigen::VectorXd& forces) {
    return [=] { interior_equilibrium(set, modes, forces); };
  };
  expect_refused(solve({kPosition}, Eigen::Vector2d(1, 1)),
                 "modes must have 2 entries, one for each finger, not 1");
  expect_refused(solve({kPosition, kForce}, Eigen::VectorXd::Ones(3)),
                 "commanded_forces must have 2 entries, one for each finger");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {-1.0, 10.1, nan}) {
    expect_refused(solve({kPosition, kForce}, Eigen::Vector2d(1, bad)), "commanded_forces[1]");
  }
  EXPECT_TRUE(interior_equilibrium(set, {kForce, kPosition}, Eigen::Vector2d(5, nan)));
}

}  // namespace
}  // namespace graspless::mechanics
