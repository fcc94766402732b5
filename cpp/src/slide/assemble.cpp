// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/assemble.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <tuple>

#include "graspless/slide/torsion.hpp"
#include "graspless/watch.hpp"

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

/// Lists the three most frequent rejections; with `pairs_first`, those of start-goal pairs come
/// first.
std::string most_frequent(const std::map<std::string, std::int64_t>& refusals, bool pairs_first) {
  std::vector<std::tuple<bool, std::int64_t, std::string>> sorted;
  for (const auto& [why, times] : refusals) {
    sorted.emplace_back(pairs_first && why.rfind("pair:", 0) == 0, times, why);
  }
  std::sort(sorted.rbegin(), sorted.rend());
  std::ostringstream out;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, sorted.size()); ++i) {
    out << (i ? ", " : "") << std::get<2>(sorted[i]) << " (" << std::get<1>(sorted[i]) << ")";
  }
  return out.str();
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

}  // namespace

bool is_home_free(Query& query, Plan& plan) {
  const Eigen::VectorXd &home = query.problem.q_home, &open = query.arm.open();
  plan.status = Status::start_in_collision;
  for (const Eigen::VectorXd& q : {home, open}) {
    const auto [a, b] = query.free.collision(q);
    if (a.empty()) continue;
    plan.reason = "at q_home, '" + a + "' touches '" + b + "'";
    return false;
  }
  if (query.is_motion_free(home, open)) return true;
  plan.reason = "at q_home, the hand touches something while it opens";
  return false;
}

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
  if (!warn_of_drag(query.problem, plan)) warn_of_torsion(query.problem, plan);
}

std::string reason(const Plan& plan) {
  const bool pairs = plan.status == Status::no_valid_pair;
  // Without the time: the same seed and iterations give the same file.
  const std::string refused =
      " within " + std::to_string(plan.statistics.iterations) + " iterations" +
      (plan.statistics.refusals.empty()
           ? ""
           : "; most frequent rejections: " + most_frequent(plan.statistics.refusals, pairs));
  if (plan.status != Status::solved && plan.statistics.iterations == 0) {
    return "the budget allowed no iteration";
  }
  switch (plan.status) {
    case Status::solved:
      return "solved";
    case Status::start_in_collision:
      return plan.reason;
    case Status::no_start_root:
      return "no configuration was found that presses on the object" + refused;
    case Status::no_goal_root:
      return "no configuration was found that presses near an edge of the support" + refused;
    case Status::no_valid_pair:
      return "starts and goals were connected, but no pair of them was valid" + refused;
    case Status::not_connected:
      return "no start could be connected with a goal" + refused;
    case Status::interrupted:
      return "interrupted before a plan was found," + refused;
    case Status::out_of_memory:
      break;
  }
  return "";
}

}  // namespace graspless::slide
