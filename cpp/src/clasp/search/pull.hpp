// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include <Eigen/Core>

#include "graspless/geometry/loops.hpp"

namespace graspless::clasp {

/// What an object can be pulled at: the middle of a loop and of the whole object.
struct Pulled {
  Eigen::Vector3d loop_middle, object_middle;
};

constexpr double kMostAlong = 0.6;  ///< cosine between pull and segment, at most
constexpr double kLeastOutward =
    0.4;  ///< cosine between pull and the way out of the loop, at least

/// How well a place of a loop serves a pull along the unit vector `pull`, in one frame; more is
/// better, nothing where the hand would slip or the object would turn round.
///
/// A hand in the hole pulls the segment it holds outwards: the pull must lie across the segment
/// and point from the middle of the loop to the place. The object then trails the hand quietly if
/// its middle lies behind the place.
std::optional<double> pull_score(const geometry::ClaspTarget& place, const Pulled& of,
                                 const Eigen::Vector3d& pull);

}  // namespace graspless::clasp
