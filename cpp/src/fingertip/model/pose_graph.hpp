// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "fingertip/model/clearance.hpp"
#include "fingertip/model/instants.hpp"
#include "fingertip/model/locations.hpp"

namespace graspless::fingertip {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The object's half of the manipulation-feasibility graph (Section 4.2): its poses, and the arcs
/// along which it moves from pose to pose with constant twist. A Path is a chain: arc i leads from
/// pose i to pose i + 1. In a Lattice, arcs lead to the 26 neighbours of a pose. The searches
/// enumerate the other half, the placements of the fingers.
///
/// An arc has a motion (its twist, hence displacements of fingertips) and a kind (the instants of
/// its P samples, hence stabilities of placements). On the open floor of a lattice both depend on
/// the yaw and the move alone. Clearances, kinds and instants at rest of a lattice are computed on
/// first use: one thread at a time.
class PoseGraph {
 public:
  PoseGraph(const Problem& problem, const Path& path, const Locations& locations,
            Instants& instants, const Options& options);
  PoseGraph(const Problem& problem, const Lattice& lattice, const Locations& locations,
            Instants& instants, const Options& options);

  bool is_path() const { return num_moves_ == 1; }
  int num_poses() const { return static_cast<int>(X_WO_.size()); }
  int num_arcs() const { return num_poses() - 1; }  // of a path
  int num_moves() const { return num_moves_; }
  int start() const { return start_; }
  int goal() const { return goal_; }
  const Eigen::Isometry3d& X_WO(int pose) const { return X_WO_[pose]; }
  Eigen::Vector3d center_W(int pose, int location) const {  // of the fingertip's sphere
    return X_WO(pose) * locations[location].center_O;
  }
  /// Number of the object's orientation, counted from 0 over ascending poses: a yaw of a lattice.
  int turn(int pose) const { return turns_[pose]; }
  /// The pose that a move leads to, or comes from; -1: there is none.
  int next(int pose, int move) const { return next_[arc(pose, move)]; }
  int previous(int pose, int move) const {  // by the opposite step in a lattice
    return is_path() ? pose - 1 : next(pose, num_moves_ - 1 - move);
  }

  int motion(int pose, int move) const { return turn(pose) * num_moves_ + move; }
  int num_motions() const { return static_cast<int>(twist_O_.size()); }
  const mechanics::Vector6d& twist_O(int motion) const { return twist_O_[motion]; }  // of an arc
  /// Displacement of a sphere's centre in one P-th of an arc [m].
  double displacement(int motion, int location) const {
    return displacements_[motion * num_locations_ + location];
  }

  /// The kind of an arc; -1: the object cannot move along it.
  int kind(int pose, int move) const {
    int& kind = kinds_of_[arc(pose, move)];
    if (kind == kUnknown) kind = find_kind(pose, move);
    return kind;
  }
  int num_kinds() const { return static_cast<int>(kinds_.size()); }
  /// Instants of a kind's samples; one when all P are the same.
  const std::vector<int>& instants(int kind) const { return kinds_[kind]; }
  int instant(int arc, int sample) const;  // of a path
  /// The object at rest while a finger regrasps. The motion to the next pose turns its friction
  /// cones, always in a path, and in a lattice where `next_pose` is given.
  int rest_instant(int pose) const;
  int rest_instant(int pose, int next_pose) const;

  /// True if the sphere is clear of planes and obstacles.
  bool is_clear(int pose, int location) const {
    std::int8_t& known = clear_[pose * num_locations_ + location];
    if (known < 0) known = clearance_.is_clear(center_W(pose, location)) ? 1 : 0;
    return known != 0;
  }
  bool is_arc_clear(int pose, int move, int location) const;  // the sphere, of obstacles
  bool is_free(int pose) const;                               // the object, of walls and obstacles
  void block(int pose, int location);                         // keeps fingertips from a location

  std::int64_t memory() const;                                                // [bytes]
  static double memory_needed(const Lattice& lattice, double num_locations);  // at most

  const Options& options;
  const Locations& locations;
  const int num_fingers;  // of the hand

 private:
  static constexpr int kUnknown = -2;
  std::size_t arc(int pose, int move) const {
    return static_cast<std::size_t>(pose) * num_moves_ + move;
  }
  void add_motion(const mechanics::Vector6d& twist_O);
  void make_clearance_table();
  void keep_to_start();
  int find_kind(int pose, int move) const;
  int add_kind(const std::vector<mechanics::BodyState>& states) const;

  const Problem& problem_;
  Instants& instants_;
  std::size_t num_locations_;
  int num_moves_ = 1, start_ = 0, goal_ = 0;
  std::vector<Eigen::Isometry3d> X_WO_;       // poses
  std::vector<int> next_;                     // poses x moves
  std::vector<int> turns_;                    // poses
  std::vector<mechanics::Vector6d> twist_O_;  // motions
  std::vector<double> displacements_;         // motions x locations
  mutable Clearance clearance_;
  mutable std::vector<int> kinds_of_;            // poses x moves
  mutable std::vector<int> floor_kinds_;         // motions, of arcs that touch no wall
  mutable std::vector<std::vector<int>> kinds_;  // kinds x samples
  mutable std::vector<int> rest_;                // poses
  mutable std::vector<std::int8_t> free_;        // poses; -1: not known
  mutable std::vector<std::int8_t> clear_;       // poses x locations; -1: not known
};

/// True if the fingers may be there at a pose: each clear, and all apart.
bool is_feasible(const PoseGraph& graph, int pose, const Placement& placement);
/// True if all fingers are clear of obstacles along an arc.
bool is_arc_clear(const PoseGraph& graph, int pose, int move, const Placement& placement);
/// True if a finger may be put down beside those of a placement.
bool has_room(const PoseGraph& graph, int pose, const Placement& placement, int location);

/// Displacement of the finger that moves farthest, in one P-th of an arc [m].
double displacement(const PoseGraph& graph, int motion, const Placement& placement);

/// Sum of 1 + X_stab / z over the P samples of an arc, from the stabilities of each or one that all
/// share; infinite if one is 0.
double arc_weight(const PoseGraph& graph, const std::vector<double>& z);
/// Cost (9) of an arc, from stabilities as above.
double arc_cost(const PoseGraph& graph, int motion, const Placement& placement,
                const std::vector<double>& z);

/// A node of the manipulation-feasibility graph.
struct Node {
  int pose;
  Placement placement;
};

/// A path through the graph. From one node to the next either the pose or one finger changes.
struct Route {
  bool found = false;
  double cost = 0;           // by (9) and (10) [m]
  double lower_bound = 0;    // no route is cheaper [m]
  bool is_complete = false;  // the search ran to its end: if nothing was found, there is no route
  std::vector<Node> nodes;
};

int num_regrasps(const Route& route);

/// True if gravity is along the floor's normal: then the mechanics on the floor depend neither on
/// the place of the object nor on its yaw.
bool is_level(const Problem& problem);

}  // namespace graspless::fingertip
