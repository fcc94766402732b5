// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/hand/reach.hpp"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "clasp/hand/kinematics.hpp"
#include "clasp/hands.hpp"
#include "paths.hpp"
#include "robot/robots.hpp"

namespace graspless::clasp {
namespace {

/// The largest excess of the hand's corners over random configurations.
double farthest_excess(const RobotWithHand& r, const Reach& reach) {
  HandKinematics hand(r.robot, r.hand);
  std::mt19937_64 rng(1);
  double farthest = -reach.radius;
  for (int i = 0; i < 2000; ++i) {
    Eigen::VectorXd q = robot::random_q(r.robot, rng);
    // The hand between open and closed, as it is in a search.
    const double t = i % 5 / 4.0;
    const Eigen::VectorXd &open = r.robot.state(r.hand.open),
                          &closed = r.robot.state(r.hand.closed);
    for (const int j : r.robot.group(r.hand.hand)) q[j] = open[j] + t * (closed[j] - open[j]);
    hand.update(q);
    for (const auto& p_W : hand.nodes().colwise()) {
      farthest = std::max(farthest, reach.excess(p_W));
    }
  }
  return farthest;
}

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// The KR 5 with the SDH whose first joint does not turn about the vertical but slides along y,
/// from `lower` to `upper` [m].
RobotWithHand on_a_rail(const std::string& lower, const std::string& upper) {
  const std::string stem = urdf_file("kr5_sdh");
  std::string urdf = text_of(stem + ".urdf");
  std::size_t at = urdf.find("name=\"kr5_joint_1\"");
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"revolute", "prismatic"},
                                 {"0 0 1", "0 1 0"},
                                 {"lower=\"-2.9670597283903604\"", "lower=\"" + lower + "\""},
                                 {"upper=\"2.9670597283903604\"", "upper=\"" + upper + "\""}}) {
    at = urdf.find(from, at);
    EXPECT_NE(at, std::string::npos) << from;
    urdf.replace(at, from.size(), to);
  }
  robot::Robot::Options options;
  options.srdf = text_of(stem + ".srdf");
  return {robot::Robot::from_urdf(urdf, options), hand_from_yaml_file(stem + ".clasp.yaml")};
}

class ArmReach : public ::testing::TestWithParam<std::string> {};

TEST_P(ArmReach, NoConfigurationLeavesIt) {
  const RobotWithHand r = robot_with_hand(GetParam());
  const double farthest = farthest_excess(r, arm_reach(r.robot, r.hand, r.robot.state("home")));
  EXPECT_LE(farthest, 0);
  EXPECT_GT(farthest, -0.4) << "the ball is much too large";
}

TEST_P(ArmReach, IsTheSameWhereverTheArmStands) {
  const RobotWithHand r = robot_with_hand(GetParam());
  const Reach at_home = arm_reach(r.robot, r.hand, r.robot.state("home"));
  const int first = r.robot.group(r.hand.arm).front();
  Eigen::VectorXd q = r.robot.state("home");
  for (const double away : {-0.05, 0.0, 0.05, 0.1}) {
    q[first] = (r.robot.lower()[first] + r.robot.upper()[first]) / 2 + away;
    const Reach reach = arm_reach(r.robot, r.hand, q);
    EXPECT_EQ(reach.base_W, at_home.base_W) << away;
    EXPECT_EQ(reach.radius, at_home.radius) << away;
  }
}

INSTANTIATE_TEST_SUITE_P(Hands, ArmReach, ::testing::ValuesIn(robots_with_hands()),
                         [](const auto& info) { return info.param; });

TEST(ArmReach, CountsTheWayThatAnArmSlides) {
  const RobotWithHand fixed = on_a_rail("-0.001", "0.001"), sliding = on_a_rail("-1", "3");
  const auto reach_of = [](const RobotWithHand& r) {
    return arm_reach(r.robot, r.hand, r.robot.state("home"));
  };
  const Reach reach = reach_of(sliding);
  EXPECT_NEAR(reach.radius, reach_of(fixed).radius + 1.999, 1e-9);
  EXPECT_NEAR(reach.base_W.y(), 1, 1e-12);
  EXPECT_LE(farthest_excess(sliding, reach), 0);
}

}  // namespace
}  // namespace graspless::clasp
