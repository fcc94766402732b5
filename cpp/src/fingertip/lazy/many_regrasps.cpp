// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Routes with any number of regrasps, by dynamic programming over bounds.
#include <algorithm>
#include <limits>

#include "graspless/watch.hpp"

#include "fingertip/lazy/state.hpp"

namespace graspless::fingertip {
namespace {

constexpr std::size_t kRoutes = 16;  // looked at together

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
  DpTable(LazyState& lazy, int max_regrasps, bool is_counted)
      : lazy_(lazy), max_(max_regrasps), is_counted_(is_counted), poses_(lazy.graph.num_poses()) {}

  /// Finds them anew. Returns the least cost of a route.
  double update() {
    candidates_ = lazy_.candidates.size();
    cells_.assign(static_cast<std::size_t>(max_ + 1) * static_cast<std::size_t>(poses_), {});
    for (int pose = 0; pose < poses_; ++pose) {
      for (int r = 0; r <= (is_counted_ ? max_ : 0); ++r) displace(r, pose);
      if (pose == 0 || pose == poses_ - 1) continue;  // no use in a regrasp there
      least_at_hub_.assign(lazy_.hubs.size(), kInfinity);
      for (int r = 0; r < max_; ++r) {
        if (is_counted_ || r == 0) lift(r, pose);
        if (r > 0) lift_again(r, pose);
        set_down(r, pose);
      }
    }
    rank_goals();
    return goals_.empty() ? kInfinity : goals_.front().first;
  }

  /// The cheapest routes to as many different goals, cheapest first, each as states from the last
  /// to the first.
  std::vector<std::vector<DpState>> best(std::size_t count) {
    std::vector<std::vector<DpState>> routes;
    for (std::size_t i = 0; i < std::min(count, goals_.size()); ++i) {
      routes.push_back(back_from(goals_[i].second));
    }
    return routes;
  }

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
  static double cost(const Cell& cell, int c) {
    const auto i = static_cast<std::size_t>(c);
    return cell.set_down.empty() ? cell.arrived[i]
                                 : std::min(cell.arrived[i], cell.set_down[i].cost);
  }

  void displace(int layer, int pose) {
    poll();
    std::vector<double>& here = cell(layer, pose).arrived;
    here.assign(candidates_, kInfinity);
    if (pose == 0) {
      if (layer == 0) here.assign(candidates_, 0.0);
      return;
    }
    Cell& before = cell(layer, pose - 1);
    for (int c = 0; c < candidates_; ++c) {
      const double from = cost(before, c);
      if (from < kInfinity) here[c] = from + lazy_.candidates.arc(c, pose - 1);
    }
  }

  // A finger goes.
  void lift(int layer, int pose) {
    const std::vector<double>& arrived = cell(layer, pose).arrived;
    for (int hub = 0; hub < lazy_.hubs.size(); ++hub, poll()) {
      if (lazy_.hubs.members(hub).empty() || !lazy_.hubs.may_be_stable(hub, pose)) continue;
      for (const Hubs::Member& member : lazy_.hubs.members(hub)) {
        const double here = arrived[member.candidate];
        if (here < kInfinity) reach(layer, pose, hub, {here, member.candidate, false, layer});
      }
    }
  }

  // A finger comes and another goes, through a placement that need not carry the object anywhere.
  void lift_again(int layer, int pose) {
    const std::vector<Step> before = cell(layer - 1, pose).hubs;
    for (std::size_t hub = 0; hub < before.size(); ++hub, poll()) {
      if (before[hub].cost == kInfinity) continue;
      const Step step{before[hub].cost + lazy_.graph.options.regrasp_cost, static_cast<int>(hub),
                      true, layer - 1};
      for (const Hubs::Neighbor& next : lazy_.hubs.neighbors(static_cast<int>(hub))) {
        if (next.hub < static_cast<int>(least_at_hub_.size()) &&
            step.cost >= least_at_hub_[next.hub]) {
          continue;
        }
        if (lazy_.graph.is_clear(pose, next.location) && lazy_.hubs.may_be_stable(next.hub, pose)) {
          reach(layer, pose, next.hub, step);
        }
      }
    }
    lazy_.watch_memory();
  }

  // With more regrasps before, a hub is of use only at a lower cost.
  void reach(int layer, int pose, int hub, const Step& step) {
    std::vector<Step>& hubs = cell(layer, pose).hubs;
    const auto size = static_cast<std::size_t>(lazy_.hubs.size());
    if (hubs.size() < size) hubs.resize(size);
    if (least_at_hub_.size() < size) least_at_hub_.resize(size, kInfinity);
    if (step.cost >= least_at_hub_[hub]) return;
    least_at_hub_[hub] = step.cost;
    hubs[hub] = step;
  }

  // And comes elsewhere.
  void set_down(int layer, int pose) {
    std::vector<Step>& hubs = cell(layer, pose).hubs;
    Cell& next = cell(is_counted_ ? layer + 1 : 0, pose);
    for (int hub = 0; hub < static_cast<int>(hubs.size()); ++hub, poll()) {
      const double here = hubs[hub].cost + lazy_.graph.options.regrasp_cost;
      if (here == kInfinity) continue;
      next.set_down.resize(candidates_);
      for (const Hubs::Member& member : lazy_.hubs.members(hub)) {
        const int c = member.candidate;
        if (here >= cost(next, c)) continue;
        if (!is_feasible(lazy_.graph, pose, lazy_.candidates.placement(c))) continue;
        next.set_down[c] = {here, hub, true, layer};
      }
    }
  }

  void rank_goals() {
    goals_.clear();
    for (int layer = 0; layer <= (is_counted_ ? max_ : 0); ++layer) {
      for (int c = 0; c < candidates_; ++c) {
        const double here = cost(cell(layer, poses_ - 1), c);
        if (here < kInfinity) goals_.push_back({here, {layer, poses_ - 1, false, c}});
      }
    }
    std::stable_sort(goals_.begin(), goals_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  std::vector<DpState> back_from(DpState state) {
    std::vector<DpState> states;
    while (true) {
      states.push_back(state);
      Cell& here = cell(state.layer, state.pose);
      const bool was_set_down = !state.at_hub && !here.set_down.empty() &&
                                here.set_down[state.index].cost < here.arrived[state.index];
      if (state.at_hub || was_set_down) {
        const Step& step = (was_set_down ? here.set_down : here.hubs)[state.index];
        state = {step.layer, state.pose, step.from_hub, step.from};
      } else if (state.pose-- == 0) {
        return states;
      }
    }
  }

  LazyState& lazy_;
  const int max_;
  const bool is_counted_;
  const int poses_;
  int candidates_ = 0;
  std::vector<Cell> cells_;
  std::vector<double> least_at_hub_;  // at this pose, in the layers so far
  std::vector<std::pair<double, DpState>> goals_;
};

/// Asks what is open on the route, last place first; false when nothing is.
bool request(LazyState& lazy, const std::vector<DpState>& states,
             std::vector<StabilityQuery>& queries) {
  bool any = false;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const DpState& last = states[i];
    if (last.at_hub) {
      any |= lazy.hubs.request(last.index, last.pose, queries);
      continue;
    }
    while (i + 1 < states.size() && !states[i + 1].at_hub && states[i + 1].index == last.index) ++i;
    any |= lazy.candidates.request(last.index, states[i].pose, last.pose, queries);
  }
  return any;
}

bool refresh(LazyState& lazy, const std::vector<DpState>& states) {
  bool changed = false;
  for (const DpState& state : states) {
    if (!state.at_hub) changed |= lazy.candidates.refresh(state.index);
  }
  return changed;
}

/// Takes up new bounds on all routes and asks what is open on those without; whether there is
/// nothing of either on the first.
bool is_settled(LazyState& lazy, const std::vector<std::vector<DpState>>& routes,
                std::vector<StabilityQuery>& queries) {
  bool is_first_settled = true;
  for (std::size_t i = 0; i < routes.size(); ++i) {
    const bool is_open = refresh(lazy, routes[i]) || request(lazy, routes[i], queries);
    if (i == 0) is_first_settled = !is_open;
  }
  return is_first_settled;
}

int num_regrasps(const std::vector<DpState>& states) {
  return static_cast<int>(std::count_if(states.begin(), states.end(),
                                        [](const DpState& state) { return state.at_hub; }));
}

std::vector<Node> nodes(LazyState& lazy, const std::vector<DpState>& states) {
  std::vector<Node> nodes;
  for (std::size_t i = states.size(); i-- > 0;) {
    const DpState& state = states[i];
    if (!state.at_hub) {
      nodes.push_back({state.pose, lazy.candidates.placement(state.index)});
    } else if (i > 0 && states[i - 1].at_hub) {  // two regrasps at one pose
      Placement between = lazy.hubs.kept(state.index);
      for (const std::int32_t location : lazy.hubs.kept(states[i - 1].index)) {
        if (location >= 0 && std::find(between.begin(), between.end(), location) == between.end()) {
          between = with(between, location);
        }
      }
      nodes.push_back({state.pose, between});
    }
  }
  return nodes;
}

}  // namespace

Route search_many_regrasps(LazyState& lazy) {
  const int max_regrasps = lazy.graph.options.max_regrasps;
  open_all(lazy);
  Route route;
  route.lower_bound = lazy.displacements.least() + 2 * lazy.graph.options.regrasp_cost;
  std::vector<StabilityQuery> queries;
  bool is_counted = false;  // only where the cheapest route has too many
  while (true) {
    DpTable layers(lazy, max_regrasps, is_counted);
    const double cost = layers.update();
    route.lower_bound = std::max(route.lower_bound, cost);
    if (cost >= lazy.limit || cost == kInfinity) break;
    if (lazy.clock.is_out() || !lazy.clock.spend()) return route;
    const std::vector<std::vector<DpState>> routes = layers.best(kRoutes);
    queries.clear();
    if (!is_settled(lazy, routes, queries)) {
      lazy.solve(queries);
    } else if (!is_counted && num_regrasps(routes.front()) > max_regrasps) {
      is_counted = true;
    } else {
      route.found = true;
      route.cost = route.lower_bound = cost;
      route.nodes = nodes(lazy, routes.front());
      break;
    }
  }
  route.is_complete = true;
  return route;
}

}  // namespace graspless::fingertip
