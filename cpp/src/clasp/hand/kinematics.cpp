// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Positions and Jacobians of the finger curves.
#include "clasp/hand/kinematics.hpp"

#include <algorithm>

#include "robot/model.hpp"

namespace graspless::clasp {

using Eigen::Vector3d;

HandKinematics::HandKinematics(const robot::Robot& robot, const Hand& hand)
    : robot_(robot),
      hand_frame_(robot.frame(hand.frame)),
      hand_movers_(movers_of(hand_frame_)),
      forward_H_(hand.forward_H),
      sideways_H_(hand.sideways_H) {
  std::vector<std::vector<int>> fingers;
  for (const Finger& finger : hand.fingers) fingers.push_back(add_finger(finger));
  const std::vector<int> thumb = add_finger(hand.thumb);
  for (std::vector<int>& curve : fingers) {
    std::reverse(curve.begin(), curve.end());
    // A palm node that finger and thumb share is one corner.
    const bool is_shared = !curve.empty() && !thumb.empty() && curve.back() == thumb.front();
    curve.insert(curve.end(), thumb.begin() + (is_shared ? 1 : 0), thumb.end());
    curves_.push_back(curve);
  }
  p_WN_.setZero(3, static_cast<Eigen::Index>(nodes_.size()));
  update(robot.clamp(Eigen::VectorXd::Zero(robot.dof())));
}

std::vector<int> HandKinematics::movers_of(int link) {
  const robot::Robot::Model& model = robot_.model();
  std::vector<int> movers;
  for (const int moved : model.movers[link]) {
    const auto is_it = [moved](const Mover& mover) { return mover.link == moved; };
    const auto known = std::find_if(movers_.begin(), movers_.end(), is_it);
    movers.push_back(static_cast<int>(known - movers_.begin()));
    if (known != movers_.end()) continue;
    const robot::Link& joint = model.links[moved];
    movers_.push_back({moved, joint.joint, joint.prismatic, joint.multiplier * joint.axis_L,
                       Vector3d::Zero(), Vector3d::Zero()});
  }
  return movers;
}

int HandKinematics::add_node(const CurveNode& node) {
  const int link = robot_.frame(node.link);
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].link == link && nodes_[i].p_L == node.p_L) return static_cast<int>(i);
  }
  nodes_.push_back({link, node.p_L, movers_of(link)});
  return static_cast<int>(nodes_.size()) - 1;
}

std::vector<int> HandKinematics::add_finger(const Finger& finger) {
  std::vector<int> nodes;
  for (const CurveNode& node : finger.nodes) nodes.push_back(add_node(node));
  return nodes;
}

void HandKinematics::update(const Eigen::VectorXd& q) {
  robot_.forward(q, X_WL_);
  for (Mover& mover : movers_) {
    const Eigen::Isometry3d& X_WL = X_WL_[mover.link];
    mover.axis_W = X_WL.linear() * mover.axis_L;
    mover.p_W = X_WL.translation();
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = nodes_[i];
    p_WN_.col(i) = X_WL_[node.link] * node.p_L;
  }
}

Eigen::Matrix3Xd HandKinematics::curve_points(int i) const {
  const std::vector<int>& corners = curve(i);
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(corners.size()));
  for (Eigen::Index k = 0; k < points.cols(); ++k) {
    points.col(k) = p_WN_.col(corners[k]);
  }
  return points;
}

Vector3d HandKinematics::forward_W() const { return X_WL_[hand_frame_].linear() * forward_H_; }

Vector3d HandKinematics::sideways_W() const { return X_WL_[hand_frame_].linear() * sideways_H_; }

double HandKinematics::longest_curve() const {
  double longest = 0;
  for (int i = 0; i < num_curves(); ++i) {
    const Eigen::Matrix3Xd p = curve_points(i);
    const Eigen::Index sides = p.cols() - 1;
    longest = std::max(longest, (p.rightCols(sides) - p.leftCols(sides)).colwise().norm().sum());
  }
  return longest;
}

Vector3d HandKinematics::center_W() const {
  return (p_WN_.rowwise().minCoeff() + p_WN_.rowwise().maxCoeff()) / 2;
}

void HandKinematics::add_row(int n, const Vector3d& direction, Row row) const {
  const Vector3d p_W = p_WN_.col(n);
  for (const int m : nodes_[n].movers) {
    const Mover& mover = movers_[m];
    const Vector3d lever =
        mover.is_prismatic ? direction : Vector3d((p_W - mover.p_W).cross(direction));
    row[mover.joint] += mover.axis_W.dot(lever);
  }
}

void HandKinematics::add_rotation_row(const Vector3d& axis, Row row) const {
  for (const int m : hand_movers_) {
    const Mover& mover = movers_[m];
    if (!mover.is_prismatic) row[mover.joint] += mover.axis_W.dot(axis);
  }
}

}  // namespace graspless::clasp
