// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability_balls.hpp"

#include <algorithm>

#include "clasp/link_spheres.hpp"

namespace graspless::clasp {
namespace {

// Balls of one size whose centres are sqrt(r times this) apart leave dents of an eighth of it [m].
constexpr double kDents = 0.008;
// Balls smaller than this part of a link's largest only fill its edges. A thin plate beside a thick
// block in one link counts: through a palm without its plate every clasp comes free.
constexpr double kSmallest = 1.0 / 8;

bool adds(const LinkSphere& ball, const SphereTree& larger) {
  return std::none_of(larger.begin(), larger.end(), [&](const LinkSphere& other) {
    const double apart = (ball.p_L - other.p_L).norm();
    return apart + ball.inner <= other.inner + kDents / 8 || apart * apart < kDents * other.inner;
  });
}

/// The inner spheres of a link that count, largest first.
SphereTree needed(SphereTree tree) {
  std::stable_sort(tree.begin(), tree.end(),
                   [](const LinkSphere& a, const LinkSphere& b) { return a.inner > b.inner; });
  SphereTree kept;
  for (const LinkSphere& ball : tree) {
    const double least = kept.empty() ? 0 : kSmallest * kept.front().inner;
    if (ball.inner > least && adds(ball, kept)) kept.push_back(ball);
  }
  return kept;
}

}  // namespace

LinkBalls::LinkBalls(const robot::Robot& robot) {
  SphereTree all;
  int link = 0;
  for (SphereTree& tree : link_spheres(robot, MeshInside::hull)) {
    const SphereTree balls = needed(std::move(tree));
    links_.insert(links_.end(), balls.size(), link++);
    all.insert(all.end(), balls.begin(), balls.end());
  }
  p_L_.resize(3, static_cast<Eigen::Index>(all.size()));
  radii_.resize(p_L_.cols());
  for (Eigen::Index i = 0; i < p_L_.cols(); ++i) {
    p_L_.col(i) = all[static_cast<std::size_t>(i)].p_L;
    radii_[i] = all[static_cast<std::size_t>(i)].inner;
  }
}

Eigen::Matrix3Xd LinkBalls::centers_W(const robot::Poses& X_WL) const {
  Eigen::Matrix3Xd centers(3, p_L_.cols());
  for (Eigen::Index i = 0; i < p_L_.cols(); ++i) {
    const int link = links_[static_cast<std::size_t>(i)];
    centers.col(i) = X_WL[static_cast<std::size_t>(link)] * Eigen::Vector3d(p_L_.col(i));
  }
  return centers;
}

}  // namespace graspless::clasp
