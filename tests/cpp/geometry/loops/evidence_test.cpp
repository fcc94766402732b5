// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/evidence.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "graspless/clasp/sample_objects.hpp"
#include "graspless/geometry/sampling.hpp"

#include "complaint.hpp"
#include "geometry/loops/one_sided.hpp"

namespace graspless::geometry {
namespace {

constexpr float kOpen = std::numeric_limits<float>::infinity();

struct Block {
  Eigen::Vector3d low, high;
  bool is_object = true;
};

/// Length of a ray up to a block; infinite if it misses.
double hit(const Block& block, const Eigen::Vector3d& p, const Eigen::Vector3d& r) {
  double in = 0, out = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double a = (block.low[i] - p[i]) / r[i], b = (block.high[i] - p[i]) / r[i];
    in = std::max(in, std::min(a, b));
    out = std::min(out, std::max(a, b));
  }
  return in <= out && in > 0 ? in : std::numeric_limits<double>::infinity();
}

/// A camera at `eye` that looks at the origin, with x level.
Eigen::Isometry3d look_from(const Eigen::Vector3d& eye) {
  const Eigen::Vector3d z = -eye.normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() << x, z.cross(x), z;
  X.translation() = eye;
  return X;
}

struct Seen {
  Eigen::Matrix3Xd points;
  std::vector<RayImage> rays;
};

/// What cameras see of blocks: the points where rays end on the object, and the rays.
Seen look(const std::vector<Block>& blocks, const std::vector<Eigen::Vector3d>& eyes) {
  constexpr int kSide = 120;
  Seen seen;
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector3d& eye : eyes) {
    RayImage rays;
    rays.K << 200, 0, (kSide - 1) / 2.0, 0, 200, (kSide - 1) / 2.0, 0, 0, 1;
    rays.X_OC = look_from(eye);
    rays.ends.setConstant(kSide, kSide, kOpen);
    for (int v = 0; v < kSide; ++v) {
      for (int u = 0; u < kSide; ++u) {
        const Eigen::Vector3d r =
            rays.X_OC.linear() * rays.K.inverse() * Eigen::Vector3d(u + 1e-4, v + 1e-4, 1);
        double nearest = std::numeric_limits<double>::infinity();
        bool is_object = false;
        for (const Block& block : blocks) {
          const double z = hit(block, eye, r);
          if (z >= nearest) continue;
          nearest = z;
          is_object = block.is_object;
        }
        if (std::isinf(nearest)) continue;
        rays.ends(v, u) = static_cast<float>(is_object ? -nearest : nearest);
        if (is_object) points.push_back(eye + nearest * r);
      }
    }
    seen.rays.push_back(rays);
  }
  seen.points.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    seen.points.col(static_cast<Eigen::Index>(i)) = points[i];
  return seen;
}

Loops loops_of(const Seen& seen) { return shortest_loops(seen.points, {}, seen.rays); }

/// A frame with an opening of 0.12 x 0.12 m, from posts 20 mm thick, that faces y. The right post
/// ends `gap` below the upper one.
std::vector<Block> frame(double gap = 0) {
  return {{{-0.08, -0.01, -0.08}, {-0.06, 0.01, 0.08}},
          {{0.06, -0.01, -0.08}, {0.08, 0.01, 0.06 - gap}},
          {{-0.06, -0.01, -0.08}, {0.06, 0.01, -0.06}},
          {{-0.06, -0.01, 0.06}, {0.08, 0.01, 0.08}}};
}

/// Walls of a box 0.16 m wide and 0.08 m high, open at the top, with a floor or without.
std::vector<Block> tray(bool has_floor) {
  std::vector<Block> blocks = {{{-0.08, -0.08, -0.04}, {-0.075, 0.08, 0.04}},
                               {{0.075, -0.08, -0.04}, {0.08, 0.08, 0.04}},
                               {{-0.075, -0.08, -0.04}, {0.075, -0.075, 0.04}},
                               {{-0.075, 0.075, -0.04}, {0.075, 0.08, 0.04}}};
  if (has_floor) blocks.push_back({{-0.075, -0.075, -0.04}, {0.075, 0.075, -0.038}});
  return blocks;
}

const Eigen::Vector3d kFront(0.05, -0.45, 0.1), kAbove(0.05, -0.2, 0.4);

TEST(Evidence, AFrameIsAHoleOfTheAreaThatRaysPass) {
  const Loops found = loops_of(look(frame(), {kFront}));
  EXPECT_TRUE(found.has_rays);
  ASSERT_EQ(found.found.size(), 1u) << found.reason;
  EXPECT_NEAR(found.found[0].seen_through, 0.12 * 0.12, 0.2 * 0.12 * 0.12);
  EXPECT_EQ(found.found[0].unseen, 0);
  EXPECT_GT(found.found[0].length, 4 * 0.12);
  EXPECT_LT(found.found[0].length, 4 * 0.16);
}

TEST(Evidence, TheRimOfADishIsUncertainAndThatOfAPipeAHole) {
  const Loops dish = loops_of(look(tray(true), {kAbove}));
  EXPECT_TRUE(dish.found.empty());
  EXPECT_EQ(dish.status, LoopStatus::no_reliable_hole);
  ASSERT_FALSE(dish.uncertain.empty());
  EXPECT_NE(dish.reason.find("no ray passed through it"), std::string::npos) << dish.reason;
  const Loops pipe = loops_of(look(tray(false), {kAbove}));
  ASSERT_EQ(pipe.found.size(), 1u) << pipe.reason;
  EXPECT_GT(pipe.found[0].seen_through, 0);
}

TEST(Evidence, WhatLiesInADishProvesNothing) {
  std::vector<Block> blocks = tray(true);
  blocks.push_back({{-0.05, -0.05, -0.038}, {0.05, 0.05, 0.01}, false});
  const Loops found = loops_of(look(blocks, {kAbove}));
  EXPECT_TRUE(found.found.empty()) << found.reason;
}

TEST(Evidence, WhatStandsBehindAFrameProvesTheHole) {
  std::vector<Block> blocks = frame();
  blocks.push_back({{-1, 0.3, -1}, {1, 0.31, 1}, false});
  EXPECT_EQ(loops_of(look(blocks, {kFront})).found.size(), 1u);
}

TEST(Evidence, AFrameThatIsOpenIsNoHole) {
  for (const double gap : {0.012, 0.03}) {
    const Loops found = loops_of(look(frame(gap), {kFront}));
    EXPECT_TRUE(found.found.empty()) << gap << ": " << found.reason;
  }
}

TEST(Evidence, AFrameBehindAPostIsUncertainUntilASecondViewShowsTheRest) {
  std::vector<Block> blocks = frame();
  blocks.push_back({{-0.012, -0.12, -0.3}, {0.012, -0.1, 0.3}, false});
  const Loops hidden = loops_of(look(blocks, {kFront}));
  EXPECT_TRUE(hidden.found.empty()) << hidden.reason;
  const Eigen::Vector3d side(-0.25, -0.4, 0.1);
  EXPECT_EQ(loops_of(look(blocks, {kFront, side})).found.size(), 1u);
}

TEST(Evidence, EveryHoleOfALatticeIsFoundOnce) {
  std::vector<Block> blocks = frame();
  blocks.push_back({{-0.008, -0.01, -0.06}, {0.008, 0.01, 0.06}});
  for (const auto& eyes :
       {std::vector<Eigen::Vector3d>{kFront},
        std::vector<Eigen::Vector3d>{kFront, {-0.1, -0.45, 0.05}, {0.1, 0.45, 0.1}}}) {
    const Loops found = loops_of(look(blocks, eyes));
    EXPECT_EQ(found.found.size(), 2u) << eyes.size() << " views: " << found.reason;
  }
}

TEST(Evidence, RaysInAnotherFrameGiveTheSameLoops) {
  Seen seen = look(frame(), {kFront});
  const Loops before = loops_of(seen);
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.rotate(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()));
  X.pretranslate(Eigen::Vector3d(0.3, -2, 1));
  seen.points = X * seen.points;
  for (RayImage& rays : seen.rays) rays.X_OC = X * rays.X_OC;
  const Loops after = loops_of(seen);
  ASSERT_EQ(after.found.size(), before.found.size());
  EXPECT_NEAR(after.found[0].seen_through, before.found[0].seen_through, 1e-4);
}

TEST(Evidence, ALoopBehindTheCameraHasNone) {
  const Seen seen = look(frame(), {kFront});
  const Evidence evidence(seen.rays, seen.points);
  Eigen::Matrix3Xd loop(3, 4);
  loop << -1, 1, 1, -1, -3, -3, -3, -3, -1, -1, 1, 1;
  EXPECT_EQ(evidence.of(loop, 1).seen_through, 0);
}

TEST(Evidence, RefusesBadRays) {
  Seen seen = look(frame(), {kFront});
  const auto complaint_of = [&](auto change) {
    std::vector<RayImage> rays = {seen.rays[0], seen.rays[0]};
    change(rays[1]);
    return complaint([&] { shortest_loops(seen.points, {}, rays); });
  };
  const auto starts = [](const std::string& text, const std::string& start) {
    return text.rfind(start, 0) == 0;
  };
  EXPECT_TRUE(starts(complaint_of([](RayImage& r) { r.ends(3, 4) = std::nanf(""); }),
                     "rays[1].ends must be numbers"));
  EXPECT_TRUE(starts(complaint_of([](RayImage& r) { r.ends(3, 4) = -kOpen; }),
                     "rays[1].ends must be numbers"));
  EXPECT_TRUE(starts(complaint_of([](RayImage& r) { r.ends.resize(0, 0); }),
                     "rays[1].ends must have 1 to 25000000 pixels, not 0"));
  EXPECT_TRUE(starts(complaint_of([](RayImage& r) { r.K(0, 1) = 1; }), "rays[1].K must be"));
  EXPECT_TRUE(
      starts(complaint_of([](RayImage& r) { r.X_OC.linear() *= 2; }), "rays[1].X_OC must be"));
}

Eigen::Matrix3Xd matrix_of(const std::vector<Eigen::Vector3d>& eyes) {
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(eyes.size()));
  for (std::size_t i = 0; i < eyes.size(); ++i) columns.col(static_cast<Eigen::Index>(i)) = eyes[i];
  return columns;
}

TEST(Viewpoints, TellHolesFromRimsWithoutDepthImages) {
  const auto found = [](const std::vector<Block>& blocks,
                        const std::vector<Eigen::Vector3d>& eyes) {
    const Eigen::Matrix3Xd points = look(blocks, eyes).points;
    return shortest_loops(points, {}, rays_from_viewpoints(points, matrix_of(eyes)));
  };
  for (const auto& eyes : {std::vector{kFront}, {kFront, Eigen::Vector3d(-kFront)}}) {
    const Loops hole = found(frame(), eyes);
    ASSERT_EQ(hole.found.size(), 1u) << hole.reason;
    EXPECT_NEAR(hole.found[0].seen_through, 0.12 * 0.12, 0.4 * 0.12 * 0.12);
    EXPECT_TRUE(found(frame(0.05), eyes).found.empty());
  }
  EXPECT_TRUE(found(tray(true), {kAbove}).found.empty());
  EXPECT_EQ(found(tray(false), {kAbove}).found.size(), 1u);
}

TEST(Viewpoints, RefuseBadInput) {
  const Eigen::Matrix3Xd points = look(frame(), {kFront}).points;
  const Eigen::Vector3d inside(0.0, 0.0, 0.0);
  expect_refused([&] { rays_from_viewpoints(points, inside); }, "viewpoints[0] is among");
  expect_refused([&] { rays_from_viewpoints(points.leftCols(10), kFront); },
                 "points must hold at least 20 points, not 10");
  expect_refused([&] { rays_from_viewpoints(points, Eigen::Vector3d(NAN, 0, 0)); }, "viewpoints");
  EXPECT_TRUE(rays_from_viewpoints(points, Eigen::Matrix3Xd(3, 0)).empty());
  Eigen::Matrix3Xd line = Eigen::Matrix3Xd::Zero(3, 40);  // seen from its end
  line.row(2) = Eigen::RowVectorXd::LinSpaced(40, 0, 0.1);
  for (const Eigen::Matrix3Xd& one_ray : {line, Eigen::Matrix3Xd(line.col(7).replicate(1, 40))}) {
    expect_refused([&] { rays_from_viewpoints(one_ray, Eigen::Vector3d(0, 0, 1)); },
                   "points must not all lie on one ray of viewpoints[0]");
  }
}

TEST(OneSided, ALoopOfOneViewIsUncertainWithoutItsCamera) {
  const Loops one = shortest_loops(look(frame(), {kFront}).points);
  EXPECT_TRUE(one.found.empty());
  ASSERT_FALSE(one.uncertain.empty());
  EXPECT_NE(one.reason.find("one camera could have seen all points"), std::string::npos)
      << one.reason;
  LoopOptions options;
  options.all_sides = true;  // says who knows that it is so
  EXPECT_FALSE(shortest_loops(look(frame(), {kFront}).points, options).found.empty());
  const Eigen::Vector3d side(0.4, 0.2, 0.1);
  const std::vector<Eigen::Vector3d> around{kFront, -kFront, side, -side};
  const Loops all = shortest_loops(look(frame(), around).points);
  EXPECT_FALSE(all.found.empty()) << all.reason;
}

/// Points with noise of a part of their spacing in all directions.
Eigen::Matrix3Xd rough(Eigen::Matrix3Xd points, double part, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, part * spacing(points));
  for (double& value : points.reshaped()) value += noise(random);
  return points;
}

TEST(OneSided, NoiseDoesNotMakeTheLoopsOfOneViewHoles) {
  const Eigen::Vector3d side(0.4, 0.2, 0.1);
  const Eigen::Matrix3Xd one = look(frame(), {kFront}).points;
  const Eigen::Matrix3Xd all = look(frame(), {kFront, -kFront, side, -side}).points;
  for (const double part : {0.3, 0.5, 0.7}) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      EXPECT_TRUE(is_one_sided(rough(one, part, seed))) << part << " " << seed;
      EXPECT_FALSE(is_one_sided(rough(all, part, seed))) << part << " " << seed;
    }
  }
}

/// The cloud without the points in three balls.
Eigen::Matrix3Xd patchy(const Eigen::Matrix3Xd& points, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<Eigen::Index> any(0, points.cols() - 1);
  const double radius = 3 * spacing(points);
  Eigen::Array<bool, 1, Eigen::Dynamic> stays = Eigen::ArrayXXd::Zero(1, points.cols()) == 0;
  for (int ball = 0; ball < 3; ++ball) {
    const Eigen::Vector3d middle = points.col(any(random));
    stays = stays && (points.colwise() - middle).colwise().norm().array() > radius;
  }
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (stays[i]) kept.push_back(i);
  return points(Eigen::all, kept);
}

/// Neighbourhoods of 13 points go around the rods of a chair.
TEST(OneSided, RodsThatAreThinnerThanTheSpacingAreNoNoise) {
  const std::vector<PlacedShape> chair = clasp::sample_object("chair");
  for (const int count : {1000, 1500, 2000}) {
    const Eigen::Matrix3Xd cloud = sample_surface(chair, count);
    EXPECT_FALSE(is_one_sided(cloud)) << count;
    for (unsigned seed = 1; seed <= 5; ++seed)
      EXPECT_FALSE(is_one_sided(patchy(cloud, seed))) << count << " " << seed;
  }
}

}  // namespace
}  // namespace graspless::geometry
