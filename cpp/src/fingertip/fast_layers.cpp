// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Routes with any number of regrasps, by dynamic programming over bounds.
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "fingertip/fast_search.hpp"

namespace graspless::fingertip {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::size_t kRoutes = 16;  // looked at together

/// Where a route may be: on a candidate, or at a hub.
struct Place {
  int regrasps, pose;
  bool at_hub;
  int index;
};

/// Least costs from the start to every (regrasps, pose, candidate) and (regrasps, pose, hub); the
/// regrasp is paid for on the way out of the hub.
class Layers {
 public:
  Layers(FastSearch& search, int max_regrasps)
      : search_(search), layers_(max_regrasps + 1), poses_(search.query.num_poses()) {}

  /// Finds them anew; the least cost of a route.
  double update() {
    candidates_ = search_.candidates.size();
    cells_.assign(static_cast<std::size_t>(layers_) * static_cast<std::size_t>(poses_), {});
    for (int pose = 0; pose < poses_; ++pose) {
      for (int r = 0; r < layers_; ++r) arrive(r, pose);
      if (pose == 0 || pose == poses_ - 1) continue;  // no use in a regrasp there
      for (int r = 0; r + 1 < layers_; ++r) {
        take(r, pose);
        put(r, pose);
      }
    }
    rank_goals();
    return goals_.empty() ? kInfinity : goals_.front().first;
  }

  /// The cheapest routes to as many different goals, cheapest first, each as places from the last
  /// to the first.
  std::vector<std::vector<Place>> best(std::size_t count) {
    std::vector<std::vector<Place>> routes;
    for (std::size_t i = 0; i < std::min(count, goals_.size()); ++i) {
      routes.push_back(back_from(goals_[i].second));
    }
    return routes;
  }

 private:
  struct Step {
    double cost = kInfinity;
    int from = -1;  // candidates: the hub, or -1 along an arc; hubs: see from_hub
    bool from_hub = false;
  };
  struct Cell {
    std::vector<Step> candidates, hubs;
  };
  Cell& cell(int r, int pose) {
    return cells_[static_cast<std::size_t>(pose) * static_cast<std::size_t>(layers_) +
                  static_cast<std::size_t>(r)];
  }
  static Step& at(std::vector<Step>& steps, int i) { return steps[static_cast<std::size_t>(i)]; }

  void arrive(int r, int pose) {
    std::vector<Step>& here = cell(r, pose).candidates;
    here.resize(static_cast<std::size_t>(candidates_));
    for (int c = 0; c < candidates_; ++c) {
      if (pose == 0) {
        at(here, c).cost = r == 0 ? 0 : kInfinity;
      } else {
        at(here, c).cost =
            at(cell(r, pose - 1).candidates, c).cost + search_.candidates.arc(c, pose - 1);
      }
    }
  }

  // From placements with r regrasps to hubs, and from hubs with one regrasp less to hubs.
  void take(int r, int pose) {
    std::vector<Step>& hubs = cell(r, pose).hubs;
    hubs.resize(static_cast<std::size_t>(search_.hubs.size()));
    for (int hub = 0; hub < search_.hubs.size(); ++hub) {
      if (search_.hubs.members(hub).empty() || !search_.hubs.may_rest(hub, pose)) continue;
      for (const int c : search_.hubs.members(hub)) {
        const double cost = at(cell(r, pose).candidates, c).cost;
        if (cost < at(hubs, hub).cost) at(hubs, hub) = {cost, c, false};
      }
    }
    if (r > 0) take_from_hubs(r, pose);
  }

  // One finger down and another up, through a placement that need not carry the object anywhere.
  void take_from_hubs(int r, int pose) {
    std::vector<Step>& before = cell(r - 1, pose).hubs;
    for (int hub = 0; hub < static_cast<int>(before.size()); ++hub) {
      if (at(before, hub).cost == kInfinity) continue;
      const double cost = at(before, hub).cost + search_.query.options.regrasp_cost;
      for (int location = 0; location < search_.query.locations.size(); ++location) {
        const Placement kept = search_.hubs.kept(hub);
        if (std::find(kept.begin(), kept.end(), location) != kept.end()) continue;
        const Placement placement = with(kept, location);
        if (!is_feasible(search_.query, pose, placement)) continue;
        for (const std::int32_t finger : kept) {
          if (finger >= 0) reach(r, pose, search_.hubs.open(without(placement, finger)), cost, hub);
        }
      }
    }
  }

  void reach(int r, int pose, int hub, double cost, int from) {
    std::vector<Step>& hubs = cell(r, pose).hubs;
    if (hub >= static_cast<int>(hubs.size())) hubs.resize(static_cast<std::size_t>(hub) + 1);
    if (cost < at(hubs, hub).cost && search_.hubs.may_rest(hub, pose)) {
      at(hubs, hub) = {cost, from, true};
    }
  }

  void put(int r, int pose) {
    std::vector<Step>& hubs = cell(r, pose).hubs;
    std::vector<Step>& next = cell(r + 1, pose).candidates;
    for (int hub = 0; hub < static_cast<int>(hubs.size()); ++hub) {
      const double cost = at(hubs, hub).cost + search_.query.options.regrasp_cost;
      for (const int c : search_.hubs.members(hub)) {
        if (cost < at(next, c).cost &&
            is_feasible(search_.query, pose, search_.candidates.placement(c))) {
          at(next, c) = {cost, hub, true};
        }
      }
    }
  }

  void rank_goals() {
    goals_.clear();
    for (int r = 0; r < layers_; ++r) {
      for (int c = 0; c < candidates_; ++c) {
        const double cost = at(cell(r, poses_ - 1).candidates, c).cost;
        if (cost < kInfinity) goals_.push_back({cost, {r, poses_ - 1, false, c}});
      }
    }
    std::stable_sort(goals_.begin(), goals_.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
  }

  std::vector<Place> back_from(Place place) {
    std::vector<Place> places;
    while (true) {
      places.push_back(place);
      Cell& here = cell(place.regrasps, place.pose);
      const Step step = at(place.at_hub ? here.hubs : here.candidates, place.index);
      if (!place.at_hub && !step.from_hub) {
        if (place.pose-- == 0) break;
      } else {
        if (step.from_hub) --place.regrasps;
        place.at_hub = step.from_hub;
        place.index = step.from;
      }
    }
    return places;
  }

  FastSearch& search_;
  const int layers_, poses_;
  int candidates_ = 0;
  std::vector<Cell> cells_;
  std::vector<std::pair<double, Place>> goals_;
};

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
  route.lower_bound = search.least_displacement;
  const double regrasp_cost = search.query.options.regrasp_cost;
  std::vector<Question> questions;
  for (int regrasps = std::min(2, max_regrasps); regrasps <= max_regrasps;) {
    Layers layers(search, regrasps);
    const double cost = layers.update();
    const double more = search.least_displacement + (regrasps + 1) * regrasp_cost;
    route.lower_bound =
        std::max(route.lower_bound, regrasps < max_regrasps ? std::min(cost, more) : cost);
    if (route.lower_bound >= search.limit) break;
    if (cost > more && regrasps < max_regrasps) {
      ++regrasps;
      continue;
    }
    if (cost == kInfinity) break;
    if (search.clock.is_out() || !search.clock.spend()) return route;
    const std::vector<std::vector<Place>> routes = layers.best(kRoutes);
    questions.clear();
    if (is_settled(search, routes, questions)) {
      route.found = true;
      route.cost = cost;
      route.nodes = nodes(search, routes.front());
      break;
    }
    search.solve(questions);
  }
  route.is_complete = true;
  return route;
}

}  // namespace graspless::fingertip
