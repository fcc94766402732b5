// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

#include "mechanics/rays/kernels.hpp"

namespace graspless::mechanics {

/// The columns of the balance of one instant with one choice of control modes:
///   sum_j a_j k_j = w               (6 rows: a wrench to be balanced, less the known one)
///   normal_i . k_i + slack = f_max  (a finger in position control)
///   normal_i . k_i         = f      (a finger in force control)
/// In blocks, each of the environment or of one finger; blocks are padded with zeros.
class Columns {
 public:
  void assign(const EnvironmentWrenches& environment,
              const std::vector<const FingerWrenches*>& fingers, ForceMask force);

  int rows() const { return rows_; }
  int count() const { return kernels::kLanes * static_cast<int>(finger_row_.size()); }
  const double* blocks() const { return table_.data(); }
  const int* finger_row() const { return finger_row_.data(); }
  /// The greatest length of a wrench.
  double longest() const { return longest_; }
  /// Column j, of all rows.
  void column(int j, double* entries) const;
  /// The column that slackens a finger's row; -1 for fingers in force control.
  int slack(int finger) const { return slack_[static_cast<std::size_t>(finger)]; }

 private:
  double* place(int j);

  int rows_ = 0;
  double longest_ = 0;
  std::vector<double> table_;    // blocks of six rows of wrenches and the finger's row
  std::vector<int> finger_row_;  // of each block
  std::array<int, kMaxFingers> slack_{};
};

/// A basis of the balance with the inverse of its matrix, walked from target to target.
class RayBasis {
 public:
  static constexpr int kMaxRows = 12;  // 6 + kMaxFingers, padded
  using Vector = std::array<double, kMaxRows>;

  /// Forgets the basis: the slacks, and artificial columns that may carry nothing elsewhere.
  void begin(const Columns& columns);
  /// Exchanges artificial columns for real ones, those first that carry `target` with the right
  /// sign. False when the columns do not span the space.
  bool complete(const Vector& target);
  /// Takes up the basis that was left, with the columns as they are now. False if it is none.
  bool resume(const Columns& columns);

  enum class Outcome { reached, facet };
  /// Pivots until the basis carries the target with coefficients >= 0 (to `tolerance`, a distance
  /// from the target), or a row proves that none does: facet().
  Outcome reach(const Vector& target, double tolerance);
  /// True if rounding may have decided since begin() or resume(): a basis was too ill-conditioned, or
  /// a column too close to a facet, for the last outcome to be accurate to 1e-9.
  bool is_doubtful() const { return is_doubtful_ || is_ill_conditioned(); }
  /// rho with rho . a_j >= 0 for all columns and rho . target < 0.
  const Vector& facet() const { return facet_; }

  kernels::Inverse inverse() { return {K_, inverse_.data(), per_square_.data()}; }
  std::int64_t pivots() const { return pivots_; }

 private:
  Vector row(int r) const;
  bool is_ill_conditioned() const;
  int leaving(const Vector& target, double tolerance, bool bland);
  int entering(int r, bool bland);
  int least_price(const Vector& rho, double below) const;
  double price(const Vector& rho, int j) const;
  void pivot(int r, int q);
  bool refresh();
  bool refactor(double least_pivot);
  void measure();
  void refine_facet(int r);

  const Columns* columns_ = nullptr;
  int rows_ = 0, K_ = 8;
  std::array<int, kMaxRows> head_{};                   // columns of the basis; negative: artificial
  std::array<double, kMaxRows * kMaxRows> inverse_{};  // by columns of K
  std::array<double, kMaxRows * kMaxRows> matrix_{};   // the basis' columns, likewise
  Vector per_square_{};
  Vector facet_{};
  bool is_doubtful_ = false;
  int since_refresh_ = 0;
  std::int64_t pivots_ = 0;
};

}  // namespace graspless::mechanics
