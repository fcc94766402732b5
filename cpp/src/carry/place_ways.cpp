// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "graspless/planning/free_path.hpp"
#include "graspless/watch.hpp"

#include "carry/place_search.hpp"
#include "carry/search.hpp"
#include "carry/straight_path.hpp"
#include "planning/joints.hpp"
#include "scene/rows.hpp"

/// Ways to the places, straight motions of the hand, and tests of motions.
namespace graspless::carry {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;
using planning::Path;

namespace {

constexpr double kTurnPoint = 0.03;    // between their attitudes [rad]
constexpr int kTreeIterations = 1000;  // of each
constexpr std::size_t kTrees = 12;     // grown at most once a way is known
constexpr double kShortWay = 2;        // of the object, relative to its distance from the start
constexpr double kNear = 0.2;          // shorter distances count as this [m]
constexpr double kWayStep = 0.1;       // between the points that measure a way [rad]
constexpr double kBranch = 0.25;       // a longer step has left the branch of the inverse [rad]

}  // namespace

/// Goes to a place straight and level, and straight down, as far as the inverse kinematics follows
/// from the start.
bool PlaceSearch::go_straight(int place, Plan& plan) {
  hold(0);
  const Isometry3d& X_WO = places_.X_WO[place];
  const StraightPath way(problem_.object.X_WB, Eigen::Translation3d(rise(place)) * X_WO);
  const int steps = std::max({1, static_cast<int>(std::ceil(way.distance() / kWaypoint)),
                              static_cast<int>(std::ceil(way.angle() / kTurnPoint))});
  std::vector<Isometry3d> poses;
  for (int i = 1; i <= steps; ++i)
    poses.push_back(way.pose(static_cast<double>(i) / steps, 0) * X_FO_.inverse());
  const std::optional<Path> transfer = follow(problem_.q_start, poses);
  if (!transfer) return false;
  for (std::size_t i = 0; i + 1 < transfer->size(); ++i)
    if (!is_level((*transfer)[i], (*transfer)[i + 1])) return false;
  hold(options_.height);
  const VectorXd& above = transfer->back();
  std::optional<Path> lower =
      follow(above, line(above, -rise(place).normalized(), rise(place).norm()));
  if (!lower) return false;
  const std::optional<Putting> putting = let_go(place, std::move(*lower));
  if (!putting) return false;
  assemble(*transfer, *putting, plan);
  return true;
}

/// Goes to one of some places by a tree. Of several ways, the one on which the object travels least
/// is taken, unless one is short.
bool PlaceSearch::go_around(const std::vector<Putting>& puttings, Plan& plan) {
  Path best;
  const Putting* to = nullptr;
  double least = std::numeric_limits<double>::infinity();
  const auto look_at = [&](Path way, const Putting& putting) {
    const double detour = detour_of(way);
    if (detour >= least) return;
    least = detour;
    best = std::move(way);
    to = &putting;
  };
  const auto grow = [&] {
    std::size_t left = puttings.size();  // trees
    for (std::size_t i = 0; left > 0 && least > kShortWay && !clock_.is_out(); ++i, --left) {
      const Putting& putting = puttings[i % puttings.size()];
      const std::optional<Path> way = way_to(putting, kTreeIterations);
      if (!way) {
        refuse("no way from the start");
        continue;
      }
      if (!to) left = kTrees;
      look_at(*way, putting);
      look_at(shortened(*way), putting);
    }
  };
  clock_.run(grow);
  return to && clock_.conclude([&] { assemble(best, *to, plan); });
}

/// Length of the object's way along a path, relative to the distance between its ends.
double PlaceSearch::detour_of(const Path& path) const {
  const Vector3d start = object_at(path.front()).translation();
  Vector3d last = start;
  double length = 0;
  for (const VectorXd& q : planning::subdivided(path, kWayStep)) {
    const Vector3d p = object_at(q).translation();
    length += (p - last).norm();
    last = p;
  }
  return length / std::max((last - start).norm(), kNear);
}

/// Shortens the way of an object that is kept level. Few straight lines between the corners of a
/// tree's path keep it so, but many between points that are nearer to each other. Parts of motions
/// are not tested where check() tests them, so all motions are tested again at the end.
Path PlaceSearch::shortened(const Path& path) {
  constexpr int kPasses = 6, kRounds = 100;
  constexpr double kPiece = 0.2;  // [rad]
  const auto is_motion_free = [&](const VectorXd& a, const VectorXd& b) {
    return is_level(a, b) && is_free(a, b);
  };
  const planning::Connect straight = [&](const VectorXd& a, const VectorXd& b) {
    return is_motion_free(a, b) ? std::optional(Path{a, b}) : std::nullopt;
  };
  Path shorter = path;
  for (int i = 0; i < kPasses && !clock_.is_out(); ++i)
    shorter = planning::shortcut(planning::subdivided(shorter, kPiece), straight, kRounds, rng_);
  for (std::size_t i = 1; i < shorter.size(); ++i)
    if (!is_motion_free(shorter[i - 1], shorter[i])) return path;
  return shorter;
}

/// The arm's free space, in which it keeps the held object level.
planning::FreeSpace PlaceSearch::held_space() {
  const planning::Joints joints{ik_.group(), problem_.q_start};
  planning::FreeSpace space;
  space.lower = joints.part(problem_.robot.lower());
  space.upper = joints.part(problem_.robot.upper());
  space.is_free = [this, joints](const VectorXd& arm) {
    return is_level(joints.full(arm)) && scene_.is_free(joints.full(arm));
  };
  space.is_motion_free = [this, joints](const VectorXd& a, const VectorXd& b) {
    return is_level(joints.full(a), joints.full(b)) && is_free(joints.full(a), joints.full(b));
  };
  space.is_out = [this] { return clock_.is_out(); };
  return space;
}

/// A way of the arm from the start to a place, with the object held.
std::optional<Path> PlaceSearch::way_to(const Putting& putting, int iterations) {
  hold(0);
  const planning::Joints joints{ik_.group(), problem_.q_start};
  const auto arm = planning::find_free_path(held_space(), joints.part(problem_.q_start),
                                            joints.part(putting.lower.front()), iterations, rng_);
  if (!arm) return std::nullopt;
  return joints.full(*arm);
}

/// Withdraws the hand along its way out, if there is one; else straight back along its own axis,
/// up, or away from the object.
std::optional<Path> PlaceSearch::withdrawn(const VectorXd& q) {
  if (!places_.way_out.empty()) return along_way_out(q);
  const Isometry3d X_WF = problem_.robot.pose(frame_, q);
  const Vector3d back = -X_WF.linear().col(2);
  const Vector3d away = X_WF.translation() - scene_.world().pose(object_).translation();
  for (const Vector3d& along : {back, places_.normal_W, Vector3d(back + places_.normal_W), away}) {
    if (along.norm() < 1e-3) continue;
    const auto poses = line(q, along.normalized(), options_.retreat);
    if (std::optional<Path> path = follow(q, poses)) return path;
  }
  return std::nullopt;
}

/// Moves the hand from q as on its way out, in its own frame.
std::optional<Path> PlaceSearch::along_way_out(const VectorXd& q) {
  const Isometry3d X_WF = problem_.robot.pose(frame_, q);
  const Isometry3d X_FW = problem_.robot.pose(frame_, places_.way_out.front()).inverse();
  Path path{q};
  for (const VectorXd& out : places_.way_out) {
    ++statistics_.ik_calls;
    const auto arm = ik_.solve_near(X_WF * X_FW * problem_.robot.pose(frame_, out), path.back());
    if (!arm) return std::nullopt;
    const planning::Joints joints{ik_.group(), out};
    const VectorXd next = joints.full(joints.part(*arm));
    if (problem_.robot.step(path.back(), next) > kBranch) return std::nullopt;
    if (!is_free(path.back(), next)) return std::nullopt;
    path.push_back(next);
  }
  return path;
}

/// Poses of the hand along a straight line from q, without turning.
std::vector<Isometry3d> PlaceSearch::line(const VectorXd& q, const Vector3d& along,
                                          double length) const {
  const Isometry3d X_WF = problem_.robot.pose(frame_, q);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / kWaypoint)));
  std::vector<Isometry3d> poses;
  for (int i = 1; i <= steps; ++i)
    poses.push_back(Eigen::Translation3d(along * (length * i / steps)) * X_WF);
  return poses;
}

/// Moves the hand from q through poses on one branch of the inverse kinematics.
std::optional<Path> PlaceSearch::follow(const VectorXd& q, const std::vector<Isometry3d>& poses) {
  Path path{q};
  for (const Isometry3d& X_WF : poses) {
    ++statistics_.ik_calls;
    const auto next = ik_.solve_near(X_WF, path.back());
    if (!next || problem_.robot.step(path.back(), *next) > kBranch) return std::nullopt;
    if (!is_free(path.back(), *next)) return std::nullopt;
    path.push_back(*next);
  }
  return path;
}

/// True if the object's vertical is near that at the start or that at the places.
bool PlaceSearch::is_level(const VectorXd& q) const {
  const Vector3d up = object_at(q).linear() * up_O_;
  const Vector3d before = problem_.object.X_WB.linear() * up_O_;
  return std::max(up.dot(before), up.dot(places_.normal_W)) >=
         std::cos(std::min(options_.max_tilt, M_PI));
}

bool PlaceSearch::is_level(const VectorXd& from, const VectorXd& to) const {
  const int pieces = std::max(
      1,
      static_cast<int>(std::ceil(problem_.robot.step(from, to) / checked_step(from, to) - 1e-6)));
  for (int i = 0; i <= pieces; ++i) {
    poll();
    if (!is_level(from + (to - from) * i / pieces)) return false;
  }
  return true;
}

bool PlaceSearch::is_free(const VectorXd& from, const VectorXd& to) {
  return scene_.is_free(from, to, checked_step(from, to));
}

double PlaceSearch::checked_step(const VectorXd& from, const VectorXd& to) const {
  return scene::replay_step(problem_.robot, from, to, options_.resolution);
}

}  // namespace graspless::carry
