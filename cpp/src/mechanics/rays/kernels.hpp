// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace graspless::mechanics {

namespace kernels {

constexpr int kLanes = 8;  ///< numbers processed side by side
constexpr int kBlock =
    7 * kLanes;  ///< size of a block of columns: six rows of wrenches, one of a finger

/// Inverse of a basis, in columns of K = 8 or 12 numbers, and 1 / |row|^2. Rows beyond the basis
/// are zero, and their 1 / |row|^2 is 1.
struct Inverse {
  int K = 8;
  double* columns = nullptr;
  double* per_square = nullptr;
};

/// Computes values = X b.
void multiply(const Inverse& X, const double* b, double* values);

/// Returns the row most against b by distance if that exceeds sqrt(allowed), else -1.
int most_against(const Inverse& X, const double* b, double allowed);

/// Replaces the column of row r by `entering`.
void exchange(const Inverse& X, const double* entering, int r);

/// Returns the column of least price rho . a_j if that is less than `below`, else -1. Block k of
/// columns has an entry in row finger_row[k] besides its wrenches.
int least_price(const double* rho, const double* blocks, const int* finger_row, int count,
                double below);

/// Computes slack[d], the distance of origin + z l_d inside the cone of the basis, at most 0.
/// Directions are in blocks of six rows of kLanes.
void slacks(const Inverse& X, const double* origin, double z, const double* blocks, int count,
            double* slack);

}  // namespace kernels
}  // namespace graspless::mechanics
