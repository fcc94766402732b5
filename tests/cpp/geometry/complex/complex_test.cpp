// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/complex.hpp"

#include <limits>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "geometry/clouds.hpp"

namespace graspless::geometry {
namespace {

/// Sums over Z_2 of rows, as sets.
using Row = std::set<int>;

void toggle(Row& row, int column) {
  if (!row.insert(column).second) row.erase(column);
}

/// The columns in which the rows begin once they are reduced, in the order of the rows; -1 for a
/// row that is a sum of rows before it.
std::vector<int> pivots(std::vector<Row> rows) {
  std::map<int, Row> by_pivot;
  std::vector<int> result;
  for (Row& row : rows) {
    while (!row.empty() && by_pivot.count(*row.rbegin()) > 0) {
      for (int column : Row(by_pivot[*row.rbegin()])) toggle(row, column);
    }
    result.push_back(row.empty() ? -1 : *row.rbegin());
    if (!row.empty()) by_pivot[*row.rbegin()] = row;
  }
  return result;
}

int rank(const std::vector<Row>& rows) {
  const auto found = pivots(rows);
  return static_cast<int>(found.size() -
                          static_cast<std::size_t>(std::count(found.begin(), found.end(), -1)));
}

/// The dimension of H_1 by the ranks of the boundary matrices.
int betti_1(const Complex& complex) {
  std::vector<Row> edges, triangles;
  std::map<std::pair<int, int>, int> index;
  for (const auto& e : complex.edges.colwise()) {
    index[{e[0], e[1]}] = static_cast<int>(edges.size());
    edges.push_back({e[0], e[1]});
  }
  for (const auto& t : complex.triangles.colwise()) {
    triangles.push_back({index.at({t[0], t[1]}), index.at({t[0], t[2]}), index.at({t[1], t[2]})});
  }
  return static_cast<int>(edges.size()) - rank(edges) - rank(triangles);
}

int betti_at(const BettiCurve& curve, double d) {
  int loops = 0;
  for (std::size_t i = 0; i < curve.loops.size(); ++i) {
    if (curve.max_edge_length[i] < d) loops = curve.loops[i];
  }
  return loops;
}

double length(const Complex& complex, Eigen::Index edge) {
  return (complex.points.col(complex.edges(0, edge)) - complex.points.col(complex.edges(1, edge)))
      .norm();
}

/// Every textbook step: simplices by length, then the standard reduction.
std::vector<std::pair<double, double>> textbook(const Filtration& filtration) {
  const Complex all = filtration.complex(1e9);
  std::vector<std::pair<double, Eigen::Index>> order;
  for (Eigen::Index e = 0; e < all.edges.cols(); ++e) order.emplace_back(length(all, e), e);
  std::sort(order.begin(), order.end());
  std::map<std::pair<int, int>, int> place;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto e = all.edges.col(order[i].second);
    place[{e[0], e[1]}] = static_cast<int>(i);
  }
  std::vector<Row> rows;
  for (const auto& t : all.triangles.colwise()) {
    rows.push_back({place.at({t[0], t[1]}), place.at({t[0], t[2]}), place.at({t[1], t[2]})});
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return *a.rbegin() < *b.rbegin(); });
  const auto born = pivots(rows);
  std::vector<std::pair<double, double>> pairs;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (born[i] < 0) continue;
    const double birth = order[born[i]].first;
    const double death = order[*rows[i].rbegin()].first;
    if (birth < death) pairs.emplace_back(birth, death);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<std::pair<double, double>> sorted_pairs(const Filtration& filtration) {
  std::vector<std::pair<double, double>> pairs;
  for (const auto& pair : filtration.persistence()) pairs.emplace_back(pair.birth, pair.death);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(Filtration, BettiCurveIsThatOfTheBoundaryMatrices) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Filtration filtration(random_cloud(20 + 6 * static_cast<int>(seed), seed));
    const Complex all = filtration.complex(1e9);
    EXPECT_EQ(betti_1(all), 0);
    for (Eigen::Index e = 0; e < all.edges.cols(); e += 5) {
      const double d = length(all, e);
      EXPECT_EQ(betti_at(filtration.betti(), d), betti_1(filtration.complex(d)));
      EXPECT_EQ(betti_at(filtration.betti(), 1.001 * d), betti_1(filtration.complex(1.001 * d)));
    }
  }
}

TEST(Filtration, WholeTriangulationFillsABall) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const Filtration filtration(random_cloud(300, seed));
    const Complex all = filtration.complex(1e9);
    // Euler's formula of a ball, solved for the tetrahedra; each has four sides, and a side
    // belongs to two of them or to the hull, whose triangles are even in number.
    const Eigen::Index tetrahedra = 300 - all.edges.cols() + all.triangles.cols() - 1;
    const Eigen::Index hull = 2 * all.triangles.cols() - 4 * tetrahedra;
    EXPECT_GE(hull, 4);
    EXPECT_LT(hull, 600);
    EXPECT_EQ(hull % 2, 0);
    EXPECT_EQ(filtration.num_vertices(), 300);
  }
}

TEST(Filtration, PersistenceIsThatOfTheTextbook) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Filtration filtration(random_cloud(60, seed));
    EXPECT_EQ(sorted_pairs(filtration), textbook(filtration));
  }
  const Filtration ring(noisy(torus(1, 0.3, 0.3), 0.02, 1));
  EXPECT_EQ(sorted_pairs(ring), textbook(ring));
}

TEST(Filtration, PairsCountTheLoops) {
  const Filtration filtration(random_cloud(400, 7));
  for (double d = 0.02; d < 0.5; d *= 1.07) {
    int alive = 0;
    for (const auto& pair : filtration.persistence()) alive += pair.birth < d && d <= pair.death;
    EXPECT_EQ(alive, betti_at(filtration.betti(), d)) << d;
  }
}

TEST(Filtration, ComplexHoldsWhatIsShorter) {
  const Filtration filtration(random_cloud(100, 3));
  const double d = 0.3;
  const Complex complex = filtration.complex(d), all = filtration.complex(1e9);
  Eigen::Index shorter = 0;
  for (Eigen::Index e = 0; e < all.edges.cols(); ++e) shorter += length(all, e) < d;
  EXPECT_EQ(complex.edges.cols(), shorter);
  std::set<std::pair<int, int>> edges;
  for (Eigen::Index e = 0; e < complex.edges.cols(); ++e) {
    EXPECT_LT(length(complex, e), d);
    edges.emplace(complex.edges(0, e), complex.edges(1, e));
  }
  for (const auto& t : complex.triangles.colwise()) {
    EXPECT_EQ(edges.count({t[0], t[1]}) + edges.count({t[0], t[2]}) + edges.count({t[1], t[2]}), 3);
  }
  EXPECT_EQ(filtration.complex(0).edges.cols(), 0);
}

TEST(Filtration, FindsTheHolesOfKnownBodies) {
  const Eigen::Matrix3Xd ring = torus(0.1, 0.012, 0.012);
  const std::vector<std::pair<Eigen::Matrix3Xd, int>> known{
      {ring, 1},
      {side_by_side({ring, moved(ring, {0.6, 0, 0})}), 2},
      {side_by_side({ring, moved(ring, {0.212, 0.001, 0.002})}), 2},  // a figure eight
  };
  for (const auto& [cloud, loops] : known) {
    const Plateau widest = Filtration(cloud).plateaus().at(0);
    EXPECT_EQ(widest.loops, loops);
    EXPECT_GT(widest.ratio(), 2);
  }
  const auto of_sphere = Filtration(sphere_cloud(0.1, 800)).plateaus();
  for (const Plateau& plateau : of_sphere) EXPECT_LT(plateau.ratio(), 1.2);
}

TEST(Filtration, DoesNotDependOnOrderOrPose) {
  const Eigen::Matrix3Xd cloud = noisy(torus(0.1, 0.02, 0.01), 0.001, 5);
  const Filtration filtration(cloud);
  std::vector<int> order(cloud.cols());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(2));
  const Filtration shuffled(cloud(Eigen::all, order));
  EXPECT_EQ(shuffled.betti().max_edge_length, filtration.betti().max_edge_length);
  EXPECT_EQ(shuffled.betti().loops, filtration.betti().loops);
  EXPECT_EQ(sorted_pairs(shuffled), sorted_pairs(filtration));

  const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  const Filtration turned(moved(turn * cloud, {0.3, -0.2, 0.1}));
  ASSERT_EQ(turned.persistence().size(), filtration.persistence().size());
  for (std::size_t i = 0; i < turned.persistence().size(); ++i) {
    EXPECT_NEAR(sorted_pairs(turned)[i].first, sorted_pairs(filtration)[i].first, 1e-9);
    EXPECT_NEAR(sorted_pairs(turned)[i].second, sorted_pairs(filtration)[i].second, 1e-9);
  }
}

TEST(Filtration, SpanOfAWalkIsThatOfItsClass) {
  const Eigen::Matrix3Xd cloud = torus(0.1, 0.02, 0.01);
  const Filtration filtration(cloud);
  const auto outer = static_cast<int>(std::ceil(2 * M_PI * 0.12 / 0.01));
  std::vector<int> around;  // the first row: the tube's outer circle
  for (int i = 0; i < outer; ++i) around.push_back(i);
  const auto longest = filtration.persistence();
  const PersistencePair span = filtration.span(around, 0.014);
  EXPECT_LT(span.birth, 0.0125);
  EXPECT_GT(span.death, 0.1);  // as wide as the hole is
  const bool is_a_pair =
      std::any_of(longest.begin(), longest.end(),
                  [&](const PersistencePair& pair) { return pair.death == span.death; });
  EXPECT_TRUE(is_a_pair);
  // Filled where it lies in K_d: no class.
  const Eigen::Vector3i triangle = filtration.complex(0.014).triangles.col(0);
  const PersistencePair filled = filtration.span({triangle[0], triangle[1], triangle[2]}, 0.014);
  EXPECT_EQ(filled.birth, filled.death);
  expect_refused([&] { filtration.span({0, 1, outer / 2}, 0.014); }, "cycle goes from point 1 to");
  expect_refused([&] { filtration.span({0, -1, 2}, 0.014); }, "cycle goes from point 0 to -1");
  expect_refused([&] { filtration.span({0, 1}, 0.014); }, "cycle must have at least 3 points, not");
}

TEST(Filtration, RefusesThresholdsWithoutMeaning) {
  const Filtration filtration(random_cloud(30, 4));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused([&] { filtration.complex(-1); }, "max_edge_length must not be negative, not -1");
  expect_refused([&] { filtration.complex(nan); }, "max_edge_length must not be negative, not nan");
  expect_refused([&] { filtration.plateaus(0.9); }, "lasting_ratio must be at least 1, not 0.9");
}

TEST(Filtration, RefusesJumpsOfPairsThatCloseNoLoop) {
  Eigen::Matrix3Xd cloud = random_cloud(50, 9);
  cloud.col(49) = cloud.col(48);  // isolated
  const Filtration filtration(cloud);
  ASSERT_FALSE(filtration.persistence().empty());
  EXPECT_GE(filtration.jump(filtration.persistence()[0]), 1);
  PersistencePair pair;
  expect_refused([&] { filtration.jump(pair); }, "must be an edge, not points -1 and -1");
  pair.closing = {0, 50};
  expect_refused([&] { filtration.jump(pair); }, "must be an edge, not points 0 and 50");
  pair.closing = {0, 49};
  expect_refused([&] { filtration.jump(pair); }, "must be an edge, not points 0 and 49");
}

TEST(Filtration, CountsEqualPointsOnce) {
  const Eigen::Matrix3Xd cloud = random_cloud(50, 9);
  const Filtration once(cloud), twice(side_by_side({cloud, cloud}));
  EXPECT_EQ(twice.num_vertices(), 50);
  EXPECT_EQ(twice.complex(0.4).edges, once.complex(0.4).edges);
  EXPECT_EQ(twice.complex(0.4).triangles, once.complex(0.4).triangles);
}

TEST(Filtration, RefusesWhatSpansNoVolume) {
  const auto make = [](const Eigen::Matrix3Xd& points) {
    return [points] { Filtration(points, "cloud"); };
  };
  Eigen::Matrix3Xd flat = random_cloud(30, 4);
  flat.row(2).setZero();
  const Eigen::Matrix3d turn(Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 1, 0).normalized()));
  Eigen::Matrix3Xd nan = random_cloud(30, 4), far = nan;
  nan(1, 7) = std::numeric_limits<double>::quiet_NaN();
  far(0, 0) = 1e6;
  expect_refused(make(Eigen::Matrix3Xd(3, 0)), "cloud must hold at least 4 distinct points, not 0");
  expect_refused(make(Eigen::Matrix3Xd::Ones(3, 20)), "not 1");
  expect_refused(make(flat), "cloud must span a volume; all 30 lie in a plane");
  expect_refused(make(turn * flat), "cloud must span a volume");
  expect_refused(make(nan), "point 7");
  expect_refused(make(far), "cloud must be within 10000 m of the origin, but point 0");
}

}  // namespace
}  // namespace graspless::geometry
