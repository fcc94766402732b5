// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/fingertip/object.hpp"

namespace graspless::fingertip {

/// The flat parts of a closed outward mesh: neighbouring triangles in one plane, to a small part of
/// `size` [m]. In the order of their first triangles.
std::vector<Face> find_faces(const geometry::Mesh& mesh, double size);

}  // namespace graspless::fingertip
