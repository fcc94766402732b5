// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {

/// The columns of the balance of one instant with one choice of control modes, as rows of numbers:
///   sum_j a_j k_j = w             (6 rows: a wrench to be balanced, less the known one)
///   normal_i . k_i + slack = f_max  (a finger in position control)
///   normal_i . k_i         = f      (a finger in force control)
class Columns {
 public:
  static constexpr int kMaxRows = 6 + kMaxFingers;

  void assign(const EnvironmentWrenches& environment,
              const std::vector<const FingerWrenches*>& fingers, ForceMask force);

  int rows() const { return rows_; }
  int count() const { return count_; }
  int stride() const { return stride_; }  ///< of price()'s answer: count, padded
  /// Entry of column j in a row.
  double entry(int row, int j) const { return table_[static_cast<std::size_t>(row * stride_ + j)]; }
  /// rho . a_j of all columns.
  void price(const double* rho, double* prices) const;
  /// The column that slackens a finger's row; -1 for fingers in force control.
  int slack(int finger) const { return slack_[static_cast<std::size_t>(finger)]; }

 private:
  struct Block {
    int first, last, row;  // columns of a finger, and its row
  };
  int rows_ = 0, count_ = 0, stride_ = 0;
  std::vector<double> table_;
  std::array<Block, kMaxFingers> blocks_{};
  std::array<int, kMaxFingers> slack_{};
};

/// A basis of the balance with the inverse of its matrix, walked from target to target.
class RayBasis {
 public:
  static constexpr int kStride = 12;  // of the inverse's rows: kMaxRows, padded
  using Vector = std::array<double, kStride>;

  /// Forgets the basis: the slacks, and artificial columns that may carry nothing elsewhere.
  void begin(const Columns& columns);
  /// Exchanges artificial columns for real ones, those first that carry `target` with the right
  /// sign. False when the columns do not span the space.
  bool complete(const Vector& target);

  enum class Outcome { reached, facet };
  /// Pivots until the basis carries the target with coefficients >= 0 (to `tolerance`, relative to
  /// the target), or a row proves that none does: facet().
  Outcome reach(const Vector& target, double tolerance);
  /// rho with rho . a_j >= 0 for all columns and rho . target < 0.
  const Vector& facet() const { return facet_; }

  const Vector& row(int r) const { return inverse_[static_cast<std::size_t>(r)]; }
  /// Squared length of row(r).
  double squared_length(int r) const { return lengths_[static_cast<std::size_t>(r)]; }
  std::int64_t pivots() const { return pivots_; }

 private:
  int leaving(const Vector& target, double tolerance, bool bland) const;
  int entering(int r, double sign, bool bland);
  void pivot(int r, int q);
  void refresh();
  void refactor();
  void refine_facet(int r);

  const Columns* columns_ = nullptr;
  int rows_ = 0;
  std::array<int, kStride> head_{};  // columns of the basis; negative: artificial
  std::array<Vector, kStride> inverse_{};
  std::array<Vector, kStride> matrix_{};  // the basis' columns
  Vector lengths_{};
  Vector facet_{};
  std::vector<double> prices_;
  int since_refresh_ = 0;
  std::int64_t pivots_ = 0;
};

}  // namespace graspless::mechanics
