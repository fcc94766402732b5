// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The search where more than one regrasp may be needed.
#include <algorithm>
#include <limits>
#include <vector>

#include "fingertip/lazy/layers.hpp"

namespace graspless::fingertip {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kRoutes = 16;  // looked at together

/// Placements that can carry the object along any arc, and their hubs.
void list_all(FastSearch& search) {
  search.candidates.keep_middles();
  for (int arc = 0; arc < search.query.num_arcs(); ++arc) {
    open_all(search, clear_locations(search.query, arc, arc + 1), search.candidates.instants(arc));
  }
  for (int c = 0; c < search.candidates.size(); ++c) search.candidates.refresh(c);
  search.hubs.link();
}

/// Asks what is open on the route, last place first; false when nothing is.
bool ask(FastSearch& search, const std::vector<Place>& places, std::vector<Question>& questions) {
  bool any = false;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place& last = places[i];
    if (last.at_hub) {
      any |= search.hubs.ask(last.index, last.pose, questions);
      continue;
    }
    while (i + 1 < places.size() && !places[i + 1].at_hub && places[i + 1].index == last.index) ++i;
    any |= search.candidates.ask(last.index, places[i].pose, last.pose, questions);
  }
  return any;
}

bool refresh(FastSearch& search, const std::vector<Place>& places) {
  bool changed = false;
  for (const Place& place : places) {
    if (!place.at_hub) changed |= search.candidates.refresh(place.index);
  }
  return changed;
}

/// Takes up new bounds on all routes and asks what is open on those without; whether there is
/// nothing of either on the first.
bool is_settled(FastSearch& search, const std::vector<std::vector<Place>>& routes,
                std::vector<Question>& questions) {
  bool is_first_settled = true;
  for (std::size_t i = 0; i < routes.size(); ++i) {
    const bool is_open = refresh(search, routes[i]) || ask(search, routes[i], questions);
    if (i == 0) is_first_settled = !is_open;
  }
  return is_first_settled;
}

int num_regrasps(const std::vector<Place>& places) {
  return static_cast<int>(
      std::count_if(places.begin(), places.end(), [](const Place& place) { return place.at_hub; }));
}

std::vector<Node> nodes(FastSearch& search, const std::vector<Place>& places) {
  std::vector<Node> nodes;
  for (std::size_t i = places.size(); i-- > 0;) {
    const Place& place = places[i];
    if (!place.at_hub) {
      nodes.push_back({place.pose, search.candidates.placement(place.index)});
    } else if (i > 0 && places[i - 1].at_hub) {  // two regrasps at one pose
      Placement between = search.hubs.kept(place.index);
      for (const std::int32_t location : search.hubs.kept(places[i - 1].index)) {
        if (location >= 0 && std::find(between.begin(), between.end(), location) == between.end()) {
          between = with(between, location);
        }
      }
      nodes.push_back({place.pose, between});
    }
  }
  return nodes;
}

}  // namespace

Route search_layers(FastSearch& search, int max_regrasps) {
  list_all(search);
  Route route;
  route.lower_bound = search.least_displacement + 2 * search.query.options.regrasp_cost;
  std::vector<Question> questions;
  bool is_counted = false;  // only where the cheapest route has too many
  while (true) {
    Layers layers(search, max_regrasps, is_counted);
    const double cost = layers.update();
    route.lower_bound = std::max(route.lower_bound, cost);
    if (cost >= search.limit || cost == kInfinity) break;
    if (search.clock.is_out() || !search.clock.spend()) return route;
    const std::vector<std::vector<Place>> routes = layers.best(kRoutes);
    questions.clear();
    if (!is_settled(search, routes, questions)) {
      search.solve(questions);
    } else if (!is_counted && num_regrasps(routes.front()) > max_regrasps) {
      is_counted = true;
    } else {
      route.found = true;
      route.cost = route.lower_bound = cost;
      route.nodes = nodes(search, routes.front());
      break;
    }
  }
  route.is_complete = true;
  return route;
}

}  // namespace graspless::fingertip
