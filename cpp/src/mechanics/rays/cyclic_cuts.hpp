// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "graspless/mechanics/stability_solver.hpp"

#include "mechanics/rays/basis.hpp"
#include "mechanics/rays/cuts.hpp"

namespace graspless::mechanics {

/// Problem (6) by ray shots and cuts, for one instant and one combination of control modes at a
/// time.
class CyclicCuts {
 public:
  explicit CyclicCuts(const Matrix6Xd& directions);

  struct Result {
    double z = 0;                             ///< upper bound if z < needed is proven
    std::array<double, kMaxFingers> f_com{};  ///< of all fingers
    bool is_doubtful = false;                 ///< z and f_com may be rounding errors
  };
  /// Continues from the last bases; begins anew if rounding errors may have decided then.
  Result solve(const std::vector<const EnvironmentWrenches*>& environments,
               const std::vector<const FingerWrenches*>& fingers, ForceMask force, double needed);
  /// Directions along which (1 + 1e-9) z or z + 1e-9 is out of reach. Call after solve(), unless
  /// that was doubtful.
  std::vector<int> binding();
  /// True if rounding errors may have decided since solve() began.
  bool is_doubtful() const;
  /// The directions, as given.
  const Matrix6Xd& directions() const { return directions_; }

  std::vector<Vector6d>& supports() { return supports_; }
  std::int64_t pivots() const;

 private:
  Result attempt(const std::vector<const EnvironmentWrenches*>& environments,
                 const std::vector<const FingerWrenches*>& fingers, ForceMask force, double needed);
  bool prepare(const std::vector<const EnvironmentWrenches*>& environments,
               const std::vector<const FingerWrenches*>& fingers, ForceMask force);
  RayBasis::Vector target(std::size_t environment, int direction, double z) const;
  double distance(double z) const;
  int sweep(std::size_t environment, double z);
  bool certify(std::size_t environment, double z);
  Cuts::Cut cut(std::size_t environment) const;
  void keep_support(const RayBasis::Vector& facet);
  Result finish() const;

  Matrix6Xd directions_;
  int count_;
  double longest_;  // length of the longest direction

  /// Order of the directions: those whose targets are not reached yet come first, in blocks for
  /// kernels::slacks().
  struct Unreached {
    int left = 0;
    std::vector<int> order;
    std::vector<double> table, slack;
    void restart(const Matrix6Xd& all);
    double* place(int at, int axis);
    void remove(int at);
  };
  struct Environment {
    Columns columns;
    RayBasis basis;
    Vector6d known;
    Unreached unreached;
  };
  std::vector<Environment> environments_;
  std::size_t used_ = 0;
  std::array<double, kMaxFingers> limit_{};
  std::array<int, kMaxFingers> dim_{};  // of the model, a finger; -1: position control
  int fingers_ = 0, dims_ = 0;
  double force_scale_ = 1, tolerance_ = 0;
  Cuts model_;
  int critical_ = 0;
  std::vector<Vector6d> supports_;
};

}  // namespace graspless::mechanics
