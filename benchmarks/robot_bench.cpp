// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What a planner spends on kinematics, per configuration. Inputs are drawn beforehand.
#include <random>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "graspless/robot/ik.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::robot {
namespace {

using Eigen::VectorXd;

constexpr std::size_t kSamples = 1024;  // a power of two

const Robot& wam() {
  static const Robot robot = Robot::from_urdf_file(GRASPLESS_URDF_DIR "/wam_t42.urdf");
  return robot;
}

const std::vector<VectorXd>& configurations() {
  static const std::vector<VectorXd> all = [] {
    std::mt19937_64 rng(1);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<VectorXd> drawn;
    for (std::size_t i = 0; i < kSamples; ++i) {
      const VectorXd u = VectorXd::NullaryExpr(wam().dof(), [&] { return unit(rng); });
      drawn.push_back(wam().lower() + u.cwiseProduct(wam().upper() - wam().lower()));
    }
    return drawn;
  }();
  return all;
}

void forward(benchmark::State& state) {
  Poses X_WL;
  std::size_t i = 0;
  for (auto _ : state) {
    wam().forward(configurations()[i++ % kSamples], X_WL);
    benchmark::DoNotOptimize(X_WL.data());
  }
}
BENCHMARK(forward);

void forward_to_fingertip(benchmark::State& state) {
  Poses X_WL;
  const int tip = wam().frame("left_fingertip");
  std::size_t i = 0;
  for (auto _ : state) {
    wam().forward_to(tip, configurations()[i++ % kSamples], X_WL);
    benchmark::DoNotOptimize(X_WL.data());
  }
}
BENCHMARK(forward_to_fingertip);

/// All frames and the Jacobian of a fingertip: what a constraint costs, without its own rows.
void forward_and_jacobian(benchmark::State& state) {
  Poses X_WL;
  Eigen::Matrix<double, 6, Eigen::Dynamic> J;
  const int tip = wam().frame("left_fingertip");
  std::size_t i = 0;
  for (auto _ : state) {
    wam().forward(configurations()[i++ % kSamples], X_WL);
    wam().jacobian(tip, X_WL, J);
    benchmark::DoNotOptimize(J.data());
  }
}
BENCHMARK(forward_and_jacobian);

Ik fingertip_ik() { return Ik(wam(), wam().frame("left_fingertip"), wam().group("arm")); }

void solve_free(benchmark::State& state) {
  const Ik ik = fingertip_ik();
  std::vector<Eigen::Isometry3d> targets;
  for (const VectorXd& q : configurations()) {
    targets.push_back(wam().pose(wam().frame("left_fingertip"), q));
  }
  Eigen::MatrixXd solutions;
  double found = 0;
  std::size_t i = 0;
  for (auto _ : state) {
    const VectorXd& q = configurations()[i % kSamples];
    found += ik.solve_free(targets[i++ % kSamples], q[2], q, solutions);
    benchmark::DoNotOptimize(solutions.data());
  }
  state.counters["solutions"] = benchmark::Counter(found, benchmark::Counter::kAvgIterations);
}
BENCHMARK(solve_free);

void solve_near(benchmark::State& state) {
  const Ik ik = fingertip_ik();
  std::vector<Eigen::Isometry3d> targets;
  for (const VectorXd& q : configurations()) {
    const VectorXd moved = wam().clamp(q + VectorXd::Constant(wam().dof(), 0.01));
    VectorXd target = q;
    target.head(7) = moved.head(7);
    targets.push_back(wam().pose(wam().frame("left_fingertip"), target));
  }
  double found = 0;
  std::size_t i = 0;
  for (auto _ : state) {
    const auto q = ik.solve_near(targets[i % kSamples], configurations()[i % kSamples]);
    ++i;
    found += q.has_value();
  }
  state.counters["found"] = benchmark::Counter(found, benchmark::Counter::kAvgIterations);
}
BENCHMARK(solve_near);

}  // namespace
}  // namespace graspless::robot
