// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the object rests on all fingers but one, and the best ways to get there and on.
#include "fingertip/lazy/hubs.hpp"

#include <algorithm>
#include <utility>

namespace graspless::fingertip {

Hubs::Hubs(const PathQuery& query, const Supports& supports, const Candidates& candidates)
    : query_(query), supports_(supports), candidates_(candidates) {
  std::unordered_map<int, int> slot_of;
  for (int pose = 0; pose < query.num_poses(); ++pose) {
    const int instant = query.rest_instant(pose);
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
  for (int location = 0; location < query_.locations.size(); ++location) {
    const auto is_apart = [&](std::int32_t finger) {
      return finger < 0 || (finger != location && query_.locations.are_apart(finger, location));
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

bool Hubs::may_rest(int hub, int pose) {
  Known& state = known(hub, slot(pose));
  if (state == Known::open &&
      static_cast<double>(supports_.bound(query_.rest_instant(pose), kept(hub))) <
          query_.options.min_stability) {
    state = Known::falls;
  }
  return state != Known::falls;
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
  const double cost = before + after + query_.options.regrasp_cost;
  if (cost < best.cost && may_rest(hub, pose)) best.cost = cost;
  return best;
}

bool Hubs::ask(int hub, int pose, std::vector<Question>& questions) {
  Known& state = known(hub, slot(pose));
  if (state == Known::open) {
    state = Known::asked;
    Question question;
    question.of = Question::Of::hub;
    question.index = hub;
    question.slot = slot(pose);
    question.instant = query_.rest_instant(pose);
    question.placement = kept(hub);
    questions.push_back(std::move(question));
  }
  return state == Known::asked;
}

void Hubs::learn(const Question& question) {
  known(question.index, question.slot) = question.z > 0 ? Known::rests : Known::falls;
}

}  // namespace graspless::fingertip
