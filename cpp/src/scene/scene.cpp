// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/scene/scene.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "once.hpp"
#include "scene/motion.hpp"

namespace graspless::scene {
namespace {

using geometry::PlacedShape;

bool is_rigid_with_root(const robot::Robot& robot, int link) { return robot.reach(link).isZero(0); }

using LinkSolids = std::map<int, collision::Solid>;

LinkSolids make_link_solids(const robot::Robot& robot) {
  std::map<int, std::vector<PlacedShape>> shapes;
  for (const robot::LinkShape& shape : robot.shapes()) shapes[shape.link].push_back(shape.placed);
  LinkSolids solids;
  for (const auto& [link, placed] : shapes) {
    solids.emplace(link, collision::Solid(placed, "link '" + robot.frame_names()[link] + "'"));
  }
  return solids;
}

/// Returns the solids of a robot's links. They are cached while any copy of the robot lives,
/// because planners build a scene for every query.
std::shared_ptr<const LinkSolids> link_solids(const robot::Robot& robot) {
  using Owner = std::weak_ptr<const void>;
  static PolledMutex mutex;
  static std::map<Owner, std::shared_ptr<const LinkSolids>, std::owner_less<Owner>> known;
  const std::lock_guard lock(mutex);
  for (auto it = known.begin(); it != known.end();)
    it = it->first.expired() ? known.erase(it) : ++it;
  auto& solids = known[robot.identity()];
  if (!solids) solids = std::make_shared<const LinkSolids>(make_link_solids(robot));
  return solids;
}

void require_link(const robot::Robot& robot, int link, const char* what) {
  const auto count = static_cast<int>(robot.frame_names().size());
  if (link >= 0 && link < count) return;
  throw std::invalid_argument(std::string(what) + " must be the index of one of the " +
                              std::to_string(count) + " links, not " + std::to_string(link));
}

}  // namespace

Scene::Scene(const robot::Robot& robot)
    : robot_(robot), link_body_(robot.frame_names().size(), -1) {
  robot_.forward(robot_.clamp(Eigen::VectorXd::Zero(robot_.dof())), X_WL_);
  const auto solids = link_solids(robot_);
  std::vector<int> links;
  for (int link = 0; link < static_cast<int>(link_body_.size()); ++link) {
    const auto solid = solids->find(link);
    if (solid == solids->end()) continue;
    link_body_[link] = world_.add_body(robot_.frame_names()[link], solid->second);
    world_.set_pose(link_body_[link], X_WL_[link]);
    for (const int other : links) {
      if (robot_.ignored_pairs().count({other, link}) == 0) {
        world_.add_pair(link_body_[other], link_body_[link]);
      }
    }
    links.push_back(link);
    if (!is_rigid_with_root(robot_, link)) moving_links_.push_back(link);
  }
}

int Scene::add_obstacle(const std::string& name, const std::vector<PlacedShape>& shapes,
                        const Eigen::Isometry3d& X_WB, bool touches_base) {
  return add_obstacle(name, collision::Solid(shapes, "body '" + name + "'"), X_WB, touches_base);
}

int Scene::add_obstacle(const std::string& name, const collision::Solid& solid,
                        const Eigen::Isometry3d& X_WB, bool touches_base) {
  const int body = world_.add_body(name, solid);
  world_.set_pose(body, X_WB);
  for (int link = 0; link < static_cast<int>(link_body_.size()); ++link) {
    if (link_body_[link] < 0 || (touches_base && is_rigid_with_root(robot_, link))) continue;
    world_.add_pair(link_body_[link], body);
  }
  return body;
}

int Scene::add_object(const std::string& name, const std::vector<PlacedShape>& shapes) {
  return add_obstacle(name, shapes, Eigen::Isometry3d::Identity(), false);
}

int Scene::add_object(const std::string& name, const collision::Solid& solid) {
  return add_obstacle(name, solid, Eigen::Isometry3d::Identity(), false);
}

void Scene::move_object(int body, const Eigen::Isometry3d& X_WO) {
  detach(body);
  world_.set_pose(body, X_WO);
}

void Scene::attach(int body, int link, const Eigen::Isometry3d& X_LO,
                   const std::vector<int>& touching) {
  require_link(robot_, link, "link");
  for (const int other : touching) require_link(robot_, other, "touching");
  const std::string& name = world_.name(body);
  if (std::find(link_body_.begin(), link_body_.end(), body) != link_body_.end()) {
    throw std::invalid_argument("body '" + name +
                                "' is a link of the robot and cannot be attached");
  }
  world_.set_pose(body,
                  X_WL_[link] * X_LO);  // throws on an invalid pose before anything changes
  detach(body);
  Attachment attachment{body, link, X_LO, {}};
  const auto pairs = world_.pairs();
  for (const int other : touching) {
    const std::pair<int, int> pair = std::minmax(link_body_[other], body);
    if (std::find(pairs.begin(), pairs.end(), pair) == pairs.end()) continue;
    world_.remove_pair(pair.first, pair.second);
    attachment.suspended.push_back(pair);
  }
  attachments_.push_back(attachment);
  motion_revision_ = -1;
}

void Scene::detach(int body) {
  const auto found = std::find_if(attachments_.begin(), attachments_.end(),
                                  [&](const Attachment& other) { return other.body == body; });
  if (found == attachments_.end()) return;
  for (const auto& [a, b] : found->suspended) world_.add_pair(a, b);
  attachments_.erase(found);
  motion_revision_ = -1;
}

void Scene::keep_links_apart(double clearance, const std::vector<int>& joints,
                             const std::vector<Eigen::VectorXd>& given) {
  std::vector<int> link_of(world_.num_bodies(), -1);
  for (int link = 0; link < static_cast<int>(link_body_.size()); ++link) {
    if (link_body_[link] >= 0) link_of[link_body_[link]] = link;
  }
  std::vector<int> kept;
  for (int i = 0; i < world_.num_pairs(); ++i) {
    const auto [a, b] = world_.pair(i);
    if (link_of[a] < 0 || link_of[b] < 0) continue;
    const Eigen::VectorXd reach =
        relative_reach(robot_, Carrier{link_of[a], {}}, Carrier{link_of[b], {}}, false);
    world_.keep_apart(a, b, 0);
    if ((reach(joints).array() > 0).any()) kept.push_back(i);
  }
  for (const int i : built_close(kept, joints, given))
    kept.erase(std::find(kept.begin(), kept.end(), i));
  for (const int i : kept) keep_apart(i, clearance);
  for (const Eigen::VectorXd& q : given) {
    place(q);
    for (const int i : kept) {
      if (world_.touches(i)) keep_apart(i, 0);
    }
  }
}

std::vector<int> Scene::built_close(std::vector<int> pairs, const std::vector<int>& joints,
                                    const std::vector<Eigen::VectorXd>& given) {
  constexpr double kClose = 2e-3;  // [m]
  Eigen::VectorXd q = given.empty() ? Eigen::VectorXd::Zero(robot_.dof()) : given.front();
  for (const double part : {0.25, 0.5, 0.75}) {
    for (const int joint : joints) {
      q[joint] = robot_.lower()[joint] + part * (robot_.upper()[joint] - robot_.lower()[joint]);
    }
    place(q);
    const auto is_other = [&](int i) {
      keep_apart(i, kClose);
      const bool is_near = world_.touches(i);
      keep_apart(i, 0);
      return !is_near || world_.touches(i);
    };
    pairs.erase(std::remove_if(pairs.begin(), pairs.end(), is_other), pairs.end());
  }
  return pairs;
}

void Scene::keep_apart(int pair, double clearance) {
  const auto [a, b] = world_.pair(pair);
  world_.keep_apart(a, b, clearance);
}

void Scene::place(const robot::Poses& X_WL) {
  for (const int link : moving_links_) world_.set_pose(link_body_[link], X_WL[link]);
  for (const Attachment& attachment : attachments_) {
    world_.set_pose(attachment.body, X_WL[attachment.link] * attachment.X_LO);
  }
}

void Scene::place(const Eigen::VectorXd& q) {
  robot_.forward(q, X_WL_);
  place(X_WL_);
}

bool Scene::is_free(const Eigen::VectorXd& q) {
  if (!robot_.is_within(q)) return false;
  place(q);
  return !world_.collides();
}

bool Scene::is_free(const robot::Poses& X_WL) { return !first_collision(X_WL); }

std::optional<std::pair<int, int>> Scene::first_collision(const robot::Poses& X_WL) {
  if (X_WL.size() != link_body_.size()) {
    throw std::invalid_argument("X_WL must have " + std::to_string(link_body_.size()) +
                                " poses, one for each link, not " + std::to_string(X_WL.size()));
  }
  place(X_WL);
  return world_.first_collision();
}

std::pair<std::string, std::string> Scene::collision(const Eigen::VectorXd& q) {
  if (!q.allFinite()) throw std::invalid_argument("q must be finite");
  place(q);
  const auto pair = world_.first_collision();
  if (!pair) return {};
  return {world_.name(pair->first), world_.name(pair->second)};
}

}  // namespace graspless::scene
