// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/search.hpp"

#include "graspless/planning/vector_states.hpp"

#include "slide/assemble.hpp"

namespace graspless::slide {

namespace ob = ompl::base;
using planning::vector;

namespace {

// Joint step of checks while trees grow [rad]; a path that is found is checked again at
// options.resolution.
constexpr double kCoarse = 0.05;

planning::Path to_path(const std::vector<ob::State*>& states, int n) {
  planning::Path path;
  for (const ob::State* state : states) path.emplace_back(vector(state, n));
  return path;
}

}  // namespace

ob::SpaceInformationPtr make_space(Query& query) {
  auto si = std::make_shared<ob::SpaceInformation>(
      planning::make_box(query.arm.lower(), query.arm.upper()));
  si->setStateValidityChecker([&query, n = query.arm.dof()](const ob::State* q) {
    return query.contact.is_valid(vector(q, n), std::nullopt);
  });
  si->setup();
  return si;
}

SlideSearch make_search(Query& query, const ob::SpaceInformationPtr& si,
                        std::shared_ptr<const ob::GoalSampleableRegion> starts,
                        std::shared_ptr<ob::GoalSampleableRegion> goals) {
  const int n = query.arm.dof();
  SlideSearch s;
  s.problem = std::make_shared<ob::ProblemDefinition>(si);
  s.problem->setGoal(std::move(goals));

  s.planner = std::make_shared<planning::ForestCBiRRT>(si);
  s.planner->setProblemDefinition(s.problem);
  s.planner->set_start_region(std::move(starts));
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
    return query.is_lag_small(slid_along(query, to_path(path, n)));
  });
  return s;
}

}  // namespace graspless::slide
