// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/fingertip/resume.hpp"

#include <random>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "fingertip/cases.hpp"
#include "fingertip/instance.hpp"

namespace graspless::fingertip {
namespace {

using Points = std::vector<Eigen::Vector3d>;

Options five_a_side(Search search = Search::fast) {
  Options options;
  options.locations_per_side = 5;
  options.search = search;
  return options;
}

Points places(const Row& row) {
  Points places;
  for (const FingerState& finger : row.fingers) places.push_back(finger.p_OC);
  return places;
}

void expect_start(const Plan& plan, const Points& start) {
  const Points found = places(plan.segments.front().rows.front());
  ASSERT_EQ(found.size(), start.size());
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_LE((found[i] - start[i]).norm(), kStartTolerance) << i;
  }
}

TEST(FingersStart, IsKeptByEveryEngineAtTheSameCost) {
  std::mt19937_64 rng(1);
  Problem problem = slide_case(10, 6);
  const Locations all(problem.object, problem.fingers, five_a_side());
  int solved = 0;
  for (int trial = 0; trial < 12; ++trial) {
    std::uniform_int_distribution<int> any(0, all.size() - 1);
    const int a = any(rng), b = any(rng);
    if (a == b || !all.are_apart(a, b)) continue;
    problem.fingers.start = {all[a].p_OC, all[b].p_OC};
    const Plan fast = plan(problem, five_a_side());
    const Plan slow = plan(problem, five_a_side(Search::dijkstra));
    ASSERT_EQ(fast.status, slow.status);
    if (!fast) continue;
    ++solved;
    EXPECT_NEAR(fast.cost, slow.cost, 1e-9 * slow.cost);
    for (const Plan* found : {&fast, &slow}) {
      expect_start(*found, problem.fingers.start);
      EXPECT_EQ(check(problem, *found, five_a_side()), std::vector<std::string>{});
    }
  }
  EXPECT_GE(solved, 2);
}

TEST(FingersStart, MayLieBetweenTheLocations) {
  Problem problem = slide_case(10, 6);
  const Plan free = plan(problem, five_a_side());
  ASSERT_TRUE(free);
  problem.fingers.start = places(free.segments.front().rows.front());
  EXPECT_NEAR(plan(problem, five_a_side()).cost, free.cost, 1e-9 * free.cost);
  for (Eigen::Vector3d& p : problem.fingers.start) p.y() += 0.123;
  const Plan moved = plan(problem, five_a_side());
  ASSERT_TRUE(moved) << moved.reason;
  expect_start(moved, problem.fingers.start);
  EXPECT_EQ(check(problem, moved, five_a_side()), std::vector<std::string>{});
  EXPECT_FALSE(check(problem, free, five_a_side()).empty());  // it starts elsewhere
}

TEST(FingersStart, IsKeptInALattice) {
  Problem problem = lattice_problem();
  const Plan free = plan(problem, five_a_side());
  ASSERT_TRUE(free) << free.reason;
  problem.fingers.start = places(free.segments.front().rows.front());
  const Plan again = plan(problem, five_a_side());
  ASSERT_TRUE(again) << again.reason;
  expect_start(again, problem.fingers.start);
  EXPECT_LE(again.cost, free.cost * (1 + 1e-9));
}

TEST(FingersStart, IsRefusedWhereNoFingerCanBe) {
  const auto expect_fault = [](const Points& start, const std::string& words,
                               const Motion& motion = slide_case(10, 6).motion) {
    Problem problem = slide_case(10, 6);
    problem.motion = motion;
    problem.fingers.start = start;
    expect_refused([&] { validate(problem); }, words);
  };
  const Eigen::Vector3d left(0, -5, 0), right(0, 5, 0);
  expect_fault({left}, "fingers.start must hold a place for each of 2");
  expect_fault({left, {0, 4, 0}}, "fingers.start[1] must lie on");
  expect_fault({left, {0, NAN, 0}}, "fingers.start[1] must be finite");
  expect_fault({left, {0.1, -5, 0}}, "fingers.start[1] must be two radii");
  expect_fault({left, right}, "not a Goal", Goal{at(0, 0, 2.5), at(9, 0, 2.5)});
}

TEST(FingersStart, OnTheFloorIsAReason) {
  Problem problem = slide_case(10, 6);
  problem.fingers.start = {{0, -5, -2}, {0, 5, 0}};  // half a unit above the floor
  const Plan refused = plan(problem, five_a_side());
  EXPECT_EQ(refused.status, Status::no_location);
  EXPECT_NE(refused.reason.find("fingers.start[0]"), std::string::npos) << refused.reason;
}

TEST(Resume, GoesOnFromEveryPoseOfAPlanAtNoMoreThanItsCost) {
  for (const bool has_side_wall : {false, true}) {
    const Problem problem = tumble_case(has_side_wall, 8);
    const Plan whole = plan(problem, five_a_side());
    ASSERT_TRUE(whole) << whole.reason;
    for (std::size_t s = 0; s < whole.segments.size(); ++s) {
      const Segment& segment = whole.segments[s];
      for (std::size_t k = 0; k + 1 < segment.X_WO.size(); k += 2) {
        const Rest rest =
            resume(problem, whole, static_cast<int>(s), segment.X_WO[k], five_a_side());
        ASSERT_TRUE(rest.plan) << segment.name << " " << k << ": " << rest.plan.reason;
        EXPECT_LE(rest.plan.cost, whole.cost * (1 + 1e-9));
        EXPECT_EQ(check(rest.problem, rest.plan, five_a_side()), std::vector<std::string>{});
        expect_start(rest.plan, places(segment.rows.front()));
        EXPECT_TRUE(rest.plan.segments.back().X_WO.back().isApprox(
            whole.segments.back().X_WO.back(), 1e-9));
      }
    }
  }
}

/// A block of 5 cm that slides by 10 cm.
Problem small_slide() {
  const Eigen::Isometry3d X_WO = at(0, 0, 0.025);
  Fingers fingers;
  return {Object::box("block", {0.05, 0.1, 0.05}, 0.5),
          fingers,
          {Plane{}},
          {0.5, 0.5},
          slide_path(X_WO, {0.1, 0, 0}, 8),
          {}};
}

TEST(Resume, BeginsWhereTheObjectWasMeasuredOnTheFloor) {
  std::mt19937_64 rng(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  const Problem problem = small_slide();
  const Plan whole = plan(problem, five_a_side());
  ASSERT_TRUE(whole);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Isometry3d on_path = at(0.045 + 0.04 * unit(rng), 0, 0.025);
    Eigen::Isometry3d measured = on_path;
    measured.pretranslate(Eigen::Vector3d(0.003 * unit(rng), 0.003 * unit(rng), 0.002 * unit(rng)));
    measured.rotate(Eigen::AngleAxisd(0.03 * unit(rng), Eigen::Vector3d::UnitZ()));
    measured.rotate(Eigen::AngleAxisd(0.03 * unit(rng), Eigen::Vector3d::UnitX()));
    const Rest rest = resume(problem, whole, 0, measured, five_a_side());
    const Eigen::Isometry3d& from = std::get<Path>(rest.problem.motion).X_WO.front();
    EXPECT_NEAR(from.translation().z(), 0.025, 1e-9);  // flat
    EXPECT_LE((from.translation() - measured.translation()).head<2>().norm(), 1e-6);
    if (!rest.plan) continue;  // the fingers may be unable to correct it
    EXPECT_EQ(check(rest.problem, rest.plan, five_a_side()), std::vector<std::string>{});
    EXPECT_TRUE(rest.plan.segments.front().X_WO.front().isApprox(from, 1e-12));
  }
}

TEST(Resume, SaysSoWhereAWallKeepsTheObjectFromWhatWasMeasured) {
  const Problem problem = tumble_case(true, 8);
  const Plan whole = plan(problem, five_a_side());
  ASSERT_TRUE(whole);
  Eigen::Isometry3d measured = whole.segments[0].X_WO[1];
  measured.pretranslate(Eigen::Vector3d(0.004, 0.003, 0));  // the edge would leave the floor's line
  const Rest rest = resume(problem, whole, 0, measured, five_a_side());
  ASSERT_TRUE(rest.plan) << rest.plan.reason;
  ASSERT_FALSE(rest.plan.warnings.empty());
  EXPECT_NE(rest.plan.warnings.back().find("from where it was measured"), std::string::npos);
  EXPECT_EQ(check(rest.problem, rest.plan, five_a_side()), std::vector<std::string>{});
}

TEST(Resume, ReportsStatesFromWhichItDoesNotGoOn) {
  const Problem problem = small_slide();
  const Plan whole = plan(problem, five_a_side());
  ASSERT_TRUE(whole);
  const auto status = [&](const Eigen::Isometry3d& X_WO) {
    return resume(problem, whole, 0, X_WO, five_a_side()).plan.status;
  };
  EXPECT_EQ(status(at(0.05, 0.03, 0.025)), Status::off_path);
  EXPECT_EQ(status(at(0.05, 0, 0.06)), Status::off_path);
  EXPECT_EQ(status(at(0.05, 0, 0.025) * Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ())),
            Status::off_path);
  EXPECT_EQ(status(whole.segments.back().X_WO.back()), Status::at_goal);
}

TEST(Resume, NamesWhatTheCallerGotWrong) {
  const Problem problem = small_slide();
  const Plan whole = plan(problem, five_a_side());
  ASSERT_TRUE(whole);
  const Eigen::Isometry3d X_WO = at(0.05, 0, 0.025);
  const auto expect_fault = [&](const Plan& given, int segment, const Eigen::Isometry3d& X,
                                const std::string& words) {
    expect_refused([&] { resume(problem, given, segment, X, five_a_side()); }, words);
  };
  expect_fault(Plan{}, 0, X_WO, "not solved");
  expect_fault(whole, 1, X_WO, "segment must be 0 to 0, not 1");
  expect_fault(whole, -1, X_WO, "segment must be");
  expect_fault(whole, 0, at(NAN, 0, 0), "X_WO");
}

}  // namespace
}  // namespace graspless::fingertip
