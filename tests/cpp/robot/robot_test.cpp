// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/robot/robot.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/tree.hpp>
#include <urdf_parser/urdf_parser.h>

#include "paths.hpp"
#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

Isometry3d translation(double x, double y, double z) {
  return Isometry3d(Eigen::Translation3d(x, y, z));
}

Isometry3d rotation(double angle, const Vector3d& axis) {
  return Isometry3d(Eigen::AngleAxisd(angle, axis));
}

/// Denavit and Hartenberg's standard step, frame i in frame i - 1.
Isometry3d dh(double a, double alpha, double d, double theta) {
  return rotation(theta, Vector3d::UnitZ()) * translation(a, 0, d) *
         rotation(alpha, Vector3d::UnitX());
}

/// Craig's modified step.
Isometry3d modified_dh(double alpha, double a, double d, double theta) {
  return rotation(alpha, Vector3d::UnitX()) * translation(a, 0, 0) *
         rotation(theta, Vector3d::UnitZ()) * translation(0, 0, d);
}

TEST(Robot, WamFollowsBarrettsTable) {
  const Robot robot = wam();
  const double h = M_PI / 2;
  const double table[7][3] = {{0, -h, 0},   {0, h, 0}, {0.045, -h, 0.55}, {-0.045, h, 0},
                              {0, -h, 0.3}, {0, h, 0}, {0, 0, 0.06}};
  std::mt19937_64 rng(1);
  for (int sample = 0; sample < 200; ++sample) {
    const VectorXd q = random_q(robot, rng);
    Isometry3d X_WF = translation(0, 0, 0.346);
    for (int i = 0; i < 7; ++i) X_WF = X_WF * dh(table[i][0], table[i][1], table[i][2], q[i]);
    EXPECT_LT(distance(robot.pose(robot.frame("flange"), q), X_WF), 1e-12);
    EXPECT_LT(distance(robot.pose(robot.frame("grasp"), q), X_WF * translation(0, 0, 0.21)), 1e-12);
  }
}

TEST(Robot, Kr5FollowsItsTable) {
  const Robot robot = kr5();
  const double h = M_PI / 2;
  const double table[6][4] = {{0, 0, 0.335, 0},      {-h, 0.075, 0, 0}, {0, 0.365, 0, -h},
                              {-h, 0.090, 0.405, 0}, {h, 0, 0, 0},      {-h, 0, 0.080, M_PI}};
  std::mt19937_64 rng(2);
  for (int sample = 0; sample < 200; ++sample) {
    const VectorXd q = random_q(robot, rng);
    Isometry3d X_WF = Isometry3d::Identity();
    for (int i = 0; i < 6; ++i) {
      X_WF = X_WF * modified_dh(table[i][0], table[i][1], table[i][2], q[i] + table[i][3]);
    }
    EXPECT_LT(distance(robot.pose(robot.frame("flange"), q), X_WF), 1e-12);
  }
}

TEST(Robot, LimitsOfTheWamAreTheManuals) {
  const Robot robot = wam();
  const double lower[] = {-2.6, -2.0, -2.8, -0.9, -4.76, -1.6, -3.0, 0};
  const double upper[] = {2.6, 2.0, 2.8, 3.1, 1.24, 1.6, 3.0, 1.2};
  ASSERT_EQ(robot.dof(), 8);
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(robot.lower()[i], lower[i]);
    EXPECT_EQ(robot.upper()[i], upper[i]);
  }
  EXPECT_TRUE(robot.is_within(robot.upper()));
  EXPECT_FALSE(robot.is_within(robot.upper().array() + 1e-6));
  EXPECT_EQ(robot.clamp(robot.upper().array() + 1), robot.upper());
}

TEST(Robot, StepsAreBetweenConfigurationsOfAllJoints) {
  const Robot robot = wam();
  const VectorXd q = robot.state("home"), next = q.array() + 0.02;
  EXPECT_NEAR(robot.step(q, next), 0.02, 1e-12);
  EXPECT_THROW(robot.step(q, VectorXd::Zero(3)), std::invalid_argument);
  EXPECT_THROW(robot.step(VectorXd::Zero(9), q), std::invalid_argument);
}

TEST(Robot, ConfigurationsAreFiniteAndLeaveLinksInTheWorld) {
  VectorXd q = wam().state("home");
  q[0] = 1e9;  // an angle
  EXPECT_TRUE(is_configuration(wam(), q));
  q[0] = NAN;
  EXPECT_FALSE(is_configuration(wam(), q));
  EXPECT_FALSE(is_configuration(wam(), VectorXd::Zero(3)));
  const Robot slider = Robot::from_urdf(
      "<robot name='slider'><link name='base'/><link name='cart'/>"
      "<joint name='rail' type='prismatic'><parent link='base'/><child link='cart'/>"
      "<limit lower='0' upper='1' effort='1' velocity='1'/></joint></robot>",
      {});
  EXPECT_TRUE(is_configuration(slider, VectorXd::Constant(1, 1000)));
  EXPECT_FALSE(is_configuration(slider, VectorXd::Constant(1, -1001)));
}

/// KDL's own chain and solver, built from urdfdom alone.
Isometry3d kdl_pose(const urdf::ModelInterface& urdf, const std::string& link,
                    const std::map<std::string, double>& values) {
  std::vector<urdf::JointConstSharedPtr> joints;
  for (auto l = urdf.getLink(link); l->parent_joint; l = l->getParent())
    joints.push_back(l->parent_joint);
  KDL::Chain chain;
  std::vector<double> q;
  for (auto it = joints.rbegin(); it != joints.rend(); ++it) {
    const urdf::Joint& joint = **it;
    const auto& pose = joint.parent_to_joint_origin_transform;
    const KDL::Frame origin(KDL::Rotation::Quaternion(pose.rotation.x, pose.rotation.y,
                                                      pose.rotation.z, pose.rotation.w),
                            KDL::Vector(pose.position.x, pose.position.y, pose.position.z));
    const KDL::Vector axis(joint.axis.x, joint.axis.y, joint.axis.z);
    KDL::Joint moved(joint.name, KDL::Joint::Fixed);
    if (joint.type == urdf::Joint::PRISMATIC) {
      moved = KDL::Joint(joint.name, origin.p, origin.M * axis, KDL::Joint::TransAxis);
    } else if (joint.type != urdf::Joint::FIXED) {
      moved = KDL::Joint(joint.name, origin.p, origin.M * axis, KDL::Joint::RotAxis);
    }
    chain.addSegment(KDL::Segment(joint.name, moved, origin));
    if (joint.type != urdf::Joint::FIXED) q.push_back(values.at(joint.name));
  }
  KDL::JntArray array(static_cast<unsigned>(q.size()));
  for (unsigned i = 0; i < q.size(); ++i) array(i) = q[i];
  KDL::Frame frame;
  KDL::ChainFkSolverPos_recursive(chain).JntToCart(array, frame);
  Isometry3d X = Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) X.linear()(i, j) = frame.M(i, j);
    X.translation()[i] = frame.p[i];
  }
  return X;
}

TEST(Robot, StaysWholeWhenMoved) {
  Robot robot = oddity();
  const Robot other = std::move(robot);
  EXPECT_EQ(robot.joint_names(), other.joint_names());  // NOLINT(bugprone-use-after-move)
}

TEST(Robot, ForwardIsKdlsForEveryFrame) {
  const Robot robot = oddity();
  const auto urdf = urdf::parseURDFFile(data_file("oddity.urdf"));
  ASSERT_TRUE(urdf);
  std::mt19937_64 rng(3);
  Poses X_WL;
  for (int sample = 0; sample < 50; ++sample) {
    const VectorXd q = random_q(robot, rng);
    std::map<std::string, double> values;
    for (int i = 0; i < robot.dof(); ++i) values[robot.joint_names()[i]] = q[i];
    values["mirror"] = -0.5 * values["joint10"] + 0.05;
    values["echo"] = 2 * values["mirror"] + 0.1;
    robot.forward(q, X_WL);
    for (std::size_t i = 0; i < X_WL.size(); ++i) {
      const std::string& link = robot.frame_names()[i];
      EXPECT_LT(distance(X_WL[i], kdl_pose(*urdf, link, values)), 1e-12) << link;
    }
  }
}

TEST(Robot, JointsComeDepthFirstInTheOrderOfTheFile) {
  const Robot robot = oddity();
  const std::vector<std::string> joints = {"joint10", "joint2", "a_turn", "tip_joint"};
  const std::vector<std::string> frames = {"root",   "z_link",    "slide",       "welded",
                                           "turner", "echo_link", "mirror_link", "tip"};
  EXPECT_EQ(robot.joint_names(), joints);
  EXPECT_EQ(robot.frame_names(), frames);
  EXPECT_EQ(robot.parent(robot.frame("tip")), robot.frame("mirror_link"));
  EXPECT_EQ(robot.parent(0), -1);
  EXPECT_EQ(robot.lower()[2], -M_PI);
  EXPECT_EQ(robot.upper()[2], M_PI);
  EXPECT_EQ(robot.max_velocity()[0], 3);
  EXPECT_EQ(robot.max_velocity()[1], 2);
  EXPECT_EQ(robot.max_effort()[1], 4);
}

TEST(Robot, ForwardToAndPoseAgreeWithForward) {
  const Robot robot = oddity();
  std::mt19937_64 rng(4);
  const VectorXd q = random_q(robot, rng);
  Poses all, some;
  robot.forward(q, all);
  for (int frame = 0; frame < static_cast<int>(all.size()); ++frame) {
    some.clear();
    robot.forward_to(frame, q, some);
    EXPECT_EQ(distance(some[frame], all[frame]), 0);
    EXPECT_EQ(distance(robot.pose(frame, q), all[frame]), 0);
  }
}

TEST(Robot, StandsWhereItIsPut) {
  Robot::Options options;
  options.X_WB = translation(1, 2, 3) * rotation(0.5, Vector3d(1, 2, 3).normalized());
  const Robot moved = Robot::from_urdf_file(urdf_file("wam_t42.urdf"), options);
  const Robot robot = wam();
  const VectorXd q = VectorXd::Constant(8, 0.3);
  const int tip = robot.frame("left_fingertip");
  EXPECT_LT(distance(moved.pose(tip, q), options.X_WB * robot.pose(tip, q)), 1e-12);
}

/// Central differences of the pose, as a twist.
Eigen::Matrix<double, 6, 1> difference(const Robot& robot, int frame, VectorXd q, int joint) {
  const double h = 1e-6;
  q[joint] += h;
  const Isometry3d X_plus = robot.pose(frame, q);
  q[joint] -= 2 * h;
  const Isometry3d X_minus = robot.pose(frame, q);
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(X_plus.linear() * X_minus.linear().transpose()));
  Eigen::Matrix<double, 6, 1> twist;
  twist << X_plus.translation() - X_minus.translation(), turn.angle() * turn.axis();
  return twist / (2 * h);
}

TEST(Robot, JacobianIsTheDerivativeOfThePose) {
  std::mt19937_64 rng(5);
  for (const Robot& robot : {wam(), kr5(), oddity()}) {
    for (int sample = 0; sample < 5; ++sample) {
      const VectorXd q = random_q(robot, rng);
      for (int frame = 0; frame < static_cast<int>(robot.frame_names().size()); ++frame) {
        const auto J = robot.jacobian(frame, q);
        for (int joint = 0; joint < robot.dof(); ++joint) {
          const double error = (J.col(joint) - difference(robot, frame, q, joint)).norm();
          EXPECT_LT(error, 1e-8) << robot.frame_names()[frame] << ' ' << robot.joint_names()[joint];
        }
      }
    }
  }
}

TEST(Robot, FingertipsFaceEachOther) {
  for (const Robot& robot : {wam(), kr5()}) {
    const VectorXd& q = robot.state("open");
    const Isometry3d X_WH = robot.pose(robot.frame("grasp"), q);
    const Isometry3d left = X_WH.inverse() * robot.pose(robot.frame("left_fingertip"), q);
    const Isometry3d right = X_WH.inverse() * robot.pose(robot.frame("right_fingertip"), q);
    EXPECT_LT((left.translation() - Vector3d(0, 0.04, 0)).norm(), 1e-12);
    EXPECT_LT((right.translation() + Vector3d(0, 0.04, 0)).norm(), 1e-12);
    EXPECT_LT((left.linear().col(1) + Vector3d::UnitY()).norm(), 1e-12);   // to the other finger
    EXPECT_LT((right.linear().col(1) - Vector3d::UnitY()).norm(), 1e-12);  // to the other finger
    EXPECT_LT((left.linear().col(2) - Vector3d::UnitZ()).norm(), 1e-12);   // out of the palm
    const VectorXd& closed = robot.state("closed");
    const double gap = (robot.pose(robot.frame("left_fingertip"), closed).translation() -
                        robot.pose(robot.frame("right_fingertip"), closed).translation())
                           .norm();
    EXPECT_LT(gap, 0.03);
  }
}

TEST(Robot, NamesAreCheckedAndChoicesListed) {
  const Robot robot = wam();
  EXPECT_CONTAINS(complaint([&] { robot.frame("elbow"); }),
                  "unknown link 'elbow'; choose from base_link");
  EXPECT_CONTAINS(complaint([&] { robot.joint("right_finger_joint"); }), "choose from wam_joint_1");
  EXPECT_CONTAINS(complaint([&] { robot.joint("WAM_joint3"); }),
                  "unknown joint 'WAM_joint3' (did you mean 'wam_joint_3'?); choose from");
  EXPECT_CONTAINS(complaint([&] { robot.group("amr"); }), "(did you mean 'arm'?)");
  EXPECT_CONTAINS(complaint([&] { robot.joint("wam_joint_9"); }),
                  "unknown joint 'wam_joint_9'; choose from");
  const std::string longer(20000, 'a');
  EXPECT_CONTAINS(complaint([&] { robot.joint(longer); }), "a'; choose from");
  EXPECT_CONTAINS(complaint([&] { robot.joint(""); }), "unknown joint ''; choose from");
  EXPECT_CONTAINS(complaint([&] { robot.group("leg"); }), "choose from arm, hand");
  EXPECT_CONTAINS(complaint([&] { robot.state("asleep"); }), "choose from closed, home, open");
  EXPECT_CONTAINS(complaint([&] { robot.parent(99); }), "99");
  Poses X_WL;
  EXPECT_CONTAINS(complaint([&] { robot.forward(VectorXd::Zero(7), X_WL); }), "8");
}

}  // namespace
}  // namespace graspless::robot
