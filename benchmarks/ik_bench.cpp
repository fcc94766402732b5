// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inverse kinematics in closed form of arms with different axes. Poses are reachable and drawn
// beforehand. Limits are +-pi, so that all branches count, unless a sweep says otherwise.
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "graspless/robot/ik.hpp"

#include "robot/arms.hpp"
#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

using Eigen::VectorXd;

struct Targets {
  explicit Targets(const Arm& arm, const Limits& limits = {})
      : robot(arm.robot(M_PI, limits)), frame(arm.dof() + 1), ik(robot, frame, arm.group()) {
    std::mt19937_64 rng(1);
    for (std::size_t i = 0; i < kSamples; ++i) {
      q.push_back(random_q(robot, rng));
      X_WF.push_back(robot.pose(frame, q.back()));
    }
  }

  static constexpr std::size_t kSamples = 1024;
  Robot robot;
  int frame;
  Ik ik;
  std::vector<VectorXd> q;
  std::vector<Eigen::Isometry3d> X_WF;
  Eigen::MatrixXd solutions;
};

/// All branches for one value of the free joint, or all there are.
void ik_branches(benchmark::State& state, const Arm& arm) {
  Targets targets(arm);
  const auto free = static_cast<Eigen::Index>(targets.ik.free_joint().value_or(0));
  double found = 0;
  std::size_t i = 0;
  for (auto _ : state) {
    const VectorXd& q = targets.q[i];
    found += targets.ik.solve_free(targets.X_WF[i], q[free], q, targets.solutions);
    benchmark::DoNotOptimize(targets.solutions.data());
    i = (i + 1) % Targets::kSamples;
  }
  state.counters["solutions"] = benchmark::Counter(found, benchmark::Counter::kAvgIterations);
}

/// All branches at 16 values of the free joint.
void ik_sweep(benchmark::State& state, const Arm& arm, const Limits& limits) {
  Targets targets(arm, limits);
  constexpr int kValues = 16;
  const int joint = targets.ik.free_joint().value();
  const double lower = targets.robot.lower()[joint], upper = targets.robot.upper()[joint];
  double found = 0;
  std::size_t i = 0;
  for (auto _ : state) {
    for (int k = 0; k < kValues; ++k) {
      const double value = lower + (upper - lower) * (k + 0.5) / kValues;
      found += targets.ik.solve_free(targets.X_WF[i], value, targets.q[i], targets.solutions);
    }
    benchmark::DoNotOptimize(targets.solutions.data());
    i = (i + 1) % Targets::kSamples;
  }
  state.counters["solutions"] = benchmark::Counter(found, benchmark::Counter::kAvgIterations);
}

Arm calibrated(const Arm& arm) {
  std::mt19937_64 rng(1);
  return arm.calibrated(1e-4, 1e-3, rng);
}

BENCHMARK_CAPTURE(ik_branches, kr5, kr5_bare());
BENCHMARK_CAPTURE(ik_branches, irb140, irb140());
BENCHMARK_CAPTURE(ik_branches, ur5e, ur5e());
BENCHMARK_CAPTURE(ik_branches, ur5e_calibrated, calibrated(ur5e()));
BENCHMARK_CAPTURE(ik_branches, iiwa, iiwa());
BENCHMARK_CAPTURE(ik_branches, gen3, gen3());
BENCHMARK_CAPTURE(ik_branches, panda, panda());
BENCHMARK_CAPTURE(ik_branches, xarm7, xarm7());
BENCHMARK_CAPTURE(ik_sweep, iiwa, iiwa(), iiwa_limits());
BENCHMARK_CAPTURE(ik_sweep, gen3, gen3(), gen3_limits());
BENCHMARK_CAPTURE(ik_sweep, panda, panda(), panda_limits());
BENCHMARK_CAPTURE(ik_sweep, iiwa_wide, iiwa(), Limits{});
BENCHMARK_CAPTURE(ik_sweep, panda_wide, panda(), Limits{});
BENCHMARK_CAPTURE(ik_sweep, xarm7_wide, xarm7(), Limits{});

}  // namespace
}  // namespace graspless::robot
