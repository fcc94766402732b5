// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/balls.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <variant>

#include <Eigen/Geometry>

namespace graspless::clasp {
namespace {

// Depth of the dent between balls of radius r whose centres are sqrt(8 r kDent) apart [m].
constexpr double kDent = 0.0008;
// Balls smaller than this fraction of a shape's largest only fill its edges, and are dropped.
constexpr double kMinRatio = 1.0 / 3;
constexpr Eigen::Index kMostInGroup = 8;

bool adds(const LinkSphere& ball, const SphereTree& larger) {
  return std::none_of(larger.begin(), larger.end(), [&](const LinkSphere& other) {
    const double apart = (ball.p_L - other.p_L).norm();
    return apart + ball.inner <= other.inner + kDent || apart * apart < 8 * kDent * other.inner;
  });
}

/// Selects the inner spheres that fill a shape, largest first.
SphereTree filling(SphereTree tree) {
  std::stable_sort(tree.begin(), tree.end(),
                   [](const LinkSphere& a, const LinkSphere& b) { return a.inner > b.inner; });
  SphereTree kept;
  for (const LinkSphere& ball : tree) {
    const double least = kept.empty() ? 0 : kMinRatio * kept.front().inner;
    if (ball.inner > least && adds(ball, kept)) kept.push_back(ball);
  }
  return kept;
}

/// Balls spaced evenly along the axis.
SphereTree balls_of_capsule(const geometry::Capsule& capsule, const Eigen::Isometry3d& X_LG) {
  const double most = std::sqrt(8 * kDent * capsule.radius);
  const int gaps = static_cast<int>(std::ceil(capsule.length / most));
  SphereTree balls;
  for (int i = 0; i <= gaps; ++i) {
    const double along = (static_cast<double>(i) / gaps - 0.5) * capsule.length;
    balls.push_back({X_LG * Eigen::Vector3d(0, 0, along), capsule.radius, capsule.radius, 0});
  }
  return balls;
}

SphereTree balls_of(const geometry::PlacedShape& placed, MeshInside inside) {
  if (const auto* capsule = std::get_if<geometry::Capsule>(&placed.shape)) {
    return balls_of_capsule(*capsule, placed.X_BG);
  }
  return filling(sphere_tree({covered(placed, inside)}));
}

}  // namespace

/// Halves points across the direction in which they are spread most, until few are left.
void group_neighbours(const Eigen::Matrix3Xd& points, std::vector<int>& order, Eigen::Index begin,
                      Eigen::Index end, Eigen::Index most, std::vector<BallGroup>& groups) {
  if (begin == end) return;
  Eigen::AlignedBox3d box;
  std::for_each(order.begin() + begin, order.begin() + end,
                [&](int i) { box.extend(points.col(i)); });
  if (end - begin <= most) {
    groups.push_back({begin, end, (box.min() + box.max()) / 2, 0, 0});
    return;
  }
  Eigen::Index axis = 0;
  box.sizes().maxCoeff(&axis);
  const Eigen::Index half = (begin + end) / 2;
  std::nth_element(order.begin() + begin, order.begin() + half, order.begin() + end,
                   [&](int a, int b) { return points(axis, a) < points(axis, b); });
  group_neighbours(points, order, begin, half, most, groups);
  group_neighbours(points, order, half, end, most, groups);
}

std::vector<BallGroup> sort_into_groups(Eigen::Matrix3Xd& centers, Eigen::VectorXd& radii) {
  std::vector<int> order(radii.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<BallGroup> groups;
  group_neighbours(centers, order, 0, radii.size(), kMostInGroup, groups);
  centers = Eigen::Matrix3Xd(centers(Eigen::all, order));
  radii = Eigen::VectorXd(radii(order));
  for (BallGroup& group : groups) {
    const auto balls = Eigen::seq(group.begin, group.end - 1);
    const auto far = (centers(Eigen::all, balls).colwise() - group.middle).colwise().norm().eval();
    group.radius = far.maxCoeff();
    group.around = (far.transpose() + radii(balls)).maxCoeff();
  }
  return groups;
}

LinkBalls::LinkBalls(const robot::Robot& robot, MeshInside inside) {
  SphereTree all;
  for (const robot::LinkShape& shape : robot.shapes()) {
    const SphereTree balls = balls_of(shape.placed, inside);
    links_.insert(links_.end(), balls.size(), shape.link);
    all.insert(all.end(), balls.begin(), balls.end());
  }
  p_L_.resize(3, static_cast<Eigen::Index>(all.size()));
  radii_.resize(p_L_.cols());
  for (Eigen::Index i = 0; i < p_L_.cols(); ++i) {
    p_L_.col(i) = all[i].p_L;
    radii_[i] = all[i].inner;
  }
}

Eigen::Matrix3Xd LinkBalls::centers_W(const robot::Poses& X_WL) const {
  Eigen::Matrix3Xd centers(3, p_L_.cols());
  for (Eigen::Index i = 0; i < p_L_.cols(); ++i) {
    const int link = links_[i];
    centers.col(i) = X_WL[link] * Eigen::Vector3d(p_L_.col(i));
  }
  return centers;
}

}  // namespace graspless::clasp
