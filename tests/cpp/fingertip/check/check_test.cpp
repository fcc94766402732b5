// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check() must see every way in which a plan can lie: each test breaks one promise of a good plan.
// Here what the plan says of itself, where the object goes and where the fingers are.
#include "fingertip/check/hand_made.hpp"

namespace graspless::fingertip {
namespace {

TEST_F(FingertipCheck, AGoodPlanHolds) { EXPECT_EQ(faults(problem_, plan_, options_), ""); }

TEST_F(FingertipCheck, AGoodPlanWithARegraspHolds) {
  EXPECT_EQ(faults(problem_, with_regrasp(), options_), "");
}

TEST_F(FingertipCheck, APlanThatWasNotFound) {
  plan_.status = Status::unstable;
  expect_fault("not solved");
}

TEST_F(FingertipCheck, NoSegments) {
  plan_.segments.clear();
  expect_fault("has no segments");
}

TEST_F(FingertipCheck, AMissingRow) {
  plan_.segments[0].rows.pop_back();
  expect_fault("segment 0 (slide): has 5 rows, not 6");
}

TEST_F(FingertipCheck, AMissingFinger) {
  row(1).fingers.pop_back();
  expect_fault("segment 0 (slide), row 1: has 1 fingers, not 2");
}

TEST_F(FingertipCheck, AValueThatIsNotFinite) {
  row(3).fingers[1].nominal_force_O.y() = std::numeric_limits<double>::quiet_NaN();
  expect_fault("row 3: has a value that is not finite");
}

TEST_F(FingertipCheck, APoseThatIsNotRigid) {
  plan_.segments[0].X_WO[1].linear() *= 1.01;
  expect_fault("pose 1 is not rigid");
}

TEST_F(FingertipCheck, AnotherMotion) {
  plan_.segments[0].X_WO[1].translation().x() += 0.001;
  expect_fault("pose 1 is not the path's");
}

TEST_F(FingertipCheck, AShorterMotion) {
  plan_.segments[0].X_WO.pop_back();
  plan_.segments[0].rows.resize(3);
  expect_fault("passes 2 poses, not the path's 3");
}

TEST_F(FingertipCheck, ARowOffTheMotion) {
  row(4).X_WO.translation().x() += 0.001;
  expect_fault("row 4: pose: not where the motion has the object");
}

TEST_F(FingertipCheck, AGapBetweenSegments) {
  plan_ = with_regrasp();
  plan_.segments[2].X_WO[0].translation().x() += 0.001;
  expect_fault("segment 2 (slide): does not begin where the last one ended");
}

TEST_F(FingertipCheck, AContactOffTheSurface) {
  for (Row& r : plan_.segments[0].rows) r.fingers[0].p_OC.z() += 0.01;
  expect_fault("finger 0: contact: not on the object's surface");
}

TEST_F(FingertipCheck, AnotherNormal) {
  for (Row& r : plan_.segments[0].rows) r.fingers[0].n_O *= -1;
  expect_fault("finger 0: contact: not on the object's surface");
}

TEST_F(FingertipCheck, AFingerThatSlips) {
  row(2).fingers[1].p_OC.y() += 0.01;
  expect_fault("row 2: finger 1 has moved without a regrasp");
}

TEST_F(FingertipCheck, SwappedFingers) {
  plan_ = with_regrasp();
  for (Row& r : plan_.segments[2].rows) std::swap(r.fingers[0], r.fingers[1]);
  expect_fault("segment 2 (slide), row 0: finger 0 has moved without a regrasp");
}

TEST_F(FingertipCheck, ASkippedRegrasp) {
  plan_ = with_regrasp();
  plan_.segments.erase(plan_.segments.begin() + 1);
  plan_.regrasps = 0;
  plan_.cost -= options_.regrasp_cost;
  expect_fault("segment 1 (slide), row 0: finger 1 has moved without a regrasp");
}

TEST_F(FingertipCheck, TheWrongFingerRegrasps) {
  plan_ = with_regrasp();
  plan_.segments[1].finger = 0;
  expect_fault("segment 1 (regrasp), row 0: finger 0 touches while it regrasps");
}

TEST_F(FingertipCheck, AFingerInTheAir) {
  row(2).fingers[0].touches = false;
  expect_fault("row 2: finger 0 does not touch");
}

TEST_F(FingertipCheck, ARegraspAtTheEnd) {
  plan_ = with_regrasp();
  plan_.segments.pop_back();
  expect_fault("a plan begins and ends with all fingers on the object");
}

TEST_F(FingertipCheck, AnotherName) {
  plan_.segments[0].name = "turn";
  expect_fault("segment 0 (turn): is no turn after pose 0");
  plan_.segments[0].name = "tumble";
  expect_fault("segment 0 (tumble): is no tumble after pose 0");
}

TEST_F(FingertipCheck, FingersThatOverlapBetweenTwoRegrasps) {
  // Finger 0 moves beside where finger 1 still is; then finger 1 moves away.
  plan_ = with_regrasp();
  Segment first = plan_.segments[1], second = first;
  first.finger = 0;
  first.rows[0].fingers[0].touches = false;
  first.rows[0].fingers[1].touches = true;
  second.rows[0].fingers[0] = behind(0.2, 0);
  plan_.segments[1] = first;
  plan_.segments.insert(plan_.segments.begin() + 2, second);
  expect_fault("segment 2 (regrasp), before it: finger 1 overlaps finger 0");
}

TEST_F(FingertipCheck, AFingerThatRegraspsTwiceOnEnd) {
  plan_ = with_regrasp();
  plan_.segments.insert(plan_.segments.begin() + 1, Segment(plan_.segments[1]));
  expect_fault("segment 2 (regrasp), before it: finger 1 regrasps twice on end");
}

TEST_F(FingertipCheck, AFingertipInAWall) {
  problem_.planes.push_back({"wall", {1, 0, 0}, -4.4});
  expect_fault("segment 0 (slide), pose 0: finger 1 reaches 0.1 m into plane 'wall'");
}

TEST_F(FingertipCheck, AFingertipInAnObstacle) {
  problem_.obstacles = {{"shelf",
                         {{geometry::Box{{0.5, 0.5, 0.5}}, Eigen::Isometry3d::Identity()}},
                         Eigen::Isometry3d(Eigen::Translation3d(1.0, 0, 7.1))}};
  expect_fault("segment 0 (slide), pose 2: finger 0 touches obstacle 'shelf'");
  expect_fault("segment 0 (slide), row 5: finger 0 touches obstacle 'shelf'");
}

// The problem's own motion is clear, or validate() would refuse it; the plan's goes too far.
TEST_F(FingertipCheck, AnObstacleInTheObjectsWay) {
  problem_.obstacles = {{"stone",
                         {{geometry::Box{{0.2, 0.2, 0.2}}, Eigen::Isometry3d::Identity()}},
                         Eigen::Isometry3d(Eigen::Translation3d(4.2, 4, 0.1))}};
  plan_.segments[0].X_WO[1].translation().x() = 2;
  expect_fault("segment 0 (slide), pose 1: obstacle 'stone' touches the object");
  expect_fault("segment 0 (slide), row 3: obstacle 'stone' touches the object");
}

TEST_F(FingertipCheck, FingertipsThatOverlap) {
  for (Row& r : plan_.segments[0].rows) {
    r.fingers[0].p_OC.x() = -2.4;
    r.fingers[1].p_OC.z() = 2.4;
  }
  expect_fault("finger 1 overlaps finger 0");
}

TEST_F(FingertipCheck, FingertipsFartherApartThanAHandOpens) {
  problem_.fingers.max_span = 3;
  expect_fault(
      "segment 0 (slide), pose 0: finger 1 is 4.94975 m from finger 0, more than fingers.max_span");
}

TEST_F(FingertipCheck, AWallInTheObjectsWay) {
  problem_.planes.push_back({"wall", {-1, 0, 0}, -4});
  plan_.segments[0].X_WO[1].translation().x() = 2;
  expect_fault("segment 0 (slide), row 2: contacts: the vertex at");
  expect_fault("inside plane 'wall'");
}

TEST_F(FingertipCheck, AnotherCost) {
  plan_.cost *= 1 + 1e-7;
  expect_fault("plan: cost: ");
}

TEST_F(FingertipCheck, ALowerBoundAboveTheCost) {
  plan_.lower_bound *= 1.001;
  expect_fault("plan: lower bound ");
}

TEST_F(FingertipCheck, AnotherNumberOfRegrasps) {
  plan_.regrasps = 1;
  expect_fault("says 1 regrasps, has 0");
}

TEST_F(FingertipCheck, AnotherWeakestRow) {
  plan_ = with_regrasp();
  const bool first = plan_.weakest_segment == 0;
  plan_.weakest_segment = first ? 1 : 0;
  plan_.weakest_row = 0;
  expect_fault("is not the weakest");
}

TEST_F(FingertipCheck, AStepThatIsTooLong) {
  problem_.motion = Goal{X_WO_.front(), X_WO_.back(), 0.4, 0.1, 0};
  expect_fault("the step to pose 1 turns by ");
}

TEST_F(FingertipCheck, SmallStepsToAGoal) {
  problem_.motion = Goal{X_WO_.front(), X_WO_.back(), 0.5, 0.1, 0};
  EXPECT_EQ(faults(problem_, plan_, options_), "");
}

TEST_F(FingertipCheck, StepsOnALattice) {
  problem_.motion = Lattice{X_WO_.front(), X_WO_.back(), {0, -1, -1}, {1, 1, 1}, {3, 3, 3}};
  EXPECT_EQ(faults(problem_, plan_, options_), "");
}

TEST_F(FingertipCheck, AStepOverALatticesPose) {
  problem_.motion = Lattice{X_WO_.front(), X_WO_.back(), {0, -1, -1}, {1, 1, 1}, {5, 3, 3}};
  expect_fault("pose 1 is no neighbour of the one before");
}

TEST_F(FingertipCheck, APoseBetweenALatticesPoses) {
  problem_.motion = Lattice{X_WO_.front(), X_WO_.back(), {0, -1, -1}, {1, 1, 1}, {4, 3, 3}};
  expect_fault("pose 1 is not on the lattice");
}

}  // namespace
}  // namespace graspless::fingertip
