// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/free_space/object_collision.hpp"

#include <algorithm>

namespace graspless::clasp {
namespace {

// Spheres do not decide cases closer to contact than this [m]. FCL does.
constexpr double kContactMargin = 2e-6;

std::vector<std::vector<geometry::PlacedShape>> shapes_of_links(const robot::Robot& robot) {
  std::vector<std::vector<geometry::PlacedShape>> shapes(robot.frame_names().size());
  for (const robot::LinkShape& shape : robot.shapes()) {
    shapes[shape.link].push_back(shape.placed);
  }
  return shapes;
}

}  // namespace

double distance_by_spheres(const SphereTree& tree, const Eigen::Isometry3d& X_OL, double enough,
                           collision::Clearance& clearance) {
  const int count = static_cast<int>(tree.size());
  double least = enough + kContactMargin;
  for (int i = 0; i < count;) {
    const LinkSphere& node = tree[i];
    const bool is_leaf = node.next == i + 1;
    const Eigen::Vector3d p_O = X_OL * node.p_L;
    const auto distance = is_leaf ? clearance.bounds(p_O, node.outer + kContactMargin)
                                  : clearance.rough_bounds(p_O, node.outer + least);
    const double clear = distance.lower - node.outer;
    if (is_leaf && clear <= kContactMargin) return 0;
    if (is_leaf) least = std::min(least, clear);
    i = clear >= least ? node.next : i + 1;
  }
  return least - kContactMargin;
}

ObjectCollision::ObjectCollision(const Problem& problem)
    : X_OW_(problem.X_WO.inverse()),
      spheres_(link_spheres(problem.robot)),
      clearance_(problem.object.clearance()) {
  const robot::Robot& robot = problem.robot;
  const int object = world_.add_body("object", problem.object.solid());
  world_.set_pose(object, problem.X_WO);
  for (const auto& shapes : shapes_of_links(robot)) {
    const int link = static_cast<int>(body_.size());
    body_.push_back(-1);
    pair_.push_back(-1);
    if (shapes.empty()) continue;
    body_.back() = world_.add_body("link " + robot.frame_names()[link], shapes);
    pair_.back() = world_.num_pairs();
    world_.add_pair(body_.back(), object);
    links_.push_back(link);
  }
  std::reverse(links_.begin(), links_.end());  // the hand first, because it is most likely to touch
}

bool ObjectCollision::touches_by_fcl(int link, const Eigen::Isometry3d& X_WL) {
  ++fcl_checks_;
  const auto index = static_cast<std::size_t>(link);
  world_.set_pose(body_[index], X_WL);
  return world_.touches(pair_[index]);
}

ObjectCollision::Result ObjectCollision::check(int link, const Eigen::Isometry3d& X_WL,
                                               double enough) {
  const SphereTree& tree = spheres_[link];
  const Eigen::Isometry3d X_OL = X_OW_ * X_WL;
  const int count = static_cast<int>(tree.size());
  double least = std::max(enough, 2 * kContactMargin);
  for (int i = 0; i < count;) {
    const LinkSphere& node = tree[i];
    const bool is_leaf = node.next == i + 1;
    const Eigen::Vector3d p_O = X_OL * node.p_L;
    const auto distance = is_leaf ? clearance_.bounds(p_O, node.outer + kContactMargin)
                                  : clearance_.rough_bounds(p_O, node.outer + least);
    if (distance.upper < node.inner - kContactMargin) return {true, 0};
    const double clear = distance.lower - node.outer;
    if (clear >= least) {
      i = node.next;
    } else if (is_leaf) {
      least = clear;
      i = node.next;
    } else {
      ++i;
    }
  }
  if (least <= kContactMargin && touches_by_fcl(link, X_WL)) return {true, 0};
  return {false, std::max(0.0, least)};
}

}  // namespace graspless::clasp
