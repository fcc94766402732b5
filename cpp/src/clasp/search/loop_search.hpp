// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/planning/task_space_rrt.hpp"

#include "clasp/search/clasp_search.hpp"
#include "clasp/search/controller.hpp"

namespace graspless::clasp {

/// Search for a clasp of one loop: TaskSpaceRRT (Algorithms 1 to 3) with the task space and the
/// controller of the hand.
///
/// A node x of the tree has five entries: p_AABB, Pi_vlink of eq. (4), and the smallest virtual
/// linking of any curve. The tolerance applies to the last, and the distance ignores it.
class LoopSearch : public ClaspSearch {
 public:
  LoopSearch(Query& query, const LoopTask& task, const Eigen::VectorXd& q_start);

  /// Runs one cycle of Algorithm 1. Returns true if it reached a target.
  bool cycle() override;
  /// Path from the start to the target reached, continued while the controller closes the hand
  /// without collision. The controller keeps the loop centred, unlike the closing of the fingers
  /// alone.
  planning::Path path() override;
  bool connect(planning::Path&) override { return true; }
  Tree tree() const override;
  Effort effort() const override;

 private:
  void make_space(const Eigen::VectorXd& q_start);
  void make_planner();
  const geometry::ClaspTarget& reached_W() const;
  void tighten(planning::Path& path);
  void draw_task(std::mt19937_64& rng, Eigen::VectorXd& x) const;
  bool is_stuck();

  Controller controller_;
  Eigen::Index dof_;
  Eigen::AlignedBox3d workspace_W_;
  ompl::base::SpaceInformationPtr si_;
  ompl::base::ProblemDefinitionPtr problem_;
  std::shared_ptr<planning::TaskSpaceRRT> planner_;
  // Before the last step: the restarts, and the nodes of its tree.
  std::int64_t restarts_ = 0;
  std::size_t nodes_ = 0;
  bool was_stuck_ = false;  // a tree was given up at its root
};

}  // namespace graspless::clasp
