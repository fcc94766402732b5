// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/hand_motion.hpp"

#include <algorithm>
#include <cmath>

#include "graspless/planning/free_path.hpp"

#include "robot/names.hpp"
#include "scene/rows.hpp"
#include "slide/contact_space.hpp"

namespace graspless::slide {

using planning::Path;

int pieces(double length, double step) {
  return std::max(1, static_cast<int>(std::ceil(length / step)));
}

bool is_finger_on_object(const Hand& hand, const std::string& a, const std::string& b) {
  return (a == kObjectBody && robot::contains(hand.fingers, b)) ||
         (b == kObjectBody && robot::contains(hand.fingers, a));
}

bool HandMotion::is_free(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
  return scene_.is_free(from, to, scene::replay_step(robot_, from, to, resolution_));
}

std::optional<Path> HandMotion::track(const robot::Ik& ik, const Eigen::VectorXd& from,
                                      const std::vector<Eigen::Isometry3d>& poses,
                                      scene::Scene& scene) {
  // Robot::step() [rad]; a longer one has left the branch of inverse kinematics.
  constexpr double kJump = 0.3;
  Path path{from};
  Eigen::VectorXd q = arm_.full(from);
  for (const Eigen::Isometry3d& pose : poses) {
    ++ik_calls_;
    const auto next = ik.solve_near(pose, q);
    if (!next || robot_.step(q, *next) > kJump) return std::nullopt;
    if (!scene.is_free(q, *next, scene::replay_step(robot_, q, *next, resolution_)))
      return std::nullopt;
    q = *next;
    path.push_back(arm_.part(q));
  }
  return path;
}

std::optional<Path> HandMotion::free_path(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                          int iterations, std::mt19937_64& rng,
                                          const std::function<bool()>& is_out) {
  planning::FreeSpace space;
  space.lower = arm_.lower();
  space.upper = arm_.upper();
  space.is_free = [&](const Eigen::VectorXd& arm) { return scene_.is_free(arm_.full(arm)); };
  space.is_motion_free = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return is_free(arm_.full(a), arm_.full(b));
  };
  space.is_out = is_out;
  return planning::find_free_path(space, from, to, iterations, rng);
}

HandMotion::Closing HandMotion::close(const Eigen::VectorXd& arm) {
  constexpr double kPrecision = 1e-4;  // of Robot::step() [rad]
  const Eigen::VectorXd open = arm_.full(arm);
  Eigen::VectorXd closed = arm_.closed();
  arm_.write(arm, closed);
  const double travel = robot_.step(open, closed);
  const int steps = pieces(travel, scene::kRowStep);
  Closing closing{{open}, {}};
  const auto at = [&](double t) -> Eigen::VectorXd { return open + t * (closed - open); };
  for (int i = 1; i <= steps; ++i) {
    double apart = (i - 1.0) / steps, touching = 1.0 * i / steps;
    if (is_free(closing.rows.back(), at(touching))) {
      closing.rows.push_back(at(touching));
      continue;
    }
    while ((touching - apart) * travel > kPrecision) {
      const double middle = (apart + touching) / 2;
      (scene_.is_free(at(middle)) ? apart : touching) = middle;
    }
    closing.rows.push_back(at(touching));
    closing.touching = scene_.collision(closing.rows.back());
    return closing;
  }
  return closing;
}

}  // namespace graspless::slide
