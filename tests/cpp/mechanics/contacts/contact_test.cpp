// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/mechanics/contact.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "complaint.hpp"

namespace graspless::mechanics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d random_unit(std::mt19937& rng) {
  std::normal_distribution<double> normal;
  return Vector3d(normal(rng), normal(rng), normal(rng)).normalized();
}

TEST(Contact, TangentIsAUnitAlongTheSurface) {
  std::mt19937 rng(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3d n = random_unit(rng), t = 7 * random_unit(rng);
    const Vector3d along = tangent(n, t);
    EXPECT_NEAR(along.norm(), 1, 1e-14);
    EXPECT_NEAR(along.dot(n), 0, 1e-14);
    EXPECT_GT(along.dot(t), 0);
    EXPECT_NEAR(n.cross(t).cross(n).normalized().dot(along), 1, 1e-12);
  }
}

TEST(Contact, TangentFallsBackOnTheGridAxis) {
  EXPECT_EQ(tangent(Vector3d::UnitX(), Vector3d::Zero()), Vector3d::UnitY());
  EXPECT_EQ(tangent(-Vector3d::UnitY(), Vector3d::Zero()), Vector3d::UnitZ());
  EXPECT_EQ(tangent(Vector3d::UnitZ(), Vector3d::Zero()), Vector3d::UnitX());
  EXPECT_EQ(tangent(Vector3d::UnitZ(), Vector3d(0, 0, 3)), Vector3d::UnitX());
}

TEST(Contact, ConeIsInscribedAndTurnsCounterClockwise) {
  std::mt19937 rng(2);
  for (int edges : {3, 6, 24}) {
    const Vector3d n = random_unit(rng);
    const Vector3d t = tangent(n, random_unit(rng));
    const double mu = 0.7;
    const Eigen::Matrix3Xd cone = friction_cone(n, mu, edges, t);
    ASSERT_EQ(cone.cols(), edges);
    for (int j = 0; j < edges; ++j) {
      const Vector3d c = cone.col(j), next = cone.col((j + 1) % edges);
      EXPECT_NEAR(c.norm(), 1, 1e-14);
      EXPECT_NEAR(n.dot(c), 1 / std::sqrt(1 + mu * mu), 1e-14);
      EXPECT_GT(n.dot(c.cross(next)), 0);
      EXPECT_NEAR(c.dot(next), cone.col(0).dot(cone.col(1)), 1e-14);
    }
    EXPECT_NEAR(cone.col(0).dot(t), mu / std::sqrt(1 + mu * mu), 1e-14);
  }
}

TEST(Contact, GravityPassesThroughTheCentreOfMass) {
  const Vector6d wrench = gravity_wrench(2, Vector3d(0, 1, -9.8));
  EXPECT_EQ(wrench, (Vector6d() << 0, 2, -19.6, 0, 0, 0).finished());
  expect_refused([] { gravity_wrench(0, Vector3d::UnitZ()); },
                 "mass must lie in [1e-09, 100000] kg, not 0");
  expect_refused([] { gravity_wrench(1, 1e4 * Vector3d::UnitZ()); },
                 "gravity_O must lie within +-1000 m/s^2, not 10000");
}

ContactSet good() {
  ContactSet set;
  set.contacts.resize(2);
  set.fingers.resize(2);
  set.contacts[1].mode = ContactMode::slide;
  set.contacts[1].t_O = Vector3d(1, 0, 5);
  return set;
}

TEST(Contact, ValidateAcceptsAGoodSet) { EXPECT_NO_THROW(validate(good())); }

TEST(Contact, ValidateNamesTheField) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const auto& spoil, const std::string& words) {
    ContactSet set = good();
    spoil(set);
    expect_refused([&] { validate(set, "sample 3"); }, "sample 3: " + words);
  };
  refused([&](ContactSet& s) { s.contacts[1].p_OC.y() = nan; }, "contacts[1].p_OC must be finite");
  refused([](ContactSet& s) { s.contacts[0].friction = -0.1; },
          "contacts[0].friction must lie in [0, 10000], not -0.1");
  refused([](ContactSet& s) { s.contacts[0].n_O *= 1.1; },
          "contacts[0].n_O must be a unit vector, not 1.1");
  refused([](ContactSet& s) { s.contacts[1].t_O = Vector3d(0, 0, 5); }, "contacts[1].t_O must");
  refused([](ContactSet& s) { s.contacts[1].t_O.setZero(); }, "contacts[1].t_O must");
  refused([](ContactSet& s) { s.fingers[1].max_normal_force = -1; },
          "fingers[1].max_normal_force must lie in [1e-06, 1e+06] N, not -1");
  refused([](ContactSet& s) { s.fingers[0].max_normal_force = 1e12; },
          "fingers[0].max_normal_force must lie in [1e-06, 1e+06] N, not 1e+12");
  refused([](ContactSet& s) { s.fingers[1].friction = 1e300; }, "fingers[1].friction must lie in");
  refused([](ContactSet& s) { s.contacts[1].p_OC.z() = -2e4; },
          "contacts[1].p_OC must lie within +-10000 m, not 20000");
  refused([](ContactSet& s) { s.com_O.z() = 1e300; }, "com_O must lie within +-10000 m");
  refused([](ContactSet& s) { s.known_wrench_O[2] = -1e300; },
          "force of known_wrench_O must lie within +-1e+06 N, not 1e+300");
  refused([](ContactSet& s) { s.known_wrench_O[4] = 1e300; },
          "moment of known_wrench_O must lie within +-1e+10 N m, not 1e+300");
  refused([](ContactSet& s) { s.wrench_scale(0, 4) = 1e300; }, "wrench_scale must lie within");
  refused([&](ContactSet& s) { s.fingers[0].friction = nan; }, "fingers[0].friction must lie in");
  refused([](ContactSet& s) { s.fingers.resize(5); }, "fingers must be at most 4, not 5");
  refused([&](ContactSet& s) { s.known_wrench_O[3] = nan; },
          "moment of known_wrench_O must be finite");
  refused([&](ContactSet& s) { s.com_O[0] = nan; }, "com_O must be finite");
  refused([](ContactSet& s) { s.wrench_scale(2, 2) = 0; }, "wrench_scale must be regular");
  refused([](ContactSet& s) { s.cone_edges = 1001; }, "cone_edges must lie in [3, 1000], not 1001");
  refused([](ContactSet& s) { s.cone_edges = 2; }, "cone_edges must lie in [3, 1000], not 2");
}

}  // namespace
}  // namespace graspless::mechanics
