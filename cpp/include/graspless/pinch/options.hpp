// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::pinch {

/// Options of the search; fields() describes them.
struct Options {
  double friction = 0.5;
  double margin = 0.002;
  double clearance = 0.0015;
  double max_lever = 0.08;
  std::optional<double> grip_force;
  double patch = 0.008;
  double depth = 0.01;
  std::optional<double> height;
  std::optional<double> opening;
  double approach = 0.08;
  int grasps = 300;
  double resolution = 0.01;
  double max_memory = 4e9;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Options&) {
  using planning::Field, planning::Range;
  return std::make_tuple(
      Field{"friction", &Options::friction, "",
            "Largest coefficient of friction that the pinch may need: the tangent of the angle "
            "between the closing direction and a face's normal.",
            Range::left_open(0, 10)},
      Field{
          "margin", &Options::margin, "m",
          "Least gap between the object and each finger of the open hand that comes to it. Where a "
          "jaw opens less, the hand comes aside by what is missing and goes sideways at the end.",
          Range::closed(0, 0.05)},
      Field{"clearance", &Options::clearance, "m",
            "Least height of the fingers above the support, and of the object's top above the "
            "contacts.",
            Range::closed(0, 0.05)},
      Field{"max_lever", &Options::max_lever, "m",
            "Largest distance of the centre of mass from the line through both contacts, seen from "
            "above, of an object without heights.",
            Range::closed(0, 1)},
      Field{"grip_force", &Options::grip_force, "N",
            "Force of each finger once the hand has closed. By default that of half the effort "
            "limits of the joints that close the hand.",
            Range::left_open(0, 1000)},
      Field{"patch", &Options::patch, "m",
            "Half length of a pad's contact, which bears the weight. A wall of an object with "
            "heights rises by as much above the contacts.",
            Range::left_open(0, 0.1)},
      Field{"depth", &Options::depth, "m",
            "Distance of the contacts from the ends of the pads, at most half the length of a pad. "
            "With 0.003, low objects can be pinched.",
            Range::left_open(0, 0.1)},
      Field{"height", &Options::height, "m",
            "Height of the contacts over the support that is tried first, or the nearest to it at "
            "which the fingers fit. By default half the thickness. Those of walls are found.",
            Range::closed(0, 10)},
      Field{
          "opening", &Options::opening, "m",
          "Distance between the fingers of the hand that comes to the object: less room is needed "
          "beside a wall. By default, and at most, as far as the hand opens.",
          Range::left_open(0, 1)},
      Field{"approach", &Options::approach, "m",
            "Length of the straight motion of the open hand onto the object. Half of it, where "
            "the arm cannot follow all of it.",
            Range::left_open(0, 0.5)},
      Field{"grasps", &Options::grasps, "", "Largest number of hand poses that are tried.",
            Range::closed(1, 100000)},
      Field{"resolution", &Options::resolution, "rad",
            "Largest joint step between checked configurations. check() uses 0.01.",
            Range::closed(1e-4, 0.01)},
      Field{"max_memory", &Options::max_memory, "bytes", "Largest memory that the search may take.",
            Range::positive()});
}

/// Throws std::invalid_argument that names the option, its value and its range.
GRASPLESS_API void validate(const Options& options);

}  // namespace graspless::pinch
