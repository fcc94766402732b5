// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/complex.hpp"

namespace graspless::geometry {

/// A simple closed walk along edges of a complex: its vertices in order, the first not repeated.
using Cycle = std::vector<int>;

double cycle_length(const Eigen::Matrix3Xd& points, const Cycle& cycle);

/// A basis of H_1(K; Z_2) of least total length, shortest first. Any number of classes.
std::vector<Cycle> shortest_basis(const Complex& complex);

/// Shorter cycles of `whole` in the classes of the given ones, which are polylines near its points
/// (loops of a thinned cloud): few roots a loop instead of all. Empty where a loop has no way
/// there.
std::vector<Cycle> polished(const Complex& whole, const std::vector<Eigen::Matrix3Xd>& loops);

/// Thickness of what a cycle runs along, at its thinnest place [m].
double thickness(const Complex& complex, const Cycle& cycle);

/// Which cycles of a basis run around a thick handle and not along it (the inside of a handle that
/// the cloud shows only as a surface is hollow, and doubles H_1).
std::vector<bool> find_meridians(const Complex& complex, const std::vector<Cycle>& basis);

}  // namespace graspless::geometry
