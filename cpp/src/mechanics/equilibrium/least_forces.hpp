// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

/// Problem: minimise |x|^2  subject to  A x = upper or A x <= upper (for each row),  x >= 0. The
/// rows are the balance and a normal force for each finger.
struct LeastForces {
  static constexpr int kMaxRows = 6 + kMaxFingers;
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxRows>;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxRows, 1>;
  Matrix A;
  Rows upper;
  std::vector<bool> is_equal;
};

/// Returns the unique solution of a problem that some x > 0 fulfils strictly. Returns nothing if
/// the iteration does not converge, as for problems without such an x.
std::optional<Eigen::VectorXd> least_forces(const LeastForces& problem);

}  // namespace graspless::mechanics
