// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/geometry/complex.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::clasp {

/// Collision surface of a complex; see Object::surface().
geometry::Mesh surface_of(const geometry::Complex& complex);

/// Same without enclosed triangles: those with a tetrahedron of triangles on either side. The
/// distance from every outside point is the same, with about a third of the triangles.
geometry::Mesh shell_of(const geometry::Complex& complex);

}  // namespace graspless::clasp
