// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The fingertip planner on the paper's four cases, on finer lattices, and with more fingers.
#include <string>

#include <benchmark/benchmark.h>

#include "graspless/fingertip/fingertip.hpp"

#include "../tests/cpp/fingertip/cases.hpp"

namespace graspless::fingertip {
namespace {

Problem make_problem(char name, int segments) {
  switch (name) {
    case 'a':
      return slide_case(10, segments);
    case 'b':
      return slide_case(5, segments);
    default:
      return tumble_case(name == 'd', segments);
  }
}

/// Plans, and reports what the search did. Arguments: case, locations per side, segments, fingers,
/// threads.
void plan_case(benchmark::State& state) {
  Problem problem =
      make_problem(static_cast<char>(state.range(0)), static_cast<int>(state.range(2)));
  problem.fingers.count = static_cast<int>(state.range(3));
  Options options;
  options.locations_per_side = static_cast<int>(state.range(1));
  options.threads = static_cast<int>(state.range(4));
  Plan plan;
  for (auto _ : state) {
    plan = fingertip::plan(problem, options);
    benchmark::DoNotOptimize(plan);
  }
  if (!plan) return state.SkipWithError(plan.reason.c_str());
  state.SetLabel(std::string(1, static_cast<char>(state.range(0))));
  state.counters["cost"] = plan.cost;
  state.counters["regrasps"] = plan.regrasps;
  state.counters["z"] = static_cast<double>(plan.statistics.z_evaluations);
  state.counters["jams"] = static_cast<double>(plan.statistics.bounded_tests);
  state.counters["pivots"] = static_cast<double>(plan.statistics.pivots);
  state.counters["placements"] = static_cast<double>(plan.statistics.placements);
  state.counters["MB"] = static_cast<double>(plan.statistics.memory) / 1e6;
}

void arguments(benchmark::internal::Benchmark* bench) {
  bench->ArgNames({"case", "side", "segments", "fingers", "threads"})
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

BENCHMARK(plan_case)
    ->Name("FingertipCase")
    ->Apply(arguments)
    ->Args({'a', 7, 30, 2, 1})
    ->Args({'b', 7, 30, 2, 1})
    ->Args({'c', 7, 30, 2, 1})
    ->Args({'d', 7, 30, 2, 1})
    ->Args({'c', 7, 30, 2, 2})
    ->Args({'d', 7, 30, 2, 2});

BENCHMARK(plan_case)
    ->Name("FingertipScaling")
    ->Apply(arguments)
    ->Args({'a', 21, 30, 2, 1})
    ->Args({'b', 21, 30, 2, 1})
    ->Args({'c', 7, 90, 2, 1})
    ->Args({'d', 7, 90, 2, 1})
    ->Args({'c', 7, 30, 3, 1});

}  // namespace
}  // namespace graspless::fingertip
