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
using scene::OpenPair;

bool FreeSpace::is_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double resolution) {
  if (base_touches_object_ || !robot_.is_within(q1) || !robot_.is_within(q2)) return false;
  const int steps = num_steps(robot_, q1, q2, resolution);
  const Eigen::VectorXd step = (q2 - q1) / steps;
  std::vector<OpenPair> links;
  const auto place = [&](int grid_point) { update_poses(q1 + grid_point * step); };
  const auto is_apart = [&](OpenPair& link, double enough) {
    const auto found = object_.check(link.index, X_WL_[link.index], std::max(2 * kMargin, enough));
    link.bound_middle = found.clearance;
    return !found.touches;
  };
  return find_uncertain_links(q1, q2, steps, links) &&
         scene::stay_apart(links, 0, 0, steps, place, is_apart) &&
         scene_.is_free(q1, q2, resolution);
}

/// Checks both ends and collects the links that may touch in between.
bool FreeSpace::find_uncertain_links(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2,
                                     int steps, std::vector<OpenPair>& links) {
  const Eigen::VectorXd step = (q2 - q1).cwiseAbs() / steps;
  links.reserve(links_.size());
  update_poses(q2);
  for (const int link : links_) {
    const double motion = robot_.reach(link).dot(step);
    // Half of the clearance needed. The other end provides the other half, or makes up for it.
    const auto found = object_.check(link, X_WL_[link], (motion * steps + kMargin) / 2);
    if (found.touches) return false;
    links.push_back({link, motion, 0, found.clearance});
  }
  update_poses(q1);
  std::size_t kept = 0;
  for (OpenPair link : links) {
    const double needed = link.motion * steps + kMargin - link.bound_last;
    const auto found = object_.check(link.index, X_WL_[link.index], needed);
    if (found.touches) return false;
    link.bound_first = found.clearance;
    if (found.clearance < needed) links[kept++] = link;
  }
  links.resize(kept);
  return true;
}

}  // namespace graspless::clasp
