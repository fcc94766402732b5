// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "graspless/geometry/complex.hpp"

#include "geometry/complex/simplices.hpp"

namespace graspless::geometry {

/// The simplices in the order in which they enter K_d as d grows, and what each of them does to
/// H_1. Edges are named by their rank.
struct Ranking {
  struct Triangle {
    int longest;
    std::array<int, 2> others;
    bool fills_loop;  ///< its boundary was no boundary before
  };
  std::vector<int> rank;         ///< of an edge of Simplices
  std::vector<double> lengths;   ///< ascending
  std::vector<char> makes_loop;  ///< the edge joins what was joined already
  std::vector<Triangle> triangles;
};

Ranking ranking(const Simplices& simplices);

BettiCurve betti_curve(const Ranking& ranking);

}  // namespace graspless::geometry
