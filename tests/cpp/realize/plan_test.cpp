// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "graspless/realize/realize.hpp"

#include "complaint.hpp"
#include "realize/plans.hpp"
#include "robot/robots.hpp"

namespace graspless::fingertip {
namespace {

/// A block whose best places for fingertips, on its long sides, are too far apart for the T42.
Problem wide_block() {
  Problem problem = BlockTumble().problem;
  problem.object = Object::box("block", {0.062, 0.078, 0.08}, 0.2);
  const Eigen::Isometry3d start = at(0.6, 0, 0.04);
  problem.motion = turn_path(start, {0.631, 0, 0}, Eigen::Vector3d::UnitY(), M_PI / 2, 18);
  return problem;
}

CarriedPlan carried(const Problem& problem, const RealizeOptions& options,
                    const Eigen::VectorXd& home = wam_tips().state("home")) {
  return plan_carried(problem, {}, wam_tips(), t42(), home, options, planning::Budget{100});
}

double scrub(const Realization& found) {
  double most = 0;
  for (const JointSegment& segment : found.segments) most = std::max(most, segment.scrub);
  return most;
}

TEST(FingertipPlanCarried, FingertipsComeNearerTogetherWhereTheHandDoesNotOpen) {
  const Problem problem = wide_block();
  RealizeOptions options;
  options.plans = 1;
  const CarriedPlan best = carried(problem, options);
  EXPECT_EQ(best.plan.status, Status::not_realized);
  EXPECT_CONTAINS(best.plan.reason, "touches 'block': a hand that opens wider");
  const CarriedPlan found = carried(problem, {});
  ASSERT_TRUE(found.plan && found.realization) << found.plan.reason;
  EXPECT_EQ(joined(check(problem, found.plan)), "");
  EXPECT_EQ(joined(check(problem, found.plan, wam_tips(), t42(), found.realization)), "");
  EXPECT_GT(found.plan.cost, best.plan.cost);
  EXPECT_EQ(found.plan.lower_bound, best.plan.lower_bound);
  EXPECT_CONTAINS(found.plan.warnings.back(), "fingertips are at most ");
  EXPECT_LT(scrub(found.realization), 1e-3);
}

TEST(FingertipPlanCarried, LittleScrubIsWorthAnotherPlan) {
  const Problem problem = BlockTumble().problem;
  RealizeOptions any;
  any.max_scrub = 1;
  const CarriedPlan best = carried(problem, any), found = carried(problem, {});
  ASSERT_TRUE(best.realization && found.realization) << best.plan.reason << found.plan.reason;
  EXPECT_EQ(best.plan.cost, plan(problem).cost);
  EXPECT_TRUE(best.plan.warnings.empty());
  EXPECT_LT(scrub(found.realization), scrub(best.realization));
  EXPECT_CONTAINS(found.plan.warnings.back(), "with fingertips that slip by less than");
}

TEST(FingertipPlanCarried, ReasonsSayWhatToChange) {
  Problem far = wide_block();
  far.motion = turn_path(at(1.6, 0, 0.04), {1.631, 0, 0}, Eigen::Vector3d::UnitY(), M_PI / 2, 18);
  RealizeOptions options;
  options.plans = 2;
  options.restarts = 2;
  const CarriedPlan found = carried(far, options);
  EXPECT_EQ(found.plan.status, Status::not_realized);
  EXPECT_CONTAINS(found.plan.reason, " mm: nearer to the robot");
  EXPECT_CONTAINS(found.plan.reason,
                  "; 1 more with fingertips nearer together failed too, the last: segment 0");
}

TEST(FingertipPlanCarried, AHomeThatTouchesEndsTheSearch) {
  const Problem problem = wide_block();
  Eigen::VectorXd home = wam_tips().state("home");
  home[1] = 1.9;  // into the floor
  const CarriedPlan found = carried(problem, {}, home);
  EXPECT_EQ(found.plan.status, Status::not_realized);
  EXPECT_EQ(found.plan.reason.rfind("q_home: ", 0), 0U) << found.plan.reason;
  EXPECT_EQ(found.plan.reason.find(" more "), std::string::npos) << found.plan.reason;
}

TEST(FingertipPlanCarried, SameSeedSameMotion) {
  const CarriedPlan once = carried(wide_block(), {}), again = carried(wide_block(), {});
  ASSERT_EQ(once.realization.segments.size(), again.realization.segments.size());
  for (std::size_t i = 0; i < once.realization.segments.size(); ++i)
    EXPECT_EQ(once.realization.segments[i].positions, again.realization.segments[i].positions);
}

}  // namespace
}  // namespace graspless::fingertip
