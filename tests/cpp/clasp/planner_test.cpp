// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <regex>

#include <gtest/gtest.h>

#include "graspless/clasp/clasp.hpp"
#include "graspless/geometry/linking.hpp"

#include "clasp/free_space/free_space.hpp"
#include "clasp/hand/kinematics.hpp"
#include "clasp/ring_problem.hpp"
#include "complaint.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;

planning::Budget cycles(std::int64_t iterations, std::uint64_t seed = 1) {
  return {std::numeric_limits<double>::infinity(), iterations, seed, {}};
}

/// A short stability test.
Options quick() {
  Options options;
  options.stability.sequences = 2;
  options.stability.moves = 50;
  return options;
}

const Plan& ring_plan() {
  static const Plan plan = clasp::plan(ring_problem(), quick(), cycles(200));
  return plan;
}

std::vector<Eigen::VectorXd> all_rows(const Plan& plan) {
  std::vector<Eigen::VectorXd> rows;
  for (const Segment& segment : plan.segments) {
    rows.insert(rows.end(), segment.positions.begin(), segment.positions.end());
  }
  return rows;
}

TEST(ClaspPlan, ReachesAndClosesAroundARing) {
  const Problem problem = ring_problem();
  const Plan& plan = ring_plan();
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  ASSERT_EQ(plan.segments.size(), 2u);
  EXPECT_EQ(plan.segments[0].name, "reach");
  EXPECT_EQ(plan.segments[1].name, "close");
  EXPECT_EQ(plan.joint_names, problem.robot.joint_names());
  EXPECT_EQ(plan.loop, 0);
  EXPECT_TRUE(plan.stability.secure);
  EXPECT_EQ(plan.segments[0].positions.front(), problem.q_start);
  EXPECT_EQ(plan.segments[0].positions.back(), plan.segments[1].positions.front());
}

TEST(ClaspPlan, RowsAreFreeAndNearEachOther) {
  const std::vector<Eigen::VectorXd> rows = all_rows(ring_plan());
  FreeSpace free(ring_problem());
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_LE((rows[i] - rows[i - 1]).lpNorm<Eigen::Infinity>(), 0.05 + 1e-12);
    EXPECT_TRUE(free.is_free(rows[i - 1], rows[i], 0.01)) << "row " << i;
  }
}

// By the integral (1), of which the search takes no use.
TEST(ClaspPlan, VirtualLinkingIsThatOfTheRows) {
  const Problem problem = ring_problem();
  const Plan& plan = ring_plan();
  const Eigen::Matrix3Xd loop_W = problem.X_WO * problem.object.loops().found[0].points;
  HandKinematics hand(problem.robot, problem.hand);
  for (const Segment& segment : plan.segments) {
    ASSERT_EQ(segment.virtual_linking.rows(), hand.num_curves());
    ASSERT_EQ(segment.virtual_linking.cols(), static_cast<Eigen::Index>(segment.positions.size()));
    for (std::size_t row = 0; row < segment.positions.size(); row += 5) {
      hand.update(segment.positions[row]);
      for (int i = 0; i < hand.num_curves(); ++i) {
        const double linking = std::abs(geometry::virtual_linking(loop_W, hand.curve_points(i)));
        EXPECT_NEAR(segment.virtual_linking(i, static_cast<Eigen::Index>(row)),
                    std::min(1.0, linking), 1e-9);
      }
    }
  }
  const auto last_of_reach = plan.segments[0].virtual_linking.rightCols(1);
  EXPECT_GE(last_of_reach.minCoeff(), plan.min_linking);
  EXPECT_GE(plan.segments[1].virtual_linking.rightCols(1).sum(), last_of_reach.sum());
}

TEST(ClaspPlan, TheTreeLeadsFromTheStartToTheClasp) {
  const Plan& plan = ring_plan();
  const auto n = static_cast<int>(plan.tree.parents.size());
  ASSERT_EQ(plan.tree.p_W.cols(), n);
  ASSERT_FALSE(plan.tree.path.empty());
  EXPECT_EQ(plan.tree.path.front(), 0);
  for (std::size_t i = 1; i < plan.tree.path.size(); ++i) {
    EXPECT_EQ(plan.tree.parents[plan.tree.path[i]], plan.tree.path[i - 1]);
  }
  EXPECT_LE(n, plan.statistics.nodes);
  EXPECT_GT(plan.statistics.control_steps, 0);
  EXPECT_GT(plan.statistics.collision_checks, 0);
  EXPECT_EQ(plan.statistics.stability_tests, 1);
  EXPECT_LE(plan.statistics.cycles, 50);
}

TEST(ClaspPlan, SameSeedSamePlan) {
  const Plan again = clasp::plan(ring_problem(), quick(), cycles(200));
  EXPECT_EQ(all_rows(again), all_rows(ring_plan()));
  const Plan other = clasp::plan(ring_problem(), quick(), cycles(200, 2));
  EXPECT_NE(all_rows(other), all_rows(ring_plan()));
}

TEST(ClaspPlan, AMarkIsClasped) {
  Problem problem = ring_problem();
  problem.marks = {{0, 0, 0.13}};
  const Plan top = clasp::plan(problem, quick(), cycles(400));
  ASSERT_TRUE(top) << top.reason;
  EXPECT_LT((top.target.point - problem.marks[0]).norm(), 0.03);
}

TEST(ClaspPlan, APullPicksThePlace) {
  Problem problem = ring_problem();
  problem.pull_W = Vector3d(0, 0, 1);
  const Plan up = clasp::plan(problem, quick(), cycles(400));
  ASSERT_TRUE(up) << up.reason;
  EXPECT_GT(up.target.point.z(), 0.04);
  problem.pull_W = Vector3d(1, 0, 0);  // along the axis of the hole: no place serves
  const Plan none = clasp::plan(problem, quick(), cycles(400));
  EXPECT_EQ(none.status, Status::not_found);
  EXPECT_NE(none.reason.find("pull"), std::string::npos) << none.reason;
}

TEST(ClaspPlan, SaysThatTheStartTouchesSomething) {
  Problem problem = ring_problem();
  HandKinematics hand(problem.robot, problem.hand);
  hand.update(problem.q_start);
  problem.obstacles.push_back({"ball",
                               {{geometry::Sphere{0.05}}},
                               Eigen::Isometry3d(Eigen::Translation3d(hand.nodes().col(0)))});
  const Plan plan = clasp::plan(problem, {}, cycles(1));
  EXPECT_EQ(plan.status, Status::start_in_collision);
  EXPECT_NE(plan.reason.find("'ball'"), std::string::npos) << plan.reason;
  EXPECT_TRUE(plan.segments.empty());
}

TEST(ClaspPlan, SaysThatThereIsNoHole) {
  Eigen::Matrix3Xd ball(3, 300);
  for (int i = 0; i < 300; ++i) {
    const double z = 1 - (2.0 * i + 1) / 300, a = 2.4 * i;
    ball.col(i) << std::sqrt(1 - z * z) * std::cos(a), std::sqrt(1 - z * z) * std::sin(a), z;
  }
  Problem problem = ring_problem();
  problem.object = Object::from_cloud("ball", 0.1 * ball);
  const Plan plan = clasp::plan(problem, {}, cycles(1));
  EXPECT_EQ(plan.status, Status::no_reliable_hole);
  EXPECT_EQ(plan.reason, problem.object.loops().reason);
}

TEST(ClaspPlan, SaysHowMuchTooFarAwayTheObjectIs) {
  Problem problem = ring_problem();
  problem.X_WO.translation().x() = 3;
  const Plan plan = clasp::plan(problem, {}, cycles(1));
  EXPECT_EQ(plan.status, Status::no_target_in_reach);
  EXPECT_NE(plan.reason.find("too far away"), std::string::npos) << plan.reason;
  EXPECT_GT(plan.statistics.refusals.at("target: out of reach"), 3);
}

TEST(ClaspPlan, EndsWithItsBudget) {
  const Plan none = clasp::plan(ring_problem(), {}, cycles(0));
  EXPECT_EQ(none.status, Status::not_found);
  EXPECT_EQ(none.statistics.cycles, 0);
  planning::Budget budget = cycles(1000);
  budget.interrupted = [] { return true; };
  EXPECT_EQ(clasp::plan(ring_problem(), {}, budget).status, Status::interrupted);
}

TEST(ClaspPlan, RefusedMotionsNameTheLinksThatTouch) {
  const Plan plan = clasp::plan(ring_problem(), quick(), cycles(200));
  std::int64_t named = 0;
  for (const auto& [why, count] : plan.statistics.refusals) {
    if (why.rfind("motion: collision of ", 0) == 0) {
      EXPECT_NE(why.find(" with "), std::string::npos) << why;
      named += count;
    }
  }
  EXPECT_GT(named, 0);
}

TEST(ClaspPlan, AClaspThatIsNotSecureIsRefused) {
  Options options = quick();
  options.stability.escape_distance = 0.001;  // everything has escaped
  const Plan refused = clasp::plan(ring_problem(), options, cycles(3));
  EXPECT_EQ(refused.status, Status::not_secure) << refused.reason;
  EXPECT_EQ(refused.statistics.refusals.at("clasp: not secure"),
            refused.statistics.stability_tests);
  options.must_be_secure = false;
  const Plan taken = clasp::plan(ring_problem(), options, cycles(200));
  EXPECT_EQ(taken.status, Status::solved);
  EXPECT_FALSE(taken.stability.secure);
}

TEST(ClaspPlan, SaysThatAHandleIsTooThick) {
  Problem problem = ring_problem();
  EXPECT_TRUE(clasp::plan(problem, {}, cycles(0)).warnings.empty());
  problem.object = Object::from_cloud("tyre", ring_cloud(0.25, 0.2, 64, 32));
  problem.X_WO.translation().x() = 0.9;
  const Plan plan = clasp::plan(problem, {}, cycles(0));
  EXPECT_EQ(plan.status, Status::not_found) << plan.reason;
  ASSERT_EQ(plan.warnings.size(), 1u);
  EXPECT_NE(plan.warnings[0].find(" mm is too thick for this hand"), std::string::npos)
      << plan.warnings[0];
}

// The hole is 60 mm wide, and the two fingers of the hand 93 mm.
TEST(ClaspPlan, ASmallHoleIsClaspedWithOneFinger) {
  Problem problem = ring_problem();
  problem.object = Object::from_cloud("small ring", ring_cloud(0.045, 0.03));
  Plan plan = clasp::plan(problem, {}, cycles(200));
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  ASSERT_EQ(plan.fingers.size(), 1u);
  EXPECT_EQ(plan.segments[1].virtual_linking.rows(), 1);
  EXPECT_TRUE(plan.stability.secure);
  EXPECT_EQ(check(problem, plan), std::vector<std::string>{});
  plan.fingers[0] = plan.fingers[0] == "finger_1" ? "finger_2" : "finger_1";
  EXPECT_NE(check(problem, plan), std::vector<std::string>{});
  plan.fingers[0] = "finger_3";
  EXPECT_EQ(check(problem, plan),
            std::vector<std::string>{"plan: its fingers are not fingers of the hand"});
}

TEST(ClaspPlan, AllFingersOfTheHandClaspALargeHole) {
  EXPECT_EQ(ring_plan().fingers, (std::vector<std::string>{"finger_1", "finger_2"}));
  EXPECT_EQ(ring_plan().pre_shape, "open");
}

// The eye of a pair of scissors, 31 mm by 51 mm wide: a finger is 27 mm thick.
TEST(ClaspPlan, AFingerGoesThroughANarrowHole) {
  Problem problem = ring_problem();
  Eigen::Matrix3Xd cloud = ring_cloud(0.02, 0.009, 40);
  cloud.row(2) *= 1.5;
  problem.object = Object::from_cloud("eye", cloud);
  const Plan plan = clasp::plan(problem, quick(), cycles(200));
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_EQ(plan.fingers.size(), 1u);
  EXPECT_EQ(check(problem, plan, quick()), std::vector<std::string>{});
  EXPECT_EQ(all_rows(clasp::plan(problem, quick(), cycles(200))), all_rows(plan));
}

TEST(ClaspPlan, SaysWhatIsInTheWayOfASmallHole) {
  Problem problem = ring_problem();
  problem.object = Object::from_cloud("small ring", ring_cloud(0.045, 0.03));
  Options options = quick();
  options.stability.escape_distance = 0.001;  // everything has escaped
  const std::string reason = clasp::plan(problem, options, cycles(24)).reason;
  std::smatch gap;
  ASSERT_TRUE(std::regex_search(
      reason, gap, std::regex("leaves a gap of (\\d+) mm between .*, in the test (\\d+) mm")))
      << reason;
  EXPECT_NEAR(std::stoi(gap[2]), std::stoi(gap[1]) + 6, 1);
  EXPECT_NE(reason.find("its hole is 56 mm wide, its handle 31 mm thick, a finger 27 mm"),
            std::string::npos)
      << reason;
  options = quick();
  options.stability.force = 1000;
  const std::string forced = clasp::plan(problem, options, cycles(24)).reason;
  EXPECT_NE(forced.find("a sudden load of 1000 N and 0.15 Nm forces open the others, which hold "
                        "with two fingers: they withstand "),
            std::string::npos)
      << forced;
}

/// The ring before a hand whose state "fist" is nearly closed.
Problem ring_before_a_fist() {
  Problem problem = ring_problem();
  robot::Robot::Options options = problem.robot.options();
  std::string state = R"(<group_state name="fist" group="hand">)";
  for (const int joint : problem.robot.group("hand")) {
    const double value = 0.95 * problem.robot.state("closed")[joint];
    state += "<joint name=\"" + problem.robot.joint_names()[joint] + "\" value=\"" +
             std::to_string(value) + "\"/>";
  }
  options.srdf.insert(options.srdf.find("</robot>"), state + "</group_state>");
  problem.robot = robot::Robot::from_urdf(problem.robot.urdf(), options);
  problem.hand.open = "fist";
  return problem;
}

TEST(ClaspPlan, TakesAnotherPreShapeWhereTheFirstClaspsNothing) {
  Problem problem = ring_before_a_fist();
  EXPECT_FALSE(clasp::plan(problem, quick(), cycles(60)));
  problem.hand.pre_shapes = {"open"};
  Plan plan = clasp::plan(problem, quick(), cycles(60));
  ASSERT_EQ(plan.status, Status::solved) << plan.reason;
  EXPECT_EQ(plan.pre_shape, "open");
  EXPECT_GT(plan.statistics.cycles, 20);
  EXPECT_EQ(check(problem, plan, quick()), std::vector<std::string>{});
  plan.pre_shape = "claw";
  EXPECT_EQ(check(problem, plan, quick()),
            std::vector<std::string>{"plan: its pre-shape 'claw' is none of the hand's"});
}

TEST(ClaspPlan, RefusesBadOptionsByName) {
  const auto refuses = [](auto spoil, const std::string& words) {
    Options options;
    spoil(options);
    expect_refused([&] { validate(options); }, words);
  };
  refuses([](Options& o) { o.min_linking = 1; }, "options.min_linking must lie in [0, 1), not 1");
  refuses([](Options& o) { o.targets = -1; }, "options.targets");
  refuses([](Options& o) { o.resolution = 0.02; }, "options.resolution");
  refuses([](Options& o) { o.targets = 1 << 30; }, "options.targets must lie in [0, 10000]");
  refuses([](Options& o) { o.resolution = 1e-12; }, "must lie in [0.0001, 0.01] rad, not 1e-12");
}

}  // namespace
}  // namespace graspless::clasp
