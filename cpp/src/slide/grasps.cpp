// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Configurations of Motions that grasp the object.
#include <algorithm>

#include "slide/motions.hpp"

namespace graspless::slide {

namespace {

/// Ways from the middle of what sticks out towards the edge at which the hand may close, the
/// deepest first [m].
std::vector<double> depths(const Options& options, const Placement& place) {
  constexpr double kFromEdge = 0.01;  // [m]
  const double out = -place.edge.inward.dot(place.out_center - place.edge.a) - kFromEdge;
  if (!options.deep_grasp || out <= 0) return {0};
  return {out, out / 2, 0};
}

}  // namespace

std::vector<Motions::GraspConfiguration> Motions::grasp_configurations(const Placement& place,
                                                                       std::size_t enough) {
  // Without a free joint, all draws of a roll have the same solutions, and find_reach() draws the
  // others again.
  const robot::Ik& ik = query_.grasp_ik;
  const bool varies = !ik.is_closed_form() || ik.free_joint();
  const std::vector<double> tried_depths = depths(query_.options, place);
  const int draws = std::max(varies ? 12 : 2, 2 * static_cast<int>(tried_depths.size()));
  std::vector<GraspConfiguration> found;
  std::optional<std::pair<int, int>> touching;
  Eigen::VectorXd q_touching;
  robot::Poses X_WL;
  for (int i = 0; i < draws && found.size() < enough; ++i) {
    const int roll = i % 2;
    const double deep = tried_depths[static_cast<std::size_t>(i / 2) % tried_depths.size()];
    const Eigen::Isometry3d X_WH = grasp_pose(query_.problem, place, roll, -deep);
    for (const Eigen::VectorXd& q :
         query_.draw_ik(ik, X_WH, query_.draw_seed(), query_.draw_free_joint())) {
      if (!varies && enough == 1 && !found.empty()) break;
      query_.problem.robot.forward(q, X_WL);
      if (const auto pair = query_.free.first_collision(X_WL)) {
        touching = pair;
        q_touching = q;
      } else {
        found.push_back({query_.arm.part(q), roll, deep});
      }
    }
  }
  if (found.empty()) refuse_grasp(touching, q_touching);
  return found;
}

void Motions::refuse_grasp(const std::optional<std::pair<int, int>>& touching,
                           const Eigen::VectorXd& q) {
  if (!touching) return query_.refuse("goal: grasp reach");
  query_.refuse_collision("goal: grasp ", query_.free, *touching, q,
                          query_.problem.hand.grasp_frame);
}

}  // namespace graspless::slide
