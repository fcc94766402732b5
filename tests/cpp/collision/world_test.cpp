// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/world.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "collision/shapes.hpp"
#include "complaint.hpp"

namespace graspless::collision {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using geometry::PlacedShape;
using geometry::Shape;

/// Whether the two bodies touch, by both paths, which must agree.
bool touch(World& world, const Isometry3d& X_WA, const Isometry3d& X_WB) {
  world.set_pose(0, X_WA);
  world.set_pose(1, X_WB);
  const bool collides = world.collides();
  EXPECT_EQ(collides, !world.all_collisions().empty());
  EXPECT_EQ(world.num_failures(), 0);
  return collides;
}

// All of these reach 0.5 above and below their origin and are at least 0.2 wide.
std::vector<std::pair<std::string, Shape>> named_kinds() {
  return {{"box", geometry::Box{{0.4, 0.6, 1}}},
          {"sphere", geometry::Sphere{0.5}},
          {"capsule", geometry::Capsule{0.2, 0.6}},
          {"convex", geometry::Convex{prism(100, 0.3, 1).vertices}},
          {"convex mesh", prism(6, 0.3, 1)},
          {"mesh", dented_prism(12, 0.3, 1)}};
}

TEST(World, EveryOrderedPairOfKindsTouchesWhereItShould) {
  ::testing::internal::CaptureStderr();
  for (const auto& [name_a, a] : named_kinds()) {
    for (const auto& [name_b, b] : named_kinds()) {
      SCOPED_TRACE(name_a + " " + name_b);
      World world = two_bodies(a, b);
      const Isometry3d X_WA = translation(1, 2, 3);
      EXPECT_TRUE(touch(world, X_WA, translation(1, 2, 3.99)));
      EXPECT_FALSE(touch(world, X_WA, translation(1, 2, 4.01)));
      EXPECT_TRUE(touch(world, X_WA, translation(1.05, 2.1, 2.1)));
      EXPECT_FALSE(touch(world, X_WA, translation(1.05, 2.1, 1.9)));
      EXPECT_TRUE(touch(world, X_WA, translation(1.2, 2, 3)));
      EXPECT_FALSE(touch(world, X_WA, translation(2.1, 2, 3)));
    }
  }
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");  // FCL only warns of unsupported pairs
}

TEST(World, IsSymmetricAndUnmovedByARigidMotion) {
  std::mt19937 rng(1);
  int touching = 0;
  for (const auto& [name_a, a] : named_kinds()) {
    for (const auto& [name_b, b] : named_kinds()) {
      SCOPED_TRACE(name_a + " " + name_b);
      World world = two_bodies(a, b), swapped = two_bodies(b, a);
      for (int i = 0; i < 60; ++i) {
        const Isometry3d X_WA = random_pose(rng, 0.6), X_WB = random_pose(rng, 0.6);
        const Isometry3d X_VW = random_pose(rng, 5);
        const bool seen = touch(world, X_WA, X_WB);
        EXPECT_EQ(touch(swapped, X_WB, X_WA), seen);
        EXPECT_EQ(touch(world, X_VW * X_WA, X_VW * X_WB), seen);
        touching += seen;
      }
    }
  }
  EXPECT_GT(touching, 300);
  EXPECT_LT(touching, 1900);
}

TEST(World, SeesASolidWhollyInside) {
  const Shape small = geometry::Sphere{0.01};
  for (const auto& [name, shape] : named_kinds()) {
    World world = two_bodies(shape, small);
    EXPECT_TRUE(world.collides()) << name;
  }
}

TEST(World, HullIgnoresInnerAndRepeatedPoints) {
  const Eigen::Matrix3Xd corners = prism(5, 0.3, 1).vertices;
  Eigen::Matrix3Xd more(3, 3 * corners.cols());
  more << corners, corners, 0.5 * corners;
  World world = two_bodies(geometry::Convex{more}, geometry::Convex{corners});
  for (const double height : {0.99, 1.01}) {
    EXPECT_EQ(touch(world, translation(0, 0, height), Isometry3d::Identity()), height < 1);
  }
}

TEST(World, KeepsEachPairOnce) {
  World world;
  for (const char* name : {"a", "b", "c"}) world.add_body(name, {{geometry::Sphere{0.1}}});
  world.add_pair(2, 0);
  world.add_pair(0, 1);
  world.add_pair(0, 2);
  EXPECT_EQ(world.pairs(), (std::vector<std::pair<int, int>>{{0, 2}, {0, 1}}));
  World copy = world;
  copy.remove_pair(2, 0);
  copy.add_pair(2, 0);
  EXPECT_EQ(copy.pairs(), (std::vector<std::pair<int, int>>{{0, 1}, {0, 2}}));
  EXPECT_EQ(world.num_pairs(), 2);
  EXPECT_THROW(world.pair(2), std::invalid_argument);
}

TEST(World, RefusesPairsThatAreNotTested) {
  World world;
  for (const char* name : {"a", "b"}) world.add_body(name, {{geometry::Sphere{0.1}}});
  world.add_pair(0, 1);
  for (const int pair : {-1, 1, 99}) {
    const std::string text = "must be in [0, 1), not " + std::to_string(pair);
    EXPECT_EQ(complaint([&] { world.pair(pair); }), "index " + text);
    EXPECT_EQ(complaint([&] { world.shift(pair); }), "pair " + text);
    EXPECT_EQ(complaint([&] { world.touches(pair); }), "pair " + text);
    EXPECT_EQ(complaint([&] { world.swallows(pair); }), "pair " + text);
    EXPECT_EQ(complaint([&] { world.distance_bound(pair); }), "pair " + text);
    EXPECT_EQ(complaint([&] { world.proven_distance(pair, 1); }), "pair " + text);
  }
}

TEST(World, TestsEveryShapeOfABody) {
  World world;
  const int a = world.add_body("comb", {{geometry::Sphere{0.1}, translation(0, 0, 0)},
                                        {geometry::Box{{0.1, 0.1, 0.1}}, translation(1, 0, 0)},
                                        {geometry::Capsule{0.1, 0.2}, translation(2, 0, 0)}});
  const int b = world.add_body(
      "probe", {{geometry::Sphere{0.05}, translation(0, 0, 5)}, {geometry::Sphere{0.05}}});
  world.add_pair(a, b);
  for (const double x : {0.0, 1.0, 2.0}) {
    world.set_pose(b, translation(x, 0, 0));
    EXPECT_TRUE(world.collides());
    world.set_pose(b, translation(x + 0.5, 0, 0));
    EXPECT_FALSE(world.collides());
    EXPECT_NEAR(world.distance_bounds()[0], 0.35, 0.05);
  }
  world.set_pose(b, translation(1, 0, -5));
  EXPECT_EQ(world.first_collision(), std::make_pair(a, b));
}

TEST(World, TestsOnlyThePairsItWasGiven) {
  World world;
  for (const char* name : {"a", "b", "c"}) world.add_body(name, {{geometry::Sphere{1}}});
  EXPECT_FALSE(world.collides());
  world.add_pair(2, 0);
  world.add_pair(0, 2);
  world.add_pair(1, 2);
  using Pairs = std::vector<std::pair<int, int>>;
  EXPECT_EQ(world.pairs(), (Pairs{{0, 2}, {1, 2}}));
  EXPECT_EQ(world.all_collisions(), (Pairs{{0, 2}, {1, 2}}));
  world.remove_pair(2, 0);
  world.remove_pair(0, 1);
  EXPECT_EQ(world.all_collisions(), (Pairs{{1, 2}}));
  EXPECT_EQ(world.num_checks(), 1);
}

TEST(World, CopiesMoveAlone) {
  World world = two_bodies(geometry::Sphere{1}, geometry::Sphere{1});
  World copy = world;
  copy.set_pose(0, translation(3, 0, 0));
  EXPECT_TRUE(world.collides());
  EXPECT_FALSE(copy.collides());
  world = copy;
  EXPECT_FALSE(world.collides());
  world.remove_pair(0, 1);
  EXPECT_EQ(copy.num_pairs(), 1);
}

TEST(World, FaultsNameTheFieldAndTheChoices) {
  World world = two_bodies(geometry::Sphere{1}, geometry::Sphere{1});
  const int c = world.add_body("c", {{geometry::Sphere{1}}});
  const Vector3d up = Vector3d::UnitZ();
  EXPECT_EQ(complaint([&] { world.body("d"); }), "no body 'd'; choose from: a, b, c");
  EXPECT_EQ(complaint([&] { world.add_body("a", {{geometry::Sphere{1}}}); }),
            "body 'a' already exists");
  EXPECT_EQ(complaint([&] { world.add_body("d", {}); }), "body 'd' must have a shape");
  EXPECT_EQ(complaint([&] {
              world.add_body("d", {{geometry::Sphere{1}}, {geometry::Sphere{0}}});
            }),
            "body 'd' shapes[1].radius must be in [1e-06, 10000] m, not 0");
  EXPECT_EQ(world.num_bodies(), 3);
  EXPECT_NE(complaint([&] { world.add_pair(0, 3); }).find("not 3"), std::string::npos);
  EXPECT_NE(complaint([&] { world.add_pair(c, c); }).find("itself"), std::string::npos);
  EXPECT_NE(complaint([&] { world.allow_contact(0, c, up, 0.1); }).find("not tested"),
            std::string::npos);
  EXPECT_NE(complaint([&] { world.allow_contact(0, 1, up, -0.1); }).find("depth"),
            std::string::npos);
  EXPECT_NE(complaint([&] { world.allow_contact(0, 1, 0 * up, 0.1); }).find("normal_W"),
            std::string::npos);
  Isometry3d broken = Isometry3d::Identity();
  broken.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(complaint([&] { world.set_pose(0, broken); }).find("'a'"), std::string::npos);
  EXPECT_NE(complaint([&] { world.set_pose(0, translation(2e4, 0, 0)); }).find("1e4 m"),
            std::string::npos);
  EXPECT_NE(complaint([&] { world.set_pose(-1, broken); }).find("-1"), std::string::npos);
  Isometry3d sheared = Isometry3d::Identity();
  sheared(0, 1) = 1e-3;
  Isometry3d mirrored = Isometry3d::Identity();
  mirrored(0, 0) = -1;
  Isometry3d shrunk = Isometry3d::Identity();
  shrunk.linear() = Eigen::Quaterniond(0.5, 0, 0, 0.5).toRotationMatrix();  // its length is not 1
  for (const Isometry3d& X : {sheared, mirrored, shrunk})
    EXPECT_NE(complaint([&] { world.set_pose(0, X); }).find("a rotation"), std::string::npos);
  EXPECT_NE(complaint([&] {
              world.add_body("d", {{geometry::Sphere{1}, broken}});
            }).find("X_BG"),
            std::string::npos);
}

// --- contact allowances ---

const Shape kSlab = geometry::Box{{2, 2, 0.1}};
constexpr double kSlabTop = 0.05;

TEST(ContactAllowance, EndsAtItsDepth) {
  const geometry::Capsule finger{0.01, 0.1};
  for (const bool finger_first : {true, false}) {
    World world;
    int bodies[2];
    for (const int i : {0, 1}) {
      const bool is_finger = (i == 0) == finger_first;
      bodies[is_finger] =
          world.add_body(is_finger ? "finger" : "slab", {{is_finger ? Shape(finger) : kSlab}});
    }
    const int slab = bodies[0], tip = bodies[1];
    world.add_pair(slab, tip);
    world.allow_contact(tip, slab, {0, 0, 3}, 0.02);
    const auto pressed = [&](double depth) {
      world.set_pose(tip, translation(0.3, 0.1, kSlabTop + 0.06 - depth));
      EXPECT_EQ(world.collides(), !world.all_collisions().empty());
      return world.collides();
    };
    EXPECT_FALSE(pressed(0.001));
    EXPECT_FALSE(pressed(0.01999));
    EXPECT_TRUE(pressed(0.02001));
    EXPECT_TRUE(pressed(0.06));
    world.allow_contact(tip, slab, Vector3d::UnitZ(), 0);
    EXPECT_TRUE(pressed(0.001));
    EXPECT_FALSE(pressed(-0.001));
  }
}

TEST(ContactAllowance, IsForOnePairOnly) {
  World world;
  const int slab = world.add_body("slab", {{kSlab}});
  const int finger = world.add_body("finger", {{geometry::Sphere{0.01}}});
  const int palm = world.add_body("palm", {{geometry::Sphere{0.01}}});
  world.add_pair(slab, finger);
  world.add_pair(slab, palm);
  world.allow_contact(finger, slab, Vector3d::UnitZ(), 0.02);
  for (const int body : {finger, palm}) world.set_pose(body, translation(0, 0, kSlabTop + 0.005));
  EXPECT_EQ(world.first_collision(), std::make_pair(slab, palm));
  EXPECT_NEAR(world.distance_bound(0), 0.015, 1e-12);
}

TEST(Clearance, IsKeptUpToATenth) {
  constexpr double kClearance = 0.01;
  for (const auto& [name_a, a] : named_kinds()) {
    for (const auto& [name_b, b] : named_kinds()) {
      SCOPED_TRACE(name_a + " " + name_b);
      World world = two_bodies(a, b);
      world.keep_apart(1, 0, kClearance);
      const auto at = [&](double gap) {  // all kinds reach 0.5 above and below their origin
        world.set_pose(0, translation(1, 2, 3));
        world.set_pose(1, translation(1, 2, 4 + gap));
        EXPECT_TRUE(world.all_collisions().empty());
        return world.collides();
      };
      EXPECT_TRUE(at(0.0001));
      EXPECT_TRUE(at(kClearance - 1e-5));
      EXPECT_FALSE(at(1.15 * kClearance));
      EXPECT_LE(world.distance_bound(0), 0.15 * kClearance + 1e-12);
      world.keep_apart(0, 1, 0);
      EXPECT_FALSE(at(0.0001));
    }
  }
}

TEST(Clearance, CountsWhatTouchesAsTouching) {
  std::mt19937 rng(8);
  int touching = 0, near = 0;
  for (const auto& [name_a, a] : named_kinds()) {
    for (const auto& [name_b, b] : named_kinds()) {
      World world = two_bodies(a, b), wide = two_bodies(a, b);
      wide.keep_apart(0, 1, 0.05);
      for (int i = 0; i < 60; ++i) {
        const Isometry3d X_WA = random_pose(rng, 0.6), X_WB = random_pose(rng, 0.6);
        const bool touches = touch(world, X_WA, X_WB);
        wide.set_pose(0, X_WA);
        wide.set_pose(1, X_WB);
        const bool is_near = wide.collides();
        EXPECT_TRUE(is_near || !touches) << name_a << " " << name_b;
        touching += touches;
        near += is_near;
      }
    }
  }
  EXPECT_GT(near, touching + 20);
}

TEST(Clearance, NamesBadArguments) {
  World world = two_bodies(geometry::Sphere{1}, geometry::Sphere{1});
  world.add_body("third", {{geometry::Sphere{1}}});
  expect_refused([&] { world.keep_apart(0, 1, -1); }, "clearance");
  expect_refused([&] { world.keep_apart(0, 2, 0.1); }, "'third' are not tested");
  expect_refused([&] { world.keep_apart(0, 3, 0.1); }, "b must be");
}

}  // namespace
}  // namespace graspless::collision
