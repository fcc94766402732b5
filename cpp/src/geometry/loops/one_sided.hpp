// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/geometry/loops.hpp"

namespace graspless::geometry {

/// True if one camera could have seen nearly all points (3 x n) [m]. Such a cloud does not show
/// where the object ends: the rim of a cup and the edge of what was seen form loops, too.
bool is_one_sided(const Eigen::Matrix3Xd& points);

/// Makes all holes uncertain if the points are of one side.
void doubt_if_one_sided(const Eigen::Matrix3Xd& points, Loops& result);

}  // namespace graspless::geometry
