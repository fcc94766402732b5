// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "graspless/robot/robot.hpp"

#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

Robot with(const std::string& body) {
  Robot::Options options;
  options.srdf = "<robot name='oddity'>\n" + body + "</robot>";
  return Robot::from_urdf_file(GRASPLESS_TEST_DATA_DIR "/oddity.urdf", options);
}

std::string refused_srdf(const std::string& body) {
  return complaint([&] { with(body); });
}

TEST(Srdf, GroupsNameJointsLinksChainsAndGroups) {
  const Robot robot = with(
      "<group name='all'><group name='joints'/><group name='links'/></group>"
      "<group name='joints'><joint name='a_turn'/><joint name='echo'/><joint name='weld'/></group>"
      "<group name='links'><link name='z_link'/><link name='root'/></group>"
      "<group name='chain'><chain base_link='slide' tip_link='tip'/></group>");
  EXPECT_EQ(robot.group("joints"), std::vector<int>({2}));  // the others have no value of their own
  EXPECT_EQ(robot.group("links"), std::vector<int>({0}));
  EXPECT_EQ(robot.group("all"), std::vector<int>({0, 2}));
  EXPECT_EQ(robot.group("chain"), std::vector<int>({2, 3}));
  EXPECT_EQ(robot.group_names().size(), 4u);
}

TEST(Srdf, StatesOfOneNameAreOne) {
  const Robot robot = with(
      "<group name='a'><joint name='joint10'/></group><group name='b'><joint "
      "name='joint2'/></group>"
      "<group_state name='home' group='a'><joint name='joint10' value='0.5'/></group_state>"
      "<group_state name='home' group='b'><joint name='joint2' value='0.5004'/></group_state>");
  Eigen::VectorXd home(4);
  home << 0.5, 0.5, 0, 0;  // rounded limits are meant
  EXPECT_EQ(robot.state("home"), home);
}

TEST(Srdf, DisablesCollisions) {
  const Robot robot = with("<disable_collisions link1='tip' link2='root' reason='Never'/>");
  EXPECT_EQ(robot.ignored_pairs().count({robot.frame("root"), robot.frame("tip")}), 1u);
}

TEST(Srdf, RefusesUnknownNames) {
  EXPECT_CONTAINS(refused_srdf("<group name='g'><joint name='x'/></group>"),
                  "SRDF line 2: unknown joint 'x'; choose from joint10");
  EXPECT_CONTAINS(refused_srdf("<group name='g'><link name='x'/></group>"), "unknown link 'x'");
  EXPECT_CONTAINS(refused_srdf("<group name='g'><chain base_link='x' tip_link='tip'/></group>"),
                  "link 'x'");
  EXPECT_CONTAINS(refused_srdf("<group name='g'><chain base_link='tip' tip_link='root'/></group>"),
                  "'root' is not below link 'tip'");
  EXPECT_CONTAINS(refused_srdf("<group name='g'><group name='x'/></group>"), "unknown group 'x'");
  EXPECT_CONTAINS(
      refused_srdf(
          "<group name='g'><group name='h'/></group><group name='h'><group name='g'/></group>"),
      "contains itself");
  EXPECT_CONTAINS(refused_srdf("<group_state name='s' group='x'/>"), "unknown group 'x'");
  EXPECT_CONTAINS(refused_srdf("<disable_collisions link1='tip' link2='x'/>"), "unknown link 'x'");
  EXPECT_CONTAINS(refused_srdf("<disable_collisions link1='tip'/>"), "no attribute 'link2'");
  EXPECT_CONTAINS(refused_srdf("<group name='g'>"), "not XML");
}

TEST(Srdf, RefusesValuesThatCannotBe) {
  const auto state = [](const std::string& value) {
    return refused_srdf(
        "<group name='g'/><group_state name='s' group='g'><joint name='joint10' value='" + value +
        "'/></group_state>");
  };
  EXPECT_CONTAINS(state("2.5"), "joint 'joint10': 2.5 is outside its limits -1.0");
  EXPECT_CONTAINS(state("0,5"), "'0,5' is not a number");
  EXPECT_CONTAINS(state(""), "not a number");
}

TEST(Srdf, OursNamesArmAndHand) {
  for (const Robot& robot : {wam(), kr5()}) {
    const auto arm = static_cast<std::size_t>(robot.dof() - 1);
    EXPECT_EQ(robot.group("arm").size(), arm);
    EXPECT_EQ(robot.group("hand"), std::vector<int>({robot.joint("left_finger_joint")}));
    EXPECT_TRUE(robot.is_within(robot.state("home")));
  }
}

TEST(Srdf, RefusesDeepNesting) {
  std::string elements, groups = "<group name='g0'><joint name='joint2'/></group>";
  for (int i = 0; i < 100000; ++i) elements += "<group name='g'>\n";
  EXPECT_CONTAINS(refused_srdf(elements), "SRDF line 101: elements may be nested 100 deep at most");
  const auto add = [&](int from, int to) {
    for (int i = from; i < to; ++i) {
      groups += "<group name='g" + std::to_string(i) + "'><group name='g" + std::to_string(i - 1) +
                "'/></group>\n";
    }
  };
  add(1, 100);
  EXPECT_EQ(with(groups).group("g99").size(), 1u);
  add(100, 100000);
  EXPECT_CONTAINS(refused_srdf(groups), "is contained in 100 others, more than 99");
}

}  // namespace
}  // namespace graspless::robot
