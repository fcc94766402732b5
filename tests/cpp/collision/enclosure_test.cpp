// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/enclosure.hpp"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "graspless/watch.hpp"

#include "collision/shapes.hpp"

namespace graspless::collision {
namespace {

using Eigen::Vector3d;
using geometry::Mesh;

constexpr double kRing = 0.3, kTube = 0.1;  // radii of a torus [m]

Mesh torus(int around, int across) {
  Mesh mesh;
  mesh.vertices.resize(3, around * across);
  mesh.triangles.resize(3, 2 * around * across);
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * M_PI * i / around, v = 2 * M_PI * j / across;
      const double r = kRing + kTube * std::cos(v);
      mesh.vertices.col(i * across + j) << r * std::cos(u), r * std::sin(u), kTube * std::sin(v);
      const int a = i * across + j, b = (i + 1) % around * across + j,
                c = (i + 1) % around * across + (j + 1) % across, d = i * across + (j + 1) % across;
      mesh.triangles.col(2 * a) << a, b, c;
      mesh.triangles.col(2 * a + 1) << a, c, d;
    }
  }
  return mesh;
}

/// Both surfaces as one mesh.
Mesh joined(const Mesh& a, const Mesh& b) {
  Mesh mesh;
  mesh.vertices.resize(3, a.vertices.cols() + b.vertices.cols());
  mesh.vertices << a.vertices, b.vertices;
  mesh.triangles.resize(3, a.triangles.cols() + b.triangles.cols());
  mesh.triangles << a.triangles,
      (b.triangles.array() + static_cast<int>(a.vertices.cols())).matrix();
  return mesh;
}

Mesh scaled(Mesh mesh, double factor) {
  mesh.vertices *= factor;
  return mesh;
}

/// Every triangle with corners of its own, as in an .stl file.
Mesh unwelded(const Mesh& mesh) {
  Mesh loose;
  loose.vertices.resize(3, 3 * mesh.triangles.cols());
  loose.triangles.resize(3, mesh.triangles.cols());
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    for (int k = 0; k < 3; ++k) {
      loose.vertices.col(3 * i + k) = mesh.vertices.col(mesh.triangles(k, i));
      loose.triangles(k, i) = static_cast<int>(3 * i + k);
    }
  }
  return loose;
}

TEST(Enclosure, TellsTheInsideOfATorus) {
  std::mt19937 rng(3);
  const Mesh mesh = torus(96, 48);
  const Enclosure enclosure(mesh), loose(unwelded(mesh));
  int inside = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3d p(uniform(rng, -.45, .45), uniform(rng, -.45, .45), uniform(rng, -.15, .15));
    const double off = std::hypot(p.head<2>().norm() - kRing, p.z()) - kTube;
    if (std::abs(off) < 0.001) continue;  // the mesh is not quite the torus
    ASSERT_EQ(enclosure.contains(p), off < 0) << p.transpose();
    ASSERT_EQ(loose.contains(p), off < 0) << p.transpose();
    inside += off < 0;
  }
  EXPECT_GT(inside, 2000);
}

TEST(Enclosure, RaysThroughVerticesAndEdgesCountOnce) {
  // Points from which the ray passes exactly through corners and edges of the mesh.
  const Eigen::Matrix3d to_ray =
      Eigen::Quaterniond(0.8147, 0.3218, -0.4163, 0.2391).normalized().toRotationMatrix();
  const Mesh mesh = dented_prism(12, 1, 1);
  const Enclosure enclosure(mesh);
  const Vector3d along = to_ray.transpose().col(2);
  for (const auto& triangle : mesh.triangles.colwise()) {
    for (int k = 0; k < 3; ++k) {
      const Vector3d a = mesh.vertices.col(triangle[k]),
                     b = mesh.vertices.col(triangle[(k + 1) % 3]);
      for (const Vector3d& through : {a, Vector3d((a + b) / 2)}) {
        EXPECT_FALSE(enclosure.contains(through - 5 * along));
        EXPECT_FALSE(enclosure.contains(through + 5 * along));
      }
    }
  }
  EXPECT_TRUE(enclosure.contains(Vector3d::Zero()));
}

TEST(Enclosure, AnOpenSurfaceEnclosesNothing) {
  Mesh mesh = torus(24, 12);
  mesh.triangles.conservativeResize(3, mesh.triangles.cols() - 1);
  EXPECT_FALSE(Enclosure(mesh).contains({kRing, 0, 0}));
}

TEST(Enclosure, ACavityIsOutside) {
  const Enclosure shell(joined(prism(24, 1, 1), scaled(prism(24, 1, 1), 0.5)));
  EXPECT_FALSE(shell.contains({0.01, 0.02, 0.03}));
  EXPECT_TRUE(shell.contains({0.7, 0, 0}));
  EXPECT_FALSE(shell.contains({1.2, 0, 0}));
  EXPECT_EQ(shell.vertex_of_each_part().cols(), 2);
}

int add(World& world, const std::string& name, const geometry::Shape& shape,
        const Eigen::Isometry3d& X_WB) {
  const int body = world.add_body(name, {{shape}});
  world.set_pose(body, X_WB);
  return body;
}

TEST(World, ABodyInsideAClosedMeshTouchesIt) {
  const geometry::Shape inner[] = {
      geometry::Box{{.02, .02, .02}},      geometry::Sphere{.02},
      geometry::Capsule{.01, .02},         scaled(torus(24, 12), 0.1),
      scaled(dented_prism(8, 1, 1), 0.02), geometry::Convex{scaled(prism(8, 1, 1), 0.02).vertices}};
  for (const geometry::Shape& shape : inner) {
    for (const bool first : {false, true}) {
      World world;
      const auto at = [&](double x) { return translation(x, 0, 0); };
      int small = first ? add(world, "small", shape, at(kRing)) : -1;
      const int ring = add(world, "ring", torus(48, 24), at(0));
      if (!first) small = add(world, "small", shape, at(kRing));
      world.add_pair(small, ring);
      EXPECT_TRUE(world.collides());
      EXPECT_FALSE(world.touches(0));
      EXPECT_TRUE(world.swallows(0));
      EXPECT_EQ(world.all_collisions().size(), 1u);
      world.set_pose(small, at(0));  // in the hole
      EXPECT_FALSE(world.collides());
      EXPECT_TRUE(world.all_collisions().empty());
      world.set_pose(small, at(kRing + kTube));  // on the surface
      EXPECT_TRUE(world.touches(0));
      world.set_pose(small, at(0.9));
      EXPECT_FALSE(world.collides());
    }
  }
}

/// True if the look is ended at a call of the check, the first of which is 0.
bool is_ended_at(int call, const std::function<void()>& look) {
  const Watch watch([&] {
    if (call-- <= 0) throw Stop{};
  });
  try {
    look();
    return false;
  } catch (const Stop&) {
    return true;
  }
}

TEST(Enclosure, AnEndedPreparationBeginsAnew) {
  const Mesh mesh = torus(400, 250);
  const Vector3d inside(kRing, 0, 0);
  for (int call = 0;; ++call) {
    const Enclosure enclosure(mesh);
    const bool is_ended = is_ended_at(call, [&] { enclosure.contains(inside); });
    EXPECT_TRUE(enclosure.contains(inside)) << "ended at call " << call;
    EXPECT_FALSE(enclosure.contains(Vector3d::Zero()));
    if (!is_ended) break;
  }
}

TEST(World, ABodyInsideAnOpenMeshIsFree) {
  Mesh open = torus(48, 24);
  open.triangles.conservativeResize(3, open.triangles.cols() - 2);
  World world;
  world.add_pair(add(world, "ring", open, translation(0, 0, 0)),
                 add(world, "ball", geometry::Sphere{.02}, translation(kRing, 0, 0)));
  EXPECT_FALSE(world.collides());
}

}  // namespace
}  // namespace graspless::collision
