// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fingertip/model/clearance.hpp"
#include "fingertip/planner.hpp"

namespace graspless::fingertip {

/// The object's poses on a lattice of positions and yaws, and the arcs between neighbours. An arc
/// has constant twist, so on the open floor its mechanics depend on yaw and move alone; only arcs
/// that touch a wall have instants of their own. What depends on the pose is worked out when asked
/// for.
class LatticeSpace {
 public:
  static constexpr int kMoves = 26;

  LatticeSpace(Workshop& workshop, const Lattice& lattice);

  int num_poses() const { return counts_[0] * counts_[1] * counts_[2]; }
  int num_yaws() const { return counts_[2]; }
  int start() const { return start_; }
  int goal() const { return goal_; }
  int yaw(int pose) const { return yaws_[ix(pose)]; }
  Eigen::Isometry3d X_WO(int pose) const;
  /// The neighbour that a move leads to; -1 off the lattice. Move 25 - m undoes move m.
  int next(int pose, int move) const { return next_[ix(pose) * kMoves + ix(move)]; }
  static int reverse(int move) { return kMoves - 1 - move; }

  /// How far a sphere's centre moves along an arc from this yaw [m].
  double displacement(int yaw, int move, int location) const {
    return displacements_[(ix(yaw) * kMoves + ix(move)) * num_locations_ + ix(location)];
  }
  /// Where a sphere's centre is.
  Eigen::Vector3d center_W(int pose, int location) const;
  bool is_clear(int pose, int location);
  bool is_free(int pose);  // the object of walls and obstacles

  /// Which kind of arc this is; -1: the object cannot go there.
  int arc_kind(int pose, int move) {
    int& kind = arc_kinds_[ix(pose) * kMoves + ix(move)];
    if (kind == kUnknown) kind = find_kind(pose, move);
    return kind;
  }
  /// The instants of a kind's samples; one when all are the same.
  const std::vector<int>& instants(int kind) const { return kinds_[ix(kind)]; }
  int num_kinds() const { return static_cast<int>(kinds_.size()); }
  /// The object at rest, while a finger regrasps; -1: it cannot be there. Cones lie as if the
  /// object had no way to go, or that of the move that goes on from there.
  int rest_instant(int pose);
  int rest_instant(int pose, int next_move);

  std::int64_t memory() const;

 private:
  enum class Near { nothing, contact, inside };
  static constexpr int kUnknown = -2;
  static std::size_t ix(int i) { return static_cast<std::size_t>(i); }

  void set_axes(const Lattice& lattice);
  int index_of(const Eigen::Isometry3d& X_WO) const;
  void tabulate();
  int find_next(int pose, int move) const;
  Near near_planes(const Eigen::Isometry3d& X_WO) const;
  int find_kind(int pose, int move);

  Workshop& workshop_;
  Clearance clearance_;
  Eigen::Isometry3d X_WO_start_;
  std::array<int, 3> counts_{};
  std::array<double, 3> lower_{}, step_{};
  bool wraps_ = false;  // the yaws go all the way round
  int start_ = 0, goal_ = 0;
  std::size_t num_locations_;
  std::vector<int> next_;                      // poses x moves
  std::vector<int> yaws_;                      // poses
  std::vector<Eigen::Vector3d> origins_;       // poses: of O, in W
  std::vector<mechanics::Vector6d> twists_O_;  // yaws x moves
  std::vector<double> displacements_;          // yaws x moves x locations
  std::vector<Eigen::Vector3d> centers_;       // yaws x locations, about O's origin, in W
  std::vector<int> floor_kinds_;               // yaws x moves
  std::vector<int> arc_kinds_;                 // poses x moves
  std::vector<std::vector<int>> kinds_;
  std::vector<std::int8_t> free_;   // poses: -1 not known
  std::vector<std::int8_t> clear_;  // poses x locations: -1 not known
  std::vector<int> rest_;           // poses
};

}  // namespace graspless::fingertip
