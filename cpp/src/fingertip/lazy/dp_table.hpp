// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Routes with any number of regrasps, by dynamic programming over bounds.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "fingertip/lazy/state.hpp"

namespace graspless::fingertip {

/// Where a route may be: on a candidate, or at a hub.
struct DpState {
  int layer, pose;
  bool at_hub;
  int index;
};

/// Least costs from the start to every (layer, pose, candidate) and (layer, pose, hub); the regrasp
/// is paid for on the way out of the hub. With regrasps counted, there is a layer for each number
/// of them. Without, candidates have but one, and hubs one for each number of regrasps at this pose
/// before.
class DpTable {
 public:
  DpTable(LazyState& lazy, int max_regrasps, bool is_counted);

  /// Finds them anew; the least cost of a route.
  double update();

  /// The cheapest routes to as many different goals, cheapest first, each as states from the last
  /// to the first.
  std::vector<std::vector<DpState>> best(std::size_t count);

 private:
  struct Step {
    double cost = std::numeric_limits<double>::infinity();
    int from = -1;  // candidate or hub
    bool from_hub = false;
    int layer = 0;  // of `from`
  };
  struct Cell {
    std::vector<double> arrived;  // candidates, along the arc
    std::vector<Step> set_down;   // candidates, after a regrasp here; empty: none
    std::vector<Step> hubs;
  };
  Cell& cell(int layer, int pose) {
    return cells_[static_cast<std::size_t>(pose) * static_cast<std::size_t>(max_ + 1) +
                  static_cast<std::size_t>(layer)];
  }
  static double cost(const Cell& cell, int c);
  void displace(int layer, int pose);
  void lift(int layer, int pose);
  void lift_again(int layer, int pose);
  void reach(int layer, int pose, int hub, const Step& step);
  void set_down(int layer, int pose);
  void rank_goals();
  std::vector<DpState> back_from(DpState state);

  LazyState& lazy_;
  const int max_;
  const bool is_counted_;
  const int poses_;
  int candidates_ = 0;
  std::vector<Cell> cells_;
  std::vector<double> least_at_hub_;  // at this pose, in the layers so far
  std::vector<std::pair<double, DpState>> goals_;
};

}  // namespace graspless::fingertip
