// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/targets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "clasp/hand/kinematics.hpp"
#include "clasp/parameters.hpp"
#include "clasp/search/pull.hpp"
#include "clasp/hand/reach.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using geometry::ClaspTarget;

/// What places are judged by.
struct Judge {
  Judge(const Problem& problem, const Eigen::VectorXd& q)
      : problem(problem),
        reach(arm_reach(problem.robot, problem.hand, q)),
        object_middle(problem.X_WO * problem.object.points().rowwise().mean()),
        clearance(problem.object.clearance()),
        finger(finger_radius(problem.robot, problem.hand)) {
    HandKinematics hand(problem.robot, problem.hand);
    hand.update(q);
    hand_W = hand.nodes().rowwise().mean();
  }
  const Problem& problem;
  Reach reach;
  Vector3d object_middle, hand_W;
  collision::Clearance clearance;  // a grid of its own
  double finger;                   // radius [m]
  double least_excess = std::numeric_limits<double>::infinity();
};

/// Of the points on a circle around the place, how many leave no room for a finger.
int num_obstructed(Judge& judge, const ClaspTarget& place_W, double thickness) {
  constexpr int kPoints = 8;
  const double radius = thickness / 2 + 2 * judge.finger;
  const Eigen::Isometry3d X_OW = judge.problem.X_WO.inverse();
  const Vector3d u = place_W.tangent.unitOrthogonal(), v = place_W.tangent.cross(u);
  int obstructed = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2 * M_PI * i / kPoints;
    const Vector3d p_W = place_W.point + radius * (std::cos(angle) * u + std::sin(angle) * v);
    obstructed += judge.clearance.bounds(X_OW * p_W, judge.finger).upper < judge.finger;
  }
  return obstructed;
}

struct Place {
  ClaspTarget target_W;
  double score;  // of the pull, else 0
  int obstructed;
  double distance;  // from the hand
};

bool is_better(const Place& a, const Place& b) {
  if (a.score != b.score) return a.score > b.score;
  return std::make_pair(a.obstructed, a.distance) < std::make_pair(b.obstructed, b.distance);
}

/// The places in reach and good for the pull, the best first.
std::vector<Place> judged(Query& query, Judge& judge, const Eigen::Matrix3Xd& loop_W,
                          double thickness, const std::vector<ClaspTarget>& targets_W) {
  const auto& pull = query.problem.pull_W;
  const Pulled pulled{loop_W.rowwise().mean(), judge.object_middle};
  std::vector<Place> places;
  for (const ClaspTarget& target : targets_W) {
    const double excess = judge.reach.excess(target.point);
    judge.least_excess = std::min(judge.least_excess, excess);
    if (excess > 0) {
      query.refuse("target: out of reach");
      continue;
    }
    const auto score = pull ? pull_score(target, pulled, pull->normalized()) : 0.0;
    if (!score) {
      query.refuse("target: not good for the pull");
      continue;
    }
    places.push_back({target, *score, num_obstructed(judge, target, thickness),
                      (target.point - judge.hand_W).norm()});
  }
  std::sort(places.begin(), places.end(), is_better);
  return places;
}

std::vector<ClaspTarget> in_world(const Eigen::Isometry3d& X_WO, std::vector<ClaspTarget> targets) {
  for (ClaspTarget& target : targets) {
    target = {X_WO * target.point, X_WO.linear() * target.tangent};
  }
  return targets;
}

/// The place of a loop nearest to a point, with the tangent that the nearest of many targets has.
ClaspTarget nearest_place(const Eigen::Matrix3Xd& loop, const Vector3d& p) {
  constexpr int kTargets = 256;
  ClaspTarget nearest{loop.col(0), Vector3d::Zero()};
  for (Eigen::Index i = 0; i < loop.cols(); ++i) {
    const Vector3d a = loop.col(i), d = loop.col((i + 1) % loop.cols()) - a;
    const double square = d.squaredNorm();
    const Vector3d place = a + (square > 0 ? std::clamp(d.dot(p - a) / square, 0.0, 1.0) : 0.0) * d;
    if ((place - p).norm() < (nearest.point - p).norm()) nearest.point = place;
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

/// By loop: targets at equal arc length or, where the user made marks, for every mark the place
/// nearest to it.
std::vector<std::vector<ClaspTarget>> all_targets_O(const Problem& problem,
                                                    const std::vector<int>& loops,
                                                    const std::vector<Options>& options) {
  std::vector<std::vector<ClaspTarget>> targets(loops.size());
  const auto points = [&](std::size_t i) -> const Eigen::Matrix3Xd& {
    return problem.object.loops().loops[static_cast<std::size_t>(loops[i])].points;
  };
  for (std::size_t i = 0; problem.marks.empty() && i < loops.size(); ++i) {
    targets[i] = geometry::clasp_targets(points(i), options[i].targets);
  }
  for (const Vector3d& mark : problem.marks) {
    std::size_t best = 0;
    ClaspTarget nearest = nearest_place(points(0), mark);
    for (std::size_t i = 1; i < loops.size(); ++i) {
      const ClaspTarget place = nearest_place(points(i), mark);
      if ((place.point - mark).norm() >= (nearest.point - mark).norm()) continue;
      nearest = place;
      best = i;
    }
    targets[best].push_back(nearest);
  }
  return targets;
}

std::vector<int> loops_wanted(const Problem& problem) {
  if (!problem.loops.empty()) return problem.loops;
  std::vector<int> all(problem.object.loops().loops.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void say_none(const Query& query, const Judge& judge, Plan& plan) {
  if (judge.least_excess > 0) {
    plan.status = Status::no_target_in_reach;
    plan.reason = "every target is out of the arm's reach of " +
                  std::to_string(judge.reach.radius) + " m; the nearest is " +
                  std::to_string(judge.least_excess) + " m too far away";
  } else {
    plan.status = Status::not_found;
    plan.reason = "no place of the loops in reach lies across the pull and on its side";
  }
  plan.statistics.refusals = query.statistics.refusals;
}

}  // namespace

std::vector<LoopTargets> choose_targets(Query& query, const Eigen::VectorXd& q, Plan& plan) {
  const Problem& problem = query.problem;
  const std::vector<int> loops = loops_wanted(problem);
  std::vector<Options> options;
  for (const int loop : loops) {
    options.push_back(derived(query.options, problem, loop));
  }
  const auto targets_O = all_targets_O(problem, loops, options);
  Judge judge(problem, q);
  std::vector<std::pair<Place, LoopTargets>> choice;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto& loop = problem.object.loops().loops[static_cast<std::size_t>(loops[i])];
    LoopTargets of{loops[i], options[i], problem.X_WO * loop.points, {}};
    const auto places =
        judged(query, judge, of.points_W, loop.thickness, in_world(problem.X_WO, targets_O[i]));
    for (const Place& place : places) of.targets_W.push_back(place.target_W);
    if (!places.empty()) choice.emplace_back(places.front(), std::move(of));
  }
  std::stable_sort(choice.begin(), choice.end(),
                   [](const auto& a, const auto& b) { return is_better(a.first, b.first); });
  std::vector<LoopTargets> sorted;
  for (auto& [place, of] : choice) sorted.push_back(std::move(of));
  if (sorted.empty()) say_none(query, judge, plan);
  return sorted;
}

}  // namespace graspless::clasp
