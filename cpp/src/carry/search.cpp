// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "carry/search.hpp"

#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

#include "scene/rows.hpp"

namespace graspless::carry {
namespace {

using Eigen::VectorXd;

constexpr double kJump =
    0.25;  // [rad]; a larger joint step has left the branch of inverse kinematics
constexpr double kTurnStep = 0.03;   // turn of the object between checked poses [rad]
constexpr double kFreeStep = 0.04;   // of the free joint [rad]
constexpr double kTwistStep = 0.02;  // [rad]

}  // namespace

std::vector<int> links_with(const robot::Robot& robot, int frame, const std::vector<int>& arm) {
  VectorXd q = robot.clamp(VectorXd::Zero(robot.dof()));
  robot::Poses here, there;
  robot.forward(q, here);
  double moved = 0.1;  // any values that differ between joints
  for (const int joint : arm) q[joint] += moved += 0.013;
  robot.forward(q, there);
  std::vector<int> links;
  const auto f = static_cast<std::size_t>(frame);
  for (std::size_t link = 0; link < here.size(); ++link) {
    const Eigen::Isometry3d now = here[f].inverse() * here[link];
    const Eigen::Isometry3d then = there[f].inverse() * there[link];
    if (now.isApprox(then, 1e-9)) links.push_back(static_cast<int>(link));
  }
  return links;
}

robot::Ik make_ik(const Problem& problem, const Options& options, bool whole_turns) {
  const std::vector<int>& joints = problem.robot.group(problem.arm);
  robot::Ik::Options chosen;
  if (may_lean(problem)) {
    chosen.tolerance = options.tolerance / 10;
    chosen.lean = std::min(options.angle_tolerance / 2, robot::Ik::kMostLean);
  }
  chosen.whole_turns = whole_turns;
  return robot::Ik(problem.robot, problem.robot.frame(problem.frame), joints, chosen);
}

void add_obstacles(scene::Scene& scene, int object, const Problem& problem,
                   const Options& options) {
  for (const Obstacle& obstacle : problem.obstacles) {
    const int body = scene.add_obstacle(obstacle.label(), obstacle.solid(), obstacle.X_WB);
    scene.world().add_pair(object, body);
    for (const Rest& rest : problem.rests_on) {
      if (rest.obstacle != obstacle.name) continue;
      scene.world().allow_contact(object, body, rest.normal_W, options.contact_depth);
    }
    if (problem.places && problem.places->on == obstacle.name)
      scene.world().allow_contact(object, body, problem.places->normal_W, options.contact_depth);
  }
}

int add_hanging(scene::Scene& scene, int frame, const std::vector<int>& hand,
                const Problem& problem) {
  if (!problem.X_WO_hanging) return -1;
  const int body = scene.add_object(problem.object.name + " hanging", problem.object.shapes);
  for (const Obstacle& obstacle : problem.obstacles)
    scene.world().add_pair(body, scene.world().body(obstacle.label()));
  const Eigen::Isometry3d X_WF = problem.robot.pose(frame, problem.q_start);
  scene.attach(body, frame, X_WF.inverse() * *problem.X_WO_hanging, hand);
  return body;
}

Search::Search(const Problem& problem, const Options& options, planning::Clock& clock)
    : problem_(problem),
      options_(options),
      clock_(clock),
      object_path_(problem.object.X_WB, problem.X_WO_goal),
      ik_(make_ik(problem, options, true)),
      frame_(problem.robot.frame(problem.frame)),
      X_FO_(problem.robot.pose(frame_, problem.q_start).inverse() * problem.object.X_WB),
      scene_(problem.robot),
      steps_(std::max({1, static_cast<int>(std::ceil(object_path_.distance() / options.step)),
                       static_cast<int>(std::ceil(object_path_.angle() / kTurnStep))})) {
  const int object = scene_.add_object(problem.object.name, problem.object.shapes);
  add_obstacles(scene_, object, problem, options);
  const std::vector<int> hand = links_with(problem.robot, frame_, ik_.group());
  scene_.attach(object, frame_, X_FO_, hand);
  const int hanging = add_hanging(scene_, frame_, hand, problem);
  if (hanging >= 0) ignore_touched(hanging);
}

/// Stops testing a body against what it touches at the start.
void Search::ignore_touched(int body) {
  scene_.collision(problem_.q_start);  // places everything
  for (const auto& [a, b] : scene_.world().all_collisions())
    if (a == body || b == body) scene_.world().remove_pair(a, b);
}

std::pair<std::string, std::string> Search::touching_at_start() {
  return scene_.collision(problem_.q_start);
}

Eigen::Isometry3d Search::object_at(const VectorXd& q) const {
  return problem_.robot.pose(frame_, q) * X_FO_;
}

std::vector<VectorXd> Search::run() {
  nodes_ = {{{0, 0, 0}, problem_.q_start, -1}};
  visited_ = {nodes_[0].cell};
  std::vector<std::pair<int, Cell>> open;  // a stack: which node to extend, and to which cell
  const auto open_neighbours = [&](int node) {
    std::vector<Cell> next = neighbours(nodes_[node].cell);
    for (auto cell = next.rbegin(); cell != next.rend(); ++cell) open.emplace_back(node, *cell);
  };
  open_neighbours(0);
  while (!open.empty()) {
    const auto [parent, cell] = open.back();
    open.pop_back();
    if (visited_.count(cell) != 0) continue;
    if (!clock_.spend()) break;
    const std::optional<VectorXd> q = step(nodes_[parent], cell);
    if (!q) continue;
    visited_.insert(cell);
    nodes_.push_back({cell, *q, parent});
    farthest_ = std::max(farthest_, cell[0]);
    const int node = static_cast<int>(nodes_.size()) - 1;
    if (cell[0] == steps_) return path_to(node);
    open_neighbours(node);
  }
  return {};
}

/// Neighbouring cells, best first: straight ahead, ahead and sideways, sideways only.
std::vector<Search::Cell> Search::neighbours(const Cell& cell) const {
  std::vector<std::array<int, 2>> sideways;
  if (ik_.free_joint()) sideways.insert(sideways.end(), {{1, 0}, {-1, 0}});
  if (options_.max_twist > 0) sideways.insert(sideways.end(), {{0, 1}, {0, -1}});
  std::vector<Cell> found{{cell[0] + 1, cell[1], cell[2]}};
  for (const int ahead : {1, 0}) {
    for (const auto& [free, twist] : sideways) {
      const Cell next{cell[0] + ahead, cell[1] + free, cell[2] + twist};
      if (std::abs(next[2]) * kTwistStep <= options_.max_twist) found.push_back(next);
    }
  }
  return found;
}

std::optional<VectorXd> Search::step(const Node& from, const Cell& to) {
  const std::optional<VectorXd> q = solve(to, from.q);
  if (!q) {
    refuse(may_lean(problem_) ? kNotTurned : "out of the arm's reach or limits");
    return std::nullopt;
  }
  if ((*q - from.q).lpNorm<Eigen::Infinity>() > kJump) {
    refuse("jump of the joints");
    return std::nullopt;
  }
  if (!is_motion_valid(from.q, *q)) return std::nullopt;
  return q;
}

std::optional<VectorXd> Search::solve(const Cell& to, const VectorXd& near) {
  ++statistics_.ik_calls;
  const double s = static_cast<double>(to[0]) / steps_;
  const Eigen::Isometry3d X_WF = object_path_.pose(s, to[2] * kTwistStep) * X_FO_.inverse();
  if (!ik_.is_closed_form()) return ik_.solve_near(X_WF, near);
  double value = 0;
  if (const std::optional<int> joint = ik_.free_joint()) {
    value = problem_.q_start[*joint] + to[1] * kFreeStep;
    if (value < problem_.robot.lower()[*joint] || value > problem_.robot.upper()[*joint])
      return std::nullopt;
  }
  std::vector<VectorXd> solutions;
  ik_.solve_free(X_WF, value, near, solutions);
  const auto distance = [&](const VectorXd& q) { return (q - near).lpNorm<Eigen::Infinity>(); };
  const auto nearest =
      std::min_element(solutions.begin(), solutions.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (nearest == solutions.end()) return std::nullopt;
  return *nearest;
}

/// Checks exactly the configurations at which check() will replay the rows.
bool Search::is_motion_valid(const VectorXd& from, const VectorXd& to) {
  const int pieces = scene::replay_steps(problem_.robot.step(from, to), options_.resolution);
  for (int i = 1; i <= pieces; ++i) {
    poll();
    if (object_path_.contains(object_at(from + (to - from) * i / pieces), options_)) continue;
    refuse("off the straight path");
    return false;
  }
  if (scene_.is_free(from, to, scene::replay_step(problem_.robot, from, to, options_.resolution)))
    return true;
  const auto [a, b] = scene_.collision(to);
  refuse(a.empty() ? "collision" : "'" + a + "' touches '" + b + "'");
  return false;
}

std::vector<VectorXd> Search::path_to(int node) const {
  std::vector<VectorXd> path;
  for (int at = node; at >= 0; at = nodes_[at].parent) path.push_back(nodes_[at].q);
  std::reverse(path.begin(), path.end());
  return path;
}

Statistics Search::statistics() {
  statistics_.seconds = clock_.seconds();
  statistics_.iterations = clock_.iterations();
  statistics_.collision_checks = scene_.world().num_checks();
  return statistics_;
}

}  // namespace graspless::carry
