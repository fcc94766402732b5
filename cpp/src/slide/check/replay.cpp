// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/check/replay.hpp"

#include <algorithm>
#include <cmath>

#include "slide/contact.hpp"
#include "slide/task/hand_frames.hpp"

namespace graspless::slide {

const std::vector<std::string>& segment_names() {
  static const std::vector<std::string> names = {"retreat", "approach", "press", "slide",
                                                 "lift",    "reach",    "grasp", "close"};
  return names;
}

Contacts contacts_of(const std::string& name) {
  if (name == "close") return Contacts::close;
  const bool presses = name == "retreat" || name == "press" || name == "slide" || name == "lift";
  return presses ? Contacts::press : Contacts::none;
}

Replay::Replay(const Problem& problem, double max_depth)
    : problem_(problem), max_depth_(max_depth), replay_(problem.robot) {
  add_surroundings();
}

Replay Replay::with(Contacts contacts) const {
  Replay copy = *this;
  if (contacts == Contacts::press) copy.allow_press();
  if (contacts == Contacts::close) copy.ignore_fingers();
  return copy;
}

void Replay::add_surroundings() {
  collision::World& world = replay_.world();
  support_ = replay_.add("support", problem_.support.solid(), true);
  world.set_pose(support_, problem_.support.X_WS());
  object_ = replay_.add("object", problem_.object.solid(), false);
  for (const Obstacle& obstacle : problem_.obstacles) {
    world.add_pair(object_, replay_.add(obstacle));
  }
}

void Replay::raise_support(double rise) {
  const Support& support = problem_.support;
  const Eigen::Translation3d raised(rise * support.normal_W());
  replay_.world().set_pose(support_, raised * support.X_WS());
}

void Replay::allow_press() {
  constexpr double kRoundOff = 1e-4;
  constexpr double kColumns = 0.006;  // by which columns may be higher than the face [m]
  const double deepest = max_depth_ + allowed_sink(problem_.hand) + kHeightTolerance + kRoundOff +
                         (problem_.object.heights() ? kColumns : 0);
  const Eigen::Vector3d normal_W = problem_.support.normal_W();
  for (const std::string& link : problem_.hand.sliding_finger) {
    const int body = replay_.body_of(link);
    if (body < 0) continue;
    replay_.world().allow_contact(body, object_, normal_W, deepest);
    replay_.world().allow_contact(body, support_, normal_W,
                                  std::max(0.0, deepest - problem_.object.top()));
  }
}

void Replay::ignore_fingers() {
  for (const std::string& link : problem_.hand.fingers) {
    if (replay_.body_of(link) >= 0) replay_.world().remove_pair(replay_.body_of(link), object_);
  }
}

std::vector<std::string> Replay::touching(const Eigen::VectorXd& q, const Eigen::Isometry3d& X_WO) {
  replay_.world().set_pose(object_, X_WO);
  return replay_.touching(q);
}

}  // namespace graspless::slide
