// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/complex.hpp"

namespace graspless::geometry {

/// Vertices of a simple closed walk along edges of a complex, without repeating the first.
using Cycle = std::vector<int>;

/// Length of a cycle [m].
double cycle_length(const Eigen::Matrix3Xd& points, const Cycle& cycle);

/// Computes a basis of H_1(K; Z_2) of least total length, shortest cycle first.
std::vector<Cycle> shortest_basis(const Complex& complex);

/// A cycle, and the last of the classes it contains that no shorter cycle of its basis stands for.
struct ClassCycle {
  Cycle cycle;
  int cls;
};

/// Same for the classes that have labels, modulo those that have none. Every class occurs once.
std::vector<ClassCycle> shortest_basis(const Complex& complex, ClassLabels labels);

}  // namespace graspless::geometry
