// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Let C be the last common ancestor of two links. Relative to C, a joint between the root and C
// moves neither of them. A joint between C and link a moves the points of a relative to C by at
// most Robot::reach(a): that bound adds up the lever arms of the joints on the path, and a lever
// arm is the same in C as in the world. For a point at a distance `lever` from the origin of its
// link, each revolute joint adds at most `lever`.
#include "scene/motion.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "robot/model.hpp"

namespace graspless::scene {
namespace {

/// Adds the bounds of the joints on the carrier's path, from its n-th link on.
void add_reach(const robot::Robot& robot, const Carrier& carrier, std::size_t n,
               Eigen::VectorXd& bound) {
  if (carrier.link < 0) return;
  const auto& model = robot.model();
  const auto& path = model.paths[carrier.link];
  std::vector<bool> counted(static_cast<std::size_t>(robot.dof()), false);
  for (; n < path.size(); ++n) {
    const auto& link = model.links[path[n]];
    if (link.joint < 0) continue;
    if (!counted[link.joint]) bound[link.joint] += robot.reach(carrier.link)[link.joint];
    counted[link.joint] = true;
    if (!link.prismatic) bound[link.joint] += std::abs(link.multiplier) * carrier.lever;
  }
}

std::size_t common_length(const std::vector<int>& a, const std::vector<int>& b) {
  const auto shorter = std::min(a.size(), b.size());
  return std::mismatch(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(shorter), b.begin())
             .first -
         a.begin();
}

}  // namespace

Eigen::VectorXd relative_reach(const robot::Robot& robot, const Carrier& a, const Carrier& b,
                               bool in_world) {
  const auto& paths = robot.model().paths;
  const bool both_move = a.link >= 0 && b.link >= 0;
  const std::size_t common =
      both_move && !in_world ? common_length(paths[a.link], paths[b.link]) : 0;
  Eigen::VectorXd bound = Eigen::VectorXd::Zero(robot.dof());
  add_reach(robot, a, common, bound);
  add_reach(robot, b, common, bound);
  return bound;
}

int num_steps(const robot::Robot& robot, const Eigen::VectorXd& q1, const Eigen::VectorXd& q2,
              double resolution) {
  if (!(resolution > 0)) {
    throw std::invalid_argument("resolution must be positive, not " + std::to_string(resolution));
  }
  const double span = q1.size() == 0 ? 0 : robot.step(q1, q2);
  constexpr double kMaxSteps = 1e8;
  const double steps = std::ceil(span / resolution);
  if (steps > kMaxSteps) {
    throw std::invalid_argument("resolution " + std::to_string(resolution) +
                                " is too small for a motion of " + std::to_string(span));
  }
  return std::max(1, static_cast<int>(steps));
}

}  // namespace graspless::scene
