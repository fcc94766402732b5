// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/geometry/complex.hpp"

namespace graspless::geometry {

/// Fractions of the directions, on either side of a plane, in which a ray leaves the object.
struct Openness {
  double above = 0, below = 0;
};

/// Openness of a place: the middle of the hole, or what seems to be one. On both sides of a hole,
/// rays leave the object. A gap between points has the inside of the object on one side. Within a
/// handle, no ray leaves on either side. `normal`: of the plane; need not be a unit vector.
Openness openness(const Complex& complex, const Eigen::Vector3d& middle,
                  const Eigen::Vector3d& normal);

}  // namespace graspless::geometry
