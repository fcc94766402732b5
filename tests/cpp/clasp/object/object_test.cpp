// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/object.hpp"

#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "graspless/collision/world.hpp"

#include "clasp/object/surface.hpp"
#include "clasp/ring_problem.hpp"
#include "complaint.hpp"

namespace graspless::clasp {
namespace {

TEST(Object, SurfaceIsWhatTheLoopsWereTakenFrom) {
  const Eigen::Matrix3Xd cloud = ring_cloud(0.12, 0.02);
  const Object ring = Object::from_cloud("ring", cloud);
  EXPECT_EQ(ring.name(), "ring");
  EXPECT_EQ(ring.points(), cloud);
  EXPECT_EQ(ring.loops().found.size(), 1u);
  const geometry::Complex& complex = ring.loops().complex;
  EXPECT_EQ(ring.surface().triangles.leftCols(complex.triangles.cols()), complex.triangles);
  EXPECT_GT(ring.spacing(), 0.001);
  EXPECT_LT(ring.spacing(), 0.02);
}

TEST(Object, ClearanceAndSolidAreOfThatSurface) {
  const Object ring = Object::from_cloud("ring", ring_cloud(0.12, 0.02));
  EXPECT_NEAR(ring.clearance().distance(Eigen::Vector3d::Zero()), 0.11, 0.001);
  for (const double radius : {0.109, 0.112}) {
    collision::World world;
    const int body = world.add_body("ring", ring.solid());
    world.add_pair(body, world.add_body("ball", {{geometry::Sphere{radius}}}));
    EXPECT_EQ(world.collides(), radius > 0.11);
  }
}

TEST(Object, OuterClearanceIsThatOfTheSurfaceSeenFromOutside) {
  // Four points of the ring often lie in a plane: tetrahedra without volume wall nothing in.
  std::mt19937_64 rng(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (const double thickness : {0.02, 0.03}) {
    const Object ring = Object::from_cloud("ring", ring_cloud(0.12, thickness));
    EXPECT_LT(shell_of(ring.loops().complex).triangles.cols(),
              0.7 * static_cast<double>(ring.surface().triangles.cols()));
    for (int i = 0; i < 2000; ++i) {
      const Eigen::Vector3d p = 0.2 * Eigen::Vector3d(0.3 * unit(rng), unit(rng), unit(rng));
      const double off_axis = std::hypot(p.x(), std::hypot(p.y(), p.z()) - 0.12);
      if (off_axis < thickness / 2 + 0.0001) continue;  // within
      EXPECT_NEAR(ring.outer_clearance().distance(p), ring.clearance().distance(p), 1e-12);
    }
  }
}

TEST(Object, IsOpenWhereItHasNoPoints) {
  // Four of the 48 sections are missing; the default d is smaller than this gap.
  const Eigen::Matrix3Xd open = ring_cloud(0.12, 0.02).leftCols(8 * 44);
  geometry::LoopOptions options;
  options.max_edge_length = 0.09;
  const Object ring = Object::from_cloud("open ring", open, options);
  ASSERT_EQ(ring.loops().uncertain.size(), 1u);
  EXPECT_GT(ring.loops().uncertain[0].gap, 0.06);
  const Eigen::Vector3d middle =
      (open.leftCols(8).rowwise().mean() + open.rightCols(8).rowwise().mean()) / 2;
  EXPECT_LT(collision::Clearance(surface_of(ring.loops().complex)).distance(middle), 0.005);
  EXPECT_GT(ring.clearance().distance(middle), 0.03);
  EXPECT_GT(ring.outer_clearance().distance(middle), 0.03);
}

TEST(Object, CopiesShare) {
  const Object ring = Object::from_cloud("ring", ring_cloud(0.12, 0.02));
  const Object copy = ring;
  EXPECT_EQ(&ring.surface(), &copy.surface());
  EXPECT_EQ(&ring.clearance(), &copy.clearance());
}

/// A grid comes back, and only one user has it at a time, who may outlive the object.
TEST(Object, LendsAGridToOneAtATime) {
  std::shared_ptr<collision::Clearance> first, second;
  {
    const Object ring = Object::from_cloud("ring", ring_cloud(0.12, 0.02));
    const collision::Clearance* const grid = ring.borrow_outer_clearance().get();
    // Takes the memory, if the grid is gone.
    const auto other = std::make_unique<collision::Clearance>(ring.outer_clearance());
    first = ring.borrow_outer_clearance();
    second = ring.borrow_outer_clearance();
    EXPECT_EQ(first.get(), grid);
    EXPECT_NE(second.get(), grid);
    EXPECT_NEAR(first->bounds(Eigen::Vector3d::Zero(), 0).upper, 0.11, 0.01);
  }
  first.reset();
  EXPECT_NEAR(second->distance(Eigen::Vector3d::Zero()), 0.11, 0.001);
}

TEST(Object, RefusesWhatHasNoLoopsToTake) {
  expect_refused([] { Object::from_cloud("dust", Eigen::Matrix3Xd::Random(3, 5)); }, "20");
}

geometry::Complex two_triangles_and_a_tail() {
  geometry::Complex complex;
  complex.points.resize(3, 6);
  complex.points << 0, 1, 0, 1, 2, 9,  //
      0, 0, 1, 1, 1, 9,                //
      0, 0, 0, 0, 0, 9;
  complex.edges.resize(2, 7);
  complex.edges << 0, 0, 1, 1, 2, 3, 2,  //
      1, 2, 2, 3, 3, 4, 4;
  complex.triangles.resize(3, 2);
  complex.triangles << 0, 1,  //
      1, 2,                   //
      2, 3;
  return complex;
}

TEST(ObjectSurface, BareEdgesAndLonePointsAreThinTriangles) {
  const geometry::Complex complex = two_triangles_and_a_tail();
  const geometry::Mesh mesh = surface_of(complex);
  ASSERT_EQ(mesh.triangles.cols(), 5);  // the edges 3-4 and 2-4 bound none, point 5 is alone
  geometry::validate(mesh, "mesh");
  for (Eigen::Index i = 2; i < 4; ++i) {
    const auto corners = mesh.triangles.col(i);
    const Eigen::Vector3d a = mesh.vertices.col(corners[0]), b = mesh.vertices.col(corners[1]),
                          c = mesh.vertices.col(corners[2]);
    EXPECT_NEAR((b - a).cross(c - a).norm() / (b - a).norm(), 0.001, 1e-9);
  }
  EXPECT_EQ(mesh.triangles(0, 4), 5);
  EXPECT_LT(collision::Clearance(mesh).distance({9, 9, 9.002}), 0.0021);
}

TEST(ObjectSurface, DustIsSpecks) {
  geometry::Complex complex;
  complex.points = Eigen::Matrix3Xd::Random(3, 4);
  complex.edges.resize(2, 0);
  complex.triangles.resize(3, 0);
  const geometry::Mesh mesh = surface_of(complex);
  EXPECT_EQ(mesh.triangles.cols(), 4);
  geometry::validate(mesh, "mesh");
  for (Eigen::Index i = 0; i < 4; ++i) {
    EXPECT_LE(collision::Clearance(mesh).distance(complex.points.col(i)), 1e-9);
  }
}

}  // namespace
}  // namespace graspless::clasp
