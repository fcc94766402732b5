// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/assemble.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <tuple>

#include "graspless/slide/torsion.hpp"

#include "slide/rows.hpp"

namespace graspless::slide {

using planning::Path;

namespace {

Path whole(const Query& query, const Path& arm_path) {
  Path path;
  for (const Eigen::VectorXd& arm : arm_path) path.push_back(query.arm.full(arm));
  return path;
}

void append(Plan& plan, const std::string& name, const Path& path, const Eigen::Isometry3d& X_WO) {
  const Path rows = planning::subdivided(path, kRowStep);
  plan.segments.push_back({name, rows, std::vector<Eigen::Isometry3d>(rows.size(), X_WO)});
}

/// The opening of the hand at home, if it is not open there.
Path with_home(const Query& query, Path approach) {
  if (query.problem.q_home != approach.front())
    approach.insert(approach.begin(), query.problem.q_home);
  return approach;
}

void append_slide(Query& query, const Path& slide, Plan& plan) {
  const ContactSpace::Carried carried = query.carried_from(slide.front());
  Segment segment{"slide", {}, {}};
  for (const Eigen::VectorXd& arm : planning::subdivided(slide, kRowStep)) {
    segment.positions.push_back(query.arm.full(arm));
    segment.object_poses.push_back(query.X_WS * spatial(query.contact.carry(carried, arm)));
  }
  plan.segments.push_back(std::move(segment));
}

/// The three most frequent refusals; those of pairs first, where it came to pairs.
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

/// A pad can hold an object against the support's friction only so far.
bool warn_of_drag(const Problem& problem, Plan& plan) {
  constexpr double kTell = 10;  // a greater load has no meaning as a number
  const double load = drag_load(problem, plan);
  if (load <= 1) return false;
  std::ostringstream out;
  out << std::setprecision(3) << "the pad cannot drag the object: on the way it would have to hold "
      << (load < kTell ? "" : "more than ") << std::min(load, kTell) << " times what it can ("
      << std::setprecision(6) << "object.mass " << problem.object.mass() << " kg, support.friction "
      << problem.support.friction() << ", hand.pad_friction " << problem.hand.pad_friction << "); "
      << (problem.support.friction() < problem.hand.pad_friction
              ? "another seed may press nearer to the centre of mass"
              : "the support holds it better than the pad, wherever that presses");
  plan.warnings.push_back(out.str());
  return true;
}

/// Eq. (2) has the object turn with the finger; physics allows that to a pad only so far.
void warn_of_torsion(const Problem& problem, Plan& plan) {
  constexpr double kDegree = 0.017453292519943295, kMost = 2;  // lag that is worth a word [deg]
  const Turning slide = turning(problem, plan);
  const double lag = slide.lag / kDegree;
  if (lag < kMost) return;
  std::ostringstream out;
  out << std::setprecision(2) << "the slide turns by up to " << slide.most / kDegree / 100
      << " deg/cm, and the pad turns the object with it only up to "
      << slide.allowed / kDegree / 100 << ": it may stay behind by " << lag
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
    plan.reason = "at home, '" + a + "' touches '" + b + "'";
    return false;
  }
  if (query.is_motion_free(home, open)) return true;
  plan.reason = "at home, the hand touches something while it opens";
  return false;
}

void assemble(Query& query, const Motions& motions, const Path& slide, Plan& plan) {
  const Approach& approach = motions.approach();
  const Handling& handling = motions.handling();
  const Eigen::Isometry3d X_WO_start = query.X_WS * spatial(query.object_start);
  const Eigen::Isometry3d X_WO_goal = query.X_WS * spatial(handling.object_goal);
  append(plan, "approach", with_home(query, whole(query, approach.free)), X_WO_start);
  append(plan, "press", whole(query, approach.press), X_WO_start);
  append_slide(query, slide, plan);
  append(plan, "lift", whole(query, handling.lift), X_WO_goal);
  append(plan, "reach", whole(query, handling.reach), X_WO_goal);
  append(plan, "grasp", whole(query, handling.grasp), X_WO_goal);
  append(plan, "close", handling.close, X_WO_goal);
  plan.status = Status::solved;
  plan.X_WO_goal = X_WO_goal;
  plan.X_WH_grasp = handling.X_WH;
  plan.overhang = handling.placement.overhang;
  if (!warn_of_drag(query.problem, plan)) warn_of_torsion(query.problem, plan);
}

std::string reason(const Plan& plan) {
  const bool pairs = plan.status == Status::no_valid_pair;
  std::ostringstream spent;
  spent << " within " << std::setprecision(3) << plan.statistics.seconds << " s and "
        << plan.statistics.iterations << " iterations";
  const std::string refused =
      spent.str() +
      (plan.statistics.refusals.empty()
           ? ""
           : "; refused most often: " + most_frequent(plan.statistics.refusals, pairs));
  if (plan.status != Status::solved && plan.statistics.iterations == 0) {
    return "the budget allowed no iteration";
  }
  switch (plan.status) {
    case Status::solved:
      return "solved";
    case Status::start_in_collision:
      return plan.reason;
    case Status::no_start_root:
      return "no configuration presses on the object" + refused;
    case Status::no_goal_root:
      return "no configuration presses near an edge" + refused;
    case Status::no_valid_pair:
      return "starts and goals were connected, but no pair of them held" + refused;
    case Status::not_connected:
      return "no start and goal were connected" + refused;
    case Status::interrupted:
      return "interrupted: not found" + refused;
  }
  return "";
}

}  // namespace graspless::slide
