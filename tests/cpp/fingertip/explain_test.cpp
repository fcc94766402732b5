// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a failed search says: which limit blocks, and the least single change that helps. A change
// that is said to help must help, and 2 % less of it must not.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "fingertip/cases.hpp"

namespace graspless::fingertip {
namespace {

/// A coarse lattice, so that a search takes a few milliseconds.
Options coarse() {
  Options options;
  options.locations_per_side = 3;
  return options;
}

Plan planned(const Problem& problem, Options options, bool explains = false) {
  options.explain = explains;
  planning::Budget budget;
  budget.seconds = 100;
  return plan(problem, options, budget);
}

/// The problem with one field set.
void set(Problem& problem, Options& options, const std::string& field, double value) {
  if (field == "fingers.friction") problem.fingers.friction = {value, value};
  if (field == "fingers.max_normal_force") problem.fingers.max_normal_force = value;
  if (field == "friction") problem.friction = {value, value};
  if (field == "planes[1] 'beside'.friction") problem.planes[1].friction = {value, value};
  if (field == "min_stability") options.min_stability = value;
}

double value_of(const Problem& problem, const Options& options, const std::string& field) {
  if (field == "fingers.friction") return problem.fingers.friction.lower;
  if (field == "fingers.max_normal_force") return problem.fingers.max_normal_force;
  if (field == "planes[1] 'beside'.friction") return problem.planes[1].friction->lower;
  return field == "friction" ? problem.friction.lower : options.min_stability;
}

bool solves_with(Problem problem, Options options, const std::string& field, double value) {
  set(problem, options, field, value);
  return planned(problem, options).status == Status::solved;
}

/// Each relaxation helps, and does not when it stops short.
void expect_least(const Problem& problem, const Options& options, const Plan& failed) {
  for (const Relaxation& found : failed.relaxations) {
    SCOPED_TRACE(found.field);
    const double given = value_of(problem, options, found.field);
    EXPECT_TRUE(solves_with(problem, options, found.field, found.value));
    const double less = found.value > given ? found.value / 1.02 : found.value * 1.02;
    if (std::abs(std::log(found.value / given)) < 0.02) continue;
    EXPECT_FALSE(solves_with(problem, options, found.field, less));
  }
}

bool names(const Plan& plan, const std::string& field) {
  return std::any_of(plan.relaxations.begin(), plan.relaxations.end(),
                     [&](const Relaxation& found) { return found.field == field; });
}

TEST(Explain, NothingOfAPlanThatWasFound) {
  const Plan plan = planned(slide_case(10, 3), coarse(), true);
  ASSERT_TRUE(plan);
  EXPECT_TRUE(plan.limit.empty());
  EXPECT_TRUE(plan.relaxations.empty());
}

TEST(Explain, FingersThatAreTooWeak) {
  const Problem problem = slide_case(0.5, 3);
  const Plan plan = planned(problem, coarse(), true);
  EXPECT_EQ(plan.status, Status::unstable);
  EXPECT_FALSE(plan.limit.empty());
  EXPECT_TRUE(names(plan, "fingers.max_normal_force")) << plan.reason;
  expect_least(problem, coarse(), plan);
}

TEST(Explain, MoreStabilityThanThereIs) {
  const Problem problem = slide_case(10, 3);
  Options options = coarse();
  Plan best = planned(problem, options);
  ASSERT_TRUE(best);
  options.min_stability = 20;
  const Plan plan = planned(problem, options, true);
  EXPECT_EQ(plan.status, Status::unstable);
  EXPECT_TRUE(names(plan, "min_stability")) << plan.reason;
  expect_least(problem, options, plan);
}

/// Pushed along a wall that is too rough to slide on.
TEST(Explain, AWallThatIsTooRough) {
  Problem problem = slide_case(10, 3);
  problem.planes.push_back({"beside", -Eigen::Vector3d::UnitY(), -5, FrictionInterval{3, 3}});
  Options options = coarse();
  options.min_stability = 7;
  const Plan plan = planned(problem, options, true);
  ASSERT_EQ(plan.status, Status::unstable) << plan.reason;
  EXPECT_TRUE(names(plan, "planes[1] 'beside'.friction")) << plan.reason;
  expect_least(problem, options, plan);
}

TEST(Explain, ItIsOffWhenNotAskedFor) {
  const Plan plan = planned(slide_case(0.5, 3), coarse(), false);
  EXPECT_TRUE(plan.limit.empty());
  EXPECT_TRUE(plan.relaxations.empty());
}

TEST(Explain, TheSameFailureGivesTheSameAnswer) {
  const Plan first = planned(slide_case(0.5, 3), coarse(), true),
             second = planned(slide_case(0.5, 3), coarse(), true);
  EXPECT_EQ(first.reason, second.reason);
  ASSERT_EQ(first.relaxations.size(), second.relaxations.size());
  for (std::size_t i = 0; i < first.relaxations.size(); ++i) {
    EXPECT_EQ(first.relaxations[i].value, second.relaxations[i].value);
  }
}

TEST(Explain, APoseWithoutAClearLocation) {
  Problem problem = slide_case(10, 3);
  problem.planes.push_back({"ceiling", -Eigen::Vector3d::UnitZ(), -5.5});
  problem.planes.push_back({"left", Eigen::Vector3d::UnitY(), -5.5});
  problem.planes.push_back({"right", -Eigen::Vector3d::UnitY(), -5.5});
  problem.fingers.radius = 2.6;  // no room over the floor beside the object, nor above it
  const Plan plan = planned(problem, coarse(), true);
  EXPECT_EQ(plan.status, Status::no_location);
  EXPECT_EQ(plan.limit, "reach of the lattice");
  EXPECT_NE(plan.reason.find("at pose 0 of 4 no fingertip location is clear"), std::string::npos)
      << plan.reason;
  EXPECT_NE(plan.reason.find("plane 'ceiling' blocks"), std::string::npos) << plan.reason;
}

TEST(Explain, RoomForOneFingerOfTwo) {
  Problem problem = slide_case(10, 3);
  problem.fingers.radius = 2.4;
  problem.planes.push_back({"ceiling", -Eigen::Vector3d::UnitZ(), -5.5});
  problem.planes.push_back({"left", Eigen::Vector3d::UnitY(), -5.5});
  problem.planes.push_back({"right", -Eigen::Vector3d::UnitY(), -5.5});
  problem.planes.push_back({"ahead", -Eigen::Vector3d::UnitX(), -13});
  Options options = coarse();
  options.locations_per_side = 1;
  problem.obstacles = {
      {"post", {{geometry::Box{{1, 1, 1}}, Eigen::Isometry3d::Identity()}}, at(-7, 0, 2.5)}};
  const Plan plan = planned(problem, options, true);
  EXPECT_EQ(plan.status, Status::no_location);
  EXPECT_EQ(plan.limit, "geometry") << plan.reason;
  EXPECT_NE(plan.reason.find("only 1 fingertip locations are clear"), std::string::npos)
      << plan.reason;
  EXPECT_NE(plan.reason.find("obstacle 'post' blocks 1"), std::string::npos) << plan.reason;
}

}  // namespace
}  // namespace graspless::fingertip
