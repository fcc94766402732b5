// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Free motions by the planners' common search; motions that hold fingers still by CBiRRT over the
// positions of the held fingertips.
#include <ompl/base/goals/GoalState.h>

#include "graspless/planning/forest_cbirrt.hpp"
#include "graspless/planning/free_path.hpp"
#include "graspless/planning/vector_states.hpp"

#include "planning/joints.hpp"
#include "realize/track.hpp"

namespace graspless::realize {
namespace {

namespace ob = ompl::base;
using Configurations = planning::Path;
using planning::Joints;  // those that move fingertips

constexpr double kRange = 0.25;  // longest extension while fingers are held [rad]
constexpr int kProjections = 12;
constexpr int kShortcuts = 30;
constexpr int kDeepest = 12;  // halvings of a motion between two configurations

std::optional<Configurations> free_path(Hand& hand, const Eigen::VectorXd& from,
                                        const Eigen::VectorXd& to, int iterations,
                                        planning::Clock& clock, std::mt19937_64& rng) {
  const Joints joints{hand.ik.joints(), from};
  const robot::Robot& robot = hand.ik.robot();
  planning::FreeSpace space;
  space.lower = joints.part(robot.lower());
  space.upper = joints.part(robot.upper());
  space.is_free = [&](const Eigen::VectorXd& part) {
    return hand.scene.is_free(joints.full(part));
  };
  space.is_motion_free = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return hand.scene.is_motion_free(joints.full(a), joints.full(b), hand.options.max_jump,
                                     hand.options.resolution);
  };
  space.is_out = [&] { return clock.is_out(); };
  const auto path =
      planning::find_free_path(space, joints.part(from), joints.part(to), iterations, rng);
  if (!path) return std::nullopt;
  return planning::subdivided(joints.full(*path), hand.options.max_jump);
}

/// Motions on the manifold where the held fingertips stay where they are.
class HeldSpace {
 public:
  HeldSpace(Hand& hand, const TipTargets& held, const Joints& joints)
      : hand_(hand), held_(held), joints_(joints) {}

  bool project(Eigen::VectorXd& q) { return hand_.ik.solve(held_, kIkTolerance, kProjections, q); }

  /// Rows between two configurations near each other, without the first. Empty if the motion leaves
  /// the manifold or touches something. The same in both directions.
  std::optional<Configurations> rows(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    Configurations out;
    if (!append(a, b, kDeepest, out)) return std::nullopt;
    return out;
  }

  std::optional<Configurations> rows(const Configurations& path) {
    Configurations out{path.front()};
    for (std::size_t i = 1; i < path.size(); ++i) {
      const auto more = rows(path[i - 1], path[i]);
      if (!more) return std::nullopt;
      out.insert(out.end(), more->begin(), more->end());
    }
    return out;
  }

  std::optional<Configurations> grow(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                     int iterations, planning::Clock& clock, std::mt19937_64& rng);

 private:
  bool append(const Eigen::VectorXd& a, const Eigen::VectorXd& b, int deeper, Configurations& out) {
    const Eigen::VectorXd middle = (a + b) / 2;
    const double length = (b - a).lpNorm<Eigen::Infinity>();
    const bool is_near = length <= hand_.options.max_jump;
    if (is_near && hand_.ik.miss(held_, middle).first <= 0.8 * hand_.options.position_tolerance) {
      if (!hand_.scene.is_motion_free(a, b, hand_.options.max_jump, hand_.options.resolution)) {
        return false;
      }
      out.push_back(b);
      return true;
    }
    Eigen::VectorXd on = middle;
    if (deeper == 0 || !project(on) || !hand_.scene.is_free(on)) return false;
    if ((on - middle).lpNorm<Eigen::Infinity>() > length / 4 + 1e-6) return false;
    return append(a, on, deeper - 1, out) && append(on, b, deeper - 1, out);
  }

  Hand& hand_;
  const TipTargets& held_;
  const Joints& joints_;
};

std::optional<Configurations> HeldSpace::grow(const Eigen::VectorXd& from,
                                              const Eigen::VectorXd& to, int iterations,
                                              planning::Clock& clock, std::mt19937_64& rng) {
  const Eigen::VectorXd lower = joints_.part(hand_.ik.robot().lower());
  const Eigen::VectorXd upper = joints_.part(hand_.ik.robot().upper());
  const Eigen::Index n = lower.size();
  const auto box = planning::make_box(lower, upper);
  const auto full = [&](const ob::State* state) {
    return joints_.full(planning::vector(state, n));
  };
  const auto si = std::make_shared<ob::SpaceInformation>(box);
  si->setStateValidityChecker([&](const ob::State* s) { return hand_.scene.is_free(full(s)); });
  si->setup();
  const auto problem = std::make_shared<ob::ProblemDefinition>(si);
  ob::ScopedState<ob::RealVectorStateSpace> start(box), goal(box);
  planning::vector(start.get(), n) = joints_.part(from);
  planning::vector(goal.get(), n) = joints_.part(to);
  problem->setStartAndGoalStates(start, goal);
  planning::ForestCBiRRT planner(si);
  planner.setProblemDefinition(problem);
  planner.set_range(kRange);
  planner.set_seed(rng());
  planner.set_random_config(
      [&](std::mt19937_64& g, ob::State* s) { planning::draw_uniform(g, lower, upper, s); });
  planner.set_projector([&](ob::State* s) {
    Eigen::VectorXd q = full(s);
    if (!project(q)) return false;
    planning::vector(s, n) = joints_.part(q);
    return true;
  });
  planner.set_motion_check([&](const ob::State*, const ob::State* a, const ob::State* b) {
    return rows(full(a), full(b)).has_value();
  });
  int left = iterations;
  const ob::PlannerTerminationCondition is_over([&] { return left-- <= 0 || clock.is_out(); });
  if (!planner.solve(is_over)) return std::nullopt;
  Configurations path;
  for (const Eigen::VectorXd& part : planning::to_path(problem->getSolutionPath(), n))
    path.push_back(joints_.full(part));
  return path;
}

std::optional<Configurations> held_path(Hand& hand, const TipTargets& held,
                                        const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                        int iterations, planning::Clock& clock,
                                        std::mt19937_64& rng) {
  const Joints joints{hand.ik.joints(), from};
  HeldSpace space(hand, held, joints);
  if (const auto straight = space.rows(Configurations{from, to})) return straight;
  const auto path = space.grow(from, to, iterations, clock, rng);
  if (!path) return std::nullopt;
  const planning::Connect connect = [&](const Eigen::VectorXd& a,
                                        const Eigen::VectorXd& b) -> std::optional<Configurations> {
    if (!space.rows(a, b)) return std::nullopt;
    return Configurations{a, b};
  };
  return space.rows(planning::shortcut(*path, connect, kShortcuts, rng));
}

}  // namespace

std::optional<Configurations> reach(Hand& hand, const TipTargets& held, const Eigen::VectorXd& from,
                                    const Eigen::VectorXd& to, int iterations,
                                    planning::Clock& clock, std::mt19937_64& rng) {
  if (held.held == 0) return free_path(hand, from, to, iterations, clock, rng);
  return held_path(hand, held, from, to, iterations, clock, rng);
}

}  // namespace graspless::realize
