// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Master problem of (6): upper bound on z, a concave function of f_com.
#include "mechanics/rays/cuts.hpp"

#include <algorithm>
#include <cmath>

#include "mechanics/rays/kernels.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kTight = 1e-14;  // relative excess that counts as zero
constexpr int kMaxPivots = 200;   // never seen above 10; limits cycles

}  // namespace

void Cuts::begin(int dims, const double* upper, double ceiling) {
  n_ = dims + 1;
  rows_.clear();
  rows_.reserve(64);
  scale_ = 1;
  for (int k = 0; k < n_; ++k) {
    Row least{}, most{};
    most[k] = 1;
    most[n_] = k == 0 ? ceiling : upper[k - 1];
    least[k] = -1;
    if (k > 0) rows_.push_back(least);
    rows_.push_back(most);
    active_[k] = most;
    inverse_[k].fill(0);
    inverse_[k][k] = 1;
    weight_[k] = k == 0 ? 1 : 0;
    if (k > 0) scale_ = std::max(scale_, upper[k - 1]);
  }
  locate();
}

double Cuts::at(const Cut& cut) const {
  double value = cut.a;
  for (int k = 1; k < n_; ++k) value += cut.b[k - 1] * v_[k];
  return value;
}

/// Violation of a row by (z, f), per unit of its coefficients.
double Cuts::excess(const Row& row) const {
  double value = -row[n_], size = 0;
  for (int k = 0; k < n_; ++k) {
    value += row[k] * v_[k];
    size = std::max(size, std::abs(row[k]));
  }
  return value / size;
}

/// Computes (z, f) from the active rows, with one step of refinement.
void Cuts::locate() {
  std::array<double, kDims> residual{};
  v_.fill(0);
  for (int step = 0; step < 2; ++step) {
    for (int i = 0; i < n_; ++i) {
      const Row& row = active_[i];
      double sum = row[n_];
      for (int k = 0; k < n_; ++k) sum -= row[k] * v_[k];
      residual[i] = sum;
    }
    for (int k = 0; k < n_; ++k) {
      for (int i = 0; i < n_; ++i) {
        v_[k] += inverse_[k][i] * residual[i];
      }
    }
  }
}

/// Pivots: the row becomes active in place of the one whose weight vanishes first.
void Cuts::make_active(const Row& row) {
  std::array<double, kDims> share{};  // row = sum of share * active
  int leaving = -1;
  double least = 0;
  for (int i = 0; i < n_; ++i) {
    double sum = 0;
    for (int k = 0; k < n_; ++k) {
      sum += row[k] * inverse_[k][i];
    }
    share[i] = sum;
    if (sum <= 1e-12) continue;
    const double ratio = weight_[i] / sum;
    if (leaving >= 0 && (ratio > least || (ratio == least && sum < share[leaving]))) {
      continue;
    }
    leaving = i;
    least = ratio;
  }
  if (leaving < 0) return;  // only rounding errors lead here
  const double pivot = share[leaving];
  for (int i = 0; i < n_; ++i) {
    if (i != leaving) {
      weight_[i] = std::max(0.0, weight_[i] - least * share[i]);
    }
  }
  weight_[leaving] = least;
  for (int k = 0; k < n_; ++k) {
    auto& line = inverse_[k];
    line[leaving] /= pivot;
    for (int i = 0; i < n_; ++i) {
      if (i != leaving) line[i] -= share[i] * line[leaving];
    }
  }
  active_[leaving] = row;
}

bool Cuts::add(const Cut& cut) {
  const std::array<double, kDims> before = v_;
  Row row{};
  row[0] = 1;
  for (int k = 1; k < n_; ++k) row[k] = -cut.b[k - 1];
  row[n_] = cut.a;
  rows_.push_back(row);
  for (int pivot = 0; pivot < kMaxPivots; ++pivot) {
    const Row* worst = nullptr;
    double most = kTight * std::max(scale_, std::abs(v_[0]));
    for (const Row& candidate : rows_) {
      const double value = excess(candidate);
      if (value <= most) continue;
      most = value;
      worst = &candidate;
    }
    if (worst == nullptr) break;
    make_active(*worst);
    locate();
  }
  return v_ != before;
}

}  // namespace graspless::mechanics
