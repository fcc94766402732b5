// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <stdexcept>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {
namespace {

using Eigen::Vector3d;

ContactSet one_slides_one_sticks() {
  ContactSet set;
  set.contacts.resize(2);
  set.contacts[0].p_OC = Vector3d(1, 2, 3);
  set.contacts[1] = {Vector3d(-1, 0, 2), Vector3d::UnitZ(), 0.5, ContactMode::slide,
                     Vector3d(3, 0, 0)};
  set.com_O = Vector3d(0.5, 0, 0);
  set.known_wrench_O << 1, 2, 3, 4, 5, 6;
  set.fingers = {Finger{Vector3d(0, 1, 0), -Vector3d::UnitY(), 0.7, 5, Vector3d::Zero()}};
  return set;
}

TEST(Wrenches, SlidingFrictionActsAgainstTheMotion) {
  const EnvironmentWrenches environment = environment_wrenches(one_slides_one_sticks());
  ASSERT_EQ(environment.generators.cols(), 7);
  const Vector3d force(-0.5 / std::sqrt(1.25), 0, 1 / std::sqrt(1.25));
  EXPECT_TRUE(environment.generators.col(6).head<3>().isApprox(force, 1e-14));
  EXPECT_TRUE(environment.generators.col(6).tail<3>().isApprox(Vector3d(-1.5, 0, 2).cross(force)));
}

TEST(Wrenches, MomentsAreAboutTheCentreOfMassAndScaled) {
  ContactSet set = one_slides_one_sticks();
  const Matrix6Xd plain = environment_wrenches(set).generators;
  set.wrench_scale.diagonal() << 1, 1, 1, 2, 3, 4;
  set.wrench_scale(3, 4) = 0.5;
  const EnvironmentWrenches scaled = environment_wrenches(set);
  EXPECT_TRUE(scaled.generators.isApprox(set.wrench_scale * plain, 1e-14));
  EXPECT_TRUE(scaled.known.isApprox(set.wrench_scale * set.known_wrench_O, 1e-14));
  for (int j = 0; j < 6; ++j) {
    const Vector3d force = plain.col(j).head<3>();
    EXPECT_TRUE(plain.col(j).tail<3>().isApprox(Vector3d(0.5, 2, 3).cross(force), 1e-12));
  }
}

TEST(Wrenches, FingersKnowTheirNormalForces) {
  const FingerWrenches finger = finger_wrenches(one_slides_one_sticks(), 0);
  ASSERT_EQ(finger.generators.cols(), 6);
  EXPECT_EQ(finger.max_normal_force, 5);
  for (int j = 0; j < 6; ++j) {
    EXPECT_NEAR(finger.normal[j], -finger.generators(1, j), 1e-14);
    EXPECT_NEAR(finger.normal[j], 1 / std::sqrt(1.49), 1e-14);
  }
}

TEST(Wrenches, RefuseWhatIsNoContact) {
  const auto refused = [](const ContactSet& set, int finger) {
    try {
      finger < 0 ? void(environment_wrenches(set)) : void(finger_wrenches(set, finger));
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  ContactSet set = one_slides_one_sticks();
  EXPECT_NE(refused(set, 1).find("finger must be an index"), std::string::npos);
  set.contacts[0].n_O.setZero();
  EXPECT_NE(refused(set, -1).find("contacts[0]"), std::string::npos) << refused(set, -1);
  set = one_slides_one_sticks();
  set.fingers[0].n_O.setZero();
  EXPECT_NE(refused(set, 0).find("fingers[0]"), std::string::npos) << refused(set, 0);
}

TEST(Wrenches, NoiseDoesNotPassForALever) {
  ContactSet set;
  set.contacts.resize(1);
  set.contacts[0].p_OC = Vector3d(1e-17, -1e-17, -0.05);
  set.contacts[0].n_O = Vector3d(std::cos(std::acos(-1.0) / 2), 0, 1);
  const Matrix6Xd generators = environment_wrenches(set).generators;
  for (Eigen::Index i = 0; i < generators.size(); ++i) {
    const double value = std::abs(generators(i % 6, i / 6));
    EXPECT_TRUE(value == 0 || value > 1e-6) << value;
  }
}

}  // namespace
}  // namespace graspless::mechanics
