// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What one evaluation of Problems (5) and (6) costs: a box with two fingers at random places of a
// 7 x 7 grid, over contacts as in sliding, tumbling, resting and leaning. Inputs are made
// beforehand; every one has z > 0.
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kSamples = 64;  // a power of two

struct Instant {
  EnvironmentWrenches environment;
  std::vector<FingerWrenches> fingers;
};

enum Footing { sliding, tumbling, resting, leaning };

void touch(ContactSet& set, const Vector3d& p, const Vector3d& n, ContactMode mode) {
  set.contacts.push_back({p, n, 0.5, mode, Vector3d::UnitX()});
}

ContactSet box(Footing footing) {
  ContactSet set;
  const Vector3d half(2.5, footing == sliding ? 5 : 2.5, footing == sliding ? 2.5 : 5);
  const Vector3d up =
      footing == tumbling ? Vector3d(std::sin(0.7), 0, std::cos(0.7)) : Vector3d::UnitZ();
  for (int i = 0; i < 4; ++i) {
    const double a = (i & 1) != 0 ? 1 : -1, b = (i & 2) != 0 ? 1 : -1;
    if (footing != tumbling || i % 2 == 1) {
      touch(set, Vector3d(a, b, -1).cwiseProduct(half), up,
            footing == sliding ? ContactMode::slide : ContactMode::stick);
    }
    if (footing != leaning) continue;
    touch(set, Vector3d(1, a, b).cwiseProduct(half), -Vector3d::UnitX(), ContactMode::stick);
    touch(set, Vector3d(a, 1, b).cwiseProduct(half), -Vector3d::UnitY(), ContactMode::stick);
  }
  set.known_wrench_O = gravity_wrench(1, -9.8 * up);
  const Vector3d square = (2 * half).cwiseAbs2();
  set.wrench_scale = wrench_scale(
      1, Vector3d((Vector3d::Constant(square.sum()) - square) / 12).asDiagonal().toDenseMatrix());
  return set;
}

void add_finger(ContactSet& set, std::mt19937& rng) {
  const auto draw = [&](int n) { return static_cast<int>(rng() % static_cast<unsigned>(n)); };
  const Vector3d half = set.contacts.back().p_OC.cwiseAbs();
  const int axis = draw(3), side = axis == 2 || draw(2) == 1 ? 1 : -1;
  Finger finger;
  for (int k = 0; k < 3; ++k) finger.p_OC[k] = half[k] * ((2 * draw(7) + 1) / 7.0 - 1);
  finger.p_OC[axis] = side * half[axis];
  finger.n_O = -side * Vector3d::Unit(axis);
  finger.friction = 0.7;
  set.fingers.push_back(finger);
}

void give(const Instant& instant, StabilitySolver& solver) {
  solver.set({&instant.environment}, {&instant.fingers[0], &instant.fingers[1]});
}

/// Instants with z > 0 under these control modes, or a jam if that is asked for.
std::vector<Instant> instants(Footing footing, ForceMask force) {
  std::mt19937 rng(1);
  std::vector<Instant> all;
  StabilitySolver solver;
  while (all.size() < kSamples) {
    ContactSet set = box(footing);
    for (int i = 0; i < 2; ++i) add_finger(set, rng);
    Instant instant{environment_wrenches(set), {finger_wrenches(set, 0), finger_wrenches(set, 1)}};
    give(instant, solver);
    if (solver.max_stability(force).z > 1e-6) all.push_back(std::move(instant));
  }
  return all;
}

/// Arguments: the footing, then the fingers in force control as bits.
void max_stability(benchmark::State& state) {
  const auto force = static_cast<ForceMask>(state.range(1));
  const auto all = instants(static_cast<Footing>(state.range(0)), force);
  StabilitySolver solver;
  std::size_t i = 0;
  for (auto _ : state) {
    give(all[i++ % kSamples], solver);
    benchmark::DoNotOptimize(solver.evaluate(force).z);
    solver.clear_supports();
  }
  state.counters["pivots"] = benchmark::Counter(static_cast<double>(solver.counters().pivots),
                                                benchmark::Counter::kAvgIterations);
}
BENCHMARK(max_stability)
    ->ArgNames({"footing", "force"})
    ->ArgsProduct({{sliding, tumbling, resting, leaning}, {0, 1, 3}})
    ->Unit(benchmark::kMicrosecond);

void internal_force_is_bounded(benchmark::State& state) {
  const auto all = instants(static_cast<Footing>(state.range(0)), 0);
  StabilitySolver solver;
  std::size_t i = 0;
  double bounded = 0;
  for (auto _ : state) {
    give(all[i++ % kSamples], solver);
    bounded += solver.internal_force_is_bounded(0);
  }
  state.counters["bounded"] = benchmark::Counter(bounded, benchmark::Counter::kAvgIterations);
}
BENCHMARK(internal_force_is_bounded)->ArgName("footing")->DenseRange(sliding, leaning);

}  // namespace
}  // namespace graspless::mechanics
