// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::robot {

/// Equivalent values of a group's joints: those a whole number of turns apart and within the
/// limits. A joint may have a range of several turns, or limits that exclude 0.
class Wraps {
 public:
  /// `turns` is false for joints with no equivalent values (prismatic, or mimicked by another).
  /// With `copies`, append() gives all equivalents, otherwise the one nearest to q.
  Wraps(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, std::vector<int> group,
        std::vector<bool> turns, bool copies);

  int size() const { return static_cast<int>(group_.size()); }
  const std::vector<int>& group() const { return group_; }

  /// True if the i-th joint has an equivalent of `value` within its limits.
  bool fits(int i, double value) const {
    return (value >= lower_[i] && value <= upper_[i]) ||
           (turns_[i] && first(i, value) <= upper_[i]);
  }

  /// Moves a value that does not fit onto a limit within `slack` [rad]; false if there is none.
  bool nudge(int i, double slack, double& value) const;

  /// Appends `q` with the group at each combination of equivalents of `values` within the limits,
  /// after the first `count` columns of `solutions`. Returns the new count. Grows `solutions` if it
  /// is full.
  int append(const double* values, const Eigen::VectorXd& q, int count,
             Eigen::MatrixXd& solutions) const;

 private:
  /// Finds up to three equivalents for the i-th joint, the nearest to `near` first; returns their
  /// number.
  int values(int i, double value, double near, double* found) const;
  double first(int i, double value) const;  // smallest equivalent that is not below the lower limit

  std::vector<int> group_;
  std::vector<bool> turns_;
  bool copies_;
  std::vector<bool> several_;                  // true if several equivalents may fit
  Eigen::VectorXd lower_, upper_;              // limits of the group, widened for rounding
  Eigen::VectorXd exact_lower_, exact_upper_;  // the same, not widened
};

}  // namespace graspless::robot
