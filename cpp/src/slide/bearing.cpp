// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/bearing.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "robot/names.hpp"
#include "robot/rates.hpp"
#include "slide/friction/pressed.hpp"

namespace graspless::slide {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d;

constexpr double kShare = 0.75;  // of its effort limit, with which a joint bears: see slide.md

/// Length of the object between the fingers: how far its outline reaches behind their tips, within
/// the width of the pads [m].
double depth_of(const Problem& problem, const Isometry3d& X_HO) {
  const Eigen::Matrix2Xd& corners = problem.object.outline().vertices();
  const double half = problem.hand.pad_width / 2;
  double least = 0;
  for (Eigen::Index i = 0; i < corners.cols(); ++i) {
    const Eigen::Index next = (i + 1) % corners.cols();
    const Vector3d a = X_HO * Vector3d(corners(0, i), corners(1, i), 0),
                   way = X_HO * Vector3d(corners(0, next), corners(1, next), 0) - a;
    double from = 0, to = 1;  // part of the side within the width
    if (std::abs(way.x()) > 1e-12) {
      const auto [first, last] = std::minmax({(-half - a.x()) / way.x(), (half - a.x()) / way.x()});
      from = std::max(from, first);
      to = std::min(to, last);
    } else if (std::abs(a.x()) > half) {
      continue;
    }
    if (from > to) continue;
    least = std::min({least, a.z() + from * way.z(), a.z() + to * way.z()});
  }
  return -least;
}

/// Rates at which points of the axis Z_H move with a finger, relative to the palm.
class Finger {
 public:
  Finger(const robot::Robot& robot, const robot::Poses& X_WL, int palm, std::vector<int> links)
      : robot_(robot), X_WL_(X_WL), palm_(palm), links_(std::move(links)) {}

  /// Rate of the point at `z` in a direction of W, per unit of each joint [m/rad or 1].
  Eigen::RowVectorXd rates(double z, const Vector3d& direction_W) const {
    const Vector3d p_W = pose(palm_) * Vector3d(0, 0, z);
    return robot::rates(robot_, link_at(z), X_WL_, p_W, direction_W) -
           robot::rates(robot_, palm_, X_WL_, p_W, direction_W);
  }

 private:
  const Isometry3d& pose(int link) const { return X_WL_[link]; }
  /// The last link that begins behind z.
  int link_at(double z) const {
    const auto begin = [&](int link) {
      return (pose(palm_).inverse() * pose(link).translation()).z();
    };
    int last = links_.front();
    for (const int link : links_) {
      if (begin(link) <= z && (begin(link) > begin(last) || begin(last) > z)) last = link;
    }
    return last;
  }

  const robot::Robot& robot_;
  const robot::Poses& X_WL_;
  int palm_;  // frame H
  std::vector<int> links_;
};

}  // namespace

std::optional<Bearing> bearing(const Problem& problem, const Plan& plan) {
  if (problem.X_WO_end) return std::nullopt;
  constexpr double kLeastDepth = 1e-3;  // [m]
  constexpr double kStill = 1e-6;       // rate of a joint that does not yield [m/rad or 1]
  constexpr double kStrongest = 500;    // force of a finger: more is a placeholder in a URDF [N]
  const robot::Robot& robot = problem.robot;
  robot::Poses X_WL;
  const Segment& close = plan.segments.back();
  robot.forward(close.positions.back(), X_WL);
  const int palm = robot.frame(problem.hand.grasp_frame);
  const Isometry3d& X_WH = X_WL[palm];
  std::vector<int> sliding, others;
  for (const std::string& name : problem.hand.fingers) {
    const bool slides = robot::contains(problem.hand.sliding_finger, name);
    (slides ? sliding : others).push_back(robot.frame(name));
  }
  if (sliding.empty() || others.empty()) return std::nullopt;
  const Finger own(robot, X_WL, palm, sliding), other(robot, X_WL, palm, others);
  const int tip = robot.frame(problem.hand.fingertip);
  const double other_up = X_WL[tip].linear()(2, 1);  // Y_F points to it
  const auto& [lower, upper] = other_up > 0 ? std::tie(own, other) : std::tie(other, own);

  Bearing held{};
  const Isometry3d X_HO = X_WH.inverse() * close.object_poses.back();
  const Vector3d p_HC = X_HO * problem.object.com();
  held.lever = std::max(0.0, p_HC.z());
  held.offset = std::abs(p_HC.x());
  held.depth = std::max(kLeastDepth, depth_of(problem, X_HO));
  const Vector3d y = X_WH.linear().col(1), up = y.z() < 0 ? Vector3d(-y) : y;
  const double ratio = std::max(held.lever / held.depth,  // N_upper / W
                                held.offset / problem.hand.pad_width - 0.5);
  const Eigen::RowVectorXd opening =  // torques of a weight of 1 N
      ratio * upper.rates(-held.depth, up) - (1 + ratio) * lower.rates(0, up);
  double most = kStrongest / (1 + ratio);  // weight [N]
  bool is_known = false;
  for (int joint = 0; joint < robot.dof(); ++joint) {
    const double torque = std::abs(opening[joint]), limit = robot.max_effort()[joint];
    if (torque < kStill) continue;
    if (!std::isfinite(limit)) return std::nullopt;
    if (kShare * limit >= most * torque) continue;
    most = kShare * limit / torque;
    is_known = true;
  }
  if (!is_known) return std::nullopt;
  held.max_mass = most / kGravity;
  return held;
}

}  // namespace graspless::slide
