// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "graspless/mechanics/stability.hpp"

#include "mechanics/contact_sets.hpp"
#include "mechanics/stability/fixed_forces.hpp"

namespace graspless::mechanics {
namespace {

Stability reference(const ContactSet& set, const std::vector<FingerMode>& modes,
                    const Matrix6Xd& directions = disturbance_directions()) {
  return max_stability(set, modes, directions, Engine::reference);
}

bool bounded(const ContactSet& set, const std::vector<FingerMode>& modes) {
  return internal_force_is_bounded(set, modes, Engine::reference);
}

/// Half of the directions, to be quick.
Matrix6Xd few_directions() { return disturbance_directions().leftCols(12); }

TEST(Reference, AnswerHoldsWhenAskedDirectionByDirection) {
  const ContactSet set = sliding_cuboid();
  const Matrix6Xd directions = disturbance_directions();
  const Stability found = reference(set, {kForce, kPosition});
  ASSERT_GT(found.z, 1);
  const FixedForces balance(set, {kForce, kPosition}, found.commanded_forces);
  EXPECT_NEAR(balance.stability(directions), found.z, 1e-10);
  ASSERT_FALSE(found.binding_directions.empty());
  for (Eigen::Index d = 0; d < directions.cols(); ++d) {
    const bool binding = std::find(found.binding_directions.begin(), found.binding_directions.end(),
                                   d) != found.binding_directions.end();
    EXPECT_EQ(balance.reach(directions.col(d)) < found.z + 1e-8, binding) << d;
  }
  // No other commanded force does better.
  for (double f = 0; f <= 10; f += 1) {
    const FixedForces other(set, {kForce, kPosition}, Eigen::Vector2d(f, 0));
    EXPECT_LE(other.stability(directions), found.z + 1e-9);
  }
}

TEST(Reference, ForceIsStablerThanNoneAndPositionThanForce) {
  std::mt19937 rng(5);
  for (int trial = 0; trial < 10; ++trial) {
    const ContactSet set = random_contact_set(&rng, 4, 2);
    const double z = reference(set, {kPosition, kPosition}, few_directions()).z;
    for (const auto& modes : all_modes(2)) {
      EXPECT_LE(reference(set, modes, few_directions()).z, z + 1e-9);
    }
  }
}

TEST(Reference, TurningWorldAndDirectionsChangesNothing) {
  const ContactSet set = sliding_cuboid();
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Matrix6d turn = Matrix6d::Zero();
  turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = R;
  ContactSet turned = set;
  for (Contact& c : turned.contacts) c = {R * c.p_OC, R * c.n_O, c.friction, c.mode, R * c.t_O};
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    Finger& f = turned.fingers[i];
    // The first edges must turn too, where they were left to tangent().
    f.t_O = R * tangent(f.n_O, f.t_O);
    f.p_OC = R * f.p_OC;
    f.n_O = R * f.n_O;
  }
  turned.known_wrench_O = turn * set.known_wrench_O;
  turned.wrench_scale = turn * set.wrench_scale * turn.transpose();
  const double z = reference(set, {kForce, kPosition}, few_directions()).z;
  EXPECT_NEAR(reference(turned, {kForce, kPosition}, turn * few_directions()).z, z, 1e-9);
}

TEST(Reference, StabilityIsZeroWithoutEquilibriumOrMargin) {
  ContactSet set;  // it floats
  set.known_wrench_O[2] = -10;
  EXPECT_EQ(reference(set, {}).z, 0);
  set = sliding_cuboid();
  set.fingers.clear();  // nothing keeps it sliding, nor can anything
  EXPECT_EQ(reference(set, {}).z, 0);
}

TEST(Reference, StabilityIsUnboundedBetweenClampingContacts) {
  ContactSet set;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Contact contact;
      contact.p_OC = side * Eigen::Vector3d::Unit(axis);
      contact.n_O = -contact.p_OC;
      set.contacts.push_back(contact);
    }
  }
  EXPECT_EQ(reference(set, {}).z, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(bounded(set, {}));
}

TEST(Reference, StabilityIsFiniteWhereClampingContactsLeaveAMotionToFingers) {
  ContactSet set;  // two contacts jam, but the object may turn about the line through them
  for (const double side : {-1.0, 1.0}) {
    Contact contact;
    contact.p_OC = side * Eigen::Vector3d::UnitX();
    contact.n_O = -contact.p_OC;
    set.contacts.push_back(contact);
    Finger finger;
    finger.p_OC = side * Eigen::Vector3d::UnitY();
    finger.n_O = -finger.p_OC;
    set.fingers.push_back(finger);
  }
  const double z = reference(set, {kPosition, kPosition}).z;
  EXPECT_GT(z, 1);
  EXPECT_LT(z, 20);
  EXPECT_NEAR(max_stability(set, {kPosition, kPosition}).z, z, 1e-9);
}

TEST(Reference, OpposedFingersJamUnlessOneGivesWay) {
  const ContactSet set = pinched();
  EXPECT_FALSE(bounded(set, {kPosition, kPosition}));
  EXPECT_TRUE(bounded(set, {kForce, kPosition}));
  EXPECT_TRUE(bounded(set, {kForce, kForce}));
  EXPECT_TRUE(bounded(ContactSet{}, {}));
}

TEST(Reference, ATopFingerJamsAgainstAStickingFloorAlone) {
  EXPECT_FALSE(bounded(resting_cuboid(), {kPosition, kPosition}));
  EXPECT_FALSE(bounded(sliding_cuboid(), {kPosition, kPosition}));
  EXPECT_TRUE(bounded(sliding_cuboid(), {kForce, kPosition}));
}

}  // namespace
}  // namespace graspless::mechanics
