// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "carry/place_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graspless/planning/free_path.hpp"
#include "graspless/watch.hpp"

#include "carry/search.hpp"
#include "carry/straight_path.hpp"
#include "planning/joints.hpp"
#include "planning/obstruction.hpp"

namespace graspless::carry {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;
using planning::Path;

constexpr double kTurnPoint = 0.03;         // between their attitudes [rad]
constexpr std::size_t kConfigurations = 6;  // of the arm, for each place
constexpr std::size_t kWaysDown = 3;        // of these, from which the object is lowered
constexpr std::size_t kWithoutWay = 12;     // such configurations to which a tree is grown
constexpr int kTreeIterations = 1000;       // of each
constexpr int kTrees = 12;                  // grown at most once a way is known
constexpr double kShortWay = 2;     // of the object, relative to its distance from the start
constexpr double kNear = 0.2;       // shorter distances count as this [m]
constexpr double kWayStep = 0.1;    // between the points that measure a way [rad]
constexpr double kFarAway = -1000;  // height at which nothing is [m]

/// Shortens the way of an object that is kept level. Few straight lines between the corners of a
/// tree's path keep it so, but many between points that are nearer to each other. Parts of motions
/// are not tested where check() tests them, so all motions are tested again at the end.
Path shortened(const Path& path, const planning::FreeSpace& space, std::mt19937_64& rng) {
  constexpr int kPasses = 6, kRounds = 100;
  constexpr double kPiece = 0.2;  // [rad]
  const planning::Connect straight = [&](const VectorXd& a, const VectorXd& b) {
    return space.is_motion_free(a, b) ? std::optional(Path{a, b}) : std::nullopt;
  };
  Path shorter = path;
  for (int i = 0; i < kPasses && !space.is_out(); ++i)
    shorter = planning::shortcut(planning::subdivided(shorter, kPiece), straight, kRounds, rng);
  for (std::size_t i = 1; i < shorter.size(); ++i)
    if (!space.is_motion_free(shorter[i - 1], shorter[i])) return path;
  return shorter;
}

robot::Ik without_whole_turns(const Problem& problem) {
  robot::Ik::Options options;
  options.whole_turns = false;  // they touch the same things
  return robot::Ik(problem.robot, problem.robot.frame(problem.frame),
                   problem.robot.group(problem.arm), options);
}

}  // namespace

PlaceSearch::PlaceSearch(const Problem& problem, const Options& options, planning::Clock& clock,
                         std::uint64_t seed)
    : problem_(problem),
      places_(*problem.places),
      options_(options),
      clock_(clock),
      rng_(seed),
      ik_(without_whole_turns(problem)),
      frame_(problem.robot.frame(problem.frame)),
      X_FO_(problem.robot.pose(frame_, problem.q_start).inverse() * problem.object.X_WB),
      up_O_(places_.X_WO.front().linear().transpose() * places_.normal_W),
      scene_(problem.robot),
      object_(scene_.add_object(problem.object.name, problem.object.shapes)),
      hand_(links_with(problem.robot, frame_, ik_.group())) {
  add_obstacles(scene_, object_, problem, options);
  hanging_ = add_hanging(scene_, frame_, hand_, problem);
  space_ = held_space();
  hold(0);
}

void PlaceSearch::run(Plan& plan) {
  if (const auto [a, b] = scene_.collision(problem_.q_start); !a.empty()) {
    plan.status = Status::start_in_collision;
    plan.reason = "at the start, '" + a + "' touches '" + b + "'";
    return;
  }
  std::vector<Putting> without_way;
  std::size_t tried = 0;
  for (; tried < places_.X_WO.size() && without_way.size() < kWithoutWay; ++tried) {
    if (!clock_.spend()) break;
    hold(options_.height);
    std::size_t found = 0;
    for (const VectorXd& q : configurations(places_.X_WO[tried])) {
      hold(options_.height);
      std::optional<Putting> putting = put_at(static_cast<int>(tried), q);
      if (!putting) continue;
      if (const auto direct = way_to(*putting, 0))
        return assemble(in_full(*direct), *putting, plan);
      without_way.push_back(std::move(*putting));
      if (++found == kWaysDown) break;
    }
  }
  for (std::size_t i = 0; i < without_way.size() && !clock_.is_out(); ++i) {
    const int place = without_way[i].place;
    if (i > 0 && place == without_way[i - 1].place) continue;
    if (go_straight(place, plan)) return;
  }
  if (!go_around(without_way, plan)) fail(tried, plan);
}

/// Goes to one of some places by a tree. Of several ways, the one on which the object travels least
/// is taken, unless one is short.
bool PlaceSearch::go_around(const std::vector<Putting>& puttings, Plan& plan) {
  Path best;
  const Putting* to = nullptr;
  double least = std::numeric_limits<double>::infinity();
  const auto look_at = [&](const Path& arm, const Putting& putting) {
    const Path way = in_full(arm);
    const double detour = detour_of(way);
    if (detour >= least) return;
    least = detour;
    best = way;
    to = &putting;
  };
  const auto improve = [&] {
    for (int left = kTrees, i = 0; left > 0 && !clock_.is_out(); ++i) {
      const Putting& putting = puttings[static_cast<std::size_t>(i) % puttings.size()];
      const std::optional<Path> way = way_to(putting, kTreeIterations);
      if (way) {
        look_at(*way, putting);
        look_at(shortened(*way, space_, rng_), putting);
      } else {
        refuse("no way from the start");
      }
      if (least <= kShortWay) return;
      const bool is_round = static_cast<std::size_t>(i) + 1 >= puttings.size();
      if (to) --left;
      if (!to && is_round) return;  // all have used their iterations
    }
  };
  if (!puttings.empty()) clock_.run(improve);
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

/// Fixes the object to the hand. As it hangs, it may be lower than the support by `depth` [m].
void PlaceSearch::hold(double depth) {
  scene_.attach(object_, frame_, X_FO_, hand_);
  if (hanging_ < 0) return;
  const Isometry3d X_WF = problem_.robot.pose(frame_, problem_.q_start);
  scene_.attach(hanging_, frame_, X_WF.inverse() * *problem_.X_WO_hanging, hand_);
  collision::World& world = scene_.world();
  world.allow_contact(hanging_, world.body(places_.on), places_.normal_W, depth);
}

/// Leaves the object where it is at q.
void PlaceSearch::let_stand(const VectorXd& q) {
  scene_.move_object(object_, object_at(q));
  if (hanging_ >= 0) scene_.move_object(hanging_, Isometry3d(Eigen::Translation3d(0, 0, kFarAway)));
}

/// Configurations that hold the object at a pose, the nearest to the start first.
std::vector<VectorXd> PlaceSearch::configurations(const Isometry3d& X_WO) {
  ++statistics_.ik_calls;
  std::vector<VectorXd> found;
  const auto all = ik_.solve_all(X_WO * X_FO_.inverse(), problem_.q_start, rng_);
  if (all.empty()) refuse("out of the arm's reach");
  for (const VectorXd& q : all) {
    poll();
    if (found.size() == kConfigurations) break;
    if (scene_.is_free(q)) {
      found.push_back(q);
    } else {
      refuse(touching(q));
    }
  }
  return found;
}

std::string PlaceSearch::touching(const VectorXd& q) {
  const auto [a, b] = scene_.collision(q);
  return a.empty() ? "joint limits" : "'" + a + "' touches '" + b + "'";
}

/// The way from a place to where the object begins to be lowered, in W [m].
Vector3d PlaceSearch::rise(int place) const {
  const Isometry3d& X_WO = places_.X_WO[static_cast<std::size_t>(place)];
  const Vector3d up =
      places_.down_O.isZero() ? places_.normal_W : Vector3d(-(X_WO.linear() * places_.down_O));
  return up * (options_.height / up.dot(places_.normal_W));
}

/// The motions at a place, from a configuration that holds the object there.
std::optional<PlaceSearch::Putting> PlaceSearch::put_at(int place, const VectorXd& q) {
  std::optional<Path> up = follow(q, line(q, rise(place).normalized(), rise(place).norm()));
  if (!up) {
    refuse("no straight way down");
    return std::nullopt;
  }
  std::reverse(up->begin(), up->end());
  return let_go(place, std::move(*up));
}

/// Opens the hand at the end of the way down, and withdraws it. Leaves the object there.
std::optional<PlaceSearch::Putting> PlaceSearch::let_go(int place, Path lower) {
  const planning::Joints released{ik_.group(), places_.q_open};
  const VectorXd q = lower.back(), opened = released.full(released.part(q));
  if (!is_free(q, opened)) {
    refuse("the hand opens: " + touching(opened));
    return std::nullopt;
  }
  let_stand(q);
  if (!scene_.is_free(opened)) {
    refuse("the open hand: " + touching(opened));
    return std::nullopt;
  }
  std::optional<Path> away = withdrawn(opened);
  if (!away) {
    refuse(places_.way_out.empty() ? "no straight way out for the open hand"
                                   : "the hand cannot leave as it came");
    return std::nullopt;
  }
  return Putting{place, std::move(lower), {q, opened}, std::move(*away)};
}

/// Goes to a place straight and level, and straight down, as far as the inverse kinematics follows
/// from the start.
bool PlaceSearch::go_straight(int place, Plan& plan) {
  hold(0);
  const Isometry3d& X_WO = places_.X_WO[static_cast<std::size_t>(place)];
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

/// Configurations of all joints where the hand is as at the start.
Path PlaceSearch::in_full(const Path& arm) const {
  const planning::Joints joints{ik_.group(), problem_.q_start};
  Path path;
  for (const VectorXd& q : arm) path.push_back(joints.full(q));
  return path;
}

/// A way of the arm from the start to a place, with the object held.
std::optional<Path> PlaceSearch::way_to(const Putting& putting, int iterations) {
  hold(0);
  const planning::Joints joints{ik_.group(), problem_.q_start};
  return planning::find_free_path(space_, joints.part(problem_.q_start),
                                  joints.part(putting.lower.front()), iterations, rng_);
}

void PlaceSearch::assemble(const Path& transfer, const Putting& putting, Plan& plan) const {
  append("transfer", transfer, true, plan);
  append("lower", putting.lower, true, plan);
  append("open", putting.open, false, plan);
  append("retreat", putting.retreat, false, plan);
  plan.status = Status::solved;
  plan.reason.clear();
  plan.place = putting.place;
  plan.reached = 1;
}

Isometry3d PlaceSearch::object_at(const VectorXd& q) const {
  return problem_.robot.pose(frame_, q) * X_FO_;
}

void PlaceSearch::append(const std::string& name, const Path& path, bool held, Plan& plan) const {
  Segment segment{name, planning::subdivided(path, kRowStep, problem_.robot.step_weights()), {}};
  const Isometry3d put =
      plan.segments.empty() ? Isometry3d::Identity() : plan.segments.back().object_poses.back();
  for (const VectorXd& q : segment.positions)
    segment.object_poses.push_back(held ? object_at(q) : put);
  plan.segments.push_back(std::move(segment));
}

void PlaceSearch::fail(std::size_t tried, Plan& plan) const {
  const std::size_t given = places_.X_WO.size();
  plan.reason = tried == 0   ? "no place was tried"
                : given == 1 ? "the object cannot be put down at its place"
                             : "none of the " + std::to_string(tried) + " places tried works";
  plan.reason += planning::obstruction(statistics_.refusals, clock_.ran_out());
  plan.status = clock_.was_interrupted() ? Status::interrupted : Status::no_place;
}

Statistics PlaceSearch::statistics() {
  statistics_.seconds = clock_.seconds();
  statistics_.iterations = clock_.iterations();
  statistics_.collision_checks = scene_.world().num_checks();
  return statistics_;
}

}  // namespace graspless::carry
