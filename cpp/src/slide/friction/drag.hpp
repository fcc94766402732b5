// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/export.hpp"

/// The motion of a flat object between a pad and a support, both with friction.
///
/// T is the middle of the pad, C the centre of pressure of the support. For both surfaces the
/// friction wrench is F = H V / sqrt(V' H V), where V is the twist with which the upper body slides
/// over the lower one: the normal of an ellipsoidal limit surface (Howe, Cutkosky 1996). At T,
/// H_p = (mu_p N)^2 diag(1, 1, w^2); at C, H_s = (mu_s (N + m g))^2 diag(1, 1, r^2). The object
/// moves quasi-statically: both wrenches are equal.
namespace graspless::slide {

/// Friction of both surfaces.
struct Drag {
  double ratio;   ///< mu_s (N + m g) / (mu_p N)
  double radius;  ///< r: mean distance of the support's pressure from C [m]
  double pad;     ///< w: mean distance of the pad's pressure from T [m]
};

/// Returns the object's twist at T (velocity [m] and turn [rad]) for that of the pad. The same
/// twist if the pad holds the object, and zero if the support does.
GRASPLESS_API Eigen::Vector3d dragged(const Drag& drag, const Eigen::Vector2d& p_TC,
                                      const Eigen::Vector3d& pad);

}  // namespace graspless::slide
