// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::robot {

/// The joints of a group with their limits: which values, a whole number of turns apart, put the
/// robot in the same place. A joint may turn more than once around, or have limits that leave out
/// 0.
class Wraps {
 public:
  /// A joint that does not turn (prismatic, or mimicked by another) only has the value itself.
  Wraps(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, std::vector<int> group,
        std::vector<bool> turns);

  int size() const { return static_cast<int>(group_.size()); }
  const std::vector<int>& group() const { return group_; }

  /// Whether the i-th joint of the group has a value within its limits.
  bool fits(int i, double value) const {
    return (value >= lower_[i] && value <= upper_[i]) ||
           (turns_[i] && first(i, value) <= upper_[i]);
  }

  /// Puts a value that does not fit onto a limit that is no farther than `slack`.
  bool nudge(int i, double slack, double& value) const;

  /// Appends `q` with the group at `values`, in all wraps within the limits, to the first `count`
  /// columns of `solutions`; returns the new count. Grows `solutions` when it is full.
  int append(const double* values, const Eigen::VectorXd& q, int count,
             Eigen::MatrixXd& solutions) const;

 private:
  /// Up to three values of the i-th joint, the nearest to `near` first.
  int values(int i, double value, double near, double* found) const;
  double first(int i, double value) const;  // the smallest wrap that is not below the lower limit

  std::vector<int> group_;
  std::vector<bool> turns_;
  std::vector<bool> several_;                  // wide enough for more than one
  Eigen::VectorXd lower_, upper_;              // of the group, with a slack for rounding
  Eigen::VectorXd exact_lower_, exact_upper_;  // without
};

}  // namespace graspless::robot
