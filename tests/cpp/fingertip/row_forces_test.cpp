// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/row_forces.hpp"

#include <gtest/gtest.h>

#include "graspless/watch.hpp"

#include "fingertip/cases.hpp"
#include "fingertip/model/evaluator.hpp"

namespace graspless::fingertip {
namespace {

/// The first rows of case b's slide with two fingers behind the cuboid.
std::vector<RowContacts> some_rows(int count) {
  std::vector<RowContacts> rows;
  mechanics::ContactSet set;
  set.known_wrench_O << 0, 0, -9.8, 0, 0, 0;
  for (const double x : {-2.5, 2.5}) {
    for (const double y : {-5.0, 5.0}) {
      mechanics::Contact contact;
      contact.p_OC = {x, y, -2.5};
      contact.n_O = Eigen::Vector3d::UnitZ();
      contact.friction = 0.5;
      contact.mode = mechanics::ContactMode::slide;
      contact.t_O = Eigen::Vector3d::UnitX();
      set.contacts.push_back(contact);
    }
  }
  for (int i = 0; i < count; ++i) {
    RowContacts row{set, {}};
    for (const double y : {-2.0, 2.0 + 0.1 * i}) {
      row.set.fingers.push_back(
          {{-2.5, y, 0}, Eigen::Vector3d::UnitX(), 0.7, 10, Eigen::Vector3d::UnitY()});
    }
    row.best.modes = {FingerMode::position, FingerMode::position};
    row.best.stability.commanded_forces = Eigen::VectorXd::Zero(2);
    rows.push_back(row);
  }
  return rows;
}

mechanics::Yield yield() { return {Object::box("cuboid", {5, 10, 5}, 1).hull(), 1e-3}; }

TEST(FingertipRowForces, AreThoseOfOneThread) {
  const std::vector<RowContacts> rows = some_rows(20);
  Options options;
  const std::vector<RowForces> once = forces_of(rows, options, yield());
  for (const int threads : {2, 3, 64}) {
    options.threads = threads;
    const std::vector<RowForces> again = forces_of(rows, options, yield());
    ASSERT_EQ(again.size(), once.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
      ASSERT_TRUE(once[i].nominal && again[i].nominal) << i;
      EXPECT_EQ(again[i].nominal->finger_forces_O, once[i].nominal->finger_forces_O) << i;
      EXPECT_EQ(again[i].compliant_stability, once[i].compliant_stability) << i;
      EXPECT_EQ(again[i].promise.withstands, once[i].promise.withstands) << i;
    }
  }
}

TEST(FingertipRowForces, StopEndsAllThreads) {
  Options options;
  options.threads = 3;
  const Watch watch([] { throw Stop{}; });
  EXPECT_THROW(forces_of(some_rows(2000), options, yield()), Stop);
}

TEST(FingertipRowForces, NoRowsNoForces) { EXPECT_TRUE(forces_of({}, {}, yield()).empty()); }

}  // namespace
}  // namespace graspless::fingertip
