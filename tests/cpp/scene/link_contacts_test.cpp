// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/scene/link_contacts.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace graspless::scene {
namespace {

using Pair = std::pair<int, int>;

/// A base, a link that swings about z over it, one at its end that always overlaps the base's
/// column, and one too far away to touch anything.
const char* const kSwing = R"(
<robot name="swing">
  <link name="base"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="upper"><collision><origin xyz="0.5 0 0"/>
    <geometry><box size="0.3 0.1 0.1"/></geometry></collision></link>
  <link name="back"><collision><origin xyz="-0.5 0 0"/>
    <geometry><sphere radius="0.05"/></geometry></collision></link>
  <link name="far"><collision><origin xyz="0 0 3"/>
    <geometry><sphere radius="0.1"/></geometry></collision></link>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/>
    <axis xyz="0 0 1"/></joint>
  <joint name="lift" type="prismatic"><origin xyz="0.5 0 0"/><parent link="upper"/>
    <child link="back"/><axis xyz="0 0 1"/>
    <limit lower="-0.01" upper="0.01" velocity="1" effort="1"/></joint>
  <joint name="mast" type="prismatic"><parent link="back"/><child link="far"/><axis xyz="0 0 1"/>
    <limit lower="0" upper="1" velocity="1" effort="1"/></joint>
</robot>)";

TEST(LinkContacts, FindsPairsThatAlwaysAndNeverTouch) {
  const auto robot = robot::Robot::from_urdf(kSwing, {});
  const LinkContacts found = sample_contacts(robot, 500);
  const int base = robot.frame("base"), upper = robot.frame("upper"), back = robot.frame("back"),
            far = robot.frame("far");
  EXPECT_EQ(found.always, (std::vector<Pair>{{base, back}}));
  EXPECT_EQ(found.never, (std::vector<Pair>{{base, far}, {upper, far}}));
  EXPECT_EQ(sample_contacts(robot, 500, 1, {upper}).never, (std::vector<Pair>{{upper, far}}));
}

TEST(LinkContacts, KeepsPairsThatSometimesTouch) {
  std::string text = kSwing;
  const std::string limits = R"(lower="-0.01" upper="0.01")";
  text.replace(text.find(limits), limits.size(), R"(lower="-0.5" upper="0.5")");
  const auto robot = robot::Robot::from_urdf(text, {});
  const LinkContacts found = sample_contacts(robot, 500);
  EXPECT_TRUE(found.always.empty());
  const Pair sometimes{robot.frame("base"), robot.frame("back")};
  EXPECT_EQ(std::count(found.never.begin(), found.never.end(), sometimes), 0);
}

/// Two arms of three links with a ball of 1 cm at each end, whose shoulders are `apart` [m].
std::string two_arms(double apart) {
  std::string text = R"(<robot name="two"><link name="base"/>)";
  for (const std::string side : {"left_", "right_"}) {
    const double y = side == "left_" ? apart / 2 : -apart / 2;
    std::string parent = "base", at = "0 " + std::to_string(y) + " 0";
    for (const std::string joint : {"0 0 1", "0 1 0", "1 0 0"}) {
      const std::string child = side + std::string(1, static_cast<char>('a' + joint.find('1')));
      text += R"(<link name=")" + child + R"("/><joint name="to_)" + child +
              R"(" type="revolute"><origin xyz=")" + at + R"("/><parent link=")" + parent +
              R"("/><child link=")" + child + R"("/><axis xyz=")" + joint +
              R"("/><limit lower="-2.5" upper="2.5" velocity="1" effort="1"/></joint>)";
      parent = child, at = "0.3 0.02 0";
    }
    text += R"(<link name=")" + side + R"(ball"><collision><geometry><sphere radius="0.01"/>)" +
            R"(</geometry></collision></link><joint name="to_)" + side +
            R"(ball" type="fixed"><origin xyz="0.3 0 0"/><parent link=")" + parent +
            R"("/><child link=")" + side + R"(ball"/></joint>)";
  }
  return text + "</robot>";
}

TEST(LinkContacts, FindsContactsThatAreTooRareForSamples) {
  const auto near = robot::Robot::from_urdf(two_arms(1.5), {});
  const auto far = robot::Robot::from_urdf(two_arms(2.0), {});
  std::size_t missed = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    missed += sample_contacts(near, 500, seed).never.size();
    EXPECT_EQ(sample_contacts(far, 500, seed).never.size(), 1U);
  }
  EXPECT_LE(missed, 1U);
}

TEST(LinkContacts, RefusesCountsOutOfRange) {
  const auto robot = robot::Robot::from_urdf(kSwing, {});
  EXPECT_THROW(sample_contacts(robot, 0), std::invalid_argument);
  EXPECT_THROW(sample_contacts(robot, 1000001), std::invalid_argument);
  EXPECT_THROW(sample_contacts(robot, 10, 1, {4}), std::invalid_argument);
}

}  // namespace
}  // namespace graspless::scene
