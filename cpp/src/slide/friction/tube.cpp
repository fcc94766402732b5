// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/slide/tube.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "graspless/slide/torsion.hpp"
#include "graspless/watch.hpp"

#include "slide/friction/course.hpp"
#include "slide/friction/drag.hpp"
#include "slide/friction/pad.hpp"

namespace graspless::slide {
namespace {

constexpr double kBothWorst = 0.7;  // share of each of two errors that are worst at once

constexpr double kStride = 0.01;      // step of the integration [m]
constexpr double kLongStride = 0.03;  // where an estimate is enough
constexpr double kFiner = 8;          // steps where slip begins or ends
constexpr double kTurnStride = 10;    // turn of a step, relative to its length [rad/m]
constexpr int kMostSteps = 1000;      // between two rows
constexpr double kFelt = 0.05;  // smallest shift of the pressure that matters, over that of the pad
constexpr double kArmLever = 0.05;  // over which an error of the tip turns the pad [m]

/// World in which a slide is followed: how much weaker the pad is than in the task, as a share of
/// the spread, where the centre of mass is, on which part of its length the pad bears, and how far
/// out the support's friction acts.
struct World {
  double weakness;
  Eigen::Vector2d com_O;
  Planar X_SO;
  double bearing = 1;  // share of the pad's length
  double beside = 0;   // of the middle of that part from the middle of the pad [m]
  double lever = 1;    // of friction, relative to an even pressure
};

/// The place of a world's pad on its way.
PadPoint pad_at(const World& world, const Leg& leg, double t) {
  PadPoint pad = leg.at(t);
  if (world.beside != 0) pad.position += world.beside * leg.line_at(t);
  return pad;
}

/// Its twist between two places.
Eigen::Vector3d twist_between(const World& world, const Leg& leg, double from, double to) {
  Eigen::Vector3d twist = (to - from) * leg.twist();
  if (world.beside != 0) twist.head<2>() += world.beside * (leg.line_at(to) - leg.line_at(from));
  return twist;
}

/// Returns the object's twist at the pad for that of the pad.
Eigen::Vector3d twist_in(const Problem& problem, const World& world, const PadPoint& pad,
                         const Eigen::Vector3d& twist) {
  const Eigen::Vector2d p_TC =
      (world.X_SO * world.com_O - pad.position) * (pad.weight / (1 + pad.weight));
  const Eigen::Vector2d p_OC = world.X_SO.inverse() * (pad.position + p_TC);
  const double radius = world.lever * pad.radius * problem.object.mean_distance(p_OC);
  const double ratio = problem.support.friction() / problem.hand.pad_friction * (1 + pad.weight) *
                       std::exp(world.weakness * pad.weakness);
  return dragged({ratio, radius, world.bearing * problem.hand.pad_width / 4}, p_TC, twist);
}

/// Moves an object by a twist at its point `at`.
Planar moved(const Planar& X_SO, const Eigen::Vector2d& at, const Eigen::Vector3d& twist) {
  const Eigen::Rotation2Dd turn(twist.z());
  Planar X = X_SO;
  X.translation() = at + twist.head<2>() + turn * (X_SO.translation() - at).eval();
  X.linear() = turn.toRotationMatrix() * X_SO.linear();
  return X;
}

/// Moves the object of a world along with the pad: at once if the pad holds it at both ends of the
/// leg, or else in steps by the midpoint rule. They are short if it holds at one end: slip that
/// begins or ends within a step is lost, or counted for all of it.
void follow(const Problem& problem, const Leg& leg, double stride, World& world) {
  World there = world;
  const PadPoint start = pad_at(world, leg, 0), end = pad_at(world, leg, 1);
  const Eigen::Vector3d whole = twist_between(world, leg, 0, 1);
  there.X_SO = moved(world.X_SO, start.position, whole);
  const bool holds = twist_in(problem, world, start, whole) == whole;
  const bool holds_then = twist_in(problem, there, end, whole) == whole;
  if (holds && holds_then) {
    world = there;
    return;
  }
  if (holds != holds_then) stride /= kFiner;
  const double length =
      std::max(leg.twist().head<2>().norm(), std::abs(leg.twist().z()) / kTurnStride);
  const double strides = std::min(std::ceil(length / stride), 1.0 * kMostSteps);
  const int steps = std::max(1, static_cast<int>(strides));
  for (int i = 0; i < steps; ++i) {
    poll();
    const double t = 1.0 * i / steps;
    const PadPoint from = pad_at(world, leg, t), middle = pad_at(world, leg, (i + 0.5) / steps);
    const Eigen::Vector3d step = twist_between(world, leg, t, (i + 1.0) / steps);
    World half = world;
    half.X_SO = moved(world.X_SO, from.position, twist_in(problem, world, from, step) / 2);
    const Eigen::Vector3d twist = twist_in(problem, half, middle, step);
    world.X_SO = moved(world.X_SO, middle.position - twist.head<2>() / 2, twist);
  }
}

/// Two worlds in which the pad bears at one of its ends, as far as options.pad_spread allows.
void add_ends(const Problem& problem, const Options& options, const Planar& X_SO,
              std::vector<World>& worlds) {
  const double off = options.pad_spread;
  if (off == 0) return;
  for (const double side : {-0.5, 0.5}) {
    const double beside = side * off * problem.hand.pad_width;
    worlds.push_back({kBothWorst, problem.object.com().head<2>(), X_SO, 1 - off, beside});
  }
}

/// The same worlds with friction on the rim of a hollow object: it makes turning harder for the
/// pad, and following.
void add_rims(const Problem& problem, std::vector<World>& worlds) {
  if (!problem.object.is_hollow()) return;
  for (std::size_t i = 0, flat = worlds.size(); i < flat; ++i) {
    worlds.push_back(worlds[i]);
    worlds.back().lever = problem.object.lever();
  }
}

std::vector<World> worlds_of(const Problem& problem, const Options& options,
                             const std::vector<PressedRow>& rows) {
  const Planar& X_SO = rows.front().X_SO;
  const Eigen::Vector2d com = problem.object.com().head<2>();
  const Eigen::Vector2d way = rows.back().p_SM - rows.front().p_SM;
  const double length = way.norm();
  const Eigen::Vector2d ahead =
      X_SO.linear().transpose() *
      (length > 0 ? Eigen::Vector2d(way / length) : Eigen::Vector2d::UnitX());
  const Eigen::Vector2d aside =
      kBothWorst * options.com_spread * Eigen::Vector2d(-ahead.y(), ahead.x());
  std::vector<World> worlds{{0, com, X_SO}, {1, com, X_SO}};  // the second has the weakest pad
  const double press = press_force(problem.hand, rows.front().depth, rows.front().tip.pitch);
  const double share = weight(problem) / (weight(problem) + press);
  if (share * aside.norm() > kFelt * problem.hand.pad_width / 4) {
    worlds.push_back({kBothWorst, com + aside, X_SO});
    worlds.push_back({kBothWorst, com - aside, X_SO});
  }
  add_ends(problem, options, X_SO, worlds);
  add_rims(problem, worlds);
  return worlds;
}

double turn_between(const Planar& a, const Planar& b) {
  const Eigen::Matrix2d R = a.linear().transpose() * b.linear();
  return std::atan2(R(1, 0), R(0, 0));
}

/// Distance by which a wrist that gives way trails behind [m], an error without slip.
double trailing_at(const Problem& problem, const PressedRow& row) {
  constexpr double kGuarded = 2000;  // of an arm that holds a force, as simulated [N/m]
  const FingerModel model = problem.hand.finger_model;
  if (model != FingerModel::impedance && model != FingerModel::rigid_guarded) return 0;
  const double K = model == FingerModel::impedance ? problem.hand.wrist_stiffness : kGuarded;
  const double N = press_force(problem.hand, row.depth, row.tip.pitch);
  return problem.support.friction() * (N + weight(problem)) / K;
}

void add_row(const Problem& problem, const Options& options, const PressedRow& row,
             double shift_spread, const std::vector<World>& worlds, Tube& tube) {
  double position = 0, angle = 0;
  for (const World& world : worlds) {
    position = std::max(position, (world.X_SO.translation() - row.X_SO.translation()).norm());
    angle = std::max(angle, std::abs(turn_between(world.X_SO, row.X_SO)));
  }
  tube.position.push_back(
      position + trailing_at(problem, row) +
      combined({options.position_spread, shift_spread, options.tracking_spread}));
  tube.angle.push_back(angle +
                       combined({options.angle_spread, options.tracking_spread / kArmLever}));
}

std::vector<Planar> ends_of(const std::vector<World>& worlds) {
  std::vector<Planar> ends;
  for (const World& world : worlds) ends.push_back(world.X_SO);
  return ends;
}

}  // namespace

Course course(const Problem& problem, const Options& options, const std::vector<PressedRow>& rows) {
  Course found;
  if (rows.empty()) return found;
  const Pads pads(problem, options);
  std::vector<World> worlds = worlds_of(problem, options, rows);
  std::optional<Pad> before;
  for (const PressedRow& row : rows) {
    const Pad now = pads.at(row);
    if (before) {
      const Leg leg(problem, *before, now);
      for (World& world : worlds) follow(problem, leg, kStride, world);
    }
    add_row(problem, options, row, now.shift_spread, worlds, found.tube);
    before = now;
  }
  found.ends = ends_of(worlds);
  return found;
}

std::vector<Planar> weakest_ends(const Problem& problem, const Options& options,
                                 const EvenSlide& slide) {
  constexpr double kMostTurn = 0.5;  // of a leg [rad]
  const double turn = turn_between(slide.tip_start, slide.tip_goal);
  const int legs = 1 + static_cast<int>(std::abs(turn) / kMostTurn);
  std::vector<World> worlds{{1, problem.object.com().head<2>(), slide.object_start}};
  add_ends(problem, options, slide.object_start, worlds);
  add_rims(problem, worlds);
  Pad before = Pads(problem, options).at(slide.tip_start, slide.depth, options.pitch);
  for (int i = 1; i <= legs; ++i) {
    const double t = 1.0 * i / legs;
    Pad now = before;
    now.position = (1 - t) * slide.tip_start.translation() + t * slide.tip_goal.translation();
    now.heading = Eigen::Rotation2Dd(t * turn) * slide.tip_start.linear().col(0).eval();
    now.yaw = before.yaw + turn / legs;
    const Leg leg(problem, before, now);
    for (World& world : worlds) follow(problem, leg, kLongStride, world);
    before = now;
  }
  return ends_of(worlds);
}

Lag largest_lag(const Problem& problem, const std::vector<Planar>& ends,
                const Planar& object_goal) {
  const Eigen::Vector2d com_O = problem.object.com().head<2>();
  Lag found;
  for (const Planar& end : ends) {
    found.position = std::max(found.position, (end * com_O - object_goal * com_O).norm());
    found.angle = std::max(found.angle, std::abs(turn_between(end, object_goal)));
  }
  return found;
}

std::optional<std::string> broken_by_lag(const Problem& problem, const Planar& object_goal,
                                         const std::optional<Eigen::Vector2d>& grasp,
                                         const std::vector<Planar>& ends) {
  const auto depth_at = [&](const Planar& X_SO) {
    return grasp ? problem.object.outline().depth(X_SO.inverse() * *grasp) : 0;
  };
  const double least = std::min(0.0, depth_at(object_goal) - kGraspGive);
  for (const Planar& end : ends) {
    if (!is_com_inside(problem, end, 0)) return "the centre of mass off the support";
    if (depth_at(end) < least) return "the object out of the hand";
  }
  const Lag lag = largest_lag(problem, ends, object_goal);
  if (lag.angle > kMostLag.angle) return "the object turned by more than 5 deg";
  if (lag.position > kMostLag.position) return "the object more than 10 mm behind";
  for (const Planar& end : ends) {
    if (!is_supported(problem, end, 0)) return "the object tipping on its rim";
  }
  return std::nullopt;
}

Tube tube(const Problem& problem, const Plan& plan, const Options& options) {
  return course(problem, options, pressed_rows(problem, plan)).tube;
}

double least_drag(const Problem& problem, const Options& options) {
  const double depth = depth_band(problem.hand, options).max;
  const double pitch = options.pitch + options.pitch_tolerance;
  const Pad pad = Pads(problem, options).at(Planar::Identity(), depth, pitch);
  const double N =
      dragging_force(problem.hand, depth, pitch, 1, problem.support.friction(), weight(problem));
  return drag_ratio(problem, N) * std::exp(pad.weakness);
}

}  // namespace graspless::slide
