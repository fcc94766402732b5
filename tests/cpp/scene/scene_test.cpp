// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "robot/robots.hpp"
#include "scene/names.hpp"

namespace graspless::scene {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;
using robot::Robot;

Isometry3d translation(double x, double y, double z) {
  return Isometry3d(Eigen::Translation3d(x, y, z));
}

/// Two links of 1 m that swing about z, a gripper that opens along y at the end, its second jaw a
/// mimic.
const char* const kPlanarArm = R"(
<robot name="planar">
  <link name="base"><collision><geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="upper"><collision><origin xyz="0.5 0 0"/>
    <geometry><box size="0.6 0.08 0.08"/></geometry></collision></link>
  <link name="lower"><collision><origin xyz="0.5 0 0"/>
    <geometry><box size="0.6 0.08 0.08"/></geometry></collision></link>
  <link name="left"><collision><origin xyz="0.05 0 0"/>
    <geometry><box size="0.1 0.02 0.06"/></geometry></collision></link>
  <link name="right"><collision><origin xyz="0.05 0 0"/>
    <geometry><box size="0.1 0.02 0.06"/></geometry></collision></link>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <joint name="elbow" type="revolute"><origin xyz="1 0 0"/><parent link="upper"/><child link="lower"/>
    <axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="1" effort="1"/></joint>
  <joint name="open" type="prismatic"><origin xyz="1 0.02 0"/><parent link="lower"/><child link="left"/>
    <axis xyz="0 1 0"/><limit lower="-0.02" upper="0.1" velocity="1" effort="1"/></joint>
  <joint name="follow" type="prismatic"><origin xyz="1 -0.02 0"/><parent link="lower"/><child link="right"/>
    <axis xyz="0 -1 0"/><limit lower="-0.02" upper="0.1" velocity="1" effort="1"/><mimic joint="open"/></joint>
</robot>)";

Robot planar_arm() { return Robot::from_urdf(kPlanarArm, {}); }

VectorXd vector(std::initializer_list<double> values) {
  VectorXd q(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), q.begin());
  return q;
}

VectorXd random_q(const Robot& robot, std::mt19937& rng) {
  VectorXd q(robot.dof());
  for (int i = 0; i < robot.dof(); ++i) {
    q[i] = std::uniform_real_distribution<double>(robot.lower()[i], robot.upper()[i])(rng);
  }
  return q;
}

using Names = std::pair<std::string, std::string>;

TEST(Scene, TestsLinksButForIgnoredPairs) {
  const Robot robot = planar_arm();
  Scene scene(robot);
  EXPECT_TRUE(scene.is_free(vector({0.3, 0.4, 0.05})));
  EXPECT_EQ(scene.collision(vector({0, 2.99, 0.09})), Names("base", "left"));
  EXPECT_EQ(scene.collision(vector({0, 0, -0.015})), Names("left", "right"));
  EXPECT_EQ(scene.collision(vector({0, 0, 0.05})), Names());
  for (const auto& [a, b] : scene.world().pairs()) {
    const Names names(scene.world().name(a), scene.world().name(b));
    EXPECT_NE(names, Names("base", "upper"));
    EXPECT_NE(names, Names("upper", "lower"));
  }
}

TEST(Scene, IsNotFreeOutsideTheLimits) {
  const Robot robot = planar_arm();
  Scene scene(robot);
  EXPECT_FALSE(scene.is_free(vector({3.01, 0, 0.05})));
  EXPECT_FALSE(scene.is_free(vector({0, std::nan(""), 0.05})));
  EXPECT_FALSE(scene.is_free(vector({0, 0, 0.05}), vector({3.01, 0, 0.05})));
  EXPECT_FALSE(scene.is_free(vector({3.01, 0, 0.05}), vector({0, 0, 0.05})));
  robot::Poses X_WL;
  robot.forward(vector({3.01, 0, 0.05}), X_WL);
  EXPECT_TRUE(scene.is_free(X_WL));
}

TEST(Scene, ObstaclesStopLinksButNotTheBase) {
  const Robot robot = planar_arm();
  const VectorXd q = vector({0, 0, 0.05});
  const geometry::Box floor{{4, 4, 0.1}};
  Scene scene(robot);
  scene.add_obstacle("floor", {{floor}}, translation(0, 0, -0.1));
  EXPECT_TRUE(scene.is_free(q));
  Scene strict(robot);
  strict.add_obstacle("floor", {{floor}}, translation(0, 0, -0.1), false);
  EXPECT_EQ(strict.collision(q), Names("base", "floor"));
  scene.add_obstacle("post", {{geometry::Sphere{0.05}}}, translation(1.5, 0, 0));
  EXPECT_EQ(scene.collision(q), Names("lower", "post"));
}

TEST(Scene, ObjectsMoveAndRide) {
  const Robot robot = planar_arm();
  const VectorXd q = vector({0, 0, 0.05}), turned = vector({1, 0, 0.05});
  Scene scene(robot);
  const int object = scene.add_object("ball", {{geometry::Sphere{0.05}}});
  scene.move_object(object, translation(1.5, 0, 0));
  EXPECT_FALSE(scene.is_free(q));
  scene.move_object(object, translation(2.05, 0, 0));
  EXPECT_TRUE(scene.is_free(q));

  const int left = robot.frame("left"), right = robot.frame("right");
  scene.attach(object, robot.frame("lower"), translation(1.05, 0, 0), {left, right});
  EXPECT_TRUE(scene.world().pose(object).isApprox(translation(2.05, 0, 0), 1e-9));
  EXPECT_TRUE(scene.is_free(vector({0, 0, 0.04})));  // squeezed, but the jaws may touch
  EXPECT_TRUE(scene.is_free(turned));
  const Vector3d p(std::cos(1) * 2.05, std::sin(1) * 2.05, 0);
  EXPECT_TRUE(scene.world().pose(object).translation().isApprox(p, 1e-9));

  const int post =
      scene.add_obstacle("post", {{geometry::Sphere{0.05}}}, Isometry3d(Eigen::Translation3d(p)));
  scene.world().add_pair(object, post);
  EXPECT_EQ(scene.collision(turned), Names("ball", "post"));
  scene.world().remove_pair(object, post);
  scene.detach(object);
  EXPECT_TRUE(scene.is_free(q));
  EXPECT_TRUE(scene.world().pose(object).translation().isApprox(p, 1e-9));
  scene.move_object(object, translation(2.05, 0, 0));
  EXPECT_NE(scene.collision(vector({0, 0, 0.01})), Names());  // the jaws may not touch any more
}

TEST(Scene, FaultsNameTheField) {
  const Robot robot = planar_arm();
  Scene scene(robot);
  const int object = scene.add_object("ball", {{geometry::Sphere{0.05}}});
  const Isometry3d X_LO = Isometry3d::Identity();
  EXPECT_NE(complaint([&] { scene.attach(0, 1, X_LO, {}); }).find("'base' is a link"),
            std::string::npos);
  EXPECT_NE(complaint([&] { scene.attach(object, 9, X_LO, {}); }).find("link"), std::string::npos);
  EXPECT_NE(complaint([&] { scene.attach(object, 1, X_LO, {-1}); }).find("touching"),
            std::string::npos);
  EXPECT_NE(complaint([&] { scene.attach(object, 1, translation(0, std::nan(""), 0), {}); }), "");
  EXPECT_NE(complaint([&] { scene.is_free(robot::Poses(2)); }).find("not 2"), std::string::npos);
  EXPECT_NE(complaint([&] { scene.is_free(vector({0, 0})); }).find("not 2"), std::string::npos);
  EXPECT_NE(complaint([&] { scene.collision(vector({0, std::nan(""), 0})); }), "");
  EXPECT_NE(complaint([&] { scene.add_object("upper", {{geometry::Sphere{1}}}); }).find("already"),
            std::string::npos);
  const VectorXd q = vector({0, 0, 0.05});
  for (const double resolution : {0.0, -1.0, std::nan(""), 1e-300}) {
    EXPECT_NE(complaint([&] {
                scene.is_free(q, vector({1, 0, 0.05}), resolution);
              }).find("resolution"),
              std::string::npos);
  }
}

TEST(Scene, CopiesMoveAlone) {
  const Robot robot = planar_arm();
  Scene scene(robot);
  const int post = scene.add_obstacle("post", {{geometry::Sphere{0.05}}}, translation(1.5, 0, 0));
  Scene copy = scene;
  copy.move_object(post, translation(5, 0, 0));
  EXPECT_TRUE(copy.is_free(vector({0, 0, 0.05})));
  EXPECT_FALSE(scene.is_free(vector({0, 0, 0.05})));
}

// --- motions ---

/// The definition: every grid point tested.
bool is_free_by_steps(Scene& scene, const VectorXd& q1, const VectorXd& q2, double resolution) {
  const double span = (q2 - q1).cwiseAbs().maxCoeff();
  const int steps = std::max(1, static_cast<int>(std::ceil(span / resolution)));
  for (int i = 0; i <= steps; ++i) {
    if (!scene.is_free(q1 + i * ((q2 - q1) / steps))) return false;
  }
  return true;
}

struct Tally {
  int free = 0, motions = 0;
};

/// Compares both on random motions of all lengths that start free.
Tally expect_as_by_steps(Scene& scene, double resolution, int motions) {
  const Robot& robot = scene.robot();
  std::mt19937 rng(7);
  std::uniform_real_distribution<double> length(0.02, 1);
  Tally tally;
  while (tally.motions < motions) {
    const VectorXd q1 = random_q(robot, rng);
    if (!scene.is_free(q1)) continue;
    const VectorXd q2 = q1 + length(rng) * (random_q(robot, rng) - q1);
    const bool is_free = scene.is_free(q1, q2, resolution);
    EXPECT_EQ(is_free, is_free_by_steps(scene, q1, q2, resolution))
        << q1.transpose() << " to " << q2.transpose();
    EXPECT_EQ(scene.is_free(q2, q1, resolution), is_free);
    tally.free += is_free;
    ++tally.motions;
  }
  return tally;
}

void expect_mixed(const Tally& tally) {
  EXPECT_GT(tally.free, tally.motions / 20);
  EXPECT_LT(tally.free, tally.motions * 19 / 20);
}

TEST(SceneMotion, OfAPlanarArmIsAsByStepping) {
  Scene scene(planar_arm());
  scene.add_obstacle("post", {{geometry::Sphere{0.02}}}, translation(1.2, 0.7, 0));
  scene.add_obstacle("wall", {{geometry::Box{{0.002, 1, 1}}}}, translation(-1.5, 0, 0));
  expect_mixed(expect_as_by_steps(scene, 0.01, 300));
}

TEST(SceneMotion, OfAnAttachedRodIsAsByStepping) {
  const Robot robot = planar_arm();
  Scene scene(robot);
  const int post = scene.add_obstacle("post", {{geometry::Sphere{0.02}}}, translation(1.2, 0.7, 0));
  const int rod = scene.add_object("rod", {{geometry::Capsule{0.01, 0.5}, translation(0, 0, 0.3)}});
  scene.world().add_pair(rod, post);
  Isometry3d X_LO = translation(0.05, 0, 0);
  X_LO.rotate(Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitY()));
  scene.attach(rod, robot.frame("left"), X_LO,
               {robot.frame("left"), robot.frame("right"), robot.frame("lower")});
  expect_mixed(expect_as_by_steps(scene, 0.01, 300));
}

TEST(SceneMotion, WithAnAllowanceIsAsByStepping) {
  Scene scene(planar_arm());
  const int post =
      scene.add_obstacle("post", {{geometry::Box{{0.3, 0.3, 0.3}}}}, translation(1.6, 0.8, 0));
  const auto& world = scene.world();
  scene.world().allow_contact(world.body("left"), post, Vector3d(-1, -1, 0), 0.1);
  scene.world().allow_contact(world.body("base"), world.body("left"), Vector3d(1, 0, 0), 0.3);
  scene.world().allow_contact(world.body("upper"), world.body("right"), Vector3d(0, 1, 0), 0.2);
  expect_mixed(expect_as_by_steps(scene, 0.01, 300));
}

TEST(SceneMotion, OfTheWamOverATableIsAsByStepping) {
  const Robot robot = robot::wam();
  Scene scene(robot);
  scene.add_obstacle("table", {{geometry::Box{{0.7, 0.7, 0.04}}}}, translation(0.65, 0, -0.02));
  scene.add_obstacle("pillar", {{geometry::Capsule{0.03, 1}}}, translation(0.4, 0.4, 0.5));
  expect_mixed(expect_as_by_steps(scene, 0.02, 200));
}

TEST(SceneMotion, SeesAThinWallBetweenTheEnds) {
  Scene scene(planar_arm());
  scene.add_obstacle("wall", {{geometry::Box{{1, 0.001, 1}}}}, translation(1.5, 0, 0));
  const VectorXd q1 = vector({-0.5, 0, 0.05}), q2 = vector({0.5, 0, 0.05});
  EXPECT_TRUE(scene.is_free(q1));
  EXPECT_TRUE(scene.is_free(q2));
  EXPECT_FALSE(scene.is_free(q1, q2));
  EXPECT_TRUE(scene.is_free(q1, q1));
}

TEST(SceneMotion, FollowsChangesOfTheWorld) {
  const Robot robot = planar_arm();
  Scene scene(robot);
  const VectorXd q1 = vector({-0.5, 0, 0.05}), q2 = vector({0.5, 0, 0.05});
  EXPECT_TRUE(scene.is_free(q1, q2));
  const int ball = scene.add_object("ball", {{geometry::Sphere{0.01}}});
  scene.move_object(ball, translation(1.5, 0, 0));
  EXPECT_FALSE(scene.is_free(q1, q2));
  const int lower = robot.frame("lower");
  scene.attach(ball, lower, translation(0.5, 0, 0.2), {lower});
  EXPECT_TRUE(scene.is_free(q1, q2));
  const int post = scene.add_obstacle("post", {{geometry::Sphere{0.01}}}, translation(1.5, 0, 0.2));
  scene.world().add_pair(ball, post);
  EXPECT_FALSE(scene.is_free(q1, q2));
  scene.world().remove_pair(ball, post);
  EXPECT_TRUE(scene.is_free(q1, q2));
}

/// True if no pair that the arm's joints move would touch after a shift by `distance` in the plane,
/// which is where all links of the planar arm are nearest to each other.
bool is_arm_clear(Scene& plain, const VectorXd& q, double distance) {
  plain.collision(q);
  collision::World world = plain.world();
  for (const auto& [a, b] : plain.world().pairs()) {
    if (Names(world.name(a), world.name(b)) == Names("left", "right")) continue;
    const Isometry3d X_WB = world.pose(b);
    for (int i = 0; i < 24; ++i) {
      const double angle = 2 * M_PI * i / 24;
      world.set_pose(b,
                     translation(distance * std::cos(angle), distance * std::sin(angle), 0) * X_WB);
      const auto touching = world.all_collisions();
      if (std::count(touching.begin(), touching.end(), std::make_pair(a, b)) > 0) return false;
    }
    world.set_pose(b, X_WB);
  }
  return true;
}

TEST(LinkClearance, IsKeptWhereTheJointsMoveLinks) {
  constexpr double kClearance = 0.03, kRounding = 0.03;  // by 24 directions, and more
  const Robot robot = planar_arm();
  Scene scene(robot), plain(robot);
  scene.keep_links_apart(kClearance, {0, 1}, {vector({0.3, 0.4, 0.05})});
  std::mt19937 rng(4);
  int near = 0, clear = 0;
  for (int i = 0; i < 300; ++i) {
    VectorXd q = random_q(robot, rng);
    if (i % 10 > 0) q[1] = std::uniform_real_distribution<double>(2.6, 3)(rng);
    if (!plain.is_free(q)) continue;
    const bool is_free = scene.is_free(q);
    if (is_free) {
      EXPECT_TRUE(is_arm_clear(plain, q, (1 - kRounding) * kClearance)) << q.transpose();
    } else {
      EXPECT_FALSE(is_arm_clear(plain, q, 1.15 * kClearance)) << q.transpose();
    }
    (is_free ? clear : near) += 1;
  }
  EXPECT_GT(near, 10);
  EXPECT_GT(clear, 10);
  EXPECT_TRUE(scene.is_free(vector({0, 0, -0.005})));  // the jaws are 10 mm apart
}

TEST(LinkClearance, IsKeptAlongMotions) {
  const Robot robot = planar_arm();
  Scene scene(robot);
  scene.keep_links_apart(0.03, {0, 1}, {});
  std::mt19937 rng(5);
  int refused = 0;
  for (int i = 0; i < 400; ++i) {
    const VectorXd q1 = random_q(robot, rng), q2 = random_q(robot, rng);
    const int steps = std::max(1, static_cast<int>(std::ceil(robot.step(q1, q2) / 0.01)));
    bool is_free = true;
    for (int k = 0; is_free && k <= steps; ++k) is_free = scene.is_free(q1 + (q2 - q1) * k / steps);
    EXPECT_EQ(scene.is_free(q1, q2), is_free);
    refused += !is_free;
  }
  EXPECT_GT(refused, 20);
  EXPECT_LT(refused, 380);
}

TEST(LinkClearance, IsNotAskedOfPairsThatAreGivenNearer) {
  const Robot robot = planar_arm();
  Scene scene(robot), plain(robot);
  VectorXd q = vector({0, 2.6, 0.05});
  while (is_arm_clear(plain, q, 0.01)) q[1] += 1e-3;
  ASSERT_TRUE(plain.is_free(q));
  scene.keep_links_apart(0.03, {0, 1}, {vector({0, 0, 0.05})});
  EXPECT_FALSE(scene.is_free(q));
  scene.keep_links_apart(0.03, {0, 1}, {vector({0, 0, 0.05}), q});
  EXPECT_TRUE(scene.is_free(q));
  scene.keep_links_apart(0.03, {0, 1}, {});
  EXPECT_FALSE(scene.is_free(q));
}

/// A plate that turns 1 mm over its base, with a bar that meets a post of the base at 3 rad.
const char* const kTurntable = R"(
<robot name="turntable">
  <link name="base">
    <collision><geometry><box size="0.4 0.4 0.02"/></geometry></collision>
    <collision><origin xyz="-0.18 0 0.1"/><geometry><box size="0.02 0.02 0.2"/></geometry></collision>
  </link>
  <link name="ring"><collision><origin xyz="0 0 1"/>
    <geometry><sphere radius="0.01"/></geometry></collision></link>
  <link name="plate"><collision><origin xyz="0 0 0.021"/>
    <geometry><cylinder radius="0.1" length="0.02"/></geometry></collision></link>
  <link name="bar"><collision><origin xyz="0.13 0 0.1"/>
    <geometry><box size="0.1 0.02 0.02"/></geometry></collision></link>
  <joint name="turn" type="revolute"><parent link="base"/><child link="ring"/>
    <axis xyz="0 0 1"/><limit lower="-4" upper="4" velocity="1" effort="1"/></joint>
  <joint name="twist" type="revolute"><parent link="ring"/><child link="plate"/>
    <axis xyz="0 0 1"/><limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
  <joint name="swing" type="revolute"><parent link="plate"/><child link="bar"/>
    <axis xyz="0 0 1"/><limit lower="-0.1" upper="0.1" velocity="1" effort="1"/></joint>
</robot>)";

TEST(LinkClearance, IsNotAskedOfPairsThatAreBuiltNearer) {
  const Robot robot = Robot::from_urdf(kTurntable, {});
  Scene scene(robot), plain(robot);
  scene.keep_links_apart(2e-3, {0, 1, 2}, {});
  for (double turn = -1.5; turn < 1.5; turn += 0.1) {
    EXPECT_TRUE(scene.is_free(vector({turn, 0, 0}))) << turn;
  }
  // The bar and the base are not built nearer. They keep the distance.
  VectorXd q = vector({2, 0, 0});
  while (plain.is_free(q)) q[0] += 1e-4;
  q[0] -= 5e-3;  // 0.9 mm before
  EXPECT_TRUE(plain.is_free(q));
  EXPECT_FALSE(scene.is_free(q));
  q[0] -= 1e-2;
  EXPECT_TRUE(scene.is_free(q));
}

TEST(Names, OfLinksWithShapesAreNotThoseOfOtherBodies) {
  const Robot robot = Robot::from_urdf(R"(<robot name="r">
    <link name="object"><collision><geometry><sphere radius="1"/></geometry></collision></link>
    <link name="support"/>
    <joint name="j" type="fixed"><parent link="object"/><child link="support"/></joint>
  </robot>)",
                                       {});
  EXPECT_EQ(taken_names(robot, {"support", "wall"}),
            (std::set<std::string>{"object", "support", "wall"}));
  expect_refused([&] { taken_names(robot, {"object"}); },
                 "robot: link 'object' has the name of another body of the plan: rename it");
}

}  // namespace
}  // namespace graspless::scene
