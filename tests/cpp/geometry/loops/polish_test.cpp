// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/polish.hpp"

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "graspless/clasp/sample_objects.hpp"
#include "graspless/geometry/sampling.hpp"

#include "geometry/clouds.hpp"
#include "geometry/cycles/homology_oracle.hpp"
#include "geometry/cycles/small_complexes.hpp"

namespace graspless::geometry {
namespace {

/// A circle about z with few corners, as a thinned cloud would give a loop.
Eigen::Matrix3Xd coarse_loop(double radius, int corners) {
  Eigen::Matrix3Xd loop(3, corners);
  for (int i = 0; i < corners; ++i) {
    const double u = 2 * M_PI * i / corners;
    loop.col(i) << radius * std::cos(u), radius * std::sin(u), 0;
  }
  return loop;
}

TEST(Polish, FindsTheShortestLoopOfARing) {
  const Complex whole = Filtration(torus(0.15, 0.012, 0.006)).complex(0.014);
  const std::vector<Cycle> exact = shortest_basis(whole);
  ASSERT_GE(exact.size(), 1u);
  const double best = cycle_length(whole.points, exact.back());
  for (const double radius : {0.142, 0.15, 0.158}) {
    const std::vector<Cycle> polish = polished(whole, {coarse_loop(radius, 30)});
    ASSERT_EQ(polish.size(), 1u);
    EXPECT_NEAR(cycle_length(whole.points, polish[0]), best, 0.005 * best);
  }
}

TEST(Polish, KeepsTheClassAndIsNoLonger) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Complex complex = random_complex(30, 0.42, 0.5, seed);
    const HomologyOracle oracle(complex);
    const std::vector<Cycle> basis = shortest_basis(complex);
    std::vector<Eigen::Matrix3Xd> loops;
    for (const Cycle& cycle : basis) loops.emplace_back(complex.points(Eigen::all, cycle));
    const std::vector<Cycle> polish = polished(complex, loops);
    ASSERT_EQ(polish.size(), basis.size());
    for (std::size_t i = 0; i < basis.size(); ++i) {
      EXPECT_EQ(std::set<int>(polish[i].begin(), polish[i].end()).size(), polish[i].size());
      EXPECT_LE(cycle_length(complex.points, polish[i]),
                cycle_length(complex.points, basis[i]) + 1e-9);
      const Chain both = oracle.chain(polish[i]) ^ oracle.chain(basis[i]);
      EXPECT_FALSE(ChainSpace(oracle.boundaries()).add(both));  // together they bound
    }
  }
}

TEST(Polish, IsTheSameForAnyNumberOfThreads) {
  LoopOptions options;
  const Eigen::Matrix3Xd cloud = sample_surface(clasp::sample_object("lawn_mower"), 30000);
  const Loops coarse = shortest_loops(cloud, options);
  options.polish = true;
  const Loops one = shortest_loops(cloud, options);
  ASSERT_EQ(one.found.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LT(one.found[i].length, coarse.found[i].length);
  for (const int threads : {2, 4}) {
    options.threads = threads;
    const Loops more = shortest_loops(cloud, options);
    ASSERT_EQ(more.found.size(), one.found.size());
    for (std::size_t i = 0; i < one.found.size(); ++i) {
      EXPECT_EQ(more.found[i].vertices, one.found[i].vertices);
      EXPECT_EQ(more.found[i].length, one.found[i].length);
      EXPECT_EQ(more.found[i].gap, one.found[i].gap);
    }
  }
}

TEST(Polish, RefusesNumbersOfThreadsOutOfRange) {
  LoopOptions options;
  for (const int threads : {0, 257}) {
    options.threads = threads;
    EXPECT_THROW(validate(options), std::invalid_argument);
  }
}

TEST(Polish, IsEmptyWhereTheLoopHasNoWay) {
  const Complex complex = net(6, 6, 0.1, 3);
  const std::vector<Cycle> polish = polished(complex, {coarse_loop(0.01, 8), coarse_loop(5, 8)});
  ASSERT_EQ(polish.size(), 2u);
  for (const Cycle& cycle : polish) EXPECT_TRUE(cycle.empty());
}

}  // namespace
}  // namespace graspless::geometry
