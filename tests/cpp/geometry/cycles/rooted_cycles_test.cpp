// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/cycles/rooted_cycles.hpp"

#include <limits>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/cycles/small_complexes.hpp"

namespace graspless::geometry {
namespace {

using Words = std::vector<Annotation::Word>;

TEST(RootedCycles, ShortestOfAClassIsTheFirstOfItsClosingEdges) {
  const double any = std::numeric_limits<double>::infinity();
  int classes = 0, above = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Complex complex = random_complex(30, 0.42, 0.5, seed);
    const EdgeGraph graph(complex);
    const Annotation annotation(complex, graph);
    RootedCycles cycles(graph, annotation);
    for (int root = 0; root < 30; ++root) {
      const std::vector<RootedCycles::ClosingEdge> edges = cycles.from(root, any);
      std::map<Words, RootedCycles::ClosingEdge> firsts;
      for (const RootedCycles::ClosingEdge& edge : edges) {
        const Annotation::Word* cls = cycles.class_of(edge);
        firsts.emplace(Words(cls, cls + annotation.words()), edge);
      }
      for (const auto& [cls, first] : firsts) {
        const auto found = cycles.shortest(root, any, cls.data());
        ASSERT_TRUE(found);
        EXPECT_EQ(found->length, first.length);
        EXPECT_EQ(found->edge, first.edge);
        EXPECT_TRUE(cycles.shortest(root, first.length, cls.data()));
        above += cycles.shortest(root, 0.999 * first.length, cls.data()) ? 1 : 0;
        ++classes;
      }
    }
  }
  EXPECT_GT(classes, 300);
  EXPECT_EQ(above, 0);
}

TEST(EdgeGraph, KnowsEdgesInBothDirectionsAndAfterRemovals) {
  const Complex complex = random_complex(30, 0.42, 0.5, 1);
  EdgeGraph graph(complex);
  for (int vertex = 0; vertex < 30; vertex += 3) graph.remove(vertex);
  std::map<std::array<int, 2>, int> index;
  for (int e = 0; e < graph.num_edges(); ++e) index[{complex.edges(0, e), complex.edges(1, e)}] = e;
  for (int a = 0; a < 30; ++a) {
    for (int b = 0; b < 30; ++b) {
      const auto at = index.find(edge_of(a, b));
      EXPECT_EQ(graph.edge(a, b), at == index.end() ? -1 : at->second);
    }
  }
}

}  // namespace
}  // namespace graspless::geometry
