// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "graspless/robot/robot.hpp"

namespace graspless::scene {

/// A ball that contains a body.
struct Ball {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 1e9;  ///< [m]; the body may be anywhere by default
};

/// The link that moves a body.
struct Carrier {
  int link = -1;  ///< frame index of the link that the body is rigid with; -1: the world
  Ball ball;      ///< in the link's frame
};

/// Returns a bound on how much the distance of the bodies on carriers a and b changes, per unit of
/// each joint [m/rad or 1], over all configurations. Joints up to the last common ancestor move
/// both alike and do not count, unless `in_world`.
Eigen::VectorXd relative_reach(const robot::Robot& robot, const Carrier& a, const Carrier& b,
                               bool in_world);

/// Bounds on the motion of a link along q(t) = q1 + t (q2 - q1), over all configurations.
struct FrameRates {
  double turn = 0;       ///< angular speed [rad]
  double curvature = 0;  ///< second derivative of a point's position [m]
};

/// Returns the bounds for a motion by `step` = q2 - q1 and a point of the link, in the link's
/// frame. The second derivative of a direction fixed in the link is at most the square of `turn`.
FrameRates frame_rates(const robot::Robot& robot, int link, const Eigen::VectorXd& step,
                       const Eigen::Vector3d& p_L = Eigen::Vector3d::Zero());

/// Safety margin on distances of a stretch that counts as free, larger than rounding and FCL's
/// errors [m].
constexpr double kMargin = 1e-7;

/// Number of equal steps of at most `resolution` (Robot::step()) in which a straight motion is
/// checked. Throws std::invalid_argument on a resolution that is not positive or so small that it
/// takes more than 1e8 steps.
int num_steps(const robot::Robot& robot, const Eigen::VectorXd& q1, const Eigen::VectorXd& q2,
              double resolution);

/// Two bodies that may touch during a stretch of motion.
struct OpenPair {
  int index;
  double motion;                   ///< bound on how far they approach each other in one step [m]
  double bound_first, bound_last;  ///< lower bounds on their distance at the stretch's ends [m]
  double bound_middle = 0;
};

/// True if the pairs from `begin` on stay apart on the grid points between `first` and `last`.
/// `place` moves the bodies to a grid point. `is_apart` sets a pair's bound_middle there, which
/// need not exceed the number given [m]; false if the pair touches. scene_motion.cpp has the proof.
template <class Place, class IsApart>
bool stay_apart(std::vector<OpenPair>& open, std::size_t begin, int first, int last,
                const Place& place, const IsApart& is_apart) {
  const std::size_t end = open.size();
  if (begin == end || last - first < 2) return true;
  const int middle = (first + last) / 2;
  place(middle);
  for (std::size_t i = begin; i < end; ++i) {
    OpenPair& pair = open[i];
    const double needed = std::max(pair.motion * (middle - first) - pair.bound_first,
                                   pair.motion * (last - middle) - pair.bound_last);
    if (!is_apart(pair, needed + 2 * kMargin)) return false;
  }
  const auto open_half = [&](double OpenPair::*bound, int steps) {
    if (steps < 2) return;
    for (std::size_t i = begin; i < end; ++i) {
      OpenPair pair = open[i];
      pair.*bound = pair.bound_middle;
      if (pair.bound_first + pair.bound_last <= pair.motion * steps + kMargin) open.push_back(pair);
    }
  };
  open_half(&OpenPair::bound_first, last - middle);
  const std::size_t first_half = open.size();
  open_half(&OpenPair::bound_last, middle - first);
  if (!stay_apart(open, first_half, first, middle, place, is_apart)) return false;
  open.resize(first_half);
  return stay_apart(open, end, middle, last, place, is_apart);
}

}  // namespace graspless::scene
