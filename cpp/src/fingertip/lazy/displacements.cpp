// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/lazy/displacements.hpp"

#include <algorithm>
#include <numeric>

#include "graspless/watch.hpp"

namespace graspless::fingertip {

Displacements::Displacements(const PoseGraph& graph) : arcs_(graph.num_arcs()) {
  const auto locations = static_cast<std::size_t>(graph.locations.size());
  parts_.reserve(locations * arcs_);
  before_.assign(locations * (arcs_ + 1), 0.0);
  after_ = before_;
  for (int location = 0; location < graph.locations.size(); ++location) add(graph, location);
  for (std::size_t arc = 0; arc < arcs_; ++arc) {
    double least = kInfinity;
    for (std::size_t l = 0; l < locations; ++l) least = std::min(least, parts_[l * arcs_ + arc]);
    least_ += least * graph.options.samples_per_arc;
  }
  rank_all();
}

void Displacements::rank_all() {
  const std::size_t locations = least_arcs_.size(), poses = arcs_ + 1;
  ranking_.resize(locations);
  std::iota(ranking_.begin(), ranking_.end(), 0);
  std::stable_sort(ranking_.begin(), ranking_.end(),
                   [&](int a, int b) { return least_arc(a) < least_arc(b); });
  ranks_.resize(locations);
  before_at_.resize(locations * poses);
  after_at_.resize(locations * poses);
  for (std::size_t i = 0; i < locations; ++i) {
    ranks_[ranking_[i]] = static_cast<std::int32_t>(i);
    for (std::size_t pose = 0; pose < poses; ++pose) {
      before_at_[pose * locations + i] = before_[i * poses + pose];
      after_at_[pose * locations + i] = after_[i * poses + pose];
    }
  }
}

void Displacements::add(const PoseGraph& graph, int location) {
  poll();
  const std::size_t first = parts_.size();
  const int P = graph.options.samples_per_arc;
  double* before = &before_[index(location)];
  double* after = &after_[index(location)];
  double least = kInfinity;
  for (std::size_t i = 0; i < arcs_; ++i) {
    const int arc = static_cast<int>(i);
    const bool is_clear = graph.is_clear(arc, location) && graph.is_clear(arc + 1, location) &&
                          graph.is_arc_clear(arc, 0, location);
    parts_.push_back(is_clear ? graph.displacement(arc, location) : kInfinity);
    before[i + 1] = before[i] + parts_.back() * P;
    least = std::min(least, parts_.back() * P);
  }
  for (std::size_t i = arcs_; i-- > 0;) after[i] = after[i + 1] + parts_[first + i] * P;
  least_arcs_.push_back(least);
  least_whole_ = std::min(least_whole_, after[0]);
}

double Displacements::in_part(int arc, const Placement& placement) const {
  double most = 0;
  for (const std::int32_t location : placement) {
    if (location < 0) break;
    most = std::max(
        most, parts_[static_cast<std::size_t>(location) * arcs_ + static_cast<std::size_t>(arc)]);
  }
  return most;
}

}  // namespace graspless::fingertip
