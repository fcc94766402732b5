// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/refusals.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <utility>
#include <vector>

#include "graspless/slide/tube.hpp"

#include "collision/overlap.hpp"
#include "planning/obstruction.hpp"
#include "robot/moved_links.hpp"
#include "robot/names.hpp"
#include "slide/placement.hpp"
#include "slide/task/hand_frames.hpp"
#include "text.hpp"

namespace graspless::slide {
namespace {

constexpr std::size_t kReasons = 3;

/// The depth of bodies in each other, or that they only are nearer than links may be.
std::string depth(collision::World& world, std::pair<int, int> bodies) {
  const auto [a, b] = bodies;
  world.keep_apart(a, b, 0);
  const double deep = collision::overlap(world, a, b);
  if (deep == 0) return "not proven to be " + in_mm(kLinkClearance) + " apart,";
  if (!std::isfinite(deep)) return "one inside the other";
  return (deep < 1e-3 ? "less than 1 mm" : "about " + in_mm(deep)) + " deep";
}

/// "frame at (x, y, z) m, heading yaw deg".
std::string pose_of(const robot::Robot& robot, const std::string& frame, const Eigen::VectorXd& q) {
  const Eigen::Isometry3d X_WF = robot.pose(robot.frame(frame), q);
  const Eigen::Vector3d p = X_WF.translation(), z = X_WF.linear().col(2);
  std::ostringstream out;
  out << std::fixed << std::setprecision(3) << frame << " at (" << p.x() << ", " << p.y() << ", "
      << p.z() << ") m, heading " << std::lround(std::atan2(z.y(), z.x()) / kDegree) << " deg";
  return out.str();
}

/// Lengths of an open finger that touches something at the grasp; empty for other links.
std::string finger_lengths(const Query& query, const Collision& collision) {
  const Hand& hand = query.problem.hand;
  const collision::World& world = collision.scene->world();
  if (collision.frame != hand.grasp_frame) return "";
  for (const int body : {collision.bodies.first, collision.bodies.second}) {
    const std::string& name = world.name(body);
    if (std::count(hand.fingers.begin(), hand.fingers.end(), name) > 0)
      return "; " + jaw_lengths(query.problem, collision.q, collision.X_WO, name);
  }
  return "";
}

/// The smallest lag of a kind; empty for other rejections.
std::string smallest_lag(const Query& query, const std::string& why) {
  const auto found = query.lags.find(why);
  if (found == query.lags.end()) return "";
  const Lag& lag = found->second;
  return ", at best " + in_mm(lag.position) + " and " +
         std::to_string(std::lround(lag.angle / kDegree)) + " deg off";
}

/// Depth and pose of the first collision of a kind, or the smallest lag; empty for other
/// rejections.
std::string example(Query& query, const std::string& why) {
  if (query.lags.count(why) > 0) return smallest_lag(query, why);
  const auto found = query.collisions.find(why);
  if (found == query.collisions.end()) return "";
  const Collision& collision = found->second;
  scene::Scene& scene = *collision.scene;
  scene.move_object(scene.world().body(kObjectBody), collision.X_WO);
  scene.collision(collision.q);  // moves the links
  return ", " + depth(scene.world(), collision.bodies) + " with " +
         pose_of(query.problem.robot, collision.frame, collision.q) +
         finger_lengths(query, collision);
}

using Counted = std::pair<std::int64_t, std::string>;

/// The most frequent rejections; with `pairs_first`, two of start-goal pairs come before others.
/// One that is a collision is added if there is one, because it tells what to move, and one that is
/// a lag, because no other place of the robot helps against it.
std::vector<Counted> frequent(const Query& query, bool pairs_first) {
  constexpr std::ptrdiff_t kPairs = 2;
  std::vector<Counted> all;
  for (const auto& [why, times] : query.statistics.refusals) all.emplace_back(times, why);
  std::sort(all.rbegin(), all.rend());
  if (pairs_first) {
    const auto others = std::stable_partition(all.begin(), all.end(), [](const Counted& counted) {
      return counted.second.rfind("pair:", 0) == 0;
    });
    const auto more = all.begin() + std::min(kPairs, others - all.begin());
    std::rotate(more, others, all.end());
  }
  const auto end = all.begin() + std::min(kReasons, all.size());
  std::vector<Counted> found(all.begin(), end);
  const auto add_one_of = [&](const auto& kind) {
    const auto first = std::find_if(all.begin(), all.end(), [&](const Counted& counted) {
      return kind.count(counted.second) > 0;
    });
    if (first >= end && first != all.end()) found.push_back(*first);
  };
  add_one_of(query.collisions);
  add_one_of(query.lags);
  return found;
}

/// Lists them with what example() tells, as far as the clock leaves time to measure it.
std::string most_frequent(Query& query, bool pairs_first) {
  const std::vector<Counted> rejections = frequent(query, pairs_first);
  std::map<std::string, std::string> examples;
  query.clock.run([&] {
    for (const auto& [times, why] : rejections) examples[why] = example(query, why);
  });
  std::string text;
  for (const auto& [times, why] : rejections) {
    text += (text.empty() ? "" : ", ") + why + " (" + std::to_string(times) + examples[why] + ")";
  }
  return text;
}

}  // namespace

std::string in_mm(double length) {
  std::ostringstream out;
  const double mm = 1000 * length;
  out << std::setprecision(std::abs(mm) < 100 ? 2 : 4) << mm << " mm";
  return out.str();
}

std::string beside_edge(double inside) {
  return in_mm(std::abs(inside)) + (inside < 0 ? " outside" : " inside") + " the edge";
}

bool is_home_free(Query& query, Plan& plan) {
  const Eigen::VectorXd &home = query.problem.q_home, &open = query.arm.open();
  plan.status = Status::start_in_collision;
  collision::World& world = query.free.world();
  for (const Eigen::VectorXd& q : {home, open}) {
    const auto [a, b] = query.free.collision(q);
    if (a.empty()) continue;
    const std::vector<std::string>& links = query.problem.robot.frame_names();
    const bool is_link = robot::contains(links, a) || robot::contains(links, b);
    plan.reason =
        "at q_home, '" + a + "' touches '" + b + "', " +
        depth(world, {world.body(a), world.body(b)}) +
        (is_link ? "; choose another q_home (robot.home of a task)" : "; move one of them") +
        planning::remedy(a, b);
    return false;
  }
  if (query.is_motion_free(home, open)) return true;
  plan.reason = "at q_home, the hand touches something while it opens";
  return false;
}

bool can_reach(const Query& query, Plan& plan) {
  constexpr double kSlack = 0.02;  // between the contact and a rigid fingertip [m]
  const Problem& problem = query.problem;
  const robot::Robot& robot = problem.robot;
  const auto span = robot::span_of(robot, robot.group(problem.hand.arm),
                                   robot.frame(problem.hand.fingertip), problem.q_home);
  if (!span) return true;
  const Eigen::Vector3d base_S = query.X_WS.inverse() * span->base_W;
  const Eigen::Vector2d base_O = query.object_start.inverse() * Eigen::Vector2d(base_S.head<2>());
  const double aside = (problem.object.points().colwise() - base_O).colwise().norm().minCoeff();
  const double nearest = std::hypot(aside, base_S.z() - query.top);
  const Options& options = query.options;
  const double bent = contact_shift(problem.hand, depth_band(problem.hand, options).max,
                                    options.pitch, options.pitch);
  if (nearest <= span->most + kSlack + bent) return true;
  plan.status = Status::no_start_root;
  plan.reason =
      robot::beyond(robot, *span, "the fingertip", "the nearest point of the object", nearest);
  return false;
}

bool can_press(const Query& query, Plan& plan) {
  const Object& object = query.problem.object;
  if (!object.heights() || !contact_points(query.problem, query.options).empty()) return true;
  plan.status = Status::no_start_root;
  plan.reason = "object '" + object.name() +
                "' has nothing to press on: no part of its top is level within " +
                in_mm(face_radius(query.problem.hand, query.options)) + " of a contact";
  return false;
}

bool can_drag(const Query& query, Plan& plan) {
  const Problem& problem = query.problem;
  const double least = least_drag(problem, query.options);
  if (!query.options.refuse_lag || least < 1) return true;
  plan.status = Status::cannot_drag;
  std::ostringstream out;
  out << std::setprecision(3) << "the slide may need " << least
      << " times the friction that the pad has, wherever the finger presses (object.mass "
      << problem.object.mass() << " kg, support.friction " << problem.support.friction()
      << ", hand.pad_friction " << problem.hand.pad_friction
      << "; options.friction_spread allows either friction to differ by "
      << std::lround(100 * query.options.friction_spread) << " %)";
  plan.reason = out.str();
  return false;
}

bool can_be_left(const Query& query, Plan& plan) {
  const Problem& problem = query.problem;
  const double margin = query.options.com_margin;
  if (!query.object_end || is_supported(problem, *query.object_end, margin)) return true;
  plan.status = Status::no_goal_root;
  const double inside = problem.support.polygon().depth(com_foot(problem, *query.object_end));
  plan.reason = "at the end (X_WO_end), " +
                (inside < margin ? "the centre of mass is " + beside_edge(inside)
                                 : std::string("the part of the rim on the support does not hold "
                                               "the centre of mass")) +
                "; options.com_margin asks for " + in_mm(margin);
  return false;
}

std::string reason(Query& query, const Plan& plan) {
  if (plan.status == Status::solved) return "solved";  // depths of collisions are not wanted
  if (plan.statistics.iterations == 0)
    return query.clock.was_interrupted() ? "interrupted before the first iteration"
                                         : "the budget allowed no iteration";
  const bool pairs = plan.status == Status::no_valid_pair;
  // Without the time: the same seed and iterations give the same file.
  const std::string refused = " within " + std::to_string(plan.statistics.iterations) +
                              (plan.statistics.iterations == 1 ? " iteration" : " iterations") +
                              query.clock.note() +
                              (plan.statistics.refusals.empty()
                                   ? ""
                                   : "; most frequent rejections: " + most_frequent(query, pairs));
  switch (plan.status) {
    case Status::start_in_collision:
    case Status::off_support:
    case Status::contact_lost:
    case Status::cannot_drag:
      return plan.reason;
    case Status::no_start_root:
      return "no configuration was found that presses on the object" + refused;
    case Status::no_goal_root:
      return (query.object_end
                  ? "no configuration was found that presses on the object where it is to be left"
                  : "no configuration was found that presses near an edge of the support") +
             refused;
    case Status::no_valid_pair:
      return "starts and goals were connected, but no pair of them was valid" + refused;
    case Status::not_connected:
      return "no start could be connected with a goal" + refused;
    case Status::interrupted:
      return "interrupted before a plan was found," + refused;
    case Status::solved:
    case Status::out_of_memory:
      break;
  }
  return "";
}

}  // namespace graspless::slide
