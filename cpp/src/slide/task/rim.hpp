// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/export.hpp"
#include "graspless/slide/problem.hpp"

#include "slide/contact.hpp"

/// Objects whose underside nobody knows: plates, lids and boxes that may rest on their rims alone.
namespace graspless::slide {

/// Mean distance from `center` at which an object can bear on a support, at most [m]: on two points
/// of the hull of its outline, between which the centre lies.
double rim_distance(const geometry::Polygon& outline, const Eigen::Vector2d& center);

/// True if an object that rests on the rim of its outline alone does not tip over the edge of the
/// support: the centre of mass, projected along gravity, lies at least `margin` [m] inside the hull
/// of the part of the rim that is on the support.
GRASPLESS_API bool is_held_by_rim(const Problem& problem, const Planar& object_S, double margin);

}  // namespace graspless::slide
