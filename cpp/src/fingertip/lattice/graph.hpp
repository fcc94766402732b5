// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <set>
#include <unordered_map>
#include <vector>

#include "fingertip/lattice/way.hpp"
#include "fingertip/model/path_query.hpp"

namespace graspless::fingertip {

/// A* over poses and placements, regrasps included: the manipulation-feasibility graph of a
/// lattice, with a hub (pose, kept fingers) between the placements of a regrasp.
class LatticeGraph {
 public:
  struct Manner {
    double regrasp_cost;  // that the search reckons with [m]
    double haste;         // what is left of the way counts so many times
    std::size_t max_nodes;
  };

  LatticeGraph(Workshop& workshop, LatticeSpace& space, LatticeBounds& bounds,
               LatticeDistances& distances);

  /// A route, its cost by (9) and (10). Complete when it ran to its end within max_nodes and
  /// refused no hub; its lower_bound holds when haste is 1 and regrasp_cost the true one.
  Route search(const Manner& manner, planning::Clock& clock, Statistics& statistics);
  /// How many nodes there are at most, hubs aside.
  double num_nodes() const;

 private:
  using Key = std::int64_t;  // fingers x poses
  struct Node {
    double g;
    Key parent = -1;
    int move = -1;  // from the parent; -1: to or from a hub
    bool is_closed = false;
  };
  struct Entry {
    double f, g;
    Key key, parent;
    int move;                                   // -1: to or from a hub
    bool operator<(const Entry& other) const {  // the top of a std heap is its greatest
      return f > other.f || (f == other.f && g < other.g);
    }
  };

  Route search_once(planning::Clock& clock, Statistics& statistics, Key& goal);
  int id_of(const Placement& placement);
  const Placement& placement(Key key) const;
  int pose(Key key) const;
  LatticeCosts& costs(Key key);
  bool is_clear(int pose, const Placement& placement);
  double left(int pose, const Placement& placement);
  void push(double g, int pose, const Placement& placement, Key parent, int move);
  void push_all(double g, int pose, const Placement& kept, int first, Key parent);
  bool settle(Entry& entry);
  void expand(Key key, double g);
  void lift_fingers(Key key, double g);
  Route route_to(Key key) const;
  bool holds_at_rest(Key goal);

  Workshop& workshop_;
  LatticeSpace& space_;
  LatticeBounds& bounds_;
  LatticeDistances& distances_;
  int count_;  // of fingers
  Manner manner_{};
  std::set<Key> refused_;  // hubs at which the fingers kept do not hold the object after all
  std::vector<Entry> heap_;
  std::unordered_map<Key, Node> nodes_;
  std::map<Placement, int> ids_;
  std::vector<Placement> placements_;
  std::vector<std::unique_ptr<LatticeCosts>> costs_;
};

}  // namespace graspless::fingertip
