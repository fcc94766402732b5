// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "carry/check_held.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "scene/bands.hpp"
#include "scene/rows.hpp"

namespace graspless::carry {

using Eigen::Isometry3d, Eigen::Quaterniond, Eigen::Vector3d, Eigen::VectorXd;

namespace {

double fraction_turned(const Quaterniond& from, const Quaterniond& to, const Quaterniond& now) {
  return now.angularDistance(from) / from.angularDistance(to);
}

/// Angle of the rotation about `axis` that is nearest to `turn`, in (-pi, pi] [rad].
double twist_about(const Vector3d& axis, const Quaterniond& turn) {
  const double angle = 2 * std::atan2(turn.vec().dot(axis), turn.w());
  return std::atan2(std::sin(angle), std::cos(angle));
}

}  // namespace

double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(a.transpose() * b)).angle();
}

HeldReplay::HeldReplay(const Problem& problem, const Obstacle& object, std::vector<Rest> rests,
                       const Options& options)
    : robot_(problem.robot),
      frame_(problem.robot.frame(problem.frame)),
      X_FO_(problem.robot.pose(frame_, problem.q_start).inverse() * object.X_WB),
      replay_(problem.robot),
      object_(replay_.add(object.name, collision::Solid(object.shapes, object.name), false)) {
  exclude_hand(problem);
  if (problem.places) rests.push_back({problem.places->on, problem.places->normal_W});
  for (const Obstacle& obstacle : problem.obstacles) {
    const int body = replay_.add(obstacle);
    replay_.world().add_pair(object_, body);
    for (const Rest& rest : rests) {
      if (rest.obstacle != obstacle.name) continue;
      replay_.world().allow_contact(object_, body, rest.normal_W, options.contact_depth);
    }
  }
}

/// Stops testing the object against links that never move relative to it: those beyond the arm's
/// last joint. They are found by moving each joint of the arm alone.
void HeldReplay::exclude_hand(const Problem& problem) {
  for (int link = 0; link < static_cast<int>(robot_.frame_names().size()); ++link) {
    bool stays = true;
    for (const int joint : robot_.group(problem.arm)) {
      VectorXd q = problem.q_start;
      const Isometry3d before = robot_.pose(frame_, q).inverse() * robot_.pose(link, q);
      q[joint] += 0.2;
      const Isometry3d after = robot_.pose(frame_, q).inverse() * robot_.pose(link, q);
      stays = stays && scene::is_same(before, after, kSame);
    }
    const int body = replay_.body_of(robot_.frame_names()[link]);
    if (!stays || body < 0) continue;
    replay_.world().remove_pair(body, object_);
    holding_.push_back(body);
  }
}

std::vector<std::string> HeldReplay::touching(const VectorXd& q, const Isometry3d& X_WO) {
  replay_.world().set_pose(object_, X_WO);
  return replay_.touching(q);
}

void HeldReplay::let_go() {
  for (const int body : holding_) replay_.world().add_pair(body, object_);
}

void HeldReplay::allow_sunk(const Places& places, double depth) {
  collision::World& world = replay_.world();
  world.allow_contact(object_, world.body(places.on), places.normal_W, depth);
}

void HeldReplay::ignore_touched(const VectorXd& q) {
  touching(q, object_at(q));
  for (const auto& [a, b] : replay_.world().all_collisions())
    if (a == object_ || b == object_) replay_.world().remove_pair(a, b);
}

std::optional<HeldReplay> hanging_replay(const Problem& problem, const Options& options) {
  if (!problem.X_WO_hanging) return std::nullopt;
  Obstacle hanging = problem.object;
  hanging.X_WB = *problem.X_WO_hanging;
  hanging.name += " hanging";
  return HeldReplay(problem, hanging, {}, options);
}

std::vector<scene::Doubt> HeldReplay::prove_free(const Segment& segment) {
  scene::Companion object;
  object.body = object_;
  object.carrier = {frame_, {X_FO_.translation(), replay_.world().radius(object_)}};
  object.place = [&](std::size_t, double, const robot::Poses& X_WL) {
    replay_.world().set_pose(object_, X_WL[frame_] * X_FO_);
  };
  return scene::EdgeProver(segment.name, segment.positions, replay_, object).run();
}

std::vector<scene::Doubt> HeldReplay::prove_free(const Segment& segment, const Isometry3d& put) {
  replay_.world().set_pose(object_, put);
  return scene::EdgeProver(segment.name, segment.positions, replay_, {}).run();
}

StraightWay::Deviation StraightWay::deviation(const Isometry3d& X_WO) const {
  const Vector3d a = start.translation(), b = goal.translation(), p = X_WO.translation();
  const Quaterniond from(start.linear()), to(goal.linear()), now(X_WO.linear());
  const double s = std::clamp(
      is_turn() ? fraction_turned(from, to, now) : (p - a).dot(b - a) / (b - a).squaredNorm(), 0.0,
      1.0);
  const Eigen::AngleAxisd turn(from.conjugate() * to);
  const auto angle_off = [&](double angle) {
    const Quaterniond wanted = from * Eigen::AngleAxisd(s * angle, turn.axis());
    if (is_turn()) return now.angularDistance(wanted);
    const Vector3d along = (b - a).normalized();
    const double twist = twist_about(along, now * wanted.conjugate());
    const Eigen::AngleAxisd kept(std::clamp(twist, -max_twist, max_twist), along);
    return now.angularDistance(kept * wanted);
  };
  double angle = angle_off(turn.angle());
  if (turn.angle() > M_PI - kSame) {  // either way round
    angle = std::min(angle, angle_off(turn.angle() - 2 * M_PI));
  }
  return {(p - a - s * (b - a)).norm(), angle};
}

std::string StraightWay::fault_of(const Isometry3d& X_WO, const Options& options) const {
  const Deviation off = deviation(X_WO);
  std::ostringstream text;
  if (off.distance > options.tolerance + kSame) {
    text << "the object is " << off.distance << " m off its straight path";
  } else if (off.angle > options.angle_tolerance + kSame) {
    text << "the object is turned by " << off.angle << " rad off its straight path";
  }
  return text.str();
}

std::vector<scene::Doubt> StraightWay::prove(const HeldReplay& held, const Segment& segment,
                                             const Options& options) const {
  const double length = (goal.translation() - start.translation()).norm();
  const double turn = angle_between(start.linear(), goal.linear());
  std::vector<scene::Doubt> doubts;
  for (std::size_t edge = 0; edge + 1 < segment.positions.size(); ++edge) {
    const VectorXd& from = segment.positions[edge];
    const VectorXd step = segment.positions[edge + 1] - from;
    const scene::FrameRates rates = held.rates(step);
    const auto slack = [&](double t0, const Isometry3d& first, double t1, const Isometry3d& last) {
      const double width = t1 - t0, bend = rates.curvature * width * width;
      const Deviation a = deviation(first), b = deviation(last);
      const double path = (last.translation() - first.translation()).norm() + bend / 2;
      const double turned =
          rates.turn * width + (is_turn() ? rates.turn * width : turn * path / length);
      scene::Slack slack;
      slack.add(options.tolerance + kSame - std::max(a.distance, b.distance) - bend / 8 -
                    (is_turn() && width > 0 ? length : 0),
                "distance of the object from its straight path");
      slack.add(options.angle_tolerance + kSame - (a.angle + b.angle + turned) / 2,
                "turn of the object off its straight path", "rad");
      return slack;
    };
    const auto doubt = scene::find_doubt(
        segment.name, edge, [&](double t) { return held.object_at(from + t * step); }, slack);
    if (doubt) doubts.push_back(*doubt);
  }
  return doubts;
}

std::vector<std::string> shape_faults(const Problem& problem, const Plan& plan,
                                      const std::vector<std::string>& names) {
  if (!plan) return {"plan: not solved: " + plan.reason};
  std::vector<std::string> faults;
  if (plan.reached != 1)
    faults.push_back("plan: reached must be 1 if it is solved, but is " +
                     std::to_string(plan.reached));
  scene::check_shape(problem.robot, plan, names,
                     [&](const std::string& place, const std::string& what) {
                       faults.push_back(place + ": " + what);
                     });
  return faults;
}

double moved(const Problem& problem, bool in_arm, const VectorXd& from, const VectorXd& to) {
  VectorXd counts = VectorXd::Constant(problem.robot.dof(), in_arm ? 0 : 1);
  for (const int joint : problem.robot.group(problem.arm)) counts[joint] = in_arm ? 1 : 0;
  return (to - from).cwiseProduct(counts).lpNorm<Eigen::Infinity>();
}

}  // namespace graspless::carry
