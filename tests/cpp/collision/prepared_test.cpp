// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/prepared.hpp"

#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace graspless::collision {
namespace {

/// A mesh of random triangles.
geometry::Mesh random_mesh(unsigned seed, int triangles) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-0.1, 0.1);
  geometry::Mesh mesh;
  mesh.vertices.resize(3, 3 * triangles);
  mesh.triangles.resize(3, triangles);
  for (double& value : mesh.vertices.reshaped()) value = place(random);
  for (int i = 0; i < 3 * triangles; ++i) mesh.triangles(i % 3, i / 3) = i;
  return mesh;
}

CollisionShape shape_of(const geometry::Mesh& mesh) {
  return make_collision_shape({mesh, Eigen::Isometry3d::Identity()}, "mesh");
}

bool share(const CollisionShape& a, const CollisionShape& b) {
  return a.geometry == b.geometry && a.hulls == b.hulls && a.enclosure == b.enclosure;
}

TEST(Prepared, EqualMeshesShareWhatWasMadeOfThem) {
  const geometry::Mesh mesh = random_mesh(1, 20);
  const CollisionShape first = shape_of(mesh);
  EXPECT_TRUE(share(first, shape_of(geometry::Mesh(mesh))));
  Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
  moved.translation() << 1, 2, 3;
  const CollisionShape elsewhere = make_collision_shape({mesh, moved}, "mesh");
  EXPECT_TRUE(share(first, elsewhere));
  EXPECT_TRUE(elsewhere.X_BC.isApprox(moved * first.X_BC));
}

TEST(Prepared, MeshesThatDifferInOneNumberShareNothing) {
  const geometry::Mesh mesh = random_mesh(2, 20);
  const CollisionShape first = shape_of(mesh);
  for (Eigen::Index i = 0; i < mesh.vertices.size(); i += 7) {
    geometry::Mesh other = mesh;
    other.vertices.reshaped()(i) += 1e-9;
    EXPECT_FALSE(share(first, shape_of(other))) << i;
  }
  geometry::Mesh other = mesh;
  other.triangles.col(3).reverseInPlace();
  EXPECT_FALSE(share(first, shape_of(other)));
}

TEST(Prepared, OldMeshesAreForgotten) {
  const geometry::Mesh mesh = random_mesh(3, 500);
  const CollisionShape first = shape_of(mesh);
  for (unsigned seed = 10; seed < 210; ++seed) shape_of(random_mesh(seed, 500));
  EXPECT_FALSE(share(first, shape_of(mesh)));
}

TEST(Prepared, LargeMeshesAreKeptBesideSmallOnesUpToAMillionTriangles) {
  const geometry::Mesh small = random_mesh(4, 20);
  const CollisionShape first = shape_of(small);
  int calls = 0;
  const auto makes = [&](const geometry::Mesh&) {
    ++calls;
    return first;
  };
  const geometry::Mesh a = random_mesh(11, 130'000), b = random_mesh(12, 130'000),
                       c = random_mesh(13, 130'000), huge = random_mesh(14, 340'000);
  for (const auto* mesh : {&a, &b, &a, &b}) prepared(*mesh, makes);  // of 390,000 vertices each
  EXPECT_EQ(calls, 2);
  for (const auto* mesh : {&huge, &huge, &a, &b}) prepared(*mesh, makes);
  EXPECT_EQ(calls, 4);
  for (const auto* mesh : {&c, &b, &a}) prepared(*mesh, makes);
  EXPECT_EQ(calls, 6);  // c and a, which c displaced
  EXPECT_TRUE(share(first, shape_of(small)));
}

TEST(Prepared, WhatCannotBeMadeIsTriedAgain) {
  const geometry::Mesh mesh = random_mesh(5, 20);
  int calls = 0;
  const auto fails = [&](const geometry::Mesh&) -> CollisionShape {
    ++calls;
    throw std::runtime_error("no time");
  };
  EXPECT_THROW(prepared(mesh, fails), std::runtime_error);
  EXPECT_THROW(prepared(mesh, fails), std::runtime_error);
  EXPECT_EQ(calls, 2);
}

TEST(Prepared, ThreadsMayAskAtOnce) {
  const std::vector<geometry::Mesh> meshes = {random_mesh(6, 50), random_mesh(7, 50)};
  std::vector<std::thread> threads;
  for (int k = 0; k < 4; ++k) {
    threads.emplace_back([&] {
      for (int i = 0; i < 50; ++i) EXPECT_NE(shape_of(meshes[i % 2]).geometry->get(), nullptr);
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(share(shape_of(meshes[0]), shape_of(meshes[0])));
}

}  // namespace
}  // namespace graspless::collision
