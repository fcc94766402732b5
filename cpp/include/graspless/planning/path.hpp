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

/// Configurations joined by straight motions.
using Path = std::vector<Eigen::VectorXd>;

/// A path from one configuration to another that keeps whatever must be kept, both ends included;
/// nothing when there is none.
using Connect =
    std::function<std::optional<Path>(const Eigen::VectorXd& from, const Eigen::VectorXd& to)>;

/// The sum of the Euclidean lengths of a path's motions.
GRASPLESS_API double length(const Path& path);

/// Tries `rounds` times to replace the stretch between two random places of the path by
/// `connect`'s, and keeps what is shorter. Every motion of the result is one of the path's own or
/// one of `connect`'s, so a constraint that both keep is kept.
GRASPLESS_API Path shortcut(Path path, const Connect& connect, int rounds, std::mt19937_64& rng);

/// The same path with every motion cut so that no joint moves by more than `step`.
GRASPLESS_API Path subdivided(const Path& path, double step);

}  // namespace graspless::planning
