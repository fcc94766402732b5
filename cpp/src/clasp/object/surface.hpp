// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/geometry/complex.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::clasp {

/// What of a complex must not be touched (Object::surface).
geometry::Mesh surface_of(const geometry::Complex& complex);

/// The same without the triangles that are walled in: those with a fourth point on either side that
/// makes a tetrahedron of triangles with them. As far from every point outside, but a third of the
/// triangles.
geometry::Mesh shell_of(const geometry::Complex& complex);

}  // namespace graspless::clasp
