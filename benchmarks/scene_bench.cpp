// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The WAM with its hand at the slide planner's square table.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "graspless/scene/scene.hpp"

namespace graspless::scene {
namespace {

using Eigen::VectorXd;

robot::Robot wam() {
  return robot::Robot::from_urdf_file(std::string(GRASPLESS_URDF_DIR) + "/wam_t42.urdf");
}

Scene make_scene(const robot::Robot& robot) {
  Scene scene(robot);
  scene.add_obstacle("table", {{geometry::Box{{0.7, 0.7, 0.04}}}},
                     Eigen::Isometry3d(Eigen::Translation3d(0.65, 0, -0.02)));
  scene.add_obstacle("card", {{geometry::Box{{0.1, 0.1, 0.005}}}},
                     Eigen::Isometry3d(Eigen::Translation3d(0.6, 0, 0.0025)));
  return scene;
}

VectorXd random_free(Scene& scene, std::mt19937& rng) {
  const robot::Robot& robot = scene.robot();
  for (;;) {
    VectorXd q(robot.dof());
    for (int i = 0; i < robot.dof(); ++i) {
      q[i] = std::uniform_real_distribution<double>(robot.lower()[i], robot.upper()[i])(rng);
    }
    if (scene.is_free(q)) return q;
  }
}

/// Motions that start free, in a random direction, whose largest joint step is `span`, within the
/// limits.
std::vector<std::pair<VectorXd, VectorXd>> random_motions(Scene& scene, double span) {
  std::mt19937 rng(1);
  std::vector<std::pair<VectorXd, VectorXd>> motions;
  while (motions.size() < 256) {
    const VectorXd q1 = random_free(scene, rng);
    const VectorXd towards = random_free(scene, rng) - q1;
    const VectorXd q2 = q1 + towards * (span / towards.cwiseAbs().maxCoeff());
    if (scene.robot().is_within(q2)) motions.emplace_back(q1, q2);
  }
  return motions;
}

bool is_free_by_steps(Scene& scene, const VectorXd& q1, const VectorXd& q2, double resolution) {
  const int steps = static_cast<int>(std::ceil((q2 - q1).cwiseAbs().maxCoeff() / resolution));
  for (int i = 0; i <= steps; ++i) {
    if (!scene.is_free(q1 + i * ((q2 - q1) / steps))) return false;
  }
  return true;
}

void BM_MakeScene(benchmark::State& state) {
  const robot::Robot robot = wam();
  for (auto _ : state) benchmark::DoNotOptimize(make_scene(robot));
}
BENCHMARK(BM_MakeScene);

void BM_CopyScene(benchmark::State& state) {
  const Scene scene = make_scene(wam());
  for (auto _ : state) benchmark::DoNotOptimize(Scene(scene));
}
BENCHMARK(BM_CopyScene);

void BM_IsFree(benchmark::State& state) {
  Scene scene = make_scene(wam());
  std::mt19937 rng(2);
  std::vector<VectorXd> configurations;
  for (int i = 0; i < 256; ++i) configurations.push_back(random_free(scene, rng));
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(scene.is_free(configurations[i++ % 256]));
  state.counters["pairs"] = scene.world().num_pairs();
}
BENCHMARK(BM_IsFree);

void BM_Motion(benchmark::State& state) {
  Scene scene = make_scene(wam());
  const auto motions = random_motions(scene, static_cast<double>(state.range(0)) / 100);
  std::size_t i = 0, free = 0;
  for (auto _ : state) {
    const auto& [q1, q2] = motions[i++ % 256];
    free += scene.is_free(q1, q2, 0.01);
  }
  state.counters["free"] = static_cast<double>(free) / static_cast<double>(i);
}
BENCHMARK(BM_Motion)->ArgName("span_0.01rad")->Arg(5)->Arg(20)->Arg(100);

void BM_MotionByStepping(benchmark::State& state) {
  Scene scene = make_scene(wam());
  const auto motions = random_motions(scene, static_cast<double>(state.range(0)) / 100);
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [q1, q2] = motions[i++ % 256];
    benchmark::DoNotOptimize(is_free_by_steps(scene, q1, q2, 0.01));
  }
}
BENCHMARK(BM_MotionByStepping)->ArgName("span_0.01rad")->Arg(5)->Arg(20)->Arg(100);

}  // namespace
}  // namespace graspless::scene
