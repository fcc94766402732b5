// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::clasp {

/// A straight edge between two points of a graph in space.
struct SpatialEdge {
  int a, b;
  double width;
};

/// Among the cycles of a graph that are linked with a closed curve, finds one whose widest edge is
/// narrowest. Returns its points in order; nothing if no cycle is linked. `curve`: corners, 3 x n.
///
/// Kruskal's algorithm. Each point of a tree carries the signed number of times that the way from
/// the root crosses a surface bounded by the curve. The first edge that joins two points of one
/// tree with a different number closes the cycle.
std::vector<int> tightest_cycle(const Eigen::Matrix3Xd& points, std::vector<SpatialEdge> edges,
                                const Eigen::Matrix3Xd& curve);

}  // namespace graspless::clasp
