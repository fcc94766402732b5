// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/forest_cbirrt.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include "graspless/planning/vector_states.hpp"

namespace graspless::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

double uniform(std::mt19937_64& rng, double a, double b) {
  return std::uniform_real_distribution<double>(a, b)(rng);
}

// --- The unit sphere in space, with a wall round the equator that has one gate; no arm anywhere.
// ---

bool is_on_sphere_free(const Eigen::Vector3d& p) {
  const bool in_wall = std::abs(p.z()) < 0.1;
  return !in_wall || std::atan2(p.y(), p.x()) > 2.6;
}

/// A cap of the sphere around a pole, with its points up to `angle` from it.
class Cap : public SampleableRegion {
 public:
  Cap(const ob::SpaceInformationPtr& si, double pole, unsigned seed)
      : SampleableRegion(si), pole_(pole), rng_(seed) {}
  bool try_sample(ob::State* state) const override {
    if (uniform(rng_, 0, 1) < 0.3) return false;  // draws may fail
    const double a = uniform(rng_, 0, 2 * M_PI), t = uniform(rng_, 0, 0.5);
    vector(state, 3) << std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), pole_ * std::cos(t);
    return true;
  }
  /// Only pairs that start and end on the same side of x = 0 are any good.
  bool isStartGoalPairValid(const ob::State* start, const ob::State* goal) const override {
    ++num_asked;
    return vector(start, 3).x() * vector(goal, 3).x() > 0;
  }
  std::optional<double> try_sample_partner(const ob::State* start, ob::State* goal,
                                           double max_cost) const override {
    do {
      if (!try_sample(goal)) return std::nullopt;
    } while (vector(start, 3).x() * vector(goal, 3).x() <= 0);
    const double cost = (vector(start, 3) - vector(goal, 3)).norm();
    if (cost >= max_cost) return std::nullopt;
    return cost;
  }
  mutable int num_asked = 0;

 private:
  double pole_;
  mutable std::mt19937_64 rng_;
};

class OnASphere : public ::testing::TestWithParam<bool> {
 protected:
  OnASphere() : setup_(make_box(Eigen::Vector3d::Constant(-1.5), Eigen::Vector3d::Constant(1.5))) {
    si_ = setup_.getSpaceInformation();
    setup_.setStateValidityChecker(
        [](const ob::State* s) { return is_on_sphere_free(vector(s, 3)); });
    setup_.setGoal(goal_ = std::make_shared<Cap>(si_, -1, 2));
    planner_ = std::make_shared<ForestCBiRRT>(si_);
    planner_->set_start_region(std::make_shared<Cap>(si_, 1, 1));
    planner_->set_range(0.1);
    planner_->set_connect_first(GetParam());
    planner_->set_projector([](ob::State* s) {
      auto p = vector(s, 3);
      if (p.norm() < 1e-3) return false;
      if (std::abs(p.norm() - 1) > 1e-12) p /= p.norm();
      return true;
    });
    planner_->set_random_config([](std::mt19937_64& rng, ob::State* s) {
      draw_uniform(rng, Eigen::Vector3d::Constant(-1.5), Eigen::Vector3d::Constant(1.5), s);
    });
    planner_->set_motion_check([](const ob::State*, const ob::State* a, const ob::State* b) {
      for (int i = 1; i <= 10; ++i) {
        const Eigen::Vector3d p = vector(a, 3) + (vector(b, 3) - vector(a, 3)) * i / 10;
        if (!is_on_sphere_free(p.normalized())) return false;
      }
      return true;
    });
    setup_.setPlanner(planner_);
    // SimpleSetup wants a start state although the planner has a region; a given start is a root
    // like any other.
    ob::ScopedState<ob::RealVectorStateSpace> start(si_->getStateSpace());
    vector(start.get(), 3) << 0, 0, 1;
    setup_.setStartState(start);
  }

  Path solve(std::uint64_t seed) {
    planner_->clear();
    setup_.getProblemDefinition()->clearSolutionPaths();
    planner_->set_seed(seed);
    if (!setup_.solve(5.0)) return {};
    return to_path(setup_.getProblemDefinition()->getSolutionPath(), 3);
  }

  og::SimpleSetup setup_;
  ob::SpaceInformationPtr si_;
  std::shared_ptr<Cap> goal_;
  std::shared_ptr<ForestCBiRRT> planner_;
};

TEST_P(OnASphere, FindsTheGateBetweenValidPairs) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Path path = solve(seed);
    ASSERT_FALSE(path.empty()) << "seed " << seed;
    EXPECT_GT(path.front().x() * path.back().x(), 0);
    EXPECT_GT(path.front().z(), std::cos(0.5) - 1e-9);
    EXPECT_LT(path.back().z(), -std::cos(0.5) + 1e-9);
    for (std::size_t i = 0; i < path.size(); ++i) {
      EXPECT_NEAR(path[i].norm(), 1, 1e-9);
      EXPECT_TRUE(is_on_sphere_free(path[i]));
      const Eigen::VectorXd& before = path[i > 0 ? i - 1 : 0];
      EXPECT_LE((path[i] - before).norm(), 0.2 + 1e-9);
    }
  }
  EXPECT_GT(goal_->num_asked, 0);
}

TEST_P(OnASphere, ConnectsOneGivenStartWithManyGoals) {
  planner_->set_start_region(nullptr);
  ob::ScopedState<ob::RealVectorStateSpace> start(si_->getStateSpace());
  const Eigen::Vector3d given(std::sin(0.2), 0, std::cos(0.2));
  vector(start.get(), 3) = given;
  setup_.setStartState(start);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Path path = solve(seed);
    ASSERT_FALSE(path.empty()) << seed;
    EXPECT_EQ(path.front(), given);
    EXPECT_GT(path.back().x(), 0);
    EXPECT_EQ(planner_->num_start_roots(), 1U);
  }
}

TEST_P(OnASphere, PlannerDataIsTheForest) {
  ASSERT_FALSE(solve(1).empty());
  ob::PlannerData data(si_);
  planner_->getPlannerData(data);
  EXPECT_EQ(data.numStartVertices(), planner_->num_start_roots());
  EXPECT_EQ(data.numGoalVertices(), planner_->num_goal_roots());
  EXPECT_EQ(data.numVertices(), planner_->num_nodes());
  EXPECT_EQ(data.numEdges(),
            planner_->num_nodes() - planner_->num_start_roots() - planner_->num_goal_roots());
}

TEST_P(OnASphere, ClearForgetsEverything) {
  ASSERT_FALSE(solve(1).empty());
  planner_->clear();
  EXPECT_EQ(planner_->num_nodes(), 0u);
  EXPECT_EQ(planner_->num_pairs(), 0u);
  EXPECT_FALSE(solve(2).empty());
}

INSTANTIATE_TEST_SUITE_P(ForestCBiRRT, OnASphere, ::testing::Values(false, true),
                         [](const auto& info) {
                           return info.param ? "ConnectFirst" : "Algorithm1";
                         });

// --- SE(2) with plain OMPL pieces only: start state, goal states, OMPL's sampler and motion
// validator. ---

TEST(ForestCBiRRT, RunsInSE2WithOmplsOwnPieces) {
  auto space = std::make_shared<ob::SE2StateSpace>();
  ob::RealVectorBounds bounds(2);
  bounds.setLow(-1);
  bounds.setHigh(1);
  space->setBounds(bounds);
  og::SimpleSetup setup(space);
  const auto is_free = [](const ob::State* s) {
    const auto* p = s->as<ob::SE2StateSpace::StateType>();
    return std::abs(p->getX()) > 0.1 || p->getY() > 0.6;
  };
  setup.setStateValidityChecker(is_free);
  ob::ScopedState<ob::SE2StateSpace> start(space), goal(space), other(space);
  start->setXY(-0.5, -0.5);
  start->setYaw(0);
  goal->setXY(0.5, -0.5);
  goal->setYaw(3);
  other->setXY(0.5, 0.5);
  other->setYaw(-2);
  auto goals = std::make_shared<ob::GoalStates>(setup.getSpaceInformation());
  goals->addState(goal);
  goals->addState(other);
  setup.setStartState(start);
  setup.setGoal(goals);
  auto planner = std::make_shared<ForestCBiRRT>(setup.getSpaceInformation());
  setup.setPlanner(planner);
  ASSERT_EQ(setup.solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
  EXPECT_TRUE(setup.getSolutionPath().check());
  EXPECT_EQ(planner->num_start_roots(), 1u);
  EXPECT_LE(planner->num_goal_roots(), 2u);
}

ob::SpaceInformationPtr open_square() {
  auto si = std::make_shared<ob::SpaceInformation>(
      make_box(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1)));
  si->setStateValidityChecker([](const ob::State*) { return true; });
  si->setup();
  return si;
}

TEST(ForestCBiRRT, SaysWhichEndHasNoRoot) {
  const auto si = open_square();
  class Empty : public SampleableRegion {
   public:
    using SampleableRegion::SampleableRegion;
    bool try_sample(ob::State*) const override { return false; }
  };
  auto problem = std::make_shared<ob::ProblemDefinition>(si);
  problem->setGoal(std::make_shared<Empty>(si));
  ForestCBiRRT planner(si);
  planner.setProblemDefinition(problem);
  EXPECT_THROW(planner.solve(ob::timedPlannerTerminationCondition(0.01)), ompl::Exception);
  planner.set_start_region(std::make_shared<Empty>(si));
  EXPECT_EQ(planner.solve(ob::timedPlannerTerminationCondition(0.01)),
            ob::PlannerStatus::INVALID_START);
  ob::ScopedState<ob::RealVectorStateSpace> start(si->getStateSpace());
  vector(start.get(), 2).setZero();
  problem->addStartState(start);
  EXPECT_EQ(planner.solve(ob::timedPlannerTerminationCondition(0.01)),
            ob::PlannerStatus::INVALID_GOAL);
}

/// Goals are found at once and end all further draws, by Eq. (5); a start is found late.
TEST(ForestCBiRRT, DrawsForAnEmptyForestHoweverManyRootsTheOtherHas) {
  const auto si = open_square();
  class Late : public SampleableRegion {
   public:
    Late(const ob::SpaceInformationPtr& given, double x, int draws)
        : SampleableRegion(given), x_(x), draws_(draws) {}
    bool try_sample(ob::State* state) const override {
      vector(state, 2) << x_, 0;
      return --draws_ < 0;
    }

   private:
    double x_;
    mutable int draws_;
  };
  auto problem = std::make_shared<ob::ProblemDefinition>(si);
  problem->setGoal(std::make_shared<Late>(si, 0.5, 0));
  ForestCBiRRT planner(si);
  planner.setProblemDefinition(problem);
  planner.set_start_region(std::make_shared<Late>(si, -0.5, 1000));
  planner.set_root_scale(0.1);
  planner.set_range(0.2);
  int iterations = 0;
  EXPECT_TRUE(planner.solve(
      ob::PlannerTerminationCondition([&iterations] { return ++iterations > 10000; })));
}

TEST(ForestCBiRRT, IsRepeatable) {
  const auto run = [](std::uint64_t seed) {
    auto si = std::make_shared<ob::SpaceInformation>(
        make_box(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1)));
    si->setStateValidityChecker([](const ob::State* s) {
      return std::abs(vector(s, 2).x()) > 0.1 || vector(s, 2).y() > 0.8;
    });
    si->setup();
    auto problem = std::make_shared<ob::ProblemDefinition>(si);
    ob::ScopedState<ob::RealVectorStateSpace> start(si->getStateSpace()), goal(si->getStateSpace());
    vector(start.get(), 2) << -0.5, -0.5;
    vector(goal.get(), 2) << 0.5, -0.5;
    problem->setStartAndGoalStates(start, goal);
    ForestCBiRRT planner(si);
    planner.setProblemDefinition(problem);
    planner.set_seed(seed);
    planner.set_range(0.2);
    planner.set_random_config([](std::mt19937_64& rng, ob::State* s) {
      draw_uniform(rng, Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1), s);
    });
    EXPECT_TRUE(planner.solve(ob::timedPlannerTerminationCondition(10)));
    return to_path(problem->getSolutionPath(), 2);
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4));
}

/// Starts left, goals right, with the distance as the cost of a pair.
class Side : public SampleableRegion {
 public:
  Side(const ob::SpaceInformationPtr& si, double x) : SampleableRegion(si), x_(x), rng_(7) {}
  bool try_sample(ob::State* state) const override {
    ++num_drawn;
    vector(state, 2) << x_, uniform(rng_, -1, 1);
    return uniform(rng_, 0, 1) < 0.7;
  }
  std::optional<double> try_sample_partner(const ob::State* start, ob::State* goal,
                                           double max_cost) const override {
    for (int i = 0; i < 3; ++i) {
      vector(goal, 2) << x_, uniform(rng_, -1, 1);
      const double cost = (vector(start, 2) - vector(goal, 2)).norm();
      all_costs.push_back(cost);
      if (cost < max_cost) return cost;
    }
    return std::nullopt;
  }
  bool isStartGoalPairValid(const ob::State* start, const ob::State* goal) const override {
    asked.push_back((vector(start, 2) - vector(goal, 2)).norm());
    return asked.size() > num_refused;
  }
  mutable int num_drawn = 0;
  std::size_t num_refused = 0;
  mutable std::vector<double> all_costs, asked;

 private:
  double x_;
  mutable std::mt19937_64 rng_;
};

TEST(ForestCBiRRT, ConnectsTheCheapestPairOfTheFirstStartsFirst) {
  const auto si = open_square();
  const auto starts = std::make_shared<Side>(si, -1);
  const auto goals = std::make_shared<Side>(si, 1);
  goals->num_refused = 2;
  auto problem = std::make_shared<ob::ProblemDefinition>(si);
  problem->setGoal(goals);
  ForestCBiRRT planner(si);
  planner.setProblemDefinition(problem);
  planner.set_start_region(starts);
  planner.set_connect_first(true);
  ASSERT_TRUE(planner.solve(ob::timedPlannerTerminationCondition(10)));
  EXPECT_EQ(planner.num_start_roots(), ForestCBiRRT::kCompared);
  EXPECT_GT(starts->num_drawn, ForestCBiRRT::kCompared);  // draws that failed do not count
  ASSERT_EQ(goals->asked.size(), 3U);
  EXPECT_EQ(goals->asked[0], *std::min_element(goals->all_costs.begin(), goals->all_costs.end()));
  EXPECT_TRUE(std::is_sorted(goals->asked.begin(), goals->asked.end()));
}

TEST(ForestCBiRRT, RefusesNonsense) {
  auto si = std::make_shared<ob::SpaceInformation>(
      make_box(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1)));
  ForestCBiRRT planner(si);
  EXPECT_THROW(planner.set_root_scale(0), std::invalid_argument);
  EXPECT_THROW(planner.set_range(-1), std::invalid_argument);
}

}  // namespace
}  // namespace graspless::planning
