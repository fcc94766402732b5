// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/controller.hpp"

#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "clasp/hands.hpp"
#include "clasp/rings.hpp"
#include "paths.hpp"
#include "robot/robots.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kSteps = 150;            // as the search takes at most
constexpr double kLargestStep = 0.12;  // of any joint [rad]

/// A robot at home with its hand open, a ring 0.15 m ahead of it, and what drives it there.
class ControllerOf : public testing::TestWithParam<std::string> {
 protected:
  Ring ring_ahead(double ahead) {
    HandKinematics kinematics(robot_.robot, robot_.hand);
    kinematics.update(home_);
    return ring_in_hand(kinematics, ahead);
  }

  TaskPoint goal(double linking) {
    TaskPoint x;
    x << ring_.targets[0].point, linking;
    return x;
  }

  double error() { return (tasks_.position() - ring_.targets[0].point).norm(); }

  VectorXd hand(const VectorXd& q) {
    const std::vector<int>& joints = robot_.robot.group(robot_.hand.hand);
    VectorXd part(static_cast<Eigen::Index>(joints.size()));
    for (Eigen::Index i = 0; i < part.size(); ++i) part[i] = q[joints[i]];
    return part;
  }

  /// Home with every joint of the arm moved by at most `by`.
  VectorXd start(double by) {
    std::uniform_real_distribution<double> move(-by, by);
    VectorXd q = home_;
    for (const int j : robot_.robot.group(robot_.hand.arm)) q[j] += move(rng_);
    return robot_.robot.clamp(q);
  }

  RobotWithHand robot_ = robot_with_hand(GetParam());
  VectorXd home_ = at_home(robot_, robot_.hand.open);
  Ring ring_ = ring_ahead(0.15);
  TaskSpace tasks_{robot_.robot, robot_.hand, ring_.p_W, ring_.targets};
  Options options_;
  Controller controller_{tasks_, robot_.robot, robot_.hand, options_};
  std::mt19937_64 rng_{1};
};
INSTANTIATE_TEST_SUITE_P(Robots, ControllerOf, testing::ValuesIn(robots_with_hands()),
                         [](const auto& info) { return info.param; });

/// What Section IV-E says of it: an unobstructed target is clasped by the controller alone.
TEST_P(ControllerOf, ClaspsWhatNothingObstructs) {
  for (int trial = 0; trial < 8; ++trial) {
    VectorXd q = start(0.3), q_new;
    for (int i = 0; i < kSteps; ++i) {
      if (!controller_.step(q, goal(1), kLargestStep, q_new)) break;
      q = q_new;
    }
    tasks_.project(q);
    EXPECT_GT(tasks_.linking_of_curves().minCoeff(), 0.75) << trial;
    EXPECT_LT(error(), 0.01);
    EXPECT_GT(tasks_.alignment()[0], 0.95);
  }
}

TEST_P(ControllerOf, StepsAreNoLongerThanAllowedAndWithinTheLimits) {
  for (int trial = 0; trial < 200; ++trial) {
    VectorXd q = robot::random_q(robot_.robot, rng_), q_new;
    const int j = trial % robot_.robot.dof();
    if (trial % 3 == 0) q[j] = robot_.robot.upper()[j];
    if (trial % 3 == 1) q[j] = robot_.robot.lower()[j];
    const double longest = trial % 2 == 0 ? 0.35 : 0.02;
    const bool goes = controller_.step(q, goal(trial % 2), longest, q_new);
    const double moved = (q_new - q).cwiseAbs().maxCoeff();
    EXPECT_LE(moved, longest + 1e-12);
    EXPECT_EQ(moved >= 2e-4, goes);
    EXPECT_TRUE(robot_.robot.is_within(q_new, 0));
  }
}

TEST_P(ControllerOf, AnOpenHandWaits) {
  VectorXd q = start(0.2), q_new;
  ASSERT_TRUE(controller_.step(q, goal(1), kLargestStep, q_new));
  EXPECT_EQ(tasks_.linking(), 0);
  EXPECT_EQ(hand(q), hand(q_new));
  EXPECT_NE(q, q_new);
}

/// But the T42 stands at its limit: it would open further.
TEST_P(ControllerOf, AnAttractedHandDoesNot) {
  options_.attract = true;
  Controller controller(tasks_, robot_.robot, robot_.hand, options_);
  TaskPoint x = tasks_.project(home_);  // so that it does not wait for the arm
  x[3] = 1;
  VectorXd before = VectorXd::Zero(tasks_.linking_of_curves().size()), after = before;
  Eigen::MatrixXd J(before.size(), home_.size());
  tasks_.attract(before, J);
  VectorXd q_new;
  controller.step(home_, x, 0.01, q_new);
  VectorXd q = home_;
  for (const int j : robot_.robot.group(robot_.hand.hand)) q[j] = q_new[j];
  tasks_.project(q);
  tasks_.attract(after, J);
  const double drawn = before.norm() - after.norm();
  if (GetParam() == "wam_t42") {
    EXPECT_EQ(0, drawn);
  } else {
    EXPECT_GT(drawn, 1e-4);
  }
}

/// GAIN: with the ring in the hand, but the goal far from it, the arm goes first.
TEST_P(ControllerOf, ClosesOnlyNearTheGoal) {
  const Ring ring = ring_ahead(0);
  TaskSpace tasks(robot_.robot, robot_.hand, ring.p_W, ring.targets);
  Controller controller(tasks, robot_.robot, robot_.hand, options_);
  VectorXd q_far, q_near;
  TaskPoint x;
  x << ring.targets[0].point, 1;
  ASSERT_TRUE(controller.step(home_, x, 10, q_near));
  ASSERT_GT(tasks.linking(), 0);
  x.head<3>() += 0.1 * Vector3d::UnitZ();
  ASSERT_TRUE(controller.step(home_, x, 10, q_far));
  EXPECT_LT(20 * (hand(q_far) - hand(home_)).norm(), (hand(q_near) - hand(home_)).norm());
  tasks.project(home_);
  const VectorXd before = tasks.linking_of_curves();
  tasks.project(home_ + 0.01 * (q_near - home_));
  EXPECT_TRUE(((tasks.linking_of_curves() - before).array() > 0).all());
}

TEST_P(ControllerOf, StopsWhereThereIsNothingToDo) {
  VectorXd q = home_, q_new;
  bool goes = true;
  for (int i = 0; i < 400 && goes; ++i) {
    goes = controller_.step(q, goal(0), kLargestStep, q_new);
    q = q_new;
  }
  EXPECT_FALSE(goes);
}

TEST_P(ControllerOf, RepeatsItselfToTheBit) {
  TaskSpace tasks(robot_.robot, robot_.hand, ring_.p_W, ring_.targets);
  Controller again(tasks, robot_.robot, robot_.hand, options_);
  VectorXd q = start(0.3), q_new, q_again;
  for (int i = 0; i < 40; ++i) {
    controller_.step(q, goal(1), kLargestStep, q_new);
    again.step(q, goal(1), kLargestStep, q_again);
    ASSERT_EQ(q_new, q_again);
    q = q_new;
  }
}

/// The KR 5 with the SDH, and in its SRDF a group of the arm's joints but one.
RobotWithHand without_arm_joint(int left_out) {
  const RobotWithHand whole = robot_with_hand("kr5_sdh");
  const std::string stem = urdf_file("kr5_sdh");
  std::ifstream file(stem + ".srdf");
  std::string srdf{std::istreambuf_iterator<char>(file), {}};
  std::string group = "<group name=\"rest\">";
  for (const int j : whole.robot.group("arm")) {
    const std::string& name = whole.robot.joint_names()[j];
    if (j != left_out) group += "<joint name=\"" + name + "\"/>";
  }
  robot::Robot::Options options;
  options.srdf =
      srdf.replace(srdf.rfind("</robot>"), std::string::npos, group + "</group></robot>");
  RobotWithHand rest = whole;
  rest.robot = robot::Robot::from_urdf_file(stem + ".urdf", options);
  rest.hand.arm = "rest";
  return rest;
}

/// A joint that stands at its limit and would go on leaves the motion to the others: they move as
/// if it were none of theirs.
TEST(Controller, GoesOnWithoutAJointAtItsLimit) {
  const RobotWithHand r = robot_with_hand("kr5_sdh");
  std::mt19937_64 rng(1);
  int blocked = 0;
  for (const int j : r.robot.group("arm")) {
    const RobotWithHand rest = without_arm_joint(j);
    for (int trial = 0; trial < 20; ++trial) {
      VectorXd q = robot::random_q(r.robot, rng), q_whole, q_rest;
      q[j] = trial % 2 == 0 ? r.robot.upper()[j] : r.robot.lower()[j];
      const Vector3d p(0.5, 0.02 * trial, 0.3);
      const Ring ring = ring_through(p, Vector3d::UnitX(), Vector3d::UnitZ(), 0.2);
      TaskSpace tasks(r.robot, r.hand, ring.p_W, ring.targets);
      TaskPoint x;
      x << p, 1;
      Controller(tasks, r.robot, r.hand, {}).step(q, x, 0.1, q_whole);
      if (q_whole[j] != q[j]) continue;
      Controller(tasks, rest.robot, rest.hand, {}).step(q, x, 0.1, q_rest);
      EXPECT_LT((q_whole - q_rest).norm(), 1e-12) << "joint " << j;
      EXPECT_GT((q_whole - q).norm(), 0.01);
      ++blocked;
    }
  }
  EXPECT_GT(blocked, 30);
}

}  // namespace
}  // namespace graspless::clasp
