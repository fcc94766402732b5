// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::perception {

/// Options of perceive(); fields() describes them.
struct Options {
  double noise_constant = 0.001;
  double noise_quadratic = 0.002;
  double max_tilt = 0.6;
  double min_support_area = 0.06;
  double min_object_area = 1e-4;
  double min_thickness = 0.002;
  double max_height = 0.6;
  double unseen_height = 0.15;
  std::int64_t max_pixels = 500'000;
  std::uint64_t seed = 1;
};

/// Table of the members: name, unit, text and range.
constexpr auto fields(const Options&) {
  using planning::Field, planning::Range;
  return std::make_tuple(
      Field{"noise_constant", &Options::noise_constant, "m",
            "Expected standard deviation of the depth z is noise_constant + noise_quadratic z^2. "
            "The image tells by which factor it differs.",
            Range::left_open(0, 0.05)},
      Field{"noise_quadratic", &Options::noise_quadratic, "1/m",
            "Growth of the standard deviation with the squared depth.", Range::closed(0, 0.05)},
      Field{"max_tilt", &Options::max_tilt, "rad",
            "Largest angle between the normal of a support and the vertical.",
            Range::closed(0.01, 1)},
      Field{"min_support_area", &Options::min_support_area, "m^2",
            "Least visible area of a support. Smaller level faces belong to objects.",
            Range::closed(1e-3, 100)},
      Field{"min_object_area", &Options::min_object_area, "m^2",
            "Least visible area of an object. What is smaller counts as noise.",
            Range::closed(1e-6, 1)},
      Field{"min_thickness", &Options::min_thickness, "m",
            "Least thickness of an object, even where the noise would allow less.",
            Range::closed(1e-4, 0.1)},
      Field{"max_height", &Options::max_height, "m",
            "Largest height above the support at which points belong to objects.",
            Range::closed(0.01, 3)},
      Field{"unseen_height", &Options::unseen_height, "m",
            "Height of the obstacle over a patch of a support without depth, such as one under "
            "glass.",
            Range::closed(0.001, 3)},
      Field{"max_pixels", &Options::max_pixels, "",
            "Larger images are read at every second, third, ... pixel.",
            Range::closed(10'000, 25'000'000)},
      Field{"seed", &Options::seed, "", "Seed of the search for planes.", Range::not_negative()});
}

/// Throws std::invalid_argument that names the option, its value and its range.
GRASPLESS_API void validate(const Options& options);

}  // namespace graspless::perception
