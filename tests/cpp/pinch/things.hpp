// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Prisms before a T42.
#pragma once

#include "graspless/pinch/pinch.hpp"

#include "slide/problems.hpp"

namespace graspless::pinch {

inline geometry::Polygon rectangle(double length, double width) {
  return geometry::Polygon(geometry::columns({{-length / 2, -width / 2},
                                              {length / 2, -width / 2},
                                              {length / 2, width / 2},
                                              {-length / 2, width / 2}}));
}

inline Problem standing(const geometry::Polygon& outline, double height, double x = 0.6,
                        double y = 0.1, double yaw = 0.4) {
  return slide::make_problem(slide::tables()[0], slide::Object::prism("thing", outline, height),
                             slide::flat(x, y, yaw));
}

}  // namespace graspless::pinch
