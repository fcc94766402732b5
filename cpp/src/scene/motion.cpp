// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Let C be the last common ancestor of two links. A joint between the root and C moves neither of
// them relative to the other. A joint between C and a link may be taken to turn either all that
// lies beyond it, or all that lies before it the other way round: the distance of the two bodies
// depends on their relative pose alone. So it changes by at most the smaller one of their lever
// arms. A lever arm is bounded by a ball that contains the body for all values of the joints passed
// so far. Passing a joint moves the ball's centre onto its axis.
#include "scene/motion.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "robot/model.hpp"
#include "text.hpp"

namespace graspless::scene {
namespace {

/// Adds the bound of a link's own joint and lets the ball, given in the link's frame, contain its
/// body for all values of the joint.
void pass_joint(const robot::Robot::Model& model, const robot::Link& link, Ball& ball,
                Eigen::VectorXd& bound) {
  if (link.joint < 0) return;
  if (link.prismatic) {
    const double at_lower = link.multiplier * model.lower[link.joint] + link.offset;
    const double at_upper = link.multiplier * model.upper[link.joint] + link.offset;
    ball.radius += std::max(std::abs(at_lower), std::abs(at_upper));
    bound[link.joint] += std::abs(link.multiplier);
    return;
  }
  const Eigen::Vector3d on_axis = link.axis_L.dot(ball.center) * link.axis_L;
  ball.radius += (ball.center - on_axis).norm();
  ball.center = on_axis;
  bound[link.joint] += std::abs(link.multiplier) * ball.radius;
}

using Links = std::vector<int>;

/// Passes the joints of a path from its n-th link on, from its end to its beginning. Returns the
/// ball in the frame of the link before.
Ball pass_inwards(const robot::Robot::Model& model, const Links& path, std::size_t n, Ball ball,
                  Eigen::VectorXd& bound) {
  for (std::size_t i = path.size(); i-- > n;) {
    const robot::Link& link = model.links[path[i]];
    pass_joint(model, link, ball, bound);
    ball.center = link.X_PJ * (link.R_JL * ball.center);
  }
  return ball;
}

/// Passes the joints of a path from its n-th link on, from its beginning to its end.
void pass_outwards(const robot::Robot::Model& model, const Links& path, std::size_t n, Ball ball,
                   Eigen::VectorXd& bound) {
  for (std::size_t i = n; i < path.size(); ++i) {
    const robot::Link& link = model.links[path[i]];
    ball.center = link.R_JL.transpose() * (link.X_PJ.inverse() * ball.center);
    pass_joint(model, link, ball, bound);
  }
}

std::size_t common_length(const std::vector<int>& a, const std::vector<int>& b) {
  const auto shorter = std::min(a.size(), b.size());
  return std::mismatch(a.begin(), a.begin() + shorter, b.begin()).first - a.begin();
}

}  // namespace

Eigen::VectorXd relative_reach(const robot::Robot& robot, const Carrier& a, const Carrier& b,
                               bool in_world) {
  const auto& model = robot.model();
  const Links none;
  const Links& path_a = a.link < 0 ? none : model.paths[a.link];
  const Links& path_b = b.link < 0 ? none : model.paths[b.link];
  const std::size_t n = in_world ? 0 : common_length(path_a, path_b);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(robot.dof());
  Eigen::VectorXd moved_a = zero, moved_b = zero;
  const Ball ball_a = pass_inwards(model, path_a, n, a.ball, moved_a);
  const Ball ball_b = pass_inwards(model, path_b, n, b.ball, moved_b);
  if (in_world) return moved_a + moved_b;
  Eigen::VectorXd moved_back_a = zero, moved_back_b = zero;
  pass_outwards(model, path_a, n, ball_b, moved_back_a);
  pass_outwards(model, path_b, n, ball_a, moved_back_b);
  return moved_a.cwiseMin(moved_back_a) + moved_b.cwiseMin(moved_back_b);
}

// The second derivative by two joints, of which `k` is nearer to the link, is
// axis_j x (axis_k x (p - o_k)): at most the lever arm of k. A sliding joint k takes the place of
// its lever arm, and a sliding joint j moves nothing but the origin.
FrameRates frame_rates(const robot::Robot& robot, int link, const Eigen::VectorXd& step,
                       const Eigen::Vector3d& p_L) {
  const auto& model = robot.model();
  FrameRates rates;
  for (const int other : model.paths[link]) {
    const robot::Link& on_path = model.links[other];
    if (on_path.joint < 0 || on_path.prismatic) continue;
    rates.turn += std::abs(on_path.multiplier * step[on_path.joint]);
  }
  Ball ball{p_L, 0};
  double inner = rates.turn;  // of the joints between the root and the current one
  for (std::size_t i = model.paths[link].size(); i-- > 0;) {
    const robot::Link& on_path = model.links[model.paths[link][i]];
    Eigen::VectorXd lever = Eigen::VectorXd::Zero(robot.dof());
    pass_joint(model, on_path, ball, lever);
    ball.center = on_path.X_PJ * (on_path.R_JL * ball.center);
    if (on_path.joint < 0) continue;
    const double rate = std::abs(step[on_path.joint]);  // `lever` includes the multiplier
    const double turn = on_path.prismatic ? 0 : rate * std::abs(on_path.multiplier);
    inner -= turn;
    rates.curvature += rate * lever[on_path.joint] * (turn + 2 * std::max(0.0, inner));
  }
  return rates;
}

int num_steps(const robot::Robot& robot, const Eigen::VectorXd& q1, const Eigen::VectorXd& q2,
              double resolution) {
  if (!(resolution > 0)) {
    throw std::invalid_argument("resolution must be positive, not " + figure(resolution));
  }
  const double span = q1.size() == 0 ? 0 : robot.step(q1, q2);
  constexpr double kMaxSteps = 1e8;
  const double steps = std::ceil(span / resolution);
  if (steps > kMaxSteps) {
    throw std::invalid_argument("resolution " + figure(resolution) +
                                " is too small for a motion of " + figure(span));
  }
  return std::max(1, static_cast<int>(steps));
}

}  // namespace graspless::scene
