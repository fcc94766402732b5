// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "carry/search.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::carry {
namespace {

using Eigen::VectorXd;

constexpr double kRowStep = 0.05;    // largest joint step between rows of a plan [rad]
constexpr double kJump = 0.25;       // [rad]; a larger one has left the branch
constexpr double kTurnStep = 0.03;   // of the object, between poses looked at [rad]
constexpr double kFreeStep = 0.04;   // of the free joint [rad]
constexpr double kTwistStep = 0.02;  // [rad]
constexpr int kFree = 2;             // which joint of the arm is free in the closed form

}  // namespace

std::vector<int> links_with(const robot::Robot& robot, int frame, const std::vector<int>& arm) {
  VectorXd q = robot.clamp(VectorXd::Zero(robot.dof()));
  robot::Poses here, there;
  robot.forward(q, here);
  double moved = 0.1;  // any values will do that no joint shares
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

Search::Search(const Problem& problem, const Options& options, planning::Clock& clock)
    : problem_(problem),
      options_(options),
      clock_(clock),
      way_(problem.object.X_WB, problem.X_WO_goal),
      ik_(problem.robot, problem.robot.frame(problem.frame), problem.robot.group(problem.arm)),
      frame_(problem.robot.frame(problem.frame)),
      X_FO_(problem.robot.pose(frame_, problem.q_start).inverse() * problem.object.X_WB),
      scene_(problem.robot),
      layers_(std::max({1, static_cast<int>(std::ceil(way_.distance() / options.step)),
                        static_cast<int>(std::ceil(way_.angle() / kTurnStep))})) {
  const int object = scene_.add_object(problem.object.name, problem.object.shapes);
  for (const Obstacle& obstacle : problem.obstacles) {
    const int body = scene_.add_obstacle(obstacle.name, obstacle.shapes, obstacle.X_WB);
    scene_.world().add_pair(object, body);
    for (const Rest& rest : problem.rests_on) {
      if (rest.obstacle != obstacle.name) continue;
      scene_.world().allow_contact(object, body, rest.normal_W, options.contact_depth);
    }
  }
  scene_.attach(object, frame_, X_FO_, links_with(problem.robot, frame_, ik_.group()));
}

std::pair<std::string, std::string> Search::touching_at_start() {
  return scene_.collision(problem_.q_start);
}

Eigen::Isometry3d Search::object_at(const VectorXd& q) const {
  return problem_.robot.pose(frame_, q) * X_FO_;
}

std::vector<VectorXd> Search::run() {
  nodes_ = {{{0, 0, 0}, problem_.q_start, -1}};
  known_ = {nodes_[0].place};
  std::vector<std::pair<int, Place>> open;  // from which node to which place; the last one first
  const auto go_on_from = [&](int node) {
    std::vector<Place> next = neighbours(nodes_[static_cast<std::size_t>(node)].place);
    for (auto place = next.rbegin(); place != next.rend(); ++place) open.emplace_back(node, *place);
  };
  go_on_from(0);
  while (!open.empty()) {
    const auto [parent, place] = open.back();
    open.pop_back();
    if (known_.count(place) != 0) continue;
    if (!clock_.spend()) break;
    const std::optional<VectorXd> q = step(nodes_[static_cast<std::size_t>(parent)], place);
    if (!q) continue;
    known_.insert(place);
    nodes_.push_back({place, *q, parent});
    farthest_ = std::max(farthest_, place[0]);
    const int node = static_cast<int>(nodes_.size()) - 1;
    if (place[0] == layers_) return way_to(node);
    go_on_from(node);
  }
  return {};
}

/// Straight ahead, then ahead and aside, then aside on the spot.
std::vector<Search::Place> Search::neighbours(const Place& place) const {
  std::vector<std::array<int, 2>> aside;
  if (has_free_joint()) aside.insert(aside.end(), {{1, 0}, {-1, 0}});
  if (options_.max_twist > 0) aside.insert(aside.end(), {{0, 1}, {0, -1}});
  std::vector<Place> found{{place[0] + 1, place[1], place[2]}};
  for (const int ahead : {1, 0}) {
    for (const auto& [free, twist] : aside) {
      const Place next{place[0] + ahead, place[1] + free, place[2] + twist};
      if (std::abs(next[2]) * kTwistStep <= options_.max_twist) found.push_back(next);
    }
  }
  return found;
}

std::optional<VectorXd> Search::step(const Node& from, const Place& to) {
  const std::optional<VectorXd> q = solve(to, from.q);
  if (!q) {
    refuse("out of the arm's reach or limits");
    return std::nullopt;
  }
  if ((*q - from.q).lpNorm<Eigen::Infinity>() > kJump) {
    refuse("jump of the joints");
    return std::nullopt;
  }
  if (!is_motion_good(from.q, *q)) return std::nullopt;
  return q;
}

std::optional<VectorXd> Search::solve(const Place& to, const VectorXd& near) {
  ++statistics_.ik_calls;
  const double s = static_cast<double>(to[0]) / layers_;
  const Eigen::Isometry3d X_WF = way_.pose(s, to[2] * kTwistStep) * X_FO_.inverse();
  if (!has_free_joint()) return ik_.solve_near(X_WF, near);
  const int joint = ik_.group()[kFree];
  const double value = problem_.q_start[joint] + to[1] * kFreeStep;
  if (value < problem_.robot.lower()[joint] || value > problem_.robot.upper()[joint])
    return std::nullopt;
  std::vector<VectorXd> solutions;
  ik_.solve_free(X_WF, value, near, solutions);
  const auto distance = [&](const VectorXd& q) { return (q - near).lpNorm<Eigen::Infinity>(); };
  const auto nearest =
      std::min_element(solutions.begin(), solutions.end(),
                       [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  if (nearest == solutions.end()) return std::nullopt;
  return *nearest;
}

/// Looks at the very configurations at which a replay of the rows will look.
bool Search::is_motion_good(const VectorXd& from, const VectorXd& to) {
  const double span = (to - from).lpNorm<Eigen::Infinity>();
  const int rows = std::max(1, static_cast<int>(std::ceil(span / kRowStep)));
  const int pieces =
      rows * std::max(1, static_cast<int>(std::ceil(span / rows / options_.resolution)));
  for (int i = 1; i <= pieces; ++i) {
    if (way_.holds(object_at(from + (to - from) * i / pieces), options_)) continue;
    refuse("off the straight way");
    return false;
  }
  if (scene_.is_free(from, to, span / pieces * (1 + 1e-12) + 1e-15)) return true;
  const auto [a, b] = scene_.collision(to);
  refuse(a.empty() ? "collision" : "'" + a + "' touches '" + b + "'");
  return false;
}

std::vector<VectorXd> Search::way_to(int node) const {
  std::vector<VectorXd> path;
  for (int at = node; at >= 0; at = nodes_[static_cast<std::size_t>(at)].parent)
    path.push_back(nodes_[static_cast<std::size_t>(at)].q);
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
