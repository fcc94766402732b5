// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/certificate.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "clasp/certificate/core.hpp"
#include "clasp/certificate/frame_hand.hpp"
#include "clasp/certificate/still_hand.hpp"
#include "clasp/certificate/way_out.hpp"
#include "complaint.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;

constexpr double kThick = 0.016;  // of the ring [m]

Certificate certificate_of(const Problem& problem, const CertificateOptions& options = {}) {
  return certificate(problem, problem.q_start, 0, options);
}

CertificateOptions without_search() {
  CertificateOptions options;
  options.moves = 0;
  return options;
}

/// The ring moves straight up through the gap: half of what the gap is wider than the ring is left
/// on either side. Its polygons are a little thinner than the torus.
TEST(Certificate, HoldsWhatAGapOfKnownWidthLeaves) {
  for (const double gap : {0.008, 0.012, 0.015, 0.018, 0.024}) {
    const Certificate found = certificate_of(frame_problem(gap));
    const double torus = (gap - kThick) / 2;
    const double polygons = (gap - kThick * std::cos(M_PI / 12)) / 2;
    EXPECT_NEAR(found.gap, gap, 1e-6);
    EXPECT_GE(found.upper, torus) << gap;
    EXPECT_LE(found.upper, polygons + 5e-4) << gap;
    EXPECT_LE(found.lower, polygons) << gap;
    EXPECT_LE(found.upper - found.lower, 0.002 + 1e-9) << gap;
    EXPECT_EQ(found.caged, found.upper < 0) << gap;
    const auto& [first, second] = found.between;
    EXPECT_TRUE((first == "left" && second == "right") || (first == "right" && second == "left"));
  }
}

TEST(Certificate, ShrinksWithTheGap) {
  double before = kUnlinked;
  for (double gap = 0.03; gap > 0.007; gap -= 0.003) {  // the tips' balls bound what is less
    const double upper = certificate_of(frame_problem(gap), without_search()).upper;
    EXPECT_LT(upper, before) << gap;
    before = upper;
  }
}

/// A thicker ring needs a wider gap.
TEST(Certificate, ShrinksWithTheObjectsThickness) {
  double before = kUnlinked;
  for (const double thickness : {0.008, 0.012, 0.016, 0.024}) {
    const Certificate found = certificate_of(frame_problem(0.014, thickness), without_search());
    EXPECT_LT(found.upper, before) << thickness;
    EXPECT_NEAR(found.thickness, thickness, 0.08 * thickness);
    before = found.upper;
  }
}

TEST(Certificate, WhereHandAndObjectStandTogetherDoesNotMatter) {
  Problem problem = frame_problem(0.013);
  const Certificate here = certificate_of(problem);
  for (const int joint : problem.robot.group("arm")) problem.q_start[joint] += 0.1 * (joint + 1);
  const auto palm = [&](const Eigen::VectorXd& q) {
    return problem.robot.pose(problem.robot.frame("palm"), q);
  };
  problem.X_WO =
      palm(problem.q_start) * palm(frame_problem(0.013).q_start).inverse() * problem.X_WO;
  const Certificate there = certificate_of(problem);
  EXPECT_NEAR(there.upper, here.upper, 1e-9);
  EXPECT_NEAR(there.thickness, here.thickness, 1e-9);
  EXPECT_LE(there.upper - there.lower, 0.002 + 1e-9);
}

/// A ring beside the frame, and one that the frame's plane does not meet.
TEST(Certificate, AHandThatIsNotLinkedCagesNothing) {
  for (const Vector3d& aside : {Vector3d(0, 0, 0.1), Vector3d(0.2, 0, 0), Vector3d(0, 0.3, 0)}) {
    Problem problem = frame_problem(0);
    problem.X_WO.translation() += aside;
    const Certificate found = certificate_of(problem);
    EXPECT_FALSE(found.caged);
    EXPECT_EQ(found.upper, kUnlinked);
    EXPECT_EQ(found.between[0], "");
  }
}

TEST(Certificate, SameSeedSameCertificate) {
  const Problem problem = frame_problem(0.018);
  const Certificate first = certificate_of(problem), again = certificate_of(problem);
  EXPECT_EQ(first.lower, again.lower);
  EXPECT_EQ(first.moves, again.moves);
}

TEST(Certificate, RefusesNonsense) {
  const Problem problem = frame_problem(0.01);
  CertificateOptions options;
  const auto run = [&](int loop) { certificate(problem, problem.q_start, loop, options); };
  expect_refused([&] { run(1); }, "loop must be the index of one of the 1 loops of object 'ring'");
  expect_refused([&] { run(-1); }, "loop");
  expect_refused([&] { certificate(problem, Eigen::VectorXd::Zero(2), 0); }, "q");
  options.tolerance = 0;
  expect_refused([&] { run(0); }, "certificate.tolerance must lie in [0.0001, 0.1] m, not 0");
  options = {};
  options.moves = -1;
  expect_refused([&] { run(0); }, "certificate.moves must lie in [0, 100000], not -1");
}

/// No motion that a search finds at a clearance above the upper bound leaves the hand; moves at the
/// rim of the bound come as near as the interval says.
TEST(WayOut, FindsNoWayAboveTheBound) {
  for (const double gap : {0.012, 0.02}) {
    const Problem problem = frame_problem(gap);
    const Certificate found = certificate_of(problem, without_search());
    const StillHand hand(problem, problem.q_start);
    const Core& core = problem.object.core();
    const std::vector<int> near = hand.balls_outside(core);
    const CoreLoop loop =
        core.loop(hand.ring(problem.object.loops().found[0].points, 0, near).points_O);
    const HandRing ring = hand.ring(loop.points, loop.radius, near);
    collision::Clearance clearance = problem.object.outer_clearance();
    WayOut search(hand, ring, loop.points, clearance, 3);
    EXPECT_FALSE(search.exists(found.upper + 1e-4, 3000)) << gap;
    EXPECT_TRUE(search.exists(found.upper - 0.003, 3000)) << gap;
  }
}

}  // namespace
}  // namespace graspless::clasp
