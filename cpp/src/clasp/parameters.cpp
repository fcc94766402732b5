// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "graspless/geometry/linking.hpp"
#include "graspless/geometry/shape.hpp"

#include "clasp/hand/kinematics.hpp"
#include "geometry/segment.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Points = Eigen::Matrix3Xd;

constexpr double kStep = 0.05;     // of a closing joint, Robot::step() [rad]
constexpr double kFraction = 0.5;  // threshold between the open (0) and the closed hand (1)
constexpr double kTip = 0.012;     // radius of a fingertip without shapes [m]

/// Virtual linking of the curve that is closed least, where each is linked once.
double closure(const HandKinematics& hand) {
  double least = 1;
  for (int i = 0; i < hand.num_curves(); ++i)
    least = std::min(least, geometry::closedness(hand.curve_points(i)));
  return least;
}

/// Distance of the segment from a to b to the line through `on_line` along a unit vector [m].
double distance(const Vector3d& a, const Vector3d& b, const Vector3d& on_line,
                const Vector3d& along) {
  const auto across = [&](const Vector3d& v) { return Vector3d(v - v.dot(along) * along); };
  return geometry::distance_to_segment(across(on_line), across(a), across(b));
}

/// Centre of the bounding box of all curves, with sides along the hand's directions.
Vector3d middle(const HandKinematics& hand) {
  const Vector3d forward = hand.forward_W(), sideways = hand.sideways_W();
  Vector3d centre = Vector3d::Zero();
  for (const Vector3d& d : {forward, sideways, Vector3d(forward.cross(sideways))}) {
    const Eigen::RowVectorXd along = d.transpose() * hand.nodes();
    centre += (along.minCoeff() + along.maxCoeff()) / 2 * d;
  }
  return centre;
}

/// True if every curve keeps a distance of `clear` from a line along `sideways` through the hand's
/// centre.
bool is_clear_of_bar(const HandKinematics& hand, double clear) {
  const Vector3d centre = middle(hand), along = hand.sideways_W();
  for (int i = 0; i < hand.num_curves(); ++i) {
    const Points p = hand.curve_points(i);
    for (Eigen::Index k = 0; k + 1 < p.cols(); ++k) {
      if (distance(p.col(k), p.col(k + 1), centre, along) < clear) return false;
    }
  }
  return true;
}

double sum_of_closures(const HandKinematics& hand) {
  double sum = 0;
  for (int i = 0; i < hand.num_curves(); ++i) sum += geometry::closedness(hand.curve_points(i));
  return sum;
}

}  // namespace

double tip_radius(const robot::Robot& robot, const Finger& finger) {
  const int tip = robot.frame(finger.nodes.back().link);
  double thickest = 0;
  for (const robot::LinkShape& shape : robot.shapes()) {
    if (shape.link != tip) continue;
    double thinnest = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d d = shape.placed.X_BG.linear().col(axis);
      thinnest = std::min(thinnest, (extent(shape.placed, d) + extent(shape.placed, -d)) / 2);
    }
    thickest = std::max(thickest, thinnest);
  }
  return thickest;
}

double finger_radius(const robot::Robot& robot, const Hand& hand) {
  double thickest = tip_radius(robot, hand.thumb);
  for (const Finger& finger : hand.fingers)
    thickest = std::max(thickest, tip_radius(robot, finger));
  return thickest > 0 ? thickest : kTip;
}

double open_linking(const robot::Robot& robot, const Hand& hand) {
  HandKinematics kinematics(robot, hand);
  kinematics.update(robot.state(hand.open));
  return closure(kinematics);
}

double half_width(const robot::Robot& robot, const Hand& hand) {
  HandKinematics kinematics(robot, hand);
  kinematics.update(robot.state(hand.open));
  const Eigen::RowVectorXd along = kinematics.sideways_W().transpose() * kinematics.nodes();
  return (along.maxCoeff() - along.minCoeff()) / 2 + finger_radius(robot, hand);
}

// The joints close in turn. A joint stops when it would touch the bar or no longer closes the
// curves.
double reachable_linking(const robot::Robot& robot, const Hand& hand, double thickness) {
  const double clear = thickness / 2 + finger_radius(robot, hand);
  const Eigen::VectorXd& closed = robot.state(hand.closed);
  Eigen::VectorXd q = robot.state(hand.open);
  HandKinematics kinematics(robot, hand);
  kinematics.update(q);
  double sum = sum_of_closures(kinematics);
  std::vector<int> moving = robot.group(hand.hand);
  const auto is_done = [&](int joint) {
    const double before = q[joint], left = closed[joint] - before;
    if (std::abs(left) < 1e-9) return true;
    const double step = kStep / robot.step_weights()[joint];
    q[joint] += std::clamp(left, -step, step);
    kinematics.update(q);
    const double now = sum_of_closures(kinematics);
    if (now > sum && is_clear_of_bar(kinematics, clear)) {
      sum = now;
      return false;
    }
    q[joint] = before;
    return true;
  };
  while (!moving.empty()) {
    moving.erase(std::remove_if(moving.begin(), moving.end(), is_done), moving.end());
  }
  kinematics.update(q);
  return closure(kinematics);
}

bool is_too_thick(const robot::Robot& robot, const Hand& hand, double thickness) {
  return reachable_linking(robot, hand, thickness) <= open_linking(robot, hand);
}

const Eigen::Matrix3Xd& loop_points(const Problem& problem, int loop) {
  const auto& loops = problem.object.loops().found;
  if (loop < 0 || loop >= static_cast<int>(loops.size())) {
    throw std::invalid_argument("loop must be the index of one of the " +
                                std::to_string(loops.size()) + " loops of object '" +
                                problem.object.name() + "', not " + std::to_string(loop));
  }
  return loops[loop].points;
}

Options derived(const Options& options, const Problem& problem, int loop) {
  Options o = options;
  const geometry::Loop& of = problem.object.loops().found[loop];
  if (o.min_linking == 0) {
    const double open = open_linking(problem.robot, problem.hand);
    const double reach = reachable_linking(problem.robot, problem.hand, of.thickness);
    o.min_linking = open + kFraction * (reach - open);
  }
  if (o.targets == 0) {
    const double spacing = half_width(problem.robot, problem.hand);
    o.targets = static_cast<int>(std::clamp(std::ceil(of.length / spacing), 4.0, 64.0));
  }
  return o;
}

}  // namespace graspless::clasp
