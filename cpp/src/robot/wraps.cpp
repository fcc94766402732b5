// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/wraps.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::robot {
namespace {

constexpr double kTurn = 2 * M_PI;
constexpr double kSlack =
    1e-11;  // an answer this far outside is taken for one on the limit [rad or m]

}  // namespace

Wraps::Wraps(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, std::vector<int> group,
             std::vector<bool> turns)
    : group_(std::move(group)), turns_(std::move(turns)) {
  const auto n = static_cast<Eigen::Index>(group_.size());
  exact_lower_.resize(n);
  exact_upper_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    exact_lower_[i] = lower[group_[i]];
    exact_upper_[i] = upper[group_[i]];
  }
  lower_ = exact_lower_.array() - kSlack;
  upper_ = exact_upper_.array() + kSlack;
}

double Wraps::first(int i, double value) const {
  return value + kTurn * std::ceil((lower_[i] - value) / kTurn);
}

int Wraps::append(const double* values, const Eigen::VectorXd& q, int count,
                  Eigen::MatrixXd& solutions) const {
  const int begin = count;
  const auto push = [&](Eigen::Index from) {
    if (solutions.rows() != q.size() || solutions.cols() <= count) {
      solutions.conservativeResize(q.size(), std::max<Eigen::Index>(16, 2 * count));
    }
    if (from < 0) {
      solutions.col(count) = q;
    } else {
      solutions.col(count) = solutions.col(from);
    }
    return count++;
  };
  push(-1);
  for (int i = 0; i < size(); ++i) {
    const int end = count;  // each solution so far gets every value of joint i
    double value = turns_[i] ? first(i, values[i]) : values[i];
    if (!(value >= lower_[i] && value <= upper_[i])) return begin;
    for (bool is_first = true; value <= upper_[i]; value += kTurn, is_first = false) {
      const double clamped = std::clamp(value, exact_lower_[i], exact_upper_[i]);
      for (int k = begin; k < end; ++k) {
        const int column = is_first ? k : push(k);
        solutions(group_[i], column) = clamped;
      }
      if (!turns_[i]) break;
    }
  }
  return count;
}

}  // namespace graspless::robot
