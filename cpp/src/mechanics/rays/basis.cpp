// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Dual simplex without costs, which moves from one target to the next with few pivots.
#include "mechanics/rays/basis.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::mechanics {
namespace {

constexpr double kZeroPrice =
    1e-11;  // |rho . a_j| / |rho| below which column j counts as in the facet
constexpr double kNoPrice = 1e-14;       // below this a column is in the facet beyond doubt
constexpr double kIllConditioned = 1e6;  // condition from which 1e-9 cannot be guaranteed
constexpr double kMagnified = 1e-8;      // price times condition from which a price matters
constexpr double kSmallPivot =
    1e-8;  // price of an artificial column's row below which no column replaces it
constexpr double kWrongSign = 0.05;  // weight of a pivot that makes a coefficient negative
constexpr double kResumable = 1e-4;  // least relative pivot of a basis to continue from
constexpr int kRefresh = 16;         // pivots between refinements of the inverse
constexpr int kBland = 60;           // pivots towards one target before Bland's rule
constexpr int kGiveUp = 5000;

double squared(const RayBasis::Vector& a) {
  double sum = 0;
  for (const double value : a) sum += value * value;
  return sum;
}

}  // namespace

void RayBasis::begin(const Columns& columns) {
  columns_ = &columns;
  is_doubtful_ = false;
  rows_ = columns.rows();
  K_ = rows_ <= 8 ? 8 : 12;
  inverse_.fill(0);
  matrix_.fill(0);
  per_square_.fill(1);
  for (int r = 0; r < rows_; ++r) {
    inverse_[r * K_ + r] = matrix_[r * K_ + r] = 1;
    head_[r] = r < 6 ? -1 : columns.slack(r - 6);
  }
  since_refresh_ = 0;
}

bool RayBasis::resume(const Columns& columns) {
  if (columns_ == nullptr || columns.rows() != rows_) return false;
  columns_ = &columns;
  is_doubtful_ = false;
  for (int r = 0; r < rows_; ++r) {
    if (head_[r] < 0 || head_[r] >= columns.count()) return false;
    columns.column(head_[r], &matrix_[r * K_]);
  }
  return refactor(kResumable);
}

RayBasis::Vector RayBasis::row(int r) const {
  Vector rho{};
  for (int k = 0; k < rows_; ++k) rho[k] = inverse_[k * K_ + r];
  return rho;
}

double RayBasis::price(const Vector& rho, int j) const {
  Vector entries{};
  columns_->column(j, entries.data());
  double sum = 0;
  for (int i = 0; i < rows_; ++i) sum += rho[i] * entries[i];
  return sum;
}

bool RayBasis::complete(const Vector& target) {
  for (int r = 0; r < rows_; ++r) {
    if (head_[r] >= 0) continue;
    Vector values{};
    kernels::multiply(inverse(), target.data(), values.data());
    Vector rho = row(r);
    const double below = -kSmallPivot * std::sqrt(squared(rho));
    const int against = least_price(rho, below);
    const double least = against < 0 ? 0 : -price(rho, against);
    for (double& value : rho) value = -value;
    const int toward = least_price(rho, below);
    const double most = toward < 0 ? 0 : -price(rho, toward);
    if (against < 0 && toward < 0) {
      const double noise = -kNoPrice * std::sqrt(squared(rho));
      is_doubtful_ = least_price(rho, noise) >= 0 || least_price(row(r), noise) >= 0;
      return false;
    }
    const bool up = values[r] >= 0 ? most >= kWrongSign * least : kWrongSign * most > least;
    pivot(r, up ? toward : against);
  }
  return true;
}

int RayBasis::least_price(const Vector& rho, double below) const {
  return kernels::least_price(rho.data(), columns_->blocks(), columns_->finger_row(),
                              columns_->count() / kernels::kLanes, below);
}

/// Returns the row most against the target by distance, by Bland's rule that of the first column,
/// or -1 if there is none.
int RayBasis::leaving(const Vector& target, double tolerance, bool bland) {
  const double allowed = tolerance * tolerance;
  if (!bland) return kernels::most_against(inverse(), target.data(), allowed);
  Vector values{};
  kernels::multiply(inverse(), target.data(), values.data());
  int first = -1;
  for (int r = 0; r < rows_; ++r) {
    const double value = std::min(0.0, values[r]);
    if (value * value * per_square_[r] <= allowed) continue;
    if (first < 0 || head_[r] < head_[first]) first = r;
  }
  return first;
}

/// Compares the longest wrench with the distance of a column of the basis from the span of the
/// others, which is 1 / |row r| for column r.
bool RayBasis::condition_exceeds(double limit) const {
  const double nearest = *std::min_element(per_square_.begin(), per_square_.begin() + rows_);
  return nearest * limit * limit < columns_->longest() * columns_->longest();
}

bool RayBasis::is_ill_conditioned() const { return condition_exceeds(kIllConditioned); }

/// Returns the column that turns most against row r, by Bland's rule the first that does, or -1 if
/// none does.
int RayBasis::entering(int r, bool bland) {
  const Vector rho = row(r);
  const double length = 1 / std::sqrt(per_square_[r]);
  const double below = -kZeroPrice * length;
  if (!bland) {
    const int q = least_price(rho, -kNoPrice * length);
    const double least = q < 0 ? 0 : price(rho, q);
    if (least < below) return q;
    if (least < 0 && condition_exceeds(kMagnified * length / -least)) is_doubtful_ = true;
    return -1;
  }
  for (int j = 0; j < columns_->count(); ++j) {
    if (price(rho, j) < below) return j;
  }
  return -1;
}

void RayBasis::pivot(int r, int q) {
  Vector column{};
  columns_->column(q, column.data());
  kernels::exchange(inverse(), column.data(), r);
  std::copy_n(column.begin(), K_, &matrix_[r * K_]);
  head_[r] = q;
  ++pivots_;
  if (++since_refresh_ >= kRefresh && !refresh()) is_doubtful_ = true;
}

RayBasis::Outcome RayBasis::reach(const Vector& target, double tolerance) {
  for (int steps = 0; steps < kGiveUp; ++steps) {
    const bool bland = steps > kBland;
    const int r = leaving(target, tolerance, bland);
    if (r < 0) return Outcome::reached;
    const int q = entering(r, bland);
    if (q < 0) {
      refine_facet(r);
      return Outcome::facet;
    }
    pivot(r, q);
  }
  is_doubtful_ = true;  // only rounding errors make it cycle
  return Outcome::facet;
}

}  // namespace graspless::mechanics
