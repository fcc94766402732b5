// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Placements at which the object rests on all fingers but one, and the best routes through them.
#include "fingertip/lazy/hubs.hpp"

#include <algorithm>
#include <utility>

#include "graspless/watch.hpp"

#include "geometry/simd.hpp"

namespace graspless::fingertip {
namespace {

GRASPLESS_SIMD void lower(const double* to, std::vector<double>& values) {
  double* value = values.data();
  const std::size_t size = values.size();
  for (std::size_t i = 0; i < size; ++i) value[i] = to[i] < value[i] ? to[i] : value[i];
}

GRASPLESS_SIMD void raise(const double* to, std::vector<double>& values) {
  double* value = values.data();
  const std::size_t size = values.size();
  for (std::size_t i = 0; i < size; ++i) value[i] = to[i] > value[i] ? to[i] : value[i];
}

}  // namespace

Hubs::Hubs(const PoseGraph& graph, const StabilityBounds& bounds,
           const Displacements& displacements, Candidates& candidates)
    : graph_(graph), bounds_(bounds), displacements_(displacements), candidates_(candidates) {
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

void Hubs::link(const Placement& placement, int candidate) {
  for (const std::int32_t location : placement) {
    if (location < 0) break;
    const auto hub = static_cast<std::size_t>(open(without(placement, location)));
    members_[hub].push_back({location, candidate});
    memory_ += static_cast<std::int64_t>(sizeof(Member));
  }
}

void Hubs::unlink_all() {
  for (std::vector<Member>& members : members_) {
    memory_ -= static_cast<std::int64_t>(members.size() * sizeof(Member));
    members.clear();
  }
}

void Hubs::rank() {
  const auto size = kept_.size() * static_cast<std::size_t>(graph_.num_poses());
  memory_ += static_cast<std::int64_t>((size - least_.size()) * sizeof(Least));
  least_.resize(size);
  for (int hub = 0; hub < this->size(); ++hub) rank(hub);
}

/// Members by ascending least arc: what they cost from pose to pose is no less.
void Hubs::rank(int hub) {
  poll();
  std::vector<Member>& members = members_[static_cast<std::size_t>(hub)];
  const auto least_arc = [&](const Member& m) { return displacements_.least_arc(m.location); };
  std::sort(members.begin(), members.end(), [&](const Member& a, const Member& b) {
    const double least_a = least_arc(a), least_b = least_arc(b);
    return least_a != least_b ? least_a < least_b : a.location < b.location;
  });
  const auto is_same = [](const Member& a, const Member& b) { return a.location == b.location; };
  members.erase(std::unique(members.begin(), members.end(), is_same), members.end());
  const auto poses = static_cast<std::size_t>(graph_.num_poses());
  std::vector<double> before(poses, kInfinity), after = before;
  for (const Member& m : members) {
    lower(displacements_.before(m.location), before);
    lower(displacements_.after(m.location), after);
  }
  for (const std::int32_t location : kept(hub)) {
    if (location < 0) break;
    raise(displacements_.before(location), before);
    raise(displacements_.after(location), after);
  }
  for (std::size_t pose = 0; pose < poses; ++pose) {
    least_[index(hub, static_cast<int>(pose))] = {before[pose], after[pose], -1, -1};
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

double Hubs::bound(int hub, int pose) {
  const Least& least = least_[index(hub, pose)];
  const double cost = least.before + least.after + graph_.options.regrasp_cost;
  return cost < kInfinity && may_be_stable(hub, pose) ? cost : kInfinity;
}

Hubs::Regrasp Hubs::best(int hub, int pose) {
  while (has_risen(hub, pose)) compare(hub, pose);
  Regrasp best;
  best.cost = bound(hub, pose);
  if (best.cost == kInfinity) return best;
  best.before = candidate(hub, least_[index(hub, pose)].first);
  best.after = candidate(hub, least_[index(hub, pose)].second);
  return best;
}

/// The placement of the kept fingers and this one.
int Hubs::candidate(int hub, int member) {
  Member& m = members_[static_cast<std::size_t>(hub)][static_cast<std::size_t>(member)];
  if (m.candidate < 0) m.candidate = candidates_.open(with(kept(hub), m.location));
  return m.candidate;
}

/// How far the bounds let a placement come from the start, and how early it may go on to the goal,
/// as far as the middle sample of each arc tells.
void Hubs::examine(const Placement& placement, Member& member) const {
  poll();
  const int middle = graph_.options.samples_per_arc / 2;
  const auto may_be = [&](int arc) {
    const auto z = static_cast<double>(bounds_.bound(graph_.instant(arc, middle), placement));
    return z >= graph_.options.min_stability && displacements_.in_part(arc, placement) < kInfinity;
  };
  const int K = graph_.num_arcs();
  member.comes = 0;
  while (member.comes < K && may_be(member.comes)) ++member.comes;
  member.goes = member.comes == K ? 0 : K;
  while (member.goes > 0 && may_be(member.goes - 1)) --member.goes;
}

/// Of equal costs the first member's counts.
void Hubs::compare(int hub, int pose) {
  constexpr double kRounding = 1e-9;  // of costs summed in another order
  const double arcs_before = pose * (1 - kRounding);
  const double arcs_after = (graph_.num_arcs() - pose) * (1 - kRounding);
  double kept_before = 0, kept_after = 0;
  for (const std::int32_t location : kept(hub)) {
    if (location < 0) break;
    kept_before = std::max(kept_before, displacements_.before(location)[pose]);
    kept_after = std::max(kept_after, displacements_.after(location)[pose]);
  }
  Least least;
  int i = -1;
  for (Member& m : members_[static_cast<std::size_t>(hub)]) {
    ++i;
    if (m.is_examined() && pose > m.comes && pose < m.goes) continue;
    const double each = displacements_.least_arc(m.location);
    if (each * arcs_before > least.before && each * arcs_after > least.after) break;
    double before = std::max(kept_before, displacements_.before(m.location)[pose]);
    double after = std::max(kept_after, displacements_.after(m.location)[pose]);
    if (before >= least.before && after >= least.after) continue;
    if (!m.is_examined()) examine(with(kept(hub), m.location), m);
    if (m.candidate >= 0) {
      before = candidates_.before(m.candidate, pose);
      after = candidates_.after(m.candidate, pose);
    }
    if (pose <= m.comes && before < least.before) least.before = before, least.first = i;
    if (pose >= m.goes && after < least.after) least.after = after, least.second = i;
  }
  if (least.first >= 0) candidate(hub, least.first);
  if (least.second >= 0) candidate(hub, least.second);
  least_[index(hub, pose)] = least;
}

/// Costs never fall: while those of the least have not risen, no other member's is less.
bool Hubs::has_risen(int hub, int pose) const {
  const Least& least = least_[index(hub, pose)];
  if (least.before == kInfinity || least.after == kInfinity) return false;
  if (least.first < 0 || least.second < 0) return true;
  const auto candidate = [&](int i) { return members(hub)[static_cast<std::size_t>(i)].candidate; };
  return candidates_.before(candidate(least.first), pose) != least.before ||
         candidates_.after(candidate(least.second), pose) != least.after;
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
