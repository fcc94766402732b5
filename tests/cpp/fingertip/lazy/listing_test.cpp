// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Placements come once, the most stable first, and none that may be the best is left out.
#include "fingertip/lazy/listing.hpp"

#include <optional>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "fingertip/cases.hpp"
#include "fingertip/instance.hpp"

namespace graspless::fingertip {
namespace {

struct ListingSetting : Instance {
  explicit ListingSetting(const Problem& problem_in) : Instance(problem_in, Options{}) {
    evaluators.emplace_back(instants, locations, options);
    lazy.emplace(graph, evaluators, clock, statistics, kInfinity);
    listing.emplace(*lazy);
  }

  planning::Clock clock{planning::Budget{}};
  std::vector<Evaluator> evaluators;
  std::optional<LazyState> lazy;
  std::optional<Listing> listing;
};

TEST(Listing, ListsOnceAllThatMayCostLessThanTheBest) {
  for (const Problem& problem : {slide_case(10, 4), slide_case(5, 4), tumble_case(false, 4)}) {
    ListingSetting setting(problem);
    LazyState& lazy = *setting.lazy;
    Listing& listing = *setting.listing;
    const double best = lazy.candidates.best();
    std::set<Placement> listed;
    EXPECT_LT(listing.least_cost(), best);
    while (listing.least_cost() < best) {
      const double least = listing.least_cost();
      listing.next([&](const Placement& placement, double cost) {
        EXPECT_TRUE(listed.insert(placement).second);
        EXPECT_GE(cost, least);
      });
      EXPECT_GT(listing.least_cost(), least);
    }
    const std::vector<int>& all = lazy.candidates.instants();
    const std::vector<int> some{all.front(), all.back(), all[all.size() / 2]};
    int allowed = 0;
    for_each_placement(setting.graph, lazy.bounds, lazy.count,
                       clear_locations(setting.graph, 0, setting.graph.num_arcs()), some,
                       lazy.min_stability, lazy.crew, [&](const Placement& placement) {
                         if (listing.cost(placement) > best) return true;
                         EXPECT_TRUE(listed.count(placement) > 0);
                         ++allowed;
                         return true;
                       });
    EXPECT_GT(allowed, 0);
  }
}

}  // namespace
}  // namespace graspless::fingertip
