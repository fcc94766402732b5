// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/assemble.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "clasp/close.hpp"
#include "clasp/parameters.hpp"
#include "clasp/tasks.hpp"

namespace graspless::clasp {

using planning::Path;

namespace {

constexpr int kPruningRounds = 60;  // costs little beside the search

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
  return planning::shortcut(std::move(path), straight, kPruningRounds, query.rng);
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

/// The stability test; a clasp that does not outlive its first sequence is spared the others where
/// it must be secure.
Stability tested(Query& query, int loop, const Eigen::VectorXd& q) {
  const double before = query.clock.seconds();
  if (!query.tester) query.tester.emplace(query.problem);
  const Eigen::Matrix3Xd& loop_O =
      query.problem.object.loops().loops[static_cast<std::size_t>(loop)].points;
  StabilityOptions first = query.options.stability;
  if (query.options.must_be_secure) first.sequences = 1;
  Stability stability = query.tester->test(q, loop_O, first);
  if (stability.secure && query.options.must_be_secure) {
    stability = query.tester->test(q, loop_O, query.options.stability);
  }
  ++query.statistics.stability_tests;
  query.statistics.stability_seconds += query.clock.seconds() - before;
  return stability;
}

/// Handles that the hand cannot close around, which may be why there is no plan.
void warn_of_thick_handles(const Problem& problem,
                           const std::vector<std::unique_ptr<LoopSearch>>& searches, Plan& plan) {
  for (const auto& search : searches) {
    const int loop = search->of().loop;
    const double thickness = problem.object.loops().loops[static_cast<std::size_t>(loop)].thickness;
    if (!is_too_thick(problem.robot, problem.hand, thickness)) continue;
    std::ostringstream out;
    out << "loop " << loop << ": its handle of " << std::lround(100 * thickness)
        << " cm is too thick for this hand to close around";
    plan.warnings.push_back(out.str());
  }
}

}  // namespace

std::optional<Found> close_clasp(Query& query, LoopSearch& search) {
  const Problem& problem = query.problem;
  const auto refused = [&](const char* why) {
    query.refuse(why);
    return std::nullopt;
  };
  Found found;
  found.reach = search.path();
  found.close = close_hand(query.free, problem.robot, problem.hand, found.reach.back());
  const Eigen::VectorXd& q = found.close.back();
  if (search.linking(q).minCoeff() < search.of().options.min_linking) {
    return refused("clasp: a finger loses the loop while it closes");
  }
  const geometry::ClaspTarget* held = search.held_W(q);
  if (!held) return refused("clasp: away from every target");
  found.target_W = *held;
  found.stability = tested(query, search.of().loop, q);
  if (query.options.must_be_secure && !found.stability.secure) {
    return refused("clasp: not secure");
  }
  return found;
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
  plan.target = {X_OW * found.target_W.point, X_OW.linear() * found.target_W.tangent};
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
  if (!plan) warn_of_thick_handles(query.problem, searches, plan);
  if (plan.reason.empty()) plan.reason = reason(plan);
}

}  // namespace graspless::clasp
