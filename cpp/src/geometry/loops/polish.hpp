// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/loops.hpp"

#include "geometry/cycles/shortest_basis.hpp"
#include "geometry/loops/resolution.hpp"

/// Shorter cycles of the same homology class, from a few roots on each instead of all vertices:
/// fast, but not always shortest.
namespace graspless::geometry {

/// Moves cycles that cross open space to the surface, within their homology class in `complex`. A
/// cycle that must cross open space does so where the crossing is short.
std::vector<Cycle> around_gaps(const Complex& complex, const Resolution& resolution,
                               std::vector<Cycle> cycles);

/// Shortens loops of a downsampled cloud on the complex `whole` of the full cloud. Each result has
/// the class of its loop. Empty if a loop cannot be traced on `whole`.
std::vector<Cycle> polished(const Complex& whole, const std::vector<Eigen::Matrix3Xd>& loops);

/// Replaces loops of a downsampled cloud by shorter ones of the same class on all its points (3 x
/// n), around gaps. Sorts them by length. Threads share the loops, which do not depend on their
/// number.
void polish(const Eigen::Matrix3Xd& points, int threads, std::vector<Loop>& loops);

}  // namespace graspless::geometry
