// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace graspless::mechanics {

/// Problem: minimise |x|^2  subject to  A x = upper or A x <= upper (for each row),  x >= 0.
struct LeastForces {
  Eigen::MatrixXd A;
  Eigen::VectorXd upper;
  std::vector<bool> is_equal;
};

/// Returns the unique solution of a problem that some x > 0 fulfils strictly. Returns nothing if
/// the iteration does not converge, as for problems without such an x.
std::optional<Eigen::VectorXd> least_forces(const LeastForces& problem);

}  // namespace graspless::mechanics
