// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/replay.hpp"

#include <algorithm>

namespace graspless::scene {
namespace {

/// True for links rigid with the root, which may touch what the robot is mounted on.
bool is_base(const robot::Robot& robot, int link) {
  const Eigen::VectorXd& reach = robot.reach(link);
  return reach.size() == 0 || reach.maxCoeff() == 0;
}

}  // namespace

Replay::Replay(const robot::Robot& robot) : robot_(robot) { add_links(); }

void Replay::add_links() {
  std::vector<std::vector<geometry::PlacedShape>> shapes(robot_.frame_names().size());
  for (const auto& shape : robot_.shapes()) {
    shapes[shape.link].push_back(shape.placed);
  }
  for (int link = 0; link < static_cast<int>(shapes.size()); ++link) {
    if (shapes[link].empty()) continue;
    const int body = world_.add_body(robot_.frame_names()[link], shapes[link]);
    for (int other = 0; other < body; ++other) {
      const int a = std::min(link, link_of_body_[other]);
      const int b = std::max(link, link_of_body_[other]);
      if (robot_.ignored_pairs().count({a, b}) == 0) world_.add_pair(other, body);
    }
    link_of_body_.push_back(link);
  }
}

int Replay::add(const std::string& name, const collision::Solid& solid, bool carries_base) {
  const int body = world_.add_body(name, solid);
  for (int link = 0; link < static_cast<int>(link_of_body_.size()); ++link) {
    if (carries_base && is_base(robot_, link_of_body_[link])) continue;
    world_.add_pair(link, body);
  }
  return body;
}

int Replay::add(const collision::Obstacle& obstacle) {
  const int body = add(obstacle.label(), obstacle.solid(), true);
  world_.set_pose(body, obstacle.X_WB);
  return body;
}

int Replay::body_of(const std::string& link) const {
  const auto found = std::find(link_of_body_.begin(), link_of_body_.end(), robot_.frame(link));
  return found == link_of_body_.end() ? -1 : static_cast<int>(found - link_of_body_.begin());
}

std::vector<std::string> Replay::touching(const Eigen::VectorXd& q) {
  robot::Poses X_WL;
  robot_.forward(q, X_WL);
  return touching(X_WL);
}

void Replay::place(const robot::Poses& X_WL) {
  for (std::size_t body = 0; body < link_of_body_.size(); ++body) {
    world_.set_pose(static_cast<int>(body), X_WL[link_of_body_[body]]);
  }
}

std::vector<std::string> Replay::touching(const robot::Poses& X_WL) {
  place(X_WL);
  std::vector<std::string> names;
  for (const auto& [a, b] : world_.all_collisions())
    names.push_back(world_.name(a) + " - " + world_.name(b));
  return names;
}

}  // namespace graspless::scene
