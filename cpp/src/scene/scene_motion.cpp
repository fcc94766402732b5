// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Conservative checking of a motion q(t) = q1 + t (q2 - q1) on the grid t = 0, 1/n, ..., 1.
//
// Let two bodies be at least d1 apart at t1 and d2 at t2, and let them approach each other by at
// most M in between. At any time between, they have approached by some s <= M and have M - s left,
// so they are at least max(d1 - s, d2 - (M - s)) >= (d1 + d2 - M) / 2 apart. If d1 + d2 > M, they
// stay apart. If not, the grid point in the middle is tested for that pair alone, and then each
// half in turn until no grid point is left.
#include "graspless/scene/scene.hpp"
#include "graspless/watch.hpp"

#include "scene/motion.hpp"

namespace graspless::scene {
bool Scene::is_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double resolution) {
  if (!robot_.is_within(q1) || !robot_.is_within(q2)) return false;
  poll();
  const int steps = num_steps(robot_, q1, q2, resolution);
  const Eigen::VectorXd step = (q2 - q1) / steps;
  update_motion_bounds();
  std::vector<OpenPair> open;  // a stack of stretches
  const auto place_at = [&](int grid_point) {
    poll();
    place(q1 + grid_point * step);
  };
  const auto is_apart = [&](OpenPair& pair, double enough) {
    pair.bound_middle = world_.distance_bound(pair.index, enough);
    return pair.bound_middle > kMargin || !world_.touches(pair.index);
  };
  return open_pairs(q1, q2, steps, open) && stay_apart(open, 0, 0, steps, place_at, is_apart);
}

void Scene::update_motion_bounds() {
  if (motion_revision_ == world_.revision()) return;
  std::vector<Carrier> carriers(world_.num_bodies());
  for (int link = 0; link < static_cast<int>(link_body_.size()); ++link) {
    const int body = link_body_[link];
    if (body >= 0) carriers[body] = {link, {Eigen::Vector3d::Zero(), world_.radius(body)}};
  }
  for (const Attachment& attachment : attachments_) {
    carriers[attachment.body] = {attachment.link,
                                 {attachment.X_LO.translation(), world_.radius(attachment.body)}};
  }
  motion_bounds_.resize(robot_.dof(), world_.num_pairs());
  for (int i = 0; i < world_.num_pairs(); ++i) {
    const auto [a, b] = world_.pair(i);
    // An allowance moves a body along an axis of the world, which turns relative to a link.
    const bool in_world = !world_.shift(i).isZero(0);
    motion_bounds_.col(i) = relative_reach(robot_, carriers[a], carriers[b], in_world);
  }
  motion_revision_ = world_.revision();
}

/// Tests both ends and opens the pairs that may touch between them.
bool Scene::open_pairs(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, int steps,
                       std::vector<OpenPair>& open) {
  const Eigen::VectorXd motion = motion_bounds_.transpose() * (q2 - q1).cwiseAbs() / steps;
  place(q1);
  if (world_.collides()) return false;
  open.reserve(world_.num_pairs());
  for (int i = 0; i < world_.num_pairs(); ++i) {
    // Half of what the stretch needs; the bound at the other end adds the rest.
    const double enough = (motion[i] * steps + kMargin) / 2;
    open.push_back({i, motion[i], world_.distance_bound(i, enough), 0});
  }
  place(q2);
  if (world_.collides()) return false;
  std::size_t kept = 0;
  for (OpenPair pair : open) {
    const double needed = pair.motion * steps + kMargin - pair.bound_first;
    pair.bound_last = world_.distance_bound(pair.index, needed);
    if (pair.bound_last <= needed) open[kept++] = pair;
  }
  open.resize(kept);
  return true;
}

}  // namespace graspless::scene
