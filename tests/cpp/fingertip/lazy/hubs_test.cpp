// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The best regrasps at a hub against all pairs of its members.
#include "fingertip/lazy/hubs.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "fingertip/cases.hpp"
#include "fingertip/instance.hpp"
#include "fingertip/lazy/state.hpp"

namespace graspless::fingertip {
namespace {

/// All pairs of every fifth location of case d, at their hubs.
struct HubSetting : Instance {
  HubSetting() : Instance(tumble_case(true, 6), Options{}) {
    evaluators.emplace_back(instants, locations, options);
    lazy.emplace(graph, evaluators, clock, statistics, kInfinity);
    for (int a = 0; a < locations.size(); a += 5) {
      for (int b = a + 5; b < locations.size(); b += 5) {
        if (locations.are_apart(a, b)) lazy->hubs.link({a, b, -1, -1});
      }
    }
    lazy->hubs.rank(lazy->crew);
  }

  /// The least cost at a hub by the costs of all its placements.
  double least_cost(int hub, int pose) {
    double before = kInfinity, after = kInfinity;
    for (const Hubs::Member& member : lazy->hubs.members(hub)) {
      const int c = lazy->candidates.open(with(lazy->hubs.kept(hub), member.location));
      lazy->candidates.refresh(c);
      before = std::min(before, lazy->candidates.before(c, pose));
      after = std::min(after, lazy->candidates.after(c, pose));
    }
    const bool may_be = lazy->hubs.may_be_stable(hub, pose);
    return may_be ? before + after + options.regrasp_cost : kInfinity;
  }

  planning::Clock clock{planning::Budget{}};
  std::vector<Evaluator> evaluators;
  std::optional<LazyState> lazy;
};

TEST(Hubs, BestRegraspIsTheBestOfAllPairs) {
  HubSetting setting;
  LazyState& lazy = *setting.lazy;
  seed_bounds(lazy, clear_locations(setting.graph, 0, 1), lazy.candidates.instants(0));
  int possible = 0;
  for (int hub = 0; hub < lazy.hubs.size(); ++hub) {
    for (int pose = 1; pose < setting.graph.num_arcs(); ++pose) {
      const double bound = lazy.hubs.bound(hub, pose);
      Hubs::Regrasp best = lazy.hubs.best(hub, pose);
      while (best.cost < kInfinity &&
             (lazy.candidates.refresh(best.before) | lazy.candidates.refresh(best.after)) != 0) {
        best = lazy.hubs.best(hub, pose);
      }
      EXPECT_LE(bound, best.cost);
      EXPECT_EQ(best.cost, setting.least_cost(hub, pose));
      if (best.cost < kInfinity) ++possible;
    }
  }
  EXPECT_GT(possible, 20);
}

}  // namespace
}  // namespace graspless::fingertip
