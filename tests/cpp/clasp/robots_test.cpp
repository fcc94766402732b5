// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Our robots that clasp: the published figures, and what a planner of clasps takes for granted.
#include "robot/robots.hpp"

#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "graspless/scene/scene.hpp"

#include "clasp/hands.hpp"
#include "paths.hpp"

namespace graspless::clasp {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

constexpr double kDegree = M_PI / 180;

Isometry3d rot(const Vector3d& axis, double angle) { return Isometry3d(AngleAxisd(angle, axis)); }
Isometry3d rx(double angle) { return rot(Vector3d::UnitX(), angle); }
Isometry3d rz(double angle) { return rot(Vector3d::UnitZ(), angle); }
Isometry3d move(double x, double y, double z) { return Isometry3d(Translation3d(x, y, z)); }

/// Pose of a link in the palm's frame.
Isometry3d in_palm(const robot::Robot& robot, const std::string& link, const Eigen::VectorXd& q) {
  return robot.pose(robot.frame("palm"), q).inverse() * robot.pose(robot.frame(link), q);
}

/// Place of the tip of finger i, or of the thumb for the number of fingers, in the palm's frame.
Vector3d tip_in_palm(const RobotWithHand& r, std::size_t i, const Eigen::VectorXd& q) {
  const Finger& finger = i < r.hand.fingers.size() ? r.hand.fingers[i] : r.hand.thumb;
  return in_palm(r.robot, finger.nodes.back().link, q) * finger.nodes.back().p_L;
}

void expect_near(const Vector3d& given, const Vector3d& expected, double tolerance = 1e-9) {
  EXPECT_LT((given - expected).norm(), tolerance)
      << given.transpose() << " is not " << expected.transpose();
}

class OurHands : public testing::TestWithParam<std::string> {
 protected:
  RobotWithHand given_ = robot_with_hand(GetParam());
  const robot::Robot& robot_ = given_.robot;
  const Hand& hand_ = given_.hand;

  std::vector<Finger> fingers_and_thumb() const {
    std::vector<Finger> all = hand_.fingers;
    all.push_back(hand_.thumb);
    return all;
  }

  /// From the tip of finger i to the thumb's [m].
  double gap(const Finger& finger, const Eigen::VectorXd& q) const {
    return (place(given_, finger.nodes.back(), q) - place(given_, hand_.thumb.nodes.back(), q))
        .norm();
  }
};

TEST_P(OurHands, HaveTheJointsAndCurvesOfThePaper) {
  const std::map<std::string, std::pair<std::size_t, std::size_t>> expected{{"kr5_sdh", {6, 2}},
                                                                            {"kr5_dlr", {12, 3}},
                                                                            {"kr5_icub", {15, 4}},
                                                                            {"kr5_armar", {10, 4}},
                                                                            {"wam_t42", {1, 1}}};
  const auto [joints, curves] = expected.at(GetParam());
  EXPECT_EQ(robot_.group(hand_.hand).size(), joints);
  EXPECT_EQ(hand_.fingers.size(), curves);
  EXPECT_EQ(robot_.group(hand_.arm).size() + joints, static_cast<std::size_t>(robot_.dof()));
}

TEST_P(OurHands, StandWithinTheirLimits) {
  for (const std::string state : {"home", "open", "closed"}) {
    EXPECT_TRUE(robot_.is_within(robot_.state(state))) << state;
  }
  for (const int joint : robot_.group(hand_.hand)) {
    EXPECT_EQ(robot_.state("home")[joint], robot_.state(hand_.open)[joint]);
  }
  EXPECT_TRUE(robot_.max_velocity().allFinite());
}

TEST_P(OurHands, AreFreeOfSelfCollisionWhenOpen) {
  scene::Scene scene(robot_);
  const auto pair = scene.collision(at_home(given_, hand_.open));
  EXPECT_EQ(pair.first, "") << pair.first << " and " << pair.second;
}

TEST_P(OurHands, CloseFromThePreShape) {
  scene::Scene scene(robot_);
  const Eigen::VectorXd open = at_home(given_, hand_.open), closed = at_home(given_, hand_.closed);
  EXPECT_TRUE(scene.is_free(open, open + 0.25 * (closed - open)));
  for (const int joint : robot_.group(hand_.hand)) {
    Eigen::VectorXd q = open;
    q[joint] += 0.25 * (closed[joint] - open[joint]);
    EXPECT_TRUE(scene.is_free(open, q)) << robot_.joint_names()[joint];
  }
}

TEST_P(OurHands, BringEveryTipToTheThumbs) {
  const Eigen::VectorXd open = at_home(given_, hand_.open), closed = at_home(given_, hand_.closed);
  for (const Finger& finger : hand_.fingers) {
    const double wide = gap(finger, open);
    EXPECT_LT(gap(finger, open + 0.1 * (closed - open)), wide) << finger.name;
    EXPECT_LT(gap(finger, closed), 0.6 * wide) << finger.name;
  }
}

TEST_P(OurHands, HaveCurvesOfRigidStretches) {
  std::mt19937_64 rng(1);
  const Eigen::VectorXd home = robot_.state("home");
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::VectorXd q = robot::random_q(robot_, rng);
    for (const Finger& finger : fingers_and_thumb()) {
      for (std::size_t i = 1; i < finger.nodes.size(); ++i) {
        const auto length = [&](const Eigen::VectorXd& at) {
          return (place(given_, finger.nodes[i], at) - place(given_, finger.nodes[i - 1], at))
              .norm();
        };
        EXPECT_GT(length(home), 0.005) << finger.name << i;
        EXPECT_NEAR(length(q), length(home), 1e-9) << finger.name << i;
      }
    }
  }
}

TEST_P(OurHands, FaceForwardAlongThePalm) {
  EXPECT_NEAR(hand_.forward_H.norm(), 1, 1e-12);
  EXPECT_NEAR(hand_.sideways_H.norm(), 1, 1e-12);
  EXPECT_NEAR(hand_.forward_H.dot(hand_.sideways_H), 0, 1e-12);
  // What is clasped lies between the tips: in front of the palm's end of the curves.
  const Eigen::VectorXd open = at_home(given_, hand_.open);
  const Eigen::Matrix3d R_WH = robot_.pose(robot_.frame(hand_.frame), open).linear();
  for (const Finger& finger : hand_.fingers) {
    const Vector3d middle =
        (place(given_, finger.nodes.back(), open) + place(given_, hand_.thumb.nodes.back(), open)) /
        2;
    const Vector3d palm = (place(given_, finger.nodes.front(), open) +
                           place(given_, hand_.thumb.nodes.front(), open)) /
                          2;
    EXPECT_GT((R_WH * hand_.forward_H).dot((middle - palm).normalized()), 0.7) << finger.name;
  }
}

TEST_P(OurHands, AreTestedForCollisionOfFingersThumbAndPalm) {
  const auto& ignored = robot_.ignored_pairs();
  const auto tested = [&](const std::string& a, const std::string& b) {
    const int i = robot_.frame(a), j = robot_.frame(b);
    return ignored.count({std::min(i, j), std::max(i, j)}) == 0;
  };
  const std::string thumb = GetParam() == "wam_t42" ? "right_finger" : "thumb_distal";
  for (const Finger& finger : hand_.fingers) {
    const std::string tip = GetParam() == "wam_t42" ? "left_finger" : finger.nodes.back().link;
    EXPECT_TRUE(tested(tip, thumb)) << tip;
    if (GetParam() != "wam_t42") {
      EXPECT_TRUE(tested(tip, "palm")) << tip;
      EXPECT_TRUE(tested(tip, "thumb_proximal")) << tip;
    }
  }
}

TEST_P(OurHands, HaveMassInEveryLink) {
  std::ifstream file(urdf_file(GetParam() + ".urdf"));
  std::stringstream text;
  text << file.rdbuf();
  const auto count = [&](const std::string& word) {
    int n = 0;
    for (auto at = text.str().find(word); at != std::string::npos;
         at = text.str().find(word, at + 1)) {
      ++n;
    }
    return n;
  };
  EXPECT_GT(count("<link name="), 10);
  EXPECT_EQ(count("<link name="), count("<inertial>"));
  EXPECT_EQ(count("<inertial>"), count("<mass value="));
}

INSTANTIATE_TEST_SUITE_P(, OurHands, testing::ValuesIn(robots_with_hands()),
                         [](const auto& info) { return info.param; });

TEST(Kr5, FlangePointsDownWhereTheDataSheetsNumbersPutIt) {
  // alpha, a, d, offset of the modified Denavit-Hartenberg table [rad, m]
  const double table[6][4] = {{0, 0, 0.335, 0},      {-90, 0.075, 0, 0}, {0, 0.365, 0, -90},
                              {-90, 0.09, 0.405, 0}, {90, 0, 0, 0},      {-90, 0, 0.08, 180}};
  const double degrees[6] = {0, -109, 109, 0, 80, 0};
  Isometry3d X_BF = Isometry3d::Identity();
  for (int i = 0; i < 6; ++i) {
    X_BF = X_BF * rx(table[i][0] * kDegree) * move(table[i][1], 0, 0) *
           rz((table[i][3] + degrees[i]) * kDegree) * move(0, 0, table[i][2]);
  }
  for (const std::string name : {"kr5_sdh", "kr5_dlr", "kr5_icub", "kr5_armar"}) {
    const robot::Robot robot = robot_with_hand(name).robot;
    Eigen::VectorXd q = Eigen::VectorXd::Zero(robot.dof());
    for (std::size_t i = 0; i < 6; ++i) q[robot.group("arm")[i]] = degrees[i] * kDegree;
    const Isometry3d flange = robot.pose(robot.frame("flange"), q);
    EXPECT_LT(robot::distance(flange, X_BF), 1e-9) << name;
    expect_near(flange.translation(), {0.3751, 0, 0.6913}, 1e-4);
    expect_near(flange.linear().col(2), {0.1736, 0, -0.9848}, 1e-4);
  }
}

TEST(SchunkSdh, HasTheHeightsOfItsParts) {
  const RobotWithHand r = robot_with_hand("kr5_sdh");
  const Eigen::VectorXd straight = Eigen::VectorXd::Zero(r.robot.dof());
  const double top = 0.0745 + 0.0165 + 0.0865 + 0.0675;
  expect_near(tip_in_palm(r, 0, straight), {0.01905, 0.033, top});
  expect_near(tip_in_palm(r, 1, straight), {0.01905, -0.033, top});
  expect_near(tip_in_palm(r, 2, straight), {-0.03811, 0, top});
  // The pre-shape: distal links parallel to Z, as far apart as the proximal ones lean out.
  const Eigen::VectorXd open = r.robot.state("open");
  const double out = 0.0865 * std::sin(1.0), up = 0.091 + 0.0865 * std::cos(1.0) + 0.0675;
  expect_near(tip_in_palm(r, 0, open), {0.01905 + out, 0.033, up});
  expect_near(tip_in_palm(r, 2, open), {-0.03811 - out, 0, up});
}

TEST(DlrHand, HasTheBasesAndTheDenavitHartenbergChain) {
  const RobotWithHand r = robot_with_hand("kr5_dlr");
  const Isometry3d bases[4] = {move(-0.00192, 0.1345, 0.03907) * rx(6 * kDegree),
                               move(0, 0.1345, 0),
                               move(-0.00217, 0.1345, -0.03907) * rx(-6 * kDegree),
                               move(-0.04455, 0.0265, 0.01985) * rx(M_PI) * rz(M_PI / 2)};
  const std::string names[4] = {"finger_a", "finger_b", "finger_c", "thumb"};
  std::mt19937_64 rng(2);
  for (int trial = 0; trial < 10; ++trial) {
    const Eigen::VectorXd q = robot::random_q(r.robot, rng);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto value = [&](const std::string& part) { return q[r.robot.joint(names[i] + part)]; };
      const double bend = value("_middle_joint");
      const Isometry3d last = bases[i] * rz(value("_base_joint") + M_PI / 2) * rx(-M_PI / 2) *
                              rz(value("_proximal_joint")) * move(0.10035, 0, 0) * rx(M_PI / 2) *
                              rz(bend) * move(0.04, 0, 0) * rz(1.047619 * bend);
      EXPECT_LT(robot::distance(in_palm(r.robot, names[i] + "_distal", q), last), 1e-9) << names[i];
    }
  }
}

TEST(DlrHand, SpreadsItsFingersAsWideAsTheirLimits) {
  const robot::Robot robot = robot_with_hand("kr5_dlr").robot;
  const int a = robot.joint("finger_a_proximal_joint"), c = robot.joint("finger_c_proximal_joint");
  EXPECT_NEAR(robot.lower()[a], -30 * kDegree, 1e-12);
  EXPECT_NEAR(robot.upper()[a], 10 * kDegree, 1e-12);
  EXPECT_NEAR(robot.lower()[c], -10 * kDegree, 1e-12);
  EXPECT_NEAR(robot.upper()[c], 30 * kDegree, 1e-12);
  EXPECT_NEAR(robot.upper()[robot.joint("thumb_middle_joint")], 100 * kDegree, 1e-12);
}

TEST(ArmarHand, HasItsFingersInARow) {
  const RobotWithHand r = robot_with_hand("kr5_armar");
  const Eigen::VectorXd straight = Eigen::VectorXd::Zero(r.robot.dof());
  const double x = -0.0087, y = -0.0135, z = 0.02925 + 0.0404 + 0.0402;
  expect_near(tip_in_palm(r, 0, straight), {x, y, z - 0.0002 + 0.05875});
  expect_near(tip_in_palm(r, 1, straight), {x, y + 0.027, z + 0.05875});
  expect_near(tip_in_palm(r, 2, straight), {x, y + 0.051, z + 0.05125});
  expect_near(tip_in_palm(r, 3, straight), {x, y + 0.073, z + 0.04375});
  expect_near(tip_in_palm(r, 4, straight), {-0.0489 - 0.0402 - 0.05875, 0, 0.02925});
}

TEST(IcubHand, HasTheDenavitHartenbergChains) {
  const RobotWithHand r = robot_with_hand("kr5_icub");
  const auto rpy = [](double roll, double pitch, double yaw) {
    return rz(yaw * kDegree) * rot(Vector3d::UnitY(), pitch * kDegree) * rx(roll * kDegree);
  };
  const std::string names[5] = {"index", "middle", "ring", "pinky", "thumb"};
  const Isometry3d bases[5] = {
      move(0.06425, -0.02622, -0.0067) * rpy(-5, 0, -4.1), move(0.065, -0.00977, -0.0076),
      move(0.06413, 0.00565, -0.007) * rpy(5, 0, 6.1),
      move(0.06211, 0.02454, -0.006) * rpy(5, 0, 6.1),
      // The thumb's opposition is held at 1.3 rad.
      move(0.039, -0.012, 0.0025) * rpy(0, 4.76, 29.04) * rpy(90, 0, -90) * rz(1.3)};
  // a and d of the first joint, its alpha in degrees, a of the second and the third
  const double table[5][5] = {{0.0148, -0.00175, 90, 0.0259, 0.022},
                              {0.0153, -0.0022, 90, 0.0258, 0.0258},
                              {0.0148, -0.00175, 90, 0.0259, 0.022},
                              {0.0148, 0.00175, 90, 0.0219, 0.019},
                              {0.0211, 0.0049, -90, 0.026, 0.022}};
  std::mt19937_64 rng(3);
  const Eigen::VectorXd q = robot::random_q(r.robot, rng);
  for (std::size_t i = 0; i < 5; ++i) {
    const auto value = [&](const std::string& part) { return q[r.robot.joint(names[i] + part)]; };
    const double* row = table[i];
    const Isometry3d last = bases[i] * move(row[0], 0, 0) * rx(row[2] * kDegree) *
                            move(0, 0, row[1]) * rz(value("_proximal_joint")) * move(row[3], 0, 0) *
                            rz(value("_middle_joint")) * move(row[4], 0, 0) *
                            rz(value("_distal_joint"));
    EXPECT_LT(robot::distance(in_palm(r.robot, names[i] + "_distal", q), last), 1e-9) << names[i];
    expect_near(tip_in_palm(r, i, q), last * Vector3d(0.018, 0.005, 0));
  }
}

TEST(IcubHand, RunsIntoItselfWhenItClosesEmpty) {
  const RobotWithHand r = robot_with_hand("kr5_icub");
  scene::Scene scene(r.robot);
  EXPECT_FALSE(scene.is_free(at_home(r, "closed")));
}

}  // namespace
}  // namespace graspless::clasp
