// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/task_space_rrt.hpp"

#include <cmath>
#include <map>
#include <set>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <ompl/base/goals/GoalRegion.h>
#include <ompl/geometric/SimpleSetup.h>

#include "graspless/planning/vector_states.hpp"

#include "complaint.hpp"

namespace graspless::planning {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

/// A planar arm of n links of equal length, 1 m in all; its task is where the tip is.
class PlanarArm {
 public:
  explicit PlanarArm(int joints) : n_(joints) {}

  /// Joints of the chain, the base first, the tip last.
  Eigen::Matrix2Xd points(const Eigen::VectorXd& q) const {
    Eigen::Matrix2Xd p = Eigen::Matrix2Xd::Zero(2, n_ + 1);
    double angle = 0;
    for (int i = 0; i < n_; ++i) {
      angle += q[i];
      p.col(i + 1) = p.col(i) + Eigen::Vector2d(std::cos(angle), std::sin(angle)) / n_;
    }
    return p;
  }
  Eigen::Vector2d tip(const Eigen::VectorXd& q) const { return points(q).col(n_); }

  /// A step of a damped pseudo-inverse, no joint by more than `max_step`.
  bool control(const Eigen::VectorXd& q, const Eigen::Vector2d& target, double max_step,
               Eigen::VectorXd& q_new) const {
    const Eigen::Matrix2Xd p = points(q);
    Eigen::Matrix2Xd J(2, n_);
    for (int i = 0; i < n_; ++i) {
      const Eigen::Vector2d r = p.col(n_) - p.col(i);
      J.col(i) << -r.y(), r.x();
    }
    const Eigen::Matrix2d A = J * J.transpose() + 1e-4 * Eigen::Matrix2d::Identity();
    Eigen::VectorXd dq = 0.5 * J.transpose() * A.inverse() * (target - p.col(n_));
    const double most = dq.cwiseAbs().maxCoeff();
    if (most < 2e-4) return false;
    if (most > max_step) dq *= max_step / most;
    q_new = q + dq;
    return true;
  }

 private:
  int n_;
};

/// Discs that no link may touch.
struct Disc {
  Eigen::Vector2d centre;
  double radius;
};

bool is_arm_free(const Eigen::Matrix2Xd& p, const std::vector<Disc>& discs) {
  for (const Disc& disc : discs) {
    for (Eigen::Index i = 0; i + 1 < p.cols(); ++i) {
      const Eigen::Vector2d a = p.col(i), d = p.col(i + 1) - a;
      const double t = std::clamp((disc.centre - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      if ((a + t * d - disc.centre).norm() < disc.radius) return false;
    }
  }
  return true;
}

/// A planar arm in OMPL's SimpleSetup.
class ArmQuery {
 public:
  ArmQuery(int joints, std::vector<Disc> discs)
      : n_(joints),
        arm_(joints),
        setup_(
            make_box(Eigen::VectorXd::Constant(joints, -3), Eigen::VectorXd::Constant(joints, 3))) {
    si_ = setup_.getSpaceInformation();
    setup_.setStateValidityChecker([this, discs](const ob::State* s) {
      ++num_checks;
      return is_arm_free(arm_.points(vector(s, n_)), discs);
    });
    si_->setStateValidityCheckingResolution(0.002);
    planner = std::make_shared<TaskSpaceRRT>(si_);
    planner->set_projection(
        [this](const ob::State* s, Eigen::VectorXd& x) { x = arm_.tip(vector(s, n_)); });
    planner->set_controller([this](const ob::State* s, const Eigen::VectorXd& x,
                                   const Eigen::VectorXd& x_target, bool is_exploring,
                                   ob::State* s_new) {
      EXPECT_EQ(x, arm_.tip(vector(s, n_)));
      if (on_control) on_control(s, x_target, is_exploring);
      Eigen::VectorXd q_new;
      if (!arm_.control(vector(s, n_), x_target, is_exploring ? 0.5 : 0.1, q_new)) return false;
      vector(s_new, n_) = q_new;
      return true;
    });
    planner->set_random_task([](std::mt19937_64& rng, Eigen::VectorXd& x) {
      std::uniform_real_distribution<double> place(-1, 1);
      x.resize(2);
      for (double& coordinate : x) coordinate = place(rng);
    });
    planner->set_tolerance([](const Eigen::VectorXd& x_target, const Eigen::VectorXd& x) {
      return (x_target - x).norm() < 0.02;
    });
    planner->set_targets({Eigen::Vector2d(-0.5, 0.1)});
    planner->set_pre_expansions(20);
    planner->set_seed(1);
    setup_.setPlanner(planner);
    start(Eigen::VectorXd::Constant(n_, 0.1));
  }

  void start(const Eigen::VectorXd& q) {
    ob::ScopedState<ob::RealVectorStateSpace> state(si_->getStateSpace());
    vector(state.get(), n_) = q;
    setup_.setStartState(state);
  }
  ob::PlannerStatus solve(double seconds = 5) { return setup_.solve(seconds); }
  Path path() { return to_path(setup_.getProblemDefinition()->getSolutionPath(), n_); }
  Eigen::Vector2d tip() { return arm_.tip(path().back()); }
  const ob::SpaceInformationPtr& si() const { return si_; }
  og::SimpleSetup& setup() { return setup_; }

  std::shared_ptr<TaskSpaceRRT> planner;
  std::function<void(const ob::State*, const Eigen::VectorXd&, bool)> on_control;
  int num_checks = 0;

 private:
  int n_;
  PlanarArm arm_;
  og::SimpleSetup setup_;
  ob::SpaceInformationPtr si_;
};

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
      if (x_target != targets[static_cast<std::size_t>(g)]) continue;
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
  EXPECT_EQ(query.solve(0.1), ob::PlannerStatus::INVALID_START);
}

TEST(TaskSpaceRRT, RefusesABadSetupByName) {
  const auto refuses = [](const std::function<void(TaskSpaceRRT&)>& spoil,
                          const std::string& words) {
    ArmQuery query(3, {});
    expect_refused(
        [&] {
          spoil(*query.planner);
          query.solve(0.1);
        },
        words);
  };
  const Eigen::Vector2d x(0, 0);
  refuses([](auto& p) { p.set_projection(nullptr); }, "set_projection()");
  refuses([](auto& p) { p.set_controller(nullptr); }, "set_controller()");
  refuses([](auto& p) { p.set_random_task(nullptr); }, "set_random_task()");
  refuses([](auto& p) { p.set_tolerance(nullptr); }, "no set_tolerance(), and no goal");
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
