// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/query.hpp"

#include <algorithm>

namespace graspless::slide {
namespace {

robot::Ik make_ik(const Problem& problem, const std::string& frame, const Arm& arm) {
  robot::Ik::Options options;
  options.whole_turns = false;  // they touch the same things
  return robot::Ik(problem.robot, problem.robot.frame(frame), arm.joints(), options);
}

}  // namespace

Query::Query(const Problem& problem, const Options& options, planning::Clock& clock,
             std::uint64_t seed)
    : problem(problem),
      options(options),
      clock(clock),
      rng(seed),
      refuses_lag(options.refuse_lag),
      arm(problem),
      tip_ik(make_ik(problem, problem.hand.fingertip, arm)),
      grasp_ik(make_ik(problem, problem.hand.grasp_frame, arm)),
      free(make_scene(problem)),
      contact(problem, options, arm, free),
      object_body(free.world().body(kObjectBody)),
      object_start(planar(problem.support.X_WS().inverse() * problem.X_WO_start)),
      top(problem.object.top()),
      X_WS(problem.support.X_WS()) {
  if (problem.X_WO_end) object_end = planar(X_WS.inverse() * *problem.X_WO_end);
}

void Query::refuse_collision(const std::string& when, scene::Scene& scene,
                             std::pair<int, int> bodies, const Eigen::VectorXd& q,
                             const std::string& frame) {
  const collision::World& world = scene.world();
  const std::string why =
      when + "collision of " + world.name(bodies.first) + " with " + world.name(bodies.second);
  if (++statistics.refusals[why] > 1) return;
  collisions.insert({why, {&scene, bodies, q, world.pose(world.body(kObjectBody)), frame}});
}

void Query::refuse_press(const std::string& when, const Eigen::VectorXd& arm_part) {
  if (!contact.touching()) return refuse(when + "contact");
  refuse_collision(when, contact.scene(), *contact.touching(), arm.full(arm_part),
                   problem.hand.fingertip);
}

bool Query::is_lag_small(Slid slide) {
  if (refuses_lag && tipping_row(problem, options, slide.pressed)) {
    refuse("pair: drag may tip the object");
    return false;
  }
  if (refuses_lag && drag_load(problem, slide.pressed) > 1) {
    refuse("pair: the pad cannot drag the object along without turning it");
    return false;
  }
  Course found = course(problem, options, slide.pressed);
  const Planar& goal = slide.pressed.back().X_SO;
  const auto grasp = [&]() -> std::optional<Eigen::Vector2d> {
    if (object_end) return std::nullopt;
    return placement(problem, options, goal).out_center;
  };
  if (!allows_lag("pair", found.ends, goal, grasp)) return false;
  slide.tube = std::move(found.tube);
  slid = std::move(slide);
  return true;
}

bool Query::is_lag_likely_small(const ContactSpace::Carried& carried, double depth,
                                const std::optional<Placement>& place, const Planar& object_goal) {
  if (!refuses_lag) return true;
  const Planar tip_goal = object_goal * carried.object_start.inverse() * carried.tip_start;
  const std::vector<Planar> ends =
      weakest_ends(problem, options, {carried.tip_start, tip_goal, carried.object_start, depth});
  return allows_lag("goal", ends, object_goal, [&]() -> std::optional<Eigen::Vector2d> {
    if (!place) return std::nullopt;
    return place->out_center;
  });
}

bool Query::allows_lag(const std::string& what, const std::vector<Planar>& ends, const Planar& goal,
                       const std::function<std::optional<Eigen::Vector2d>()>& grasp) {
  constexpr double kNothing = 1e-9;  // [m, rad]
  if (!refuses_lag) return true;
  const Lag lag = largest_lag(problem, ends, goal);
  if (lag.position < kNothing && lag.angle < kNothing) return true;
  const std::optional<std::string> broken = broken_by_lag(problem, goal, grasp(), ends);
  if (!broken) return true;
  const std::string why = what + ": friction may leave " + *broken;
  refuse(why);
  ++num_lags;
  const auto [known, is_new] = lags.insert({why, lag});
  if (!is_new && lag.position < known->second.position) known->second = lag;
  return false;
}

Eigen::Isometry3d Query::pressed_tip(const Planar& contact, double depth, double pitch) const {
  const Eigen::Vector2d heading = contact.linear().col(0);
  const double shift = contact_shift(problem.hand, depth, pitch, options.pitch);
  return X_WS * tip_pose(contact.translation() - shift * heading, top - depth, heading, pitch);
}

Eigen::VectorXd Query::draw_seed() {
  if (tip_ik.is_closed_form() || uniform(0, 1) < 0.5) return arm.open();
  Eigen::VectorXd q(arm.dof());
  for (int i = 0; i < q.size(); ++i) q[i] = uniform(arm.lower()[i], arm.upper()[i]);
  return arm.full(q);
}

double Query::draw_free_joint() {
  const std::optional<int> joint = tip_ik.free_joint();
  return joint ? uniform(problem.robot.lower()[*joint], problem.robot.upper()[*joint]) : 0;
}

double Query::draw_free_joint(double near) {
  constexpr double kNear = 0.5;  // [rad]
  const std::optional<int> joint = tip_ik.free_joint();
  if (!joint) return 0;
  return std::clamp(near + uniform(-kNear, kNear), problem.robot.lower()[*joint],
                    problem.robot.upper()[*joint]);
}

std::vector<Eigen::VectorXd> Query::draw_ik(const robot::Ik& ik, const Eigen::Isometry3d& X_WF,
                                            const Eigen::VectorXd& near, double free_joint) {
  ++statistics.ik_calls;
  std::vector<Eigen::VectorXd> solutions;
  if (ik.is_closed_form()) {
    ik.solve_free(X_WF, free_joint, near, solutions);
  } else if (auto q = ik.solve_near(X_WF, near)) {
    solutions.push_back(*q);
  }
  return solutions;
}

}  // namespace graspless::slide
