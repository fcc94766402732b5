// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pinch/press.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graspless::pinch {

namespace {

constexpr double kGrip = 0.5;   // part of its effort limit with which a joint grips
constexpr double kIdle = 1e-3;  // a joint that moves the fingers less does not press [m/rad or 1]

}  // namespace

Press::Press(const Problem& problem, const Options& options, const Jaw& jaw) {
  const Eigen::VectorXd& limits = problem.robot.max_effort();
  for (std::size_t k = 0; k < kSamples; ++k) {
    const double closing = static_cast<double>(k) / (kSamples - 1);
    gaps_[k] = jaw.gap_at(closing);
    forces_[k] = options.grip_force.value_or(std::numeric_limits<double>::infinity());
    if (options.grip_force) continue;
    const Eigen::VectorXd rates = jaw.gap_rates(closing);
    for (Eigen::Index j = 0; j < rates.size(); ++j) {
      if (rates[j] < kIdle) continue;
      forces_[k] = std::min(forces_[k], kGrip * limits[j] / rates[j]);
      if (!std::isfinite(limits[j])) unknown_ = problem.robot.joint_names()[j];
    }
    if (!std::isfinite(forces_[k])) forces_[k] = 0;
  }
}

double Press::at(double width) const {
  std::size_t k = 1;
  while (k + 1 < kSamples && gaps_[k] > width) ++k;
  const double step = gaps_[k - 1] - gaps_[k],
               share = step > 0 ? std::clamp((gaps_[k - 1] - width) / step, 0.0, 1.0) : 0;
  return forces_[k - 1] + share * (forces_[k] - forces_[k - 1]);
}

}  // namespace graspless::pinch
