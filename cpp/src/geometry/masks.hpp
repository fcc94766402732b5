// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::geometry {

/// Pixels of an image that belong to a set, row by row.
using Mask = Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Pixels that lie in a square of 2 x 2 pixels of the mask.
Mask opened(const Mask& mask);

/// Moves the pixel `seed` of a mask, and all that are connected with it along rows and columns, out
/// of the mask to `members`, as indices of its data.
void take_connected(Mask& mask, Eigen::Index seed, std::vector<Eigen::Index>& members);

}  // namespace graspless::geometry
