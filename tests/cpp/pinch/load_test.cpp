// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The weight that the pads of a pinch bear.
#include <gtest/gtest.h>

#include "graspless/pinch/pinch.hpp"

#include "complaint.hpp"
#include "pinch/things.hpp"

namespace graspless::pinch {
namespace {

using Eigen::Vector3d;
using slide::Object;

/// By the limit surface of both pads: the motor of the T42 presses with 5.2 N.
TEST(PinchLoad, RefusesWhatThePadsDoNotBear) {
  Problem problem = standing(rectangle(0.12, 0.03), 0.05);
  const Object bar = problem.object;
  const auto of = [&](double mass, const Options& options = {}) {
    problem.object = bar.with_mass(mass);
    return pinch::plan(problem, options);
  };
  const Plan light = of(1);
  ASSERT_TRUE(light) << light.reason;
  EXPECT_EQ(joined(check(problem, light)), "");
  ASSERT_TRUE(light.max_mass);
  const double press = 0.5 * 2 / (2 * 0.096);  // half the effort, by levers to the tip's centre
  EXPECT_NEAR(*light.max_mass, 2 * (1.16 - light.friction) * press / 9.81, 0.06);
  const Plan heavy = of(1.5);
  EXPECT_EQ(heavy.status, Status::too_heavy);
  EXPECT_NE(heavy.reason.find("kg at 5."), std::string::npos) << heavy.reason;
  EXPECT_NE(heavy.reason.find("it weighs 1.50 kg"), std::string::npos) << heavy.reason;
  Options strong;
  strong.grip_force = 20;
  const Plan held = of(1.5, strong);
  ASSERT_TRUE(held) << held.reason;
  EXPECT_EQ(joined(check(problem, held, strong)), "");
  EXPECT_NE(joined(check(problem, held)).find("kg there, it weighs 1.5 kg"), std::string::npos);
  Plan boastful = light;
  boastful.max_mass = 3;
  problem.object = bar.with_mass(1);
  const std::string bound = "max_mass must be above 0 and at most";
  EXPECT_NE(joined(check(problem, boastful)).find(bound), std::string::npos);
  boastful.max_mass = -1;
  EXPECT_NE(joined(check(problem, boastful)).find(bound), std::string::npos);
  boastful = light;
  boastful.opening += 0.01;
  EXPECT_NE(joined(check(problem, boastful)).find("plan: opening must be"), std::string::npos);
}

/// Twist: a hammer can be held by its handle alone, away from its centre of mass.
TEST(PinchLoad, TheLeverOfAHammerCounts) {
  const geometry::Polygon hammer(geometry::columns({{-0.15, -0.01},
                                                    {0, -0.01},
                                                    {0, -0.05},
                                                    {0.06, -0.05},
                                                    {0.06, 0.05},
                                                    {0, 0.05},
                                                    {0, 0.01},
                                                    {-0.15, 0.01}}));
  Problem problem = standing(hammer, 0.04);
  Options options;
  options.margin = 0.001;
  problem.object = problem.object.with_com({0.02, 0, 0.02}).with_mass(0.01);
  const Plan light = pinch::plan(problem, options);
  ASSERT_TRUE(light && light.max_mass) << light.reason;
  EXPECT_EQ(joined(check(problem, light, options)), "");
  const Vector3d arm = problem.object.com() - light.contacts_O.rowwise().mean(),
                 line = (light.contacts_O.col(1) - light.contacts_O.col(0)).normalized();
  const double press = 5.2, mu = 1.16, lever = std::abs(arm.x() * line.y() - arm.y() * line.x());
  ASSERT_GT(lever, 0.01);
  EXPECT_LT(*light.max_mass, 1.05 * 4 / 3.0 * mu * options.patch * press / (9.81 * lever));
  problem.object = problem.object.with_mass(1.2 * *light.max_mass);
  const Plan heavy = pinch::plan(problem, options);
  EXPECT_TRUE(!heavy || *heavy.max_mass >= problem.object.mass());
}

/// The same bar on a tilted support: the weight has a lever that is not seen from above.
TEST(PinchLoad, GravityIsThatOfTheWorld) {
  Problem level = standing(rectangle(0.12, 0.03), 0.12, 0.6, 0, 0);
  Options options;
  options.height = 0.11;
  const Plan upright = pinch::plan(level, options);
  ASSERT_TRUE(upright) << upright.reason;
  Problem leaning = level;
  const Eigen::Isometry3d X = Eigen::Translation3d(0.6, 0, 0) *
                              Eigen::AngleAxisd(0.5, Vector3d::UnitY()) *
                              Eigen::Translation3d(-0.6, 0, 0);
  leaning.support = slide::Support(level.support.polygon(), X * level.support.X_WS(), 0.04, 0.06,
                                   0.6);  // it would slide off a smoother one
  leaning.X_WO_start = X * level.X_WO_start;
  const Plan found = pinch::plan(leaning, options);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_LT(*found.max_mass, 0.5 * *upright.max_mass);
  EXPECT_EQ(joined(check(leaning, found, options)), "");
}

/// Of the weight beside the middle, one contact bears more.
TEST(PinchLoad, TheNearerFingerBearsMore) {
  Problem problem = standing(rectangle(0.02, 0.05), 0.05, 0.6, 0, 0);
  Options options;
  options.margin = 0.0005;
  const Plan centred = pinch::plan(problem, options);
  problem.object = problem.object.with_com({0, 0.024, 0.025});
  const Plan aside = pinch::plan(problem, options);
  ASSERT_TRUE(centred && aside) << centred.reason << aside.reason;
  EXPECT_NEAR(*aside.max_mass / *centred.max_mass, 0.5 / (0.5 + 0.024 / 0.05), 0.08);
  Plan boastful = aside;
  boastful.max_mass = centred.max_mass;
  EXPECT_NE(joined(check(problem, boastful, options)).find("above 0 and at most"),
            std::string::npos);
  boastful = aside;
  boastful.friction = 0;
  EXPECT_EQ(joined(check(problem, boastful, options)), "");  // its faces are parallel
}

/// A claim about the slopes that they do not bear out is found.
TEST(PinchLoad, CheckMeasuresSlopes) {
  const geometry::Polygon wedge(
      geometry::columns({{-0.05, -0.008}, {0.05, -0.026}, {0.05, 0.026}, {-0.05, 0.008}}));
  const Problem problem = standing(wedge, 0.05);
  Plan found = pinch::plan(problem);
  ASSERT_TRUE(found) << found.reason;
  EXPECT_EQ(joined(check(problem, found)), "");
  found.friction = 0;
  EXPECT_NE(joined(check(problem, found)).find("friction must be at least"), std::string::npos);
}

}  // namespace
}  // namespace graspless::pinch
