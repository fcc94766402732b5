// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/task_space.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "clasp/hands.hpp"
#include "clasp/rings.hpp"
#include "complaint.hpp"
#include "robot/robots.hpp"

namespace graspless::clasp {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kStep = 1e-6;

class TasksOf : public testing::TestWithParam<std::string> {
 protected:
  /// Within the limits, with the hand somewhere between open and closed.
  VectorXd random_q() {
    VectorXd q = robot::random_q(robot_.robot, rng_);
    const VectorXd open = robot_.robot.state(robot_.hand.open);
    const VectorXd closed = robot_.robot.state(robot_.hand.closed);
    std::uniform_real_distribution<double> part(0, 0.7);
    for (const int j : robot_.robot.group(robot_.hand.hand)) {
      q[j] = open[j] + part(rng_) * (closed[j] - open[j]);
    }
    return q;
  }

  /// TaskSpace with a ring `ahead` of the hand at q.
  TaskSpace tasks(const VectorXd& q, double ahead) {
    HandKinematics kinematics(robot_.robot, robot_.hand);
    kinematics.update(q);
    ring_ = ring_in_hand(kinematics, ahead);
    return TaskSpace(robot_.robot, robot_.hand, ring_.p_W, ring_.targets);
  }

  RobotWithHand robot_ = robot_with_hand(GetParam());
  Ring ring_;
  std::mt19937_64 rng_{1};
};
INSTANTIATE_TEST_SUITE_P(Robots, TasksOf, testing::ValuesIn(robots_with_hands()),
                         [](const auto& info) { return info.param; });

TEST_P(TasksOf, AreWhatTheEquationsSay) {
  int linked = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const VectorXd q = random_q();
    TaskSpace tasks = this->tasks(q, 0.005 * trial);
    const TaskPoint x = tasks.project(q);
    HandKinematics kinematics(robot_.robot, robot_.hand);
    kinematics.update(q);
    const Vector3d center = hand_center(kinematics);
    EXPECT_LT((center - x.head<3>()).norm(), 1e-12);
    EXPECT_LT((center - tasks.position()).norm(), 1e-12);

    const auto nearer = [&](const auto& a, const auto& b) {
      return (a.point - center).norm() < (b.point - center).norm();
    };
    const auto near = std::min_element(ring_.targets.begin(), ring_.targets.end(), nearer);
    const Vector3d t = (near->point - center).normalized();  // (3)
    EXPECT_NEAR(std::abs(kinematics.sideways_W().dot(near->tangent)), tasks.alignment()[0], 1e-12);
    const double forward = trial > 0 ? kinematics.forward_W().dot(t) : 1;
    EXPECT_NEAR(forward, tasks.alignment()[1], 1e-9);

    double sum = 0;  // (4)
    for (int i = 0; i < kinematics.num_curves(); ++i) {
      const double linking = geometry::virtual_linking(ring_.p_W, kinematics.curve_points(i));
      EXPECT_NEAR(std::min(1.0, std::abs(linking)), tasks.linking_of_curves()[i], 1e-12);
      sum += std::min(1.0, std::abs(linking));
    }
    EXPECT_NEAR(sum / kinematics.num_curves(), x[3], 1e-12);
    EXPECT_EQ(x[3], tasks.linking());
    linked += tasks.linking() > 0 ? 1 : 0;
  }
  EXPECT_GT(linked, 2);
}

/// Everything that has a derivative, one after the other.
VectorXd values(TaskSpace& tasks, const VectorXd& q) {
  tasks.project(q);
  VectorXd all(5 + tasks.linking_of_curves().size());
  all << tasks.position(), tasks.alignment(), tasks.linking_of_curves();
  return all;
}

/// What the derivatives take for fixed.
VectorXd switches(TaskSpace& tasks, const VectorXd& q) {
  tasks.project(q);
  const Eigen::Matrix3Xd& p = tasks.kinematics().nodes();
  VectorXd all(8 + tasks.linking_of_curves().size());
  for (int k = 0; k < 3; ++k) {
    Eigen::Index low, high;
    p.row(k).minCoeff(&low);
    p.row(k).maxCoeff(&high);
    all[2 * k] = static_cast<double>(low);
    all[2 * k + 1] = static_cast<double>(high);
  }
  const std::size_t near = static_cast<std::size_t>(tasks.nearest_target());
  all[6] = tasks.nearest_target();
  all[7] = tasks.targets()[near].tangent.dot(tasks.kinematics().sideways_W()) > 0 ? 1 : 0;
  all.tail(all.size() - 8) = (tasks.linking_of_curves().array() > 0).cast<double>();
  return all;
}

TEST_P(TasksOf, HaveTheDerivativesOfDifferences) {
  int compared = 0, linked = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const VectorXd q = random_q();
    TaskSpace tasks = this->tasks(q, 0.02 + 0.002 * trial);
    tasks.project(q);
    linked += tasks.linking() > 0 ? 1 : 0;
    MatrixXd position, alignment, linking;
    tasks.position_jacobian(position);
    tasks.alignment_jacobian(alignment);
    tasks.linking_jacobian(linking);
    MatrixXd J(5 + linking.rows(), q.size());
    J << position, alignment, linking;
    const VectorXd here = switches(tasks, q);
    for (int j = 0; j < q.size(); ++j) {
      const VectorXd step = kStep * VectorXd::Unit(q.size(), j);
      if (switches(tasks, q + step) != here || switches(tasks, q - step) != here) continue;
      const VectorXd by_q = (values(tasks, q + step) - values(tasks, q - step)) / (2 * kStep);
      EXPECT_LT((J.col(j) - by_q).cwiseAbs().maxCoeff(), 1e-6) << trial << " joint " << j;
      ++compared;
    }
  }
  EXPECT_GT(compared, 30 * robot_.robot.dof());
  EXPECT_GT(linked, 3);
}

TEST_P(TasksOf, AttractByTheIntegralOfOpenCurves) {
  int compared = 0;
  for (int trial = 0; trial < 20; ++trial) {
    const VectorXd q = random_q();
    TaskSpace tasks = this->tasks(q, 0.05 + 0.01 * trial);
    const int curves = tasks.kinematics().num_curves();
    VectorXd u = VectorXd::Constant(curves, 7), more = u, less = u;
    MatrixXd J = MatrixXd::Constant(curves, q.size(), 7), other = J;
    tasks.project(q);
    const VectorXd linking = tasks.linking_of_curves();
    tasks.attract(u, J);
    for (int j = 0; j < q.size(); ++j) {
      const VectorXd step = kStep * VectorXd::Unit(q.size(), j);
      tasks.project(q + step);
      tasks.attract(more, other);
      tasks.project(q - step);
      tasks.attract(less, other);
      for (int i = 0; i < curves; ++i) {
        const double expected = linking[i] > 0 ? 7 : (less[i] - more[i]) / (2 * kStep);
        EXPECT_NEAR(expected, J(i, j), 1e-6);
        compared += linking[i] > 0 ? 0 : 1;
      }
    }
  }
  EXPECT_GT(compared, 10 * robot_.robot.dof());
}

/// Where the hand is carried does not matter to how closed it is.
TEST_P(TasksOf, ArmDoesNotChangeTheLinking) {
  const VectorXd q = at_home(robot_, robot_.hand.open);
  TaskSpace tasks = this->tasks(q, 0);
  tasks.project(q);
  MatrixXd J;
  tasks.linking_jacobian(J);
  EXPECT_GT(tasks.linking(), 0);
  EXPECT_GT(J.norm(), 0.1);
  for (const int j : robot_.robot.group(robot_.hand.arm)) EXPECT_LT(J.col(j).norm(), 1e-12);
}

TEST_P(TasksOf, AreFiniteOnTheTarget) {
  const VectorXd q = at_home(robot_, robot_.hand.open);
  TaskSpace tasks = this->tasks(q, 0);
  tasks.project(q);
  ASSERT_LT(tasks.target_distance(), 1e-9);
  MatrixXd J;
  tasks.alignment_jacobian(J);
  EXPECT_TRUE(J.allFinite());
  EXPECT_EQ(0, J.row(1).norm());
  EXPECT_EQ(1, tasks.alignment()[1]);
}

TEST(TaskSpace, RefusesNoTargets) {
  const RobotWithHand r = robot_with_hand("kr5_sdh");
  const Ring ring = ring_through(Vector3d::Zero(), Vector3d::UnitX(), Vector3d::UnitZ(), 0.2);
  expect_refused([&] { TaskSpace(r.robot, r.hand, ring.p_W, {}); }, "targets must not be empty");
}

}  // namespace
}  // namespace graspless::clasp
