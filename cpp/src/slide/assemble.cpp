// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/assemble.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "graspless/slide/torsion.hpp"
#include "graspless/watch.hpp"

#include "slide/refusals.hpp"
#include "slide/rows.hpp"

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
  const Path rows = planning::subdivided(path, kRowStep, query.problem.robot.step_weights());
  plan.segments.push_back({name, rows, std::vector<Eigen::Isometry3d>(rows.size(), X_WO)});
}

/// Prepends q_home, so that the hand opens there first if it is not open.
Path with_home(const Query& query, Path approach) {
  if (query.problem.q_home != approach.front())
    approach.insert(approach.begin(), query.problem.q_home);
  return approach;
}

void append_slide(Query& query, const Path& slide, Plan& plan) {
  const ContactSpace::Carried carried = query.carried_from(slide.front());
  Segment segment{"slide", {}, {}};
  const Path rows = planning::subdivided(with_hand_open(query, slide), kRowStep,
                                         query.problem.robot.step_weights());
  for (const Eigen::VectorXd& q : rows) {
    poll();
    segment.positions.push_back(q);
    segment.object_poses.push_back(query.X_WS *
                                   spatial(query.contact.carry(carried, query.arm.part(q))));
  }
  plan.segments.push_back(std::move(segment));
}

/// Warns if the pad's friction is too small to drag the object; returns true if it does.
bool warn_of_drag(const Problem& problem, Plan& plan) {
  constexpr double kLargest = 10;  // beyond it the exact number says nothing more
  const double load = drag_load(problem, plan);
  if (load <= 1) return false;
  std::ostringstream out;
  out << std::setprecision(3) << "the fingertip's pad cannot drag the object: the slide needs "
      << (load < kLargest ? "" : "more than ") << std::min(load, kLargest)
      << " times the friction that the pad has (" << std::setprecision(6) << "object.mass "
      << problem.object.mass() << " kg, support.friction " << problem.support.friction()
      << ", hand.pad_friction " << problem.hand.pad_friction << "); "
      << (problem.support.friction() < problem.hand.pad_friction
              ? "another seed may press nearer to the centre of mass"
              : "no seed helps while support.friction is not below hand.pad_friction");
  plan.warnings.push_back(out.str());
  return true;
}

/// Eq. (2) lets the object turn with the finger; the pad's friction limits how fast. Warns if the
/// object may lag behind.
void warn_of_torsion(const Problem& problem, Plan& plan) {
  constexpr double kDegree = 0.017453292519943295;  // [rad]
  constexpr double kSmallLag = 2;                   // not worth a warning [deg]
  const Turning slide = turning(problem, plan);
  const double lag = slide.lag / kDegree;
  if (lag < kSmallLag) return;
  std::ostringstream out;
  out << std::setprecision(2) << "the slide turns by up to " << slide.max_turn_rate / kDegree / 100
      << " deg/cm, but the pad's friction turns the object by at most "
      << slide.allowed_turn_rate / kDegree / 100 << " deg/cm: the object may lag behind by " << lag
      << " deg; a wider pad (hand.pad_width) or a smoother support (support.friction) helps";
  plan.warnings.push_back(out.str());
}

/// Warns if the object ends behind the plan, because the wrist gives way to friction.
void warn_of_trailing(const Problem& problem, Plan& plan) {
  constexpr double kSmallTrail = 2e-3;  // not worth a warning [m]
  const Trailing slide = trailing(problem, plan);
  if (slide.left < kSmallTrail) return;
  plan.warnings.push_back("the wrist gives way to the friction of the support: the object trails " +
                          in_mm(slide.sliding) + " behind the plan while it slides, and ends " +
                          in_mm(slide.left) +
                          " short of it; a larger hand.wrist_stiffness or a smoother support "
                          "(support.friction) helps");
}

}  // namespace

void assemble(Query& query, const Motions& motions, const Path& slide, Plan& plan) {
  const Approach& approach = motions.approach();
  const Handling& handling = motions.handling();
  const Eigen::Isometry3d X_WO_start = query.X_WS * spatial(query.object_start);
  const Eigen::Isometry3d X_WO_goal = query.X_WS * spatial(handling.object_goal);
  append(query, plan, "approach", with_home(query, with_hand_open(query, approach.free)),
         X_WO_start);
  append(query, plan, "press", with_hand_open(query, approach.press), X_WO_start);
  append_slide(query, slide, plan);
  append(query, plan, "lift", with_hand_open(query, handling.lift), X_WO_goal);
  append(query, plan, "reach", with_hand_open(query, handling.reach), X_WO_goal);
  append(query, plan, "grasp", with_hand_open(query, handling.grasp), X_WO_goal);
  append(query, plan, "close", handling.close, X_WO_goal);
  plan.status = Status::solved;
  plan.X_WO_goal = X_WO_goal;
  plan.X_WH_grasp = handling.X_WH;
  plan.overhang = handling.placement.overhang;
  if (warn_of_drag(query.problem, plan)) return;
  warn_of_torsion(query.problem, plan);
  warn_of_trailing(query.problem, plan);
}

}  // namespace graspless::slide
