// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>

#include "geometry/read_ply.hpp"

namespace graspless::geometry {

/// Reads the vertices and faces of a .obj file, under any locale; all else is skipped. Throws
/// std::invalid_argument that names the line, the value and what is allowed.
PolygonSoup read_obj(std::istream& file);

}  // namespace graspless::geometry
