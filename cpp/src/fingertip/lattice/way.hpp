// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "fingertip/lattice/bounds.hpp"
#include "fingertip/lattice/distances.hpp"
#include "fingertip/lattice/space.hpp"

namespace graspless::fingertip {

/// What arcs cost with the fingers at one placement, by (9).
class LatticeCosts {
 public:
  LatticeCosts(LatticeSpace& space, LatticeBounds& bounds, const Options& options,
               const Placement& placement);

  const Placement& placement() const { return placement_; }
  bool is_clear(int pose);  // the fingers of floor, walls and obstacles
  /// At least the cost of an arc between clear poses: exact when its kind is solved; infinite when
  /// it is impossible.
  double cost(int pose, int move);
  bool is_solved(int pose, int move);
  /// Solves the kind of this arc.
  void solve(int pose, int move);

 private:
  struct Weight {
    double value = -1;  // mean of 1 + X_stab / z over the samples; -1: not looked at
    bool is_solved = false;
  };
  Weight& weight(int kind);

  LatticeSpace& space_;
  LatticeBounds& bounds_;
  const Options& options_;
  Placement placement_;
  int count_;
  std::vector<double> speeds_;   // yaws x moves: the largest displacement
  std::vector<Weight> weights_;  // kinds
};

/// A way through the lattice with one placement.
struct LatticeWay {
  bool found = false;
  double cost = std::numeric_limits<double>::infinity();
  std::vector<int> poses, moves;
};

/// Finds ways by A*; holds its tables.
class LatticeAstar {
 public:
  LatticeAstar(LatticeSpace& space, LatticeDistances& distances);

  /// The cheapest way from start to goal below `limit`. What is left of the way costs at least the
  /// distance of the sphere that has the farthest to go: (11) without regrasps. Ways are looked for
  /// by bounds of stability first; then arcs are solved when they turn out to be the best to come
  /// to a pose, not before.
  LatticeWay find(LatticeCosts& costs, double limit, planning::Clock& clock,
                  Statistics& statistics);

  /// Some way below `limit`, found with less work; it may miss what is there.
  LatticeWay find_soon(LatticeCosts& costs, double limit, planning::Clock& clock,
                       Statistics& statistics);

 private:
  struct Manner {
    double limit;
    bool exact;    // solve arcs, instead of taking their bounds
    double haste;  // what is left counts so many times
  };
  struct Entry {
    double f, g;
    int pose, from, move;
    bool operator<(const Entry& other) const {  // the top of a std heap is its greatest
      return f > other.f || (f == other.f && g < other.g);
    }
  };
  void begin(const Placement& placement, double limit);
  double left(int pose) const;
  void push(const Entry& entry);
  LatticeWay search(LatticeCosts& costs, const Manner& manner, planning::Clock& clock,
                    Statistics& statistics);
  void expand(LatticeCosts& costs, int pose, double g, const Manner& manner);
  LatticeWay way_to_goal() const;
  static bool solve_all(LatticeCosts& costs, LatticeWay& way);

  LatticeSpace& space_;
  LatticeDistances& distances_;
  std::vector<const double*> to_goal_;  // of the fingers' spheres
  std::vector<Entry> heap_;
  std::vector<double> best_;  // poses: the least solved cost to come
  std::vector<int> parent_, move_;
  std::vector<int> stamp_, closed_;
  int round_ = 0;
};

}  // namespace graspless::fingertip
