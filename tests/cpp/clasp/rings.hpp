// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A ring in free space for a hand to clasp.
#pragma once

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/geometry/loops.hpp"

#include "clasp/hand/kinematics.hpp"

namespace graspless::clasp {

struct Ring {
  Eigen::Matrix3Xd p_W;
  std::vector<geometry::ClaspTarget> targets;  // the first at the place given
};

/// Through `p` along `tangent`, the middle ahead in the direction of `inwards`.
inline Ring ring_through(const Eigen::Vector3d& p, const Eigen::Vector3d& tangent,
                         const Eigen::Vector3d& inwards, double radius) {
  constexpr int kCorners = 96, kTargets = 12;
  const Eigen::Vector3d out = (tangent * inwards.dot(tangent) - inwards).normalized();
  const Eigen::Vector3d middle = p - radius * out;
  Ring ring;
  ring.p_W.resize(3, kCorners);
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * M_PI * i / kCorners;
    const Eigen::Vector3d along = tangent * std::cos(angle) - out * std::sin(angle);
    ring.p_W.col(i) = middle + radius * (out * std::cos(angle) + tangent * std::sin(angle));
    if (i % (kCorners / kTargets) == 0) ring.targets.push_back({ring.p_W.col(i), along});
  }
  return ring;
}

/// Centre of the box of the hand's curves.
inline Eigen::Vector3d hand_center(const HandKinematics& kinematics) {
  const Eigen::Matrix3Xd& nodes = kinematics.nodes();
  return (nodes.rowwise().minCoeff() + nodes.rowwise().maxCoeff()) / 2;
}

/// A ring of radius 0.2 m whose first target lies in the hand as it stands, moved by `ahead` along
/// forward [m].
inline Ring ring_in_hand(const HandKinematics& kinematics, double ahead) {
  const Eigen::Vector3d forward = kinematics.forward_W();
  return ring_through(hand_center(kinematics) + ahead * forward, kinematics.sideways_W(), forward,
                      0.2);
}

}  // namespace graspless::clasp
