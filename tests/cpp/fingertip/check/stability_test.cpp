// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/check/stability.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "graspless/mechanics/contact.hpp"

namespace graspless::fingertip::checking {
namespace {

using Eigen::Vector3d;
using mechanics::FingerMode;

/// A linear program for each direction.
double oracle(const Instant& instant, const mechanics::Matrix6Xd& directions) {
  double z = mechanics::kInfinity;
  for (Eigen::Index d = 0; d < directions.cols(); ++d) {
    mechanics::LinearProgram lp = balance(instant);
    lp.set_block(0, 0, directions.col(d));
    const mechanics::LpSolution found = mechanics::solve_lp(lp);
    if (found.status == mechanics::LpStatus::infeasible) return 0;
    z = std::min(z, found.objective);
  }
  return z;
}

/// A cube of 0.1 m and 0.3 kg on a floor, between fingers on opposite sides.
Instant cube(double height, double along, std::size_t fingers, FingerMode last) {
  Instant instant;
  for (const double x : {-0.05, 0.05}) {
    for (const double y : {-0.05, 0.05})
      instant.set.contacts.push_back({Vector3d(x, y, -0.05), Vector3d::UnitZ(), 0.4});
  }
  for (std::size_t j = 0; j < fingers; ++j) {
    const double side = j % 2 == 0 ? -1 : 1;
    mechanics::Finger finger;
    finger.p_OC = {0.05 * side, along + 0.02 * static_cast<double>(j / 2), height};
    finger.n_O = -side * Vector3d::UnitX();
    finger.friction = 0.6;
    finger.max_normal_force = 8;
    instant.set.fingers.push_back(finger);
    instant.modes.push_back(j + 1 == fingers ? last : FingerMode::position);
  }
  instant.set.known_wrench_O.head<3>() = Vector3d(0, 0, -3);
  instant.set.wrench_scale.bottomRightCorner<3, 3>() *= 20;
  instant.commanded_forces = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(fingers), 2);
  return instant;
}

TEST(Stabilities, AreThoseOfALinearProgramForEachDirection) {
  const mechanics::Matrix6Xd directions = mechanics::disturbance_directions();
  Stabilities stabilities(directions);
  std::mt19937_64 rng(7);
  std::uniform_real_distribution<double> side(-1, 1);
  int held = 0;
  double height = 0, along = 0;
  for (int sample = 0; sample < 60; ++sample) {
    // Small steps, now and then a jump, another number of fingers, or another mode of the last one.
    const bool jumps = sample % 7 == 0;
    height = jumps ? 0.045 * side(rng) : std::clamp(height + 0.002 * side(rng), -0.045, 0.045);
    along = jumps ? 0.02 * side(rng) : std::clamp(along + 0.002 * side(rng), -0.02, 0.02);
    const std::size_t fingers = sample % 20 < 10 ? 2 : 3;
    const FingerMode last = sample % 15 < 8 ? FingerMode::position : FingerMode::force;
    const Instant instant = cube(height, along, fingers, last);
    const double expected = oracle(instant, directions);
    EXPECT_NEAR(stabilities.least(instant), expected, 1e-8 * std::max(1.0, expected));
    held += expected > 0;
  }
  EXPECT_GT(held, 30);
}

TEST(Stabilities, AreZeroWithoutAnEquilibrium) {
  Stabilities stabilities(mechanics::disturbance_directions());
  EXPECT_GT(stabilities.least(cube(0, 0, 2, FingerMode::position)), 0);
  Instant lifted = cube(0, 0, 2, FingerMode::position);
  lifted.set.known_wrench_O.head<3>() = Vector3d(0, 0, 100);
  EXPECT_EQ(stabilities.least(lifted), 0);
  EXPECT_GT(stabilities.least(cube(0, 0, 2, FingerMode::position)), 0);
}

}  // namespace
}  // namespace graspless::fingertip::checking
