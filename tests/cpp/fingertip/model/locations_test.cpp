// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/model/locations.hpp"

#include <set>

#include <gtest/gtest.h>

#include "fingertip/cases.hpp"
#include "fingertip/meshes.hpp"

namespace graspless::fingertip {
namespace {

TEST(FingertipLocations, PaperGridOfABox) {
  const Object box = Object::box("cuboid", {5, 10, 5}, 1);
  const Locations all(box, paper_fingers(10), Options{});
  ASSERT_EQ(all.size(), 6 * 49);
  std::set<int> faces;
  std::set<double> y;
  for (int i = 0; i < all.size(); ++i) {
    faces.insert(all[i].face);
    const Eigen::Vector3d outward = -all[i].n_O;
    // On the surface, a radius below the sphere's centre.
    EXPECT_NEAR(all[i].p_OC.cwiseAbs().cwiseQuotient(Eigen::Vector3d(2.5, 5, 2.5)).maxCoeff(), 1,
                1e-12);
    EXPECT_TRUE(all[i].center_O.isApprox(all[i].p_OC + outward));
    if (outward.isApprox(Eigen::Vector3d::UnitX())) y.insert(std::round(all[i].p_OC.y() * 1e9));
  }
  EXPECT_EQ(faces.size(), 6U);
  ASSERT_EQ(y.size(), 7U);
  EXPECT_NEAR(*y.begin() * 1e-9, -5 + 10 * 0.5 / 7, 1e-9);  // cell-centred
}

TEST(FingertipLocations, SpacingIsKeptAndTrianglesAreFilled) {
  // A triangular prism: half of the rectangle about each end is off the face.
  const Object prism = Object::from_mesh("prism", prism_mesh({{0, 0}, {1, 0}, {0, 1}}, 2), 1);
  Options options;
  options.location_spacing = 0.1;
  Fingers fingers;
  const Locations all(prism, fingers, options);
  int on_end = 0, on_floor = 0;
  for (int i = 0; i < all.size(); ++i) {
    const Eigen::Vector3d& p = all[i].p_OC;
    EXPECT_GE(p.minCoeff(), -1e-9);
    EXPECT_LE(p.x() + p.z(), 1 + 1e-9);
    if (std::abs(all[i].n_O.y()) > 0.5) ++on_end;
    if (all[i].n_O.z() > 0.5) ++on_floor;
  }
  EXPECT_EQ(on_floor, 10 * 20);
  EXPECT_EQ(on_end, 2 * 55);  // the diagonal's cells belong to the triangle
  EXPECT_LE(all.size(), num_grid_points(prism, options));
}

TEST(FingertipLocations, SpacingRulesWhereFacesAreSmaller) {
  const Object ball = Object::from_mesh("ball", sphere_mesh(20, 40), 1);
  Options options;
  options.location_spacing = 0.5;
  const Locations all(ball, Fingers{}, options);
  // A disc of radius spacing / 2 each at least, of spacing / 2 about each at most.
  EXPECT_LT(all.size(), 4 * M_PI / (M_PI * 0.125 * 0.125) * 0.9);
  EXPECT_GT(all.size(), 4 * M_PI / (M_PI * 0.25 * 0.25) * 0.5);
  for (int i = 0; i < all.size(); ++i) {
    for (int j = 0; j < i; ++j) EXPECT_GE((all[i].p_OC - all[j].p_OC).norm(), 0.25);
  }
}

TEST(FingertipLocations, SphereMustFitIntoConcavePlaces) {
  const Object l = Object::from_mesh("L", l_mesh(), 1);
  Options options;
  options.location_spacing = 0.1;
  Fingers fingers;
  fingers.radius = 0.25;
  const Locations all(l, fingers, options);
  const int unrestrained = static_cast<int>(grid_locations(l, fingers.radius, options).size());
  // The two inner faces, x = 1 above z = 1 and z = 1 beyond x = 1, within a radius of the corner:
  // two rows of ten and a third at exactly 0.25 that just clears.
  EXPECT_EQ(all.size(), unrestrained - 2 * 2 * 10);
  for (int i = 0; i < all.size(); ++i) {
    const Eigen::Vector3d& c = all[i].center_O;
    const bool in_corner = c.x() > 1 && c.z() > 1;
    if (in_corner) {
      EXPECT_GE(std::min(c.x() - 1, c.z() - 1), 0.25 * (1 - 2e-3));
    }
  }
}

TEST(FingertipLocations, PlacementsAreOrderedSets) {
  Placement p = kNoFingers;
  EXPECT_EQ(num_fingers(p), 0);
  for (const int l : {7, 3, 9, 5}) p = with(p, l);
  EXPECT_EQ(p, (Placement{3, 5, 7, 9}));
  EXPECT_EQ(num_fingers(p), 4);
  EXPECT_EQ(without(p, 5), (Placement{3, 7, 9, -1}));
  EXPECT_EQ(without(without(without(without(p, 3), 9), 7), 5), kNoFingers);
}

TEST(FingertipLocations, SpheresMayTouchButNotOverlap) {
  const Object box = Object::box("cuboid", {6, 6, 6}, 1);
  Options options;
  options.locations_per_side = 3;  // 2 apart: the spheres just touch
  const Locations all(box, paper_fingers(10), options);
  for (int i = 0; i < all.size(); ++i) {
    for (int j = 0; j < all.size(); ++j) {
      const double d = (all[i].center_O - all[j].center_O).norm();
      EXPECT_EQ(all.are_apart(i, j), d > 2 - 1e-6) << d;
    }
  }
}

}  // namespace
}  // namespace graspless::fingertip
