// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/planning/path.hpp"

#include "clasp/query.hpp"
#include "clasp/search/targets.hpp"
#include "clasp/search/task_space.hpp"

namespace graspless::clasp {

/// Numbers of a search, for Statistics.
struct Effort {
  std::int64_t cycles = 0, nodes = 0, restarts = 0, control_steps = 0;
};

/// Search for a clasp of one loop.
class ClaspSearch {
 public:
  ClaspSearch(Query& query, const LoopTask& task);
  ClaspSearch(const ClaspSearch&) = delete;
  ClaspSearch& operator=(const ClaspSearch&) = delete;
  virtual ~ClaspSearch() = default;

  /// Runs one cycle, or goes on with one that found something. Returns true if the hand may close
  /// at the end of path().
  virtual bool cycle() = 0;
  /// Path that ends where the hand may close.
  virtual planning::Path path() = 0;
  /// Lets a path() whose clasp is accepted begin at the start. Returns false if there is no way.
  virtual bool connect(planning::Path& reach) = 0;
  virtual Tree tree() const = 0;
  virtual Effort effort() const = 0;

  /// True if every finger curve is linked enough at q for the hand to close, or with a closed hand.
  bool is_linked(const Eigen::VectorXd& q);
  bool is_clasped(const Eigen::VectorXd& q);
  /// Target held by the hand at q: the nearest one, if closer than 0.4 of the longest finger curve,
  /// else null.
  const geometry::ClaspTarget* held_target_W(const Eigen::VectorXd& q);

  Query& query() { return query_; }
  const LoopTask& task() const { return task_; }

 protected:
  /// p_AABB, Pi_vlink of eq. (4), and the smallest virtual linking of any curve.
  Eigen::VectorXd project(const Eigen::VectorXd& q);
  bool is_enough(double linking) const;

  Query& query_;
  LoopTask task_;
  TaskSpace task_space_;
};

}  // namespace graspless::clasp
