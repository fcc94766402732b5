// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/free_space/free_space.hpp"

#include <algorithm>

namespace graspless::clasp {

FreeSpace::FreeSpace(const Problem& problem)
    : robot_(problem.robot),
      object_name_(problem.object.name()),
      scene_(problem.robot),
      object_(problem) {
  for (const Obstacle& obstacle : problem.obstacles) {
    scene_.add_obstacle(obstacle.label(), obstacle.solid(), obstacle.X_WB);
  }
  update_poses(robot_.clamp(Eigen::VectorXd::Zero(robot_.dof())));
  for (const int link : object_.links()) {
    if (!robot_.reach(link).isZero(0)) {
      links_.push_back(link);
    } else if (object_.check(link, X_WL_[link], 0).touches) {
      base_touches_object_ = true;
    }
  }
}

void FreeSpace::update_poses(const Eigen::VectorXd& q) {
  ++checks_;
  robot_.forward(q, X_WL_);
}

bool FreeSpace::misses_object() {
  const auto touches = [&](int link) { return object_.check(link, X_WL_[link], 0).touches; };
  const auto touching = std::find_if(links_.begin(), links_.end(), touches);
  if (touching == links_.end()) return true;
  // The same link is likely to collide at the next configuration, so it is checked first.
  std::rotate(links_.begin(), touching, touching + 1);
  return false;
}

bool FreeSpace::is_free(const Eigen::VectorXd& q) {
  if (base_touches_object_ || !robot_.is_within(q)) return false;
  update_poses(q);
  return misses_object() && scene_.is_free(X_WL_);
}

std::pair<std::string, std::string> FreeSpace::collision(const Eigen::VectorXd& q) {
  const auto others = scene_.collision(q);
  if (!others.first.empty()) return others;
  update_poses(q);
  for (const int link : object_.links()) {
    if (!object_.check(link, X_WL_[link], 0).touches) continue;
    return {robot_.frame_names()[link], object_name_};
  }
  return {};
}

}  // namespace graspless::clasp
