// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/fingertip/object.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "graspless/mechanics/contact.hpp"

#include "complaint.hpp"
#include "fingertip/meshes.hpp"
#include "fingertip/model/mesh.hpp"
#include "geometry/box_mesh.hpp"

namespace graspless::fingertip {
namespace {

TEST(FingertipObject, BoxHasItsTextbookProperties) {
  const Object box = Object::box("brick", {0.2, 0.3, 0.6}, 1.2);
  EXPECT_TRUE(box.com().isZero(0));
  const Eigen::Vector3d J(0.09 + 0.36, 0.04 + 0.36, 0.04 + 0.09);
  EXPECT_TRUE(box.inertia().isApprox(Eigen::Matrix3d((0.1 * J).asDiagonal()), 1e-12));
  EXPECT_TRUE(box.inertia().isDiagonal(0));
  EXPECT_TRUE(box.is_convex());
  EXPECT_EQ(box.hull().cols(), 8);
  EXPECT_NEAR(box.size(), 0.7, 1e-12);
  ASSERT_EQ(box.faces().size(), 6U);
  double area = 0;
  for (const Face& face : box.faces()) {
    area += face.area;
    EXPECT_EQ(face.triangles.size(), 2U);
    EXPECT_LT(face.offset, 0);  // n_O looks inward
    EXPECT_TRUE(face.first_O.isApprox(mechanics::tangent(face.n_O, Eigen::Vector3d::Zero())));
    EXPECT_TRUE(face.second_O.isApprox(face.n_O.cross(face.first_O)));
  }
  EXPECT_NEAR(area, 2 * (0.06 + 0.12 + 0.18), 1e-12);
}

// The volume's integrals move with the mesh: steps of no theory in common with the tetrahedra.
TEST(FingertipObject, PropertiesFollowARigidMotion) {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> number(-1, 1);
  const Object before = Object::from_mesh("L", l_mesh(), 2);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Isometry3d X =
        Eigen::Translation3d(number(rng), number(rng), number(rng)) *
        Eigen::Quaterniond(number(rng), number(rng), number(rng), number(rng)).normalized();
    geometry::Mesh mesh = l_mesh();
    mesh.vertices = X * mesh.vertices;
    const Object after = Object::from_mesh("L", mesh, 2);
    EXPECT_TRUE(after.com().isApprox(X * before.com(), 1e-10));
    EXPECT_TRUE(
        after.inertia().isApprox(X.linear() * before.inertia() * X.linear().transpose(), 1e-10));
    EXPECT_EQ(after.faces().size(), before.faces().size());
  }
}

TEST(FingertipObject, VerticesOfNoTriangleAreNoPart) {
  geometry::Mesh mesh = l_mesh();
  const Object before = Object::from_mesh("L", mesh, 2);
  mesh.vertices.conservativeResize(3, mesh.vertices.cols() + 1);
  mesh.vertices.rightCols<1>() << 0.3, 0.2, 0.9;
  const Object after = Object::from_mesh("L", mesh, 2);
  EXPECT_EQ(after.hull(), before.hull());
  EXPECT_EQ(after.size(), before.size());
}

TEST(FingertipObject, LIsTwoBoxes) {
  const Object l = Object::from_mesh("L", l_mesh(), 3);
  // A bar of 3 x 1 x 1 along x and a cube on its end: centres (1.5, .5, .5) and (.5, .5, 1.5).
  EXPECT_TRUE(l.com().isApprox(Eigen::Vector3d(1.25, 0.5, 0.75), 1e-12));
  EXPECT_FALSE(l.is_convex());
  EXPECT_EQ(l.faces().size(), 8U);
  EXPECT_EQ(l.hull().cols(), 10);
  double largest = 0;
  for (const Face& face : l.faces()) largest = std::max(largest, face.area);
  EXPECT_NEAR(largest, 4, 1e-12);  // either side of the L, one face
}

TEST(FingertipObject, MergesVerticesAndTurnsInvertedMeshesOutward) {
  const geometry::Mesh mesh = l_mesh();
  geometry::Mesh soup{Eigen::Matrix3Xd(3, 3 * mesh.triangles.cols()),
                      Eigen::Matrix3Xi(3, mesh.triangles.cols())};
  for (int i = 0; i < static_cast<int>(mesh.triangles.cols()); ++i) {
    for (int k = 0; k < 3; ++k) {
      soup.vertices.col(3 * i + k) = mesh.vertices.col(mesh.triangles(k, i));
      soup.triangles(2 - k, i) = 3 * i + k;  // inverted
    }
  }
  const Object object = Object::from_mesh("soup", soup, 3);
  EXPECT_EQ(object.mesh().vertices.cols(), mesh.vertices.cols());
  EXPECT_TRUE(object.com().isApprox(Eigen::Vector3d(1.25, 0.5, 0.75), 1e-12));
  EXPECT_GT(object.inertia()(0, 0), 0);
  EXPECT_EQ(object.faces().size(), 8U);
}

TEST(FingertipObject, FacesOfAFineSphereAreItsTriangles) {
  const geometry::Mesh mesh = sphere_mesh(20, 40);
  const Object ball = Object::from_mesh("ball", mesh, 1);
  EXPECT_TRUE(ball.is_convex());
  // The flat quadrilaterals between meridians are faces of two triangles.
  EXPECT_EQ(ball.faces().size(), 20U * 40U);
}

TEST(FingertipObject, TakesAnotherCentreAndInertia) {
  const Object box = Object::box("brick", {0.2, 0.3, 0.6}, 1);
  EXPECT_EQ(box.with_com({0.05, 0, -0.1}).com(), Eigen::Vector3d(0.05, 0, -0.1));
  expect_refused([&] { box.with_com({0.11, 0, 0}); }, "com");
  expect_refused([&] { box.with_com({std::nan(""), 0, 0}); }, "com");
  EXPECT_EQ(box.with_inertia(Eigen::Matrix3d::Identity()).inertia(), Eigen::Matrix3d::Identity());
  expect_refused([&] { box.with_inertia(-Eigen::Matrix3d::Identity()); }, "inertia");
}

/// Both meshes, the second one scaled, moved and perhaps inside out.
geometry::Mesh with_cube(geometry::Mesh mesh, double size, const Eigen::Vector3d& center,
                         bool is_inverted) {
  geometry::Mesh cube = geometry::box_mesh({size, size, size});
  cube.vertices.colwise() += center;
  if (is_inverted) cube.triangles.row(1).swap(cube.triangles.row(2));
  const Eigen::Index corners = mesh.vertices.cols(), triangles = mesh.triangles.cols();
  mesh.vertices.conservativeResize(3, corners + 8);
  mesh.vertices.rightCols(8) = cube.vertices;
  mesh.triangles.conservativeResize(3, triangles + 12);
  mesh.triangles.rightCols(12) = cube.triangles.array() + static_cast<int>(corners);
  return mesh;
}

TEST(FingertipObject, APieceThatIsInsideOutMustBeACavity) {
  const auto make = [](const geometry::Mesh& mesh) { return Object::from_mesh("it", mesh, 1); };
  const geometry::Mesh big = geometry::box_mesh({0.06, 0.06, 0.06});
  const std::string complaint = "object 'it' mesh must be oriented throughout, but its piece of 12";
  for (const double x : {0.06, 0.04, 0.035, -0.2}) {  // beside it, flush with it, part in it
    expect_refused([&] { make(with_cube(big, 0.02, {x, 0, 0}, true)); }, complaint);
    EXPECT_NO_THROW(make(with_cube(big, 0.02, {x, 0, 0}, false)));
  }
  expect_refused([&] { make(with_cube(big, 0.06, {0.1, 0, 0}, true)); }, complaint);  // no volume
  expect_refused([&] { make(with_cube(big, 0.08, {0.1, 0, 0}, true)); }, complaint);
  // The empty corner of an L lies within its bounding box.
  expect_refused([&] { make(with_cube(l_mesh(), 0.5, {2, 0.5, 1.5}, true)); }, complaint);

  const Object hollow = make(with_cube(big, 0.02, {0.01, 0, 0}, true));
  const double part = std::pow(0.02 / 0.06, 3);
  EXPECT_NEAR(hollow.com().x(), -part * 0.01 / (1 - part), 1e-12);
  EXPECT_NO_THROW(make(with_cube(big, 0.02, {0.02, 0, 0}, true)));  // up to the wall
  geometry::Mesh turned = with_cube(big, 0.02, {0.01, 0, 0}, true);
  turned.triangles.row(1).swap(turned.triangles.row(2));
  EXPECT_EQ(make(turned).com(), hollow.com());
  const geometry::Mesh shell = with_cube(big, 0.04, {0, 0, 0}, true);
  EXPECT_NO_THROW(make(with_cube(shell, 0.02, {0, 0, 0}, false)));
  expect_refused([&] { make(with_cube(shell, 0.02, {0, 0, 0}, true)); }, complaint);
}

TEST(FingertipObject, RefusesBadMeshes) {
  const auto make = [](const geometry::Mesh& mesh) { Object::from_mesh("it", mesh, 1); };
  geometry::Mesh open = l_mesh();
  open.triangles.conservativeResize(3, open.triangles.cols() - 1);
  expect_refused([&] { make(open); }, "object 'it' mesh must be watertight");
  geometry::Mesh twisted = l_mesh();
  std::swap(twisted.triangles(0, 3), twisted.triangles(1, 3));
  expect_refused([&] { make(twisted); }, "oriented");
  geometry::Mesh flat = l_mesh();
  flat.vertices.row(2).setZero();
  expect_refused([&] { make(flat); }, "object 'it' mesh must");
  geometry::Mesh nan = l_mesh();
  nan.vertices(1, 1) = std::nan("");
  expect_refused([&] { make(nan); }, "object 'it' mesh");
  geometry::Mesh huge = l_mesh();
  huge.vertices *= 1e6;
  expect_refused([&] { make(huge); }, "within 10000 m");
  geometry::Mesh many{Eigen::Matrix3Xd::Zero(3, 3),
                      Eigen::Matrix3Xi::Zero(3, Object::kMaxTriangles + 1)};
  expect_refused([&] { make(many); }, "200000 triangles");
  expect_refused([&] { make({}); }, "object 'it' mesh");
  for (const double mass : {0.0, -1.0, std::nan("")}) {
    expect_refused([&] { Object::box("it", {1, 1, 1}, mass); }, "object 'it' mass");
  }
  expect_refused([&] { Object::box("it", {1, 0, 1}, 1); }, "size[1]");
}

}  // namespace
}  // namespace graspless::fingertip
