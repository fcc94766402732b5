// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Lower bounds on the distance of two shapes, from their trees of convex hulls.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "collision/hulls.hpp"

namespace graspless::collision {

/// A direction in which part i of one tree lies apart from part j of another. The hulls are parts,
/// and after them come the triangles of a surface.
struct Witness {
  int i, j;
  Eigen::Vector3d direction_A;
};

/// Witnesses that prove two whole shapes apart, from the last search. They mostly hold at the next
/// configuration too, which saves the search.
using Witnesses = std::vector<Witness>;

/// Returns a lower bound on the distance of two shapes [m]; 0 if parts of them may touch. A bound
/// of at least `enough` is not improved further. With `by_triangle`, the triangles of surfaces
/// count where their hulls are too near.
double separation(const HullTree& a, const HullTree& b, const Eigen::Isometry3d& X_AB,
                  double enough, bool by_triangle, Witnesses& witnesses);

/// True if two shapes are proven to be more than `margin` [m] apart.
bool are_apart(const HullTree& a, const HullTree& b, const Eigen::Isometry3d& X_AB, double margin,
               Witnesses& witnesses);

}  // namespace graspless::collision
