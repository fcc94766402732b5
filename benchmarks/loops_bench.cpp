// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What the loops of a cloud cost: the five objects at 2000 and 10,000 points, 100,000 thinned and
// polished, and what goes into it. Clouds are sampled beforehand.
#include <map>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "graspless/clasp/sample_objects.hpp"
#include "graspless/geometry/loops.hpp"
#include "graspless/geometry/sampling.hpp"

namespace graspless::geometry {
namespace {

const std::string& object_name(const benchmark::State& state) {
  return clasp::sample_object_names().at(static_cast<std::size_t>(state.range(0)));
}

const Eigen::Matrix3Xd& cloud(const std::string& name, int count) {
  static std::map<std::pair<std::string, int>, Eigen::Matrix3Xd> clouds;
  Eigen::Matrix3Xd& points = clouds[{name, count}];
  if (points.cols() == 0) points = sample_surface(clasp::sample_object(name), count);
  return points;
}

void measure(benchmark::State& state, int count, const LoopOptions& options) {
  const Eigen::Matrix3Xd& points = cloud(object_name(state), count);
  Loops found;
  for (auto _ : state) found = shortest_loops(points, options);
  state.SetLabel(object_name(state));
  state.counters["loops"] = static_cast<double>(found.found.size());
  state.counters["meridians"] = static_cast<double>(found.meridians.size());
  state.counters["d"] = found.complex.max_edge_length;
  for (const Loop& loop : found.found) state.counters["length"] += loop.length;
}

void loops_of_2000(benchmark::State& state) { measure(state, 2000, {}); }
BENCHMARK(loops_of_2000)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);

void loops_of_10000(benchmark::State& state) {
  LoopOptions options;
  options.max_points = 10000;
  measure(state, 10000, options);
}
BENCHMARK(loops_of_10000)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);

void loops_of_100000_thinned(benchmark::State& state) { measure(state, 100000, {}); }
BENCHMARK(loops_of_100000_thinned)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);

void loops_of_100000_polished(benchmark::State& state) {
  LoopOptions options;
  options.polish = true;
  measure(state, 100000, options);
}
BENCHMARK(loops_of_100000_polished)->DenseRange(0, 4)->Unit(benchmark::kMillisecond);

/// Arguments: the object, the number of points.
void filtration(benchmark::State& state) {
  const Eigen::Matrix3Xd& points = cloud(object_name(state), static_cast<int>(state.range(1)));
  for (auto _ : state) benchmark::DoNotOptimize(Filtration(points));
  state.SetLabel(object_name(state));
}
BENCHMARK(filtration)->ArgsProduct({{0, 4}, {2000, 10000}})->Unit(benchmark::kMillisecond);

void persistence(benchmark::State& state) {
  const Eigen::Matrix3Xd& points = cloud(object_name(state), static_cast<int>(state.range(1)));
  for (auto _ : state) {
    state.PauseTiming();
    const Filtration filtration(points);
    state.ResumeTiming();
    benchmark::DoNotOptimize(filtration.persistence().size());
  }
  state.SetLabel(object_name(state));
}
BENCHMARK(persistence)->ArgsProduct({{0, 4}, {2000, 10000}})->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace graspless::geometry
