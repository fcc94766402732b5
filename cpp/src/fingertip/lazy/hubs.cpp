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
    neighbors_.emplace_back();
    known_.resize(known_.size() + instants_.size(), Known::open);
  }
  return entry->second;
}

void Hubs::link() {
  for (; linked_ < candidates_.size(); ++linked_) {
    poll();
    const Placement placement = candidates_.placement(linked_);
    for (const std::int32_t location : placement) {
      if (location < 0) break;
      members_[static_cast<std::size_t>(open(without(placement, location)))].push_back(linked_);
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
  Regrasp best;
  double before = std::numeric_limits<double>::infinity(), after = before;
  for (const int c : members(hub)) {
    if (candidates_.before(c, pose) < before) {
      before = candidates_.before(c, pose);
      best.before = c;
    }
    if (candidates_.after(c, pose) < after) {
      after = candidates_.after(c, pose);
      best.after = c;
    }
  }
  const double cost = before + after + graph_.options.regrasp_cost;
  if (cost < best.cost && may_be_stable(hub, pose)) best.cost = cost;
  return best;
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
