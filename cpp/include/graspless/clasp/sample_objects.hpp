// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

/// Objects with holes of our own making, at real size, out of primitives (a physics engine keeps
/// their holes open). O: on the floor z = 0, handles up, the middle at x = y = 0.
namespace graspless::clasp {

/// purse, bag, travel_bag, lawn_mower, chair.
GRASPLESS_API const std::vector<std::string>& sample_object_names();
/// The shapes of one. Throws std::invalid_argument that lists the names. `scale` > 0.
GRASPLESS_API std::vector<geometry::PlacedShape> sample_object(const std::string& name,
                                                               double scale = 1);

}  // namespace graspless::clasp
