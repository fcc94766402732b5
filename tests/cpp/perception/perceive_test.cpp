// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "geometry/convex_hull.hpp"
#include "perception/scenes.hpp"

namespace graspless::perception {
namespace {

const Eigen::Vector3d kCard(0.12, 0.08, 0.003);
const Eigen::Vector3d kBox(0.06, 0.08, 0.1);

std::map<EdgeLabel, double> lengths_of(const Support& support) {
  std::map<EdgeLabel, double> lengths;
  for (int i = 0; i < support.polygon.size(); ++i) {
    const auto edge = support.polygon.edge(i);
    lengths[support.edges[i]] += (edge.b - edge.a).norm();
  }
  return lengths;
}

/// Distance of a point of a support from the boundary of the true table, in the plane [m].
double distance_to_table(const Support& support, const Eigen::Vector2d& p_S) {
  const Eigen::Vector3d p = support.X_WS * Eigen::Vector3d(p_S.x(), p_S.y(), 0);
  Eigen::Matrix2Xd corners(2, 4);
  corners << -0.35, 0.35, 0.35, -0.35, -0.3, -0.3, 0.3, 0.3;
  return std::abs(geometry::Polygon(corners).depth(p.head<2>()));
}

void expect_real_edges_are_true(const Support& support, double tolerance = 0.008) {
  for (int i = 0; i < support.polygon.size(); ++i) {
    if (support.edges[i] != EdgeLabel::real) continue;
    const auto edge = support.polygon.edge(i);
    for (const double t : {0.1, 0.5, 0.9}) {
      EXPECT_LT(distance_to_table(support, edge.a + t * (edge.b - edge.a)), tolerance);
    }
  }
}

TEST(Perceive, FindsTheTableItsEdgesAndWhatLiesOnIt) {
  const Scene scene = perceive(
      {view_of({floor(), table(), on_table(kCard, -0.1, 0.1), on_table(kBox, 0.1, -0.1)}, eye())});
  ASSERT_TRUE(scene) << scene.reason;
  const Support* support = table_in(scene);
  ASSERT_NE(support, nullptr);
  EXPECT_NEAR(support->X_WS.translation().z(), 0.4, 4e-4);
  EXPECT_LT(std::acos(support->X_WS.linear()(2, 2)), 2e-3);
  EXPECT_NEAR(support->polygon.area(), 0.7 * 0.6, 0.01);
  EXPECT_NEAR(lengths_of(*support)[EdgeLabel::real], 2.6, 0.1);
  expect_real_edges_are_true(*support);
  ASSERT_EQ(scene.objects.size(), 2u);
  const Object &card = scene.objects[0], &box = scene.objects[1];
  EXPECT_EQ(card.name, "object_0");
  EXPECT_TRUE(card.is_flat);
  EXPECT_NEAR(card.thickness, 0.003, 5e-4);
  EXPECT_NEAR(card.outline.area(), 0.12 * 0.08, 0.1 * 0.12 * 0.08);
  EXPECT_LT((card.X_WO.translation() - Eigen::Vector3d(-0.1, 0.1, 0.4)).norm(), 0.003);
  EXPECT_NEAR(box.thickness, 0.1, 0.0015);
  EXPECT_LT((box.X_WO.translation() - Eigen::Vector3d(0.1, -0.1, 0.4)).norm(), 0.005);
}

TEST(Perceive, ThicknessIsWithinItsStandardErrors) {
  double squares = 0;
  constexpr int kTrials = 12;
  const View clean = view_of({floor(), table(), on_table({0.1, 0.1, 0.008}, 0, 0)}, eye(), 0);
  for (int i = 0; i < kTrials; ++i) {
    const Scene scene = perceive({with_noise(clean, 1, static_cast<std::uint64_t>(i))});
    ASSERT_EQ(scene.objects.size(), 1u);
    const Object& plate = scene.objects[0];
    squares += std::pow((plate.thickness - 0.008) / plate.thickness_error, 2) / kTrials;
    EXPECT_LT(plate.thickness_error, 0.0007);
  }
  EXPECT_LT(std::sqrt(squares), 2);
}

TEST(Perceive, SeesObjectsThatAreHigherThanTheCamera) {
  const std::vector<Body> bodies{floor(), table(), on_table({0.08, 0.08, 0.4}, 0.05, 0)};
  for (const double up : {0.2, 0.35, 0.41, 0.6}) {
    const View view = view_of(bodies, look_at({-0.9, 0, 0.4 + up}, {0, 0, 0.55}));
    const Scene scene = perceive({view});
    ASSERT_EQ(scene.objects.size(), 1u) << up;
    EXPECT_FALSE(scene.objects[0].touches_border) << up;
    EXPECT_NEAR(scene.objects[0].thickness, 0.4, 0.006) << up;
    double hidden = 0;  // behind it, up to its top
    for (const Unseen& unseen : scene.unseen)
      hidden = std::max(hidden, unseen.shape.vertices.row(2).maxCoeff());
    EXPECT_GT(hidden, up < 0.5 ? 0.78 : 0.7) << up;
  }
}

TEST(Perceive, TakesNoBackgroundForDepths) {
  const View clean = view_of({table(), on_table(kBox, 0.1, -0.1)}, eye());
  ASSERT_GT((clean.depth == 0).count(), clean.depth.size() / 10);
  const Scene expected = perceive({clean});
  for (const float far : {51.0f, 1000.0f, 65504.0f, 1e10f}) {
    View rendered = clean;
    rendered.depth = (clean.depth == 0).select(far, clean.depth);
    const Scene scene = perceive({rendered});
    ASSERT_EQ(scene.supports.size(), expected.supports.size()) << far;
    EXPECT_EQ(scene.supports[0].polygon.area(), expected.supports[0].polygon.area());
    ASSERT_EQ(scene.objects.size(), 1u) << far;
    EXPECT_EQ(scene.objects[0].thickness, expected.objects[0].thickness);
  }
}

/// Rounds depths to steps [m].
View rounded(View view, float step) {
  view.depth = (view.depth / step).round() * step;
  return view;
}

TEST(Perceive, StepsOfTheDepthsCountAsNoise) {
  // Where the plane falls by about a step from pixel to pixel, cells look smooth.
  const std::vector<Body> bodies{floor(), table(), on_table({0.1, 0.1, 0.02}, 0, 0)};
  for (const double up : {0.5, 0.6, 0.65, 0.7, 0.8}) {
    for (const float step : {0.001f, 0.002f}) {
      const auto seen = [&](double side) {
        return rounded(view_of(bodies, look_at({side * 0.7, 0.05, 0.4 + up}, {0, 0, 0.4}), 0),
                       step);
      };
      for (const auto& views : {std::vector{seen(-1)}, std::vector{seen(-1), seen(1)}}) {
        const Scene scene = perceive(views);
        ASSERT_NE(table_in(scene), nullptr) << up << ' ' << step;
        EXPECT_GT(table_in(scene)->noise, 0.25 * static_cast<double>(step));
        ASSERT_EQ(scene.objects.size(), 1u) << up << ' ' << step;
        EXPECT_NEAR(scene.objects[0].thickness, 0.02, 0.6 * static_cast<double>(step));
        EXPECT_NEAR(scene.objects[0].outline.area(), 0.01, 0.0015);
      }
    }
  }
  // Depths that are no multiples of a step have none.
  const Scene fine = perceive({view_of(bodies, eye(), 0.01)});
  ASSERT_NE(table_in(fine), nullptr);
  EXPECT_LT(table_in(fine)->noise, 1.5e-4);
}

TEST(Perceive, CornersOfATableAreWhereItsEdgesMeet) {
  Body turned = table();
  turned.X_WB.linear() = Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  std::vector<double> errors;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Scene scene =
        perceive({view_of({floor(), turned}, look_at({-0.8, 0.2, 1.3}, {0, 0, 0.4}), 1, seed)});
    const Support* support = table_in(scene);
    ASSERT_NE(support, nullptr);
    EXPECT_LE(support->polygon.size(), 8);  // 13 on average with a tolerance that ignores the noise
    for (const auto& [x, y] : {std::pair{0.35, 0.3}, {-0.35, 0.3}, {-0.35, -0.3}, {0.35, -0.3}}) {
      const Eigen::Vector3d corner = turned.X_WB * Eigen::Vector3d(x, y, 0.02);
      const Eigen::Vector2d at = (support->X_WS.inverse() * corner).head<2>();
      errors.push_back((support->polygon.vertices().colwise() - at).colwise().norm().minCoeff());
    }
  }
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.003);
  EXPECT_LT(errors[errors.size() * 9 / 10], 0.005);
  EXPECT_LT(errors.back(), 0.009);  // 8.1 mm among 240 corners
}

TEST(Perceive, AWallBehindATableIsNoPartOfIt) {
  // Where it crosses the height of the table, it is as high as the table.
  const Body wall = box_at({0.02, 2, 1.6}, {0.36, 0, 0.6});
  const Scene scene = perceive({view_of({floor(), table(), wall}, eye())});
  const Support* support = table_in(scene);
  ASSERT_NE(support, nullptr);
  EXPECT_NEAR(support->polygon.area(), 0.7 * 0.6, 0.02);
  auto lengths = lengths_of(*support);
  EXPECT_NEAR(lengths[EdgeLabel::real], 2, 0.1);
  // A piece of the wall as long as a strip is wide stays on either side: 0.68 to 0.74 m with
  // eight seeds.
  EXPECT_NEAR(lengths[EdgeLabel::occluded], 0.7, 0.05);
  expect_real_edges_are_true(*support, 0.015);
}

// Squares of a coarse image that hold the edges of boxes would tilt the plane by up to 2 mrad, and
// the middle of the table would be below it: 8 false edges.
TEST(Perceive, BoxesOnATableDoNotTiltItInACoarseImage) {
  const Camera coarse = camera_with_view(424, 240, 1.5);
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    std::mt19937_64 rng(seed);
    const auto draw = [&rng](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(rng);
    };
    std::vector<Body> bodies{floor(), box_at({1.2, 0.9, 0.04}, {0, 0, 0.38})};
    for (int i = 0; i < 8; ++i) {
      const double height = draw(0.01, 0.1);
      bodies.push_back(box_at({draw(0.05, 0.25), draw(0.05, 0.2), height},
                              {draw(-0.4, 0.4), draw(-0.3, 0.3), 0.4 + height / 2}));
    }
    const Eigen::Isometry3d X_WC = look_at({-1.1, 0.2, 1.4}, {0, 0, 0.4});
    const View clean{render(bodies, X_WC, coarse).depth, coarse.K, X_WC};
    const Support* support = nullptr;
    const Scene scene = perceive({with_noise(clean, 1, seed)});
    for (const Support& other : scene.supports) {
      if (std::abs(other.X_WS.translation().z() - 0.4) > 0.02) continue;
      if (!support || other.polygon.area() > support->polygon.area()) support = &other;
    }
    ASSERT_NE(support, nullptr);
    EXPECT_LT(std::acos(support->X_WS.linear()(2, 2)), 1.5e-3);
    const Eigen::Matrix2Xd& corners = support->polygon.vertices();
    EXPECT_GT(lengths_of(*support)[EdgeLabel::real], 3) << seed;
    for (Eigen::Index i = 0; i < corners.cols(); ++i) {
      if (support->edges[i] != EdgeLabel::real) continue;
      const Eigen::Vector2d middle = (corners.col(i) + corners.col((i + 1) % corners.cols())) / 2;
      const Eigen::Vector3d p = support->X_WS * Eigen::Vector3d(middle.x(), middle.y(), 0);
      EXPECT_GT(std::max(std::abs(p.x()) / 0.6, std::abs(p.y()) / 0.45), 0.93) << seed;
    }
  }
}

TEST(Perceive, ANarrowPieceOfTheFloorIsNoSupport) {
  // A frame of bars cuts a piece out of the floor that is narrower than a strip where a wall could
  // cross it, at this noise.
  std::vector<Body> bodies{floor(), table()};
  for (const double side : {-1, 1}) {
    bodies.push_back(box_at({0.04, 0.88, 0.1}, {-0.6 + 0.07 * side, 0, 0.05}));
    bodies.push_back(box_at({0.1, 0.04, 0.1}, {-0.6, 0.42 * side, 0.05}));
  }
  const Scene scene = perceive({view_of(bodies, look_at({-1.2, 0, 1.8}, {-0.3, 0, 0.2}), 4)});
  EXPECT_NE(table_in(scene), nullptr);
  EXPECT_EQ(scene.supports.size(), 2u);
}

TEST(Perceive, MovesWithTheWorld) {
  const std::vector<Body> bodies{floor(), table(), on_table(kCard, -0.1, 0.1)};
  View view = view_of(bodies, eye());
  const Scene before = perceive({view});
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = Eigen::AngleAxisd(2.1, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  X.translation() << 3, -1, 0.5;
  view.X_WC = X * view.X_WC;
  const Scene after = perceive({view});
  ASSERT_EQ(before.objects.size(), 1u);
  ASSERT_EQ(after.objects.size(), 1u);
  EXPECT_LT((after.objects[0].X_WO.translation() - X * before.objects[0].X_WO.translation()).norm(),
            1e-3);
  EXPECT_NEAR(after.objects[0].thickness, before.objects[0].thickness, 1e-4);
  EXPECT_NEAR(table_in(before)->polygon.area(), after.supports[1].polygon.area(), 2e-3);
}

TEST(Perceive, TheSameSeedGivesTheSameScene) {
  const View view = view_of({floor(), table(), on_table(kCard, 0, 0)}, eye());
  const Scene a = perceive({view}), b = perceive({view});
  ASSERT_EQ(a.objects.size(), b.objects.size());
  EXPECT_EQ(a.objects[0].outline.vertices(), b.objects[0].outline.vertices());
  EXPECT_EQ(a.supports[0].polygon.vertices(), b.supports[0].polygon.vertices());
}

TEST(Perceive, AnEdgeOutsideTheImageIsNotReal) {
  // The camera sees only the table's far part: the near edge is outside the image.
  const Scene scene =
      perceive({view_of({floor(), table()}, look_at({-0.5, 0, 0.9}, {0.1, 0, 0.4}))});
  const Support* support = table_in(scene);
  ASSERT_NE(support, nullptr);
  auto lengths = lengths_of(*support);
  EXPECT_GT(lengths[EdgeLabel::image_border], 0.5);
  EXPECT_GT(lengths[EdgeLabel::real], 1);
  expect_real_edges_are_true(*support);
  // Without any edge in the image none is real, and a warning says so.
  const Scene near = perceive({view_of({floor(), table()}, look_at({-0.2, 0, 0.75}, {0, 0, 0.4}))});
  ASSERT_NE(table_in(near), nullptr);
  EXPECT_EQ(lengths_of(*table_in(near)).count(EdgeLabel::real), 0u);
  ASSERT_EQ(near.warnings.size(), 1u);
  EXPECT_NE(near.warnings[0].find("no real edge"), std::string::npos);
}

TEST(Perceive, WhatTheLowerBorderCutsOffIsAnObjectWithAWarning) {
  // Most of what is seen of it is above places of the table that are not in the image.
  const Eigen::Isometry3d X_WC = look_at({-0.6, 0, 0.85}, {0, 0, 0.45});
  for (const double height : {0.2, 0.3}) {
    const Scene scene = perceive({view_of(
        {floor(), table(), on_table({0.08, 0.12, height}, -0.27, 0.1), on_table(kBox, 0, 0)},
        X_WC)});
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_NEAR(scene.objects[0].thickness, height, 0.01);
    EXPECT_NEAR(scene.objects[0].X_WO.translation().y(), 0.1, 0.02);
    ASSERT_FALSE(scene.objects[0].warnings.empty());
    EXPECT_NE(scene.objects[0].warnings[0].find("the image cuts it off"), std::string::npos);
  }
}

TEST(Perceive, AnEdgeBehindSomethingIsOccluded) {
  // A wall stands on the floor between the camera and the right half of the far edge, and a second
  // one against the left side.
  const Body wall = box_at({0.04, 0.3, 0.7}, {0.37, -0.15, 0.35});
  const Scene scene = perceive({view_of({floor(), table(), wall}, eye())});
  const Support* support = table_in(scene);
  ASSERT_NE(support, nullptr);
  auto lengths = lengths_of(*support);
  EXPECT_NEAR(lengths[EdgeLabel::occluded], 0.3, 0.06);
  EXPECT_NEAR(lengths[EdgeLabel::real], 2.3, 0.1);
  expect_real_edges_are_true(*support);
}

TEST(Perceive, TellsTheLeastThicknessThatItCouldSee) {
  const auto found = [](double thickness, double noise) {
    const Scene scene = perceive(
        {view_of({floor(), table(), on_table({0.12, 0.08, thickness}, 0, 0)}, eye(), noise)});
    return scene.objects.size();
  };
  const Scene quiet = perceive({view_of({floor(), table()}, eye(), 0.5)});
  const Scene loud = perceive({view_of({floor(), table()}, eye(), 3)});
  EXPECT_LT(table_in(quiet)->least_thickness, 0.0025);
  EXPECT_GT(table_in(loud)->least_thickness, 0.003);
  EXPECT_TRUE(quiet.objects.empty());
  EXPECT_TRUE(loud.objects.empty());
  EXPECT_EQ(found(1.2 * table_in(quiet)->least_thickness, 0.5), 1u);
  EXPECT_EQ(found(1.2 * table_in(loud)->least_thickness, 3), 1u);
  EXPECT_EQ(found(0.1 * table_in(loud)->least_thickness, 3), 0u);
  EXPECT_NEAR(table_in(quiet)->noise / table_in(loud)->noise, 0.5 / 3, 0.02);
}

TEST(Perceive, FindsShelvesTiltedTablesAndTwoTablesOfOneHeight) {
  const Scene shelf =
      perceive({view_of({floor(), table(), box_at({0.3, 0.6, 0.02}, {0.3, 0, 0.7}),
                         on_table(kCard, -0.2, 0.1), box_at({0.1, 0.1, 0.05}, {0.3, 0, 0.735})},
                        look_at({-0.6, 0, 1.4}, {0.1, 0, 0.4}))});
  ASSERT_EQ(shelf.supports.size(), 3u);
  ASSERT_EQ(shelf.objects.size(), 2u);
  EXPECT_NE(shelf.objects[0].support, shelf.objects[1].support);

  Body tilted = table();
  tilted.X_WB.linear() = Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const Scene slope = perceive({view_of({floor(), tilted}, eye())});
  ASSERT_TRUE(slope);
  const bool is_found = std::any_of(
      slope.supports.begin(), slope.supports.end(),
      [](const auto& s) { return std::abs(std::acos(s.X_WS.linear()(2, 2)) - 0.3) < 3e-3; });
  EXPECT_TRUE(is_found);

  const Scene two = perceive({view_of({floor(), box_at({0.5, 0.3, 0.04}, {0, 0.22, 0.38}),
                                       box_at({0.5, 0.3, 0.04}, {0, -0.22, 0.38})},
                                      eye())});
  int tables = 0;
  for (const Support& support : two.supports) {
    tables += std::abs(support.X_WS.translation().z() - 0.4) < 0.01;
  }
  EXPECT_EQ(tables, 2);
}

TEST(Perceive, ThingsBesideABoardAreFoundBelowItsTop) {
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    const Scene scene =
        perceive({view_of({floor(), table(), box_at({0.3, 0.3, 0.02}, {0.1, 0.1, 0.41}),
                           on_table({0.08, 0.05, 0.015}, -0.2, -0.2), on_table(kCard, 0.1, -0.2)},
                          look_at({-0.6, 0, 1.3}, {0, 0, 0.4}), 1, seed)});
    EXPECT_EQ(scene.supports.size(), 3u);  // floor, table, board
    std::vector<double> heights;
    for (const Object& object : scene.objects) {
      if (object.X_WO.translation().z() < 0.41) heights.push_back(object.thickness);
    }
    std::sort(heights.begin(), heights.end());
    ASSERT_EQ(heights.size(), 2u) << scene.reason;
    EXPECT_NEAR(heights[0], 0.003, 0.001);
    EXPECT_NEAR(heights[1], 0.015, 0.002);
  }
}

TEST(Perceive, ThingsCloseToABoardKeepTheirPixels) {
  const Body board = box_at({0.3, 0.3, 0.02}, {0.1, 0.1, 0.41});
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    const auto seen = [&](const std::vector<Body>& bodies) {
      return perceive({view_of(bodies, look_at({-0.6, 0, 1.3}, {0, 0, 0.4}), 1, seed)});
    };
    const Eigen::Vector2d center(-0.05 - 0.015 - 0.025, 0.1);
    const Scene scene =
        seen({floor(), table(), board, on_table({0.05, 0.08, 0.015}, center.x(), center.y())});
    ASSERT_EQ(scene.objects.size(), 1u) << scene.reason;
    EXPECT_LT((scene.objects[0].X_WO.translation().head<2>() - center).norm(), 0.004);
    EXPECT_TRUE(seen({floor(), table(), board}).objects.empty());  // its sides are none
  }
}

TEST(Perceive, AViewFromBelowTellsNothingOfWhereATableEnds) {
  const Eigen::Isometry3d beside = look_at({-0.7, 0.5, 0.75}, {-0.1, 0.3, 0.4});
  const View above = view_of({floor(), table()}, beside),
             below = view_of({floor(), table()}, look_at({-0.9, 0, 0.2}, {0, 0, 0.3}));
  for (const auto& views : {std::vector<View>{above}, std::vector<View>{above, below}}) {
    const Scene scene = perceive(views);
    const Support* support = table_in(scene);
    ASSERT_NE(support, nullptr);
    EXPECT_LT(lengths_of(*support)[EdgeLabel::real], 2.0);  // the image ends across the table
    expect_real_edges_are_true(*support);
  }
}

TEST(Perceive, ACameraOnItsSideSeesAsMuch) {
  Eigen::Isometry3d X_WC = look_at({-0.95, 0, 0.65}, {0, 0, 0.4});
  for (int turn = 0; turn < 4; ++turn) {
    const Scene scene =
        perceive({view_of({floor(), table(), on_table({0.2, 0.15, 0.05}, 0.1, 0)}, X_WC)});
    EXPECT_EQ(scene.objects.size(), 1u) << turn << ": " << scene.reason;
    X_WC.linear() *= Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  }
}

TEST(Perceive, ATopThatManyViewsSeeHidesNoTable) {
  const std::vector<Body> bodies{floor(), table(), on_table({0.24, 0.24, 0.1}, 0, 0)};
  std::vector<View> views;
  for (int i = 0; i < 4; ++i) {
    View view = view_of(bodies, eye(), 1, static_cast<std::uint64_t>(i));
    for (int v = 0; v < view.depth.rows(); ++v) {
      for (int u = 0; u < view.depth.cols(); ++u) {
        const Eigen::Vector3d ray = view.K.inverse() * Eigen::Vector3d(u, v, 1);
        const Eigen::Vector3d p = view.X_WC * (ray * static_cast<double>(view.depth(v, u)));
        if (p.z() < 0.45 && (i > 0 || p.x() > -0.05)) view.depth(v, u) = 0;
      }
    }
    views.push_back(view);
  }
  const Scene scene = perceive(views);
  EXPECT_NE(table_in(scene), nullptr) << scene.reason;
}

TEST(Perceive, WhatIsUnknownAroundAnObjectIsNotWhereTheObjectIs) {
  View view = view_of({floor(), table(), on_table({0.08, 0.08, 0.05}, 0, 0)},
                      look_at({0, 0.001, 1.2}, {0, 0, 0.4}));
  for (int v = 0; v < view.depth.rows(); ++v) {
    for (int u = 0; u < view.depth.cols(); ++u) {
      const Eigen::Vector3d ray = view.X_WC.linear() * view.K.inverse() * Eigen::Vector3d(u, v, 1);
      const double z = (0.4 - view.X_WC.translation().z()) / ray.z();
      const Eigen::Vector3d p = view.X_WC * (view.X_WC.linear().transpose() * ray * z);
      const double radius = p.head<2>().lpNorm<Eigen::Infinity>();
      if (radius > 0.08 && radius < 0.12) view.depth(v, u) = 0;
    }
  }
  const Scene scene = perceive({view});
  ASSERT_EQ(scene.objects.size(), 1u) << scene.reason;
  const Eigen::Vector3d middle = scene.objects[0].X_WO.translation();
  int patches = 0;
  for (const Unseen& space : scene.unseen) {
    if (!space.behind.empty()) continue;
    ++patches;
    const Eigen::Vector3d least = space.shape.vertices.rowwise().minCoeff(),
                          most = space.shape.vertices.rowwise().maxCoeff();
    EXPECT_TRUE(((middle - least).head<2>().array() < 0).any() ||
                ((most - middle).head<2>().array() < 0).any());
  }
  EXPECT_GT(patches, 0);
}

TEST(Perceive, TheRestOfABoardBehindABoxIsNoObject) {
  const Scene scene = perceive({view_of({floor(), table(), box_at({0.4, 0.3, 0.02}, {0, 0, 0.41}),
                                         box_at({0.06, 0.3, 0.1}, {0.08, 0, 0.47})},
                                        look_at({-0.6, 0, 1.1}, {0, 0, 0.4}))});
  int boxes = 0;
  for (const Object& object : scene.objects) {
    boxes += object.thickness > 0.08;
    EXPECT_FALSE(object.X_WO.translation().z() < 0.41 && object.thickness < 0.03)
        << object.X_WO.translation().transpose() << ", " << object.thickness << " m high";
  }
  EXPECT_EQ(boxes, 1);
}

TEST(Perceive, BoxesOfOneHeightThatAreNoSupportAreObjects) {
  const auto box = [](double x, double y) { return on_table({0.16, 0.16, 0.05}, x, y); };
  const Scene scene =
      perceive({view_of({floor(), table(), box(0.15, 0.15), box(-0.15, 0.15), box(0, -0.15)},
                        look_at({-0.6, 0, 1.3}, {0, 0, 0.4}))});
  ASSERT_EQ(scene.objects.size(), 3u) << scene.reason;
  for (const Object& object : scene.objects) EXPECT_NEAR(object.thickness, 0.05, 0.003);
}

TEST(Perceive, WedgesBelowACameraAreAroundTheBoxTheyBelongTo) {
  for (const double aside : {0.0, 0.042}) {
    const Scene scene = perceive({view_of({floor(), table(), on_table({0.08, 0.08, 0.1}, aside, 0)},
                                          look_at({0, 0.001, 1.0}, {0, 0, 0.4}))});
    ASSERT_EQ(scene.objects.size(), 1u);
    for (const Unseen& space : scene.unseen) {
      if (space.behind.empty()) continue;
      const Eigen::Vector3d size =
          space.shape.vertices.rowwise().maxCoeff() - space.shape.vertices.rowwise().minCoeff();
      EXPECT_LT(size.head<2>().maxCoeff(), 0.12);
    }
  }
}

TEST(Perceive, TwoViewsSeeMoreThanOne) {
  const std::vector<Body> bodies{floor(), table(), on_table(kBox, 0, 0)};
  const View front = view_of(bodies, eye());
  const View back = view_of(bodies, look_at({0.7, 0.1, 1.05}, {0, 0, 0.4}), 1, 2);
  const Scene one = perceive({front}), both = perceive({front, back});
  ASSERT_EQ(one.objects.size(), 1u);
  ASSERT_EQ(both.objects.size(), 1u);
  const auto volume = [](const Scene& scene) {
    double sum = 0;
    for (const Unseen& unseen : scene.unseen) {
      const geometry::Mesh hull = geometry::convex_hull(unseen.shape.vertices);
      for (const auto& t : hull.triangles.colwise()) {
        const Eigen::Vector3d a = hull.vertices.col(t[0]), b = hull.vertices.col(t[1]);
        sum += a.cross(b).dot(hull.vertices.col(t[2])) / 6;
      }
    }
    return sum;
  };
  EXPECT_GT(volume(one), 0);
  EXPECT_LT(volume(both), volume(one));
  EXPECT_NEAR(both.objects[0].outline.area(), 0.06 * 0.08, 0.2 * 0.06 * 0.08);
}

TEST(Perceive, UnseenSpaceIsBehindTheObjectAndHoldsNoPointThatWasSeen) {
  const std::vector<Body> bodies{floor(), table(), on_table(kBox, 0, 0)};
  const Scene scene = perceive({view_of(bodies, eye(), 0)});
  ASSERT_FALSE(scene.unseen.empty());
  for (const Unseen& unseen : scene.unseen) {
    EXPECT_EQ(unseen.behind, "object_0");
    EXPECT_GT(unseen.shape.vertices.row(0).minCoeff(), 0.02);  // the camera is at negative x
    // The middle of a wedge is hidden: the box is in front of it.
    const Eigen::Vector3d middle = unseen.shape.vertices.rowwise().mean();
    const Eigen::Vector3d uvw = Camera{}.K * (eye().inverse() * middle);
    const Rendering seen = render(bodies, eye());
    const float z = seen.depth(static_cast<int>(uvw.y() / uvw.z() + 0.5),
                               static_cast<int>(uvw.x() / uvw.z() + 0.5));
    EXPECT_LT(static_cast<double>(z), uvw.z());
  }
}

TEST(Perceive, BadDepthsAreAStatusWithAReason) {
  const View good = view_of({floor(), table()}, eye());
  const auto status_of = [](const View& view) {
    const Scene scene = perceive({view});
    EXPECT_FALSE(scene.reason.empty());
    return scene.status;
  };
  View bad = good;
  bad.depth *= 1000;
  EXPECT_EQ(status_of(bad), Status::not_metres);
  bad.depth.setZero();
  EXPECT_EQ(status_of(bad), Status::no_depth);
  bad.depth.setConstant(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(status_of(bad), Status::no_depth);
  bad.depth.setConstant(std::numeric_limits<float>::infinity());
  EXPECT_EQ(status_of(bad), Status::no_depth);
  bad.depth.setConstant(-1);
  EXPECT_EQ(status_of(bad), Status::no_depth);
  bad = good;  // a wall
  bad.X_WC = look_at({-1, 0, 0.5}, {0, 0, 0.5});
  bad.depth.setConstant(1);
  EXPECT_EQ(status_of(bad), Status::no_support);
  bad = good;  // z up instead of down: the table hangs over the camera
  bad.X_WC.linear() = good.X_WC.linear() * Eigen::Vector3d(1, -1, -1).asDiagonal();
  EXPECT_EQ(status_of(bad), Status::camera_below);
  std::mt19937_64 rng(3);
  for (Eigen::Index i = 0; i < bad.depth.size(); ++i) {
    bad.depth.data()[i] = 0.3f + static_cast<float>(rng() % 1000) / 500;
  }
  EXPECT_EQ(status_of(bad), Status::no_support);
}

TEST(Perceive, WarnsOfWhatMayBeWrong) {
  const auto warned = [](const Scene& scene, const std::string& words) {
    for (const auto& text : scene.warnings) {
      if (text.find(words) != std::string::npos) return true;
    }
    for (const Object& object : scene.objects) {
      for (const auto& text : object.warnings) {
        if (text.find(words) != std::string::npos) return true;
      }
    }
    return false;
  };
  const std::vector<Body> bodies{floor(), table(), on_table(kBox, 0, 0)};
  const View good = view_of(bodies, eye());
  const Scene fine = perceive({good});
  EXPECT_TRUE(fine.warnings.empty());
  ASSERT_EQ(fine.objects.size(), 1u);
  EXPECT_TRUE(fine.objects[0].warnings.empty());
  EXPECT_TRUE(warned(perceive({view_of(bodies, eye(), 4)}), "times as noisy"));
  View wrong = good;  // the K of another lens
  wrong.K(1, 1) *= 1.4;
  EXPECT_TRUE(warned(perceive({wrong}), "if it is level, X_WC or K is wrong"));
  View glass = good;
  glass.depth.block(300, 250, 40, 40).setZero();
  const Scene unseen = perceive({glass});
  EXPECT_TRUE(warned(unseen, "as under glass"));
  EXPECT_TRUE(std::any_of(unseen.unseen.begin(), unseen.unseen.end(),
                          [](const Unseen& u) { return u.behind.empty(); }));
  const Scene cut = perceive({view_of(bodies, look_at({-0.5, 0.36, 0.9}, {0, 0.36, 0.4}))});
  EXPECT_TRUE(warned(cut, "cuts it off"));
  const Scene stacked = perceive({view_of(
      {floor(), table(), on_table({0.2, 0.2, 0.03}, 0, 0), box_at({0.1, 0.1, 0.04}, {0, 0, 0.45})},
      eye())});
  EXPECT_TRUE(warned(stacked, "one on top of another"));
  Options low;
  low.max_height = 0.08;
  const Scene high = perceive({good}, low);
  EXPECT_TRUE(warned(high, " reaches 0.1"));
  EXPECT_TRUE(warned(high, "raise max_height"));
}

TEST(Perceive, LargeImagesAreThinnedAndSaySo) {
  const Camera camera = camera_with_view(1600, 1200, 1.0471975511965976);
  const std::vector<Body> bodies{floor(), table(), on_table(kBox, 0, 0)};
  const View large{render(bodies, eye(), camera).depth, camera.K, eye()};
  const Scene scene = perceive({large});
  ASSERT_EQ(scene.objects.size(), 1u);
  EXPECT_NEAR(scene.objects[0].thickness, 0.1, 0.001);
  EXPECT_LT((scene.objects[0].X_WO.translation() - Eigen::Vector3d(0, 0, 0.4)).norm(), 0.006);
  ASSERT_FALSE(scene.warnings.empty());
  EXPECT_NE(scene.warnings[0].find("one of 2 rows"), std::string::npos);
}

TEST(Perceive, ReadsCommonImagesWhole) {
  const Camera camera = camera_with_view(848, 480, 1.2042771838760873);
  const View view{render({floor(), table()}, eye(), camera).depth, camera.K, eye()};
  EXPECT_TRUE(perceive({view}).warnings.empty());
}

TEST(Perceive, RefusesACallersMistakesByName) {
  const View good = view_of({table()}, eye());
  expect_refused([&] { perceive({}); }, "views must have at least one view");
  View bad = good;
  bad.K(0, 0) = -1;
  expect_refused([&] { perceive({bad}); }, "K's horizontal focal length is -1");
  expect_refused([&] { perceive({good, bad}); }, "views[1]: K's");
  bad = good;
  bad.K(0, 2) = 960;
  expect_refused([&] { perceive({bad}); }, "another resolution");
  bad = good;
  bad.X_WC.translation().x() = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { perceive({bad}); }, "X_WC");
  bad = good;
  bad.depth.resize(4, 4);
  expect_refused([&] { perceive({bad}); }, "width is 4");
  Options options;
  options.min_thickness = 0;
  expect_refused([&] { perceive({good}, options); }, "options.min_thickness");
}

}  // namespace
}  // namespace graspless::perception
