// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Problem (5): whether contact forces can grow without bound against each other.
#include "mechanics/rays/jamming.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/rays/kernels.hpp"

namespace graspless::mechanics {
namespace {

using kernels::kBlock;
using kernels::kLanes;

constexpr int kGuesses = 2;
constexpr int kMaxSteps = 1000;
constexpr double kNone = 1e-14;  // weight that counts as 0
constexpr double kHeld = 1e-3;   // fraction of kTouch within which the hull contains 0 beyond doubt

}  // namespace

void Jamming::put(const Matrix6Xd& generators) {
  for (Eigen::Index j = 0; j < generators.cols(); ++j, ++count_) {
    double* entry = &blocks_[count_ / kLanes * kBlock + count_ % kLanes];
    for (int i = 0; i < 6; ++i) entry[i * kLanes] = generators(i, j);
    touch_ = std::max(touch_, generators.col(j).squaredNorm());
    sum_ += generators.col(j);
  }
}

void Jamming::assign(const EnvironmentWrenches& environment,
                     const std::vector<const FingerWrenches*>& fingers, ForceMask force) {
  const auto jam = [](const auto& part) -> const Matrix6Xd& {
    return part.jam_generators.cols() > 0 ? part.jam_generators : part.generators;
  };
  Eigen::Index columns = jam(environment).cols();
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    if ((force >> i & 1U) == 0) columns += jam(*fingers[i]).cols();
  }
  rows_.assign((columns + kLanes - 1) / kLanes, 6);
  blocks_.assign(rows_.size() * kBlock, 0.0);
  count_ = 0;
  touch_ = 0;
  sum_.setZero();
  put(jam(environment));
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    if ((force >> i & 1U) == 0) put(jam(*fingers[i]));
  }
  touch_ = kTouch * std::sqrt(touch_);
  for (int j = count_; count_ > 0 && j % kLanes != 0;
       ++j) {  // pads with copies of the first column
    for (int i = 0; i < 6; ++i) {
      blocks_[j / kLanes * kBlock + i * kLanes + j % kLanes] = blocks_[i * kLanes];
    }
  }
}

Vector6d Jamming::wrench(int j) const {
  Vector6d g;
  const double* entry = &blocks_[j / kLanes * kBlock + j % kLanes];
  for (int i = 0; i < 6; ++i) g[i] = entry[i * kLanes];
  return g;
}

/// Returns the wrench farthest against y.
int Jamming::least(const Vector6d& y) const {
  std::array<double, 7> rho{};
  std::copy_n(y.data(), 6, rho.begin());
  const int j =
      kernels::least_price(rho.data(), blocks_.data(), rows_.data(), static_cast<int>(rows_.size()),
                           std::numeric_limits<double>::max());
  return j < count_ ? j : 0;
}

/// Returns true if the half-space of y contains all wrenches. `least` is the farthest one against
/// it.
bool Jamming::is_apart(const Vector6d& y, int least) const {
  return y.dot(wrench(least)) > touch_ * y.norm();
}

/// Tries a few steps of the perceptron, which settle the common case.
bool Jamming::guess(Vector6d& y) const {
  for (int step = 0; step < kGuesses; ++step) {
    const int j = least(y);
    if (is_apart(y, j)) return true;
    const Vector6d g = wrench(j);
    y += (1e-3 - 1.5 * y.dot(g) / g.squaredNorm()) * g;
  }
  return false;
}

Vector6d Jamming::Simplex::point() const {
  Vector6d sum = Vector6d::Zero();
  for (std::size_t i = 0; i < count; ++i) sum += weight[i] * g[i];
  return sum;
}

void Jamming::Simplex::append(int j, const Vector6d& wrench, double with) {
  corner[count] = j;
  g[count] = wrench;
  weight[count++] = with;
}

void Jamming::Simplex::drop(std::size_t at) {
  --count;
  factored = std::min(factored, at);
  for (std::size_t i = at; i < count; ++i) {
    corner[i] = corner[i + 1];
    weight[i] = weight[i + 1];
    g[i] = g[i + 1];
  }
}

/// Completes the factor L of G + e e', where G is the Gram matrix. Returns false if the corners are
/// affinely dependent.
bool Jamming::Simplex::factor() {
  for (; factored < count; ++factored) {
    const std::size_t a = factored;
    for (std::size_t b = 0; b <= a; ++b) {
      const double whole = 1 + g[a].dot(g[b]);
      double sum = whole;
      for (std::size_t k = 0; k < b; ++k) sum -= L[a][k] * L[b][k];
      if (a == b && !(sum > kNone * whole)) return false;
      L[a][b] = a == b ? 1 / std::sqrt(sum) : sum * L[b][b];  // the diagonal holds inverses
    }
  }
  return true;
}

/// Computes the weights (of sum 1) of the point nearest to 0 in the affine hull of the corners,
/// from (G + e e') w = e. Returns false if the corners are affinely dependent.
bool Jamming::Simplex::aim(Weights& w) {
  if (!factor()) return false;
  for (std::size_t a = 0; a < count; ++a) {
    double sum = 1;
    for (std::size_t k = 0; k < a; ++k) sum -= L[a][k] * w[k];
    w[a] = sum * L[a][a];
  }
  double total = 0;
  for (std::size_t a = count; a-- > 0;) {
    for (std::size_t k = a + 1; k < count; ++k) w[a] -= L[k][a] * w[k];
    total += w[a] *= L[a][a];
  }
  for (std::size_t a = 0; a < count; ++a) w[a] /= total;
  return std::isfinite(total) && total > 0;
}

/// Moves to the nearest point of the affine hull as far as weights stay positive, and drops corners
/// that stop it. Returns false if the corners are affinely dependent.
bool Jamming::Simplex::approach() {
  for (;;) {
    Weights target{};
    if (!aim(target)) return false;
    double reach = 1;
    std::size_t leaving = count;
    for (std::size_t i = 0; i < count; ++i) {
      if (target[i] > kNone) continue;
      const double stop = weight[i] / std::max(weight[i] - target[i], kNone);
      if (leaving < count && stop >= reach) continue;
      reach = std::min(reach, stop);
      leaving = i;
    }
    for (std::size_t i = 0; i < count; ++i) weight[i] += reach * (target[i] - weight[i]);
    if (leaving == count) return true;
    drop(leaving);
  }
}

/// Returns true if the hull stays away from 0, which y then proves. Otherwise the simplex proves
/// that it does not.
bool Jamming::wolfe(Vector6d& y, Simplex& s) const {
  for (int step = 0; step < kMaxSteps; ++step) {
    y = s.point();
    if (s.count == kCorners || y.norm() < touch_) return false;
    const int entering = least(y);
    if (is_apart(y, entering)) return true;
    if (s.has(entering)) return false;  // 0 up to rounding
    s.append(entering, wrench(entering), 0);
    if (!s.approach()) return false;
  }
  return false;
}

/// Returns true if the corners of the last proof jam again.
bool Jamming::jams_again(Simplex& s) const {
  s.factored = 0;
  for (std::size_t i = 0; i < s.count; ++i) {
    if (s.corner[i] >= count_) return false;
    s.g[i] = wrench(s.corner[i]);
  }
  if (!s.aim(s.weight)) return false;
  for (std::size_t i = 0; i < s.count; ++i) {
    if (!(s.weight[i] > 0)) return false;
  }
  return s.point().norm() < touch_;
}

bool Jamming::is_bounded(const EnvironmentWrenches& environment,
                         const std::vector<const FingerWrenches*>& fingers, ForceMask force) {
  assign(environment, fingers, force);
  is_doubtful_ = false;
  if (count_ == 0) return true;
  Proof& last = proofs_[force];
  if (last.known && !last.bounded && jams_again(last.simplex)) {
    is_doubtful_ = last.simplex.point().norm() > kHeld * touch_;
    return false;
  }
  Vector6d y = last.known && last.bounded ? last.y : sum_;
  last.known = true;
  last.bounded = guess(y);
  if (!last.bounded) {
    Simplex& s = last.simplex;
    s.count = s.factored = 0;
    const int first = least(y);
    s.append(first, wrench(first), 1);
    last.bounded = wolfe(y, s);
  }
  if (last.bounded) last.y = y;
  is_doubtful_ = !last.bounded && last.simplex.point().norm() > kHeld * touch_;
  return last.bounded;
}

}  // namespace graspless::mechanics
