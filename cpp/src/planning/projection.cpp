// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/projection.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/Cholesky>

namespace graspless::planning {
namespace {

using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, BandProjection::kMaxRows,
                             BandProjection::kMaxRows>;

void check(const BandProjection::Bands& bands, const BandProjection::Limits& limits) {
  if (bands.upper.size() != bands.lower.size() || bands.slack.size() != bands.lower.size() ||
      limits.upper.size() != limits.lower.size()) {
    throw std::invalid_argument("projection bands or limits differ in size");
  }
  if (limits.lower.size() > BandProjection::kMaxJoints) {
    throw std::invalid_argument("projection handles at most " +
                                std::to_string(BandProjection::kMaxJoints) + " joints, not " +
                                std::to_string(limits.lower.size()));
  }
  if ((bands.lower.array() > bands.upper.array()).any()) {
    throw std::invalid_argument("a projection band has its lower bound above its upper");
  }
}

/// Moves q by the shortest step that brings the violated rows (J, error) to their targets, to first
/// order.
void step(const BandProjection::Jacobian& J, const BandProjection::Values& error,
          Eigen::VectorXd& q) {
  constexpr double kDamping = 1e-12;  // keeps J J^T factorisable if it is singular
  Square A = J * J.transpose();
  A.diagonal().array() += kDamping;
  const BandProjection::Values lambda = A.ldlt().solve(error);
  q.noalias() -= J.transpose() * lambda;
}

}  // namespace

BandProjection::BandProjection(Rows rows, Bands bands, Limits limits, int max_iterations)
    : rows_(std::move(rows)),
      bands_(std::move(bands)),
      limits_(std::move(limits)),
      max_iterations_(max_iterations) {
  check(bands_, limits_);
  const Values inset = (0.02 * (bands_.upper - bands_.lower)).cwiseMin(bands_.slack);
  aim_lower_ = bands_.lower + inset;
  aim_upper_ = bands_.upper - inset;
}

bool BandProjection::is_satisfied(const Values& value) const {
  return ((value - bands_.lower + bands_.slack).array() >= 0).all() &&
         ((bands_.upper + bands_.slack - value).array() >= 0).all();
}

bool BandProjection::is_satisfied(const Eigen::VectorXd& q) const {
  Values value(bands_.lower.size());
  rows_(q, value, nullptr);
  return is_satisfied(value);
}

bool BandProjection::project(Eigen::VectorXd& q) const {
  constexpr double kNear =
      1e-9;  // tolerance while projecting; the slack is kept for the motions between
  if (q.size() != limits_.lower.size())
    throw std::invalid_argument("q must have " + std::to_string(limits_.lower.size()) +
                                " joints, not " + std::to_string(q.size()));
  const auto num_rows = bands_.lower.size();
  Values value(num_rows), error(num_rows);
  Jacobian J(num_rows, q.size()), J_violated(num_rows, q.size());
  for (int i = 0; i <= max_iterations_; ++i) {
    rows_(q, value, &J);
    Eigen::Index violated = 0;
    for (Eigen::Index r = 0; r < num_rows; ++r) {
      if (value[r] >= bands_.lower[r] - kNear && value[r] <= bands_.upper[r] + kNear) continue;
      error[violated] = value[r] - (value[r] < aim_lower_[r] ? aim_lower_[r] : aim_upper_[r]);
      J_violated.row(violated++) = J.row(r);
    }
    if (violated == 0) return true;
    step(J_violated.topRows(violated), error.head(violated), q);
    q = q.cwiseMax(limits_.lower).cwiseMin(limits_.upper);
  }
  return false;
}

}  // namespace graspless::planning
