// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pinch/press.hpp"

#include <string>

#include <gtest/gtest.h>

#include "pinch/check_contacts.hpp"
#include "slide/problems.hpp"

namespace graspless::pinch {
namespace {

using slide::Object;

constexpr double kEffort = 2;  // of the joint of the T42, which moves both fingers [Nm]

/// A bar before a T42 whose motor has another effort limit.
Problem before_hand(const std::string& effort) {
  const geometry::Polygon outline(
      geometry::columns({{-0.05, -0.015}, {0.05, -0.015}, {0.05, 0.015}, {-0.05, 0.015}}));
  Problem problem = slide::make_problem(slide::tables()[0], Object::prism("bar", outline, 0.05),
                                        slide::flat(0.6, 0.1, 0.4));
  std::string urdf = problem.robot.urdf();
  const std::string given = "velocity=\"3\" effort=\"2\"";
  for (std::size_t at = urdf.find(given); at != std::string::npos; at = urdf.find(given, at + 1))
    urdf.replace(at, given.size(), "velocity=\"3\" effort=\"" + effort + "\"");
  problem.robot = robot::Robot::from_urdf(urdf, problem.robot.options());
  return problem;
}

/// The work of the motor is that of the force on both fingers.
TEST(PinchPress, IsThatOfHalfTheEffort) {
  for (const auto& [effort, factor] : {std::pair("2", 1.0), {"6", 3.0}}) {
    const Problem problem = before_hand(effort);
    const Jaw jaw(problem);
    const Press press(problem, {}, jaw);
    EXPECT_EQ(press.unknown(), "");
    for (const double width : {0.01, 0.03, 0.05}) {
      const Eigen::VectorXd q = jaw.at_width(width)->q;
      const int joint = problem.robot.joint("left_finger_joint");
      Eigen::VectorXd closer = q;
      closer[joint] += 1e-3;
      const double per_radian = (jaw.gap(q) - jaw.gap(closer)) / 1e-3;
      EXPECT_NEAR(press.at(width) * per_radian, factor * kEffort / 2, 0.01 * factor);
    }
  }
}

/// check() computes it with Jacobians, not with the jaw.
TEST(PinchPress, IsTheSameInTheCheck) {
  const Problem problem = before_hand("2");
  const Plan found = pinch::plan(problem);
  ASSERT_TRUE(found) << found.reason;
  const double width = (found.contacts_O.col(1) - found.contacts_O.col(0)).norm();
  const auto force = finger_force(problem, found, {});
  ASSERT_TRUE(force);
  EXPECT_NEAR(*force, Press(problem, {}, Jaw(problem)).at(width), 0.05 * *force);
}

TEST(PinchPress, IsThatOfTheOptionIfItIsGiven) {
  const Problem problem = before_hand("0");
  Options options;
  options.grip_force = 8;
  const Press press(problem, options, Jaw(problem));
  EXPECT_EQ(press.at(0.03), 8);
  EXPECT_EQ(press.unknown(), "");
}

TEST(PinchPress, OfAHandWithoutLimitsIsUnknown) {
  const Problem problem = before_hand("0");
  EXPECT_EQ(Press(problem, {}, Jaw(problem)).unknown(), "left_finger_joint");
  const Plan found = pinch::plan(problem);  // of a prism, of whose weight nothing is promised
  ASSERT_TRUE(found) << found.reason;
  EXPECT_FALSE(finger_force(problem, found, {}));
  EXPECT_FALSE(found.max_mass);
  EXPECT_TRUE(check(problem, found).empty());
  Plan boastful = found;
  boastful.max_mass = 0.1;
  const std::vector<std::string> faults = check(problem, boastful);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].find("effort limit of a joint that closes the hand is unknown"),
            std::string::npos);
}

}  // namespace
}  // namespace graspless::pinch
