// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

#include "mechanics/rays/kernels.hpp"

namespace graspless::mechanics {

/// Columns of the balance of one instant with one combination of control modes:
///   sum_j a_j k_j = w               (6 rows: a wrench to balance, less the known one)
///   normal_i . k_i + slack = f_max  (a finger in position control)
///   normal_i . k_i         = f      (a finger in force control)
/// They are stored in blocks, each of the environment or of one finger, padded with zeros.
class Columns {
 public:
  void assign(const EnvironmentWrenches& environment,
              const std::vector<const FingerWrenches*>& fingers, ForceMask force);

  int rows() const { return rows_; }
  int count() const { return kernels::kLanes * static_cast<int>(finger_row_.size()); }
  const double* blocks() const { return table_.data(); }
  const int* finger_row() const { return finger_row_.data(); }
  /// Length of the longest wrench.
  double longest() const { return longest_; }
  /// Writes column j, all rows.
  void column(int j, double* entries) const;
  /// Slack column of a finger's row; -1 for fingers in force control.
  int slack(int finger) const { return slack_[finger]; }

 private:
  double* place(int j);

  int rows_ = 0;
  double longest_ = 0;
  std::vector<double> table_;    // blocks of six rows of wrenches and the finger's row
  std::vector<int> finger_row_;  // row of each block's finger
  std::array<int, kMaxFingers> slack_{};
};

/// Basis of the balance with the inverse of its matrix, which moves from target to target.
class RayBasis {
 public:
  static constexpr int kMaxRows = 12;  // 6 + kMaxFingers, padded
  using Vector = std::array<double, kMaxRows>;

  /// Restarts with the slacks and with artificial columns, which must carry nothing in the end.
  void begin(const Columns& columns);
  /// Replaces artificial columns by real ones, preferably ones that carry `target` with the right
  /// sign. Returns false if the columns do not span the space.
  bool complete(const Vector& target);
  /// Continues from the last basis with new columns. Returns false if they are dependent.
  bool resume(const Columns& columns);
  /// Makes the next resume() fail.
  void forget() { columns_ = nullptr; }

  enum class Outcome { reached, facet };
  /// Pivots until the basis carries the target with coefficients >= 0 (to `tolerance`, a distance
  /// from the target), or a row proves that no basis does: facet().
  Outcome reach(const Vector& target, double tolerance);
  /// True if rounding errors may have decided: the basis is ill-conditioned, or since begin() or
  /// resume() a column was too close to a facet to tell its side.
  bool is_doubtful() const { return is_doubtful_ || is_ill_conditioned(); }
  /// rho with rho . a_j >= 0 for all columns and rho . target < 0.
  const Vector& facet() const { return facet_; }

  kernels::Inverse inverse() { return {K_, inverse_.data(), per_square_.data()}; }
  std::int64_t pivots() const { return pivots_; }

 private:
  Vector row(int r) const;
  bool condition_exceeds(double limit) const;
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
  std::array<int, kMaxRows> head_{};                   // column of each row; negative: artificial
  std::array<double, kMaxRows * kMaxRows> inverse_{};  // column by column, K entries each
  std::array<double, kMaxRows * kMaxRows> matrix_{};   // columns of the basis, stored likewise
  Vector per_square_{};
  Vector facet_{};
  bool is_doubtful_ = false;
  int since_refresh_ = 0;
  std::int64_t pivots_ = 0;
};

}  // namespace graspless::mechanics
