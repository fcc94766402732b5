// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The KR 5 with the SDH at the purse's handle: where it is free, closing, and the stability test.
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "graspless/clasp/sample_objects.hpp"
#include "graspless/geometry/sampling.hpp"

#include "clasp/close.hpp"
#include "clasp/stability/tester.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

/// The top of the handle `ahead` of the palm, along sideways.
Problem at_the_handle(double ahead) {
  static const Object purse =
      Object::from_cloud("purse", geometry::sample_surface(sample_object("purse"), 2000));
  const std::string stem = std::string(GRASPLESS_URDF_DIR) + "/kr5_sdh";
  const robot::Robot robot = robot::Robot::from_urdf_file(stem + ".urdf");
  const Hand hand = hand_from_yaml_file(stem + ".clasp.yaml");
  Eigen::Isometry3d X_HO = Eigen::Isometry3d::Identity();
  X_HO.linear() << hand.sideways_H, hand.sideways_H.cross(hand.forward_H), -hand.forward_H;
  X_HO.translation() = ahead * hand.forward_H - X_HO.linear() * Vector3d(0, 0, 0.298);
  VectorXd q = robot.state("home");
  for (const int joint : robot.group(hand.hand)) q[joint] = robot.state(hand.open)[joint];
  return {robot, hand, purse, robot.pose(robot.frame(hand.frame), q) * X_HO, {}, q, {}, {}, {}};
}

VectorXd moved(const Problem& problem, double reach, std::mt19937_64& rng) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const VectorXd& q = problem.q_start;
  return problem.robot.clamp(q +
                             VectorXd::NullaryExpr(q.size(), [&] { return reach * unit(rng); }));
}

void BM_ClearanceBounds(benchmark::State& state) {
  const Problem problem = at_the_handle(0.12);
  collision::Clearance clearance = problem.object.clearance();
  std::mt19937_64 rng(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Vector3d> points;
  Vector3d p(0, 0.03, 0.3);
  while (points.size() < 4096) {
    points.push_back(p += 0.004 * Vector3d(unit(rng), unit(rng), unit(rng)));
    if (points.size() % 64 == 0) p = Vector3d(0.05 * unit(rng), 0.05 * unit(rng), 0.3);
  }
  for (const Vector3d& point : points) clearance.bounds(point, 0.015);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(clearance.bounds(points[i++ % points.size()], 0.015));
  }
}
BENCHMARK(BM_ClearanceBounds);

/// Configurations `ahead` / 100 m from the handle.
void BM_FreeConfiguration(benchmark::State& state) {
  const Problem problem = at_the_handle(static_cast<double>(state.range(0)) / 100);
  FreeSpace space(problem);
  std::mt19937_64 rng(1);
  std::vector<VectorXd> looked;
  while (looked.size() < 256) {
    looked.push_back(moved(problem, 0.1, rng));
    if (!space.is_free(looked.back())) looked.pop_back();
  }
  const auto fcl = space.num_fcl_checks();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(space.is_free(looked[i++ % looked.size()]));
  state.counters["fcl"] = benchmark::Counter(static_cast<double>(space.num_fcl_checks() - fcl),
                                             benchmark::Counter::kAvgIterations);
}
BENCHMARK(BM_FreeConfiguration)->Arg(12)->Arg(20)->Arg(40)->Unit(benchmark::kMicrosecond);

void BM_ControlStep(benchmark::State& state) {
  const Problem problem = at_the_handle(static_cast<double>(state.range(0)) / 100);
  FreeSpace space(problem);
  std::mt19937_64 rng(1);
  std::vector<std::pair<VectorXd, VectorXd>> motions;
  std::uniform_real_distribution<double> unit(-1, 1);
  while (motions.size() < 128) {
    const VectorXd from = moved(problem, 0.08, rng);
    VectorXd step = VectorXd::NullaryExpr(from.size(), [&] { return unit(rng); });
    step *= 0.12 / step.cwiseAbs().maxCoeff();
    if (space.is_free(from, from + step, 0.01)) motions.emplace_back(from, from + step);
  }
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [from, to] = motions[i++ % motions.size()];
    benchmark::DoNotOptimize(space.is_free(from, to, 0.01));
  }
}
BENCHMARK(BM_ControlStep)->Arg(12)->Arg(20)->Arg(40)->Unit(benchmark::kMicrosecond);

void BM_MakeFreeSpace(benchmark::State& state) {
  const Problem problem = at_the_handle(0.12);
  for (auto _ : state) benchmark::DoNotOptimize(FreeSpace(problem).is_free(problem.q_start));
}
BENCHMARK(BM_MakeFreeSpace)->Unit(benchmark::kMicrosecond);

void BM_CloseHand(benchmark::State& state) {
  const Problem problem = at_the_handle(0.12);
  FreeSpace space(problem);
  for (auto _ : state) {
    benchmark::DoNotOptimize(close_hand(space, problem.robot, problem.hand, problem.q_start));
  }
}
BENCHMARK(BM_CloseHand)->Unit(benchmark::kMillisecond);

void BM_Stability(benchmark::State& state) {
  const Problem problem = at_the_handle(0.12);
  FreeSpace space(problem);
  const VectorXd closed = close_hand(space, problem.robot, problem.hand, problem.q_start).back();
  StabilityOptions options;
  for (auto _ : state) {
    state.PauseTiming();
    ++options.seed;
    state.ResumeTiming();
    const Stability found =
        StabilityTester(problem).test(closed, problem.object.loops().found.front().points, options);
    state.counters["secure"] = found.secure ? 1 : 0;
    state.counters["checks"] = static_cast<double>(found.checks);
  }
}
BENCHMARK(BM_Stability)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace graspless::clasp
