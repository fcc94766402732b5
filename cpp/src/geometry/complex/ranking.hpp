// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "graspless/geometry/complex.hpp"

#include "geometry/complex/simplices.hpp"

namespace graspless::geometry {

/// The simplices in the order in which they enter K_d as d grows, and their effect on H_1. Edges
/// are identified by their rank in this order.
struct Ranking {
  struct Triangle {
    int longest;                ///< its longest edge
    std::array<int, 2> others;  ///< its other edges
    bool fills_loop;            ///< true if it fills a loop, false if it encloses a void
    int simplex;                ///< index in Simplices::triangles
  };
  std::vector<int> rank;         ///< rank of each edge of Simplices
  std::vector<int> edge;         ///< edge of Simplices by rank
  std::vector<double> lengths;   ///< of the edges by rank, ascending [m]
  std::vector<char> makes_loop;  ///< by rank: true if the edge's ends were connected before
  std::vector<Triangle> triangles;
};

Ranking ranking(const Simplices& simplices);

BettiCurve betti_curve(const Ranking& ranking);

}  // namespace graspless::geometry
