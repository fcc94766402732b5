// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// plan() on the paper's cases: costs, and what every plan must hold.
#include "fingertip/planner.hpp"

#include <gtest/gtest.h>

#include "graspless/watch.hpp"

#include "fingertip/cases.hpp"

namespace graspless::fingertip {
namespace {

/// Rows, poses and fingers fit together.
void expect_well_formed(const Problem& problem, const Options& options, const Plan& plan) {
  ASSERT_TRUE(plan) << plan.reason;
  const auto P = static_cast<std::size_t>(options.samples_per_arc);
  double least = INFINITY;
  for (std::size_t s = 0; s < plan.segments.size(); ++s) {
    const Segment& segment = plan.segments[s];
    const bool is_regrasp = segment.name == "regrasp";
    EXPECT_EQ(segment.rows.size(), is_regrasp ? 1 : (segment.X_WO.size() - 1) * P);
    EXPECT_EQ(segment.finger >= 0, is_regrasp);
    if (s > 0) {
      EXPECT_TRUE(segment.X_WO.front().isApprox(plan.segments[s - 1].X_WO.back(), 1e-12));
    }
    for (const Row& row : segment.rows) {
      ASSERT_EQ(row.fingers.size(), static_cast<std::size_t>(problem.fingers.count));
      EXPECT_GE(row.stability, options.min_stability);
      EXPECT_GT(row.nominal_margin, 0);
      EXPECT_GT(row.compliant_stability, 0);
      EXPECT_GE(row.withstands, plan.withstands);
      EXPECT_GE(row.place_tolerance, plan.place_tolerance);
      least = std::min(least, row.stability);
      for (std::size_t i = 0; i < row.fingers.size(); ++i) {
        const FingerState& finger = row.fingers[i];
        EXPECT_EQ(finger.touches, static_cast<int>(i) != segment.finger);
        const double normal = finger.n_O.dot(finger.nominal_force_O);
        if (finger.touches && finger.mode == FingerMode::force) {
          EXPECT_NEAR(normal, finger.commanded_force, 1e-7);
        }
        EXPECT_LE(normal, problem.fingers.max_normal_force + 1e-9);
      }
    }
  }
  const Segment& weakest = plan.segments.at(static_cast<std::size_t>(plan.weakest_segment));
  EXPECT_GE(plan.withstands, 0);
  EXPECT_EQ(weakest.rows.at(static_cast<std::size_t>(plan.weakest_row)).stability, least);
}

TEST(FingertipPlanner, ReferenceCostsByTheFastEngine) {
  for (const Case& it : paper_cases()) {
    const Options options;
    const Plan found = plan(it.problem, options);
    expect_well_formed(it.problem, options, found);
    EXPECT_NEAR(found.cost, it.cost, 1e-8) << it.name;
    EXPECT_EQ(found.lower_bound, found.cost) << it.name;
    EXPECT_EQ(found.regrasps, it.regrasps) << it.name;
    EXPECT_EQ(check(it.problem, found, options), std::vector<std::string>{}) << it.name;
  }
}

TEST(FingertipPlanner, ReferenceCostsByThePapersEngine) {
  for (const int i : {1, 2}) {
    const Case it = paper_cases()[i];
    const Options options = with_engine(Search::paper);
    const Plan found = plan(it.problem, options);
    expect_well_formed(it.problem, options, found);
    EXPECT_NEAR(found.cost, it.cost, 1e-8) << it.name;
  }
}

TEST(FingertipPlanner, FingersKeepTheirNamesThroughARegrasp) {
  const Plan found = plan(tumble_case(true));
  ASSERT_EQ(found.segments.size(), 3U);
  EXPECT_EQ(found.segments[0].name, "tumble");
  EXPECT_EQ(found.segments[1].name, "regrasp");
  EXPECT_EQ(found.segments[0].X_WO.size(), 13U);  // at 36 degrees
  const auto moved = static_cast<std::size_t>(found.segments[1].finger);
  const Row& before = found.segments[0].rows.back();
  const Row& after = found.segments[2].rows.front();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(before.fingers[i].p_OC == after.fingers[i].p_OC, i != moved);
  }
}

// Cases a and c of the paper: the finger on top presses by force, the one behind holds its place.
TEST(FingertipPlanner, TiesGoToTheModesThatHold) {
  const Plan found = plan(slide_case(10));
  ASSERT_TRUE(found);
  for (const FingerState& finger : found.segments[0].rows[0].fingers) {
    const bool is_on_top = finger.n_O.z() < -0.5;
    EXPECT_EQ(finger.mode, is_on_top ? FingerMode::force : FingerMode::position);
  }
}

TEST(FingertipPlanner, DoesNotDependOnWhereTheWorldIs) {
  Problem problem = tumble_case(false, 10);
  Options options;
  options.locations_per_side = 3;
  const Plan before = plan(problem, options);
  ASSERT_TRUE(before);
  const Eigen::Isometry3d X = Eigen::Translation3d(3, -2, 1) *
                              Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  for (Plane& plane : problem.planes) {
    plane.n_W = X.linear() * plane.n_W;
    plane.offset += plane.n_W.dot(X.translation());
  }
  problem.gravity_W = X.linear() * problem.gravity_W;
  for (Eigen::Isometry3d& X_WO : std::get<Path>(problem.motion).X_WO) X_WO = X * X_WO;
  const Plan after = plan(problem, options);
  ASSERT_TRUE(after) << after.reason;
  EXPECT_NEAR(after.cost, before.cost, 1e-9);
}

TEST(FingertipPlanner, PushesWithoutFriction) {
  Problem problem = slide_case(10, 5);
  problem.friction = {0, 0};
  Options options;
  options.locations_per_side = 3;
  const Plan found = plan(problem, options);
  expect_well_formed(problem, options, found);
  EXPECT_TRUE(check(problem, found, options).empty());
  problem.fingers.friction = {0, 0};
  EXPECT_EQ(plan(problem, options).status, Status::unstable);
}

TEST(FingertipPlanner, SaysWhyNothingWasFound) {
  Options options;
  options.explain = false;
  options.locations_per_side = 3;
  Problem weak = slide_case(0.2, 5);
  const Plan unstable = plan(weak, options);
  EXPECT_EQ(unstable.status, Status::unstable);
  EXPECT_NE(unstable.reason.find("min_stability"), std::string::npos) << unstable.reason;
  Problem tight = slide_case(10, 5);
  tight.fingers.radius = 8;
  tight.fingers.count = 4;
  const Plan nowhere = plan(tight, options);
  EXPECT_EQ(nowhere.status, Status::no_location);
  EXPECT_NE(nowhere.reason.find("pose 0"), std::string::npos) << nowhere.reason;
  planning::Budget budget;
  options.search = Search::paper;
  budget.iterations = 3;
  const Plan late = plan(tumble_case(true, 10), options, budget);
  EXPECT_EQ(late.status, Status::out_of_time);
  budget.interrupted = [] { return true; };
  EXPECT_EQ(plan(tumble_case(true, 10), options, budget).status, Status::interrupted);
}

/// Warnings that an object does not stay where it is by itself.
std::vector<std::string> falls(const Plan& plan) {
  std::vector<std::string> found;
  for (const std::string& warning : plan.warnings) {
    if (warning.find("does not stay at the") != std::string::npos) found.push_back(warning);
  }
  return found;
}

TEST(FingertipPlanner, WarnsOfObjectsThatDoNotStayByThemselves) {
  const auto found = [](const Problem& problem) {
    Plan solved = plan(problem);
    EXPECT_TRUE(solved) << solved.reason;
    return solved;
  };
  for (const double friction : {0.0, 0.5}) {
    Problem upright = slide_case(10, 3);
    upright.friction = {friction, friction};
    EXPECT_EQ(falls(found(upright)), std::vector<std::string>());
  }
  EXPECT_EQ(falls(found(tumble_case(true, 10))), std::vector<std::string>());

  Problem sideways = slide_case(10, 3);
  sideways.gravity_W = {1, 0, 0};
  const std::vector<std::string> both = falls(found(sideways));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_NE(both[0].find("at the first pose"), std::string::npos) << both[0];
  EXPECT_NE(both[0].find("until the fingers press"), std::string::npos) << both[0];
  EXPECT_NE(both[1].find("at the last pose"), std::string::npos) << both[1];

  Problem half = tumble_case(false, 5);  // ends on an edge
  half.motion = turn_path(at(0, 0, 5), {2.5, 0, 0}, Eigen::Vector3d::UnitY(), M_PI / 10, 5);
  const Plan onto_edge = found(half);
  ASSERT_EQ(falls(onto_edge).size(), 1U);
  EXPECT_NE(falls(onto_edge)[0].find("at the last pose"), std::string::npos);

  Problem held = sideways;  // by fingers that are there already
  const Plan before = found(sideways);
  for (const FingerState& finger : before.segments.front().rows.front().fingers) {
    held.fingers.start.push_back(finger.p_OC);
  }
  EXPECT_EQ(falls(found(held)).size(), 1U);
}

TEST(FingertipPlanner, WritesUpWhatWasFoundAfterTheTime) {
  Problem problem = tumble_case(false, 300);
  problem.planes.resize(1);
  problem.object = Object::box("cuboid", {5, 5, 10}, 0.3);
  Options options;
  options.locations_per_side = 3;
  options.threads = 1;
  SearchContext context(problem, options);
  const PoseGraph graph(problem, std::get<Path>(problem.motion), context.locations,
                        context.instants, options);
  planning::Clock early{planning::Budget{}};
  Statistics statistics;
  const Route route = search(graph, context, early, statistics);
  ASSERT_TRUE(route.found);

  planning::Budget budget;
  budget.seconds = 1e-9;
  planning::Clock late(budget);
  Plan found;
  EXPECT_TRUE(late.run([&] {
    EXPECT_TRUE(late.is_out());
    write_up(stages_of(graph, route), context, late, found);
    poll();
  }));
  ASSERT_EQ(found.status, Status::solved) << found.reason;
  EXPECT_GE(late.seconds(), 0.06);  // more than 40 ms, or this tests nothing
  EXPECT_EQ(check(problem, found, options), std::vector<std::string>());
}

}  // namespace
}  // namespace graspless::fingertip
