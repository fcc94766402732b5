// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Problem (5): whether contact forces can grow without bound against each other.
#include "mechanics/jamming.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace graspless::mechanics {
namespace {

constexpr int kGuesses = 6;
constexpr int kMaxSteps = 1000;

auto ix(int i) { return static_cast<std::size_t>(i); }

}  // namespace

void Jamming::assign(const EnvironmentWrenches& environment,
                     const std::vector<const FingerWrenches*>& fingers, ForceMask force) {
  const auto jam = [](const auto& part) -> const Matrix6Xd& {
    return part.jam_generators.cols() > 0 ? part.jam_generators : part.generators;
  };
  std::array<const Matrix6Xd*, 1 + kMaxFingers> parts{&jam(environment)};
  int used = 1;
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    if ((force >> i & 1U) == 0) parts[ix(used++)] = &jam(*fingers[i]);
  }
  count_ = 0;
  for (int p = 0; p < used; ++p) count_ += static_cast<int>(parts[ix(p)]->cols());
  stride_ = (count_ + 7) / 8 * 8;
  table_.assign(ix(6 * stride_), 0.0);
  dots_.resize(ix(stride_));
  int next = 0;
  for (int p = 0; p < used; ++p) {
    for (Eigen::Index j = 0; j < parts[ix(p)]->cols(); ++j, ++next) {
      const Vector6d unit = parts[ix(p)]->col(j).normalized();
      for (int i = 0; i < 6; ++i) table_[ix(i * stride_ + next)] = unit[i];
    }
  }
}

/// The wrench farthest against y.
int Jamming::least(const Vector6d& y, double* value) {
  std::fill(dots_.begin(), dots_.end(), 0.0);
  for (int i = 0; i < 6; ++i) {
    const double* row = &table_[ix(i * stride_)];
    for (int j = 0; j < stride_; ++j) dots_[ix(j)] += y[i] * row[j];
  }
  const auto found = std::min_element(dots_.begin(), dots_.begin() + count_);
  *value = *found;
  return static_cast<int>(found - dots_.begin());
}

/// A few steps of the perceptron from the last half-space: the common case ends here.
bool Jamming::guess() {
  for (int step = 0; step < kGuesses; ++step) {
    double value = 0;
    const int j = least(y_, &value);
    if (value > kTouch * y_.norm()) return true;
    for (int i = 0; i < 6; ++i) y_[i] += (1e-3 - 1.5 * value) * table_[ix(i * stride_ + j)];
  }
  return false;
}

/// Weights (of sum 1) of the point nearest to 0 in the affine hull of the corners. False when they
/// are affinely dependent.
bool Jamming::nearest_of_corners(int count, double* weights) const {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 7, 7> gram(count, count);
  for (int a = 0; a < count; ++a) {
    for (int b = 0; b <= a; ++b) {
      double sum =
          1;  // + e e': the solution of (G + e e') w = e, scaled, is that of the affine hull
      for (int i = 0; i < 6; ++i) {
        sum +=
            table_[ix(i * stride_ + corners_[ix(a)])] * table_[ix(i * stride_ + corners_[ix(b)])];
      }
      gram(a, b) = gram(b, a) = sum;
    }
  }
  const Eigen::LLT<decltype(gram)> llt(gram);
  if (llt.info() != Eigen::Success) return false;
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 7, 1>> w(weights, count);
  w = llt.solve(Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 7, 1>::Ones(count));
  w /= w.sum();
  return w.allFinite();
}

/// Whether the hull stays away from 0.
bool Jamming::wolfe() {
  const auto corner = [&](int j) {
    Vector6d g;
    for (int i = 0; i < 6; ++i) g[i] = table_[ix(i * stride_ + j)];
    return g;
  };
  std::array<double, 8> weights{1};
  int count = 1;
  corners_[0] = 0;
  y_ = corner(0);
  for (int step = 0; step < kMaxSteps; ++step) {
    double value = 0;
    const int entering = least(y_, &value);
    if (value > kTouch * y_.norm()) return true;
    if (y_.norm() < kTouch || count == 7) return false;
    if (std::find(corners_.begin(), corners_.begin() + count, entering) !=
        corners_.begin() + count) {
      return y_.norm() >= kTouch;  // no corner is nearer, to rounding
    }
    corners_[ix(count)] = entering;
    weights[ix(count++)] = 0;
    for (;;) {  // towards the nearest point of the affine hull, as far as weights stay positive
      std::array<double, 8> aim{};
      if (!nearest_of_corners(count, aim.data())) return false;
      double far = 1;
      int leaving = -1;
      for (int i = 0; i < count; ++i) {
        if (aim[ix(i)] > 1e-14) continue;
        const double reach = weights[ix(i)] / (weights[ix(i)] - aim[ix(i)]);
        if (leaving >= 0 && reach >= far) continue;
        far = std::min(far, reach);
        leaving = i;
      }
      if (leaving < 0) far = 1;
      for (int i = 0; i < count; ++i) weights[ix(i)] += far * (aim[ix(i)] - weights[ix(i)]);
      if (leaving < 0) break;
      std::copy(corners_.begin() + leaving + 1, corners_.begin() + count,
                corners_.begin() + leaving);
      std::copy(weights.begin() + leaving + 1, weights.begin() + count, weights.begin() + leaving);
      --count;
    }
    y_.setZero();
    for (int i = 0; i < count; ++i) y_ += weights[ix(i)] * corner(corners_[ix(i)]);
  }
  return false;
}

bool Jamming::is_bounded(const EnvironmentWrenches& environment,
                         const std::vector<const FingerWrenches*>& fingers, ForceMask force) {
  assign(environment, fingers, force);
  if (count_ == 0) return true;
  if (known_[force]) {
    y_ = last_[force];
  } else {
    for (int i = 0; i < 6; ++i) {
      y_[i] = Eigen::Map<const Eigen::VectorXd>(&table_[ix(i * stride_)], count_).mean();
    }
  }
  const bool bounded = guess() || wolfe();
  if (bounded) {
    last_[force] = y_;
    known_[force] = true;
  }
  return bounded;
}

}  // namespace graspless::mechanics
