// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace graspless::geometry {

/// Points, and polygons as indices of them.
struct PolygonSoup {
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<std::size_t>> polygons;
};

/// Reads the text of a .ply file: ascii, or binary of either byte order. Throws
/// std::invalid_argument that names the line or element, the value and what is allowed. Takes no
/// more memory than a small multiple of the text's length, whatever counts the file states.
PolygonSoup read_ply(const std::string& text);

}  // namespace graspless::geometry
