// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Tables computed from the tree alone: pairs of links that are never tested against each other, and
// bounds on how far links move.
#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

#include "robot/model.hpp"

namespace graspless::robot {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

std::pair<int, int> ordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Returns for each link the first one of its rigid body: of the links connected by fixed joints.
std::vector<int> rigid_bodies(const Robot::Model& model) {
  std::vector<int> first;
  for (int link = 0; link < static_cast<int>(model.links.size()); ++link) {  // parents come first
    const Link& it = model.links[link];
    first.push_back(link > 0 && it.joint < 0 ? first[it.parent] : link);
  }
  return first;
}

/// Returns the largest distance from A's origin to a point of the shape [m].
struct Farthest {
  Isometry3d X_AG;

  double operator()(const geometry::Box& box) const {
    double distance = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      distance = std::max(distance, (X_AG * (0.5 * box.size.cwiseProduct(sign))).norm());
    }
    return distance;
  }
  double operator()(const geometry::Sphere& sphere) const {
    return X_AG.translation().norm() + sphere.radius;
  }
  double operator()(const geometry::Capsule& capsule) const {
    const Vector3d half(0, 0, capsule.length / 2);
    return std::max((X_AG * half).norm(), (X_AG * Vector3d(-half)).norm()) + capsule.radius;
  }
  double operator()(const geometry::Convex& convex) const { return farthest(convex.vertices); }
  double operator()(const geometry::Mesh& mesh) const { return farthest(mesh.vertices); }

  double farthest(const Eigen::Matrix3Xd& points) const {
    return points.cols() == 0 ? 0 : (X_AG * points).colwise().norm().maxCoeff();
  }
};

double farthest(const geometry::PlacedShape& placed, const Isometry3d& X_AL) {
  return std::visit(Farthest{X_AL * placed.X_BG}, placed.shape);
}

/// Returns the largest absolute value of a joint within its limits.
double max_travel(const Robot::Model& model, const Link& link) {
  const double at_lower = link.multiplier * model.lower[link.joint] + link.offset;
  const double at_upper = link.multiplier * model.upper[link.joint] + link.offset;
  return std::max(std::abs(at_lower), std::abs(at_upper));
}

/// Bounds along the path to `link` [m]: steps[i] bounds the distance from the origin of the i-th
/// moving link to that of the next; the last one bounds the distance to the farthest point of the
/// shapes.
std::vector<double> step_lengths(const Robot::Model& model, int link) {
  std::vector<double> steps;
  Isometry3d X_ML = Isometry3d::Identity();  // pose of L in the last moving link
  for (const int i : model.paths[link]) {
    const Link& step = model.links[i];
    X_ML = X_ML * step.X_PJ;
    if (step.joint < 0) continue;
    steps.push_back(X_ML.translation().norm() + (step.prismatic ? max_travel(model, step) : 0));
    X_ML.setIdentity();
  }
  double last = X_ML.translation().norm();
  for (const LinkShape& shape : model.shapes) {
    if (shape.link == link) last = std::max(last, farthest(shape.placed, X_ML));
  }
  steps.push_back(last);
  return steps;
}

VectorXd reach_of(const Robot::Model& model, int link) {
  VectorXd reach = VectorXd::Zero(model.lower.size());
  const std::vector<double> steps = step_lengths(model, link);
  const std::vector<int>& movers = model.movers[link];
  double lever =
      0;  // from the mover's origin to the farthest point; the first step lies before all movers
  for (std::size_t i = movers.size(); i-- > 0;) {
    lever += steps[i + 1];
    const Link& mover = model.links[movers[i]];
    reach[mover.joint] += std::abs(mover.multiplier) * (mover.prismatic ? 1 : lever);
  }
  return reach;
}

}  // namespace

std::set<std::pair<int, int>> neighbours(const Robot::Model& model) {
  std::set<int> shaped;
  for (const LinkShape& shape : model.shapes) shaped.insert(shape.link);
  const std::vector<int> body = rigid_bodies(model);
  std::set<std::pair<int, int>> pairs;
  for (const int link : shaped) {
    poll();
    int ancestor = model.links[link].parent;
    while (ancestor >= 0 && shaped.count(ancestor) == 0) ancestor = model.links[ancestor].parent;
    if (ancestor >= 0) pairs.insert(ordered(ancestor, link));
    for (const int other : shaped) {
      if (other >= link) break;
      if (body[other] == body[link]) {
        pairs.insert(ordered(other, link));
      }
    }
  }
  return pairs;
}

std::vector<VectorXd> reach_bounds(const Robot::Model& model) {
  std::vector<VectorXd> reach;
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    poll();
    reach.push_back(reach_of(model, static_cast<int>(link)));
  }
  return reach;
}

}  // namespace graspless::robot
