// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "graspless/robot/description.hpp"

#include "paths.hpp"
#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

const std::string kArm =
    "<robot name='arm'><material name='red'><color rgba='1 0 0 1'/></material>"
    "<link name='world'/><link name='base'><collision><geometry><box size='1 1 1'/></geometry>"
    "</collision></link><link name='tool0'/>"
    "<joint name='root' type='floating'><parent link='world'/><child link='base'/></joint>"
    "<joint name='turn' type='revolute'><parent link='base'/><child link='tool0'/>"
    "<origin xyz='0 0 1'/><axis xyz='0 0 1'/>"
    "<limit lower='-1' upper='1' velocity='1' effort='1'/></joint></robot>";

const std::string kGripper =
    "<robot name='two'><material name='red'><color rgba='1 0 0 1'/></material>"
    "<link name='world'/><link name='palm'><collision><geometry>"
    "<mesh filename='tetrahedron.obj'/></geometry></collision></link>"
    "<link name='left'><visual><geometry><mesh filename='package://none/a.stl'/></geometry>"
    "<material name='red'/></visual></link><link name='right'/>"
    "<joint name='root' type='floating'><parent link='world'/><child link='palm'/></joint>"
    "<joint name='turn' type='prismatic'><parent link='palm'/><child link='left'/>"
    "<axis xyz='0 1 0'/><limit lower='0' upper='0.04' velocity='1' effort='1'/></joint>"
    "<joint name='follow' type='prismatic'><parent link='palm'/><child link='right'/>"
    "<axis xyz='0 -1 0'/><limit lower='0' upper='0.04' velocity='1' effort='1'/>"
    "<mimic joint='turn'/></joint>"
    "<gazebo reference='left'><kp>1</kp></gazebo><gazebo reference='turn'/></robot>";

Description arm() {
  return {kArm,
          "<robot name='arm'><group name='arm'><joint name='turn'/></group>"
          "<group_state name='home' group='arm'><joint name='turn' value='0.5'/></group_state>"
          "</robot>",
          {},
          ""};
}

Description gripper() {
  return {kGripper,
          "<robot name='two'><group name='arm'><joint name='turn'/></group>"
          "<group name='hand'><group name='arm'/></group>"
          "<group_state name='home' group='arm'><joint name='turn' value='0.04'/></group_state>"
          "<disable_collisions link1='left' link2='right'/></robot>",
          {},
          data_file()};
}

Mount tool(const std::string& prefix = "") {
  Mount mount{"tool0", Eigen::Isometry3d::Identity(), prefix, {}};
  mount.X_MG.translation() << 0.1, 0.2, 0.3;
  mount.X_MG.linear() = (Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()) *
                         Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitY()) *
                         Eigen::AngleAxisd(2.9, Eigen::Vector3d::UnitX()))
                            .toRotationMatrix();
  return mount;
}

Robot read(const Description& robot) {
  return Robot::from_urdf(robot.urdf, {robot.srdf, robot.packages, robot.directory});
}

TEST(Join, CarriesTheGripper) {
  const Robot robot = read(join(arm(), gripper(), tool()));
  EXPECT_EQ(robot.name(), "arm_two");
  EXPECT_EQ(robot.joint_names(), (std::vector<std::string>{"turn", "gripper_turn"}));
  EXPECT_EQ(robot.frame_names(),
            (std::vector<std::string>{"world", "base", "tool0", "gripper_world", "palm", "left",
                                      "right"}));
  const Eigen::Vector2d q(0.3, 0.02);
  const Eigen::Isometry3d X_WT = robot.pose(robot.frame("tool0"), q);
  EXPECT_LT(distance(robot.pose(robot.frame("palm"), q), X_WT * tool().X_MG), 1e-12);
  const Eigen::Vector3d left(0, 0.02, 0), right(0, -0.02, 0);
  EXPECT_TRUE(robot.pose(robot.frame("left"), q).translation().isApprox(X_WT * tool().X_MG * left));
  EXPECT_TRUE(
      robot.pose(robot.frame("right"), q).translation().isApprox(X_WT * tool().X_MG * right));
  EXPECT_EQ(robot.shapes().size(), 2u);  // the mesh is found from any directory
}

TEST(Join, KeepsNamespaces) {
  const std::string drake = " xmlns:drake='http://drake.mit.edu'";
  const std::string other = " xmlns:drake='elsewhere' xmlns:xacro='http://ros.org/wiki/xacro'";
  Description a = arm(), g = gripper();
  a.urdf.insert(a.urdf.find("<robot") + 6, drake);
  g.urdf.insert(g.urdf.find("<robot") + 6, other);
  const std::string joined = join(a, g, tool()).urdf;
  EXPECT_NE(joined.find("xmlns:drake=\"http://drake.mit.edu\""), std::string::npos) << joined;
  EXPECT_NE(joined.find("xmlns:xacro=\"http://ros.org/wiki/xacro\""), std::string::npos);
  EXPECT_EQ(joined.find("elsewhere"), std::string::npos);
}

TEST(Join, MergesTheSrdfs) {
  const Robot robot = read(join(arm(), gripper(), tool()));
  EXPECT_EQ(robot.group_names(), (std::vector<std::string>{"arm", "gripper_arm", "hand"}));
  EXPECT_EQ(robot.group("hand"), std::vector<int>{1});
  EXPECT_EQ(robot.state("home"), Eigen::VectorXd(Eigen::Vector2d(0.5, 0.04)));
  EXPECT_EQ(robot.ignored_pairs().count({5, 6}), 1u);
  Description bare_arm = arm(), bare_gripper = gripper();
  bare_arm.srdf.clear();
  EXPECT_EQ(read(join(bare_arm, gripper(), tool())).group("arm"), std::vector<int>{1});
  bare_gripper.srdf.clear();
  EXPECT_EQ(join(bare_arm, bare_gripper, tool()).srdf, "");
}

TEST(Join, PutsThePrefixBeforeAllNames) {
  Description hand = gripper();
  hand.srdf.insert(hand.srdf.rfind("</robot>"),
                   "<virtual_joint name='v' type='fixed' parent_frame='w' child_link='palm'/>"
                   "<end_effector name='e' parent_link='palm' parent_group='arm' group='hand'/>"
                   "<disable_default_collisions link='left'/>");
  const Description joined = join(arm(), hand, tool("left_"));
  const Robot robot = read(joined);
  for (const char* renamed : {"child_link=\"left_palm\"", "parent_group=\"left_arm\"",
                              "<disable_default_collisions link=\"left_left\""}) {
    EXPECT_CONTAINS(joined.srdf, renamed);
  }
  EXPECT_EQ(robot.joint_names(), (std::vector<std::string>{"turn", "left_turn"}));
  EXPECT_EQ(robot.group_names(), (std::vector<std::string>{"arm", "left_arm", "left_hand"}));
  EXPECT_EQ(robot.frame("left_palm"), 4);
  EXPECT_CONTAINS(joined.urdf, "<gazebo reference=\"left_left\">");
  EXPECT_CONTAINS(joined.urdf, "<gazebo reference=\"left_turn\"");
  EXPECT_CONTAINS(joined.urdf, "package://none/a.stl");  // found when it is drawn, or never
}

TEST(Join, TakesTheSameGripperTwice) {
  const Description one = join(arm(), gripper(), tool("left_"));
  const Robot robot = read(join(one, gripper(), tool("right_")));
  EXPECT_EQ(robot.dof(), 3);
  EXPECT_EQ(robot.parent(robot.frame("right_world")), robot.frame("tool0"));
}

TEST(Join, TakesAPartOfTheGripper) {
  Mount mount = tool();
  mount.root = "palm";
  const Description joined = join(arm(), gripper(), mount);
  const Robot robot = read(joined);
  EXPECT_EQ(robot.frame_names(),
            (std::vector<std::string>{"world", "base", "tool0", "palm", "left", "right"}));
  EXPECT_EQ(robot.parent(robot.frame("palm")), robot.frame("tool0"));
  EXPECT_EQ(robot.group_names(), std::vector<std::string>{"arm"});  // of the arm's SRDF alone
  const Eigen::Vector2d q(0.3, 0.02);
  EXPECT_LT(distance(robot.pose(robot.frame("palm"), q),
                     robot.pose(robot.frame("tool0"), q) * mount.X_MG),
            1e-12);
  mount.root = "hand";
  EXPECT_CONTAINS(complaint([&] { join(arm(), gripper(), mount); }), "unknown root 'hand'");
}

TEST(Join, RefusesWhatDoesNotFit) {
  const auto refused = [](const Description& a, const Description& b, const Mount& mount) {
    return complaint([&] { join(a, b, mount); });
  };
  Mount mount = tool();
  mount.link = "flange";
  EXPECT_CONTAINS(refused(arm(), gripper(), mount),
                  "unknown mount 'flange'; choose from base, tool0, world");
  EXPECT_CONTAINS(refused({"<robot", "", {}, ""}, gripper(), tool()), "arm: URDF line 1: not XML");
  EXPECT_CONTAINS(refused(arm(), {"<robot name='r'/>", "", {}, ""}, tool()),
                  "gripper: URDF line 1: the robot has no links");
  Description bad = gripper();
  bad.srdf = "<robot";
  EXPECT_CONTAINS(refused(arm(), bad, tool()), "gripper: SRDF line 1: not XML");
  const Description joined = join(arm(), gripper(), tool());
  EXPECT_CONTAINS(refused(joined, gripper(), tool()),
                  "prefix: link 'gripper_world' occurs in both descriptions; give another prefix");
  Mount nowhere = tool();
  nowhere.X_MG.translation().x() = std::nan("");
  EXPECT_CONTAINS(refused(arm(), gripper(), nowhere), "mount.X_MG must be a rigid pose");
}

}  // namespace
}  // namespace graspless::robot
