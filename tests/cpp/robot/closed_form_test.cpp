// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "graspless/robot/ik.hpp"

#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Ik wam_ik(const Robot& robot, const std::string& frame = "left_fingertip") {
  return Ik(robot, robot.frame(frame), robot.group("arm"));
}

/// Largest pose error of the first `count` columns; each must be finite and within the limits.
double worst(const Robot& robot, int frame, const Isometry3d& X_WF, const MatrixXd& solutions,
             int count) {
  double error = 0;
  for (int i = 0; i < count; ++i) {
    const VectorXd q = solutions.col(i);
    EXPECT_TRUE(q.allFinite());
    EXPECT_TRUE(robot.is_within(q, 0));
    error = std::max(error, distance(robot.pose(frame, q), X_WF));
  }
  return error;
}

bool holds(const MatrixXd& solutions, int count, const VectorXd& q, double tolerance) {
  for (int i = 0; i < count; ++i) {
    if ((solutions.col(i) - q).cwiseAbs().maxCoeff() < tolerance) return true;
  }
  return false;
}

TEST(ClosedForm, FindsTheConfigurationItCameFrom) {
  const Robot robot = wam();
  std::mt19937_64 rng(1);
  for (const char* name : {"left_fingertip", "right_fingertip", "flange", "wam_link_7"}) {
    const Ik ik = wam_ik(robot, name);
    ASSERT_TRUE(ik.is_closed_form());
    const int frame = robot.frame(name);
    MatrixXd solutions;
    double error = 0;
    for (int sample = 0; sample < 3000; ++sample) {
      const VectorXd q = random_q(robot, rng);
      const Isometry3d X_WF = robot.pose(frame, q);
      const int count = ik.solve_free(X_WF, q[2], q, solutions);
      EXPECT_TRUE(holds(solutions, count, q, 1e-6)) << q.transpose();
      error = std::max(error, worst(robot, frame, X_WF, solutions, count));
    }
    EXPECT_LT(error, 1e-12) << name;
  }
}

/// Some joints of a random configuration at a limit, at 0 or a hair beside: shoulder, elbow and
/// wrist are singular there.
VectorXd extreme_q(const Robot& robot, bool limits, bool singular, std::mt19937_64& rng) {
  std::uniform_int_distribution<int> choice(0, 5), exponent(-9, -3);
  VectorXd q = random_q(robot, rng);
  for (int i = 0; i < 7; ++i) {
    const int what = choice(rng);
    const double hair = std::pow(10.0, exponent(rng));
    if (limits && what == 0) q[i] = robot.lower()[i];
    if (limits && what == 1) q[i] = robot.upper()[i];
    if (singular && what == 2) q[i] = 0;
    if (singular && what == 3) q[i] = rng() % 2 == 0 ? hair : -hair;
  }
  return q;
}

/// With both at once there may be no answer: next to a singularity the angles are only known to
/// half their digits, and a joint at its limit may come out beyond.
TEST(ClosedForm, HoldsAtLimitsAndSingularities) {
  const Robot robot = wam();
  const Ik ik = wam_ik(robot);
  const int frame = robot.frame("left_fingertip");
  std::mt19937_64 rng(2);
  MatrixXd solutions;
  double error = 0;
  for (int sample = 0; sample < 9000; ++sample) {
    const bool limits = sample % 3 != 1, singular = sample % 3 != 0;
    const VectorXd q = extreme_q(robot, limits, singular, rng);
    const Isometry3d X_WF = robot.pose(frame, q);
    const int count = ik.solve_free(X_WF, q[2], q, solutions);
    EXPECT_TRUE(count >= 1 || (limits && singular)) << q.transpose();
    error = std::max(error, worst(robot, frame, X_WF, solutions, count));
  }
  EXPECT_LT(error, 1e-12);
}

TEST(ClosedForm, TakesArbitraryAnglesFromTheGivenConfiguration) {
  const Robot robot = wam();
  const Ik ik = wam_ik(robot, "flange");
  VectorXd q(8);
  q << 0.3, 0.8, 0.1, 1.2, -0.7, 0, 0.4, 0;  // joints 5 and 7 turn about one axis
  MatrixXd solutions;
  const int count = ik.solve_free(robot.pose(robot.frame("flange"), q), q[2], q, solutions);
  EXPECT_TRUE(holds(solutions, count, q, 1e-6));
}

TEST(ClosedForm, GivesNothingOutOfReachAndForNonsense) {
  const Robot robot = wam();
  const Ik ik = wam_ik(robot);
  const VectorXd q = robot.state("home");
  MatrixXd solutions;
  Isometry3d X_WF = Isometry3d::Identity();
  for (const double x : {0.0, 1.5, 1e6, std::nan(""), std::numeric_limits<double>::infinity()}) {
    X_WF.translation() = Eigen::Vector3d(x, 0, 2);
    EXPECT_EQ(ik.solve_free(X_WF, 0, q, solutions), 0) << x;
  }
  X_WF = robot.pose(robot.frame("left_fingertip"), q);
  EXPECT_EQ(ik.solve_free(X_WF, 3.0, q, solutions), 0);  // joint 3 ends at 2.8
  EXPECT_EQ(ik.solve_free(X_WF, std::nan(""), q, solutions), 0);
}

TEST(ClosedForm, HoldsTheFingersWhereTheyAre) {
  const Robot robot = wam();
  const Ik ik = wam_ik(robot);
  const int frame = robot.frame("left_fingertip");
  VectorXd q = robot.state("home");
  q[7] = 0.9;
  MatrixXd solutions;
  const Isometry3d X_WF = robot.pose(frame, q);
  const int count = ik.solve_free(X_WF, q[2], q, solutions);
  ASSERT_GE(count, 1);
  for (int i = 0; i < count; ++i) EXPECT_EQ(solutions(7, i), 0.9);
  EXPECT_LT(worst(robot, frame, X_WF, solutions, count), 1e-12);
}

TEST(ClosedForm, FindsAsManyBranchesAsThereAre) {
  const Robot robot = wam();
  const Ik ik = wam_ik(robot);
  std::mt19937_64 rng(3);
  MatrixXd solutions;
  std::set<int> counts;
  for (int sample = 0; sample < 2000; ++sample) {
    const VectorXd q = random_q(robot, rng);
    counts.insert(ik.solve_free(robot.pose(robot.frame("left_fingertip"), q), q[2], q, solutions));
  }
  EXPECT_EQ(*counts.begin(), 1);
  EXPECT_EQ(*counts.rbegin(), 8);
}

/// Seven joints about skewed axes, an offset elbow, and limits that let every joint turn once and a
/// half.
std::string wide_arm() {
  const char* axes[] = {"0 0 1", "1 0.2 0", "0.3 1 0.5", "0 1 0.1", "0.2 0 1", "1 1 0", "0 0.3 1"};
  const char* origins[] = {"0 0 0.4",        "0 0 0", "0 0 0", "0.05 0 0.5",
                           "-0.05 0.02 0.4", "0 0 0", "0 0 0"};
  std::string urdf = "<robot name='wide'><link name='l0'/>";
  for (int i = 0; i < 7; ++i) {
    const std::string n = std::to_string(i + 1);
    urdf += "<link name='l" + n + "'/><joint name='j" + n + "' type='revolute'><origin xyz='" +
            origins[i] + "'/><parent link='l" + std::to_string(i) + "'/><child link='l" + n +
            "'/><axis xyz='" + axes[i] +
            "'/><limit lower='-4.7' upper='4.7' velocity='1' effort='1'/></joint>";
  }
  return urdf + "</robot>";
}

TEST(ClosedForm, KnowsAnyAxesAndReturnsWholeTurns) {
  const Robot robot = Robot::from_urdf(wide_arm(), {});
  const Ik ik(robot, 7, {0, 1, 2, 3, 4, 5, 6});
  ASSERT_TRUE(ik.is_closed_form());
  std::mt19937_64 rng(4);
  MatrixXd solutions;
  double error = 0;
  for (int sample = 0; sample < 500; ++sample) {
    VectorXd q = random_q(robot, rng);
    const Isometry3d X_WF = robot.pose(7, q);
    const int count = ik.solve_free(X_WF, q[2], q, solutions);
    EXPECT_TRUE(holds(solutions, count, q, 1e-6));
    error = std::max(error, worst(robot, 7, X_WF, solutions, count));
    const int turned = q[0] > 1.6 ? -1 : q[0] < -1.6 ? 1 : 0;
    q[0] += turned * 2 * M_PI;  // fits as well
    EXPECT_TRUE(holds(solutions, count, q, 1e-6));
  }
  EXPECT_LT(error, 1e-12);
}

TEST(ClosedForm, IsOnlyForArmsThatHaveIt) {
  const Robot robot = wam();
  EXPECT_EQ(wam_ik(robot).free_joint(), 2);
  const Robot other = kr5();
  const Ik six(other, other.frame("flange"), other.group("arm"));
  EXPECT_TRUE(six.is_closed_form());
  EXPECT_FALSE(six.free_joint().has_value());
  const Ik five(robot, robot.frame("flange"), {0, 1, 2, 3, 4});
  EXPECT_FALSE(five.is_closed_form());
  EXPECT_FALSE(five.free_joint().has_value());
  MatrixXd solutions;
  EXPECT_THROW(five.solve_free(Isometry3d::Identity(), 0, robot.state("home"), solutions),
               std::logic_error);
  const Robot odd = oddity();
  EXPECT_FALSE(Ik(odd, odd.frame("tip"), {0, 1, 2, 3}).is_closed_form());
}

}  // namespace
}  // namespace graspless::robot
