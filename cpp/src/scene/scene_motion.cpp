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
#include <algorithm>
#include <cmath>

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
  open_.clear();
  return open_pairs(q1, q2, steps) && is_stretch_free(q1, step, 0, steps, 0);
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
bool Scene::open_pairs(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, int steps) {
  const Eigen::VectorXd motion = motion_bounds_.transpose() * (q2 - q1).cwiseAbs() / steps;
  place(q1);
  if (world_.collides()) return false;
  for (int i = 0; i < world_.num_pairs(); ++i) {
    // Half of what the stretch needs; the bound at the other end adds the rest.
    const double enough = (motion[i] * steps + kMargin) / 2;
    open_.push_back({i, motion[i], world_.distance_bound(i, enough), 0});
  }
  place(q2);
  if (world_.collides()) return false;
  std::size_t kept = 0;
  for (OpenPair pair : open_) {
    const double needed = pair.motion * steps + kMargin - pair.bound_first;
    pair.bound_last = world_.distance_bound(pair.index, needed);
    if (pair.bound_last <= needed) open_[kept++] = pair;
  }
  open_.resize(kept);
  return true;
}

void Scene::keep_open(const OpenPair& pair, int steps) {
  if (pair.bound_first + pair.bound_last <= pair.motion * steps + kMargin) open_.push_back(pair);
}

/// True if the open pairs from `begin` on stay apart on the grid points between `first` and `last`.
bool Scene::is_stretch_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& step, int first,
                            int last, std::size_t begin) {
  const std::size_t end = open_.size();
  if (begin == end || last - first < 2) return true;
  poll();
  const int middle = (first + last) / 2;
  place(q1 + middle * step);
  for (std::size_t i = begin; i < end; ++i) {
    OpenPair& pair = open_[i];
    const double needed = std::max(pair.motion * (middle - first) - pair.bound_first,
                                   pair.motion * (last - middle) - pair.bound_last);
    pair.bound_middle = world_.distance_bound(pair.index, needed + 2 * kMargin);
    if (pair.bound_middle <= kMargin && world_.touches(pair.index)) return false;
  }
  const auto open_half = [&](bool second) {
    for (std::size_t i = begin; i < end; ++i) {
      const OpenPair pair = open_[i];  // a copy: keep_open may move the stack
      const double bound_first = second ? pair.bound_middle : pair.bound_first;
      const double bound_last = second ? pair.bound_last : pair.bound_middle;
      keep_open({pair.index, pair.motion, bound_first, bound_last},
                second ? last - middle : middle - first);
    }
  };
  open_half(true);
  const std::size_t first_half = open_.size();
  open_half(false);
  if (!is_stretch_free(q1, step, first, middle, first_half)) return false;
  open_.resize(first_half);
  return is_stretch_free(q1, step, middle, last, end);
}

}  // namespace graspless::scene
