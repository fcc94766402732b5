// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Debian's OMPL and KDL were built against different Eigens and both export weak symbols of
// JacobiSVD; the first one loaded wins, and the other may abort. What our users may call of both
// must work in one process that also decomposes matrices itself.
#include <Eigen/SVD>
#include <gtest/gtest.h>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <ompl/base/Constraint.h>

#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

/// The fingertips stay at one height; project() is our own, as everywhere in the library.
class Height : public ompl::base::Constraint {
 public:
  Height(const Robot& robot, double z)
      : Constraint(static_cast<unsigned>(robot.dof()), 1), robot_(robot), z_(z) {}

  void function(const Eigen::Ref<const Eigen::VectorXd>& q,
                Eigen::Ref<Eigen::VectorXd> out) const override {
    out[0] = robot_.pose(robot_.frame("grasp"), q).translation().z() - z_;
  }
  void jacobian(const Eigen::Ref<const Eigen::VectorXd>& q,
                Eigen::Ref<Eigen::MatrixXd> out) const override {
    out = robot_.jacobian(robot_.frame("grasp"), q).row(2);
  }
  bool project(Eigen::Ref<Eigen::VectorXd> q) const override {
    Eigen::VectorXd f(1);
    Eigen::MatrixXd J(1, q.size());
    for (int i = 0; i < 50; ++i) {
      function(q, f);
      if (f.norm() < getTolerance()) return true;
      jacobian(q, J);
      q -= J.jacobiSvd(Eigen::ComputeThinU | Eigen::ComputeThinV).solve(f);
    }
    return false;
  }

 private:
  Robot robot_;
  double z_;
};

TEST(Coexistence, KdlOmplAndJacobiSvdInOneProcess) {
  const Robot robot = wam();
  const Height constraint(robot, 0.3);
  Eigen::VectorXd q = robot.state("home");
  EXPECT_TRUE(constraint.project(q));
  EXPECT_NEAR(robot.pose(robot.frame("grasp"), q).translation().z(), 0.3, 1e-3);

  const Eigen::MatrixXd A = Eigen::MatrixXd::Random(6, 8);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(A, Eigen::ComputeThinU | Eigen::ComputeThinV);
  EXPECT_LT(
      (svd.matrixU() * svd.singularValues().asDiagonal() * svd.matrixV().transpose() - A).norm(),
      1e-12);

  KDL::Chain chain;
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ), KDL::Frame(KDL::Vector(1, 0, 0))));
  KDL::JntArray angle(1);
  angle(0) = M_PI / 2;
  KDL::Frame tip;
  ASSERT_GE(KDL::ChainFkSolverPos_recursive(chain).JntToCart(angle, tip), 0);
  EXPECT_NEAR(tip.p.y(), 1, 1e-12);
}

}  // namespace
}  // namespace graspless::robot
