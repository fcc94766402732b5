// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/robot/robot.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/tree.hpp>
#include <urdf_parser/urdf_parser.h>

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

TEST(Robot, ForwardIsKdlsForEveryFrame) {
  const Robot robot = oddity();
  const auto urdf = urdf::parseURDFFile(GRASPLESS_TEST_DATA_DIR "/oddity.urdf");
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
  EXPECT_EQ(robot.max_velocity()[0], std::numeric_limits<double>::infinity());  // the file says 0
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
  const Robot moved = Robot::from_urdf_file(GRASPLESS_URDF_DIR "/wam_t42.urdf", options);
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

/// Points on the outside of a shape, in the frame of its link.
Eigen::Matrix3Xd points_of(const geometry::PlacedShape& placed) {
  Eigen::Matrix3Xd p_G(3, 0);
  const auto add = [&](const Vector3d& p) {
    p_G.conservativeResize(3, p_G.cols() + 1);
    p_G.rightCols<1>() = p;
  };
  const auto add_ball = [&](const Vector3d& center, double radius) {
    for (double a = -3; a < 3; a += 0.5) {
      for (double b = -1.5; b <= 1.5; b += 0.5) {
        add(center +
            radius * Vector3d(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)));
      }
    }
  };
  if (const auto* box = std::get_if<geometry::Box>(&placed.shape)) {
    for (int i = 0; i < 8; ++i) {
      add(box->size.cwiseProduct(
          Vector3d(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5)));
    }
  } else if (const auto* sphere = std::get_if<geometry::Sphere>(&placed.shape)) {
    add_ball(Vector3d::Zero(), sphere->radius);
  } else if (const auto* capsule = std::get_if<geometry::Capsule>(&placed.shape)) {
    add_ball(Vector3d(0, 0, capsule->length / 2), capsule->radius);
    add_ball(Vector3d(0, 0, -capsule->length / 2), capsule->radius);
  } else if (const auto* convex = std::get_if<geometry::Convex>(&placed.shape)) {
    p_G = convex->vertices;
  } else if (const auto* mesh = std::get_if<geometry::Mesh>(&placed.shape)) {
    p_G = mesh->vertices;
  }
  return placed.X_BG * p_G;
}

TEST(Robot, ReachBoundsEveryMotion) {
  std::mt19937_64 rng(6);
  for (const Robot& robot : {wam(), kr5(), oddity()}) {
    double tightest = std::numeric_limits<double>::infinity();
    for (int sample = 0; sample < 400; ++sample) {
      const VectorXd q1 = random_q(robot, rng);
      // Far pairs and near ones: only near ones come close to the bound.
      const double share = sample % 2 == 0 ? 1 : 0.01;
      const VectorXd q2 = q1 + share * (random_q(robot, rng) - q1);
      for (const LinkShape& shape : robot.shapes()) {
        const Eigen::Matrix3Xd p_L = points_of(shape.placed);
        const Eigen::Matrix3Xd moved =
            robot.pose(shape.link, q2) * p_L - robot.pose(shape.link, q1) * p_L;
        const double bound = robot.reach(shape.link).dot((q2 - q1).cwiseAbs());
        const double distance = moved.colwise().norm().maxCoeff();
        EXPECT_LE(distance, bound + 1e-12) << robot.frame_names()[shape.link];
        if (distance > 0) tightest = std::min(tightest, bound / distance);
      }
    }
    EXPECT_LT(tightest, 1.5);  // a bound, but not a wasteful one
  }
}

TEST(Robot, ShapesBecomeCapsulesPrismsAndMeshes) {
  const Robot arm = wam();
  int capsules = 0;
  for (const LinkShape& shape : arm.shapes()) {
    capsules += std::holds_alternative<geometry::Capsule>(shape.placed.shape);
    EXPECT_FALSE(std::holds_alternative<geometry::Sphere>(shape.placed.shape));
  }
  EXPECT_EQ(capsules, 8);

  const Robot robot = oddity();
  ASSERT_EQ(robot.shapes().size(), 6u);
  const auto& prism = std::get<geometry::Convex>(robot.shapes()[1].placed.shape).vertices;
  ASSERT_EQ(prism.cols(), 48);
  const double radius = prism.topRows<2>().colwise().norm().maxCoeff();
  EXPECT_NEAR(radius * std::cos(M_PI / 24), 0.05, 1e-12);  // its sides touch the cylinder
  EXPECT_NEAR(prism.row(2).maxCoeff(), 0.1, 1e-12);
  const auto& mesh = std::get<geometry::Mesh>(robot.shapes()[3].placed.shape);
  EXPECT_NEAR(mesh.vertices.row(2).maxCoeff(), 0.2, 1e-12);  // scaled
  EXPECT_EQ(mesh.triangles.cols(), 4);
}

TEST(Robot, NeighboursAreNeverTested) {
  const Robot robot = oddity();
  const auto ignored = [&](const std::string& a, const std::string& b) {
    const int i = robot.frame(a), j = robot.frame(b);
    return robot.ignored_pairs().count({std::min(i, j), std::max(i, j)}) == 1;
  };
  EXPECT_TRUE(ignored("root", "slide"));  // z_link between them has no shape
  EXPECT_TRUE(ignored("slide", "welded"));
  EXPECT_TRUE(ignored("welded", "turner"));
  EXPECT_TRUE(ignored("turner", "echo_link"));
  EXPECT_TRUE(ignored("turner", "tip"));
  EXPECT_FALSE(ignored("root", "welded"));
  EXPECT_FALSE(ignored("slide", "turner"));
  EXPECT_FALSE(ignored("echo_link", "tip"));  // siblings
  const Robot arm = wam();
  EXPECT_EQ(arm.ignored_pairs().count({arm.frame("base_link"), arm.frame("wam_link_3")}), 1u);
  EXPECT_EQ(arm.ignored_pairs().count({arm.frame("left_finger"), arm.frame("right_finger")}), 0u);
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
  EXPECT_CONTAINS(complaint([&] { robot.group("leg"); }), "choose from arm, hand");
  EXPECT_CONTAINS(complaint([&] { robot.state("asleep"); }), "choose from closed, home, open");
  EXPECT_CONTAINS(complaint([&] { robot.parent(99); }), "99");
  Poses X_WL;
  EXPECT_CONTAINS(complaint([&] { robot.forward(VectorXd::Zero(7), X_WL); }), "8");
}

}  // namespace
}  // namespace graspless::robot
