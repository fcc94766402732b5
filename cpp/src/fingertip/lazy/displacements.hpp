// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "fingertip/model/pose_graph.hpp"

namespace graspless::fingertip {

/// Displacement of the fingertip at each location along a path [m]: the least that (9) comes to,
/// whatever the stability. Infinite where the location is not clear.
class Displacements {
 public:
  explicit Displacements(const PoseGraph& graph);

  /// Of the finger that moves farthest, in a P-th of an arc.
  double in_part(int arc, const Placement& placement) const;
  /// From the start to each pose, and from each pose to the goal.
  const double* before(int location) const { return &before_[index(location)]; }
  const double* after(int location) const { return &after_[index(location)]; }
  /// The same of all locations at one pose.
  const double* before_at(int pose) const { return &before_at_[at_pose(pose)]; }
  const double* after_at(int pose) const { return &after_at_[at_pose(pose)]; }
  /// In the arc in which the location moves least.
  double least_arc(int location) const { return least_arcs_[location]; }
  /// Locations by ascending least arc.
  const std::vector<std::int32_t>& ranking() const { return ranking_; }
  /// Place of a location in ranking().
  std::int32_t rank(int location) const { return ranks_[location]; }
  /// No route costs less, whatever its placements.
  double least() const { return least_; }
  /// No route on which some finger stays where it is costs less.
  double least_whole() const { return least_whole_; }

 private:
  std::size_t index(int location) const { return static_cast<std::size_t>(location) * (arcs_ + 1); }
  std::size_t at_pose(int pose) const { return static_cast<std::size_t>(pose) * ranks_.size(); }
  void add(const PoseGraph& graph, int location);
  void rank_all();

  std::size_t arcs_;
  std::vector<double> parts_;                 // locations x arcs: in a P-th
  std::vector<double> before_, after_;        // locations x poses
  std::vector<double> before_at_, after_at_;  // poses x locations
  std::vector<double> least_arcs_;            // locations
  std::vector<std::int32_t> ranking_, ranks_;
  double least_ = 0, least_whole_ = kInfinity;
};

}  // namespace graspless::fingertip
