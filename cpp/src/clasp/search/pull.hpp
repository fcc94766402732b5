// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Core>

#include "graspless/geometry/loops.hpp"

namespace graspless::clasp {

constexpr double kMaxAlong = 0.6;    ///< largest |cosine| between pull and tangent
constexpr double kMinOutward = 0.4;  ///< smallest cosine between pull and direction out of the loop

/// Centres of a loop and of the whole object [m].
struct PullCenters {
  Eigen::Vector3d loop, object;
};

/// Suitability of a target for a pull along the unit vector `pull`; higher is better. All arguments
/// are in one frame. Empty if the hand would slip or the object would turn round.
///
/// A hand in the hole pulls the handle outwards. So the pull must lie across the handle and point
/// from the centre of the loop to the target. The object then follows the hand without turning if
/// its centre lies behind the target.
std::optional<double> pull_score(const geometry::ClaspTarget& target, const PullCenters& centers,
                                 const Eigen::Vector3d& pull);

}  // namespace graspless::clasp
