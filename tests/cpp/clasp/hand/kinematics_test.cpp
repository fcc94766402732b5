// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/hand/kinematics.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "clasp/hands.hpp"
#include "robot/robots.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

class HandKinematicsOf : public testing::TestWithParam<std::string> {
 protected:
  RobotWithHand robot_ = robot_with_hand(GetParam());
  HandKinematics kinematics_{robot_.robot, robot_.hand};
  std::mt19937_64 rng_{1};
};
INSTANTIATE_TEST_SUITE_P(Robots, HandKinematicsOf, testing::ValuesIn(robots_with_hands()),
                         [](const auto& info) { return info.param; });

TEST_P(HandKinematicsOf, CurvesRunFromTheFingersTipToTheThumbs) {
  const Hand& hand = robot_.hand;
  ASSERT_EQ(hand.fingers.size(), static_cast<std::size_t>(kinematics_.num_curves()));
  const VectorXd q = robot::random_q(robot_.robot, rng_);
  kinematics_.update(q);
  for (int i = 0; i < kinematics_.num_curves(); ++i) {
    std::vector<CurveNode> nodes = hand.fingers[i].nodes;
    std::reverse(nodes.begin(), nodes.end());
    nodes.insert(nodes.end(), hand.thumb.nodes.begin(), hand.thumb.nodes.end());
    const Eigen::Matrix3Xd points = kinematics_.curve_points(i);
    ASSERT_EQ(nodes.size(), static_cast<std::size_t>(points.cols()));
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Vector3d p_W = place(robot_, nodes[k], q);
      EXPECT_LT((points.col(k) - p_W).norm(), 1e-12);
    }
  }
}

TEST_P(HandKinematicsOf, NodesMoveAsTheirDerivativesSay) {
  constexpr double kStep = 1e-6;
  HandKinematics::Jacobian3 J;
  for (int trial = 0; trial < 5; ++trial) {
    const VectorXd q = robot::random_q(robot_.robot, rng_);
    for (int j = 0; j < q.size(); ++j) {
      const VectorXd step = kStep * VectorXd::Unit(q.size(), j);
      kinematics_.update(q + step);
      const Eigen::Matrix3Xd more = kinematics_.nodes();
      kinematics_.update(q - step);
      const Eigen::Matrix3Xd by_q = (more - kinematics_.nodes()) / (2 * kStep);
      kinematics_.update(q);
      for (int n = 0; n < by_q.cols(); ++n) {
        J.setZero(3, q.size());
        for (int k = 0; k < 3; ++k) kinematics_.add_row(n, Vector3d::Unit(k), J.row(k));
        ASSERT_LT((J.col(j) - by_q.col(n)).norm(), 1e-8) << "joint " << j << " node " << n;
      }
    }
  }
}

TEST_P(HandKinematicsOf, HandTurnsAsItsDerivativeSays) {
  constexpr double kStep = 1e-6;
  const VectorXd q = robot::random_q(robot_.robot, rng_);
  HandKinematics::Jacobian3 J;
  for (int j = 0; j < q.size(); ++j) {
    const VectorXd step = kStep * VectorXd::Unit(q.size(), j);
    kinematics_.update(q + step);
    const Vector3d forward = kinematics_.forward_W(), sideways = kinematics_.sideways_W();
    kinematics_.update(q - step);
    const Vector3d forward_by_q = (forward - kinematics_.forward_W()) / (2 * kStep);
    const Vector3d sideways_by_q = (sideways - kinematics_.sideways_W()) / (2 * kStep);
    kinematics_.update(q);
    J.setZero(3, q.size());
    for (int k = 0; k < 3; ++k) kinematics_.add_rotation_row(Vector3d::Unit(k), J.row(k));
    const Vector3d turn = J.col(j);
    EXPECT_LT((turn.cross(kinematics_.forward_W()) - forward_by_q).norm(), 1e-8);
    EXPECT_LT((turn.cross(kinematics_.sideways_W()) - sideways_by_q).norm(), 1e-8);
  }
}

TEST(HandKinematics, KnowsANodeThatFingersShareOnce) {
  RobotWithHand r = robot_with_hand("kr5_sdh");
  const CurveNode palm{"palm", Vector3d(0, 0, 0.07)};
  for (Finger& finger : r.hand.fingers) finger.nodes.front() = palm;
  r.hand.thumb.nodes.front() = palm;
  const HandKinematics kinematics(r.robot, r.hand);
  EXPECT_EQ(1 + 3 * 3, kinematics.nodes().cols());
  EXPECT_EQ(7u, kinematics.curve(0).size());  // the corner in the palm is one
}

}  // namespace
}  // namespace graspless::clasp
