// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "graspless/carry/carry.hpp"
#include "graspless/geometry/pose.hpp"
#include "graspless/robot/ik.hpp"

#include "scene/names.hpp"
#include "text.hpp"

namespace graspless::carry {
namespace {

void check_bodies(const Problem& problem) {
  std::set<std::string> taken = scene::taken_names(problem.robot, {});
  std::vector<Obstacle> bodies{problem.object};
  try {
    collision::require_obstacles(bodies, taken, "a link of the robot");
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("object" + std::string(error.what()).substr(12));  // obstacles[0]
  }
  if (problem.object.padding != 0) {
    throw std::invalid_argument("object.padding must be 0, not " + figure(problem.object.padding) +
                                "; give the obstacles a padding instead");
  }
  taken.insert(problem.object.name);
  collision::require_obstacles(problem.obstacles, taken, "a link, another obstacle or the object");
}

void check_rest(const Problem& problem, const Rest& rest, const std::string& field) {
  const auto is_it = [&](const Obstacle& obstacle) { return obstacle.name == rest.obstacle; };
  const auto found = std::find_if(problem.obstacles.begin(), problem.obstacles.end(), is_it);
  if (found == problem.obstacles.end()) {
    std::string names;
    for (const Obstacle& obstacle : problem.obstacles)
      names += (names.empty() ? "" : ", ") + obstacle.name;
    throw std::invalid_argument(field + ": there is no obstacle '" + rest.obstacle +
                                "' (one of: " + names + ")");
  }
  const Obstacle& under = *found;
  if (under.padding != 0)
    throw std::invalid_argument(field + ": the object stands on '" + under.name +
                                "', which must have no padding, not " + figure(under.padding));
  const double length = rest.normal_W.norm();
  if (!std::isfinite(length) || std::abs(length - 1) > 1e-6)
    throw std::invalid_argument(field + ": normal_W must have unit length, not " + figure(length));
}

void check_rests(const Problem& problem) {
  for (std::size_t i = 0; i < problem.rests_on.size(); ++i)
    check_rest(problem, problem.rests_on[i], "rests_on[" + std::to_string(i) + "]");
}

void check_places(const Problem& problem) {
  const Places& places = *problem.places;
  if (places.X_WO.empty()) throw std::invalid_argument("places.X_WO: must have at least one pose");
  for (std::size_t i = 0; i < places.X_WO.size(); ++i)
    geometry::require_pose(places.X_WO[i], "places.X_WO[" + std::to_string(i) + "]");
  check_rest(problem, {places.on, places.normal_W}, "places.on");
  robot::require_configuration(problem.robot, places.q_open, "places.q_open");
  for (std::size_t i = 0; i < places.way_out.size(); ++i)
    robot::require_configuration(problem.robot, places.way_out[i],
                                 "places.way_out[" + std::to_string(i) + "]");
  for (std::size_t i = 0; i < places.X_WO.size() && !places.down_O.isZero(); ++i) {
    const double along = (places.X_WO[i].linear() * places.down_O).dot(places.normal_W);
    if (!(along < -0.1 * places.down_O.norm()))
      throw std::invalid_argument("places.down_O: must lead down onto '" + places.on +
                                  "' at places.X_WO[" + std::to_string(i) +
                                  "], at least 6 degrees steep");
  }
  const Eigen::Vector3d up_O = places.X_WO[0].linear().transpose() * places.normal_W;
  for (std::size_t i = 1; i < places.X_WO.size(); ++i) {
    if ((places.X_WO[i].linear() * up_O - places.normal_W).norm() < 1e-6) continue;
    throw std::invalid_argument("places.X_WO[" + std::to_string(i) +
                                "]: must stand on the same side of the object as places.X_WO[0]");
  }
}

void check_goal(const Problem& problem) {
  geometry::require_pose(problem.X_WO_goal, "X_WO_goal");
  const Eigen::Isometry3d X = problem.object.X_WB.inverse() * problem.X_WO_goal;
  if (X.translation().norm() > 1e-6 || Eigen::AngleAxisd(X.linear()).angle() > 1e-6) return;
  throw std::invalid_argument(
      "X_WO_goal must differ from the object's pose object.X_WB: there is no path to follow");
}

}  // namespace

void validate(const Problem& problem) {
  const std::vector<int>& arm = problem.robot.group(problem.arm);
  const robot::Ik ik(problem.robot, problem.robot.frame(problem.frame), arm);  // throws otherwise
  robot::require_configuration(problem.robot, problem.q_start, "q_start");
  check_bodies(problem);
  check_rests(problem);
  if (problem.X_WO_hanging) geometry::require_pose(*problem.X_WO_hanging, "X_WO_hanging");
  if (problem.places) {
    check_places(problem);
  } else {
    check_goal(problem);
  }
}

void validate(const Options& options) { planning::require_in_range("options.", options); }

std::string to_string(Status status) { return planning::name_of(status); }

}  // namespace graspless::carry
