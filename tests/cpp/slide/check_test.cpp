// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check() must see every way in which a plan can lie: each test breaks one promise of a good plan.
#include <gtest/gtest.h>

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
  void expect_fault(const std::string& words) {
    std::string all;
    for (const std::string& fault : check(problem_, plan_)) all += fault + "\n";
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

TEST_F(Check, OtherJoints) {
  std::swap(plan_.joint_names[0], plan_.joint_names[1]);
  expect_fault("joint names");
}

TEST_F(Check, AValueThatIsNotFinite) {
  segment("reach").positions[0][2] = std::numeric_limits<double>::quiet_NaN();
  expect_fault("not finite");
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
  options.max_depth = options.min_depth;
  std::string all;
  for (const std::string& fault : check(problem_, plan_, options)) all += fault + "\n";
  EXPECT_NE(all.find("out of its band"), std::string::npos) << all;
}

TEST_F(Check, ASmallerTable) {
  const auto& v = problem_.support.polygon().vertices();
  const Eigen::Vector2d middle = problem_.support.polygon().centroid();
  problem_.support =
      Support(geometry::Polygon((((v.colwise() - middle) * 0.7).colwise() + middle).eval()),
              problem_.support.X_WS());
  expect_fault("slide row");
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

TEST_F(Check, TheOtherFingerModel) {
  problem_.hand.finger_model =
      FingerModel::none;  // the paper's formula, on a plan made for a flexing finger
  expect_fault("does not follow the contact");
}

}  // namespace
}  // namespace graspless::slide
