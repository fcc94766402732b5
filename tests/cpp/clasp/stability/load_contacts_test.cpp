// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/load_contacts.hpp"

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using mechanics::Vector6d;

/// A capsule, a box and a sphere, each on a link of its own, that two joints move, and points
/// around them.
class PosedContactsTest : public ::testing::Test {
 protected:
  PosedContactsTest() {
    const geometry::Capsule capsule{0.01, 0.05};
    const geometry::Box box{Vector3d(0.03, 0.02, 0.04)};
    const geometry::Sphere sphere{0.015};
    bodies_ = {body_of({0, {capsule, random_pose()}}), body_of({1, {box, random_pose()}}),
               body_of({2, {sphere, random_pose()}})};
    hand_.center_W = random(0.02);
    for (int link = 0; link < 3; ++link) {
      const Eigen::Isometry3d X_WL = random_pose();
      hand_.X_WL.push_back(X_WL);
      hand_.X_LW.push_back(X_WL.inverse());
      hand_.twists.emplace_back(
          mechanics::Matrix6Xd::NullaryExpr(6, 2, [&] { return 1000 * side_(rng_); }));
    }
  }

  Vector3d random(double most) {
    return Vector3d::NullaryExpr([&] { return most * side_(rng_); });
  }

  Eigen::Isometry3d random_pose() {
    Eigen::Isometry3d X(Eigen::Translation3d(random(0.03)));
    return X.rotate(Eigen::AngleAxisd(3 * side_(rng_), random(1).normalized()));
  }

  double distance(const Vector3d& p_W, std::size_t body) const {
    return bodies_[body].distance(hand_.X_LW[body] * p_W, kReach);
  }

  NearPoints points(Eigen::Index count) {
    Eigen::Matrix3Xd p_W(3, 3 * count);
    Eigen::ArrayXd distances(3 * count);
    for (Eigen::Index i = 0; i < 3 * count; ++i) {
      const auto body = static_cast<std::size_t>(i / count);
      do p_W.col(i) = hand_.X_WL[body] * (bodies_[body].center_L + random(0.06));
      while (distance(p_W.col(i), body) < 0 || distance(p_W.col(i), body) > kReach);
      distances[i] = distance(p_W.col(i), body);
    }
    return {p_W, {{0, 0, count}, {1, count, count}, {2, 2 * count, count}}, distances};
  }

  std::mt19937_64 rng_{5};
  std::uniform_real_distribution<double> side_{-1, 1};
  std::vector<Body> bodies_;
  Posture hand_;
};

TEST_F(PosedContactsTest, FindsEveryContactThatAMovePasses) {
  int passed = 0, left_out = 0;
  for (int sample = 0; sample < 50; ++sample) {
    const NearPoints untouched = points(200);
    NearPoints near = untouched;  // where earlier poses leave what they measure
    for (int pose = 0; pose < 4; ++pose) {
      Eigen::Isometry3d moved(Eigen::Translation3d(random(0.003 * pose)));
      moved.rotate(Eigen::AngleAxisd(0.05 * pose * side_(rng_), random(1).normalized()));
      NearPoints fresh = untouched;
      PosedContacts all(fresh, moved, bodies_, hand_), lazy(near, moved, bodies_, hand_);
      for (int step = 0; step < 3; ++step) {
        const double most = 0.5 * (1 + step);
        const Vector6d move = Vector6d::NullaryExpr([&] { return most * side_(rng_); });
        const VectorXd yield = VectorXd::NullaryExpr(2, [&] { return 1e-3 + 1e-3 * side_(rng_); });
        std::set<Eigen::Index> found;
        for (const LoadContact* contact : lazy.near(move, yield)) found.insert(contact->point);
        for (Eigen::Index i = 0; i < near.p_W.cols(); ++i) {
          const LoadContact* contact = all.at(i);
          const bool is_passed =
              contact != nullptr &&
              contact->row.dot(move) - contact->gap - contact->opens.dot(yield) > 1e-6;
          EXPECT_TRUE(!is_passed || found.count(i) > 0);
          passed += is_passed;
          left_out += found.count(i) == 0;
        }
      }
    }
  }
  EXPECT_GT(passed, 1000);
  EXPECT_GT(left_out, 10000);
}

TEST_F(PosedContactsTest, MeasuresTheGapOfAPointThatMoved) {
  NearPoints near = points(100);
  for (int pose = 0; pose < 20; ++pose) {
    const Eigen::Isometry3d moved(Eigen::Translation3d(random(0.01)));
    PosedContacts contacts(near, moved, bodies_, hand_);
    for (Eigen::Index i = 0; i < near.p_W.cols(); i += 1 + pose % 5) {
      const LoadContact* contact = contacts.at(i);
      if (contact == nullptr) continue;
      const Vector3d p_W = moved * near.p_W.col(i);
      const auto body = static_cast<std::size_t>(i / 100);
      const double rounded = 1000 * distance(p_W, body) - 0.5;
      EXPECT_NEAR(contact->gap, std::max(0.0, rounded), 1e-9);
      // The gap shrinks by the motion along the normal.
      const Vector3d step = 1e-6 * random(1);
      const double closer = distance(p_W, body) - distance(p_W + step, body);
      EXPECT_NEAR(contact->row.head<3>().dot(step), closer, 1e-9);
    }
  }
}

}  // namespace
}  // namespace graspless::clasp
