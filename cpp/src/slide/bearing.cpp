// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/bearing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace graspless::slide {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d;

constexpr double kGravity = 9.81;  // [m/s^2]
constexpr double kShare = 0.75;    // of its effort limit, with which a joint bears: see slide.md

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

/// A finger as a chain of links, to be pressed on at points of the axis Z_H.
class Finger {
 public:
  Finger(const robot::Robot& robot, const robot::Poses& X_WL, const Isometry3d& X_WH,
         std::vector<int> links)
      : robot_(robot), X_WL_(X_WL), X_WH_(X_WH), links_(std::move(links)) {}

  /// Mean height of the links' origins [m].
  double height() const {
    double sum = 0;
    for (const int link : links_) sum += pose(link).translation().z();
    return sum / static_cast<double>(links_.size());
  }
  /// Rate of a point at `z` along Z_H in a direction of W, per unit of each joint [m/rad or 1].
  Eigen::VectorXd rates(double z, const Vector3d& direction_W) const {
    const Vector3d p_W = X_WH_ * Vector3d(0, 0, z);
    const int link = link_at(z);
    Eigen::Matrix<double, 6, Eigen::Dynamic> J;
    robot_.jacobian(link, X_WL_, J);
    const Vector3d arm = p_W - pose(link).translation();
    return J.topRows<3>().transpose() * direction_W +
           J.bottomRows<3>().transpose() * arm.cross(direction_W);
  }

 private:
  const Isometry3d& pose(int link) const { return X_WL_[static_cast<std::size_t>(link)]; }
  /// The last link that begins behind z.
  int link_at(double z) const {
    const auto begin = [&](int link) { return (X_WH_.inverse() * pose(link).translation()).z(); };
    int last = links_.front();
    for (const int link : links_) {
      if (begin(link) <= z && (begin(link) > begin(last) || begin(last) > z)) last = link;
    }
    return last;
  }

  const robot::Robot& robot_;
  const robot::Poses& X_WL_;
  const Isometry3d& X_WH_;
  std::vector<int> links_;
};

}  // namespace

std::optional<Bearing> bearing(const Problem& problem, const Eigen::VectorXd& q,
                               const Isometry3d& X_WO) {
  constexpr double kLeastDepth = 1e-3;  // [m]
  constexpr double kStill = 1e-6;       // rate of a joint that does not yield [m/rad or 1]
  const robot::Robot& robot = problem.robot;
  robot::Poses X_WL;
  robot.forward(q, X_WL);
  const Isometry3d& X_WH = X_WL[static_cast<std::size_t>(robot.frame(problem.hand.grasp_frame))];
  std::vector<int> own, others;
  const std::vector<std::string>& sliding = problem.hand.sliding_finger;
  for (const std::string& name : problem.hand.fingers) {
    const bool is_own = std::find(sliding.begin(), sliding.end(), name) != sliding.end();
    (is_own ? own : others).push_back(robot.frame(name));
  }
  if (own.empty() || others.empty()) return std::nullopt;
  const Finger a(robot, X_WL, X_WH, own), b(robot, X_WL, X_WH, others);
  const auto& [lower, upper] = a.height() <= b.height() ? std::tie(a, b) : std::tie(b, a);

  const Isometry3d X_HO = X_WH.inverse() * X_WO;
  Bearing held{};
  const Vector3d p_HC = X_HO * problem.object.com();
  held.lever = std::max(0.0, p_HC.z());
  held.offset = std::abs(p_HC.x());
  held.depth = std::max(kLeastDepth, depth_of(problem, X_HO));
  const Vector3d y = X_WH.linear().col(1), up = y.z() < 0 ? Vector3d(-y) : y;
  const double ratio = std::max(held.lever / held.depth,  // N_upper / W
                                held.offset / problem.hand.pad_width - 0.5);
  const Eigen::VectorXd opening =  // torques of a weight of 1 N
      ratio * upper.rates(-held.depth, up) - (1 + ratio) * lower.rates(0, up);
  std::vector<bool> is_arm(static_cast<std::size_t>(robot.dof()), false);
  for (const int joint : robot.group(problem.hand.arm))
    is_arm[static_cast<std::size_t>(joint)] = true;
  double most = std::numeric_limits<double>::infinity();  // weight [N]
  for (int joint = 0; joint < robot.dof(); ++joint) {
    const double torque = std::abs(opening[joint]), limit = robot.max_effort()[joint];
    if (is_arm[static_cast<std::size_t>(joint)] || torque < kStill) continue;
    if (!std::isfinite(limit)) return std::nullopt;
    most = std::min(most, kShare * limit / torque);
  }
  if (!std::isfinite(most)) return std::nullopt;
  held.max_mass = most / kGravity;
  return held;
}

std::optional<Bearing> bearing(const Problem& problem, const Plan& plan) {
  if (problem.X_WO_end) return std::nullopt;
  const Segment& last = plan.segments.back();
  return bearing(problem, last.positions.back(), last.object_poses.back());
}

}  // namespace graspless::slide
