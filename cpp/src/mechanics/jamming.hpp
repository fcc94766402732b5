// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::mechanics {

/// Problem (5) as geometry: contact forces can cancel each other iff 0 lies in the convex hull of
/// the unit wrenches. Wolfe's algorithm for the hull's point nearest to 0; a half-space y . g > 0
/// that holds all wrenches ends it early, and those of former calls are tried first.
class Jamming {
 public:
  /// Nearer to 0 than this counts as a hull that holds 0.
  static constexpr double kTouch = 1e-9;

  /// Whether no forces cancel. `force`: whose wrenches do not count.
  bool is_bounded(const EnvironmentWrenches& environment,
                  const std::vector<const FingerWrenches*>& fingers, ForceMask force);

 private:
  void assign(const EnvironmentWrenches& environment,
              const std::vector<const FingerWrenches*>& fingers, ForceMask force);
  int least(const Vector6d& y, double* value);
  bool guess();
  bool wolfe();
  bool nearest_of_corners(int count, double* weights) const;

  int count_ = 0, stride_ = 0;
  std::vector<double> table_;  // unit wrenches, rows of numbers
  std::vector<double> dots_;
  std::array<Vector6d, 1 << kMaxFingers> last_{};  // the half-space found last, for each mask
  std::array<bool, 1 << kMaxFingers> known_{};
  std::array<int, 8> corners_{};
  Vector6d y_ = Vector6d::Zero();
};

}  // namespace graspless::mechanics
