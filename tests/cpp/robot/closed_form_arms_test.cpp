// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Closed forms of the arms that people have, by the laws that hold for each of them.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

#include "graspless/robot/ik.hpp"

#include "robot/arms.hpp"
#include "robot/damped_least_squares.hpp"
#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kWide = 3.0;  // limits [rad]

struct Bench {
  explicit Bench(const Arm& arm_, double limit = kWide)
      : arm(arm_), robot(arm.robot(limit)), frame(arm.dof() + 1), ik(robot, frame, arm.group()) {}

  Isometry3d pose(const VectorXd& q) const { return robot.pose(frame, q); }
  double free_value(const VectorXd& q) const { return ik.free_joint() ? q[*ik.free_joint()] : 0; }

  /// Solutions for the free joint's value in q; each must be within the limits.
  int solve(const Isometry3d& X_WF, const VectorXd& q) {
    const int count = ik.solve_free(X_WF, free_value(q), q, solutions);
    for (int i = 0; i < count; ++i) {
      const VectorXd solution = solutions.col(i);
      EXPECT_TRUE(robot.is_within(solution, 0)) << arm.name << ": " << solution.transpose();
      worst = std::max(worst, distance(pose(solution), X_WF));
    }
    return count;
  }

  bool holds(int count, const VectorXd& q, double tolerance) const {
    for (int i = 0; i < count; ++i) {
      if ((solutions.col(i) - q).cwiseAbs().maxCoeff() < tolerance) return true;
    }
    return false;
  }

  Arm arm;
  Robot robot;
  int frame;
  Ik ik;
  MatrixXd solutions;
  double worst = 0;  // largest pose error so far
};

TEST(ClosedFormArms, AreKnownByTheirAxes) {
  std::mt19937_64 rng(1);
  for (const Arm& arm : ideal_arms()) {
    for (const Arm& one : {arm, arm.calibrated(1e-4, 1e-3, rng)}) {
      const Bench bench(one);
      ASSERT_TRUE(bench.ik.is_closed_form()) << one.name;
      EXPECT_EQ(bench.ik.free_joint().value_or(-1), arm.free_joint) << one.name;
    }
  }
}

TEST(ClosedFormArms, FindTheConfigurationTheyCameFrom) {
  std::mt19937_64 rng(2);
  for (const Arm& arm : ideal_arms()) {
    Bench bench(arm);
    for (int sample = 0; sample < 2000; ++sample) {
      const VectorXd q = random_q(bench.robot, rng);
      const int count = bench.solve(bench.pose(q), q);
      EXPECT_TRUE(bench.holds(count, q, 1e-6)) << arm.name << ": " << q.transpose();
      EXPECT_LE(count, 8);
    }
    EXPECT_LT(bench.worst, 1e-11) << arm.name;
  }
}

/// Next to a singularity Newton's method may end on another branch, or on none.
TEST(ClosedFormArms, PolishOffsets) {
  std::mt19937_64 rng(3);
  std::vector<Arm> arms = ideal_arms();
  for (Arm& arm : arms) arm = arm.calibrated(1e-4, 1e-3, rng);
  for (const Arm& arm : arms) {
    Bench bench(arm);
    int kept = 0;
    constexpr int kSamples = 1000;
    for (int sample = 0; sample < kSamples; ++sample) {
      const VectorXd q = random_q(bench.robot, rng);
      kept += bench.holds(bench.solve(bench.pose(q), q), q, 1e-5);
    }
    EXPECT_GE(kept, 0.98 * kSamples) << arm.name;
    EXPECT_LT(bench.worst, 1e-9) << arm.name;
  }
}

/// Distinct solutions that damped least squares finds from `restarts` random configurations.
std::vector<VectorXd> by_restarts(const Bench& bench, const Isometry3d& X_WF, const VectorXd& q,
                                  int restarts, std::mt19937_64& rng) {
  std::vector<int> joints = bench.arm.group();
  if (bench.ik.free_joint()) joints.erase(joints.begin() + *bench.ik.free_joint());
  DampedLeastSquares solver(bench.robot, bench.frame, joints);
  Ik::Options options;
  options.tolerance = 1e-10;
  std::vector<VectorXd> found;
  for (int i = 0; i < restarts; ++i) {
    VectorXd answer = random_q(bench.robot, rng);
    if (bench.ik.free_joint()) answer[*bench.ik.free_joint()] = bench.free_value(q);
    if (!solver.solve(X_WF, options, false, answer)) continue;
    const auto same = [&](const VectorXd& other) { return (other - answer).norm() < 1e-4; };
    if (std::none_of(found.begin(), found.end(), same)) found.push_back(answer);
  }
  return found;
}

int from_environment(const char* name, int otherwise) {
  const char* value = std::getenv(name);
  return value == nullptr ? otherwise : std::atoi(value);
}

/// The oracle: a long run sets both numbers, GRASPLESS_IK_RESTARTS to 10000.
TEST(ClosedFormArms, FindEveryBranchThatRestartsFind) {
  const int restarts = from_environment("GRASPLESS_IK_RESTARTS", 150);
  const int samples = from_environment("GRASPLESS_IK_SAMPLES", 4);
  std::mt19937_64 rng(4);
  std::vector<Arm> arms = ideal_arms();
  for (const Arm& arm : {ur5e(), kr5_bare(), panda()}) {
    arms.push_back(arm.calibrated(1e-4, 1e-3, rng));
  }
  for (const Arm& arm : arms) {
    Bench bench(arm);
    int numeric = 0, missed = 0, closed = 0;
    for (int sample = 0; sample < samples; ++sample) {
      const VectorXd q = random_q(bench.robot, rng);
      const int count = bench.solve(bench.pose(q), q);
      closed += count;
      for (const VectorXd& other : by_restarts(bench, bench.pose(q), q, restarts, rng)) {
        ++numeric;
        missed += !bench.holds(count, other, 1e-3);
      }
    }
    EXPECT_EQ(missed, 0) << arm.name;
    EXPECT_GE(closed, numeric) << arm.name;
    EXPECT_GE(numeric, samples) << arm.name;
  }
}

/// Some joints at 0, at a right angle or a hair beside: shoulder, elbow and wrist are singular
/// there.
VectorXd singular_q(const Robot& robot, std::mt19937_64& rng) {
  std::uniform_int_distribution<int> choice(0, 5), exponent(-12, -3);
  VectorXd q = random_q(robot, rng);
  for (int i = 0; i < q.size(); ++i) {
    const int what = choice(rng);
    const double hair = rng() % 2 == 0 ? std::pow(10.0, exponent(rng)) : 0;
    if (what == 0) q[i] = hair;
    if (what == 1) q[i] = kRight - hair;
    if (what == 2) q[i] = hair - kRight;
  }
  return q;
}

TEST(ClosedFormArms, HoldAtSingularities) {
  std::mt19937_64 rng(5);
  for (const Arm& arm : ideal_arms()) {
    Bench bench(arm);
    int none = 0;
    for (int sample = 0; sample < 3000; ++sample) {
      const VectorXd q = singular_q(bench.robot, rng);
      none += bench.solve(bench.pose(q), q) == 0;
    }
    EXPECT_EQ(none, 0) << arm.name;
    EXPECT_LT(bench.worst, 1e-9) << arm.name;
    Bench offset(arm.calibrated(1e-4, 1e-3, rng));
    none = 0;
    for (int sample = 0; sample < 1000; ++sample) {
      const VectorXd q = singular_q(offset.robot, rng);
      none += offset.solve(offset.pose(q), q) == 0;
    }
    EXPECT_LE(none, 80) << arm.name;
    EXPECT_LT(offset.worst, 1e-9) << arm.name;
  }
}

TEST(ClosedFormArms, TakeArbitraryAnglesFromTheGivenConfiguration) {
  Bench kr5(kr5_bare());
  VectorXd q(6);
  q << 0.3, -0.8, 0.5, 1.2, 0, 0.4;  // axes 4 and 6 are one line
  EXPECT_TRUE(kr5.holds(kr5.solve(kr5.pose(q), q), q, 1e-6));
  Bench ur(ur5e());
  q << 0.3, -0.8, 0.5, 1.2, 0, 0.4;  // axis 6 is parallel to axes 2 to 4
  EXPECT_TRUE(ur.holds(ur.solve(ur.pose(q), q), q, 1e-6));
}

TEST(ClosedFormArms, GiveNothingOutOfReachAndForNonsense) {
  std::mt19937_64 rng(6);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Arm& arm : ideal_arms()) {
    for (const Arm& one : {arm, arm.calibrated(1e-4, 1e-3, rng)}) {
      Bench bench(one);
      const VectorXd q = random_q(bench.robot, rng);
      Isometry3d X_WF = bench.pose(q);
      for (const double x : {3.0, 1e6, 1e200, std::nan(""), infinity}) {
        X_WF.translation().x() = x;
        EXPECT_EQ(bench.solve(X_WF, q), 0) << one.name << ' ' << x;
      }
      X_WF = bench.pose(q);
      X_WF.linear().setConstant(std::nan(""));
      EXPECT_EQ(bench.solve(X_WF, q), 0) << one.name;
    }
  }
}

TEST(ClosedFormArms, RespectLimitsAndReturnWholeTurns) {
  std::mt19937_64 rng(7);
  for (const Arm& arm : ideal_arms()) {
    Bench narrow(arm, 1.2), wide(arm, 2 * M_PI);
    std::size_t few = 0, many = 0;
    for (int sample = 0; sample < 200; ++sample) {
      const VectorXd q = random_q(narrow.robot, rng);
      const int count = narrow.solve(narrow.pose(q), q);
      EXPECT_TRUE(narrow.holds(count, q, 1e-6)) << arm.name;
      few += count;
      many += wide.solve(narrow.pose(q), q);
      VectorXd turned = q;
      turned[1] += q[1] > 0 ? -2 * M_PI : 2 * M_PI;
      EXPECT_TRUE(wide.holds(wide.solve(wide.pose(q), q), turned, 1e-6)) << arm.name;
    }
    EXPECT_GT(many, 16 * few) << arm.name;  // each of at least six joints has two values
  }
}

TEST(ClosedFormArms, ReturnTheNearestOfTheWholeTurns) {
  std::mt19937_64 rng(9);
  const Bench bench(ur5e(), 2 * M_PI);
  Ik::Options options;
  options.whole_turns = false;
  const Ik ik(bench.robot, bench.frame, bench.arm.group(), options);
  MatrixXd solutions;
  for (int sample = 0; sample < 200; ++sample) {
    const VectorXd q = random_q(bench.robot, rng);
    const int count = ik.solve_free(bench.pose(q), 0, q, solutions);
    EXPECT_LE(count, 8);
    const double nearest = (solutions.leftCols(count).colwise() - q).colwise().norm().minCoeff();
    EXPECT_LT(nearest, 1e-6);
  }
}

/// Random axes, right-angled or skew, meeting or not: most arms have no closed form, and those that
/// have one must be right.
Arm random_arm(std::mt19937_64& rng) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::uniform_int_distribution<int> choice(0, 3);
  Arm arm{"random", {}, -1};
  const int dof = rng() % 2 == 0 ? 6 : 7;
  for (int i = 0; i <= dof; ++i) {
    JointOrigin origin{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    for (int k = 0; k < 3; ++k) {
      if (choice(rng) == 0) origin.xyz[k] = unit(rng);
      const int turn = choice(rng);
      origin.rpy[k] = turn == 0 ? kRight : turn == 1 && choice(rng) == 0 ? unit(rng) : 0;
    }
    const int hair = choice(rng);  // almost parallel, almost meeting
    if (hair == 0) origin.rpy[0] += std::pow(10.0, -12 * std::abs(unit(rng)));
    if (hair == 1) origin.xyz[1] += std::pow(10.0, -12 * std::abs(unit(rng)));
    arm.origins.push_back(origin);
  }
  return arm;
}

TEST(ClosedFormArms, AreRightForRandomAxes) {
  std::mt19937_64 rng(8);
  const int arms = from_environment("GRASPLESS_IK_ARMS", 10000);
  int closed = 0, kept = 0, samples = 0;
  for (int i = 0; i < arms; ++i) {
    const Arm arm = random_arm(rng);
    Bench bench(arm);
    if (!bench.ik.is_closed_form()) continue;
    ++closed;
    for (int sample = 0; sample < 20; ++sample) {
      const VectorXd q =
          sample % 2 == 0 ? random_q(bench.robot, rng) : singular_q(bench.robot, rng);
      kept += bench.solve(bench.pose(q), q) > 0;
      ++samples;
    }
    EXPECT_LT(bench.worst, 1e-9) << i;
  }
  EXPECT_GT(closed, arms / 40);
  EXPECT_GT(kept, 0.99 * samples);
}

}  // namespace
}  // namespace graspless::robot
