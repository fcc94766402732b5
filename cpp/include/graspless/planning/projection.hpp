// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include <Eigen/Core>

#include "graspless/export.hpp"

namespace graspless::planning {

/// Projects configurations into bands: lower <= value(q) <= upper in every row, within joint
/// limits.
///
/// Takes least-norm Newton steps on the violated rows only (the gradient-based projection of
/// CBiRRT, Berenson et al. 2009), so a row inside its band does not constrain the step. One
/// instance serves one thread.
class GRASPLESS_API BandProjection {
 public:
  static constexpr int kMaxRows = 6;
  static constexpr int kMaxJoints = 16;
  using Values = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxRows, 1>;
  using Jacobian = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxRows, kMaxJoints>;
  /// Writes the rows' values at q and, unless `J` is null, their derivatives (rows x joints).
  using Rows = std::function<void(const Eigen::VectorXd& q, Values& value, Jacobian* J)>;

  struct Bands {
    Values lower, upper;
    Values slack;  ///< per row: distance outside the band that still counts as inside
  };
  struct Limits {
    Eigen::VectorXd lower, upper;  ///< of the joints
  };

  /// Throws std::invalid_argument if sizes differ or exceed the maxima, or a lower bound exceeds
  /// its upper bound.
  BandProjection(Rows rows, Bands bands, Limits limits, int max_iterations = 10);

  /// True if every row lies in its band, widened by the slack.
  bool is_satisfied(const Eigen::VectorXd& q) const;
  bool is_satisfied(const Values& value) const;

  /// Moves q into the bands. Returns false if that takes more than max_iterations or the limits
  /// prevent it; q is modified in either case. Throws std::invalid_argument if q differs from the
  /// limits in size.
  bool project(Eigen::VectorXd& q) const;

 private:
  Rows rows_;
  Bands bands_;
  Values aim_lower_,
      aim_upper_;  // a little inside, so that rounding does not leave a row just outside
  Limits limits_;
  int max_iterations_;
};

}  // namespace graspless::planning
