// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/goal/contact_states.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace graspless::fingertip {
namespace {

Object prism() {
  geometry::Mesh mesh;
  mesh.vertices.resize(3, 6);
  mesh.vertices << 0, 0.04, 0, 0, 0.04, 0,  //
      0, 0, 0.03, 0, 0, 0.03,               //
      0, 0, 0, 0.05, 0.05, 0.05;
  mesh.triangles.resize(3, 8);
  mesh.triangles << 0, 3, 0, 0, 1, 1, 2, 2,  //
      2, 4, 1, 4, 2, 5, 0, 3,                //
      1, 5, 4, 3, 5, 4, 3, 5;
  return Object::from_mesh("prism", mesh, 0.1);
}

Eigen::Isometry3d random_pose(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Eigen::Isometry3d X(
      Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
          .normalized());
  X.translation() << normal(random), normal(random), normal(random);
  return X;
}

/// A pose on this face, anywhere on the floor.
Eigen::Isometry3d standing_on(const ContactState& state, double yaw) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = (Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
                Eigen::Quaterniond::FromTwoVectors(state.n_O, Eigen::Vector3d::UnitZ()))
                   .toRotationMatrix();
  X.translation() << 0.3, -0.2, -state.offset;
  return X;
}

TEST(ContactStates, BoxHasSixFacesOfFourEdges) {
  const ContactStates states(Object::box("block", {0.05, 0.06, 0.1}, 1));
  ASSERT_EQ(states.size(), 6);
  for (int i = 0; i < 6; ++i) {
    EXPECT_TRUE(states[i].is_stable);
    ASSERT_EQ(states[i].edges.size(), 4U);
    for (const TumbleEdge& edge : states[i].edges)
      EXPECT_NEAR(edge.angle, std::acos(-1.0) / 2, 1e-12);
  }
}

TEST(ContactStates, TumbleBringsTheNextFaceDownAndLeavesTheEdge) {
  for (const Object& object : {Object::box("block", {0.05, 0.06, 0.1}, 1), prism()}) {
    const ContactStates states(object);
    for (int i = 0; i < states.size(); ++i) {
      const Eigen::Isometry3d X_WO = standing_on(states[i], 0.7);
      ASSERT_EQ(states.standing(X_WO, Plane{}, 1e-9), i);
      for (const TumbleEdge& edge : states[i].edges) {
        const Eigen::Isometry3d X_WO_next = tumbled(X_WO, edge);
        EXPECT_EQ(states.standing(X_WO_next, Plane{}, 1e-9), edge.to);
        for (const double s : {-1.0, 2.0}) {
          const Eigen::Vector3d p_O = edge.p_O + s * edge.axis_O;
          EXPECT_LT((X_WO * p_O - X_WO_next * p_O).norm(), 1e-12);
        }
      }
    }
  }
}

TEST(ContactStates, TumblingBackUndoesATumble) {
  const Object object = prism();
  const ContactStates states(object);
  std::mt19937 random(1);
  const Eigen::Isometry3d X_WO = random_pose(random);
  for (int i = 0; i < states.size(); ++i) {
    for (const TumbleEdge& edge : states[i].edges) {
      int back = 0;
      for (const TumbleEdge& reverse : states[edge.to].edges) {
        if (reverse.to != i) continue;
        ++back;
        EXPECT_TRUE(tumbled(tumbled(X_WO, edge), reverse).isApprox(X_WO, 1e-12));
      }
      EXPECT_EQ(back, 1);
    }
  }
}

TEST(ContactStates, NothingStandsInTheAirOrOnAnEdge) {
  const ContactStates states(Object::box("block", {0.05, 0.06, 0.1}, 1));
  Eigen::Isometry3d X_WO = standing_on(states[0], 0);
  X_WO.translation().z() += 0.001;
  EXPECT_EQ(states.standing(X_WO, Plane{}, 1e-6), -1);
  X_WO = standing_on(states[0], 0);
  X_WO.rotate(Eigen::AngleAxisd(0.1, Eigen::Vector3d(1, 2, 3).normalized()));
  EXPECT_EQ(states.standing(X_WO, Plane{}, 1e-6), -1);
}

TEST(ContactStates, TippingFacesAreNotStable) {
  const Object object = Object::box("block", {0.05, 0.06, 0.1}, 1);
  const ContactStates all(object);
  // With the centre of mass on an edge of the top face nothing but the sides there and the bottom
  // and top hold it, and those not for sure.
  const ContactStates leaning(object.with_com({0.0, 0.0, 0.05}));
  int stable = 0;
  for (int i = 0; i < leaning.size(); ++i) {
    const bool is_end = std::abs(leaning[i].n_O.z()) > 0.5;
    EXPECT_EQ(leaning[i].is_stable, is_end);
    stable += leaning[i].is_stable ? 1 : 0;
  }
  EXPECT_EQ(stable, 2);
}

TEST(ContactStates, SequencesOfABox) {
  const ContactStates states(Object::box("block", {0.05, 0.06, 0.1}, 1));
  int opposite = -1;
  for (int i = 1; i < 6; ++i) {
    if (states[i].n_O.dot(states[0].n_O) < -0.5) opposite = i;
  }
  const int beside = states[0].edges.front().to;
  EXPECT_EQ(states.tumbles_to(0)[opposite], 2);
  EXPECT_EQ(tumble_sequences(states, 0, opposite, 1, 100).size(), 0U);
  EXPECT_EQ(tumble_sequences(states, 0, opposite, 2, 100).size(), 4U);
  EXPECT_EQ(tumble_sequences(states, 0, beside, 1, 100).size(), 1U);
  // Over either neighbour that both share.
  EXPECT_EQ(tumble_sequences(states, 0, beside, 2, 100).size(), 2U);
  EXPECT_EQ(tumble_sequences(states, 0, 0, 0, 100).size(), 1U);
  EXPECT_EQ(tumble_sequences(states, 0, 0, 1, 100).size(), 0U);
  EXPECT_EQ(tumble_sequences(states, 0, opposite, 2, 3).size(), 3U);
}

TEST(ContactStates, SequencesChainAndNeverGoStraightBack) {
  const ContactStates states(prism());
  for (int tumbles = 0; tumbles <= 4; ++tumbles) {
    for (const TumbleSequence& sequence : tumble_sequences(states, 0, 2, tumbles, 1000)) {
      ASSERT_EQ(static_cast<int>(sequence.size()), tumbles);
      std::vector<int> faces{0};
      for (const TumbleEdge* edge : sequence) {
        bool leads = false;
        for (const TumbleEdge& own : states[faces.back()].edges) leads = leads || &own == edge;
        EXPECT_TRUE(leads);
        faces.push_back(edge->to);
        if (faces.size() > 2) {
          EXPECT_NE(faces[faces.size() - 3], faces.back());
        }
      }
      EXPECT_EQ(faces.back(), 2);
    }
  }
}

}  // namespace
}  // namespace graspless::fingertip
