// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The integrated planner of Section IV-C: ForestCBiRRT (Algorithm 1) over the arm's joints, with
// C_s of Eq. (3), C_g of Eq. (4), the relaxed contact constraint, and IsPairValid.
#include <ompl/base/SpaceInformation.h>

#include "graspless/planning/forest_cbirrt.hpp"
#include "graspless/planning/vector_states.hpp"

#include "slide/assemble.hpp"
#include "slide/motions.hpp"
#include "slide/query.hpp"
#include "slide/regions.hpp"

namespace graspless::slide {

namespace ob = ompl::base;
using planning::vector;

namespace {

constexpr int kShortcutRounds = 30;
constexpr double kCoarse =
    0.05;  // joint step while trees grow [rad]; a path found is checked at options.resolution

/// Everything OMPL needs for one query.
struct Setup {
  ob::SpaceInformationPtr si;
  std::shared_ptr<ob::ProblemDefinition> problem;
  std::shared_ptr<StartRegion> start_region;
  std::shared_ptr<GoalRegion> goal_region;
  std::shared_ptr<planning::ForestCBiRRT> planner;
};

Setup make_setup(Query& query, Motions& motions) {
  const int n = query.arm.dof();
  Setup s;
  s.si = std::make_shared<ob::SpaceInformation>(
      planning::make_box(query.arm.lower(), query.arm.upper()));
  s.si->setStateValidityChecker([&query, n](const ob::State* q) {
    return query.contact.is_valid(vector(q, n), std::nullopt);
  });
  s.si->setup();
  s.start_region = std::make_shared<StartRegion>(s.si, query);
  s.goal_region = std::make_shared<GoalRegion>(s.si, query, motions);
  s.problem = std::make_shared<ob::ProblemDefinition>(s.si);
  s.problem->setGoal(s.goal_region);

  s.planner = std::make_shared<planning::ForestCBiRRT>(s.si);
  s.planner->setProblemDefinition(s.problem);
  s.planner->set_start_region(s.start_region);
  s.planner->set_root_scale(query.options.root_scale);
  s.planner->set_range(query.options.range);
  s.planner->set_seed(query.rng());
  s.planner->set_connect_first(query.options.search == slide::Search::fast);
  s.planner->set_random_config([&query](std::mt19937_64& rng, ob::State* q) {
    planning::draw_uniform(rng, query.arm.lower(), query.arm.upper(), q);
  });
  s.planner->set_projector([&query, n, arm = Eigen::VectorXd(n)](ob::State* q) mutable {
    arm = vector(q, n);
    const bool projected = query.contact.project(arm);
    vector(q, n) = arm;
    return projected;
  });
  s.planner->set_motion_check(
      [&query, n](const ob::State* start, const ob::State* a, const ob::State* b) {
        std::optional<ContactSpace::Carried> carried;
        if (start) carried = query.carried_from(vector(start, n));
        return query.contact.is_motion_valid(vector(a, n), vector(b, n), carried, kCoarse);
      });
  s.planner->set_path_check([&query, n](const std::vector<ob::State*>& path) {
    const auto carried = query.carried_from(vector(path.front(), n));
    for (std::size_t i = 1; i < path.size(); ++i) {
      if (!query.contact.is_motion_valid(vector(path[i - 1], n), vector(path[i], n), carried,
                                         query.options.resolution)) {
        query.refuse("path: lost between its nodes");
        return false;
      }
    }
    return true;
  });
  return s;
}

/// Whether a path is much longer than the straight way: one that came from a tree.
bool is_detour(const planning::Path& path) {
  return planning::length(path) > 1.2 * (path.back() - path.front()).norm();
}

/// Shortens the slide while it keeps the constraint.
planning::Path shortened(Query& query, planning::Path path) {
  const ContactSpace::Carried carried = query.carried_from(path.front());
  const planning::Connect connect =
      [&](const Eigen::VectorXd& from, const Eigen::VectorXd& to) -> std::optional<planning::Path> {
    if (query.clock.is_out()) return std::nullopt;
    return query.contact.connect(from, to, carried);
  };
  return planning::shortcut(std::move(path), connect, kShortcutRounds, query.rng);
}

Status status_of(const ob::PlannerStatus& status, Query& query,
                 const planning::ForestCBiRRT& planner) {
  if (query.clock.was_interrupted()) return Status::interrupted;
  if (status == ob::PlannerStatus::INVALID_START) return Status::no_start_root;
  if (status == ob::PlannerStatus::INVALID_GOAL) return Status::no_goal_root;
  return planner.num_pairs() > 0 ? Status::no_valid_pair : Status::not_connected;
}

void count(const planning::ForestCBiRRT& planner, Query& query, Statistics& statistics) {
  statistics = query.statistics;
  statistics.seconds = query.clock.seconds();
  statistics.iterations = query.clock.iterations();
  statistics.nodes = static_cast<std::int64_t>(planner.num_nodes());
  statistics.start_roots = static_cast<std::int64_t>(planner.num_start_roots());
  statistics.goal_roots = static_cast<std::int64_t>(planner.num_goal_roots());
  statistics.collision_checks = query.contact.num_checks() + query.free.world().num_checks();
  statistics.projections = query.contact.num_projections();
}

}  // namespace

Plan plan(const Problem& problem, const Options& options, const planning::Budget& budget) {
  validate(problem, options);
  Query query(problem, options, budget);
  Plan plan;
  plan.joint_names = problem.robot.joint_names();
  if (!is_home_free(query, plan)) return plan;

  Motions motions(query);
  Setup search = make_setup(query, motions);
  const ob::PlannerStatus status =
      search.planner->solve(ob::PlannerTerminationCondition([&] { return !query.clock.spend(); }));
  if (status == ob::PlannerStatus::EXACT_SOLUTION) {
    planning::Path slide = planning::to_path(search.problem->getSolutionPath(), query.arm.dof());
    if (options.shortcut && is_detour(slide)) slide = shortened(query, std::move(slide));
    assemble(query, motions, slide, plan);
  } else {
    plan.status = status_of(status, query, *search.planner);
  }
  count(*search.planner, query, plan.statistics);
  plan.reason = reason(plan);
  return plan;
}

}  // namespace graspless::slide
