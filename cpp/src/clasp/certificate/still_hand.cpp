// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/certificate/still_hand.hpp"

#include <algorithm>

#include "clasp/certificate/core.hpp"
#include "clasp/certificate/tight_cycle.hpp"
#include "clasp/hand/kinematics.hpp"
#include "clasp/stability/balls.hpp"

namespace graspless::clasp {
namespace {

constexpr double kAround =
    0.02;  // beyond the corners of the curves, where balls may form a ring [m]

}  // namespace

StillHand::StillHand(const Problem& problem, const Eigen::VectorXd& q) {
  HandKinematics kinematics(problem.robot, problem.hand);
  kinematics.update(q);
  const Eigen::Isometry3d X_OW = problem.X_WO.inverse();
  const auto in_object = [&](const Eigen::Matrix3Xd& p_W) -> Eigen::Matrix3Xd {
    return (X_OW.linear() * p_W).colwise() + X_OW.translation();
  };
  const LinkBalls balls(problem.robot, MeshInside::hollow);
  p_OB = in_object(balls.centers_W(kinematics.poses()));
  radii = balls.radii();
  links = balls.links();
  const Eigen::Matrix3Xd corners = in_object(kinematics.nodes());
  p_OC = (corners.rowwise().minCoeff() + corners.rowwise().maxCoeff()) / 2;
  reach = (corners.colwise() - p_OC).colwise().norm().maxCoeff() + kAround;
}

std::vector<int> StillHand::balls_outside(const Core& core) const {
  std::vector<int> near;
  for (int i = 0; i < static_cast<int>(radii.size()); ++i) {
    if ((p_OB.col(i) - p_OC).norm() <= reach && !core.contains(p_OB.col(i))) near.push_back(i);
  }
  return near;
}

HandRing StillHand::ring(const Eigen::Matrix3Xd& curve_O, double radius,
                         const std::vector<int>& near) const {
  const auto gap = [&](int a, int b) {
    return (p_OB.col(a) - p_OB.col(b)).norm() - radii[a] - radii[b];
  };
  // A ball is no obstacle to what may enter it by its radius.
  const auto clearance_of = [&](int a, int b) {
    return std::max({gap(a, b) / 2 - radius, -radii[a], -radii[b]});
  };
  std::vector<SpatialEdge> edges;
  const int n = static_cast<int>(near.size());
  edges.reserve(static_cast<std::size_t>(n) * static_cast<std::size_t>(n) / 2);
  for (int i = 0; i < n; ++i) {
    for (int k = i + 1; k < n; ++k)
      edges.push_back({i, k, clearance_of(near[std::size_t(i)], near[std::size_t(k)])});
  }
  const Eigen::Matrix3Xd points = p_OB(Eigen::all, near);
  const std::vector<int> cycle = tightest_cycle(points, std::move(edges), curve_O);
  HandRing ring;
  ring.points_O = points(Eigen::all, cycle);
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const int a = near[std::size_t(cycle[i])], b = near[std::size_t(cycle[(i + 1) % cycle.size()])];
    if (i > 0 && clearance_of(a, b) <= ring.clearance) continue;
    ring.clearance = clearance_of(a, b);
    ring.gap = gap(a, b);
    ring.balls = {a, b};
  }
  return ring;
}

}  // namespace graspless::clasp
