// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/free_space/free_space.hpp"

#include <gtest/gtest.h>

#include "clasp/free_space/link_spheres.hpp"
#include "clasp/free_space/object_collision.hpp"
#include "clasp/spaces.hpp"
#include "robot/robots.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// All by FCL, one configuration at a time.
class Judge {
 public:
  explicit Judge(const Problem& problem) : scene_(problem.robot) {
    for (const Obstacle& obstacle : problem.obstacles) {
      scene_.add_obstacle(obstacle.name, obstacle.shapes, obstacle.X_WB);
    }
    scene_.move_object(scene_.add_object(problem.object.name(), problem.object.solid()),
                       problem.X_WO);
  }
  bool is_free(const VectorXd& q) { return scene_.is_free(q); }
  bool is_free(const VectorXd& q1, const VectorXd& q2, double resolution) {
    const int steps =
        std::max(1, static_cast<int>(std::ceil((q2 - q1).cwiseAbs().maxCoeff() / resolution)));
    for (int i = 0; i <= steps; ++i) {
      if (!is_free(q1 + i * ((q2 - q1) / steps))) return false;
    }
    return true;
  }

 private:
  scene::Scene scene_;
};

/// A problem whose purse stands so that its handle or top is near the palm at q.
Problem near_palm(const std::string& hand, std::mt19937_64& rng, VectorXd& q) {
  Problem problem = problem_of(hand, purse(), Isometry3d::Identity());
  std::uniform_real_distribution<double> unit(-1, 1);
  scene::Scene alone(problem.robot);
  do {
    q = robot::random_q(problem.robot, rng);
  } while (!alone.is_free(q));
  const Isometry3d X_WH = problem.robot.pose(problem.robot.frame("palm"), q);
  const Eigen::Matrix3Xd& points = purse().points();
  Eigen::Index nearest = 0;
  const Vector3d side(unit(rng), unit(rng), 2 + unit(rng));
  (side.transpose() * points).maxCoeff(&nearest);
  const Vector3d at(0.08 * unit(rng), 0.08 * unit(rng), 0.1 + 0.06 * unit(rng));
  const Eigen::Quaterniond turn(unit(rng), unit(rng), unit(rng), unit(rng));
  problem.X_WO = Translation3d(X_WH * at) * turn.normalized() * Translation3d(-points.col(nearest));
  return problem;
}

VectorXd moved(const VectorXd& q, double reach, std::mt19937_64& rng) {
  std::uniform_real_distribution<double> unit(-1, 1);
  return q + VectorXd::NullaryExpr(q.size(), [&] { return reach * unit(rng); });
}

class FreeSpaceOf : public testing::TestWithParam<std::string> {};

TEST_P(FreeSpaceOf, ConfigurationsAreWhatFclSays) {
  std::mt19937_64 rng(1);
  int free = 0, looked = 0;
  for (int i = 0; i < 12; ++i) {
    VectorXd q0;
    const Problem problem = near_palm(GetParam(), rng, q0);
    FreeSpace space(problem);
    Judge judge(problem);
    for (int j = 0; j < 150; ++j) {
      const VectorXd q = problem.robot.clamp(moved(q0, 0.1 * (j % 4), rng));
      const bool is_free = space.is_free(q);
      ASSERT_EQ(is_free, judge.is_free(q)) << "problem " << i << ", configuration " << j;
      ASSERT_EQ(is_free, space.collision(q).first.empty());
      free += is_free;
      ++looked;
    }
  }
  EXPECT_GT(free, looked / 10);
  EXPECT_LT(free, looked * 9 / 10);
}

TEST_P(FreeSpaceOf, MotionsAreWhatFclSaysStepByStep) {
  std::mt19937_64 rng(2);
  int free = 0, looked = 0;
  for (int i = 0; i < 12; ++i) {
    VectorXd q0;
    const Problem problem = near_palm(GetParam(), rng, q0);
    FreeSpace space(problem);
    Judge judge(problem);
    for (int j = 0; j < 40; ++j) {
      const VectorXd q1 = problem.robot.clamp(moved(q0, 0.1, rng));
      const VectorXd q2 = problem.robot.clamp(moved(q1, j % 2 == 0 ? 0.12 : 0.4, rng));
      if (!judge.is_free(q1)) continue;
      const bool is_free = space.is_free(q1, q2, 0.01);
      ASSERT_EQ(is_free, judge.is_free(q1, q2, 0.01)) << "problem " << i << ", motion " << j;
      free += is_free;
      ++looked;
    }
  }
  EXPECT_GT(looked, 40);
  EXPECT_GT(free, looked / 10);
  EXPECT_LT(free, looked * 9 / 10);
}

/// Links that spheres prove apart do not touch for FCL, and most that do not touch are proven.
TEST_P(FreeSpaceOf, LinksThatAreApartDoNotTouch) {
  std::mt19937_64 rng(4);
  int apart = 0, touching = 0, looked = 0;
  for (int i = 0; i < 12; ++i) {
    VectorXd q0;
    const Problem problem = near_palm(GetParam(), rng, q0);
    const std::vector<SphereTree> trees = link_spheres(problem.robot);
    const auto clearance = problem.object.borrow_outer_clearance();
    ObjectCollision collision(problem);
    for (int j = 0; j < 100; ++j) {
      robot::Poses X_WL;
      problem.robot.forward(problem.robot.clamp(moved(q0, 0.1 * (j % 4), rng)), X_WL);
      for (const int link : collision.links()) {
        const auto index = static_cast<std::size_t>(link);
        const Isometry3d X_OL = problem.X_WO.inverse() * X_WL[index];
        const bool touches = collision.touches_by_fcl(link, X_WL[index]);
        const double bound = distance_by_spheres(trees[index], X_OL, 0.01, *clearance);
        const bool is_proven = bound > 0;
        EXPECT_FALSE(touches && is_proven) << "problem " << i << ", link " << link;
        for (int k = 0; k < 6 && is_proven; ++k) {  // no motion by less than the bound leads there
          const Vector3d shift = (k % 2 == 0 ? bound : -bound) * Vector3d::Unit(k / 2);
          EXPECT_FALSE(collision.touches_by_fcl(link, Translation3d(shift) * X_WL[index]))
              << "problem " << i << ", link " << link;
        }
        apart += is_proven;
        touching += touches;
        ++looked;
      }
    }
  }
  EXPECT_GT(touching, looked / 50);
  EXPECT_GT(apart, (looked - touching) * 9 / 10);
}

TEST(FreeSpace, SpheresSettleMostOfIt) {
  const Problem problem = problem_of("kr5_sdh", purse(), Isometry3d(Translation3d(0.7, 0, 0)));
  std::mt19937_64 rng(3);
  FreeSpace space(problem);
  for (int i = 0; i < 1000; ++i) space.is_free(moved(problem.q_start, 0.5, rng));
  EXPECT_GT(space.num_checks(), 300);
  EXPECT_LT(space.num_fcl_checks(), space.num_checks() / 10);
}

TEST(FreeSpace, NamesWhatTouches) {
  Problem problem = ring_within("kr5_sdh");
  EXPECT_EQ(FreeSpace(problem).collision(problem.q_start).first, "");
  Problem inside = problem;
  inside.X_WO.translation() =
      problem.robot.pose(problem.robot.frame("palm"), problem.q_start) * Vector3d(0, 0, 0.04) -
      problem.X_WO.linear() * Vector3d(0, 0.1, 0);
  EXPECT_EQ(FreeSpace(inside).collision(inside.q_start),
            std::make_pair(std::string("palm"), std::string("ring")));
  EXPECT_FALSE(FreeSpace(inside).is_free(inside.q_start));
  const geometry::PlacedShape block{geometry::Sphere{0.03}};
  problem.obstacles.push_back(
      {"lamp", {block}, problem.robot.pose(problem.robot.frame("palm"), problem.q_start)});
  EXPECT_EQ(FreeSpace(problem).collision(problem.q_start).second, "lamp");
  EXPECT_FALSE(FreeSpace(problem).is_free(problem.q_start));
}

TEST_P(FreeSpaceOf, NamesTheLinkThatFclNames) {
  std::mt19937_64 rng(5);
  int named = 0, asked = 0;
  for (int i = 0; i < 8; ++i) {
    VectorXd q0;
    const Problem problem = near_palm(GetParam(), rng, q0);
    FreeSpace space(problem);
    ObjectCollision judge(problem);
    scene::Scene alone(problem.robot);
    for (int j = 0; j < 100; ++j) {
      const VectorXd q = problem.robot.clamp(moved(q0, 0.1, rng));
      if (!alone.is_free(q)) continue;
      robot::Poses X_WL;
      problem.robot.forward(q, X_WL);
      std::string first;
      for (const int link : judge.links()) {
        const auto index = static_cast<std::size_t>(link);
        if (first.empty() && judge.touches_by_fcl(link, X_WL[index]))
          first = problem.robot.frame_names()[index];
      }
      ASSERT_EQ(space.collision(q).first, first) << "problem " << i << ", configuration " << j;
      named += !first.empty();
      asked += static_cast<int>(judge.links().size());
    }
    EXPECT_LT(space.num_fcl_checks(), judge.num_fcl_checks() / 4);
  }
  EXPECT_GT(named, 50);
  EXPECT_LT(named, asked / 8);
}

TEST(FreeSpace, OutOfLimitsIsNotFree) {
  const Problem problem = ring_within("kr5_sdh");
  FreeSpace space(problem);
  VectorXd q = problem.q_start;
  q[0] = problem.robot.upper()[0] + 0.01;
  EXPECT_FALSE(space.is_free(q));
  EXPECT_FALSE(space.is_free(problem.q_start, q, 0.01));
  expect_refused([&] { space.is_free(problem.q_start, problem.q_start, 0); },
                 "resolution must be positive");
}

INSTANTIATE_TEST_SUITE_P(Hands, FreeSpaceOf, testing::Values("kr5_sdh", "kr5_icub"));

}  // namespace
}  // namespace graspless::clasp
