// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Collision check of motions. scene::Scene checks everything except the object. Links are checked
// against the object by the same rule (scene/scene_motion.cpp has the proof): a link with
// clearances c1 and c2 at the ends of a part, that moves by at most M < c1 + c2 in between, stays
// clear.
#include "scene/motion.hpp"

#include <algorithm>

#include "clasp/free_space/free_space.hpp"

namespace graspless::clasp {
using scene::kMargin;
using scene::num_steps;

bool FreeSpace::is_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double resolution) {
  if (base_touches_object_ || !robot_.is_within(q1) || !robot_.is_within(q2)) return false;
  const int steps = num_steps(robot_, q1, q2, resolution);
  uncertain_.clear();
  return find_uncertain_links(q1, q2, steps) && is_part_free(q1, (q2 - q1) / steps, 0, steps, 0) &&
         scene_.is_free(q1, q2, resolution);
}

/// Checks both ends and collects the links that may touch in between.
bool FreeSpace::find_uncertain_links(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2,
                                     int steps) {
  const Eigen::VectorXd step = (q2 - q1).cwiseAbs() / steps;
  update_poses(q2);
  for (const int link : links_) {
    const double motion = robot_.reach(link).dot(step);
    // Half of the clearance needed. The other end provides the other half, or makes up for it.
    const auto found = object_.check(link, X_WL_[link], (motion * steps + kMargin) / 2);
    if (found.touches) return false;
    uncertain_.push_back({link, motion, 0, found.clearance});
  }
  update_poses(q1);
  std::size_t kept = 0;
  for (UncertainLink uncertain : uncertain_) {
    const double needed = uncertain.motion * steps + kMargin - uncertain.clear_last;
    const auto found = object_.check(uncertain.link, X_WL_[uncertain.link], needed);
    if (found.touches) return false;
    uncertain.clear_first = found.clearance;
    if (found.clearance < needed) uncertain_[kept++] = uncertain;
  }
  uncertain_.resize(kept);
  return true;
}

/// True if the uncertain links from `begin` on stay clear at the steps between `first` and `last`.
bool FreeSpace::is_part_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& step, int first,
                             int last, std::size_t begin) {
  const std::size_t end = uncertain_.size();
  if (begin == end || last - first < 2) return true;
  const int middle = (first + last) / 2;
  if (!check_middle(q1 + middle * step, middle - first, last - middle, begin)) return false;
  push_half(begin, end, true, last - middle);
  const std::size_t first_half = uncertain_.size();
  push_half(begin, end, false, middle - first);
  if (!is_part_free(q1, step, first, middle, first_half)) return false;
  uncertain_.resize(first_half);
  return is_part_free(q1, step, middle, last, end);
}

bool FreeSpace::check_middle(const Eigen::VectorXd& q, int steps_before, int steps_after,
                             std::size_t begin) {
  update_poses(q);
  for (std::size_t i = begin; i < uncertain_.size(); ++i) {
    UncertainLink& uncertain = uncertain_[i];
    const double needed = std::max({0.0, uncertain.motion * steps_before - uncertain.clear_first,
                                    uncertain.motion * steps_after - uncertain.clear_last});
    const auto found = object_.check(uncertain.link, X_WL_[uncertain.link], needed + 2 * kMargin);
    if (found.touches) return false;
    uncertain.clear_middle = found.clearance;
  }
  return true;
}

void FreeSpace::push_half(std::size_t begin, std::size_t end, bool second, int steps) {
  if (steps < 2) return;
  for (std::size_t i = begin; i < end; ++i) {
    UncertainLink uncertain = uncertain_[i];
    (second ? uncertain.clear_first : uncertain.clear_last) = uncertain.clear_middle;
    if (uncertain.clear_first + uncertain.clear_last > uncertain.motion * steps + kMargin) continue;
    uncertain_.push_back(uncertain);
  }
}

}  // namespace graspless::clasp
