// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Placements at which the object rests on all fingers but one, and the best routes through them.
#include "fingertip/lazy/hubs.hpp"

#include <algorithm>
#include <utility>

#include "graspless/watch.hpp"

namespace graspless::fingertip {

Hubs::Hubs(const PoseGraph& graph, const StabilityBounds& bounds, const Candidates& candidates)
    : graph_(graph), bounds_(bounds), candidates_(candidates) {
  std::unordered_map<int, int> slot_of;
  for (int pose = 0; pose < graph.num_poses(); ++pose) {
    const int instant = graph.rest_instant(pose);
    const auto [entry, is_new] = slot_of.emplace(instant, static_cast<int>(instants_.size()));
    if (is_new) instants_.push_back(instant);
    slots_.push_back(entry->second);
  }
}

int Hubs::open(const Placement& kept) {
  const auto [entry, is_new] = index_.emplace(kept, size());
  if (is_new) {
    kept_.push_back(kept);
    members_.emplace_back();
    ranked_.emplace_back();
    neighbors_.emplace_back();
    known_.resize(known_.size() + instants_.size(), Known::open);
    const auto poses = static_cast<std::size_t>(graph_.num_poses());
    least_.resize(least_.size() + poses);
    memory_ += static_cast<std::int64_t>(poses * sizeof(Least));
  }
  return entry->second;
}

void Hubs::link() {
  for (; linked_ < candidates_.size(); ++linked_) {
    poll();
    const Placement placement = candidates_.placement(linked_);
    for (const std::int32_t location : placement) {
      if (location < 0) break;
      const int hub = open(without(placement, location));
      members_[static_cast<std::size_t>(hub)].push_back(linked_);
      compare(hub, linked_);
    }
  }
}

const std::vector<Hubs::Neighbor>& Hubs::neighbors(int hub) {
  if (!neighbors_[static_cast<std::size_t>(hub)].empty()) {
    return neighbors_[static_cast<std::size_t>(hub)];
  }
  std::vector<Neighbor> found;
  const Placement kept = this->kept(hub);
  for (int location = 0; location < graph_.locations.size(); ++location) {
    const auto is_apart = [&](std::int32_t finger) {
      return finger < 0 || (finger != location && graph_.locations.are_apart(finger, location));
    };
    if (!std::all_of(kept.begin(), kept.end(), is_apart)) continue;
    for (const std::int32_t finger : kept) {
      if (finger >= 0) found.push_back({open(without(with(kept, location), finger)), location});
    }
  }
  memory_ += static_cast<std::int64_t>(found.size() * sizeof(Neighbor));
  neighbors_[static_cast<std::size_t>(hub)] = std::move(found);
  return neighbors_[static_cast<std::size_t>(hub)];
}

bool Hubs::may_be_stable(int hub, int pose) {
  Known& state = known(hub, slot(pose));
  if (state == Known::open &&
      static_cast<double>(bounds_.bound(graph_.rest_instant(pose), kept(hub))) <
          graph_.options.min_stability) {
    state = Known::unstable;
  }
  return state != Known::unstable;
}

Hubs::Regrasp Hubs::best(int hub, int pose) {
  if (has_risen(least(hub)[pose], pose)) compare_again(hub, pose);
  const Least& now = least(hub)[pose];
  Regrasp best;
  best.before = now.first;
  best.after = now.second;
  const double cost = now.before + now.after + graph_.options.regrasp_cost;
  if (cost < best.cost && may_be_stable(hub, pose)) best.cost = cost;
  return best;
}

/// Of equal costs the first member's counts.
void Hubs::compare(int hub, int c) {
  const Candidates::Sums sums = candidates_.sums(c);
  Least* least = this->least(hub);
  for (int pose = 0; pose < graph_.num_poses(); ++pose) {
    if (sums.before[pose] < least[pose].before) {
      least[pose].before = sums.before[pose];
      least[pose].first = c;
    }
    if (sums.after[pose] < least[pose].after) {
      least[pose].after = sums.after[pose];
      least[pose].second = c;
    }
  }
}

/// Members by ascending least arc: what they cost from pose to pose is no less.
const std::vector<Candidates::Reach>& Hubs::ranked(int hub) {
  std::vector<Candidates::Reach>& ranked = ranked_[static_cast<std::size_t>(hub)];
  if (ranked.size() == members(hub).size()) return ranked;
  ranked.clear();
  ranked.reserve(members(hub).size());
  for (const int c : members(hub)) ranked.push_back(candidates_.reach(c));
  std::sort(ranked.begin(), ranked.end());
  memory_ += static_cast<std::int64_t>(ranked.size() * sizeof(ranked.front()));
  return ranked;
}

/// The same as compare() with all members, at one pose.
void Hubs::compare_again(int hub, int pose) {
  constexpr double kRounding = 1e-9;  // of costs summed in another order
  Least& least = this->least(hub)[pose];
  least = Least();
  for (const Candidates::Reach& reach : ranked(hub)) {
    const double each = reach.least_arc * (1 - kRounding);
    const bool may_come = each * pose <= least.before;
    const bool may_go = each * (graph_.num_arcs() - pose) <= least.after;
    if (!may_come && !may_go) break;
    const bool comes = may_come && pose <= reach.first_blocked;
    const bool goes = may_go && pose > reach.last_blocked;
    if (!comes && !goes) continue;
    const int c = reach.candidate;
    const Candidates::Sums sums = candidates_.sums(c);
    const double before = sums.before[pose], after = sums.after[pose];
    if (before < least.before || (before == least.before && c < least.first)) {
      least.before = before;
      least.first = c;
    }
    if (after < least.after || (after == least.after && c < least.second)) {
      least.after = after;
      least.second = c;
    }
  }
}

/// Costs never fall: while those of the least have not risen, no other member's is less.
bool Hubs::has_risen(const Least& least, int pose) const {
  const auto may_have = [&](int c) { return c >= 0 && candidates_.is_looked_at(c); };
  return (may_have(least.first) && candidates_.before(least.first, pose) != least.before) ||
         (may_have(least.second) && candidates_.after(least.second, pose) != least.after);
}

bool Hubs::request(int hub, int pose, std::vector<StabilityQuery>& queries) {
  Known& state = known(hub, slot(pose));
  if (state == Known::open) {
    state = Known::requested;
    StabilityQuery query;
    query.of = StabilityQuery::Of::hub;
    query.index = hub;
    query.slot = slot(pose);
    query.instant = graph_.rest_instant(pose);
    query.placement = kept(hub);
    queries.push_back(std::move(query));
  }
  return state == Known::requested;
}

void Hubs::record(const StabilityQuery& query) {
  known(query.index, query.slot) = query.z > 0 ? Known::stable : Known::unstable;
}

}  // namespace graspless::fingertip
