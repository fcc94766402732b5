// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "realize/replay.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kWide = 20, kThick = 1;  // of the box that stands for a half-space [m]

/// A box under the plane, in W, its top at the foot of the perpendicular from p_W.
geometry::PlacedShape half_space(const Plane& plane, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d n_W = plane.n_W.normalized();
  const Eigen::Vector3d foot_W = p_W - (n_W.dot(p_W) - plane.offset) * n_W;
  Eigen::Matrix3d R;
  R.col(2) = n_W;
  R.col(0) = n_W.unitOrthogonal();
  R.col(1) = n_W.cross(R.col(0));
  geometry::PlacedShape placed{geometry::Box{{kWide, kWide, kThick}}};
  placed.X_BG.linear() = R;
  placed.X_BG.translation() = foot_W - kThick / 2 * n_W;
  return placed;
}

}  // namespace

RealizeReplay::RealizeReplay(const Problem& problem, const robot::Robot& robot) : replay_(robot) {
  for (const Plane& plane : problem.planes) {
    replay_.add({plane.name, {half_space(plane, robot.X_WB().translation())}});
  }
  for (const Obstacle& obstacle : problem.obstacles) replay_.add(obstacle);
  object_ = replay_.add(problem.object.name(), problem.object.solid(), false);
}

std::vector<std::string> RealizeReplay::touching(const robot::Poses& X_WL,
                                                 const Eigen::Isometry3d& X_WO,
                                                 const std::vector<Allowed>& allowed) {
  collision::World& world = replay_.world();
  world.set_pose(object_, X_WO);
  for (int body = 0; body < replay_.num_links(); ++body)
    world.allow_contact(body, object_, Eigen::Vector3d::UnitZ(), 0);
  for (const Allowed& contact : allowed) {
    const int body = replay_.body_of(contact.link);
    if (body >= 0) world.allow_contact(body, object_, X_WO.linear() * contact.out_O, contact.depth);
  }
  return replay_.touching(X_WL);
}

}  // namespace graspless::fingertip
