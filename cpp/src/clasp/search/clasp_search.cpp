// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/clasp_search.hpp"

#include <algorithm>

namespace graspless::clasp {

ClaspSearch::ClaspSearch(Query& query, const LoopTask& task)
    : query_(query),
      task_(task),
      task_space_(query.problem.robot, query.problem.hand, task.points_W, task.targets_W) {}

Eigen::VectorXd ClaspSearch::project(const Eigen::VectorXd& q) {
  Eigen::VectorXd x(5);
  x.head<4>() = task_space_.project(q);
  x[4] = task_space_.linking_of_curves().minCoeff();
  return x;
}

bool ClaspSearch::is_linked(const Eigen::VectorXd& q) { return is_enough(project(q)[4]); }

/// A derived threshold applies to the closed hand only.
bool ClaspSearch::is_enough(double linking) const {
  return query_.options.min_linking > 0 ? linking >= task_.options.min_linking : linking > 0;
}

bool ClaspSearch::is_clasped(const Eigen::VectorXd& q) {
  return project(q)[4] >= task_.options.min_linking;
}

const geometry::ClaspTarget* ClaspSearch::held_target_W(const Eigen::VectorXd& q) {
  const Eigen::Vector3d hand_W = project(q).head<3>();
  constexpr double kNear = 0.4;  // of the longest curve, as in check()
  const geometry::ClaspTarget* nearest = nullptr;
  double least = kNear * task_space_.kinematics().longest_curve();
  for (const geometry::ClaspTarget& target : task_.targets_W) {
    const double distance = (target.point - hand_W).norm();
    if (distance >= least) continue;
    least = distance;
    nearest = &target;
  }
  return nearest;
}

}  // namespace graspless::clasp
