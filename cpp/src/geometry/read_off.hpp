// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "geometry/read_ply.hpp"

namespace graspless::geometry {

/// Reads the text of a .off file; normals, colours and texture coordinates are skipped. Throws
/// std::invalid_argument that names the vertex or face, the value and what is allowed. Takes no
/// more memory than a small multiple of the text's length, whatever counts the file states.
PolygonSoup read_off(const std::string& text);

}  // namespace graspless::geometry
