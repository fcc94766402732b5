// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace graspless::mechanics {

/// minimise |x|^2  subject to  A x = upper or A x <= upper (a row each),  x >= 0.
struct LeastForces {
  Eigen::MatrixXd A;
  Eigen::VectorXd upper;
  std::vector<bool> is_equal;
};

/// The one solution of a problem that can be kept strictly (some x > 0). Nothing where the
/// iteration does not end, as when it cannot.
std::optional<Eigen::VectorXd> least_forces(const LeastForces& problem);

}  // namespace graspless::mechanics
