// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check() must see every way in which a plan can lie: here about what holds the object.
#include "fingertip/check/hand_made.hpp"

namespace graspless::fingertip {
namespace {

TEST_F(FingertipCheck, AnObjectThatDropsWhileAFingerRegrasps) {
  // One finger on a pile of weights: no disturbance is left that it withstands.
  plan_ = with_regrasp();
  options_.min_stability = row(0, 1).stability + 0.1;
  expect_fault("segment 1 (regrasp), row 0: stability: ");
}

TEST_F(FingertipCheck, OtherModes) {
  const std::size_t i = force_finger(1);
  row(1).fingers[i].mode = FingerMode::position;
  row(1).fingers[i].commanded_force = 0;
  expect_fault("row 1: modes: the fingers can jam the object");
}

TEST_F(FingertipCheck, ACommandedForceBeyondTheLimit) {
  row(1).fingers[force_finger(1)].commanded_force = 10.1;
  expect_fault("commanded force 10.1 N is not within 0 and 10");
}

TEST_F(FingertipCheck, ACommandedForceInPositionControl) {
  row(1).fingers[1 - force_finger(1)].commanded_force = 1;
  expect_fault("commanded force 1 N is not within 0 and 0");
}

TEST_F(FingertipCheck, AnotherCommandedForce) {
  row(1).fingers[force_finger(1)].commanded_force *= 0.9;
  expect_fault("row 1: stability: ");
  expect_fault("N along the normal, commanded");
}

TEST_F(FingertipCheck, APromiseOfMoreStability) {
  row(5).stability *= 1 + 1e-5;
  expect_fault("row 5: stability: ");
}

TEST_F(FingertipCheck, LessThanIsNeeded) {
  options_.min_stability = row(0).stability * 1.01;
  expect_fault("(needed ");
}

TEST_F(FingertipCheck, APromiseOfMoreCompliantStability) {
  row(5).compliant_stability += 0.01;
  expect_fault("row 5: compliant stability: ");
}

TEST_F(FingertipCheck, APromiseToWithstandMore) {
  ASSERT_GT(row(5).withstands, 0.1);
  row(5).withstands *= 1.001;
  expect_fault("row 5: withstands: ");
}

TEST_F(FingertipCheck, APlanThatPromisesToWithstandMoreThanItsRows) {
  plan_.withstands *= 1.001;
  expect_fault("plan: withstands: ");
}

TEST_F(FingertipCheck, APromiseOfMorePlaceTolerance) {
  ASSERT_GT(row(5).place_tolerance, 1e-6);
  row(5).place_tolerance *= 1.001;
  expect_fault("row 5: place tolerance: ");
}

TEST_F(FingertipCheck, APlanThatPromisesMorePlaceToleranceThanItsRows) {
  plan_.place_tolerance *= 1.001;
  expect_fault("plan: place tolerance: ");
}

TEST_F(FingertipCheck, OtherFingersOrToleranceThanPlanned) {
  const std::string fault = "row 1: withstands: ";
  const Options planned = options_;
  options_.compliance.finger_tangential /= 10;
  expect_fault(fault);
  options_ = planned;
  options_.max_yield = 1e-6;
  expect_fault(fault);
}

TEST_F(FingertipCheck, WhatARegraspWithstands) {
  plan_ = with_regrasp();
  EXPECT_EQ(faults(problem_, plan_, options_), "");
  row(0, 1).withstands += 0.01;
  expect_fault("segment 1 (regrasp), row 0: withstands: ");
}

TEST_F(FingertipCheck, NominalForcesOutOfBalance) {
  row(2).fingers[1].nominal_force_O.y() += 0.01;
  row(2).fingers[0].nominal_force_O.x() -= 0.01;
  expect_fault("row 2: nominal forces: ");
}

TEST_F(FingertipCheck, NominalForcesOutOfTheirCones) {
  for (FingerState& finger : row(2).fingers) {
    finger.nominal_force_O -= finger.nominal_force_O.dot(finger.n_O) * 1.2 * finger.n_O;
  }
  expect_fault("row 2: nominal forces: ");
}

TEST_F(FingertipCheck, APromiseOfMoreMargin) {
  row(2).nominal_margin += 0.001;
  expect_fault("row 2: nominal margin: ");
}

TEST_F(FingertipCheck, FrictionThatMayBeLess) {
  problem_.friction = {0.5, 20};
  expect_fault("friction: fails at ");
}

}  // namespace
}  // namespace graspless::fingertip
