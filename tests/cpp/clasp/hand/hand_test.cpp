// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/hand.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "clasp/hands.hpp"
#include "complaint.hpp"
#include "other_locale.hpp"
#include "paths.hpp"

namespace graspless::clasp {
namespace {

const std::string kHand = R"(frame: palm
forward: [0, 0, 2]
sideways: [0, 1, 0]
fingers:
  finger_1:
    - {link: palm, point: [0.019, 0.033, 0.0745]}
    - {link: finger_1_distal, point: [0, 0, 0.0675]}
thumb:
  - {link: palm, point: [-0.038, 0, 0.0745]}
  - {link: thumb_distal}
)";

/// kHand with the first `from` replaced.
std::string changed(const std::string& from, const std::string& to) {
  std::string text = kHand;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expect_refused_text(const std::string& text, const std::string& words) {
  expect_refused([&] { hand_from_yaml(text, "my.yaml"); }, words);
}

TEST(HandYaml, ReadsWhatItSays) {
  const Hand hand = hand_from_yaml(kHand + "arm: lift\nhand: claw\nopen: wide\nclosed: fist\n");
  EXPECT_EQ(hand.arm, "lift");
  EXPECT_EQ(hand.hand, "claw");
  EXPECT_EQ(hand.frame, "palm");
  EXPECT_EQ(hand.open, "wide");
  EXPECT_EQ(hand.closed, "fist");
  EXPECT_EQ(hand.forward_H, Eigen::Vector3d::UnitZ());  // of any length in the file
  EXPECT_EQ(hand.sideways_H, Eigen::Vector3d::UnitY());
  ASSERT_EQ(hand.fingers.size(), 1u);
  EXPECT_EQ(hand.fingers[0].name, "finger_1");
  ASSERT_EQ(hand.fingers[0].nodes.size(), 2u);
  EXPECT_EQ(hand.fingers[0].nodes[0].link, "palm");
  EXPECT_EQ(hand.fingers[0].nodes[0].p_L, Eigen::Vector3d(0.019, 0.033, 0.0745));
  EXPECT_EQ(hand.thumb.name, "thumb");
  EXPECT_EQ(hand.thumb.nodes[1].link, "thumb_distal");
  EXPECT_EQ(hand.thumb.nodes[1].p_L, Eigen::Vector3d::Zero());
}

TEST(HandFile, HasDecimalPointsUnderAnyLocale) {
  const Hand here = hand_from_yaml(kHand);
  const OtherLocale comma;
  const Hand there = hand_from_yaml(kHand);
  EXPECT_EQ(there.forward_H, here.forward_H);
  for (std::size_t i = 0; i < here.thumb.nodes.size(); ++i)
    EXPECT_EQ(there.thumb.nodes[i].p_L, here.thumb.nodes[i].p_L);
}

TEST(HandYaml, ReadsSeveralPreShapes) {
  const Hand hand = hand_from_yaml(kHand + "open: [wide, hook, flat]\n");
  EXPECT_EQ(hand.open, "wide");
  EXPECT_EQ(hand.pre_shapes, (std::vector<std::string>{"hook", "flat"}));
  EXPECT_TRUE(hand_from_yaml(kHand + "open: [wide]\n").pre_shapes.empty());
  expect_refused_text(kHand + "open: []\n", "my.yaml:11: open must be a name, or a list of names");
  expect_refused_text(kHand + "open: [wide, {}]\n", "my.yaml:11: open[1] must be a name");
  expect_refused_text(kHand + "open: {}\n", "my.yaml:11: open must be a name, or a list of names");
}

TEST(HandYaml, HasDefaults) {
  const Hand hand = hand_from_yaml(kHand);
  EXPECT_EQ(hand.arm, "arm");
  EXPECT_EQ(hand.hand, "hand");
  EXPECT_EQ(hand.open, "open");
  EXPECT_EQ(hand.closed, "closed");
}

TEST(HandYaml, KeepsTheOrderOfTheFingers) {
  const Hand hand = robot_with_hand("kr5_icub").hand;
  ASSERT_EQ(hand.fingers.size(), 4u);
  EXPECT_EQ(hand.fingers[0].name, "index");
  EXPECT_EQ(hand.fingers[3].name, "pinky");
}

TEST(HandYaml, NamesFileAndLineOfWhatItRefuses) {
  expect_refused_text(changed("sideways", "sidewards"),
                      "my.yaml:3: unknown key 'sidewards' of a hand; choose from arm, hand, frame");
  expect_refused_text(
      changed("point: [0, 0, 0.0675]", "at: [0, 0, 0.0675]"),
      "my.yaml:7: unknown key 'at' of fingers.finger_1[1]; choose from link, point");
  expect_refused_text(changed("0.0675", "tip"),
                      "my.yaml:7: fingers.finger_1[1].point[2] must be a finite number, not 'tip'");
  expect_refused_text(changed("0.0675", ".nan"), "must be a finite number, not '.nan'");
  expect_refused_text(changed("[0, 0, 2]", "[0, 2]"),
                      "my.yaml:2: forward must be a list of 3 numbers, not of 2");
  expect_refused_text(changed("[0, 0, 2]", "up"), "my.yaml:2: forward must be a list of 3 numbers");
  expect_refused_text(changed("[0, 0, 2]", "[0, 0, 0]"), "my.yaml:2: forward must not be zero");
  expect_refused_text(changed("{link: thumb_distal}", "{point: [0, 0, 0]}"),
                      "my.yaml:10: thumb[1] needs 'link'");
  expect_refused_text(changed("{link: thumb_distal}", "{link: [a]}"),
                      "my.yaml:10: link must be a name");
  expect_refused_text(kHand + "frame: palm\n", "my.yaml:11: a hand has 'frame' twice");
}

TEST(HandYaml, NamesWhatIsMissing) {
  for (const std::string field : {"frame", "forward", "sideways", "fingers", "thumb"}) {
    std::string text = kHand;
    text.replace(text.find(field + ":"), field.size(), "open");
    expect_refused_text(text, "a hand needs '" + field + "'");
  }
}

TEST(HandYaml, NeedsAFingerAndAThumbOfTwoNodes) {
  expect_refused_text(changed("  - {link: thumb_distal}\n", ""),
                      "thumb must be a list of at least 2 nodes");
  expect_refused_text(
      "frame: palm\nforward: [0, 0, 1]\nsideways: [0, 1, 0]\nfingers: {}\nthumb: []",
      "my.yaml:4: fingers must name at least one finger besides the thumb");
  expect_refused_text(
      "frame: palm\nforward: [0, 0, 1]\nsideways: [0, 1, 0]\nfingers: [a, b]\nthumb: []",
      "my.yaml:4: fingers must be a mapping");
}

TEST(HandYaml, RefusesWhatIsNoHand) {
  expect_refused_text("", "a hand must be a mapping");
  expect_refused_text("- 1\n- 2\n", "a hand must be a mapping");
  expect_refused_text("frame: palm\nforward: [0, 0\nsideways: ]\n", "not YAML");
  expect_refused_text("? [1, 2]\n: 3\n", "must be a word");
  expect_refused([] { hand_from_yaml_file("/no/such.yaml"); }, "/no/such.yaml");
  expect_refused([] { hand_from_yaml_file(urdf_file()); }, urdf_file());
}

class HandValidate : public testing::Test {
 protected:
  void expect_invalid(const std::string& words) const {
    expect_refused([&] { validate(given_.hand, given_.robot); }, words);
  }

  RobotWithHand given_ = robot_with_hand("kr5_sdh");
  Hand& hand_ = given_.hand;
};

TEST_F(HandValidate, AcceptsOurHands) {
  for (const std::string& name : robots_with_hands()) {
    const RobotWithHand given = robot_with_hand(name);
    EXPECT_NO_THROW(validate(given.hand, given.robot)) << name;
  }
}

TEST_F(HandValidate, NamesUnknownGroupsStatesAndLinks) {
  hand_.arm = "leg";
  expect_invalid("hand.arm: unknown group 'leg'; choose from arm, hand");
  hand_ = robot_with_hand("kr5_sdh").hand;
  hand_.hand = "foot";
  expect_invalid("hand.hand: unknown group 'foot'");
  hand_ = robot_with_hand("kr5_sdh").hand;
  hand_.open = "ajar";
  expect_invalid("hand.open: unknown state 'ajar'; choose from");
  hand_ = robot_with_hand("kr5_sdh").hand;
  hand_.frame = "wrist";
  expect_invalid("hand.frame: unknown link 'wrist'; choose from base_link");
  hand_ = robot_with_hand("kr5_sdh").hand;
  hand_.fingers[1].nodes[2].link = "nail";
  expect_invalid("hand.fingers.finger_2.nodes[2].link: unknown link 'nail'");
}

TEST_F(HandValidate, NeedsFingersThatCloseAgainstAThumb) {
  hand_.fingers[0].nodes.back() = {"palm", Eigen::Vector3d(0, 0, 0.2)};
  expect_invalid("hand.fingers.finger_1: its tip, on link 'palm', is moved by no joint");
  hand_ = robot_with_hand("kr5_sdh").hand;
  hand_.fingers[1].name = "finger_1";
  expect_invalid("hand.fingers has 'finger_1' twice");
  hand_.fingers.clear();
  expect_invalid("at least one finger besides the thumb");
  hand_ = robot_with_hand("kr5_sdh").hand;
  hand_.thumb.nodes.resize(1);
  expect_invalid("hand.thumb must have at least 2 nodes, from the palm to the tip, not 1");
}

TEST_F(HandValidate, NeedsFingersThatMeetTheThumbInThePalm) {
  auto& nodes = hand_.fingers[1].nodes;
  std::reverse(nodes.begin(), nodes.end() - 1);  // the distal joint first
  expect_invalid("hand.fingers.finger_2 does not meet the thumb: joints of the group 'hand' move");
  hand_ = robot_with_hand("kr5_sdh").hand;
  hand_.thumb.nodes.erase(hand_.thumb.nodes.begin(), hand_.thumb.nodes.begin() + 2);
  expect_invalid("on link 'thumb_distal'; nodes run from the palm to the tip");
}

TEST_F(HandValidate, NeedsFingersThatMeetTheThumbNearby) {
  hand_.thumb.nodes.front().p_L.x() -= 0.5;
  expect_invalid("hand.fingers.finger_1 does not meet the thumb: their first nodes, on links");
}

TEST_F(HandValidate, RefusesCornersThatCoincide) {
  hand_.fingers[0].nodes[2] = hand_.fingers[0].nodes[1];
  expect_invalid("hand.fingers.finger_1: corners 1 and 2 of the curve");
  hand_ = robot_with_hand("kr5_sdh").hand;
  hand_.thumb.nodes[0] = hand_.fingers[1].nodes[0];  // where finger and thumb meet
  expect_invalid("hand.fingers.finger_2: corners 3 and 4 of the curve");
  hand_ = robot_with_hand("kr5_sdh").hand;
  hand_.fingers[0].nodes.back() = hand_.thumb.nodes.back();  // the tips
  expect_invalid("hand.fingers.finger_1: corners 0 and 7 of the curve");
}

TEST_F(HandValidate, RefusesPointsFarAwayOrNotFinite) {
  hand_.thumb.nodes[3].p_L.z() = 67.5;  // millimetres
  expect_invalid("hand.thumb.nodes[3].point must be finite and within 1 m");
  hand_.thumb.nodes[3].p_L.z() = std::numeric_limits<double>::quiet_NaN();
  expect_invalid("hand.thumb.nodes[3].point must be finite");
}

TEST_F(HandValidate, NeedsOrthogonalUnitVectors) {
  hand_.forward_H = Eigen::Vector3d(0, 0, 2);
  expect_invalid("hand.forward must be a unit vector");
  hand_.forward_H = Eigen::Vector3d(0, 1, 1).normalized();
  expect_invalid("must be orthogonal to hand.forward");
}

TEST_F(HandValidate, NeedsPreShapesThatCloseOnceEach) {
  hand_.pre_shapes = {"ajar"};
  expect_invalid("hand.pre_shapes[0]: unknown state 'ajar'; choose from");
  hand_.pre_shapes = {"home", hand_.open};
  expect_invalid("hand.pre_shapes[1] is 'open' again; each may occur only once");
  hand_.pre_shapes = {hand_.closed};
  expect_invalid("hand.pre_shapes[0] 'closed' and hand.closed 'closed' are the same");
  hand_.pre_shapes = {"home"};
  EXPECT_NO_THROW(validate(hand_, given_.robot));
}

TEST_F(HandValidate, NeedsAnArmThatCarriesAnotherHandThatCloses) {
  hand_.closed = hand_.open;
  expect_invalid("hand.open 'open' and hand.closed 'open' are the same");
  hand_ = robot_with_hand("kr5_sdh").hand;
  hand_.hand = "arm";
  expect_invalid("share the joint 'kr5_joint_1'");
  hand_ = robot_with_hand("kr5_sdh").hand;
  hand_.frame = "kr5_link_3";
  expect_invalid("hand.frame 'kr5_link_3' is not carried by the group 'arm'");
}

}  // namespace
}  // namespace graspless::clasp
