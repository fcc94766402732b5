// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Removes from the inverse of a basis the rounding errors that pivots accumulate.
#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "mechanics/rays/basis.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kDrift = 1e-6;      // residual above which a Newton step may diverge
constexpr double kSingular = 1e-10;  // relative pivot below which columns count as dependent

using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, RayBasis::kMaxRows,
                             RayBasis::kMaxRows>;
using Map = Eigen::Map<Square, 0, Eigen::OuterStride<>>;

}  // namespace

/// Takes a Newton step X += X (I - B X) towards the inverse, or inverts again if it has drifted
/// far. Returns false if the basis is singular.
bool RayBasis::refresh() {
  since_refresh_ = 0;
  Map X(inverse_.data(), rows_, rows_, Eigen::OuterStride<>(K_));
  const Map B(matrix_.data(), rows_, rows_, Eigen::OuterStride<>(K_));
  Square miss = Square::Identity(rows_, rows_);
  miss.noalias() -= B.lazyProduct(X);
  if (!(miss.cwiseAbs().maxCoeff() < kDrift)) return refactor(kSingular);
  const Square step = X.lazyProduct(miss);
  X += step;
  measure();
  return true;
}

/// Inverts by Gauss-Jordan elimination with partial pivoting. Returns false if the basis is
/// singular.
bool RayBasis::refactor(double least_pivot) {
  since_refresh_ = 0;
  Square B = Map(matrix_.data(), rows_, rows_, Eigen::OuterStride<>(K_));
  Square X = Square::Identity(rows_, rows_);
  const double size = B.cwiseAbs().maxCoeff();
  for (int c = 0; c < rows_; ++c) {
    Eigen::Index at = 0;
    const double pivot = B.col(c).tail(rows_ - c).cwiseAbs().maxCoeff(&at);
    if (!(pivot > least_pivot * size)) return false;
    B.row(c).swap(B.row(c + at));
    X.row(c).swap(X.row(c + at));
    const double scale = 1 / B(c, c);
    B.row(c) *= scale;
    X.row(c) *= scale;
    for (int r = 0; r < rows_; ++r) {
      const double factor = B(r, c);
      if (r == c || factor == 0) continue;
      B.row(r) -= factor * B.row(c);
      X.row(r) -= factor * X.row(c);
    }
  }
  inverse_.fill(0);
  Map(inverse_.data(), rows_, rows_, Eigen::OuterStride<>(K_)) = X;
  measure();
  return true;
}

void RayBasis::measure() {
  for (int r = 0; r < K_; ++r) {
    double square = 0;
    for (int k = 0; k < rows_; ++k) {
      const double value = inverse_[k * K_ + r];
      square += value * value;
    }
    per_square_[r] = 1 / (square > 0 ? square : 1);
  }
}

/// Sets the facet to row r of the inverse after one step of refinement: rho += (e_r - rho B) X.
void RayBasis::refine_facet(int r) {
  using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, kMaxRows>;
  const Map X(inverse_.data(), rows_, rows_, Eigen::OuterStride<>(K_));
  const Map B(matrix_.data(), rows_, rows_, Eigen::OuterStride<>(K_));
  Row rho = X.row(r);
  Row miss = -rho.lazyProduct(B);
  miss[r] += 1;
  rho += miss.lazyProduct(X);
  facet_.fill(0);
  std::copy_n(rho.data(), rows_, facet_.begin());
}

}  // namespace graspless::mechanics
