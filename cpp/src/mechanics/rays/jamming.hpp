// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {

/// Problem (5) as geometry: contact forces can cancel each other if and only if 0 lies in the
/// convex hull of the wrenches. Wolfe's algorithm finds the point of the hull nearest to 0; a
/// half-space y . g > 0 that contains all wrenches ends it early. The proof of the last answer for
/// the same mask is tried first.
class Jamming {
 public:
  /// Distance from 0, relative to the longest wrench, below which the hull counts as containing 0.
  static constexpr double kTouch = 1e-9;

  /// Returns true if no forces can cancel. Wrenches of the fingers in `force` do not count.
  bool is_bounded(const EnvironmentWrenches& environment,
                  const std::vector<const FingerWrenches*>& fingers, ForceMask force);
  /// True if rounding errors may have decided the last answer: the hull comes near to 0, and no
  /// point of it was found at 0.
  bool is_doubtful() const { return is_doubtful_; }

 private:
  static constexpr std::size_t kCorners = 7;  // of a simplex in six dimensions
  using Weights = std::array<double, kCorners + 1>;
  /// Corners of the hull, and the weights of a point between them.
  struct Simplex {
    std::size_t count = 0, factored = 0;
    std::array<int, kCorners + 1> corner{};
    Weights weight{};
    std::array<Vector6d, kCorners + 1> g;
    std::array<Weights, kCorners + 1> L;

    Vector6d point() const;
    bool has(int j) const { return std::find(&corner[0], &corner[count], j) != &corner[count]; }
    void append(int j, const Vector6d& wrench, double with);
    void drop(std::size_t at);
    bool factor();
    bool aim(Weights& w);
    bool approach();
  };
  struct Proof {
    bool known = false, bounded = false;
    Vector6d y = Vector6d::Zero();  // if bounded
    Simplex simplex;                // otherwise
  };

  void assign(const EnvironmentWrenches& environment,
              const std::vector<const FingerWrenches*>& fingers, ForceMask force);
  void put(const Matrix6Xd& generators);
  Vector6d wrench(int j) const;
  int least(const Vector6d& y) const;
  bool is_apart(const Vector6d& y, int least) const;
  bool guess(Vector6d& y) const;
  bool wolfe(Vector6d& y, Simplex& s) const;
  bool jams_again(Simplex& s) const;

  bool is_doubtful_ = false;
  int count_ = 0;
  double touch_ = 0;                 // kTouch times the longest wrench
  Vector6d sum_ = Vector6d::Zero();  // of all wrenches
  std::vector<double> blocks_;       // for kernels::least_price()
  std::vector<int> rows_;
  std::array<Proof, 1 << kMaxFingers> proofs_{};
};

}  // namespace graspless::mechanics
