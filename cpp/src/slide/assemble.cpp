// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/assemble.hpp"

#include <algorithm>

#include "graspless/watch.hpp"

#include "scene/rows.hpp"
#include "slide/friction/warnings.hpp"

namespace graspless::slide {

using planning::Path;

namespace {

Path with_hand_open(const Query& query, const Path& arm_path) {
  Path path;
  for (const Eigen::VectorXd& arm : arm_path) path.push_back(query.arm.full(arm));
  return path;
}

void append(const Query& query, Plan& plan, const std::string& name, const Path& path,
            const Eigen::Isometry3d& X_WO) {
  const Path rows = planning::subdivided(path, scene::kRowStep, query.problem.robot.step_weights());
  plan.segments.push_back({name, rows, std::vector<Eigen::Isometry3d>(rows.size(), X_WO)});
}

/// Prepends q_home, so that the hand opens there first if it is not open.
Path with_home(const Query& query, Path approach) {
  if (query.problem.q_home != approach.front())
    approach.insert(approach.begin(), query.problem.q_home);
  return approach;
}

}  // namespace

Slid slid_along(Query& query, const Path& slide) {
  const ContactSpace::Carried carried = query.carried_from(slide.front());
  Slid slid{{"slide", {}, {}}, {}, {}};
  const Path rows = planning::subdivided(with_hand_open(query, slide), scene::kRowStep,
                                         query.problem.robot.step_weights());
  for (const Eigen::VectorXd& q : rows) {
    poll();
    const Tip tip = query.contact.tip_at(query.arm.part(q));
    const Planar contact = effective_tip(query.problem.hand, tip, query.top, query.options.pitch);
    const Planar X_SO = object_pose(contact, carried.tip_start, carried.object_start);
    slid.segment.positions.push_back(q);
    slid.segment.object_poses.push_back(query.X_WS * spatial(X_SO));
    slid.pressed.push_back(pressed_row(query.problem, tip, X_SO));
  }
  return slid;
}

void assemble(const Query& query, const Motions& motions, const Slid& slide, Plan& plan) {
  const Approach& approach = motions.approach();
  const Handling& handling = motions.handling();
  const Eigen::Isometry3d X_WO_start = query.X_WS * spatial(query.object_start);
  const Eigen::Isometry3d X_WO_goal = query.X_WS * spatial(handling.object_goal);
  if (!plan.resumed) {
    append(query, plan, "approach", with_home(query, with_hand_open(query, approach.free)),
           X_WO_start);
    append(query, plan, "press", with_hand_open(query, approach.press), X_WO_start);
  }
  plan.segments.push_back(slide.segment);
  append(query, plan, "lift", with_hand_open(query, handling.lift), X_WO_goal);
  if (!query.object_end) {
    append(query, plan, "reach", with_hand_open(query, handling.reach), X_WO_goal);
    append(query, plan, "grasp", with_hand_open(query, handling.grasp), X_WO_goal);
    append(query, plan, "close", handling.close, X_WO_goal);
    plan.X_WH_grasp = handling.X_WH;
    plan.overhang = handling.placement.overhang;
  }
  plan.X_WO_goal = X_WO_goal;
  plan.tube = slide.tube;
  const std::optional<Bearing> held = bearing(query.problem, plan);
  if (held) plan.max_mass = held->max_mass;
  for (const Warning& warning : warnings(query.problem, slide.pressed, held)) {
    plan.warnings.push_back(warning.text());
  }
  plan.status = Status::solved;
}

void prepend_retreat(const Query& query, const Retreat& retreat, Plan& plan) {
  append(query, plan, "retreat", with_hand_open(query, retreat.path),
         query.X_WS * spatial(retreat.object_S));
  std::rotate(plan.segments.begin(), plan.segments.end() - 1, plan.segments.end());
}

}  // namespace graspless::slide
