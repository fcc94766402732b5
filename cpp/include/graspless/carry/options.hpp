// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::carry {

/// Options of the search; fields() describes them.
struct Options {
  double step = 0.005;
  double tolerance = 5e-4;
  double angle_tolerance = 2e-3;
  double max_twist = 0;
  double contact_depth = 1e-3;
  double height = 0.06;
  double retreat = 0.08;
  double max_tilt = 0.35;
  double resolution = 0.01;
  double max_memory = 4e9;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Options&) {
  using planning::Field, planning::Range;
  return std::make_tuple(
      Field{"step", &Options::step, "m", "Distance between checked poses along the path.",
            Range::closed(1e-4, 0.1)},
      Field{"tolerance", &Options::tolerance, "m",
            "Largest distance of the object's origin from the straight path.",
            Range::closed(1e-5, 0.05)},
      Field{"angle_tolerance", &Options::angle_tolerance, "rad",
            "Largest rotation of the object away from the planned attitude.",
            Range::closed(1e-4, 0.5)},
      Field{"max_twist", &Options::max_twist, "rad",
            "Largest rotation of hand and object about the direction of the path, also at its end. "
            "0: none.",
            Range::closed(0, 3.2)},
      Field{"contact_depth", &Options::contact_depth, "m",
            "Largest penetration of the object into the obstacles that it rests on.",
            Range::left_open(0, 0.02)},
      Field{"height", &Options::height, "m",
            "With places: length of the straight motion down onto the support.",
            Range::left_open(0, 0.5)},
      Field{"retreat", &Options::retreat, "m",
            "With places: length of the straight motion of the open hand away from the object.",
            Range::left_open(0, 0.5)},
      Field{"max_tilt", &Options::max_tilt, "rad",
            "With places: largest angle between the object's vertical on the way and that at the "
            "start or at the place, whichever is nearer.",
            Range::left_open(0, 3.2)},
      Field{"resolution", &Options::resolution, "rad",
            "Largest joint step between checked configurations. check() uses 0.01.",
            Range::closed(1e-4, 0.01)},
      Field{"max_memory", &Options::max_memory, "bytes", "Largest memory that the search may take.",
            Range::positive()});
}

/// Throws std::invalid_argument that names the option, its value and its range.
GRASPLESS_API void validate(const Options& options);

}  // namespace graspless::carry
