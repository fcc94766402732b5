// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Purse, bag and travel bag: a body with one handle. Each handle is wide enough for the two
// parallel fingers of a Schunk SDH (96 mm), and high enough for a finger to close.
#include "clasp/samples/parts.hpp"

namespace graspless::clasp {
namespace {

/// Narrow at the top, which leaves room for a hand on both sides of the handle.
struct Purse {
  Eigen::Vector2d lower_size{0.28, 0.10}, upper_size{0.22, 0.03};  // [m]
  double height = 0.18;                                            // of the body [m]
  Arch handle{0.15, 0.11, 0.05, 0.008, 0.02};
};

struct Bag {
  Eigen::Vector2d lower_size{0.34, 0.13}, upper_size{0.36, 0.10};
  double height = 0.30;
  Arch handle{0.25, 0.25, 0.06, 0.0075, 0.02};
};

struct TravelBag {
  Eigen::Vector3d half_axes{0.25, 0.13, 0.13};
  Arch handle{0.14, 0.105, 0.045, 0.009, 0.03};
};

}  // namespace

Parts make_purse() {
  const Purse purse;
  Parts parts{wedge(purse.lower_size, 0, purse.upper_size, purse.height)};
  append(parts, moved(arch(purse.handle), {0, 0, purse.height}));
  return parts;
}

Parts make_bag() {
  const Bag bag;
  Parts parts{wedge(bag.lower_size, 0, bag.upper_size, bag.height)};
  append(parts, moved(arch(bag.handle), {0, 0, bag.height}));
  return parts;
}

Parts make_travel_bag() {
  const TravelBag bag;
  const double middle = bag.half_axes.z();
  Parts parts{ellipsoid(bag.half_axes, {0, 0, middle})};
  append(parts, moved(arch(bag.handle), {0, 0, 2 * middle}));
  return parts;
}

}  // namespace graspless::clasp
