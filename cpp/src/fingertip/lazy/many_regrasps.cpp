// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The search where more than one regrasp may be needed.
#include <algorithm>
#include <limits>
#include <vector>

#include "fingertip/lazy/dp_table.hpp"
#include "fingertip/lazy/state.hpp"

namespace graspless::fingertip {

namespace {

constexpr std::size_t kRoutes = 16;  // looked at together

/// Placements that can carry the object along any arc, and their hubs.
void list_all(LazyState& lazy) {
  lazy.candidates.keep_inner_arcs();
  for (int arc = 0; arc < lazy.graph.num_arcs(); ++arc) {
    open_all(lazy, clear_locations(lazy.graph, arc, arc + 1), lazy.candidates.instants(arc));
  }
  for (int c = 0; c < lazy.candidates.size(); ++c) lazy.candidates.refresh(c);
  lazy.hubs.link();
}

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

Route search_many_regrasps(LazyState& lazy, int max_regrasps) {
  list_all(lazy);
  Route route;
  route.lower_bound = lazy.least_displacement + 2 * lazy.graph.options.regrasp_cost;
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
