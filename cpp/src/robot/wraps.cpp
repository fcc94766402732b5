// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/wraps.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::robot {
namespace {

constexpr double kTurn = 2 * M_PI;

// A solution this far outside counts as on the limit [rad or m].
constexpr double kSlack = 2e-13;

}  // namespace

Wraps::Wraps(const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, std::vector<int> group,
             std::vector<bool> turns, bool copies)
    : group_(std::move(group)), turns_(std::move(turns)), copies_(copies) {
  const auto n = static_cast<Eigen::Index>(group_.size());
  exact_lower_.resize(n);
  exact_upper_.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    exact_lower_[i] = lower[group_[i]];
    exact_upper_[i] = upper[group_[i]];
  }
  lower_ = exact_lower_.array() - kSlack;
  upper_ = exact_upper_.array() + kSlack;
  for (Eigen::Index i = 0; i < n; ++i)
    several_.push_back(turns_[i] && upper_[i] - lower_[i] >= kTurn);
}

double Wraps::first(int i, double value) const {
  return value + kTurn * std::ceil((lower_[i] - value) / kTurn);
}

bool Wraps::nudge(int i, double slack, double& value) const {
  if (slack <= kSlack) return false;
  for (const double limit : {exact_lower_[i], exact_upper_[i]}) {
    if (std::abs(turns_[i] ? std::remainder(value - limit, kTurn) : value - limit) > slack)
      continue;
    value = limit;
    return true;
  }
  return false;
}

int Wraps::values(int i, double value, double near, double* found) const {
  const double lower = lower_[i], upper = upper_[i];
  if (value >= lower && value <= upper) {
    found[0] = value;
    if (!several_[i] || (value - kTurn < lower && value + kTurn > upper)) return 1;
  } else {
    if (!fits(i, value)) return 0;
    found[0] = first(i, value);
    if (!several_[i]) return 1;
  }
  const double away = near - value;
  const double turns = std::abs(away) < 3 ? 0 : std::round(away / kTurn);
  const double nearest = value + kTurn * turns;
  int count = 0;
  for (const double more : {0.0, -1.0, 1.0}) {
    const double wrap = nearest + more * kTurn;
    if (wrap < lower || wrap > upper) continue;
    found[count++] = wrap;
    if (!copies_) break;
  }
  return count;
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
    double wraps[3];
    const double near = std::clamp(q[group_[i]], exact_lower_[i], exact_upper_[i]);
    const int found = this->values(i, values[i], near, wraps);
    if (found == 0) return begin;
    const int end = count;  // each solution so far gets every value of joint i
    for (int w = 0; w < found; ++w) {
      const double value = std::clamp(wraps[w], exact_lower_[i], exact_upper_[i]);
      for (int k = begin; k < end; ++k) solutions(group_[i], w == 0 ? k : push(k)) = value;
    }
  }
  return count;
}

}  // namespace graspless::robot
