// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Placements come once, the most stable first, and none that may be the best is left out.
#include "fingertip/lazy/listing.hpp"

#include <algorithm>
#include <map>
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

TEST(Listing, ListsAgainWhatItTookForUnstableOnceThatIsForgotten) {
  for (const Problem& problem : {slide_case(10, 4), slide_case(5, 4)}) {
    ListingSetting setting(problem);
    LazyState& lazy = *setting.lazy;
    Listing& listing = *setting.listing;
    ASSERT_EQ(lazy.candidates.instants().size(), 1U);
    const int instant = lazy.candidates.instants().front();
    struct Solved {
      double cost;
      std::vector<mechanics::Vector6d> functionals;
    };
    std::map<Placement, Solved> all;
    for_each_placement(
        setting.graph, lazy.bounds, lazy.count,
        clear_locations(setting.graph, 0, setting.graph.num_arcs()), {instant}, lazy.min_stability,
        lazy.crew, [&](const Placement& placement) {
          Evaluator& evaluator = setting.evaluators.front();
          evaluator.solver().clear_supports();
          const double z = evaluator.stability(instant, placement);
          if (z < lazy.min_stability) return true;
          double displacement = 0;
          for (const std::int32_t location : placement) {
            if (location < 0) break;
            displacement = std::max(displacement, *lazy.displacements.after(location));
          }
          all[placement] = {displacement * (1 + setting.options.stability_weight / z),
                            evaluator.solver().supports()};
          return true;
        });
    const double best = lazy.candidates.best();
    std::set<Placement> listed;
    for (int call = 0; listing.least_cost() < best; ++call) {
      ASSERT_LT(call, 40);
      if (listing.begins_anew()) listed.clear();
      listing.next([&](const Placement& placement, double) {
        EXPECT_TRUE(listed.insert(placement).second);
      });
      for (const auto& [placement, solved] : all) {
        const double known = listed.count(placement) > 0 ? listing.cost(placement) : kInfinity;
        EXPECT_GE(solved.cost, std::min(known, listing.least_cost()) * (1 - 1e-9));
      }
      // One round knows much, and the next one has forgotten it.
      for (int i = 0; i < 150; ++i) {
        auto other = all.begin();
        std::advance(other, i * 7919 % static_cast<int>(all.size()));
        const auto& [placement, solved] = call % 2 == 0 ? *other : *all.begin();
        lazy.bounds.add(instant, solved.functionals, placement);
      }
    }
    EXPECT_TRUE(listing.begins_anew());
    int cheaper = 0;
    for (const auto& [placement, solved] : all) {
      if (solved.cost >= best) continue;
      EXPECT_TRUE(listed.count(placement) > 0);
      ++cheaper;
    }
    EXPECT_GT(cheaper, 20);
  }
}

}  // namespace
}  // namespace graspless::fingertip
