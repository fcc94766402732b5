// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/mechanics/contact_patch.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "complaint.hpp"

namespace graspless::mechanics {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr double kTolerance = 1e-6;

Matrix3Xd box(double x, double y, double z) {
  Matrix3Xd vertices(3, 8);
  for (int i = 0; i < 8; ++i) {
    vertices.col(i) << ((i & 1) ? x : -x) / 2, ((i & 2) ? y : -y) / 2, ((i & 4) ? z : -z) / 2;
  }
  return vertices;
}

/// A box of 5 x 5 x 10 that has turned about its bottom edge at x = 2.5 by an angle.
BodyState tumbling(double angle) {
  const Vector3d p_pivot(2.5, 0, 0);
  BodyState state;
  state.X_WO = Eigen::Translation3d(p_pivot) * Eigen::AngleAxisd(angle, Vector3d::UnitY()) *
               Eigen::Translation3d(Vector3d(0, 0, 5) - p_pivot);
  state.twist_W.tail<3>() = Vector3d::UnitY();
  state.twist_W.head<3>() = Vector3d::UnitY().cross(state.X_WO.translation() - p_pivot);
  return state;
}

BodyState resting_on_floor(double height) {
  BodyState state;
  state.X_WO.translation().z() = height;
  return state;
}

ContactPatches patches(const BodyState& state, const std::vector<Plane>& planes = {Plane{}},
                       const Matrix3Xd& vertices = box(5, 5, 10)) {
  return contact_patches(vertices, Vector3d::Zero(), planes, state, kTolerance);
}

TEST(ContactPatch, AFaceSlides) {
  BodyState state = resting_on_floor(5);
  state.twist_W.head<3>() = Vector3d(0, -3, 0);
  const ContactPatches found = patches(state);
  ASSERT_EQ(found.contacts.size(), 4U);
  EXPECT_EQ(found.fault, "");
  EXPECT_FALSE(found.turns_in_plane);
  for (const Contact& contact : found.contacts) {
    EXPECT_EQ(contact.mode, ContactMode::slide);
    EXPECT_NEAR(contact.p_OC.z(), -5, 1e-12);
    EXPECT_TRUE(contact.n_O.isApprox(Vector3d::UnitZ()));
    EXPECT_TRUE(contact.t_O.isApprox(-Vector3d::UnitY()));
  }
}

TEST(ContactPatch, TumblingTurnsWithTheObject) {
  for (const double angle : {0.0, 0.3, 1.5}) {
    const ContactPatches found = patches(tumbling(angle));
    EXPECT_EQ(found.fault, "") << angle;
    ASSERT_EQ(found.contacts.size(), 2U) << angle;  // at 0 the face's far vertices leave
    for (const Contact& contact : found.contacts) {
      EXPECT_EQ(contact.mode, ContactMode::stick);
      EXPECT_NEAR(contact.p_OC.x(), 2.5, 1e-12);
      EXPECT_TRUE(contact.n_O.isApprox(Vector3d(-std::sin(angle), 0, std::cos(angle)), 1e-9));
      // The centre of mass moves towards +x, seen in O.
      EXPECT_TRUE(contact.t_O.isApprox(Vector3d(std::cos(angle), 0, std::sin(angle)), 1e-9));
    }
  }
}

TEST(ContactPatch, AtRestEveryVertexSticks) {
  BodyState state = tumbling(0);
  state.at_rest = true;
  const ContactPatches found = patches(state);
  ASSERT_EQ(found.contacts.size(), 4U);
  for (const Contact& contact : found.contacts) {
    EXPECT_EQ(contact.mode, ContactMode::stick);
    EXPECT_TRUE(contact.t_O.isApprox(Vector3d::UnitX(), 1e-9));
  }
  state = tumbling(std::acos(0.0));  // lies on its side
  state.at_rest = true;
  EXPECT_EQ(patches(state).contacts.size(), 4U);
  EXPECT_EQ(patches(resting_on_floor(5)).contacts.front().t_O, Vector3d::Zero());
}

TEST(ContactPatch, ATumbleEndsWhenTheFaceTouches) {
  const ContactPatches found = patches(tumbling(std::acos(0.0)));
  EXPECT_NE(found.fault.find("the face on plane 'floor' cannot turn about the axis (0, 1, 0)"),
            std::string::npos)
      << found.fault;
}

TEST(ContactPatch, SpeedAndUnitDoNotMatter) {
  for (const double unit : {1e-3, 1.0, 1e3}) {
    for (const double speed : {1e-6, 1.0, 1e6}) {
      BodyState state = tumbling(0.3);
      state.X_WO.translation() *= unit;
      state.twist_W *= speed;
      state.twist_W.head<3>() *= unit;
      const auto found = contact_patches(unit * box(5, 5, 10), Vector3d::Zero(), {Plane{}}, state,
                                         unit * kTolerance);
      EXPECT_EQ(found.fault, "");
      ASSERT_EQ(found.contacts.size(), 2U);
      EXPECT_EQ(found.contacts[0].mode, ContactMode::stick);
    }
  }
}

TEST(ContactPatch, FrameDoesNotMatter) {
  Isometry3d X_NW = Isometry3d::Identity();  // another world
  X_NW.linear() = Eigen::AngleAxisd(1.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  X_NW.translation() = Vector3d(3, -7, 2);
  Plane plane;
  plane.n_W = X_NW.linear() * Vector3d::UnitZ();
  plane.offset = plane.n_W.dot(X_NW.translation());
  const BodyState here = tumbling(0.4);
  BodyState there = here;
  there.X_WO = X_NW * here.X_WO;
  there.twist_W << X_NW.linear() * here.twist_W.head<3>(), X_NW.linear() * here.twist_W.tail<3>();
  const ContactPatches a = patches(here), b = patches(there, {plane});
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
  for (std::size_t i = 0; i < a.contacts.size(); ++i) {
    EXPECT_EQ(a.contacts[i].mode, b.contacts[i].mode);
    EXPECT_TRUE(a.contacts[i].n_O.isApprox(b.contacts[i].n_O, 1e-9));
    EXPECT_TRUE(a.contacts[i].t_O.isApprox(b.contacts[i].t_O, 1e-9));
  }
}

TEST(ContactPatch, WallsHaveTheirOwnFriction) {
  Plane floor, wall;
  wall.name = "wall";
  wall.n_W = -Vector3d::UnitX();
  wall.offset = -2.5;
  wall.friction = 0.1;
  BodyState state = resting_on_floor(5);
  state.twist_W[1] = 1;
  const ContactPatches found = patches(state, {floor, wall});
  ASSERT_EQ(found.contacts.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(found.contacts[i].friction, found.plane[i] == 0 ? 0.5 : 0.1);
    EXPECT_EQ(found.contacts[i].mode, ContactMode::slide);
  }
  state.twist_W << 1, 0, 0, 0, 0, 0;
  EXPECT_NE(patches(state, {floor, wall}).fault.find("into plane 'wall'"), std::string::npos);
  state.twist_W[0] = -1;  // off the wall: only the floor counts
  EXPECT_EQ(patches(state, {floor, wall}).contacts.size(), 4U);
}

TEST(ContactPatch, AFaceMayTurnInItsPlane) {
  BodyState state = resting_on_floor(5);
  state.twist_W[5] = 1;
  const ContactPatches found = patches(state);
  EXPECT_EQ(found.fault, "");
  EXPECT_TRUE(found.turns_in_plane);
  ASSERT_EQ(found.contacts.size(), 4U);
  for (const Contact& contact : found.contacts) {
    EXPECT_EQ(contact.mode, ContactMode::slide);
    EXPECT_NEAR(contact.t_O.dot(contact.p_OC), 0, 1e-9);  // around the middle
  }
  state.at_rest = true;
  EXPECT_FALSE(patches(state).turns_in_plane);
}

TEST(ContactPatch, AnEdgeMayNotTurnOnThePlane) {
  BodyState state = tumbling(0.4);
  state.twist_W << state.twist_W.head<3>() + Vector3d(0, 0.7, 0), 0, 1, 0;
  EXPECT_EQ(patches(state).fault, "");  // it slides along itself while it turns about itself
  state.twist_W << Vector3d::UnitZ().cross(state.X_WO.translation() - Vector3d(2.5, 0, 0)), 0, 0, 1;
  const std::string fault = patches(state).fault;
  EXPECT_NE(fault.find("the edge along (0, 1, 0) on plane 'floor' cannot turn"), std::string::npos)
      << fault;
}

TEST(ContactPatch, AVertexTurnsAnyhow) {
  BodyState state;
  state.X_WO.linear() =
      Eigen::Quaterniond::FromTwoVectors(Vector3d(1, 1, 1), Vector3d::UnitZ()).toRotationMatrix();
  state.X_WO.translation().z() = std::sqrt(3.0);
  state.twist_W.tail<3>() = Vector3d(0.3, -0.2, 1);
  state.twist_W.head<3>() =
      state.twist_W.tail<3>().cross(state.X_WO.translation());  // about the vertex at 0
  const ContactPatches found = patches(state, {Plane{}}, box(2, 2, 2));
  EXPECT_EQ(found.fault, "");
  ASSERT_EQ(found.contacts.size(), 1U);
  EXPECT_EQ(found.contacts[0].mode, ContactMode::stick);
}

TEST(ContactPatch, Penetration) {
  const std::string fault = patches(resting_on_floor(4.9)).fault;
  EXPECT_NE(fault.find("inside plane 'floor'"), std::string::npos) << fault;
  EXPECT_TRUE(patches(resting_on_floor(5.1)).contacts.empty());  // it floats
  EXPECT_EQ(patches(resting_on_floor(5 - 1e-7)).contacts.size(), 4U);
}

TEST(ContactPatch, BadInputIsNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [](const Plane& plane) { patches(resting_on_floor(5), {Plane{}, plane}); };
  Plane plane;
  plane.n_W *= 2;
  expect_refused([&] { with(plane); }, "planes[1].n_W");
  plane = {};
  for (const double bad : {nan, 2e4, -1e300}) {
    plane.offset = bad;
    expect_refused([&] { with(plane); }, "planes[1].offset must lie in [-10000, 10000] m, not ");
  }
  plane = {};
  for (const double bad : {nan, -0.1, 2e4}) {
    plane.friction = bad;
    expect_refused([&] { with(plane); }, "planes[1].friction must lie in [0, 10000], not ");
  }
  BodyState state;
  state.twist_W[2] = nan;
  expect_refused([&] { patches(state); }, "state.twist_W");
  state = {};
  state.X_WO.linear() *= 2;
  expect_refused([&] { patches(state); }, "state.X_WO");
  expect_refused([&] { patches({}, {Plane{}}, Matrix3Xd(3, 0)); }, "vertices_O");
  expect_refused([&] { patches({}, {Plane{}}, nan * box(1, 1, 1)); }, "vertices_O");
  expect_refused([&] { patches({}, {Plane{}}, 1e300 * box(1, 1, 1)); },
                 "vertices_O must be within");
  state = {};
  state.X_WO.translation().x() = 1e300;
  expect_refused([&] { patches(state); }, "state.X_WO");
  expect_refused([&] { contact_patches(box(1, 1, 1), Vector3d::Zero(), {}, BodyState{}, -1); },
                 "tolerance");
}

}  // namespace
}  // namespace graspless::mechanics
