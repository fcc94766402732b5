// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/evidence.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "graspless/geometry/sampling.hpp"

#include "complaint.hpp"
#include "geometry/loops/views.hpp"

namespace graspless::geometry {
namespace {

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
  for (std::size_t i = 0; i < eyes.size(); ++i) columns.col(i) = eyes[i];
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

}  // namespace
}  // namespace graspless::geometry
