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
  index_of_one_.assign(graph.locations.size(), -1);
}

int Hubs::open(const Placement& kept) {
  const bool is_one = kept[0] >= 0 && kept[1] < 0;
  int& known = is_one ? index_of_one_[kept[0]] : index_.try_emplace(kept, -1).first->second;
  if (known < 0) {
    known = size();
    kept_.push_back(kept);
    members_.emplace_back();
    neighbors_.emplace_back();
    known_.resize(known_.size() + instants_.size(), Known::open);
  }
  return known;
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

void Hubs::rank(Crew& crew) {
  const auto size = kept_.size() * static_cast<std::size_t>(graph_.num_poses());
  memory_ += static_cast<std::int64_t>((size - least_.size()) * sizeof(Least));
  least_.resize(size);
  constexpr std::size_t kHubs = 16;  // an item
  crew.share((kept_.size() + kHubs - 1) / kHubs, [&](std::size_t item) {
    const std::size_t last = std::min(kept_.size(), (item + 1) * kHubs);
    for (std::size_t hub = item * kHubs; hub < last; ++hub) rank(static_cast<int>(hub));
  });
}

/// Members by ascending least arc: what they cost from pose to pose is no less.
void Hubs::rank(int hub) {
  poll();
  std::vector<Member>& members = members_[hub];
  std::vector<std::int32_t> ranks;
  for (const Member& m : members) ranks.push_back(displacements_.rank(m.location));
  std::sort(ranks.begin(), ranks.end());
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  members.clear();
  for (const std::int32_t rank : ranks) {
    members.push_back({displacements_.ranking()[rank]});
  }
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
  if (!neighbors_[hub].empty()) {
    return neighbors_[hub];
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
  neighbors_[hub] = std::move(found);
  return neighbors_[hub];
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
  Member& m = members_[hub][member];
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
Hubs::Least Hubs::least_of(int hub, int pose) {
  constexpr double kRounding = 1e-9;         // of costs summed in another order
  constexpr std::size_t kBetweenLooks = 16;  // members, for a look at whether more can cost less
  const double arcs_before = pose * (1 - kRounding);
  const double arcs_after = (graph_.num_arcs() - pose) * (1 - kRounding);
  const double* all_before = displacements_.before_at(pose);
  const double* all_after = displacements_.after_at(pose);
  double kept_before = 0, kept_after = 0;
  for (const std::int32_t location : kept(hub)) {
    if (location < 0) break;
    kept_before = std::max(kept_before, all_before[location]);
    kept_after = std::max(kept_after, all_after[location]);
  }
  Least least;
  std::vector<Member>& members = members_[hub];
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (i % kBetweenLooks == 0) {
      const double each = displacements_.least_arc(members[i].location);
      if (each * arcs_before > least.before && each * arcs_after > least.after) break;
    }
    Member& m = members[i];
    double before = std::max(kept_before, all_before[m.location]);
    double after = std::max(kept_after, all_after[m.location]);
    if (before >= least.before && after >= least.after) continue;
    if (!m.is_examined()) examine(with(kept(hub), m.location), m);
    if (pose > m.comes && pose < m.goes) continue;
    if (m.candidate >= 0) {
      before = candidates_.before(m.candidate, pose);
      after = candidates_.after(m.candidate, pose);
    }
    const int member = static_cast<int>(i);
    if (pose <= m.comes && before < least.before) least.before = before, least.first = member;
    if (pose >= m.goes && after < least.after) least.after = after, least.second = member;
  }
  return least;
}

void Hubs::compare(int hub, int pose) {
  const Least least = least_of(hub, pose);
  if (least.first >= 0) candidate(hub, least.first);
  if (least.second >= 0) candidate(hub, least.second);
  least_[index(hub, pose)] = least;
}

void Hubs::compare(const std::vector<HubPose>& together, Crew& crew) {
  std::vector<HubPose> all = together;  // those of one hub side by side: one thread takes them
  std::stable_sort(all.begin(), all.end(),
                   [](const HubPose& a, const HubPose& b) { return a.hub < b.hub; });
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == 0 || all[i].hub != all[i - 1].hub) first.push_back(i);
  }
  crew.share(first.size(), [&](std::size_t item) {
    const std::size_t last = item + 1 < first.size() ? first[item + 1] : all.size();
    for (std::size_t i = first[item]; i < last; ++i) {
      least_[index(all[i].hub, all[i].pose)] = least_of(all[i].hub, all[i].pose);
    }
  });
  std::vector<int> opened;
  for (const HubPose& at : together) {
    const Least& least = least_[index(at.hub, at.pose)];
    if (least.first >= 0) opened.push_back(candidate(at.hub, least.first));
    if (least.second >= 0) opened.push_back(candidate(at.hub, least.second));
  }
  std::sort(opened.begin(), opened.end());
  opened.erase(std::unique(opened.begin(), opened.end()), opened.end());
  crew.share(opened.size(), [&](std::size_t item) { candidates_.refresh(opened[item]); });
}

/// Costs never fall: while those of the least have not risen, no other member's is less.
bool Hubs::has_risen(int hub, int pose) const {
  const Least& least = least_[index(hub, pose)];
  if (least.before == kInfinity || least.after == kInfinity) return false;
  if (least.first < 0 || least.second < 0) return true;
  const auto candidate = [&](int i) { return members(hub)[i].candidate; };
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
