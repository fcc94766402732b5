// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/realize_replay.hpp"

#include <algorithm>

namespace graspless::fingertip {
namespace {

constexpr double kWide = 20, kThick = 1;  // of the box that stands for a half-space [m]

bool is_base(const robot::Robot& robot, int link) {
  const Eigen::VectorXd& reach = robot.reach(link);
  return reach.size() == 0 || reach.maxCoeff() == 0;
}

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

RealizeReplay::RealizeReplay(const Problem& problem, const robot::Robot& robot) : robot_(robot) {
  std::vector<std::vector<geometry::PlacedShape>> shapes(robot.frame_names().size());
  for (const auto& shape : robot.shapes())
    shapes[static_cast<std::size_t>(shape.link)].push_back(shape.placed);
  for (int link = 0; link < static_cast<int>(shapes.size()); ++link) {
    const auto i = static_cast<std::size_t>(link);
    if (shapes[i].empty()) continue;
    const int body = world_.add_body(robot.frame_names()[i], shapes[i]);
    for (int other = 0; other < body; ++other) {
      const int before = link_of_body_[static_cast<std::size_t>(other)];
      if (robot.ignored_pairs().count(std::minmax(before, link)) == 0) world_.add_pair(other, body);
    }
    link_of_body_.push_back(link);
  }
  for (const Plane& plane : problem.planes) {
    add(plane.name, {half_space(plane, robot.X_WB().translation())}, Eigen::Isometry3d::Identity());
  }
  for (const Obstacle& obstacle : problem.obstacles)
    add(obstacle.name, obstacle.shapes, obstacle.X_WB);
  object_ = world_.add_body(problem.object.name(), problem.object.solid());
  for (int body = 0; body < static_cast<int>(link_of_body_.size()); ++body)
    world_.add_pair(body, object_);
}

void RealizeReplay::add(const std::string& name, const std::vector<geometry::PlacedShape>& shapes,
                        const Eigen::Isometry3d& X_WB) {
  const int added = world_.add_body(name, shapes);
  world_.set_pose(added, X_WB);
  for (std::size_t body = 0; body < link_of_body_.size(); ++body) {
    if (!is_base(robot_, link_of_body_[body])) world_.add_pair(static_cast<int>(body), added);
  }
}

int RealizeReplay::body_of(const std::string& link) const {
  const auto found = std::find(link_of_body_.begin(), link_of_body_.end(), robot_.frame(link));
  return found == link_of_body_.end() ? -1 : static_cast<int>(found - link_of_body_.begin());
}

std::vector<std::string> RealizeReplay::touching(const robot::Poses& X_WL,
                                                 const Eigen::Isometry3d& X_WO,
                                                 const std::vector<Allowed>& allowed) {
  for (std::size_t body = 0; body < link_of_body_.size(); ++body)
    world_.set_pose(static_cast<int>(body), X_WL[static_cast<std::size_t>(link_of_body_[body])]);
  world_.set_pose(object_, X_WO);
  for (std::size_t body = 0; body < link_of_body_.size(); ++body)
    world_.allow_contact(static_cast<int>(body), object_, Eigen::Vector3d::UnitZ(), 0);
  for (const Allowed& contact : allowed) {
    const int body = body_of(contact.link);
    if (body >= 0)
      world_.allow_contact(body, object_, X_WO.linear() * contact.out_O, contact.depth);
  }
  std::vector<std::string> names;
  for (const auto& [a, b] : world_.all_collisions())
    names.push_back(world_.name(a) + " - " + world_.name(b));
  return names;
}

}  // namespace graspless::fingertip
