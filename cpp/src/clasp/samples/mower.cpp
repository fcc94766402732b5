// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Lawn mower: a deck on four wheels, and a handle frame that a cross bar divides into two holes.
#include <cmath>

#include "clasp/samples/parts.hpp"

namespace graspless::clasp {
namespace {

struct LawnMower {
  Eigen::Vector3d deck{0.46, 0.42, 0.14};  // [m]
  double ground_clearance = 0.06;
  double wheel_radius = 0.09, wheel_width = 0.04;
  double frame_radius = 0.0125;
  double frame_width = 0.38;  // between the middles of its two bars [m]
  double slope = 0.87;        // of the frame against the ground [rad]
  double cross_bar = 0.48;    // from the deck along the frame [m]
  double length = 0.78;       // of the frame [m]
  double corner = 0.04;       // cut off where the top bar begins [m]
};

Parts wheels(const LawnMower& mower) {
  const double x = mower.deck.x() / 2 - mower.wheel_radius / 2;
  const double y = (mower.deck.y() + mower.wheel_width) / 2;
  const double z = mower.wheel_radius;
  Parts parts;
  for (const Eigen::Vector3d& p_OG : {Eigen::Vector3d(x, y, z), Eigen::Vector3d(x, -y, z),
                                      Eigen::Vector3d(-x, y, z), Eigen::Vector3d(-x, -y, z)}) {
    parts.push_back(disc(mower.wheel_radius, mower.wheel_width, p_OG));
  }
  return parts;
}

Parts frame(const LawnMower& mower) {
  const Eigen::Vector3d root(-mower.deck.x() / 2 + mower.frame_radius, 0,
                             mower.ground_clearance + mower.deck.z() - mower.frame_radius);
  const Eigen::Vector3d up(-std::cos(mower.slope), 0, std::sin(mower.slope));
  const auto at = [&](double along, double y) -> Eigen::Vector3d {
    return root + along * up + y * Eigen::Vector3d::UnitY();
  };
  const double y = mower.frame_width / 2, top = mower.length, cut = mower.corner;
  Parts parts = bar({at(0, -y), at(top - cut, -y), at(top, -y + cut), at(top, y - cut),
                     at(top - cut, y), at(0, y)},
                    mower.frame_radius);
  append(parts, bar({at(mower.cross_bar, -y), at(mower.cross_bar, y)}, mower.frame_radius));
  return parts;
}

}  // namespace

Parts make_lawn_mower() {
  const LawnMower mower;
  Parts parts{box(mower.deck, {0, 0, mower.ground_clearance + mower.deck.z() / 2})};
  append(parts, wheels(mower));
  append(parts, frame(mower));
  // Centres the object between the front wheels and the top bar.
  const double front = (mower.deck.x() + mower.wheel_radius) / 2;
  const double rear = mower.deck.x() / 2 + mower.length * std::cos(mower.slope);
  return moved(parts, {(rear - front) / 2, 0, 0});
}

}  // namespace graspless::clasp
