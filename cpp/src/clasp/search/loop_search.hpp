// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/planning/path.hpp"
#include "graspless/planning/task_space_rrt.hpp"

#include "clasp/query.hpp"
#include "clasp/search/controller.hpp"
#include "clasp/search/targets.hpp"
#include "clasp/search/task_space.hpp"

namespace graspless::clasp {

/// Search for a clasp of one loop: TaskSpaceRRT (Algorithms 1 to 3) with the task space and the
/// controller of the hand.
///
/// A node x of the tree has five entries: p_AABB, Pi_vlink of eq. (4), and the smallest virtual
/// linking of any curve. The tolerance applies to the last, and the distance ignores it.
class LoopSearch {
 public:
  LoopSearch(Query& query, const LoopTask& task, const Eigen::VectorXd& q_start);
  LoopSearch(const LoopSearch&) = delete;
  LoopSearch& operator=(const LoopSearch&) = delete;

  /// Runs one cycle of Algorithm 1. Returns true if it reached a target.
  bool cycle();
  /// Path from the start to the target reached, continued while the controller closes the hand
  /// without collision. The controller keeps the loop centred, unlike the closing of the fingers
  /// alone.
  planning::Path path();
  Tree tree() const;
  /// True if every finger curve is linked enough at q for the hand to close, or with a closed hand.
  bool is_linked(const Eigen::VectorXd& q);
  bool is_clasped(const Eigen::VectorXd& q);

  Query& query() { return query_; }
  const LoopTask& task() const { return task_; }
  /// Target held by the hand at q: the nearest one, if closer than half the longest finger curve,
  /// else null.
  const geometry::ClaspTarget* held_target_W(const Eigen::VectorXd& q);
  const planning::TaskSpaceRRT& planner() const { return *planner_; }

 private:
  void make_space(const Eigen::VectorXd& q_start);
  void make_planner();
  Eigen::VectorXd project(const Eigen::VectorXd& q);
  const geometry::ClaspTarget& reached_W() const;
  bool is_enough(double linking) const;
  void tighten(planning::Path& path);
  void draw_task(std::mt19937_64& rng, Eigen::VectorXd& x) const;

  Query& query_;
  LoopTask task_;
  TaskSpace task_space_;
  Controller controller_;
  Eigen::Index dof_;
  Eigen::AlignedBox3d workspace_W_;
  ompl::base::SpaceInformationPtr si_;
  ompl::base::ProblemDefinitionPtr problem_;
  std::shared_ptr<planning::TaskSpaceRRT> planner_;
};

}  // namespace graspless::clasp
