// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "carry/place_search.hpp"

#include <algorithm>
#include <cmath>

#include "graspless/planning/free_path.hpp"
#include "graspless/watch.hpp"

#include "carry/search.hpp"
#include "carry/straight_path.hpp"
#include "planning/joints.hpp"
#include "planning/obstruction.hpp"
#include "scene/rows.hpp"

namespace graspless::carry {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;
using planning::Path;

constexpr std::size_t kConfigurations = 6;  // of the arm, for each place
constexpr std::size_t kWaysDown = 3;        // of these, from which the object is lowered
constexpr std::size_t kWithoutWay = 12;     // such configurations to which trees are grown
constexpr double kFarAway = -1000;          // height at which nothing is [m]

}  // namespace

PlaceSearch::PlaceSearch(const Problem& problem, const Options& options, planning::Clock& clock,
                         std::uint64_t seed)
    : problem_(problem),
      places_(*problem.places),
      options_(options),
      clock_(clock),
      rng_(seed),
      ik_(make_ik(problem, options, false)),  // whole turns touch the same things
      frame_(problem.robot.frame(problem.frame)),
      X_FO_(problem.robot.pose(frame_, problem.q_start).inverse() * problem.object.X_WB),
      up_O_(places_.X_WO.front().linear().transpose() * places_.normal_W),
      scene_(problem.robot),
      object_(scene_.add_object(problem.object.name, problem.object.shapes)),
      hand_(links_with(problem.robot, frame_, ik_.group())) {
  add_obstacles(scene_, object_, problem, options);
  hanging_ = add_hanging(scene_, frame_, hand_, problem);
  hold(0);
}

void PlaceSearch::run(Plan& plan) {
  if (const auto [a, b] = scene_.collision(problem_.q_start); !a.empty()) {
    plan.status = Status::start_in_collision;
    plan.reason = "at the start, " + planning::contact(a, b);
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
      if (const auto direct = way_to(*putting, 0)) return assemble(*direct, *putting, plan);
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
  if (all.empty()) refuse(may_lean(problem_) ? kNotTurned : "out of the arm's reach");
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
  const Isometry3d& X_WO = places_.X_WO[place];
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
  Segment segment{
      name, planning::subdivided(path, scene::kRowStep, problem_.robot.step_weights()), {}};
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
