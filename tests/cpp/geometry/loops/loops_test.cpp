// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/loops.hpp"

#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "graspless/geometry/linking.hpp"

#include "complaint.hpp"
#include "geometry/clouds.hpp"

namespace graspless::geometry {
namespace {

/// A ring of radius 0.1 m, 24 mm thick, about 500 points.
const Eigen::Matrix3Xd& ring() {
  static const Eigen::Matrix3Xd cloud = noisy(torus(0.1, 0.012, 0.01), 0.0005, 1);
  return cloud;
}

/// A closed curve through the ring's hole.
Eigen::Matrix3Xd through_ring() {
  Eigen::Matrix3Xd curve(3, 4);
  curve << 0, 0, 1, 1, 0, 0, 0, 0, -1, 1, 1, -1;
  return curve;
}

/// Consecutive corners are edges of K_d, the length is theirs, vertices are columns of the cloud.
void expect_consistent(const Loops& found, const Eigen::Matrix3Xd& cloud) {
  for (const Loop& loop : found.found) {
    ASSERT_EQ(loop.points.cols(), static_cast<Eigen::Index>(loop.vertices.size()));
    ASSERT_GE(loop.points.cols(), 3);
    double length = 0;
    for (Eigen::Index i = 0; i < loop.points.cols(); ++i) {
      EXPECT_EQ(loop.points.col(i), cloud.col(loop.vertices[i]));
      const double step =
          (loop.points.col(i) - loop.points.col((i + 1) % loop.points.cols())).norm();
      EXPECT_LT(step, loop.max_edge_length);
      length += step;
    }
    EXPECT_NEAR(loop.length, length, 1e-12);
    EXPECT_LT(loop.birth, loop.max_edge_length);
    EXPECT_GE(loop.death, loop.max_edge_length);
    EXPECT_TRUE(loop.thickness > 0 || found.noise > 0);  // unknown in sparse clouds
  }
  const auto shorter = [](const Loop& a, const Loop& b) { return a.length < b.length; };
  EXPECT_TRUE(std::is_sorted(found.found.begin(), found.found.end(), shorter));
}

/// The wall of a cup without a handle, 80 mm wide and 90 mm high, its floor, or none: a pipe.
Eigen::Matrix3Xd cup(bool has_floor) {
  const double spacing = 0.007, radius = 0.04;
  std::vector<Eigen::Vector3d> points;
  const auto add_circle = [&](double r, double z) {
    const int n = std::max(1, static_cast<int>(2 * M_PI * r / spacing));
    for (int i = 0; i < n; ++i) {
      const double a = 2 * M_PI * (i + 60 * z) / n;
      points.emplace_back(r * std::cos(a), r * std::sin(a), z);
    }
  };
  for (double z = 0; z < 0.09; z += spacing) add_circle(radius, z);
  for (double r = radius - spacing; has_floor && r > 0; r -= spacing) add_circle(r, 0);
  const auto n = static_cast<Eigen::Index>(points.size());
  return noisy(Eigen::Map<Eigen::Matrix3Xd>(points[0].data(), 3, n), 0.0004, 1);
}

bool has_warning(const Loops& found, const std::string& words) {
  return std::any_of(found.warnings.begin(), found.warnings.end(), [&](const std::string& warning) {
    return warning.find(words) != std::string::npos;
  });
}

TEST(ShortestLoops, RunThroughTheRing) {
  const Loops found = shortest_loops(ring());
  ASSERT_EQ(found.status, LoopStatus::found) << found.reason;
  ASSERT_EQ(found.found.size(), 1u);
  expect_consistent(found, ring());
  const Loop& loop = found.found[0];
  EXPECT_EQ(std::abs(linking_number(loop.points, through_ring())), 1);
  EXPECT_GT(loop.length, 2 * M_PI * 0.088 * 0.97);  // the inner circle is the shortest
  EXPECT_LT(loop.length, 2 * M_PI * 0.1);
  EXPECT_GT(loop.death / loop.birth, 4);
  EXPECT_EQ(found.plateau.loops, 1);
  EXPECT_GT(found.complex.max_edge_length, found.plateau.lower);
  EXPECT_LT(found.complex.max_edge_length, found.plateau.upper);
  EXPECT_TRUE(found.warnings.empty());
  EXPECT_NE(found.reason.find("1 loop at max_edge_length"), std::string::npos) << found.reason;
}

TEST(ShortestLoops, AreAsManyAsTheHoles) {
  const Eigen::Matrix3Xd other = moved(ring(), {0.23, 0.003, 0.002});
  EXPECT_EQ(shortest_loops(side_by_side({ring(), other})).found.size(), 2u);
  EXPECT_EQ(shortest_loops(noisy(ring(), 0.003, 4)).found.size(), 1u);
  EXPECT_EQ(shortest_loops(sphere_cloud(0.1, 600)).status, LoopStatus::no_reliable_hole);
}

TEST(ShortestLoops, GiveTheSurfaceOfAnObjectWithoutHoles) {
  const Loops ball = shortest_loops(sphere_cloud(0.1, 600));
  const Eigen::Matrix3Xd& points = ball.surface.points;
  std::set<int> corners;
  for (const auto& triangle : ball.surface.triangles.colwise()) {
    corners.insert(triangle.begin(), triangle.end());
    for (int i = 0; i < 3; ++i) {  // sqrt(4 pi / 600) of the radius is the distance of neighbours
      const auto side = points.col(triangle[i]) - points.col(triangle[(i + 1) % 3]);
      EXPECT_LT(side.norm(), 4 * 0.0145);
    }
  }
  EXPECT_EQ(corners.size(), 600u);
}

TEST(ShortestLoops, OfACupNeedAHandle) {
  EXPECT_EQ(shortest_loops(cup(true)).status, LoopStatus::no_reliable_hole);
  const Loops pipe = shortest_loops(cup(false));
  EXPECT_EQ(pipe.found.size() + pipe.meridians.size(), 1u) << pipe.reason;
}

TEST(ShortestLoops, DoNotDependOnOrder) {
  std::vector<int> order(ring().cols());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(3));
  const Eigen::Matrix3Xd shuffled = ring()(Eigen::all, order);
  const Loop one = shortest_loops(ring()).found.at(0), other = shortest_loops(shuffled).found.at(0);
  EXPECT_NEAR(one.length, other.length, 1e-12);
  EXPECT_EQ(one.death, other.death);
  std::set<int> vertices;
  for (const int v : other.vertices) vertices.insert(order[v]);
  EXPECT_EQ(vertices, std::set<int>(one.vertices.begin(), one.vertices.end()));
}

TEST(ShortestLoops, OfAThinnedCloudAreNearlyThose) {
  const Eigen::Matrix3Xd dense = noisy(torus(0.1, 0.012, 0.0025), 0.0002, 2);
  LoopOptions options;
  options.max_points = 3000;
  ASSERT_GT(dense.cols(), 6000);
  const Loops thinned = shortest_loops(dense, options);
  ASSERT_EQ(thinned.found.size(), 1u) << thinned.reason;
  EXPECT_LT(thinned.complex.points.cols(), 1800);
  EXPECT_GT(thinned.complex.points.cols(), 1200);
  expect_consistent(thinned, dense);

  options.polish = true;
  const Loops polished = shortest_loops(dense, options);
  ASSERT_EQ(polished.found.size(), 1u);
  expect_consistent(polished, dense);
  EXPECT_LE(polished.found[0].length, thinned.found[0].length);
  EXPECT_LT(thinned.found[0].length, 1.03 * polished.found[0].length);
  EXPECT_EQ(std::abs(linking_number(polished.found[0].points, through_ring())), 1);
}

TEST(ShortestLoops, PolishNeverMakesALoopLonger) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Eigen::Matrix3Xd cloud = noisy(torus(0.15, 0.012, 0.006), 0.002, seed);
    LoopOptions options;
    options.max_points = 500;
    const Loops before = shortest_loops(cloud, options);
    options.polish = true;
    const Loops after = shortest_loops(cloud, options);
    ASSERT_EQ(after.found.size(), before.found.size());
    for (std::size_t i = 0; i < after.found.size(); ++i) {
      EXPECT_LE(after.found[i].length, before.found[i].length);
    }
  }
}

TEST(ShortestLoops, RefuseToPolishAHugeCloud) {
  const Eigen::Matrix3Xd huge = Eigen::Matrix3Xd::Zero(3, 1000001);
  LoopOptions options;
  options.polish = true;
  expect_refused([&] { shortest_loops(huge, options); },
                 "points must be at most 1000000 for polish, not 1000001");
}

TEST(ShortestLoops, TakeTheEdgeLengthGiven) {
  LoopOptions options;
  options.max_edge_length = 0.05;
  const Loops found = shortest_loops(ring(), options);
  ASSERT_EQ(found.found.size(), 1u);
  EXPECT_EQ(found.complex.max_edge_length, 0.05);
  EXPECT_EQ(found.plateau.loops, 0);
  expect_consistent(found, ring());
}

TEST(ShortestLoops, SayWhyThereAreNone) {
  LoopOptions options;
  const auto reason = [&](double d) {
    options.max_edge_length = d;
    const Loops found = shortest_loops(ring(), options);
    EXPECT_EQ(found.status, LoopStatus::no_reliable_hole);
    EXPECT_TRUE(found.found.empty());
    EXPECT_FALSE(found.betti.loops.empty());
    return found.reason;
  };
  EXPECT_NE(reason(1e-4).find("is too small: no two points are closer"), std::string::npos);
  const double first_loop = Filtration(ring()).betti().max_edge_length[0];
  EXPECT_NE(reason(first_loop).find("is too small: the points do not form a loop"),
            std::string::npos);
  EXPECT_NE(reason(0.5).find("is too large: every hole is filled; a hole exists from"),
            std::string::npos);

  const Loops ball = shortest_loops(sphere_cloud(0.1, 600));
  EXPECT_EQ(ball.reason, "every loop is a gap between points");
  EXPECT_FALSE(ball.betti.loops.empty());
  EXPECT_EQ(ball.complex.edges.cols(), 0);
}

TEST(ShortestLoops, WarnOfGapsBetweenPoints) {
  LoopOptions options;
  options.max_edge_length = 0.0112;
  const Loops found = shortest_loops(ring(), options);
  EXPECT_GT(found.noise, 64);
  expect_consistent(found, ring());
  EXPECT_TRUE(has_warning(found, "may be too small"));
}

TEST(ShortestLoops, WarnOfMillimetresAndEqualPoints) {
  EXPECT_TRUE(has_warning(shortest_loops(1000 * ring()), "looks like millimetres"));
  const Loops twice = shortest_loops(side_by_side({ring(), ring()}));
  EXPECT_TRUE(has_warning(twice, "equal others; equal points count once"));
  ASSERT_EQ(twice.found.size(), 1u);
  EXPECT_NEAR(twice.found[0].length, shortest_loops(ring()).found[0].length, 1e-12);
}

TEST(ShortestLoops, DoNotTakeAWindowInASolidForAHole) {
  // A window in the ring's outer side, three spacings wide.
  std::vector<int> kept;
  for (int i = 0; i < ring().cols(); ++i) {
    if ((ring().col(i) - Eigen::Vector3d(0.112, 0, 0)).norm() > 0.022) kept.push_back(i);
  }
  EXPECT_EQ(shortest_loops(ring()(Eigen::all, kept)).found.size(), 1u);
}

TEST(ShortestLoops, OfManySizesAreAllFound) {
  // Widths of the holes: from 5 to 57 times the distance of neighbours.
  const Eigen::Matrix3Xd rings = side_by_side(
      {torus(0.04, 0.012, 0.01), moved(torus(0.08, 0.012, 0.01), {0.18, 0, 0}),
       moved(torus(0.16, 0.012, 0.01), {0.48, 0, 0}), moved(torus(0.3, 0.012, 0.01), {1, 0, 0})});
  for (const double deviation : {0.0005, 0.003}) {
    const Eigen::Matrix3Xd cloud = noisy(rings, deviation, 1);
    const Loops found = shortest_loops(cloud);
    ASSERT_EQ(found.found.size(), 4u) << found.reason;
    expect_consistent(found, cloud);
    for (const Loop& loop : found.found) EXPECT_LT(loop.length, 45 * loop.death);
    EXPECT_GT(found.found.back().length, 6 * found.found.front().length);
  }
}

TEST(ShortestLoops, OfDenseAndSparsePartsAreAllFound) {
  const Eigen::Matrix3Xd cloud =
      side_by_side({torus(0.1, 0.012, 0.004), moved(torus(0.1, 0.012, 0.014), {0.4, 0, 0}),
                    moved(sphere_cloud(0.1, 300), {0.8, 0, 0})});
  const Loops found = shortest_loops(cloud);
  EXPECT_EQ(found.found.size(), 2u) << found.reason;
}

/// An arc of a ring.
Eigen::Matrix3Xd open_ring(double gap) {
  const Eigen::Matrix3Xd whole = torus(0.1, 0.012, 0.008);
  std::vector<int> kept;
  for (int i = 0; i < whole.cols(); ++i) {
    if (std::abs(std::atan2(whole(1, i), whole(0, i))) > gap / 2) kept.push_back(i);
  }
  return whole(Eigen::all, kept);
}

TEST(ShortestLoops, AcrossAGapAreUncertain) {
  for (const double gap : {0.3, 0.8}) {
    const Loops found = shortest_loops(noisy(open_ring(gap), 0.001, 1));
    EXPECT_EQ(found.status, LoopStatus::no_reliable_hole) << found.reason;
    EXPECT_TRUE(found.found.empty());
    const auto is_across = [](const Loop& loop) {
      return loop.jump > 1.5 && loop.reason.find("it closes across a gap of") == 0;
    };
    EXPECT_EQ(std::count_if(found.uncertain.begin(), found.uncertain.end(), is_across), 1);
    EXPECT_NE(found.reason.find("uncertain loop"), std::string::npos) << found.reason;
  }
}

TEST(ShortestLoops, OfRandomPointsAreGaps) {
  LoopOptions options;
  options.max_edge_length = 0.12;
  const Eigen::Matrix3Xd cloud = random_cloud(2000, 1);
  const Loops found = shortest_loops(cloud, options);
  const auto listed = found.found.size() + found.uncertain.size() + found.meridians.size();
  int alive = 0;
  const Filtration filtration(cloud);
  for (const auto& pair : filtration.persistence())
    alive += pair.birth < 0.12 && 0.12 <= pair.death;
  EXPECT_EQ(found.noise + static_cast<int>(listed), alive);
  EXPECT_TRUE(found.found.empty());
  EXPECT_TRUE(has_warning(found, "are gaps between points"));
}

TEST(ShortestLoops, RefuseBadClouds) {
  const auto call = [](const Eigen::Matrix3Xd& points) {
    return [points] { shortest_loops(points); };
  };
  Eigen::Matrix3Xd nan = random_cloud(50, 1);
  nan(2, 5) = std::numeric_limits<double>::quiet_NaN();
  Eigen::Matrix3Xd flat = random_cloud(50, 1);
  flat.row(0).setConstant(0.3);
  expect_refused(call(Eigen::Matrix3Xd(3, 0)), "distinct points, not 0");
  expect_refused(call(random_cloud(19, 1)), "at least 20 distinct points, not 19");
  expect_refused(call(Eigen::Matrix3Xd::Ones(3, 100)), "distinct points, not 1");
  expect_refused(call(Eigen::Matrix3Xd::Ones(3, 9000)), "distinct points, not 1");  // thinned
  expect_refused(call(nan), "point 5");
  expect_refused(call(flat), "lie in a plane");
  const Eigen::Matrix3Xd many(3, 10000001);  // never touched
  expect_refused([&] { shortest_loops(many); }, "at most 10000000, not 10000001");
}

TEST(ShortestLoops, RefuseBadOptions) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [](auto member, auto value) {
    return [=] {
      LoopOptions options;
      options.*member = value;
      shortest_loops(ring(), options);
    };
  };
  expect_refused(with(&LoopOptions::max_edge_length, -1.0), "max_edge_length must be in [0");
  expect_refused(with(&LoopOptions::max_edge_length, nan), "max_edge_length");
  expect_refused(with(&LoopOptions::min_ratio, 1.0), "min_ratio must be greater than 1");
  expect_refused(with(&LoopOptions::min_ratio, nan), "min_ratio");
  expect_refused(with(&LoopOptions::max_points, 3), "max_points must be in [100, 1000000], not 3");
  expect_refused(with(&LoopOptions::max_points, 2000000), "[100, 1000000], not 2000000");
}

}  // namespace
}  // namespace graspless::geometry
