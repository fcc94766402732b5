// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "fingertip/lattice/bounds.hpp"
#include "fingertip/model/pose_graph.hpp"
#include "fingertip/search/heuristic.hpp"

namespace graspless::fingertip {

/// Costs (9) of arcs with the fingers at one placement: lower bounds, from bounds of stability,
/// until their kinds are solved.
class PlacementCosts {
 public:
  PlacementCosts(const PoseGraph& graph, LatticeBounds& bounds, const Placement& placement);

  const Placement& placement() const { return placement_; }
  bool is_clear(int pose) const;  // the fingers, of floor, walls and obstacles
  /// At least the cost of an arc between clear poses: exact if its kind is solved; infinite if it
  /// is impossible.
  double cost(int pose, int move);
  bool is_solved(int pose, int move);
  /// Solves the kind of an arc, and returns the cost.
  double solve(int pose, int move);

 private:
  struct Weight {
    double value = -1;  // sum of 1 + X_stab / z over the samples; -1: not computed
    bool is_solved = false;
  };
  Weight& weight(int kind);

  const PoseGraph& graph_;
  LatticeBounds& bounds_;
  Placement placement_;
  std::vector<double> displacements_;  // motions
  std::vector<Weight> weights_;        // kinds
  std::vector<double> z_;              // scratch
};

/// A path through the lattice with one placement.
struct PosePath {
  bool found = false;
  double cost = std::numeric_limits<double>::infinity();
  std::vector<int> poses, moves;
};

/// A* over the poses of a lattice with one placement; holds its tables.
class PoseSearch {
 public:
  PoseSearch(const PoseGraph& graph, RemainingDistance& remaining);

  /// The cheapest path from start to goal below `limit`. The heuristic is (11) without regrasps:
  /// the displacement of the sphere that has the farthest to go. Paths are searched by bounds of
  /// stability first; then arcs are solved when they turn out to be the best to a pose, not before.
  PosePath find(PlacementCosts& costs, double limit, planning::Clock& clock,
                Statistics& statistics);

 private:
  struct Settings {
    double limit;
    bool exact;  // solve arcs, instead of taking their bounds
  };
  struct Entry {
    double f, g;
    int pose, from, move;
    bool operator<(const Entry& other) const {  // the top of a std heap is its greatest
      return f > other.f || (f == other.f && g < other.g);
    }
  };
  struct State {                                         // of a pose
    double g = std::numeric_limits<double>::infinity();  // the least solved cost to come
    double rest = 0;                                     // heuristic
    int round = 0;                                       // in which it was reached
    int parent = -1, move = -1;
    bool is_clear = false;   // known to be
    bool is_closed = false;  // expanded, or not clear
  };
  void begin(const Placement& placement, double limit);
  State& state(int pose);
  double heuristic(int pose) const;
  void push(const Entry& entry);
  PosePath search(PlacementCosts& costs, const Settings& settings, planning::Clock& clock,
                  Statistics& statistics);
  void expand(PlacementCosts& costs, int pose, double g, const Settings& settings);
  PosePath path_to_goal() const;
  static bool solve_all(PlacementCosts& costs, PosePath& path);

  const PoseGraph& graph_;
  RemainingDistance& remaining_;
  std::vector<const double*> to_goal_;  // of the fingers' spheres
  std::vector<Entry> heap_;
  std::vector<State> states_;  // poses
  int round_ = 0;
};

/// Searches a lattice with lazily evaluated stabilities. Without regrasps if that can be done: then
/// the cost is the least over all paths through the lattice and all placements of the fingers. With
/// regrasps it is the least in small lattices only; else lower_bound says what is proven.
Route search_lattice(const PoseGraph& graph, Evaluator& evaluator, planning::Clock& clock,
                     Statistics& statistics);

}  // namespace graspless::fingertip
