// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A world the size of the slide planner's: an arm of nine capsules with twenty self pairs, a table
// slab, two prisms.
#include <cmath>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "graspless/collision/world.hpp"

namespace graspless::collision {
namespace {

using Poses = std::vector<Eigen::Isometry3d>;

constexpr int kLinks = 9;
constexpr int kBodies = 12;

geometry::Convex prism(int sides, double radius, double height) {
  geometry::Convex convex;
  convex.vertices.resize(3, 2 * sides);
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    const Eigen::Vector2d corner(radius * std::cos(angle), radius * std::sin(angle));
    convex.vertices.col(i) << corner, -height / 2;
    convex.vertices.col(sides + i) << corner, height / 2;
  }
  return convex;
}

World make_world(bool round_table) {
  World world;
  for (int i = 0; i < kLinks; ++i) {
    world.add_body("link" + std::to_string(i), {{geometry::Capsule{0.05, i < 5 ? 0.25 : 0.08}}});
  }
  const geometry::Shape table =
      round_table ? geometry::Shape(prism(100, 0.35, 0.04)) : geometry::Box{{0.7, 0.7, 0.04}};
  world.add_body("table", {{table}});
  world.add_body("card", {{prism(100, 0.055, 0.005)}});
  world.add_body("triangle", {{prism(3, 0.075, 0.005)}});
  for (int i = 0; i < kLinks; ++i) {
    for (int j = i + 3; j < kLinks; ++j) world.add_pair(i, j);
    if (i > 0) {
      for (int body = kLinks; body < kBodies; ++body) world.add_pair(i, body);
    }
  }
  return world;
}

/// A chain of links that bends at random, low over the table in front of it.
Poses random_arm(std::mt19937& rng) {
  std::uniform_real_distribution<double> bend(-0.5, 0.5);
  Poses poses;
  Eigen::Isometry3d X_WL(Eigen::Translation3d(0, 0, 0.15));
  X_WL.rotate(Eigen::AngleAxisd(1.3, Eigen::Vector3d::UnitY()));
  for (int i = 0; i < kLinks; ++i) {
    const double half = i < 5 ? 0.16 : 0.07;
    X_WL = X_WL * Eigen::AngleAxisd(bend(rng), Eigen::Vector3d::UnitX()) *
           Eigen::AngleAxisd(bend(rng), Eigen::Vector3d::UnitY()) *
           Eigen::Translation3d(0, 0, half);
    poses.push_back(X_WL);
    X_WL = X_WL * Eigen::Translation3d(0, 0, half);
  }
  poses.emplace_back(Eigen::Translation3d(0.65, 0, -0.1));
  poses.emplace_back(Eigen::Translation3d(0.6, 0.1, -0.07));
  poses.emplace_back(Eigen::Translation3d(0.7, -0.1, -0.07));
  return poses;
}

void set_poses(World& world, const Poses& poses) {
  for (int i = 0; i < kBodies; ++i) world.set_pose(i, poses[i]);
}

std::vector<Poses> random_arms(World& world, bool free_only) {
  std::mt19937 rng(1);
  std::vector<Poses> arms;
  while (arms.size() < 256) {
    Poses poses = random_arm(rng);
    set_poses(world, poses);
    if (!free_only || !world.collides()) arms.push_back(std::move(poses));
  }
  return arms;
}

void BM_SetPoses(benchmark::State& state) {
  World world = make_world(false);
  const auto arms = random_arms(world, true);
  std::size_t i = 0;
  for (auto _ : state) set_poses(world, arms[i++ % arms.size()]);
}
BENCHMARK(BM_SetPoses);

void BM_Collides(benchmark::State& state) {
  World world = make_world(state.range(0) != 0);
  const auto arms = random_arms(world, state.range(1) != 0);
  std::size_t i = 0;
  for (auto _ : state) {
    set_poses(world, arms[i++ % arms.size()]);
    benchmark::DoNotOptimize(world.collides());
  }
}
BENCHMARK(BM_Collides)->ArgNames({"round_table", "free_only"})->ArgsProduct({{0, 1}, {0, 1}});

void BM_CollidesAlone(benchmark::State& state) {
  World world = make_world(false);
  set_poses(world, random_arms(world, true)[0]);
  for (auto _ : state) benchmark::DoNotOptimize(world.collides());
}
BENCHMARK(BM_CollidesAlone);

void BM_AllCollisions(benchmark::State& state) {
  World world = make_world(false);
  const auto arms = random_arms(world, true);
  std::size_t i = 0;
  for (auto _ : state) {
    set_poses(world, arms[i++ % arms.size()]);
    benchmark::DoNotOptimize(world.all_collisions());
  }
}
BENCHMARK(BM_AllCollisions);

void BM_DistanceBounds(benchmark::State& state) {
  World world = make_world(false);
  const auto arms = random_arms(world, true);
  std::size_t i = 0;
  for (auto _ : state) {
    set_poses(world, arms[i++ % arms.size()]);
    benchmark::DoNotOptimize(world.distance_bounds().data());
  }
}
BENCHMARK(BM_DistanceBounds);

void BM_CopyWorld(benchmark::State& state) {
  const World world = make_world(false);
  for (auto _ : state) benchmark::DoNotOptimize(World(world));
}
BENCHMARK(BM_CopyWorld);

}  // namespace
}  // namespace graspless::collision
