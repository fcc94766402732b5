// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/assemble.hpp"

#include <algorithm>
#include <sstream>

#include "clasp/close.hpp"
#include "clasp/tasks.hpp"

namespace graspless::clasp {

using planning::Path;

namespace {

/// The randomised path pruning of Section IV-D. Both ends stay where they are.
Path pruned(Query& query, Path path) {
  std::vector<std::pair<Eigen::VectorXd, Eigen::VectorXd>> refused;  // are drawn again and again
  const planning::Connect straight = [&](const Eigen::VectorXd& a,
                                         const Eigen::VectorXd& b) -> std::optional<Path> {
    const auto pair = std::make_pair(a, b);
    if (query.clock.is_out() || std::count(refused.begin(), refused.end(), pair) > 0)
      return std::nullopt;
    if (query.is_motion_free(a, b)) return Path{a, b};
    refused.push_back(pair);
    return std::nullopt;
  };
  return planning::shortcut(std::move(path), straight, query.options.shortcut_rounds, query.rng);
}

Segment segment(const std::string& name, const Path& path, Tasks& tasks) {
  Segment segment{name, planning::subdivided(path, kRowStep), {}};
  const auto rows = static_cast<Eigen::Index>(segment.positions.size());
  segment.virtual_linking.resize(tasks.kinematics().num_curves(), rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    tasks.project(segment.positions[static_cast<std::size_t>(i)]);
    segment.virtual_linking.col(i) = tasks.linking_of_curves();
  }
  return segment;
}

std::string most_frequent(const std::map<std::string, std::int64_t>& refusals) {
  std::vector<std::pair<std::int64_t, std::string>> sorted;
  for (const auto& [why, times] : refusals) sorted.emplace_back(times, why);
  std::sort(sorted.rbegin(), sorted.rend());
  std::ostringstream out;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, sorted.size()); ++i) {
    out << (i ? ", " : "; most often: ") << sorted[i].second << " (" << sorted[i].first << ")";
  }
  return out.str();
}

std::string reason(const Plan& plan) {
  std::ostringstream out;
  switch (plan.status) {
    case Status::solved:
      out << "loop " << plan.loop << " clasped after " << plan.statistics.cycles << " cycles";
      break;
    case Status::interrupted:
      out << "interrupted after " << plan.statistics.cycles << " cycles";
      break;
    case Status::not_secure:
      out << "clasps were found, but the object came free of all "
          << plan.statistics.stability_tests << " in the stability test";
      break;
    default:
      out << "no motion to a clasp found in " << plan.statistics.cycles << " cycles"
          << most_frequent(plan.statistics.refusals);
  }
  return out.str();
}

}  // namespace

std::optional<Found> close_clasp(Query& query, LoopSearch& search) {
  Found found;
  found.reach = search.path();
  const Problem& problem = query.problem;
  found.close = close_hand(query.free, problem.robot, problem.hand, found.reach.back());
  if (search.linking(found.close.back()).minCoeff() < search.of().options.min_linking) {
    query.refuse("clasp: a finger loses the loop while it closes");
    return std::nullopt;
  }
  const double before = query.clock.seconds();
  found.stability =
      test_stability(problem, found.close.back(), search.of().loop, query.options.stability);
  ++query.statistics.stability_tests;
  query.statistics.stability_seconds += query.clock.seconds() - before;
  if (found.stability.secure || !query.options.must_be_secure) return found;
  query.refuse("clasp: not secure");
  return std::nullopt;
}

void assemble(Query& query, const LoopSearch& search, Found found, Plan& plan) {
  const Problem& problem = query.problem;
  const LoopTargets& of = search.of();
  Tasks tasks(problem.robot, problem.hand, of.points_W, of.targets_W);
  if (problem.q_start != found.reach.front()) {
    found.reach.insert(found.reach.begin(), problem.q_start);
  }
  plan.status = Status::solved;
  plan.segments = {segment("reach", pruned(query, std::move(found.reach)), tasks),
                   segment("close", found.close, tasks)};
  plan.loop = of.loop;
  const Eigen::Isometry3d X_OW = problem.X_WO.inverse();
  plan.target = {X_OW * search.reached_W().point, X_OW.linear() * search.reached_W().tangent};
  plan.min_linking = of.options.min_linking;
  plan.stability = found.stability;
  plan.tree = search.tree();
}

void conclude(const Query& query, const std::vector<std::unique_ptr<LoopSearch>>& searches,
              Plan& plan) {
  Statistics& s = plan.statistics;
  s = query.statistics;
  s.seconds = query.clock.seconds();
  s.collision_checks = query.free.num_checks();
  s.fcl_checks = query.free.num_fcl_checks();
  for (const auto& search : searches) {
    s.cycles += search->planner().num_cycles();
    s.nodes += search->planner().num_nodes_grown();
    s.restarts += search->planner().num_restarts();
    s.control_steps += search->planner().num_steps();
  }
  if (plan.reason.empty()) plan.reason = reason(plan);
}

}  // namespace graspless::clasp
