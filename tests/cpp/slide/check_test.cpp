// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check() must report every kind of fault: each test breaks one property of a valid plan.
#include <gtest/gtest.h>

#include "graspless/robot/ik.hpp"

#include "complaint.hpp"
#include "slide/placement.hpp"
#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

class Check : public ::testing::Test {
 protected:
  Check() : problem_(simple_problem()), plan_(plan(problem_, {}, seeded(1))) {}

  Segment& segment(const std::string& name) {
    for (Segment& s : plan_.segments) {
      if (s.name == name) return s;
    }
    throw std::logic_error(name);
  }
  void expect_fault(const std::string& words, const Options& options = {}) {
    const std::string all = joined(check(problem_, plan_, options));
    EXPECT_NE(all.find(words), std::string::npos) << "faults found:\n" << all;
  }

  Problem problem_;
  Plan plan_;
};

TEST_F(Check, AGoodPlanHolds) { EXPECT_TRUE(check(problem_, plan_).empty()); }

TEST_F(Check, APlanThatWasNotFound) {
  plan_.status = Status::not_connected;
  expect_fault("not solved");
}

TEST_F(Check, AMissingSegment) {
  plan_.segments.pop_back();
  expect_fault("segments are not");
}

TEST_F(Check, APadThatSlips) {
  problem_.hand.pad_friction = 0.15;
  expect_fault("warnings: the plan lacks this one: the fingertip's pad cannot drag the object");
  expect_fault("tube: friction may leave the object out of the hand");
  plan_.warnings = {"the fingertip's pad cannot drag the object: as before"};
  plan_.tube = {};
  Options any;
  any.refuse_lag = false;
  EXPECT_TRUE(check(problem_, plan_, any).empty());
}

TEST_F(Check, AHeavierObject) {
  problem_.object = problem_.object.with_mass(20 * problem_.object.mass());
  expect_fault("tube row");
}

TEST_F(Check, OtherJoints) {
  std::swap(plan_.joint_names[0], plan_.joint_names[1]);
  expect_fault("plan: joint names are not in the robot's order");
  plan_.joint_names[0] = "other";
  expect_fault("plan: joint names are not the robot's");
}

TEST_F(Check, AValueThatIsNotFinite) {
  segment("reach").positions[0][2] = std::numeric_limits<double>::quiet_NaN();
  expect_fault("not finite");
}

TEST_F(Check, AnObjectBeyondTheWorld) {
  segment("slide").object_poses[1].translation().x() = 1e9;
  expect_fault("no pose");
}

TEST_F(Check, AnotherHome) {
  problem_.q_home[0] += 0.1;
  expect_fault("home");
}

TEST_F(Check, AJump) {
  auto& rows = segment("slide").positions;
  rows.erase(rows.begin() + 1, rows.begin() + 4);
  auto& poses = segment("slide").object_poses;
  poses.erase(poses.begin() + 1, poses.begin() + 4);
  expect_fault("rad between rows");
}

TEST_F(Check, ALimit) {
  auto& rows = segment("reach").positions;
  rows[rows.size() / 2][5] = 1.7;
  expect_fault("leaves the joint limits");
}

TEST_F(Check, AHandOutsideItsLimitsInEveryRow) {
  for (Segment& part : plan_.segments) {
    for (auto& q : part.positions) q[q.size() - 1] = 9;
  }
  expect_fault("leaves the joint limits");
}

TEST_F(Check, AnObjectThatMovesAlone) {
  segment("reach").object_poses[1].translation().x() += 0.001;
  expect_fault("moves though nothing slides it");
}

TEST_F(Check, AnObjectThatDoesNotFollow) {
  Segment& slide = segment("slide");
  slide.object_poses[slide.object_poses.size() / 2].translation().y() += 0.001;
  expect_fault("does not follow the contact");
}

TEST_F(Check, AnotherStart) {
  problem_.X_WO_start.translation().x() += 0.03;
  expect_fault("not at its start");
}

TEST_F(Check, AnObstacleInTheWay) {
  const Eigen::Vector3d p =
      problem_.robot.pose(problem_.robot.frame("grasp"), segment("reach").positions.back())
          .translation();
  problem_.obstacles = {{"post",
                         {{geometry::Box{{0.02, 0.02, 0.02}}, Eigen::Isometry3d::Identity()}},
                         Eigen::Isometry3d(Eigen::Translation3d(p + Eigen::Vector3d(0, 0, 0.04)))}};
  expect_fault("post");
}

TEST_F(Check, AnObstacleInTheObjectsWay) {
  const Segment& slide = segment("slide");
  const Eigen::Vector3d com_O = problem_.object.com();
  // Low enough for the arm to pass above it, at a far corner of where the object ends.
  const Eigen::Vector3d p =
      slide.object_poses.back() * Eigen::Vector3d(com_O.x() + 0.045, com_O.y() + 0.045, 0);
  problem_.obstacles = {{"coin",
                         {{geometry::Box{{0.004, 0.004, 0.004}}, Eigen::Isometry3d::Identity()}},
                         Eigen::Isometry3d(Eigen::Translation3d(p.x(), p.y(), 0.002))}};
  expect_fault("object - coin");
}

TEST_F(Check, ATighterBand) {
  Options options;
  options.min_depth = options.max_depth = 0.005;
  expect_fault("outside its band", options);
}

TEST_F(Check, ASmallerTable) {
  const auto& v = problem_.support.polygon().vertices();
  const Eigen::Vector2d middle = problem_.support.polygon().centroid();
  problem_.support =
      Support(geometry::Polygon((((v.colwise() - middle) * 0.7).colwise() + middle).eval()),
              problem_.support.X_WS());
  expect_fault("not far enough inside");
}

TEST_F(Check, ALargerOverhangAskedFor) {
  Options options;
  options.min_overhang = 0.06;
  const auto faults = check(problem_, plan_, options);
  ASSERT_FALSE(faults.empty());
  EXPECT_NE(faults.back().find("sticks out"), std::string::npos);
}

TEST_F(Check, ACenterOfMassOutside) {
  const Eigen::Vector3d out_O =
      plan_.X_WO_goal.linear().transpose() * -plan_.X_WH_grasp.linear().col(2) * 0.045;
  problem_.object = problem_.object.with_com(
      {std::clamp(out_O.x(), -.05, .05), std::clamp(out_O.y(), -.05, .05), 0.0025});
  expect_fault("centre of mass");
}

TEST_F(Check, AnotherGrasp) {
  plan_.X_WH_grasp.translation().x() += 0.01;
  expect_fault("does not end at X_WH_grasp");
}

TEST_F(Check, AHandThatNeverTouches) {
  Segment& close = segment("close");
  close.positions = {close.positions.front()};
  close.object_poses = {close.object_poses.front()};
  expect_fault("no finger touches");
}

// --- Faults that an earlier check() missed. ---

TEST_F(Check, AStartAMillimetreAside) {
  for (Segment& s : plan_.segments) {
    for (auto& X_WO : s.object_poses) X_WO.translation().x() += 0.001;
  }
  plan_.X_WO_goal.translation().x() += 0.001;
  expect_fault("not at its start");
}

TEST_F(Check, AnObjectSunkIntoTheTable) {
  for (Segment& s : plan_.segments) {
    for (auto& X_WO : s.object_poses) X_WO.translation().z() -= 0.001;
  }
  plan_.X_WO_goal.translation().z() -= 0.001;
  expect_fault("not at its start");
}

/// Moves the fingertip of the last row of a segment by X_FF, by inverse kinematics, and appends
/// that row and back.
void twitch(const Problem& problem, Segment& segment, const Eigen::Isometry3d& X_FF,
            std::size_t row) {
  const robot::Robot& robot = problem.robot;
  const int F = robot.frame(problem.hand.fingertip);
  const robot::Ik ik(robot, F, robot.group(problem.hand.arm));
  const Eigen::VectorXd q = segment.positions[row];
  const auto moved = ik.solve_near(robot.pose(F, q) * X_FF, q);
  ASSERT_TRUE(moved);
  std::vector<Eigen::VectorXd> there;
  for (int i = 1; i <= 20; ++i) there.push_back(q + (*moved - q) * i / 20);
  for (int i = 19; i >= 0; --i) there.push_back(q + (*moved - q) * i / 20);
  const auto at = static_cast<std::ptrdiff_t>(row) + 1;
  segment.positions.insert(segment.positions.begin() + at, there.begin(), there.end());
  segment.object_poses.insert(segment.object_poses.begin() + at, there.size(),
                              segment.object_poses[row]);
}

/// About the support's normal through the fingertip.
Eigen::Isometry3d yawed(const Problem& problem, const Eigen::VectorXd& q, double angle) {
  const Eigen::Isometry3d X_WF = problem.robot.pose(problem.robot.frame(problem.hand.fingertip), q);
  const Eigen::Vector3d up_F = X_WF.linear().transpose() * problem.support.normal_W();
  return Eigen::Isometry3d(Eigen::AngleAxisd(angle, up_F));
}

void turn(const Problem& problem, Segment& press) {
  const std::size_t last = press.positions.size() - 1;
  twitch(problem, press, yawed(problem, press.positions[last], 0.1), last);
}

void shift(const Problem& problem, Segment& lift) {
  twitch(problem, lift, Eigen::Isometry3d(Eigen::Translation3d(0.003, 0, 0)), 0);
}

TEST_F(Check, AFingerThatTurnsWhileItPresses) {
  turn(problem_, segment("press"));
  expect_fault("the contact turns");
}

TEST_F(Check, AFingerThatShiftsWhileItLifts) {
  shift(problem_, segment("lift"));
  expect_fault("the contact moves");
}

/// A plan with rigid fingers, which touch at depth 0.
class CheckOfRigidFingers : public Check {
 protected:
  CheckOfRigidFingers() {
    problem_.hand.finger_model = FingerModel::rigid_guarded;
    plan_ = plan(problem_, {}, seeded(1));
  }
};

TEST_F(CheckOfRigidFingers, ThatTurnWhileTheyPress) {
  EXPECT_TRUE(check(problem_, plan_).empty());
  turn(problem_, segment("press"));
  expect_fault("the contact turns");
}

TEST_F(CheckOfRigidFingers, ThatShiftWhileTheyLift) {
  shift(problem_, segment("lift"));
  expect_fault("the contact moves");
}

TEST_F(Check, ARowFarAway) {  // is not replayed in steps of 0.01 rad
  auto& rows = segment("approach").positions;
  rows[rows.size() / 2][0] = 1e9;
  expect_fault("leaves the joint limits");
}

TEST_F(Check, APressThatGoesTooDeep) {
  const Eigen::Vector3d down_W = -0.03 * problem_.support.normal_W();
  Segment& press = segment("press");
  const std::size_t last = press.positions.size() - 1;
  const Eigen::Isometry3d X_WF =
      problem_.robot.pose(problem_.robot.frame("left_fingertip"), press.positions[last]);
  twitch(problem_, press,
         Eigen::Isometry3d(Eigen::Translation3d(X_WF.linear().transpose() * down_W)), last);
  expect_fault("m deep");
}

TEST_F(Check, APitchARollAndATurnedFingerInTheSlide) {
  const Plan good = plan_;
  const std::size_t middle = segment("slide").positions.size() / 2;
  twitch(problem_, segment("slide"),
         Eigen::Isometry3d(Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX())), middle);
  expect_fault("pitch");
  plan_ = good;
  twitch(problem_, segment("slide"),
         Eigen::Isometry3d(Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitZ())), middle);
  expect_fault("roll");
}

TEST_F(Check, ACoarserPitchAtTheEnds) {
  Options options;
  options.pitch += 0.01;
  expect_fault("begins or ends at pitch", options);
}

TEST_F(Check, AWiderMarginOfTheTip) {
  Options options;
  options.tip_margin = 0.3;
  expect_fault("too near the edge", options);
}

TEST_F(Check, AContactBesideTheObject) {
  problem_.X_WO_start.translation().x() += 0.15;
  for (Segment& segment : plan_.segments) {
    for (Eigen::Isometry3d& X_WO : segment.object_poses) X_WO.translation().x() += 0.15;
  }
  expect_fault("the contact is not on the object");
}

TEST_F(Check, ASegmentThatBeginsElsewhere) {
  Segment& reach = segment("reach");
  reach.positions.erase(reach.positions.begin());
  reach.object_poses.erase(reach.object_poses.begin());
  expect_fault("does not continue");
}

TEST_F(Check, ALiftThatStaysLow) {
  Options options;
  options.lift_height = 0.12;
  expect_fault("above the object", options);
}

TEST_F(Check, AShorterStraightWay) {
  Options options;
  options.grasp_approach = 0.1;
  expect_fault("straight approach is only", options);
}

TEST_F(Check, AHandThatSwaysOnItsWay) {
  Segment& grasp = segment("grasp");
  const std::size_t middle = grasp.positions.size() / 2;
  grasp.positions[middle][6] += 0.04;
  expect_fault("does not approach in a straight line");
}

TEST_F(Check, OverhangsThatAreNotSo) {
  plan_.overhang += 0.01;
  expect_fault("overhang is not what");
  plan_.overhang = std::numeric_limits<double>::quiet_NaN();
  expect_fault("overhang is not what");
}

TEST_F(Check, AGoalThatIsNotWhereTheSlideEnds) {
  plan_.X_WO_goal.translation().y() += 0.001;
  expect_fault("X_WO_goal is not where");
}

TEST_F(Check, AGraspBesideTheMiddle) {
  problem_.object = Object::from_polygon("wider", geometry::square(.12), .005);  // another P_out
  expect_fault("not at the middle");
}

TEST_F(Check, AHalfClosedHandOnTheWay) {
  for (auto& q : segment("slide").positions) q[7] = 0.05;
  expect_fault("the hand is not open");
}

TEST_F(Check, AnArmThatMovesWhileTheHandCloses) {
  auto& rows = segment("close").positions;
  rows[rows.size() / 2][0] += 0.01;
  expect_fault("the hand alone");
}

TEST_F(Check, AHandThatClosesOn) {
  Segment& close = segment("close");
  Eigen::VectorXd closed = close.positions.back();
  closed[7] = problem_.robot.state("closed")[7];
  close.positions.push_back(closed);
  close.object_poses.push_back(close.object_poses.back());
  expect_fault("closes further");
}

TEST_F(Check, MissingObjectPosesAreAFaultNotACrash) {
  segment("lift").object_poses.clear();
  expect_fault("one object pose for each");
}

TEST_F(Check, ALinkWithoutShapesAmongTheFingersIsNone) {
  problem_.hand.sliding_finger.push_back("left_fingertip");
  problem_.hand.fingers.push_back("right_fingertip");
  EXPECT_TRUE(check(problem_, plan_).empty());
}

TEST_F(Check, TheOtherFingerModel) {
  // The paper's formula, on a plan made for a flexing finger.
  problem_.hand.finger_model = FingerModel::impedance;
  problem_.hand.wrist_stiffness = 400;
  expect_fault("does not follow the contact");
}

/// A hook over an edge, whose parts the rows of its points meet one by one.
TEST_F(Check, AgreesWithTheSearchOnWhatSticksOut) {
  const auto hook = columns({{-.08, -.08},
                             {.12, -.08},
                             {.12, .07},
                             {.02, .07},
                             {.02, -.05},
                             {-.03, -.05},
                             {-.03, -.02},
                             {-.05, -.02},
                             {-.05, .07},
                             {-.08, .07},
                             {-.08, -.03},
                             {-.05, -.03},
                             {-.05, -.05},
                             {-.08, -.05}});
  problem_.object = Object::from_polygon("hook", geometry::Polygon(hook), .005);
  Options options;
  options.deep_grasp = false;
  const geometry::Polygon::Edge edge = problem_.support.polygon().edge(0);
  const double inwards = std::atan2(edge.inward.y(), edge.inward.x());
  std::mt19937_64 rng(1);
  std::uniform_real_distribution<double> in(-.03, .03), yaw(inwards - .3, inwards + .3);
  for (int k = 0; k < 100; ++k) {
    Planar object_S(Eigen::Rotation2Dd(yaw(rng)));
    object_S.translation() = (edge.a + edge.b) / 2 + in(rng)*edge.inward;
    const Placement place = placement(problem_, options, object_S);
    plan_.X_WO_goal = problem_.support.X_WS() * spatial(object_S);
    plan_.X_WH_grasp = grasp_pose(problem_, place, 0);
    plan_.overhang = place.overhang;
    for (const std::string& fault : check(problem_, plan_, options)) {
      EXPECT_EQ(fault.find("grasp: the hand"), std::string::npos) << k << ": " << fault;
      EXPECT_EQ(fault.find("the overhang is"), std::string::npos) << k << ": " << fault;
    }
  }
}

}  // namespace
}  // namespace graspless::slide
