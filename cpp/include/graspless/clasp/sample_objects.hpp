// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sample objects with holes at real size, like those of Stork 2013, Fig. 3. They consist of
// primitives, so a physics engine keeps their holes open. In O they stand on the floor z = 0,
// handles up, centred at x = y = 0.
#pragma once

#include <string>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::clasp {

/// Returns the names: purse, bag, travel_bag, lawn_mower, chair.
GRASPLESS_API const std::vector<std::string>& sample_object_names();
/// Returns the shapes of a sample object, in O. `scale` in (0, 1000]. Throws std::invalid_argument
/// that lists the names.
GRASPLESS_API std::vector<geometry::PlacedShape> sample_object(const std::string& name,
                                                               double scale = 1);

}  // namespace graspless::clasp
