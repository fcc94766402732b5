// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/targets.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numeric>
#include <sstream>

#include "graspless/watch.hpp"

#include "clasp/hand/kinematics.hpp"
#include "clasp/hand/reach.hpp"
#include "clasp/parameters.hpp"
#include "clasp/search/hole.hpp"
#include "clasp/search/pull.hpp"
#include "clasp/stability/pinch.hpp"
#include "geometry/segment.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using geometry::ClaspTarget;

/// Data for rating targets.
struct TargetRater {
  TargetRater(const Problem& problem, const Eigen::VectorXd& q)
      : problem(problem),
        reach(arm_reach(problem.robot, problem.hand, q)),
        object_center(problem.X_WO * problem.object.points().rowwise().mean()),
        clearance(problem.object.clearance()),
        finger(finger_radius(problem.robot, problem.hand)) {
    HandKinematics hand(problem.robot, problem.hand);
    hand.update(q);
    hand_W = hand.nodes().rowwise().mean();
  }
  const Problem& problem;
  Reach reach;
  Vector3d object_center, hand_W;
  collision::Clearance clearance;  // a copy, which is not shared between threads
  double finger;                   // radius of a finger [m]
  double least_excess = std::numeric_limits<double>::infinity();  // beyond the arm's reach [m]
};

/// Number of points on a circle around the target that leave no room for a finger.
int num_obstructed(TargetRater& rater, const ClaspTarget& target_W, double thickness) {
  constexpr int kPoints = 8;
  const double radius = thickness / 2 + 2 * rater.finger;
  const Eigen::Isometry3d X_OW = rater.problem.X_WO.inverse();
  const Vector3d u = target_W.tangent.unitOrthogonal(), v = target_W.tangent.cross(u);
  int obstructed = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * M_PI * i / kPoints;
    const Vector3d p_W = target_W.point + radius * (std::cos(angle) * u + std::sin(angle) * v);
    obstructed += rater.clearance.bounds(X_OW * p_W, rater.finger).upper < rater.finger;
  }
  return obstructed;
}

struct RatedTarget {
  ClaspTarget target_W;
  double score;     // of the pull, else 0
  int obstructed;   // see num_obstructed
  double distance;  // from the hand [m]
};

bool is_better(const RatedTarget& a, const RatedTarget& b) {
  if (a.score != b.score) return a.score > b.score;
  return std::make_pair(a.obstructed, a.distance) < std::make_pair(b.obstructed, b.distance);
}

/// Rates the targets in reach that are suitable for the pull, best first.
std::vector<RatedTarget> rate(Query& query, TargetRater& rater, const Eigen::Matrix3Xd& loop_W,
                              double thickness, const std::vector<ClaspTarget>& targets_W) {
  const auto& pull = query.problem.pull_W;
  const PullCenters centers{loop_W.rowwise().mean(), rater.object_center};
  std::vector<RatedTarget> rated;
  for (const ClaspTarget& target : targets_W) {
    poll();
    const double excess = rater.reach.excess(target.point);
    rater.least_excess = std::min(rater.least_excess, excess);
    if (excess > 0) {
      query.refuse("target: out of reach");
      continue;
    }
    const auto score = pull ? pull_score(target, centers, pull->normalized()) : 0.0;
    if (!score) {
      query.refuse("target: not good for the pull");
      continue;
    }
    rated.push_back({target, *score, num_obstructed(rater, target, thickness),
                     (target.point - rater.hand_W).norm()});
  }
  std::sort(rated.begin(), rated.end(), is_better);
  return rated;
}

std::vector<ClaspTarget> in_world(const Eigen::Isometry3d& X_WO, std::vector<ClaspTarget> targets) {
  for (ClaspTarget& target : targets) {
    target = {X_WO * target.point, X_WO.linear() * target.tangent};
  }
  return targets;
}

/// Point of a loop nearest to a given point, with the tangent of the nearest of many targets.
ClaspTarget nearest_target(const Eigen::Matrix3Xd& loop, const Vector3d& p) {
  constexpr int kTargets = 256;
  ClaspTarget nearest{loop.col(0), Vector3d::Zero()};
  for (Eigen::Index i = 0; i < loop.cols(); ++i) {
    const Vector3d a = loop.col(i), b = loop.col((i + 1) % loop.cols());
    const Vector3d q = a + geometry::nearest_on_segment(p, a, b) * (b - a);
    if ((q - p).norm() < (nearest.point - p).norm()) nearest.point = q;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const ClaspTarget& target : geometry::clasp_targets(loop, kTargets)) {
    const double distance = (target.point - nearest.point).norm();
    if (distance >= least) continue;
    least = distance;
    nearest.tangent = target.tangent;
  }
  return nearest;
}

/// Targets of every loop: at equal arc length or, if there are marks, its points nearest to those
/// that mark it.
std::vector<std::vector<ClaspTarget>> all_targets_O(const Problem& problem,
                                                    const std::vector<int>& loops,
                                                    const std::vector<Options>& options) {
  std::vector<std::vector<ClaspTarget>> targets(loops.size());
  const auto points = [&](std::size_t i) -> const Eigen::Matrix3Xd& {
    return problem.object.loops().found[loops[i]].points;
  };
  for (std::size_t i = 0; problem.marks.empty() && i < loops.size(); ++i) {
    targets[i] = geometry::clasp_targets(points(i), options[i].targets);
  }
  for (const Vector3d& mark : problem.marks) {
    const auto marked = std::find(loops.begin(), loops.end(), marked_loop(problem, mark));
    if (marked == loops.end()) continue;  // the hand does not fit there
    const auto i = static_cast<std::size_t>(marked - loops.begin());
    targets[i].push_back(nearest_target(points(i), mark));
  }
  return targets;
}

/// The allowed loops; if there are marks, those that are marked.
std::vector<int> wanted_loops(const Problem& problem) {
  std::vector<int> loops = allowed_loops(problem);
  if (problem.marks.empty()) return loops;
  std::vector<int> marked;
  for (const Vector3d& mark : problem.marks) marked.push_back(marked_loop(problem, mark));
  const auto is_unmarked = [&](int loop) {
    return std::find(marked.begin(), marked.end(), loop) == marked.end();
  };
  loops.erase(std::remove_if(loops.begin(), loops.end(), is_unmarked), loops.end());
  return loops;
}

/// Drops the loops along handles that are wider than the two fingers of the hand open.
std::vector<int> without_thick(Query& query, std::vector<int> loops, Plan& plan) {
  const Problem& problem = query.problem;
  if (problem.hand.fingers.size() > 1) return loops;
  const double open = opening(problem.robot, problem.hand);
  const auto width = [&](int loop) { return problem.object.loops().found[loop].width; };
  const auto thinnest = std::min_element(loops.begin(), loops.end(),
                                         [&](int a, int b) { return width(a) < width(b); });
  if (width(*thinnest) >= open) {
    const auto mm = [](double length) { return std::to_string(std::lround(1000 * length)); };
    plan.status = Status::too_thick;
    plan.reason = "loop " + std::to_string(*thinnest) + ": its handle is " + mm(width(*thinnest)) +
                  " mm thick, the hand opens " + mm(open) + " mm";
  }
  const auto is_thick = [&](int loop) {
    if (width(loop) < open) return false;
    query.refuse("target: handle too thick");
    return true;
  };
  loops.erase(std::remove_if(loops.begin(), loops.end(), is_thick), loops.end());
  return loops;
}

/// Drops the loops around holes that no finger passes. Clasps that need not be secure may hold
/// a loop between fingertips.
std::vector<int> without_narrow(Query& query, std::vector<int> loops, Plan& plan) {
  const Problem& problem = query.problem;
  const double needed = needed_width(problem.robot, problem.hand);
  if (!query.options.must_be_secure || needed == 0) return loops;
  int widest = -1;
  double most = 0;
  const auto is_narrow = [&](int loop) {
    // A ball as wide as the edges that fill the hole passes it.
    if (problem.object.loops().found[loop].death >= needed) return false;
    const double width = hole_width(problem.object, loop, needed);
    if (width >= needed) return false;
    query.refuse("target: hole too narrow");
    if (width > most) widest = loop;
    most = std::max(most, width);
    return true;
  };
  loops.erase(std::remove_if(loops.begin(), loops.end(), is_narrow), loops.end());
  if (loops.empty() && widest >= 0) {
    plan.status = Status::hole_too_narrow;
    plan.reason = "no finger passes through a hole; " + describe_sizes(problem, widest);
    plan.statistics.refusals = query.statistics.refusals;
  }
  return loops;
}

void explain_no_target(const Query& query, const TargetRater& rater, Plan& plan) {
  if (rater.least_excess > 0) {
    plan.status = Status::no_target_in_reach;
    std::ostringstream out;
    out << std::fixed << std::setprecision(3) << "every target is out of the arm's reach of "
        << rater.reach.radius << " m; the nearest is " << rater.least_excess << " m too far away";
    plan.reason = out.str();
  } else {
    plan.status = Status::not_found;
    plan.reason = "no target in reach lies across the pull and on its side";
  }
  plan.statistics.refusals = query.statistics.refusals;
}

}  // namespace

std::vector<int> allowed_loops(const Problem& problem) {
  if (!problem.loops.empty()) return problem.loops;
  std::vector<int> all(problem.object.loops().found.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

int marked_loop(const Problem& problem, const Eigen::Vector3d& mark) {
  int marked = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const int loop : allowed_loops(problem)) {
    poll();
    const auto& points = problem.object.loops().found[loop].points;
    const double distance = geometry::distance_to_loop(points, mark);
    if (distance < least) marked = loop;
    least = std::min(least, distance);
  }
  return marked;
}

std::vector<LoopTask> choose_targets(Query& query, const Eigen::VectorXd& q, Plan& plan) {
  const Problem& problem = query.problem;
  std::vector<int> loops = without_thick(query, wanted_loops(problem), plan);
  if (!loops.empty()) loops = without_narrow(query, std::move(loops), plan);
  if (loops.empty()) return {};
  std::vector<Options> options;
  for (const int loop : loops) {
    options.push_back(derived(query.options, problem, loop));
  }
  const auto targets_O = all_targets_O(problem, loops, options);
  TargetRater rater(problem, q);
  std::vector<std::pair<RatedTarget, LoopTask>> choice;  // each with its best target
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto& loop = problem.object.loops().found[loops[i]];
    LoopTask task{loops[i], options[i], problem.X_WO * loop.points, {}};
    const auto rated =
        rate(query, rater, task.points_W, loop.thickness, in_world(problem.X_WO, targets_O[i]));
    for (const RatedTarget& target : rated) task.targets_W.push_back(target.target_W);
    if (!rated.empty()) choice.emplace_back(rated.front(), std::move(task));
  }
  std::stable_sort(choice.begin(), choice.end(),
                   [](const auto& a, const auto& b) { return is_better(a.first, b.first); });
  std::vector<LoopTask> sorted;
  for (auto& [best, task] : choice) sorted.push_back(std::move(task));
  if (sorted.empty()) explain_no_target(query, rater, plan);
  return sorted;
}

}  // namespace graspless::clasp
