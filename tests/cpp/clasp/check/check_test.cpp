// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check() must see every way in which a plan can lie: each test breaks one promise of a good plan.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "graspless/clasp/sample_objects.hpp"
#include "graspless/geometry/linking.hpp"
#include "graspless/geometry/sampling.hpp"

#include "clasp/check/checker.hpp"
#include "clasp/ring_problem.hpp"
#include "complaint.hpp"

namespace graspless::clasp {
namespace {

const Plan& good_plan() {
  static const Plan plan =
      clasp::plan(ring_problem(), {}, {std::numeric_limits<double>::infinity(), 200, 1, {}});
  return plan;
}

class ClaspCheck : public ::testing::Test {
 protected:
  ClaspCheck() : problem_(ring_problem()), plan_(good_plan()) {}

  std::string faults(const Options& options = {}) {
    return joined(check(problem_, plan_, options));
  }
  void expect_fault(const std::string& words, const Options& options = {}) {
    const std::string all = faults(options);
    EXPECT_NE(all.find(words), std::string::npos) << "faults found:\n" << all;
  }
  Segment& reach() { return plan_.segments[0]; }
  Segment& close() { return plan_.segments[1]; }

  Problem problem_;
  Plan plan_;
};

TEST_F(ClaspCheck, AGoodPlanHolds) { EXPECT_EQ(faults(), ""); }

TEST_F(ClaspCheck, APlanThatWasNotFound) {
  plan_.status = Status::not_found;
  expect_fault("not solved");
}

TEST_F(ClaspCheck, AMissingSegment) {
  plan_.segments.pop_back();
  expect_fault("segments are not reach, close");
}

TEST_F(ClaspCheck, OtherJoints) {
  std::swap(plan_.joint_names[0], plan_.joint_names[1]);
  expect_fault("joint names");
}

TEST_F(ClaspCheck, AValueThatIsNotFinite) {
  reach().positions[1][2] = std::numeric_limits<double>::quiet_NaN();
  expect_fault("not finite");
}

TEST_F(ClaspCheck, LinkingOfTooFewCurves) {
  close().virtual_linking.conservativeResize(1, Eigen::NoChange);
  expect_fault("virtual linking of 2 curves");
}

TEST_F(ClaspCheck, AnotherStart) {
  problem_.q_start[0] += 0.1;
  expect_fault("reach row 0");
}

TEST_F(ClaspCheck, AJump) {
  auto& rows = reach().positions;
  rows.erase(rows.begin() + 1, rows.begin() + 4);
  Eigen::MatrixXd& linking = reach().virtual_linking;
  linking = Eigen::MatrixXd(linking.rightCols(rows.size()));
  expect_fault("rad between rows");
}

TEST_F(ClaspCheck, AHandOutsideItsLimits) {
  Eigen::VectorXd& q = close().positions.back();
  q[q.size() - 1] = 9;
  expect_fault("leaves the joint limits");
}

TEST_F(ClaspCheck, ALoopThatIsNotThere) {
  plan_.loop = 1;
  expect_fault("loop 1 is not one of the object's 1");
}

TEST_F(ClaspCheck, ATargetBesideItsLoop) {
  plan_.target.point.x() += 0.01;
  expect_fault("does not lie on its loop");
}

TEST_F(ClaspCheck, ATargetThatWasNotMarked) {
  problem_.marks = {problem_.object.loops().found[0].points.col(0)};
  const Eigen::Vector3d& target = plan_.target.point;
  if ((target - problem_.marks[0]).norm() < 1e-3) {
    problem_.marks[0] = problem_.object.loops().found[0].points.col(10);
  }
  expect_fault("none of the marked places");
}

TEST_F(ClaspCheck, ATangentAcrossTheLoop) {
  plan_.target.tangent = plan_.target.tangent.unitOrthogonal();
  expect_fault("tangent");
}

TEST_F(ClaspCheck, AHandThatIsNotAtItsTarget) {
  const Eigen::Matrix3Xd& loop = problem_.object.loops().found[0].points;
  Eigen::Index farthest = 0;
  (loop.colwise() - plan_.target.point).colwise().norm().maxCoeff(&farthest);
  plan_.target = geometry::clasp_targets(loop, static_cast<int>(loop.cols()))[0];
  plan_.target.point = loop.col(farthest);
  expect_fault("away from its target");
}

TEST_F(ClaspCheck, APullThatThePlaceIsNotGoodFor) {
  const Eigen::Vector3d middle = problem_.object.loops().found[0].points.rowwise().mean();
  problem_.pull_W = problem_.X_WO.linear() * (middle - plan_.target.point);
  expect_fault("not good for the pull");
}

TEST_F(ClaspCheck, AnObstacleInTheWay) {
  const auto& way = reach().positions;
  const auto last = problem_.robot.frame(problem_.hand.frame);
  Obstacle ball{"ball", {{geometry::Sphere{0.03}}}};
  ball.X_WB.translation() = problem_.robot.pose(last, way[way.size() / 2]).translation();
  problem_.obstacles.push_back(ball);
  expect_fault("collision");
}

TEST_F(ClaspCheck, AnObjectThatStandsElsewhere) {
  problem_.X_WO.translation().y() += 0.02;
  expect_fault("virtual linking of curve");
}

TEST_F(ClaspCheck, LinkingThatIsMadeUp) {
  reach().virtual_linking(0, 3) = 0.9;
  expect_fault("reach row 3: virtual linking of curve 0 is ");
}

TEST_F(ClaspCheck, AThresholdThatWasNotAskedFor) {
  plan_.min_linking = 0.001;
  expect_fault("min_linking is 0.001, not");
}

TEST_F(ClaspCheck, AReachThatEndsTooEarly) {
  Options options;
  options.min_linking = 0.999;
  expect_fault("below min_linking 0.999", options);
}

TEST_F(ClaspCheck, AHandThatIsNotClosed) {
  ASSERT_GT(close().positions.size(), 2u);
  close().positions.resize(1);
  close().virtual_linking = Eigen::MatrixXd(close().virtual_linking.leftCols(1));
  expect_fault("could close further");
}

TEST_F(ClaspCheck, AnArmThatMovesWhileTheHandCloses) {
  close().positions.back()[0] += 0.001;
  expect_fault("does not close the hand");
}

TEST_F(ClaspCheck, AStabilityThatIsMadeUp) {
  plan_.stability.margin += 0.1;
  expect_fault("stability is not what its test says");
}

TEST_F(ClaspCheck, AnOpenHandDoesNotHold) {
  const Problem problem = ring_problem();
  Eigen::VectorXd q = reach().positions.back();
  for (const int joint : problem.robot.group(problem.hand.hand))
    q[joint] = problem.robot.state(problem.hand.open)[joint];
  EXPECT_TRUE(comes_free(problem, 0, q));
  EXPECT_FALSE(comes_free(problem, 0, close().positions.back()));
}

/// The handle of the purse, where every hand of ours can pass.
Problem purse_problem(const std::string& robot) {
  static const Object purse =
      Object::from_cloud("purse", geometry::sample_surface(sample_object("purse"), 1200));
  const RobotWithHand r = robot_with_hand(robot);
  Problem problem{r.robot, r.hand, purse, Eigen::Isometry3d::Identity(), {}, at_home(r, "open"),
                  {},      {},     {}};
  problem.X_WO =
      Eigen::Translation3d(0.6, 0, -0.1) * Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ());
  return problem;
}

TEST(ClaspCheckPlans, HoldForEveryHand) {
  for (const std::string name : {"kr5_sdh", "kr5_dlr", "kr5_icub", "kr5_armar"}) {
    SCOPED_TRACE(name);
    const Problem problem = purse_problem(name);
    const Plan found = clasp::plan(problem, {}, {60, 100, 1, {}});
    ASSERT_TRUE(found) << found.reason;
    EXPECT_EQ(check(problem, found), std::vector<std::string>{});
  }
}

TEST(ClaspCheckPlans, HoldWithMarksPullAndObstacles) {
  Problem problem = ring_problem();
  const Eigen::Matrix3Xd& loop = problem.object.loops().found[0].points;
  const planning::Budget budget{60, 100, 1, {}};
  problem.pull_W = -Eigen::Vector3d::UnitY();
  Plan found = clasp::plan(problem, {}, budget);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(check(problem, found), std::vector<std::string>{});

  problem.pull_W.reset();
  Eigen::Index top = 0;
  loop.row(2).maxCoeff(&top);
  problem.marks = {loop.col(top) + Eigen::Vector3d(0, 0.003, 0.02)};
  Obstacle pole{"pole", {{geometry::Box{{0.03, 0.03, 0.6}}}}};
  pole.X_WB.translation() = Eigen::Vector3d(0.35, 0.3, 0.3);
  problem.obstacles = {pole};
  found = clasp::plan(problem, {}, budget);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(check(problem, found), std::vector<std::string>{});
}

TEST(ClaspCheckLinking, TheDoubleIntegralAgreesWithTheLibrary) {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto knot = [&](int n) {
    return Eigen::Matrix3Xd(Eigen::Matrix3Xd::NullaryExpr(3, n, [&] { return uniform(rng); }));
  };
  int linked = 0;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Matrix3Xd a = knot(12), b = knot(7);
    EXPECT_NEAR(std::abs(double_integral(a, b)), std::abs(geometry::linking_number(a, b)), 1e-9);
    if (geometry::linking_number(a, b) != 0) ++linked;
  }
  EXPECT_GT(linked, 40);
}

TEST(ClaspValidate, NamesFieldAndChoices) {
  const auto with = [](auto change) {
    return [change] {
      Problem problem = ring_problem();
      change(problem);
      validate(problem);
    };
  };
  expect_refused(with([](Problem& p) { p.loops = {3}; }),
                 "loops[0]: there is no loop 3; object 'ring' has 1 loop,");
  expect_refused(with([](Problem& p) { p.loops = {0, 0}; }), "loops[1]: loop 0 is given twice");
  expect_refused(with([](Problem& p) { p.marks = {{0, 0, 1e9}}; }), "marks[0] must be finite");
  for (const double length : {0.0, 1e-9, 1e5, std::nan("")}) {
    expect_refused(with([&](Problem& p) { p.pull_W = length * Eigen::Vector3d::UnitX(); }),
                   "pull_W must be a direction whose length lies in [1e-06, 10000], not ");
  }
  expect_refused(with([](Problem& p) { p.q_start[1] = 9; }), "q_start: joint");
  expect_refused(with([](Problem& p) { p.X_WO.linear() *= 2; }), "X_WO must be a rigid pose");
  expect_refused(with([](Problem& p) {
                   p.obstacles = {{"palm", {{geometry::Sphere{0.1}}}}};
                 }),
                 "is taken by");
  expect_refused(with([](Problem& p) { p.hand.fingers.clear(); }), "finger");
}

}  // namespace
}  // namespace graspless::clasp
