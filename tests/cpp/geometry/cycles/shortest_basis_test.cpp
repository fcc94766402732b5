// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/cycles/shortest_basis.hpp"

#include <set>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "geometry/clouds.hpp"
#include "geometry/cycles/homology_oracle.hpp"
#include "geometry/cycles/small_complexes.hpp"

namespace graspless::geometry {
namespace {

double total_length(const Complex& complex, const std::vector<Cycle>& basis) {
  double total = 0;
  for (const Cycle& cycle : basis) total += cycle_length(complex.points, cycle);
  return total;
}

/// Simple, along edges, shortest first, independent, and as many as H_1 has dimensions.
void expect_basis(const Complex& complex, const std::vector<Cycle>& basis) {
  const HomologyOracle oracle(complex);
  ChainSpace space = oracle.boundaries();
  double last = 0;
  for (const Cycle& cycle : basis) {
    EXPECT_EQ(std::set<int>(cycle.begin(), cycle.end()).size(), cycle.size());
    ASSERT_NO_THROW(oracle.chain(cycle));
    EXPECT_TRUE(space.add(oracle.chain(cycle)));
    EXPECT_GE(cycle_length(complex.points, cycle), last);
    last = cycle_length(complex.points, cycle);
  }
  EXPECT_EQ(static_cast<int>(basis.size()), oracle.num_classes());
}

void expect_shortest(const Complex& complex) {
  const std::vector<Cycle> basis = shortest_basis(complex);
  expect_basis(complex, basis);
  EXPECT_NEAR(total_length(complex, basis), HomologyOracle(complex).basis_length(), 1e-9);
}

TEST(ShortestBasis, IsAsShortAsAllRootsMakeIt) {
  int most = 0, least = 1000;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const double share = 0.15 * static_cast<double>(seed % 7);
    const Complex complex = random_complex(26, 0.42, share, seed);
    expect_shortest(complex);
    const int count = static_cast<int>(shortest_basis(complex).size());
    most = std::max(most, count);
    least = std::min(least, count);
  }
  EXPECT_GT(most, 30);  // else the cases are all alike
  EXPECT_LT(least, 3);
}

TEST(ShortestBasis, OfSparseGraphsIsAMinimumCycleBasis) {
  for (std::uint64_t seed = 100; seed < 120; ++seed) {
    SCOPED_TRACE(seed);
    expect_shortest(random_complex(40, 0.3, 0, seed));  // in several pieces
  }
}

TEST(ShortestBasis, IsAsShortAsAllRootsMakeItWhereLengthsTie) {
  expect_shortest(net(9, 7, 0.1, 3));
  expect_shortest(net(6, 6, 0.5, 2));
  expect_shortest(ring_surface(1, 0.4, 14, 6));
}

TEST(ShortestBasis, GoesOnPastSixtyFourClasses) {
  const Complex complex = net(23, 13, 0.1, 2);
  const std::vector<Cycle> basis = shortest_basis(complex);
  ASSERT_EQ(basis.size(), 66u);
  expect_basis(complex, basis);
  for (const Cycle& cycle : basis) EXPECT_NEAR(cycle_length(complex.points, cycle), 0.4, 1e-12);
  const Complex graph = random_complex(45, 0.45, 0, 7);
  EXPECT_GT(shortest_basis(graph).size(), 128u);
  expect_shortest(graph);
}

TEST(ShortestBasis, ASurfaceOfATorusHasTwo) {
  const Complex complex = ring_surface(1, 0.25, 40, 12);
  const std::vector<Cycle> basis = shortest_basis(complex);
  expect_basis(complex, basis);
  ASSERT_EQ(basis.size(), 2u);
  EXPECT_NEAR(cycle_length(complex.points, basis[0]), 2 * M_PI * 0.25, 0.05);
  EXPECT_GT(cycle_length(complex.points, basis[1]), 0.98 * 2 * M_PI * 0.75);
  EXPECT_LT(cycle_length(complex.points, basis[1]), 1.2 * 2 * M_PI * 0.75);  // zigzag
}

TEST(ShortestBasis, OfLabelledClassesIsThatOfAll) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Filtration filtration(random_cloud(150, seed));
    const double d = 0.28;
    const auto& pairs = filtration.persistence();
    std::vector<int> alive;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (pairs[i].birth < d && d <= pairs[i].death) alive.push_back(static_cast<int>(i));
    }
    const Complex complex = filtration.complex(d);
    const std::vector<Cycle> all = shortest_basis(complex);
    ASSERT_EQ(alive.size(), all.size());
    ASSERT_FALSE(alive.empty());
    std::vector<Cycle> labelled;
    std::set<int> classes;
    for (const ClassCycle& member : shortest_basis(complex, filtration.labels(d, alive))) {
      labelled.push_back(member.cycle);
      classes.insert(member.cls);
    }
    expect_basis(complex, labelled);
    EXPECT_EQ(classes.size(), alive.size());
    EXPECT_NEAR(total_length(complex, labelled), total_length(complex, all), 1e-9);
    // Of one class alone: a cycle that dies when the class does, if others may be added.
    const ClassCycle one = shortest_basis(complex, filtration.labels(d, {alive[0]})).at(0);
    EXPECT_GE(filtration.span(one.cycle, d).death, pairs[alive[0]].death);
  }
  expect_refused([] { Filtration(random_cloud(50, 1)).labels(0.5, {-1}); },
                 "class -1 is not alive at 0.5");
}

TEST(ShortestBasis, IsEmptyWithoutHoles) {
  EXPECT_TRUE(shortest_basis(net(4, 4, 1)).empty());
  EXPECT_TRUE(shortest_basis(complex_of(Eigen::Matrix3Xd::Zero(3, 3), {})).empty());
  EXPECT_TRUE(shortest_basis(Complex{}).empty());
  const Complex tree = complex_of(Eigen::Matrix3Xd::Identity(3, 4), {{0, 1}, {1, 2}, {1, 3}}, {});
  EXPECT_TRUE(shortest_basis(tree).empty());
}

TEST(ShortestBasis, HasTheSameLengthInAnyOrderOfPoints) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Complex complex = random_complex(60, 0.3, 0.6, seed);
    const Complex other = relabelled(complex, seed + 1);
    EXPECT_NEAR(total_length(complex, shortest_basis(complex)),
                total_length(other, shortest_basis(other)), 1e-9);
  }
}

TEST(ShortestBasis, IsTheSameEveryTime) {
  const Complex complex = net(23, 13, 0.1, 2);
  EXPECT_EQ(shortest_basis(complex), shortest_basis(complex));
}

TEST(ShortestBasis, GrowsWithThePoints) {
  Complex complex = random_complex(40, 0.35, 0.5, 3);
  const double before = total_length(complex, shortest_basis(complex));
  complex.points *= 1e-3;
  EXPECT_NEAR(total_length(complex, shortest_basis(complex)), 1e-3 * before, 1e-12);
}

}  // namespace
}  // namespace graspless::geometry
