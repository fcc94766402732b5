// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/replay.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::slide {
namespace {

/// Links rigid with the root: they may stand on or against what the robot is mounted on.
bool is_base(const robot::Robot& robot, int link) {
  const Eigen::VectorXd& reach = robot.reach(link);
  return reach.size() == 0 || reach.maxCoeff() == 0;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

double finger_below_tip(const Problem& problem, const Options& options) {
  const robot::Robot& robot = problem.robot;
  const Eigen::VectorXd& q = robot.state(problem.hand.open);
  const Eigen::Isometry3d X_FW = robot.pose(robot.frame(problem.hand.fingertip), q).inverse();
  constexpr int kSamples = 9;
  double below = 0;
  for (const robot::LinkShape& shape : robot.shapes()) {
    if (!contains(problem.hand.sliding_finger,
                  robot.frame_names()[static_cast<std::size_t>(shape.link)])) {
      continue;
    }
    geometry::PlacedShape in_F = shape.placed;
    in_F.X_BG = X_FW * robot.pose(shape.link, q) * shape.placed.X_BG;
    for (int i = 0; i < kSamples; ++i) {
      const double pitch = options.pitch + options.pitch_tolerance * (2.0 * i / (kSamples - 1) - 1);
      below = std::max(below, geometry::extent(in_F, {0, -std::cos(pitch), std::sin(pitch)}));
    }
  }
  return below;
}

Replay::Replay(const Problem& problem, const Options& options, Contacts contacts)
    : problem_(problem) {
  add_links();
  add_surroundings();
  if (contacts == Contacts::press) allow_press(options);
  if (contacts == Contacts::close) ignore_fingers();
}

void Replay::add_links() {
  const robot::Robot& robot = problem_.robot;
  std::vector<std::vector<geometry::PlacedShape>> shapes(robot.frame_names().size());
  for (const auto& shape : robot.shapes()) {
    shapes[static_cast<std::size_t>(shape.link)].push_back(shape.placed);
  }
  for (int link = 0; link < static_cast<int>(shapes.size()); ++link) {
    if (shapes[static_cast<std::size_t>(link)].empty()) continue;
    const int body = world_.add_body(robot.frame_names()[static_cast<std::size_t>(link)],
                                     shapes[static_cast<std::size_t>(link)]);
    for (int other = 0; other < body; ++other) {
      const int a = std::min(link, link_of_body_[static_cast<std::size_t>(other)]);
      const int b = std::max(link, link_of_body_[static_cast<std::size_t>(other)]);
      if (robot.ignored_pairs().count({a, b}) == 0) world_.add_pair(other, body);
    }
    link_of_body_.push_back(link);
  }
}

void Replay::add_surroundings() {
  const auto num_links = static_cast<int>(link_of_body_.size());
  const auto add = [&](const std::string& name, const auto& shapes, bool carries_base) {
    const int body = world_.add_body(name, shapes);
    for (int link = 0; link < num_links; ++link) {
      if (carries_base && is_base(problem_.robot, link_of_body_[static_cast<std::size_t>(link)]))
        continue;
      world_.add_pair(link, body);
    }
    return body;
  };
  support_ = add("support", problem_.support.shapes(), true);
  world_.set_pose(support_, problem_.support.X_WS());
  object_ = add("object", problem_.object.shapes(), false);
  for (const Obstacle& obstacle : problem_.obstacles) {
    const int body = add(obstacle.name, obstacle.shapes, true);
    world_.set_pose(body, obstacle.X_WB);
    world_.add_pair(object_, body);
  }
}

void Replay::allow_press(const Options& options) {
  constexpr double kRoundOff = 1e-4;
  const double deepest = options.max_depth + finger_below_tip(problem_, options) +
                         options.height_tolerance + kRoundOff;
  const Eigen::Vector3d normal_W = problem_.support.normal_W();
  for (const std::string& link : problem_.hand.sliding_finger) {
    const int body = body_of(link);
    if (body < 0) continue;
    world_.allow_contact(body, object_, normal_W, deepest);
    world_.allow_contact(body, support_, normal_W,
                         std::max(0.0, deepest - problem_.object.thickness()));
  }
}

void Replay::ignore_fingers() {
  for (const std::string& link : problem_.hand.fingers) {
    if (body_of(link) >= 0) world_.remove_pair(body_of(link), object_);
  }
}

/// -1 for a link without shapes.
int Replay::body_of(const std::string& link) const {
  const int frame = problem_.robot.frame(link);
  const auto found = std::find(link_of_body_.begin(), link_of_body_.end(), frame);
  return found == link_of_body_.end() ? -1 : static_cast<int>(found - link_of_body_.begin());
}

std::vector<std::string> Replay::touching(const Eigen::VectorXd& q, const Eigen::Isometry3d& X_WO) {
  robot::Poses X_WL;
  problem_.robot.forward(q, X_WL);
  for (std::size_t body = 0; body < link_of_body_.size(); ++body) {
    world_.set_pose(static_cast<int>(body), X_WL[static_cast<std::size_t>(link_of_body_[body])]);
  }
  world_.set_pose(object_, X_WO);
  std::vector<std::string> names;
  for (const auto& [a, b] : world_.all_collisions())
    names.push_back(world_.name(a) + " - " + world_.name(b));
  return names;
}

}  // namespace graspless::slide
