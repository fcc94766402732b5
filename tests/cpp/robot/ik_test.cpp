// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/robot/ik.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "robot/arms.hpp"
#include "robot/damped_least_squares.hpp"
#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

using Eigen::Isometry3d;
using Eigen::VectorXd;

Ik arm_ik(const Robot& robot, const std::string& frame = "left_fingertip") {
  return Ik(robot, robot.frame(frame), robot.group("arm"));
}

TEST(Ik, SolveAllSortsAndRepeats) {
  const Robot robot = wam();
  const Ik ik = arm_ik(robot);
  const VectorXd q = robot.state("home");
  const Isometry3d X_WF = robot.pose(robot.frame("left_fingertip"), q);
  std::mt19937_64 rng(5), same(5);
  const std::vector<VectorXd> solutions = ik.solve_all(X_WF, q, rng);
  ASSERT_GT(solutions.size(), 16u);
  EXPECT_LT((solutions[0] - q).norm(), 1e-9);
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    EXPECT_LT(distance(robot.pose(robot.frame("left_fingertip"), solutions[i]), X_WF), 1e-11);
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_GT((solutions[i] - solutions[j]).norm(), 1e-5);
      EXPECT_LE((solutions[j] - q).norm(), (solutions[i] - q).norm());
    }
  }
  EXPECT_EQ(ik.solve_all(X_WF, q, same), solutions);
}

/// The eight solutions of a wrist-partitioned arm for one pose: over the shoulder or not, elbow up
/// or down, wrist flipped or not. Limits are widened so that all of them exist.
TEST(Ik, FindsAllEightBranchesOfTheKr5) {
  std::string urdf = "<robot name='kr5'><link name='l0'/>";
  const char* origins[] = {"xyz='0 0 0.335'",
                           "xyz='0.075 0 0' rpy='-1.5707963267948966 0 0'",
                           "xyz='0.365 0 0' rpy='0 0 -1.5707963267948966'",
                           "xyz='0.09 0.405 0' rpy='-1.5707963267948966 0 0'",
                           "rpy='1.5707963267948966 0 0'",
                           "xyz='0 0.08 0' rpy='1.5707963267948966 0 3.141592653589793'"};
  for (int i = 0; i < 6; ++i) {
    const std::string n = std::to_string(i + 1);
    urdf += "<link name='l" + n + "'/><joint name='j" + n + "' type='continuous'><origin " +
            origins[i] + "/><parent link='l" + std::to_string(i) + "'/><child link='l" + n +
            "'/><axis xyz='0 0 1'/></joint>";
  }
  const Robot robot = Robot::from_urdf(urdf + "</robot>", {});
  Ik::Options options;
  options.restarts = 200;
  const Ik ik(robot, 6, {0, 1, 2, 3, 4, 5}, options);
  VectorXd q(6);
  q << 0.4, -1.4, 2.3, 0.7, 0.9, -0.5;
  std::mt19937_64 rng(6);
  const std::vector<VectorXd> solutions = ik.solve_all(robot.pose(6, q), q, rng);
  EXPECT_EQ(solutions.size(), 8u);
  for (const VectorXd& solution : solutions) {
    EXPECT_TRUE(robot.is_within(solution));
    EXPECT_LT(distance(robot.pose(6, solution), robot.pose(6, q)), 1e-8);
  }
}

TEST(Ik, ReachesWithinTheLimitsFromAnywhere) {
  const Robot robot = kr5();
  const int frame = robot.frame("right_fingertip");
  Ik::Options options;
  options.restarts = 30;
  const Ik ik(robot, frame, robot.group("arm"), options);
  std::mt19937_64 rng(7);
  int found = 0;
  for (int sample = 0; sample < 100; ++sample) {
    const VectorXd q = random_q(robot, rng);
    const Isometry3d X_WF = robot.pose(frame, q);
    VectorXd start = robot.state("home");
    start[6] = q[6];
    const std::vector<VectorXd> solutions = ik.solve_all(X_WF, start, rng);
    found += !solutions.empty();
    for (const VectorXd& solution : solutions) {
      EXPECT_TRUE(robot.is_within(solution, 0));
      EXPECT_EQ(solution[6], q[6]);
      EXPECT_LT(distance(robot.pose(frame, solution), X_WF), 1e-8);
    }
  }
  EXPECT_GE(found, 95);
}

TEST(Ik, SolveNearFollowsSmallMotions) {
  std::mt19937_64 rng(8);
  for (const Robot& robot : {wam(), kr5()}) {
    const int frame = robot.frame("left_fingertip");
    const std::vector<int>& arm = robot.group("arm");
    const Ik ik(robot, frame, arm);
    int found = 0;
    for (int sample = 0; sample < 500; ++sample) {
      const VectorXd q = random_q(robot, rng);
      VectorXd moved = q;
      for (const int joint : arm) moved[joint] += sample % 2 == 0 ? 0.01 : -0.01;
      moved = robot.clamp(moved);
      const auto answer = ik.solve_near(robot.pose(frame, moved), q);
      if (!answer) continue;
      ++found;
      EXPECT_TRUE(robot.is_within(*answer, 0));
      EXPECT_LT(distance(robot.pose(frame, *answer), robot.pose(frame, moved)), 1e-8);
    }
    EXPECT_GE(found, 490);
    const VectorXd home = robot.state("home");
    EXPECT_EQ(*ik.solve_near(robot.pose(frame, home), home), home);  // nothing to do
  }
}

/// Five joints of an arm cannot turn the frame about every axis: a tilted pose is reached with the
/// least angle that the position leaves.
TEST(Ik, LeansAsLittleAsFiveJointsCan) {
  const Robot robot = wam();
  const int frame = robot.frame("left_fingertip");
  std::vector<int> five = robot.group("arm");
  five.erase(five.begin() + 2);
  five.pop_back();
  Ik::Options options;
  options.tolerance = 1e-6;
  const Ik exact(robot, frame, five, options);
  options.lean = 0.01;
  const Ik leaning(robot, frame, five, options);
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> draw(-1, 1);
  int tilted = 0;
  for (int i = 0; i < 200; ++i) {
    VectorXd q = robot.state("home");
    for (const int joint : five) q[joint] += 0.3 * draw(rng);
    Isometry3d X_WF = robot.pose(frame, q);
    EXPECT_TRUE(exact.solve_near(X_WF, robot.state("home")).has_value());
    const Eigen::Vector3d axis(draw(rng), draw(rng), draw(rng));
    X_WF.rotate(Eigen::AngleAxisd(0.008, axis.normalized()));
    if (exact.solve_near(X_WF, q)) continue;
    const auto found = leaning.solve_near(X_WF, q);
    ASSERT_TRUE(found) << "case " << i;
    ++tilted;
    const auto error = pose_error(robot.pose(frame, *found), X_WF);
    EXPECT_LE(error.head<3>().norm(), options.tolerance);
    EXPECT_LE(error.tail<3>().norm(), 0.008);
    Eigen::MatrixXd J(6, 5);  // moves that keep the position
    for (int k = 0; k < 5; ++k) J.col(k) = robot.jacobian(frame, *found).col(five[k]);
    const Eigen::MatrixXd moves = Eigen::MatrixXd(J.topRows(3)).fullPivLu().kernel();
    EXPECT_LT((moves.transpose() * J.bottomRows(3).transpose() * error.tail<3>()).norm(), 1e-5);
  }
  EXPECT_GT(tilted, 150);
}

TEST(Ik, SolveNearGivesUpOutOfReach) {
  const Robot robot = wam();
  const Ik ik = arm_ik(robot);
  Isometry3d X_WF = Isometry3d::Identity();
  X_WF.translation().x() = 3;
  EXPECT_FALSE(ik.solve_near(X_WF, robot.state("home")).has_value());
  X_WF.translation().x() = std::nan("");
  EXPECT_FALSE(ik.solve_near(X_WF, robot.state("home")).has_value());
}

TEST(Ik, DrivesJointsThatOthersMimic) {
  const Robot robot = oddity();
  const int frame = robot.frame("tip");
  const Ik ik(robot, frame, {0, 1, 2, 3});
  std::mt19937_64 rng(9);
  int found = 0;
  for (int sample = 0; sample < 50; ++sample) {
    const VectorXd q = random_q(robot, rng);
    const auto answer = ik.solve_near(robot.pose(frame, q), robot.clamp(q.array() + 0.02));
    if (!answer) continue;
    ++found;
    EXPECT_LT(distance(robot.pose(frame, *answer), robot.pose(frame, q)), 1e-8);
  }
  EXPECT_GE(found, 45);
}

// An arm without a closed form, on a torso that is outside its limits.
TEST(Ik, LeavesJointsOutsideTheGroupAlone) {
  std::mt19937_64 rng(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  Arm arm{"crooked", {}};
  for (int i = 0; i < 8; ++i) {
    const auto draw = [&] { return Eigen::Vector3d(unit(rng), unit(rng), unit(rng)); };
    arm.origins.push_back({0.2 * draw(), draw()});
  }
  const Robot robot = arm.robot(2.5, {{-0.3, 0.3}});
  const int frame = robot.frame("l8");
  const Ik ik(robot, frame, {1, 2, 3, 4, 5, 6});
  ASSERT_FALSE(ik.is_closed_form());
  int found = 0;
  for (int sample = 0; sample < 20; ++sample) {
    VectorXd q = random_q(robot, rng);
    q[0] = 0.305;
    const auto X_WF = robot.pose(frame, q);
    for (const VectorXd& answer : ik.solve_all(X_WF, q, rng)) {
      ++found;
      EXPECT_EQ(answer[0], q[0]);
      EXPECT_LT(distance(robot.pose(frame, answer), X_WF), 1e-8);
    }
  }
  EXPECT_GT(found, 20);
}

TEST(Ik, RefusesGroupsThatDoNotMoveTheFrame) {
  const Robot robot = wam();
  const int flange = robot.frame("flange");
  EXPECT_CONTAINS(complaint([&] {
                    Ik(robot, flange, {0, 7});
                  }),
                  "joint 'left_finger_joint' does not move frame 'flange'");
  EXPECT_CONTAINS(complaint([&] { Ik(robot, flange, {}); }), "group");
  EXPECT_CONTAINS(complaint([&] { Ik(robot, flange, {0, 0}); }), "twice");
  EXPECT_CONTAINS(complaint([&] { Ik(robot, flange, {99}); }), "99");
  EXPECT_CONTAINS(complaint([&] { Ik(robot, -1, {0}); }), "-1");
  Ik::Options options;
  options.tolerance = 0;
  EXPECT_CONTAINS(complaint([&] { Ik(robot, flange, {0}, options); }), "tolerance");
  const Ik ik = arm_ik(robot);
  EXPECT_CONTAINS(complaint([&] { ik.solve_near(Isometry3d::Identity(), VectorXd::Zero(3)); }),
                  "8");
}

}  // namespace
}  // namespace graspless::robot
