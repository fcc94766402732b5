// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <random>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/planning/path.hpp"

namespace graspless::planning {

/// A box of configurations with collision tests, for motions without a constraint.
struct FreeSpace {
  Eigen::VectorXd lower, upper;
  std::function<bool(const Eigen::VectorXd&)> is_free;
  std::function<bool(const Eigen::VectorXd&, const Eigen::VectorXd&)> is_motion_free;  ///< straight
  std::function<bool()> is_out;  ///< ends the search if true; called once per iteration
};

/// Returns a collision-free path: the straight motion if it is free, otherwise a shortened path of
/// ForestCBiRRT with one start, one goal and no constraint (RRT-Connect). Returns nothing if an end
/// is not free or `iterations` do not suffice.
GRASPLESS_API std::optional<Path> find_free_path(const FreeSpace& space,
                                                 const Eigen::VectorXd& from,
                                                 const Eigen::VectorXd& to, int iterations,
                                                 std::mt19937_64& rng);

}  // namespace graspless::planning
