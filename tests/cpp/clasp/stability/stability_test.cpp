// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/stability.hpp"

#include <cmath>
#include <set>
#include <variant>

#include <gtest/gtest.h>

#include "clasp/close.hpp"
#include "clasp/hand/kinematics.hpp"
#include "clasp/spaces.hpp"
#include "clasp/stability/balls.hpp"
#include "clasp/stability/tester.hpp"
#include "clasp/stability/walk.hpp"
#include "complaint.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

VectorXd closed_around(const Problem& problem) {
  FreeSpace space(problem);
  return close_hand(space, problem.robot, problem.hand, problem.q_start).back();
}

TEST(TestStability, ClosedHandHoldsARingAndAnOpenOneDoesNot) {
  StabilityOptions shape;  // without a load
  shape.force = shape.torque = 0;
  for (const std::string& hand : robots_with_hands()) {
    const Problem problem = ring_within(hand, 0.016, 0.02);
    const Stability closed = test_stability(problem, closed_around(problem), 0, shape);
    EXPECT_TRUE(closed.secure) << hand;
    EXPECT_EQ(closed.escapes, 0) << hand;
    EXPECT_GT(closed.margin, 0.3) << hand;
    const Stability open = test_stability(problem, problem.q_start, 0);
    EXPECT_FALSE(open.secure) << hand;
    EXPECT_EQ(open.escapes, 10) << hand;
    EXPECT_LT(open.margin, 0) << hand;
  }
}

void expect_same(const Stability& a, const Stability& b) {
  EXPECT_EQ(a.secure, b.secure);
  EXPECT_EQ(a.escapes, b.escapes);
  EXPECT_EQ(a.margin, b.margin);
  EXPECT_EQ(a.withstands, b.withstands);
  EXPECT_EQ(a.opens_first, b.opens_first);
  EXPECT_EQ(a.checks, b.checks);
}

TEST(StabilityTester, TestsQuicklyUpToAnEscapeInTheFirstSequence) {
  const Problem problem = ring_within("kr5_sdh");
  const Eigen::Matrix3Xd& loop_O = problem.object.loops().found.front().points;
  StabilityOptions options, first;
  options.sequences = 3;
  first.sequences = 1;
  StabilityTester tester(problem);
  const VectorXd closed = closed_around(problem), &open = problem.q_start;
  expect_same(tester.test_quickly(closed, loop_O, options, 0),
              tester.test(closed, loop_O, options));
  expect_same(tester.test_quickly(open, loop_O, options, 0), tester.test(open, loop_O, first));
  EXPECT_EQ(tester.test(open, loop_O, options).escapes, 3);
}

TEST(TestStability, IsTheSameForAnyNumberOfThreads) {
  const Problem problem = ring_within("kr5_sdh");
  const Eigen::Matrix3Xd& loop_O = problem.object.loops().found.front().points;
  const VectorXd closed = closed_around(problem);
  StabilityTester tester(problem);
  std::set<int> escapes;
  for (const double escape : {0.0, 0.01, 0.012, 0.014, 0.016, 0.02}) {
    StabilityOptions options;
    options.moves = 60;
    options.escape_distance = escape;
    const Stability one = tester.test(closed, loop_O, options);
    const Stability quick = tester.test_quickly(closed, loop_O, options, 0);
    escapes.insert(one.escapes);
    for (const int threads : {2, 4}) {
      options.threads = threads;
      expect_same(tester.test(closed, loop_O, options), one);
      expect_same(tester.test_quickly(closed, loop_O, options, 0), quick);
    }
  }
  EXPECT_GT(escapes.size(), 2u);  // all, none, and a few of the sequences
}

TEST(TestStability, SameSeedSameWalk) {
  const Problem problem = ring_within("kr5_sdh");
  const VectorXd q = closed_around(problem);
  StabilityOptions options;
  options.sequences = 2;
  const Stability first = test_stability(problem, q, 0, options);
  const Stability again = test_stability(problem, q, 0, options);
  EXPECT_EQ(first.margin, again.margin);
  EXPECT_EQ(first.checks, again.checks);
  options.seed = 2;
  EXPECT_NE(first.checks, test_stability(problem, q, 0, options).checks);
}

TEST(TestStability, WhereHandAndObjectStandTogetherDoesNotMatter) {
  Problem problem = ring_within("kr5_sdh");
  const VectorXd q = closed_around(problem);
  StabilityOptions options;
  options.sequences = 2;
  const double margin = test_stability(problem, q, 0, options).margin;
  // The first joint turns arm and ring about the same axis.
  VectorXd turned = q;
  turned[0] += 0.7;
  const auto palm = [&](const VectorXd& at) {
    return problem.robot.pose(problem.robot.frame("palm"), at);
  };
  problem.X_WO = palm(turned) * palm(q).inverse() * problem.X_WO;
  const Stability stability = test_stability(problem, turned, 0, options);
  EXPECT_TRUE(stability.secure);
  EXPECT_NEAR(stability.margin, margin, 0.1);
}

TEST(TestStability, ARobotDeepInTheObjectHoldsNothing) {
  Problem problem = ring_within("kr5_sdh");
  const Vector3d forward =
      problem.robot.pose(problem.robot.frame("palm"), problem.q_start).linear() *
      problem.hand.forward_H;
  problem.X_WO.translation() -= 0.06 * forward;
  const Stability stability = test_stability(problem, problem.q_start, 0);
  EXPECT_FALSE(stability.secure);
  EXPECT_EQ(stability.checks, 0);
}

TEST(TestStability, RefusesNonsense) {
  const Problem problem = ring_within("kr5_sdh");
  const VectorXd& q = problem.q_start;
  StabilityOptions options;
  const auto run = [&](int loop) { test_stability(problem, q, loop, options); };
  expect_refused([&] { run(1); }, "loop must be the index of one of the 1 loops of object 'ring'");
  expect_refused([&] { run(-1); }, "loop");
  expect_refused([&] { test_stability(problem, VectorXd::Zero(3), 0); }, "q");
  options.sequences = 0;
  expect_refused([&] { run(0); }, "stability.sequences must lie in [1, 1000], not 0");
  options = {};
  options.turn = std::nan("");
  expect_refused([&] { run(0); }, "stability.turn must lie in [0.001, 1] rad");
  options = {};
  options.penetration = -1;
  expect_refused([&] { run(0); }, "stability.penetration");
  options = {};
  options.moves = 1000000000;
  expect_refused([&] { run(0); }, "stability.moves must lie in [1, 10000], not 1000000000");
  options = {};
  options.step = 1e-300;
  expect_refused([&] { run(0); }, "stability.step must lie in [0.0001, 0.1] m, not 1e-300");
  options = {};
  options.escape_distance = 1e300;
  expect_refused([&] { run(0); }, "stability.escape_distance must lie in [0, 10] m, not 1e+300");
}

/// Balls within the links, and none looks out.
TEST(LinkBalls, LieWithinTheLinks) {
  for (const std::string& name : robots_with_hands()) {
    const RobotWithHand r = robot_with_hand(name);
    robot::Poses X_WL;
    const VectorXd q = at_home(r, r.hand.open);
    r.robot.forward(q, X_WL);
    const LinkBalls balls(r.robot);
    const Eigen::Matrix3Xd centers = balls.centers_W(X_WL);
    EXPECT_GT(centers.cols(), 50);
    std::mt19937_64 rng(1);
    std::normal_distribution<double> normal;
    for (Eigen::Index i = 0; i < centers.cols(); i += 5) {
      const Vector3d out = Vector3d(normal(rng), normal(rng), normal(rng)).normalized();
      collision::World world;
      const int point = world.add_body("point", {{geometry::Sphere{1e-5}}});
      for (const robot::LinkShape& shape : r.robot.shapes()) {
        const int body = world.add_body(std::to_string(world.num_bodies()), {shape.placed});
        world.set_pose(body, X_WL[shape.link]);
        world.add_pair(point, body);
      }
      world.set_pose(point, Eigen::Isometry3d(Eigen::Translation3d(
                                centers.col(i) + (balls.radii()[i] - 1e-5) * out)));
      EXPECT_TRUE(world.collides()) << name << " ball " << i;
    }
  }
}

/// The object cannot pass between them: every point 2 mm deep in a capsule is in a ball.
TEST(LinkBalls, FillCapsules) {
  for (const std::string& name : robots_with_hands()) {
    const robot::Robot robot = robot_with_hand(name).robot;
    robot::Poses X_WL;
    robot.forward(robot.state("home"), X_WL);
    const LinkBalls balls(robot);
    const Eigen::Matrix3Xd centers = balls.centers_W(X_WL);
    std::mt19937_64 rng(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const robot::LinkShape& shape : robot.shapes()) {
      const auto* capsule = std::get_if<geometry::Capsule>(&shape.placed.shape);
      if (capsule == nullptr) continue;
      for (int i = 0; i < 20; ++i) {
        const double along = (unit(rng) - 0.5) * capsule->length, angle = 2 * M_PI * unit(rng);
        const double out = capsule->radius - 0.002;
        const Vector3d p = X_WL[shape.link] * shape.placed.X_BG *
                           Vector3d(out * std::cos(angle), out * std::sin(angle), along);
        const VectorXd gaps = (centers.colwise() - p).colwise().norm().transpose() - balls.radii();
        EXPECT_LE(gaps.minCoeff(), 0) << name;
      }
    }
  }
}

/// A move goes exactly as far as looking at every ball at every step says.
TEST(ObjectWalk, StopsWhereSteppingStops) {
  const Problem problem = ring_within("kr5_sdh");
  std::mt19937_64 rng(5);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    return Vector3d(normal(rng), normal(rng), normal(rng)).normalized();
  };
  // Some near the object, and groups of others that mostly stay far away.
  constexpr int kNear = 12, kBalls = 60;
  Eigen::Matrix3Xd balls(3, kBalls);
  for (int i = 0; i < kBalls; ++i)
    balls.col(i) = (i < kNear ? 0.05 : 0.2 + 0.005 * i) * direction();
  VectorXd radii = VectorXd::Constant(kBalls, 0.006);
  radii.tail(kBalls - kNear).setConstant(0.02);
  collision::Clearance clearance = problem.object.clearance();
  const StabilityOptions options;
  ObjectWalk walk(balls, radii, Matrix3d::Identity(), Vector3d(0, 0.1, 0), options, clearance);
  ASSERT_FALSE(walk.hits_at_start());
  Matrix3d R_OW = Matrix3d::Identity();
  Vector3d p_OC(0, 0.1, 0);
  const auto hits = [&](const Matrix3d& R, const Vector3d& p) {
    for (int i = 0; i < kBalls; ++i) {
      if (clearance.distance(R * balls.col(i) + p) < radii[i]) return true;
    }
    return false;
  };
  for (int move = 0; move < 60; ++move) {
    const Vector3d along = direction();
    int step = 0;
    if (move % 2 == 0) {
      const Vector3d d = R_OW * -options.step * along;
      while (step < 50 && !hits(R_OW, p_OC + (step + 1) * d)) ++step;
      p_OC += step * d;
      walk.translate(along, 50);
    } else {
      const auto turned = [&](int k) -> Matrix3d {
        return R_OW * Eigen::AngleAxisd(-k * options.turn, along).toRotationMatrix();
      };
      while (step < 100 && !hits(turned(step + 1), p_OC)) ++step;
      R_OW = turned(step);
      walk.rotate(along, 100);
    }
    ASSERT_NEAR((walk.p_OC() - p_OC).norm(), 0, 1e-9) << "move " << move;
  }
  EXPECT_GT(walk.steps(), 60);
}

}  // namespace
}  // namespace graspless::clasp
