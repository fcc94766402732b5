// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/planning/path.hpp"
#include "graspless/planning/task_space_rrt.hpp"

#include "clasp/search/controller.hpp"
#include "clasp/query.hpp"
#include "clasp/search/targets.hpp"
#include "clasp/search/tasks.hpp"

namespace graspless::clasp {

/// The search for a clasp of one loop: TaskSpaceRRT with the tasks and the controller of the hand.
///
/// x of the tree is (3) and (4), the centre of the curves and their mean virtual linking, with the
/// least virtual linking of any curve behind, which the tolerance asks for and the distance
/// ignores.
class LoopSearch {
 public:
  LoopSearch(Query& query, const LoopTargets& of, const Eigen::VectorXd& q_start);
  LoopSearch(const LoopSearch&) = delete;
  LoopSearch& operator=(const LoopSearch&) = delete;

  /// One cycle of Algorithm 1; whether it reached a target.
  bool cycle();
  /// From the start to the target reached, and on as far as control closes the hand without a
  /// touch: it keeps the loop in the middle, which the fingers alone would not.
  planning::Path path();
  Tree tree() const;
  /// |VLk| of every finger curve at q.
  const Eigen::VectorXd& linking(const Eigen::VectorXd& q);

  const LoopTargets& of() const { return of_; }
  /// The target that the hand at q holds: the nearest, if it is nearer than a finger curve could
  /// span; null otherwise.
  const geometry::ClaspTarget* held_W(const Eigen::VectorXd& q);
  const planning::TaskSpaceRRT& planner() const { return *planner_; }

 private:
  void make_space(const Eigen::VectorXd& q_start);
  void make_planner();
  Eigen::VectorXd project(const Eigen::VectorXd& q);
  const geometry::ClaspTarget& reached_W() const;
  void tighten(planning::Path& path);
  void draw_task(std::mt19937_64& rng, Eigen::VectorXd& x) const;

  Query& query_;
  LoopTargets of_;
  Tasks tasks_;
  Controller controller_;
  Eigen::Index dof_;
  Eigen::AlignedBox3d workspace_W_;
  ompl::base::SpaceInformationPtr si_;
  ompl::base::ProblemDefinitionPtr problem_;
  std::shared_ptr<planning::TaskSpaceRRT> planner_;
};

}  // namespace graspless::clasp
