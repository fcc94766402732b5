// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/cycles/annotation.hpp"

#include <random>

#include <gtest/gtest.h>

#include "geometry/cycles/homology_oracle.hpp"
#include "geometry/cycles/shortest_basis.hpp"
#include "geometry/cycles/small_complexes.hpp"

namespace graspless::geometry {
namespace {

using Class = std::vector<Annotation::Word>;

Class class_of(const Annotation& annotation, const EdgeGraph& graph, const Cycle& cycle) {
  Class sum(static_cast<std::size_t>(annotation.words()), 0);
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const int edge = graph.edge(cycle[i], cycle[(i + 1) % cycle.size()]);
    for (std::size_t w = 0; w < sum.size(); ++w) sum[w] ^= annotation.of(edge)[w];
  }
  return sum;
}

bool is_zero(const Class& cls) { return cls == Class(cls.size(), 0); }

/// A closed walk by lot: out at random, and back by any way.
Cycle closed_walk(const EdgeGraph& graph, std::mt19937_64& rng) {
  const auto count = static_cast<std::uint64_t>(graph.num_vertices());
  const auto start = static_cast<int>(rng() % count);
  Cycle walk{start};
  for (int i = 0; i < 200; ++i) {
    const EdgeGraph::Arcs arcs = graph.arcs(walk.back());
    const auto degree = static_cast<std::uint64_t>(arcs.end() - arcs.begin());
    if (degree == 0) return {};
    const int next = (arcs.begin() + rng() % degree)->to;
    if (next == start && walk.size() > 2) return walk;
    walk.push_back(next);
  }
  return {};
}

TEST(Annotation, CountsTheClassesOfHomology) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Complex complex = random_complex(26, 0.42, 0.15 * static_cast<double>(seed % 7), seed);
    const EdgeGraph graph(complex);
    EXPECT_EQ(Annotation(complex, graph).num_classes(), HomologyOracle(complex).num_classes());
  }
}

TEST(Annotation, OfATriangleIsZero) {
  const Complex complex = random_complex(40, 0.4, 0.5, 1);
  ASSERT_GT(complex.triangles.cols(), 30);
  const EdgeGraph graph(complex);
  const Annotation annotation(complex, graph);
  ASSERT_GT(annotation.num_classes(), 0);
  for (const auto& t : complex.triangles.colwise())
    EXPECT_TRUE(is_zero(class_of(annotation, graph, {t[0], t[1], t[2]})));
}

TEST(Annotation, IsZeroOnWhatBoundsAndOnNothingElse) {
  std::mt19937_64 rng(2);
  int bounding = 0, others = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Complex complex = random_complex(26, 0.45, 0.45, seed);
    const EdgeGraph graph(complex);
    const Annotation annotation(complex, graph);
    const HomologyOracle oracle(complex);
    for (int i = 0; i < 60; ++i) {
      const Cycle walk = closed_walk(graph, rng);
      if (walk.empty()) continue;
      const bool bounds = !ChainSpace(oracle.boundaries()).add(oracle.chain(walk));
      EXPECT_EQ(is_zero(class_of(annotation, graph, walk)), bounds);
      ++(bounds ? bounding : others);
    }
  }
  EXPECT_GT(bounding, 50);
  EXPECT_GT(others, 50);
}

TEST(Annotation, GoesOnPastSixtyFourClasses) {
  const Complex complex = net(23, 13, 0.1, 2);
  const EdgeGraph graph(complex);
  const Annotation annotation(complex, graph);
  EXPECT_EQ(annotation.num_classes(), 66);
  EXPECT_EQ(annotation.words(), 2);
}

/// The projective plane on six points: over Z_2 one class, and the edges of any triangle of the
/// complete graph that is not a face carry it. Relations between symbols arise here.
TEST(Annotation, KnowsTheProjectivePlane) {
  const TriangleSet faces{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 1, 5},
                          {1, 2, 4}, {2, 3, 5}, {1, 3, 4}, {2, 4, 5}, {1, 3, 5}};
  const Complex complex = complex_of(Eigen::Matrix3Xd::Random(3, 6), {}, faces);
  const EdgeGraph graph(complex);
  const Annotation annotation(complex, graph);
  ASSERT_EQ(annotation.num_classes(), 1);
  EXPECT_FALSE(is_zero(class_of(annotation, graph, {0, 1, 3})));
}

}  // namespace
}  // namespace graspless::geometry
