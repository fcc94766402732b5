// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Motions: what does not touch the object as scene::Scene does it (scene_motion.cpp has the proof),
// and the links against the object by the same law: a link that is c1 and c2 clear of the object at
// the ends of a stretch, and moves by at most M < c1 + c2 on the way, stays clear of it.
#include <algorithm>

#include "clasp/free_space/free_space.hpp"
#include "scene/motion.hpp"

namespace graspless::clasp {
using scene::kMargin;
using scene::num_steps;

bool FreeSpace::is_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double resolution) {
  if (base_touches_object_ || !robot_.is_within(q1) || !robot_.is_within(q2)) return false;
  const int steps = num_steps(q1, q2, resolution);
  open_.clear();
  return open_links(q1, q2, steps) && is_stretch_free(q1, (q2 - q1) / steps, 0, steps, 0) &&
         scene_.is_free(q1, q2, resolution);
}

/// Looks at both ends and opens the links that may touch between them.
bool FreeSpace::open_links(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, int steps) {
  const Eigen::VectorXd step = (q2 - q1).cwiseAbs() / steps;
  place(q2);
  for (const int link : links_) {
    const double motion = robot_.reach(link).dot(step);
    // Half of what the stretch needs; the other end has the other half, or makes up for it.
    const auto look = object_.look(link, X_WL_[at(link)], (motion * steps + kMargin) / 2);
    if (look.touches) return false;
    open_.push_back({link, motion, 0, look.clearance});
  }
  place(q1);
  std::size_t kept = 0;
  for (OpenLink open : open_) {
    const double needed = open.motion * steps + kMargin - open.clear_last;
    const auto look = object_.look(open.link, X_WL_[at(open.link)], needed);
    if (look.touches) return false;
    open.clear_first = look.clearance;
    if (look.clearance < needed) open_[kept++] = open;
  }
  open_.resize(kept);
  return true;
}

/// Whether the open links from `begin` on stay clear on the grid points between `first` and `last`.
bool FreeSpace::is_stretch_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& step, int first,
                                int last, std::size_t begin) {
  const std::size_t end = open_.size();
  if (begin == end || last - first < 2) return true;
  const int middle = (first + last) / 2;
  if (!look_at_middle(q1 + middle * step, middle - first, last - middle, begin)) return false;
  open_half(begin, end, true, last - middle);
  const std::size_t first_half = open_.size();
  open_half(begin, end, false, middle - first);
  if (!is_stretch_free(q1, step, first, middle, first_half)) return false;
  open_.resize(first_half);
  return is_stretch_free(q1, step, middle, last, end);
}

bool FreeSpace::look_at_middle(const Eigen::VectorXd& q, int steps_before, int steps_after,
                               std::size_t begin) {
  place(q);
  for (std::size_t i = begin; i < open_.size(); ++i) {
    OpenLink& open = open_[i];
    const double needed = std::max({0.0, open.motion * steps_before - open.clear_first,
                                    open.motion * steps_after - open.clear_last});
    const auto look = object_.look(open.link, X_WL_[at(open.link)], needed + 2 * kMargin);
    if (look.touches) return false;
    open.clear_middle = look.clearance;
  }
  return true;
}

void FreeSpace::open_half(std::size_t begin, std::size_t end, bool second, int steps) {
  if (steps < 2) return;
  for (std::size_t i = begin; i < end; ++i) {
    OpenLink open = open_[i];
    (second ? open.clear_first : open.clear_last) = open.clear_middle;
    if (open.clear_first + open.clear_last > open.motion * steps + kMargin) continue;
    open_.push_back(open);
  }
}

}  // namespace graspless::clasp
