// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Chair with seven holes: four between legs, rungs and seat, and three between the slats of the
// back.
#include "clasp/samples/parts.hpp"

namespace graspless::clasp {
namespace {

struct Chair {
  double width = 0.38;        // between the middles of the legs, both ways [m]
  double seat_height = 0.45;  // of its upper side [m]
  double seat_thickness = 0.03;
  double seat_overhang = 0.02;   // beyond the middles of the legs [m]
  double rung_height = 0.18;     // of the middles of the rungs [m]
  double slat_distance = 0.135;  // from seat to slat, and to the next [m]
  int slats = 3;
  double bar_radius = 0.0125;
};

Parts legs(const Chair& chair) {
  const double at = chair.width / 2, foot = chair.bar_radius;
  const double under_seat = chair.seat_height - chair.seat_thickness / 2;
  const double top = chair.seat_height + chair.slats * chair.slat_distance;
  Parts parts;
  for (const double y : {-at, at}) {
    append(parts, bar({{at, y, foot}, {at, y, under_seat}}, chair.bar_radius));
    append(parts, bar({{-at, y, foot}, {-at, y, top}}, chair.bar_radius));  // carries the back
  }
  return parts;
}

Parts rungs(const Chair& chair) {
  const double at = chair.width / 2, z = chair.rung_height;
  return bar({{-at, -at, z}, {at, -at, z}, {at, at, z}, {-at, at, z}, {-at, -at, z}},
             chair.bar_radius);
}

Parts slats(const Chair& chair) {
  const double at = chair.width / 2;
  Parts parts;
  for (int i = 1; i <= chair.slats; ++i) {
    const double z = chair.seat_height + i * chair.slat_distance;
    append(parts, bar({{-at, -at, z}, {-at, at, z}}, chair.bar_radius));
  }
  return parts;
}

}  // namespace

Parts make_chair() {
  const Chair chair;
  const double side = chair.width + 2 * chair.seat_overhang;
  Parts parts{box({side, side, chair.seat_thickness},
                  {0, 0, chair.seat_height - chair.seat_thickness / 2})};
  append(parts, legs(chair));
  append(parts, rungs(chair));
  append(parts, slats(chair));
  return parts;
}

}  // namespace graspless::clasp
