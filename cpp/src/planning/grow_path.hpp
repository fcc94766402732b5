// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/planning/free_path.hpp"

namespace graspless::planning {

/// Moves a configuration onto a constraint; false if that fails.
using Projection = std::function<bool(Eigen::VectorXd&)>;

/// Path of ForestCBiRRT with one start and one goal, which must be free. `range`: longest
/// extension. There is no constraint without `project`.
std::optional<Path> grow_path(const FreeSpace& space, const Eigen::VectorXd& from,
                              const Eigen::VectorXd& to, double range, const Projection& project,
                              int iterations, std::mt19937_64& rng);

}  // namespace graspless::planning
