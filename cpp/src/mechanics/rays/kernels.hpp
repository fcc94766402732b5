// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace graspless::mechanics {

/// An int as the index of a standard container.
constexpr std::size_t ix(int i) { return static_cast<std::size_t>(i); }

namespace kernels {

constexpr int kLanes = 8;           ///< numbers that are worked on side by side
constexpr int kBlock = 7 * kLanes;  ///< of columns: six rows of wrenches, one of a finger

/// The inverse of a basis, by columns of K = 8 or 12 numbers, and 1 / |row|^2. Rows beyond the
/// basis are zero, with a 1 there.
struct Inverse {
  int K = 8;
  double* columns = nullptr;
  double* per_square = nullptr;
};

/// values = X b.
void multiply(const Inverse& X, const double* b, double* values);

/// The row most against b by distance, if by more than sqrt(allowed); else -1.
int most_against(const Inverse& X, const double* b, double allowed);

/// Column `entering` takes the place of the one of row r.
void exchange(const Inverse& X, const double* entering, int r);

/// The column that turns most against rho, if by more than -below; else -1. Block k of columns has
/// an entry in row finger_row[k] besides its wrenches.
int least_price(const double* rho, const double* blocks, const int* finger_row, int count,
                double below);

/// slack[d]: by how far origin + z l_d is inside the cone of the basis, at most 0. Directions in
/// blocks of six rows of kLanes.
void slacks(const Inverse& X, const double* origin, double z, const double* blocks, int count,
            double* slack);

}  // namespace kernels
}  // namespace graspless::mechanics
