// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Routes with any number of regrasps, by dynamic programming over bounds.
#include "fingertip/lazy/dp_table.hpp"

#include <algorithm>

namespace graspless::fingertip {

namespace {

template <typename T>
T& at(std::vector<T>& values, int i) {
  return values[static_cast<std::size_t>(i)];
}

}  // namespace

DpTable::DpTable(LazyState& lazy, int max_regrasps, bool is_counted)
    : lazy_(lazy), max_(max_regrasps), is_counted_(is_counted), poses_(lazy.graph.num_poses()) {}

double DpTable::cost(const Cell& cell, int c) {
  const auto i = static_cast<std::size_t>(c);
  return cell.set_down.empty() ? cell.arrived[i] : std::min(cell.arrived[i], cell.set_down[i].cost);
}

double DpTable::update() {
  candidates_ = lazy_.candidates.size();
  cells_.assign(static_cast<std::size_t>(max_ + 1) * static_cast<std::size_t>(poses_), {});
  for (int pose = 0; pose < poses_; ++pose) {
    for (int r = 0; r <= (is_counted_ ? max_ : 0); ++r) displace(r, pose);
    if (pose == 0 || pose == poses_ - 1) continue;  // no use in a regrasp there
    least_at_hub_.assign(static_cast<std::size_t>(lazy_.hubs.size()), kInfinity);
    for (int r = 0; r < max_; ++r) {
      if (is_counted_ || r == 0) lift(r, pose);
      if (r > 0) lift_again(r, pose);
      set_down(r, pose);
    }
  }
  rank_goals();
  return goals_.empty() ? kInfinity : goals_.front().first;
}

std::vector<std::vector<DpState>> DpTable::best(std::size_t count) {
  std::vector<std::vector<DpState>> routes;
  for (std::size_t i = 0; i < std::min(count, goals_.size()); ++i) {
    routes.push_back(back_from(goals_[i].second));
  }
  return routes;
}

void DpTable::displace(int layer, int pose) {
  std::vector<double>& here = cell(layer, pose).arrived;
  here.assign(static_cast<std::size_t>(candidates_), kInfinity);
  if (pose == 0) {
    if (layer == 0) here.assign(static_cast<std::size_t>(candidates_), 0.0);
    return;
  }
  Cell& before = cell(layer, pose - 1);
  for (int c = 0; c < candidates_; ++c) {
    const double from = cost(before, c);
    if (from < kInfinity) at(here, c) = from + lazy_.candidates.arc(c, pose - 1);
  }
}

// A finger goes.
void DpTable::lift(int layer, int pose) {
  const std::vector<double>& arrived = cell(layer, pose).arrived;
  for (int hub = 0; hub < lazy_.hubs.size(); ++hub) {
    if (lazy_.hubs.members(hub).empty() || !lazy_.hubs.may_be_stable(hub, pose)) continue;
    for (const int c : lazy_.hubs.members(hub)) {
      const double here = arrived[static_cast<std::size_t>(c)];
      if (here < kInfinity) reach(layer, pose, hub, {here, c, false, layer});
    }
  }
}

// A finger comes and another goes, through a placement that need not carry the object anywhere.
void DpTable::lift_again(int layer, int pose) {
  const std::vector<Step> before = cell(layer - 1, pose).hubs;
  for (std::size_t hub = 0; hub < before.size(); ++hub) {
    if (before[hub].cost == kInfinity) continue;
    const Step step{before[hub].cost + lazy_.graph.options.regrasp_cost, static_cast<int>(hub),
                    true, layer - 1};
    for (const Hubs::Neighbor& next : lazy_.hubs.neighbors(static_cast<int>(hub))) {
      if (next.hub < static_cast<int>(least_at_hub_.size()) &&
          step.cost >= at(least_at_hub_, next.hub)) {
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
void DpTable::reach(int layer, int pose, int hub, const Step& step) {
  std::vector<Step>& hubs = cell(layer, pose).hubs;
  const auto size = static_cast<std::size_t>(lazy_.hubs.size());
  if (hubs.size() < size) hubs.resize(size);
  if (least_at_hub_.size() < size) least_at_hub_.resize(size, kInfinity);
  if (step.cost >= at(least_at_hub_, hub)) return;
  at(least_at_hub_, hub) = step.cost;
  at(hubs, hub) = step;
}

// And comes elsewhere.
void DpTable::set_down(int layer, int pose) {
  std::vector<Step>& hubs = cell(layer, pose).hubs;
  Cell& next = cell(is_counted_ ? layer + 1 : 0, pose);
  for (int hub = 0; hub < static_cast<int>(hubs.size()); ++hub) {
    const double here = at(hubs, hub).cost + lazy_.graph.options.regrasp_cost;
    if (here == kInfinity) continue;
    next.set_down.resize(static_cast<std::size_t>(candidates_));
    for (const int c : lazy_.hubs.members(hub)) {
      if (here >= cost(next, c)) continue;
      if (!is_feasible(lazy_.graph, pose, lazy_.candidates.placement(c))) continue;
      at(next.set_down, c) = {here, hub, true, layer};
    }
  }
}

void DpTable::rank_goals() {
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

std::vector<DpState> DpTable::back_from(DpState state) {
  std::vector<DpState> states;
  while (true) {
    states.push_back(state);
    Cell& here = cell(state.layer, state.pose);
    const bool was_set_down = !state.at_hub && !here.set_down.empty() &&
                              at(here.set_down, state.index).cost < at(here.arrived, state.index);
    if (state.at_hub || was_set_down) {
      const Step& step = at(was_set_down ? here.set_down : here.hubs, state.index);
      state = {step.layer, state.pose, step.from_hub, step.from};
    } else if (state.pose-- == 0) {
      return states;
    }
  }
}

}  // namespace graspless::fingertip
