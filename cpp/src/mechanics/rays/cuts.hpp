// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

/// Upper bound on z as a function of f_com: the least of affine cuts z <= a + b . f, valid for
/// every f. Keeps the maximum over the box 0 <= f <= f_max, by dual simplex in 1 + dims variables.
class Cuts {
 public:
  struct Cut {
    double a = 0;
    std::array<double, kMaxFingers> b{};
  };

  /// Restarts with the single cut z <= ceiling.
  void begin(int dims, const double* upper, double ceiling);
  /// Adds a cut and moves to the new maximum. Returns false if that changes nothing, because the
  /// cut was known up to rounding.
  bool add(const Cut& cut);

  double z() const { return v_[0]; }
  const double* f() const { return &v_[1]; }
  /// Value of a cut at the maximum.
  double at(const Cut& cut) const;

 private:
  static constexpr int kDims = kMaxFingers + 1;
  using Row = std::array<double, kDims + 1>;  // coefficients of (z, f), then the right-hand side
  using Square = std::array<std::array<double, kDims>, kDims>;

  double excess(const Row& row) const;
  void make_active(const Row& row);
  void locate();

  int n_ = 1;  // variables
  std::vector<Row> rows_;
  std::array<Row, kDims> active_{};
  Square inverse_{};                    // of the active rows
  std::array<double, kDims> weight_{};  // of the active rows, in the objective
  std::array<double, kDims> v_{};       // (z, f)
  double scale_ = 1;
};

}  // namespace graspless::mechanics
