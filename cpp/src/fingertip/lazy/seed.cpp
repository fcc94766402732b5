// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// First functionals: from a few placements, chosen among those that are not refused yet.
#include <algorithm>
#include <cmath>

#include "fingertip/lazy/search.hpp"

namespace graspless::fingertip {

namespace {

constexpr int kRounds = 12;          // at an instant
constexpr std::size_t kEach = 2;     // placements solved a round
constexpr double kMany = 60000;      // placements that represent all
constexpr double kStagnation = 0.9;  // what is left of them, when it no longer pays

/// Every so many-th location, such that there are at most kMany placements.
std::vector<int> thinned(const std::vector<int>& locations, int count) {
  double placements = 1;
  for (int i = 0; i < count; ++i) {
    placements *= (static_cast<double>(locations.size()) - i) / (i + 1);
  }
  const double stride = std::max(1.0, std::pow(placements / kMany, 1.0 / count));
  std::vector<int> some;
  for (double i = 0; i < static_cast<double>(locations.size()); i += stride) {
    some.push_back(locations[static_cast<std::size_t>(i)]);
  }
  return some;
}

}  // namespace

void seed_supports(FastSearch& search, const std::vector<int>& locations,
                   const std::vector<int>& instants) {
  const std::vector<int> some = thinned(locations, search.count);
  for (const int instant : instants) {
    std::vector<Placement> left;
    for_each_placement(search.query, search.supports, search.count, some, {instant},
                       [&](const Placement& placement) {
                         left.push_back(placement);
                         return true;
                       });
    const auto& slots = search.candidates.instants();
    const auto slot = std::find(slots.begin(), slots.end(), instant);
    double drawn = 0.5;
    int idle = 0;
    for (int round = 0; round < kRounds && !left.empty() && idle < 2; ++round) {
      if (search.clock.is_out()) return;
      std::vector<Question> questions;
      for (std::size_t i = 0; i < std::min(kEach, left.size()); ++i) {
        drawn = std::fmod(drawn + 0.6180339887498949, 1.0);
        const Placement& placement =
            left[static_cast<std::size_t>(drawn * static_cast<double>(left.size()))];
        const int c = search.candidates.open(placement);
        search.candidates.ask_slot(c, static_cast<int>(slot - slots.begin()), questions);
      }
      if (questions.empty()) break;
      search.solve(questions);
      const std::size_t before = left.size();
      const auto refused = [&](const Placement& placement) {
        return static_cast<double>(search.supports.bound(instant, placement)) <
               search.query.options.min_stability;
      };
      left.erase(std::remove_if(left.begin(), left.end(), refused), left.end());
      idle = static_cast<double>(left.size()) > kStagnation * static_cast<double>(before) ? idle + 1
                                                                                          : 0;
    }
  }
}

}  // namespace graspless::fingertip
