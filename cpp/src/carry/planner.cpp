// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>

#include "graspless/planning/path.hpp"

#include "carry/place_search.hpp"
#include "carry/search.hpp"
#include "planning/obstruction.hpp"
#include "planning/plan_within.hpp"
#include "scene/rows.hpp"

namespace graspless::carry {
namespace {

Segment assemble(const Search& search, const std::vector<Eigen::VectorXd>& path) {
  Segment segment{"carry", planning::subdivided(path, scene::kRowStep, search.step_weights()), {}};
  for (const Eigen::VectorXd& q : segment.positions)
    segment.object_poses.push_back(search.object_at(q));
  return segment;
}

/// One sentence: how far the search came, and what stopped it most often.
std::string failure(const Search& search, const Statistics& statistics, bool is_unfinished) {
  std::ostringstream text;
  text.precision(3);
  const StraightPath& path = search.object_path();
  text << "the arm follows only " << search.reached() * 100 << " % of the straight path of ";
  if (path.distance() > 1e-6) {
    text << path.distance() << " m";
  } else {
    text << path.angle() << " rad";
  }
  return text.str() + planning::obstruction(statistics.refusals, is_unfinished);
}

Plan searched(const Problem& problem, const Options& options, planning::Clock& clock,
              std::uint64_t seed) {
  validate(problem);
  validate(options);
  if (problem.places) {
    Plan plan;
    PlaceSearch search(problem, options, clock, seed);
    search.run(plan);
    plan.statistics = search.statistics();
    return plan;
  }
  Search search(problem, options, clock);
  Plan plan;
  if (const auto [a, b] = search.touching_at_start(); !a.empty()) {
    plan.status = Status::start_in_collision;
    plan.reason = "at the start, " + planning::contact(a, b);
  } else if (const auto path = search.run(); !path.empty()) {
    plan.status = Status::solved;
    plan.segments = {assemble(search, path)};
  } else {
    plan.reason = failure(search, search.statistics(), clock.ran_out());
    plan.status = clock.was_interrupted() ? Status::interrupted : Status::not_found;
  }
  plan.reached = search.reached();
  plan.statistics = search.statistics();
  return plan;
}

}  // namespace

Plan plan(const Problem& problem, const Options& options, const planning::Budget& budget) {
  planning::Clock clock(budget, options.max_memory);
  Plan plan = planning::plan_within(clock, "a larger options.step",
                                    [&] { return searched(problem, options, clock, budget.seed); });
  plan.statistics.iterations = clock.iterations();
  plan.joint_names = problem.robot.joint_names();
  return plan;
}

}  // namespace graspless::carry
