// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A dual simplex without costs: from one target to the next with few pivots.
#include "mechanics/ray_basis.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <Eigen/LU>

namespace graspless::mechanics {
namespace {

constexpr double kZeroPrice = 1e-11;  // |rho . a_j| / |rho| below which column j lies in the facet
constexpr double kSmallPivot = 1e-8;  // of an artificial column's row: the columns do not span
constexpr double kWrongSign =
    0.05;                     // worth of a pivot that makes the target's coefficient negative
constexpr int kRefresh = 16;  // pivots between refreshments of the inverse
constexpr int kBland = 60;    // pivots towards one target before Bland's rule
constexpr int kGiveUp = 5000;

auto ix(int i) { return static_cast<std::size_t>(i); }

double dot(const RayBasis::Vector& a, const RayBasis::Vector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

void RayBasis::begin(const Columns& columns) {
  columns_ = &columns;
  rows_ = columns.rows();
  prices_.resize(ix(columns.stride()));
  lengths_.fill(1);
  facet_.fill(0);
  for (int r = 0; r < kStride; ++r) {
    inverse_[ix(r)].fill(0);
    matrix_[ix(r)].fill(0);
    if (r >= rows_) continue;
    inverse_[ix(r)][ix(r)] = matrix_[ix(r)][ix(r)] = 1;
    head_[ix(r)] = r < 6 ? -1 : columns.slack(r - 6);
  }
  since_refresh_ = 0;
}

bool RayBasis::complete(const Vector& target) {
  for (int r = 0; r < rows_; ++r) {
    if (head_[ix(r)] >= 0) continue;
    const double sign = dot(inverse_[ix(r)], target) < 0 ? -1 : 1;
    columns_->price(inverse_[ix(r)].data(), prices_.data());
    int q = -1;
    double best = kSmallPivot * std::sqrt(lengths_[ix(r)]);
    for (int j = 0; j < columns_->count(); ++j) {
      const double price = sign * prices_[ix(j)];
      const double worth = price > 0 ? price : -kWrongSign * price;
      if (worth <= best) continue;
      best = worth;
      q = j;
    }
    if (q < 0) return false;
    pivot(r, q);
  }
  return true;
}

/// The row most against the target, by distance; Bland: of the least column.
int RayBasis::leaving(const Vector& target, double tolerance, bool bland) const {
  int r = -1;
  double worst = tolerance * tolerance * dot(target, target);
  for (int i = 0; i < rows_; ++i) {
    const double value = dot(inverse_[ix(i)], target);
    if (value >= 0) continue;
    const double distance = value * value / lengths_[ix(i)];
    if (bland ? distance <= tolerance * tolerance * dot(target, target) ||
                    (r >= 0 && head_[ix(i)] > head_[ix(r)])
              : distance <= worst) {
      continue;
    }
    worst = distance;
    r = i;
  }
  return r;
}

/// The column that turns most against row r (of this sign); Bland: the first. -1: none does.
int RayBasis::entering(int r, double sign, bool bland) {
  columns_->price(inverse_[ix(r)].data(), prices_.data());
  const double zero = -kZeroPrice * std::sqrt(lengths_[ix(r)]);
  int q = -1;
  double least = zero;
  for (int j = 0; j < columns_->count(); ++j) {
    const double price = sign * prices_[ix(j)];
    if (price >= least) continue;
    least = bland ? -1e300 : price;
    q = j;
  }
  return q;
}

void RayBasis::pivot(int r, int q) {
  Vector column{};
  for (int i = 0; i < rows_; ++i) column[ix(i)] = columns_->entry(i, q);
  Vector& leading = inverse_[ix(r)];
  const double scale = 1 / dot(leading, column);
  for (double& value : leading) value *= scale;
  for (int i = 0; i < rows_; ++i) {
    if (i == r) continue;
    Vector& row = inverse_[ix(i)];
    const double factor = dot(row, column);
    for (std::size_t k = 0; k < row.size(); ++k) row[k] -= factor * leading[k];
  }
  head_[ix(r)] = q;
  for (int i = 0; i < rows_; ++i) matrix_[ix(i)][ix(r)] = column[ix(i)];
  ++pivots_;
  if (++since_refresh_ >= kRefresh) refresh();
  for (int i = 0; i < rows_; ++i) lengths_[ix(i)] = dot(inverse_[ix(i)], inverse_[ix(i)]);
}

/// A Newton step X += X (I - B X) towards the inverse; from scratch when it has drifted far.
void RayBasis::refresh() {
  since_refresh_ = 0;
  std::array<Vector, kStride> miss;
  double largest = 0;
  for (int i = 0; i < rows_; ++i) {
    Vector& line = miss[ix(i)];
    line.fill(0);
    line[ix(i)] = 1;
    for (int k = 0; k < rows_; ++k) {
      const double b = matrix_[ix(i)][ix(k)];
      for (std::size_t j = 0; j < line.size(); ++j) line[j] -= b * inverse_[ix(k)][j];
    }
    for (double value : line) largest = std::max(largest, std::abs(value));
  }
  if (!(largest < 1e-6)) return refactor();
  for (int i = 0; i < rows_; ++i) {
    Vector step{};
    for (int k = 0; k < rows_; ++k) {
      const double x = inverse_[ix(i)][ix(k)];
      for (std::size_t j = 0; j < step.size(); ++j) step[j] += x * miss[ix(k)][j];
    }
    for (std::size_t j = 0; j < step.size(); ++j) inverse_[ix(i)][j] += step[j];
  }
}

void RayBasis::refactor() {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kStride, kStride> B(rows_, rows_);
  for (int i = 0; i < rows_; ++i) {
    for (int j = 0; j < rows_; ++j) B(i, j) = matrix_[ix(i)][ix(j)];
  }
  const auto inverse = B.fullPivLu().inverse().eval();
  for (int i = 0; i < rows_; ++i) {
    for (int j = 0; j < rows_; ++j) inverse_[ix(i)][ix(j)] = inverse(i, j);
  }
}

/// Row r of the inverse with one step of refinement: rho += (e_r - rho B) X.
void RayBasis::refine_facet(int r) {
  facet_ = inverse_[ix(r)];
  Vector miss{};
  miss[ix(r)] = 1;
  for (int k = 0; k < rows_; ++k) {
    const double rho = inverse_[ix(r)][ix(k)];
    for (std::size_t j = 0; j < miss.size(); ++j) miss[j] -= rho * matrix_[ix(k)][j];
  }
  for (int k = 0; k < rows_; ++k) {
    for (std::size_t j = 0; j < miss.size(); ++j) facet_[j] += miss[ix(k)] * inverse_[ix(k)][j];
  }
}

RayBasis::Outcome RayBasis::reach(const Vector& target, double tolerance) {
  for (int steps = 0; steps < kGiveUp; ++steps) {
    const bool bland = steps > kBland;
    const int r = leaving(target, tolerance, bland);
    if (r < 0) return Outcome::reached;
    const int q = entering(r, 1, bland);
    if (q < 0) {
      refine_facet(r);
      return Outcome::facet;
    }
    pivot(r, q);
  }
  throw std::logic_error("a ray shot did not end");
}

}  // namespace graspless::mechanics
