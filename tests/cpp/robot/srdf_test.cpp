// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "graspless/robot/robot.hpp"

#include "paths.hpp"
#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

Robot with(const std::string& body) {
  Robot::Options options;
  options.srdf = "<robot name='oddity'>\n" + body + "</robot>";
  return Robot::from_urdf_file(data_file("oddity.urdf"), options);
}

std::string fault_of_group(const std::string& body, const std::string& group = "g") {
  const Robot robot = with(body);
  return complaint([&] { robot.group(group); });
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

TEST(Srdf, DisablesTheDefaultCollisionsOfALink) {
  const std::string all = "<disable_default_collisions link='tip'/>";
  const auto is_ignored = [](const Robot& robot, const std::string& a, const std::string& b) {
    const std::pair<int, int> pair = std::minmax({robot.frame(a), robot.frame(b)});
    return robot.ignored_pairs().count(pair) == 1;
  };
  const Robot robot = with(all);
  EXPECT_TRUE(robot.warnings().empty());
  for (const std::string& other : robot.frame_names())
    EXPECT_EQ(is_ignored(robot, other, "tip"), other != "tip") << other;
  const Robot enabled = with("<enable_collisions link1='root' link2='tip'/>" + all);
  EXPECT_FALSE(is_ignored(enabled, "root", "tip"));
  EXPECT_TRUE(is_ignored(enabled, "slide", "tip"));
  EXPECT_FALSE(with("<disable_default_collisions link='x'/>").warnings().empty());
}

TEST(Srdf, SkipsGroupsWithUnknownNames) {
  EXPECT_EQ(fault_of_group("<group name='g'><joint name='x'/></group>"),
            "group 'g' cannot be used: SRDF line 2: the URDF has no joint 'x'");
  EXPECT_CONTAINS(fault_of_group("<group name='g'><link name='x'/></group>"), "no link 'x'");
  EXPECT_CONTAINS(fault_of_group("<group name='g'><chain base_link='x' tip_link='tip'/></group>"),
                  "no link 'x'");
  EXPECT_CONTAINS(
      fault_of_group("<group name='g'><chain base_link='tip' tip_link='root'/></group>"),
      "'root' is not below link 'tip'");
  EXPECT_CONTAINS(fault_of_group("<group name='g'><group name='x'/></group>"), "no group 'x'");
  EXPECT_CONTAINS(
      fault_of_group(
          "<group name='g'><group name='h'/></group><group name='h'><group name='g'/></group>"),
      "contains itself");
  EXPECT_CONTAINS(fault_of_group("<group name='g'><joint/></group>"), "no attribute 'name'");
}

TEST(Srdf, ReadsTheRestOfAFileWithUnknownNames) {
  const Robot robot = with(
      "<virtual_joint name='base' type='fixed' parent_frame='world' child_link='root'/>\n"
      "<group name='arm'><joint name='base'/><joint name='joint10'/></group>\n"
      "<group name='bad'><joint name='x'/></group><group name='worse'><group name='bad'/></group>\n"
      "<group_state name='home'><joint name='joint10' value='0.5'/>"
      "<joint name='floating_base' value='0 0 1 0 0 0 1'/></group_state>\n"
      "<group_state name='lost' group='arm'><joint name='x' value='0'/></group_state>\n"
      "<disable_collisions link1='tip' link2='x'/>\n<disable_collisions link1='tip'/>\n"
      "<passive_joint name='x'/><end_effector name='e' parent_link='x' group='x'/>");
  EXPECT_EQ(robot.group_names(), std::vector<std::string>{"arm"});
  EXPECT_EQ(robot.group("arm"), std::vector<int>{0});
  EXPECT_EQ(robot.state_names(), std::vector<std::string>{"home"});
  EXPECT_EQ(robot.state("home")[0], 0.5);
  const std::vector<std::string> expected = {
      "SRDF line 4: the URDF has no joint 'x'; skipped",  // of the group, and of the one that
                                                          // contains it
      "SRDF line 4: the URDF has no joint 'x'; skipped",
      "SRDF line 5: joint 'floating_base' is not in the URDF; skipped",
      "SRDF line 6: the URDF has no joint 'x'; skipped",
      "SRDF line 7: the URDF has no link 'x'; skipped",
      "SRDF line 8: <disable_collisions> has no attribute 'link2'; skipped"};
  EXPECT_EQ(robot.warnings(), expected);
  EXPECT_TRUE(with("<group name='g'><joint name='joint10'/></group>").warnings().empty());
  EXPECT_CONTAINS(complaint([] { with("<group name='g'>"); }), "not XML");
}

TEST(Srdf, SkipsStatesThatCannotBe) {
  const auto state = [](const std::string& value) {
    const Robot robot =
        with("<group name='g'/><group_state name='s' group='g'><joint name='joint10' value='" +
             value + "'/></group_state>");
    EXPECT_EQ(robot.warnings().size(), 1u);
    return complaint([&] { robot.state("s"); });
  };
  EXPECT_CONTAINS(state("2.5"), "joint 'joint10': 2.5 is outside its limits -1 to");
  EXPECT_CONTAINS(state("0,5"), "state 's' cannot be used: SRDF line 2: joint 'joint10': '0,5'");
  EXPECT_CONTAINS(state(""), "not a number");
  const Robot robot = with("<group_state name='s' group='x'/>");
  EXPECT_CONTAINS(complaint([&] { robot.state("s"); }), "the SRDF has no group 'x'");
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
  EXPECT_CONTAINS(complaint([&] { with(elements); }),
                  "SRDF line 101: elements may be nested 100 deep at most");
  const auto add = [&](int from, int to) {
    for (int i = from; i < to; ++i) {
      groups += "<group name='g" + std::to_string(i) + "'><group name='g" + std::to_string(i - 1) +
                "'/></group>\n";
    }
  };
  add(1, 100);
  EXPECT_EQ(with(groups).group("g99").size(), 1u);
  add(100, 100000);
  EXPECT_CONTAINS(fault_of_group(groups, "g99999"), "is contained in 100 others, more than 99");
}

}  // namespace
}  // namespace graspless::robot
