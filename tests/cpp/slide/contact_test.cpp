// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/contact.hpp"

#include <random>

#include <gtest/gtest.h>

namespace graspless::slide {
namespace {

constexpr double kTop = 0.005;

double uniform(std::mt19937_64& rng, double a, double b) {
  return std::uniform_real_distribution<double>(a, b)(rng);
}

Eigen::Vector2d heading(double yaw) { return {std::cos(yaw), std::sin(yaw)}; }

TEST(Contact, TipReadsWhatTipPoseWrote) {
  std::mt19937_64 rng(1);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d p(uniform(rng, -1, 1), uniform(rng, -1, 1)),
        h = heading(uniform(rng, -4, 4));
    const double pitch = uniform(rng, 0.1, 1.4), height = uniform(rng, -0.02, 0.1);
    const Eigen::Isometry3d X_SF = tip_pose(p, height, h, pitch);
    EXPECT_TRUE((X_SF.linear() * X_SF.linear().transpose()).isIdentity(1e-12));
    EXPECT_NEAR(X_SF.linear().determinant(), 1, 1e-12);
    const Tip read = tip(X_SF);
    EXPECT_TRUE(read.position.isApprox(p, 1e-12));
    EXPECT_TRUE(read.heading.isApprox(h, 1e-12));
    EXPECT_NEAR(read.height, height, 1e-12);
    EXPECT_NEAR(read.pitch, pitch, 1e-12);
    EXPECT_NEAR(read.roll, 0, 1e-12);
    EXPECT_TRUE(read.other_finger_up);
  }
}

TEST(Contact, TurnedAboutItsOwnAxisTheOtherFingerPointsDown) {
  const Eigen::Isometry3d X_SF =
      tip_pose({0, 0}, 0, heading(0.3), 0.8) * Eigen::AngleAxisd(M_PI, Eigen::Vector3d::UnitZ());
  const Tip read = tip(X_SF);
  EXPECT_NEAR(read.pitch, 0.8, 1e-12);
  EXPECT_FALSE(read.other_finger_up);
}

// Figures from an independent physics engine: 5 / 13.4 / 20 mm of
// shift at 5 / 15 / 25 mm of depth and 45 degrees.
TEST(Contact, ShiftOfAFlexingFinger) {
  Hand hand;
  const double pitch = M_PI / 4;
  EXPECT_NEAR(contact_shift(hand, 0.005, pitch, pitch), 0.0051, 3e-4);
  EXPECT_NEAR(contact_shift(hand, 0.015, pitch, pitch), 0.0134, 1e-3);
  EXPECT_NEAR(contact_shift(hand, 0.025, pitch, pitch), 0.0205, 1e-3);
  EXPECT_NEAR(contact_shift(hand, 0, pitch, pitch), 0, 1e-15);
  hand.finger_model = FingerModel::none;
  EXPECT_EQ(contact_shift(hand, 0.02, pitch, 0.7), 0);
}

TEST(Contact, ShiftGrowsWithDepth) {
  const Hand hand;
  double before = 0;
  for (double depth = 0.001; depth < 0.03; depth += 0.001) {
    const double shift = contact_shift(hand, depth, 0.785, 0.785);
    EXPECT_GT(shift, before);
    before = shift;
  }
}

TEST(Contact, TheObjectFollowsRigidly) {
  std::mt19937_64 rng(2);
  const auto random = [&] {
    Planar X = Planar::Identity();
    X.linear() = Eigen::Rotation2Dd(uniform(rng, -3, 3)).toRotationMatrix();
    X.translation() << uniform(rng, -1, 1), uniform(rng, -1, 1);
    return X;
  };
  for (int i = 0; i < 100; ++i) {
    const Planar tip_start = random(), tip_now = random(), object_start = random();
    const Planar now = object_pose(tip_now, tip_start, object_start);
    // Eq. (1): the tip, seen from the object, stays where it was.
    EXPECT_TRUE((now.inverse() * tip_now).isApprox(object_start.inverse() * tip_start, 1e-12));
    EXPECT_TRUE(object_pose(tip_start, tip_start, object_start).isApprox(object_start, 1e-12));
  }
}

TEST(Contact, PlanarAndSpatialAreInverse) {
  std::mt19937_64 rng(3);
  for (int i = 0; i < 50; ++i) {
    Planar X = Planar::Identity();
    X.linear() = Eigen::Rotation2Dd(uniform(rng, -3, 3)).toRotationMatrix();
    X.translation() << uniform(rng, -1, 1), uniform(rng, -1, 1);
    EXPECT_TRUE(planar(spatial(X)).isApprox(X, 1e-12));
  }
}

TEST(Contact, EffectiveTipRunsAheadAlongTheHeading) {
  const Hand hand;
  const Tip pressed = tip(tip_pose({0.2, 0.3}, kTop - 0.02, heading(1.1), 0.785));
  const Planar effective = effective_tip(hand, pressed, kTop, 0.785);
  const Eigen::Vector2d ahead = effective.translation() - pressed.position;
  EXPECT_NEAR(ahead.dot(heading(1.1)), contact_shift(hand, 0.02, 0.785, 0.785), 1e-12);
  EXPECT_NEAR(ahead.norm(), ahead.dot(heading(1.1)), 1e-12);
  EXPECT_TRUE(effective.linear().col(0).isApprox(heading(1.1), 1e-12));
}

}  // namespace
}  // namespace graspless::slide
