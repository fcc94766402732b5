// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/world.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"
#include "graspless/watch.hpp"

#include "collision/world_impl.hpp"
#include "text.hpp"

namespace graspless::collision {
namespace {

void require_length(double length, const char* what) {
  if (length >= 0 && length <= geometry::kMaxLength) return;
  require(false, what, length, "must be in [0, " + figure(geometry::kMaxLength) + "] m");
}

const Pair& pair_at(const std::vector<Pair>& pairs, int index, const char* what = "pair") {
  const auto at = static_cast<std::size_t>(index);
  if (at < pairs.size()) return pairs[at];  // false of a negative index
  throw std::invalid_argument(what + (" must be in [0, " + std::to_string(pairs.size())) +
                              "), not " + std::to_string(index));
}

}  // namespace

World::World() : impl_(std::make_unique<Impl>()) {}
World::World(const World& other) : impl_(std::make_unique<Impl>(*other.impl_)) {}
World& World::operator=(const World& other) {
  if (this != &other) impl_ = std::make_unique<Impl>(*other.impl_);
  return *this;
}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

int World::add_body(const std::string& name, const std::vector<geometry::PlacedShape>& shapes) {
  return add_body(name, Solid(shapes, "body '" + name + "'"));
}

int World::add_body(const std::string& name, const Solid& solid) {
  for (const Body& body : impl_->bodies) {
    if (body.name == name) throw std::invalid_argument("body '" + name + "' already exists");
  }
  impl_->first_placement.push_back(static_cast<int>(impl_->placements.size()));
  impl_->placements.resize(impl_->placements.size() + solid.data().shapes.size());
  impl_->bodies.push_back({name, solid});
  impl_->poses.push_back(Eigen::Isometry3d::Identity());
  impl_->boxes.emplace_back();
  impl_->place(num_bodies() - 1);
  return num_bodies() - 1;
}

int World::num_bodies() const { return static_cast<int>(impl_->bodies.size()); }

int World::body(const std::string& name) const {
  std::string names;
  for (int i = 0; i < num_bodies(); ++i) {
    if (impl_->bodies[i].name == name) return i;
    names += (i == 0 ? "" : ", ") + impl_->bodies[i].name;
  }
  throw std::invalid_argument("no body '" + name + "'; choose from: " + names);
}

const std::string& World::name(int body) const {
  impl_->require_body(body, "body");
  return impl_->bodies[body].name;
}

void World::set_pose(int body, const Eigen::Isometry3d& X_WB) {
  impl_->require_body(body, "body");
  if (!geometry::is_pose(X_WB)) geometry::require_pose(X_WB, "pose of body '" + name(body) + "'");
  impl_->poses[body] = X_WB;
  impl_->place(body);
}

const Eigen::Isometry3d& World::pose(int body) const {
  impl_->require_body(body, "body");
  return impl_->poses[body];
}

double World::radius(int body) const {
  impl_->require_body(body, "body");
  return impl_->bodies[body].solid.data().radius;
}

void World::add_pair(int a, int b) {
  impl_->require_body(a, "a");
  impl_->require_body(b, "b");
  if (a == b) throw std::invalid_argument("body '" + name(a) + "' cannot be tested against itself");
  if (!impl_->tested.insert(std::minmax({a, b})).second) return;
  impl_->pairs.push_back({std::min(a, b), std::max(a, b), Eigen::Vector3d::Zero(), 0, {}, {}});
  ++impl_->revision;
}

void World::remove_pair(int a, int b) {
  const int pair = impl_->find(a, b);
  if (pair < 0) return;
  impl_->tested.erase(std::minmax({a, b}));
  impl_->pairs.erase(impl_->pairs.begin() + pair);
  ++impl_->revision;
}

void World::allow_contact(int a, int b, const Eigen::Vector3d& normal_W, double depth) {
  const int pair = impl_->require_pair(a, b);
  require_length(depth, "depth");
  const double length = normal_W.norm();
  if (!(length > 0) || !std::isfinite(length)) {
    std::ostringstream fault;
    fault << "normal_W must be finite and not zero, not (" << normal_W.transpose() << ")";
    throw std::invalid_argument(fault.str());
  }
  // Moving the first body of a pair equals moving the second in the opposite direction.
  const double sign = a < b ? -1 : 1;
  Eigen::Vector3d& shift_W = impl_->pairs[pair].shift_W;
  if (shift_W.isZero(0) != (depth == 0)) ++impl_->revision;
  shift_W = sign * depth / length * normal_W;
}

void World::keep_apart(int a, int b, double clearance) {
  const int pair = impl_->require_pair(a, b);
  require_length(clearance, "clearance");
  impl_->pairs[pair].clearance = clearance;
}

int World::num_pairs() const { return static_cast<int>(impl_->pairs.size()); }

std::pair<int, int> World::pair(int index) const {
  const Pair& pair = pair_at(impl_->pairs, index, "index");
  return {pair.a, pair.b};
}

const Eigen::Vector3d& World::shift(int pair) const { return pair_at(impl_->pairs, pair).shift_W; }

int World::revision() const { return impl_->revision; }

std::vector<std::pair<int, int>> World::pairs() const {
  std::vector<std::pair<int, int>> all;
  for (const Pair& pair : impl_->pairs) all.emplace_back(pair.a, pair.b);
  return all;
}

bool World::collides() { return first_collision().has_value(); }

std::optional<std::pair<int, int>> World::first_collision() {
  poll();
  ++impl_->checks;
  for (const Pair& pair : impl_->pairs) {
    if (impl_->is_far(pair)) continue;
    if (impl_->touch(pair) || impl_->swallows(pair)) return std::make_pair(pair.a, pair.b);
  }
  return std::nullopt;
}

std::vector<std::pair<int, int>> World::all_collisions() {
  poll();
  std::vector<std::pair<int, int>> touching;
  for (const Pair& pair : impl_->pairs) {
    if (impl_->touch_by_fcl(pair) || impl_->swallows(pair)) touching.emplace_back(pair.a, pair.b);
  }
  return touching;
}

bool World::touches(int pair) { return impl_->touch(pair_at(impl_->pairs, pair)); }

bool World::swallows(int pair) const { return impl_->swallows(pair_at(impl_->pairs, pair)); }

double World::distance_bound(int pair, double enough) const {
  const Pair& tested = pair_at(impl_->pairs, pair);
  return std::max(0.0, impl_->bound(tested, enough + tested.clearance, false) - tested.clearance);
}

double World::proven_distance(int pair, double enough) const {
  return impl_->bound(pair_at(impl_->pairs, pair), enough, true);
}

const std::vector<double>& World::distance_bounds() {
  impl_->bounds.resize(impl_->pairs.size());
  for (int i = 0; i < num_pairs(); ++i) impl_->bounds[i] = distance_bound(i);
  return impl_->bounds;
}

int World::num_checks() const { return impl_->checks; }

int World::num_failures() const { return impl_->failures; }

}  // namespace graspless::collision
