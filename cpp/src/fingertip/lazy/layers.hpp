// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Routes with any number of regrasps, by dynamic programming over bounds.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "fingertip/lazy/search.hpp"

namespace graspless::fingertip {

/// Where a route may be: on a candidate, or at a hub.
struct Place {
  int layer, pose;
  bool at_hub;
  int index;
};

/// Least costs from the start to every (layer, pose, candidate) and (layer, pose, hub); the regrasp
/// is paid for on the way out of the hub. With regrasps counted, there is a layer for each number
/// of them. Without, candidates have but one, and hubs one for each number of regrasps at this pose
/// before.
class Layers {
 public:
  Layers(FastSearch& search, int max_regrasps, bool is_counted);

  /// Finds them anew; the least cost of a route.
  double update();

  /// The cheapest routes to as many different goals, cheapest first, each as places from the last
  /// to the first.
  std::vector<std::vector<Place>> best(std::size_t count);

 private:
  struct Step {
    double cost = std::numeric_limits<double>::infinity();
    int from = -1;  // candidate or hub
    bool from_hub = false;
    int layer = 0;  // of `from`
  };
  struct Cell {
    std::vector<double> arrived;  // candidates, along the arc
    std::vector<Step> put;        // candidates, after a regrasp here; empty: none
    std::vector<Step> hubs;
  };
  Cell& cell(int layer, int pose) {
    return cells_[static_cast<std::size_t>(pose) * static_cast<std::size_t>(max_ + 1) +
                  static_cast<std::size_t>(layer)];
  }
  static double cost(const Cell& cell, int c);
  void arrive(int layer, int pose);
  void take(int layer, int pose);
  void take_from_hubs(int layer, int pose);
  void reach(int layer, int pose, int hub, const Step& step);
  void put(int layer, int pose);
  void rank_goals();
  std::vector<Place> back_from(Place place);

  FastSearch& search_;
  const int max_;
  const bool is_counted_;
  const int poses_;
  int candidates_ = 0;
  std::vector<Cell> cells_;
  std::vector<double> least_at_hub_;  // at this pose, in the layers so far
  std::vector<std::pair<double, Place>> goals_;
};

}  // namespace graspless::fingertip
