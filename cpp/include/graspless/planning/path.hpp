// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"

namespace graspless::planning {

/// Waypoints, connected by straight motions.
using Path = std::vector<Eigen::VectorXd>;

/// Returns a valid path between two configurations, both included, or nothing.
using Connect =
    std::function<std::optional<Path>(const Eigen::VectorXd& from, const Eigen::VectorXd& to)>;

/// Returns the sum of the Euclidean lengths of a path's motions. Throws std::invalid_argument
/// unless all configurations have one size.
GRASPLESS_API double length(const Path& path);

/// Shortens a path: tries `rounds` times to replace the part between two random points by the path
/// that `connect` returns, and keeps it if it is shorter. Every motion of the result is one of the
/// path's own or one of `connect`'s, so a constraint that both keep is kept. Throws like length().
GRASPLESS_API Path shortcut(Path path, const Connect& connect, int rounds, std::mt19937_64& rng);

/// Returns the path with every motion subdivided so that no joint, times its weight, moves by more
/// than `step`. Without weights, all are 1. Throws std::invalid_argument unless `step` is positive,
/// all configurations and the weights have one size, and no motion has more than 10^7 steps.
GRASPLESS_API Path subdivided(const Path& path, double step, const Eigen::VectorXd& weights = {});

}  // namespace graspless::planning
