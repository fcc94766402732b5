// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Bounds hold, bind where they were found, and reach other instants.
#include "fingertip/lazy/bounds.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "fingertip/cases.hpp"
#include "fingertip/instance.hpp"
#include "fingertip/lazy/state.hpp"

namespace graspless::fingertip {
namespace {

Options low_stability() {
  Options options;
  options.min_stability = 1e-3;
  return options;
}

struct Setting : Instance {
  explicit Setting(const Problem& problem_in)
      : Instance(problem_in, low_stability()), bounds(graph, instants) {}

  Placement random_placement() {
    const auto draw = [&] {
      return std::uniform_int_distribution<int>(0, locations.size() - 1)(rng);
    };
    int a = draw(), b = draw();
    while (a == b || !locations.are_apart(a, b)) b = draw();
    return {std::min(a, b), std::max(a, b), -1, -1};
  }

  double solve(int instant, const Placement& placement) {
    evaluator.solver().clear_supports();
    const double z = evaluator.stability(instant, placement);
    bounds.add(instant, evaluator.solver().supports(), placement);
    return z;
  }

  StabilityBounds bounds;
  std::mt19937 rng{1};
};

TEST(StabilityBounds, BoundWhatIsSolvedAtEveryInstant) {
  for (const Problem& problem : {slide_case(10, 4), tumble_case(false, 4)}) {
    Setting setting(problem);
    int rejected = 0, unstable = 0;
    for (int i = 0; i < 60; ++i) {
      const int instant =
          std::uniform_int_distribution<int>(0, setting.instants.size() - 1)(setting.rng);
      setting.solve(instant, setting.random_placement());
    }
    for (int i = 0; i < 300; ++i) {
      const int instant = i % setting.instants.size();
      const Placement placement = setting.random_placement();
      const auto bound = static_cast<double>(setting.bounds.bound(instant, placement));
      const double z = setting.evaluator.stability(instant, placement);
      if (z > 0) {
        EXPECT_LE(z, bound);
        continue;
      }
      ++unstable;
      if (bound < setting.options.min_stability) ++rejected;
    }
    EXPECT_GT(rejected, unstable / 2);  // most of what is not stable is refused without an LP
  }
}

TEST(StabilityBounds, BindWhereTheyWereFound) {
  Setting setting(tumble_case(false, 4));
  mechanics::StabilitySolver& solver = setting.evaluator.solver();
  int stable = 0;
  for (int i = 0; i < 200; ++i) {
    const Placement placement = setting.random_placement();
    const int instant = setting.graph.instant(i % 4, 0);
    solver.set(
        {&setting.instants[instant].environments.front()},
        {&setting.locations.wrenches(placement[0]), &setting.locations.wrenches(placement[1])});
    solver.clear_supports();
    const double z = solver.max_stability(0).z;
    setting.bounds.add(instant, solver.supports(), placement);
    const auto bound = static_cast<double>(setting.bounds.bound(instant, placement));
    if (z > 0) {
      EXPECT_NEAR(bound, z, 1e-4 * (1 + z));
      ++stable;
    } else {
      EXPECT_LT(bound, 1e-4);
    }
  }
  EXPECT_GT(stable, 5);
}

TEST(StabilityBounds, OneFunctionalServesTheWholeTumble) {
  Setting setting(tumble_case(false, 30));
  Placement placement;
  do {
    placement = setting.random_placement();
  } while (setting.solve(setting.graph.instant(15, 1), placement) > 0);
  int bounded = 0;
  for (int arc = 0; arc < 30; ++arc) {
    for (int j = 0; j < 3; ++j) {
      if (setting.bounds.bound(setting.graph.instant(arc, j), placement) < 1e6F) ++bounded;
    }
  }
  EXPECT_EQ(bounded, 90);
}

TEST(StabilityBounds, SpanWhatTheEnumerationFinds) {
  Setting setting(slide_case(10, 3));
  for (int i = 0; i < 40; ++i)
    setting.solve(setting.graph.instant(0, 0), setting.random_placement());
  std::vector<int> all;
  for (int i = 0; i < setting.locations.size(); i += 3) all.push_back(i);
  const int instant = setting.graph.instant(0, 0), rest = setting.graph.rest_instant(0);
  Crew crew(2);
  std::vector<Placement> found;
  const auto needed = static_cast<float>(setting.options.min_stability);
  for_each_placement(setting.graph, setting.bounds, 2, all, {instant, rest}, needed, crew,
                     [&](const Placement& placement) {
                       found.push_back(placement);
                       return true;
                     });
  std::vector<Placement> expected;
  for (const int a : all) {
    for (const int b : all) {
      const Placement placement = {a, b, -1, -1};
      if (b <= a || !setting.locations.are_apart(a, b)) continue;
      if (setting.bounds.bound(instant, placement) < needed) continue;
      if (setting.bounds.bound(rest, placement) < needed) continue;
      expected.push_back(placement);
    }
  }
  EXPECT_EQ(found, expected);
  EXPECT_GT(found.size(), 10U);
}

}  // namespace
}  // namespace graspless::fingertip
