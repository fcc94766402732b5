// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/task_space_rrt.hpp"

#include <cmath>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <ompl/base/goals/GoalRegion.h>

#include "complaint.hpp"
#include "planar_arm.hpp"

namespace graspless::planning {
namespace {

/// A disc that the arm runs into where the controller alone leads it to (-0.5, 0.1).
const std::vector<Disc> kObstacle{{{0.3, 0.25}, 0.12}};
/// The target walled in.
const std::vector<Disc> kWalls{{{-0.5, 0.1}, 0.1}};

class TaskSpaceRRTArm : public ::testing::TestWithParam<int> {};

TEST_P(TaskSpaceRRTArm, ReachesATargetInOneCycleWhereNothingIsInTheWay) {
  ArmQuery query(GetParam(), {});
  query.planner->set_random_probability(0);
  ASSERT_EQ(query.solve(), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_LT((query.tip() - Eigen::Vector2d(-0.5, 0.1)).norm(), 0.02);
  EXPECT_EQ(query.planner->num_cycles(), 1);
  EXPECT_EQ(query.planner->reached_target(), 0);
  EXPECT_EQ(query.path().front(), Eigen::VectorXd::Constant(GetParam(), 0.1));
}

TEST_P(TaskSpaceRRTArm, FindsAWayRoundAnObstacle) {
  ArmQuery control_alone(GetParam(), kObstacle);
  control_alone.planner->set_pre_expansions(0);
  control_alone.planner->set_random_probability(0);
  control_alone.planner->set_max_iterations(1);
  EXPECT_FALSE(control_alone.solve());
  for (unsigned seed = 1; seed <= 10; ++seed) {
    ArmQuery query(GetParam(), kObstacle);
    query.planner->set_seed(seed);
    ASSERT_EQ(query.solve(), ob::PlannerStatus::EXACT_SOLUTION) << "seed " << seed;
    EXPECT_TRUE(query.setup().getSolutionPath().check());
    EXPECT_LT((query.tip() - Eigen::Vector2d(-0.5, 0.1)).norm(), 0.02);
  }
}

TEST_P(TaskSpaceRRTArm, SameSeedSamePath) {
  const auto run = [](std::uint64_t seed) {
    ArmQuery query(GetParam(), kObstacle);
    query.planner->set_seed(seed);
    EXPECT_TRUE(query.solve());
    return query.path();
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

INSTANTIATE_TEST_SUITE_P(Joints, TaskSpaceRRTArm, ::testing::Values(3, 10),
                         ::testing::PrintToStringParamName());

TEST(TaskSpaceRRT, WithoutAToleranceTheGoalOfTheProblemEndsTheSearch) {
  class TipNear : public ob::GoalRegion {
   public:
    using GoalRegion::GoalRegion;
    double distanceGoal(const ob::State* s) const override {
      return std::max(0.0,
                      (PlanarArm(3).tip(vector(s, 3)) - Eigen::Vector2d(-0.5, 0.1)).norm() - 0.1);
    }
  };
  ArmQuery query(3, {});
  query.planner->set_tolerance(nullptr);
  query.setup().setGoal(std::make_shared<TipNear>(query.si()));
  ASSERT_EQ(query.solve(), ob::PlannerStatus::EXACT_SOLUTION);
  const double distance = (query.tip() - Eigen::Vector2d(-0.5, 0.1)).norm();
  EXPECT_LE(distance, 0.1);
  EXPECT_GT(distance, 0.02);  // the tolerance of the other tests was not asked
}

TEST(TaskSpaceRRT, AStartAtTheGoalIsAPathOfOneState) {
  ArmQuery query(3, {});
  query.planner->set_targets(
      {Eigen::Vector2d(5, 5), PlanarArm(3).tip(Eigen::Vector3d::Constant(0.1))});
  ASSERT_TRUE(query.solve());
  EXPECT_EQ(query.path().size(), 1u);
  EXPECT_EQ(query.planner->reached_target(), 1);
  EXPECT_EQ(query.planner->num_cycles(), 0);
}

TEST(TaskSpaceRRT, LeadsNoNodeTwiceTowardsOneTarget) {
  ArmQuery query(3, kWalls);
  std::vector<Eigen::VectorXd> targets{Eigen::Vector2d(-0.5, 0.1), Eigen::Vector2d(-0.52, 0.12),
                                       Eigen::Vector2d(2, 2)};
  query.planner->set_targets(targets);
  query.planner->set_restart_cycles(0);
  query.planner->set_max_iterations(150);
  std::map<int, std::set<const ob::State*>> led;
  int connections = 0;
  query.on_control = [&](const ob::State* q, const Eigen::VectorXd& x_target, bool is_exploring) {
    if (is_exploring) return;
    ++connections;
    for (int g = 0; g < 3; ++g) {
      if (x_target != targets[g]) continue;
      EXPECT_TRUE(led[g].insert(q).second) << "target " << g;
    }
  };
  EXPECT_EQ(query.solve(), ob::PlannerStatus::TIMEOUT);
  EXPECT_GT(connections, 100);
  EXPECT_EQ(query.planner->num_cycles(), 150);
}

TEST(TaskSpaceRRT, CountsItsTrees) {
  ArmQuery query(3, kWalls);
  query.planner->set_restart_cycles(7);
  query.planner->set_max_iterations(50);
  query.planner->set_pre_expansion_schedule({0, 5, 30});
  int explored = 0;
  query.planner->set_random_probability(0);
  query.on_control = [&](const ob::State*, const Eigen::VectorXd&, bool is_exploring) {
    explored += is_exploring;
  };
  EXPECT_EQ(query.solve(), ob::PlannerStatus::TIMEOUT);
  EXPECT_EQ(query.planner->num_restarts(), 7);  // trees of 7 cycles; the eighth has one
  EXPECT_EQ(explored, 0 + 5 + 6 * 30);
  EXPECT_GT(query.planner->num_nodes_grown(),
            static_cast<std::int64_t>(query.planner->num_nodes()));
}

TEST(TaskSpaceRRT, SolvingAgainGoesOnAndDoesNotReturnTheSameClasp) {
  ArmQuery query(3, {});
  query.planner->set_targets({Eigen::Vector2d(-0.5, 0.1), Eigen::Vector2d(0.1, -0.5)});
  std::set<std::vector<double>> ends;
  for (int i = 0; i < 4; ++i) {
    ASSERT_EQ(query.solve(), ob::PlannerStatus::EXACT_SOLUTION);
    const Eigen::VectorXd end = query.path().back();
    query.setup().getProblemDefinition()->clearSolutionPaths();
    EXPECT_TRUE(ends.insert({end.begin(), end.end()}).second);
  }
  EXPECT_EQ(query.planner->num_restarts(), 0);
}

TEST(TaskSpaceRRT, TheTreeIsPlannerDataAndNodes) {
  ArmQuery query(3, kObstacle);
  ASSERT_TRUE(query.solve());
  ob::PlannerData data(query.si());
  query.planner->getPlannerData(data);
  const std::size_t n = query.planner->num_nodes();
  EXPECT_EQ(data.numVertices(), n);
  EXPECT_EQ(data.numEdges(), n - 1);
  EXPECT_EQ(data.numStartVertices(), 1u);
  EXPECT_EQ(data.numGoalVertices(), 1u);
  for (std::size_t i = 0; i < n; ++i) {
    const auto node = query.planner->node(i);
    EXPECT_EQ(node.x, PlanarArm(3).tip(vector(node.state, 3)));
    EXPECT_EQ(node.parent == static_cast<int>(i), i == 0);
    EXPECT_LE(node.parent, static_cast<int>(i));
  }
  std::vector<int> way{query.planner->reached_node()};
  while (way.back() != 0)
    way.push_back(query.planner->node(static_cast<std::size_t>(way.back())).parent);
  EXPECT_EQ(way.size(), query.path().size());
  EXPECT_THROW(query.planner->node(n), std::out_of_range);
}

TEST(TaskSpaceRRT, ClearForgetsEverything) {
  ArmQuery query(3, kObstacle);
  ASSERT_TRUE(query.solve());
  query.planner->clear();
  EXPECT_EQ(query.planner->num_nodes(), 0u);
  EXPECT_EQ(query.planner->num_nodes_grown(), 0);
  EXPECT_EQ(query.planner->num_cycles(), 0);
  EXPECT_EQ(query.planner->num_steps(), 0);
  EXPECT_EQ(query.planner->reached_target(), -1);
  EXPECT_TRUE(query.solve());
}

TEST(TaskSpaceRRT, TheTerminationConditionIsAskedAtEveryStep) {
  ArmQuery query(3, {});
  query.planner->set_pre_expansions(0);
  query.planner->set_random_probability(0);
  query.setup().setup();
  query.planner->setProblemDefinition(query.setup().getProblemDefinition());
  int asked = 0;
  const ob::PlannerTerminationCondition third([&] { return ++asked > 4; });
  EXPECT_EQ(query.planner->solve(third), ob::PlannerStatus::TIMEOUT);
  EXPECT_LE(query.planner->num_steps(), 4);
  EXPECT_EQ(query.planner->solve(ob::plannerAlwaysTerminatingCondition()),
            ob::PlannerStatus::TIMEOUT);
}

TEST(TaskSpaceRRT, AConnectionEndsWithoutProgress) {
  ArmQuery query(3, {});
  query.planner->set_targets({Eigen::Vector2d(5, 0)});  // beyond the arm: damping never stalls
  query.planner->set_random_probability(0);
  query.planner->set_pre_expansions(0);
  query.planner->set_restart_cycles(0);
  query.planner->set_max_iterations(3);
  query.planner->set_max_connect_steps(100000);
  EXPECT_EQ(query.solve(), ob::PlannerStatus::TIMEOUT);
  EXPECT_LT(query.planner->num_steps(), 10000);
}

TEST(TaskSpaceRRT, SaysWhenThereIsNoStart) {
  ArmQuery query(3, {{{0.5, 0}, 0.9}});  // the start lies in the disc
  EXPECT_EQ(query.solve(), ob::PlannerStatus::INVALID_START);
}

TEST(TaskSpaceRRT, RefusesABadSetupByName) {
  const auto refuses = [](const std::function<void(TaskSpaceRRT&)>& spoil,
                          const std::string& words) {
    ArmQuery query(3, {});
    expect_refused(
        [&] {
          spoil(*query.planner);
          query.solve();
        },
        words);
  };
  const Eigen::Vector2d x(0, 0);
  refuses([](auto& p) { p.set_projection(nullptr); }, "set_projection()");
  refuses([](auto& p) { p.set_controller(nullptr); }, "set_controller()");
  refuses([](auto& p) { p.set_random_task(nullptr); }, "set_random_task()");
  refuses([](auto& p) { p.set_tolerance(nullptr); }, "needs set_tolerance() or a goal");
  refuses([](auto& p) { p.set_targets({}); }, "no target");
  refuses(
      [&](auto& p) {
        p.set_targets({x, Eigen::Vector3d::Zero()});
      },
      "targets[1] has 3 coordinates, targets[0] 2");
  refuses([&](auto& p) { p.set_targets({x, x * std::nan("")}); }, "targets[1] is not finite");
  refuses([](auto& p) { p.set_targets({Eigen::Vector3d::Zero()}); },
          "the projection has 2 coordinates, the targets 3");
  refuses([](auto& p) { p.set_weights(Eigen::Vector3d::Ones()); },
          "weights has 3 coordinates, the targets 2");
  refuses([](auto& p) { p.set_weights(Eigen::Vector2d(1, -1)); }, "weights must be");
  refuses(
      [](auto& p) {
        p.set_random_task([](std::mt19937_64&, Eigen::VectorXd& x) { x.setZero(1); });
      },
      "random_task has 1 coordinates");
  refuses([](auto& p) { p.set_random_probability(1); }, "random_probability must lie in [0, 1)");
  refuses([](auto& p) { p.set_pre_expansions(-1); }, "pre_expansions");
  refuses([](auto& p) { p.set_pre_expansion_schedule({}); }, "pre_expansions");
  refuses([](auto& p) { p.set_max_iterations(-1); }, "max_iterations");
  refuses([](auto& p) { p.set_restart_cycles(-1); }, "restart_cycles");
  refuses([](auto& p) { p.set_max_connect_steps(0); }, "max_connect_steps");
}

}  // namespace
}  // namespace graspless::planning
