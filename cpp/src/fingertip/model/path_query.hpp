// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "fingertip/model/evaluator.hpp"
#include "fingertip/model/instants.hpp"
#include "fingertip/model/locations.hpp"

namespace graspless::fingertip {

/// A motion of one degree of freedom, laid out for search: poses 0 ... K, arc i from pose i to pose
/// i + 1, P samples an arc.
struct PathQuery {
  PathQuery(const Problem& problem, const Path& path, const Locations& locations,
            Instants& instants, const Options& options);

  int num_arcs() const { return static_cast<int>(X_WO.size()) - 1; }
  int num_poses() const { return static_cast<int>(X_WO.size()); }
  int instant(int arc, int sample) const;       // of the moving object
  int rest_instant(int pose) const;             // of the object at rest, while a finger regrasps
  bool is_clear(int pose, int location) const;  // of planes and obstacles
  /// How far the sphere's centre moves in one P-th of an arc [m].
  double displacement(int arc, int location) const;

  const Options& options;
  const Locations& locations;
  int num_fingers = 0;  // of the hand
  std::vector<Eigen::Isometry3d> X_WO;
  std::vector<mechanics::Vector6d> twist_O;  // body twist of each arc, over the whole arc
  std::vector<int> instants;                 // arcs x P
  std::vector<int> rest_instants;            // poses
  std::vector<std::uint8_t> clear;           // poses x locations
  std::vector<double> displacements;         // arcs x locations
};

/// Whether the fingers may be there at a pose: each clear, and all apart.
bool is_feasible(const PathQuery& query, int pose, const Placement& placement);

/// Eq. (9) for one arc, from the stabilities of its P samples; infinite when one is 0.
double arc_cost(const PathQuery& query, int arc, const Placement& placement, const double* z);

/// A node of the manipulation-feasibility graph.
struct Node {
  int pose;
  Placement placement;
};

/// A way through the graph. From one node to the next either the pose or one finger changes.
struct Route {
  bool found = false;
  double cost = 0;
  double lower_bound = 0;
  bool is_complete =
      false;  // whether the search ran to its end: not found then means there is none
  std::vector<Node> nodes;
};

int num_regrasps(const Route& route);

/// Uniform cost, or A* with (11): Section 4. Routes of `limit` or more are not looked for: then
/// complete and not found means that there is none below.
Route search_graph(const PathQuery& query, Evaluator& evaluator, bool heuristic,
                   planning::Clock& clock, Statistics& statistics,
                   double limit = std::numeric_limits<double>::infinity());
/// Lazy best-first search over placements. The same cost. Work is shared among the evaluators: with
/// kLanes of them the answer is the same whatever the number of threads. The first one knows all
/// about the route afterwards.
constexpr int kLanes = 8;
Route search_fast(const PathQuery& query, std::vector<Evaluator>& evaluators,
                  planning::Clock& clock, Statistics& statistics,
                  double limit = std::numeric_limits<double>::infinity());

}  // namespace graspless::fingertip
