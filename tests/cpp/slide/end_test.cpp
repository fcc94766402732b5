// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Slides to a given pose, at which the object is left.
#include <gtest/gtest.h>

#include "graspless/slide/resume.hpp"

#include "complaint.hpp"
#include "slide/problems.hpp"

namespace graspless::slide {
namespace {

/// A card that sticks out of the table, and shall lie in its middle.
Problem sticking_out(double yaw = 0.8) {
  Problem problem = make_problem(tables()[0], objects()[0], flat(0.62, -0.33, 0));
  problem.X_WO_end = flat(0.6, -0.1, yaw);
  return problem;
}

std::vector<std::string> segments_of(const Plan& plan) {
  std::vector<std::string> found;
  for (const Segment& segment : plan.segments) found.push_back(segment.name);
  return found;
}

TEST(End, TheObjectIsLeftWhereItShallLie) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Problem problem = sticking_out(0.3 * static_cast<double>(seed));
    const Plan found = plan(problem, {}, seeded(seed));
    ASSERT_TRUE(found) << "seed " << seed << ": " << found.reason;
    EXPECT_EQ(joined(check(problem, found)), "") << "seed " << seed;
    EXPECT_TRUE(found.X_WO_goal.isApprox(*problem.X_WO_end, 1e-4));
    EXPECT_EQ(segments_of(found), (std::vector<std::string>{"approach", "press", "slide", "lift"}));
  }
}

TEST(End, APlanIsProvenBetweenItsRows) {
  const Problem problem = sticking_out();
  const Plan found = plan(problem, {}, seeded(1));
  ASSERT_TRUE(found) << found.reason;
  const scene::EdgeCertificate proof = certify(problem, found);
  EXPECT_EQ(proof.doubts.size(), 0U);
}

TEST(End, TheSameSeedGivesTheSamePlan) {
  const Problem problem = sticking_out();
  const Plan a = plan(problem, {}, seeded(3)), b = plan(problem, {}, seeded(3));
  ASSERT_TRUE(a && b);
  for (std::size_t i = 0; i < a.segments.size(); ++i)
    EXPECT_EQ(a.segments[i].positions, b.segments[i].positions);
}

TEST(End, AnInterruptedOneGoesOn) {
  const Problem problem = sticking_out();
  const Plan found = plan(problem, {}, seeded(1));
  ASSERT_TRUE(found) << found.reason;
  const Segment& slide = found.segments[2];
  const std::size_t row = slide.positions.size() / 2;
  Eigen::Isometry3d moved = slide.object_poses[row];
  moved.pretranslate(Eigen::Vector3d(0.003, -0.002, 0));
  const Interruption at{slide.positions[row], moved, found.X_WO_goal};
  const Plan rest = resume(problem, at, {}, seeded(1));
  ASSERT_TRUE(rest) << rest.reason;
  EXPECT_EQ(joined(check(problem, rest)), "");
  EXPECT_TRUE(rest.X_WO_goal.isApprox(*problem.X_WO_end, 1e-4));
}

TEST(End, AnInterruptedOneEndsOnlyWhereTheSupportHoldsIt) {
  Problem problem = sticking_out();
  const Plan found = plan(problem, {}, seeded(1));
  ASSERT_TRUE(found) << found.reason;
  const Segment& slide = found.segments[2];
  const std::size_t row = slide.positions.size() / 2;
  Options strict;
  strict.com_margin = 0.3;
  const Plan rest = resume(problem, {slide.positions[row], slide.object_poses[row], std::nullopt},
                           strict, seeded(1));
  EXPECT_EQ(rest.status, Status::no_goal_root);
  EXPECT_NE(rest.reason.find("options.com_margin asks for"), std::string::npos) << rest.reason;
}

TEST(End, CheckFindsAnotherPlace) {
  Problem problem = sticking_out();
  const Plan found = plan(problem, {}, seeded(1));
  ASSERT_TRUE(found) << found.reason;
  problem.X_WO_end->pretranslate(Eigen::Vector3d(0.002, 0, 0));
  EXPECT_NE(joined(check(problem, found)).find("the object is not at its end"), std::string::npos);
  problem.X_WO_end = sticking_out(0.81).X_WO_end;
  EXPECT_NE(joined(check(problem, found)).find("the object is not at its end"), std::string::npos);
  problem.X_WO_end.reset();
  EXPECT_NE(joined(check(problem, found)).find("segments are not"), std::string::npos);
}

TEST(End, CheckFindsAPadThatMaySlip) {
  Problem problem = sticking_out();
  const Plan found = plan(problem, {}, seeded(1));
  ASSERT_TRUE(found) << found.reason;
  problem.hand.pad_friction = 0.15;
  EXPECT_NE(joined(check(problem, found)).find("friction may leave the object"), std::string::npos);
}

TEST(End, AnObstacleThereIsAReason) {
  Problem problem = sticking_out();
  problem.obstacles.push_back({"jug",
                               {{geometry::Box{{0.06, 0.06, 0.2}}, Eigen::Isometry3d::Identity()}},
                               flat(0.6, -0.1, 0)});
  planning::Budget budget = seeded(1);
  budget.iterations = 300;
  const Plan found = plan(problem, {}, budget);
  EXPECT_FALSE(found);
  EXPECT_NE(found.reason.find("jug"), std::string::npos) << found.reason;
}

TEST(End, ATurnThatFrictionMayUndoIsAReason) {
  planning::Budget budget = seeded(6);
  budget.iterations = 300;
  const Plan found = plan(sticking_out(3), {}, budget);
  EXPECT_FALSE(found);
  EXPECT_NE(found.reason.find("friction may leave the object turned by more than 5 deg"),
            std::string::npos)
      << found.reason;
}

TEST(End, APlaceNearTheEdgeIsRefusedWithTheDistance) {
  Problem problem = sticking_out();
  problem.X_WO_end = flat(0.6, -0.347, 0);
  const Plan found = plan(problem, {}, seeded(1));
  EXPECT_EQ(found.status, Status::no_goal_root);
  EXPECT_EQ(found.reason,
            "at the end (X_WO_end), the centre of mass is 3 mm inside the edge; options.com_margin "
            "asks for "
            "10 mm");
}

TEST(End, MistakesNameTheField) {
  Problem problem = sticking_out();
  problem.X_WO_end = Eigen::Translation3d(0, 0, 0.01) * *problem.X_WO_end;
  EXPECT_NE(complaint([&] { plan(problem); }).find("X_WO_end: height of the object"),
            std::string::npos);
  problem.X_WO_end = flat(0.1, 0, 0);
  EXPECT_NE(complaint([&] { plan(problem); }).find("X_WO_end: object 'square' is off the support"),
            std::string::npos);
  problem = sticking_out();
  Options options;
  options.search = Search::paper;
  EXPECT_NE(complaint([&] { plan(problem, options); }).find("options.search must be fast"),
            std::string::npos);
}

}  // namespace
}  // namespace graspless::slide
