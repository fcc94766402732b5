// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/world.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "collision/bounds.hpp"
#include "collision/fcl_shape.hpp"

namespace graspless::collision {
namespace {

// Boxes this near are given to FCL, so that rounding in our bounds never hides a contact FCL would
// see [m].
constexpr double kMargin = 1e-9;

struct Body {
  std::string name;
  std::vector<CollisionShape> shapes;
};

/// An axis-aligned box in the world.
struct WorldBox {
  Eigen::Vector3d middle, half;
};

/// Bodies a < b; b is tested moved by `shift_W`.
struct Pair {
  int a, b;
  Eigen::Vector3d shift_W = Eigen::Vector3d::Zero();
};

bool overlap(const WorldBox& a, const WorldBox& b, const Eigen::Vector3d& shift_W) {
  const Eigen::Array3d gap = (b.middle + shift_W - a.middle).cwiseAbs() - a.half - b.half;
  return (gap <= kMargin).all();
}

}  // namespace

struct World::Impl {
  std::vector<std::shared_ptr<const Body>> bodies;
  std::vector<Eigen::Isometry3d> poses;
  std::vector<WorldBox> boxes;        // one a body
  std::vector<int> first_placement;   // of each body
  std::vector<Placement> placements;  // one a shape
  std::vector<Pair> pairs;
  std::vector<double> bounds;
  FclTest test;
  int checks = 0;
  int failures = 0;

  void require_body(int body, const char* what) const;
  int find(int a, int b) const;
  void place(int body);
  /// Calls visit(shape a, placement a, shape b, placement b) until it says true; returns whether it
  /// did.
  template <typename Visit>
  bool any_shapes(const Pair& pair, Visit visit) const;
  bool fcl_touch(const CollisionShape& a, const Placement& at_a, const CollisionShape& b,
                 const Placement& at_b, const Eigen::Vector3d& shift_W);
  bool touch(const Pair& pair);
  bool touch_by_fcl(const Pair& pair);
  double bound(const Pair& pair) const;
};

void World::Impl::require_body(int body, const char* what) const {
  if (body >= 0 && body < static_cast<int>(bodies.size())) return;
  throw std::invalid_argument(std::string(what) + " must be the index of one of the " +
                              std::to_string(bodies.size()) + " bodies, not " +
                              std::to_string(body));
}

int World::Impl::find(int a, int b) const {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].a == std::min(a, b) && pairs[i].b == std::max(a, b)) return static_cast<int>(i);
  }
  return -1;
}

void World::Impl::place(int body) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  Placement* at = &placements[first_placement[body]];
  for (const CollisionShape& shape : bodies[body]->shapes) {
    at->X_WC = poses[body] * shape.X_BC;
    at->half_W = half_in_world(shape.core, at->X_WC.linear());
    low = low.cwiseMin(at->X_WC.translation() - at->half_W);
    high = high.cwiseMax(at->X_WC.translation() + at->half_W);
    ++at;
  }
  boxes[body] = {(low + high) / 2, (high - low) / 2};
}

template <typename Visit>
bool World::Impl::any_shapes(const Pair& pair, Visit visit) const {
  const Placement* at_a = &placements[first_placement[pair.a]];
  for (const CollisionShape& a : bodies[pair.a]->shapes) {
    const Placement* at_b = &placements[first_placement[pair.b]];
    for (const CollisionShape& b : bodies[pair.b]->shapes) {
      if (visit(a, *at_a, b, *at_b)) return true;
      ++at_b;
    }
    ++at_a;
  }
  return false;
}

bool World::Impl::fcl_touch(const CollisionShape& a, const Placement& at_a, const CollisionShape& b,
                            const Placement& at_b, const Eigen::Vector3d& shift_W) {
  Eigen::Isometry3d X_WC_b = at_b.X_WC;
  X_WC_b.translation() += shift_W;
  const Touch touch = test(a, at_a.X_WC, b, X_WC_b);
  failures += touch == Touch::failed;
  return touch != Touch::no;
}

bool World::Impl::touch(const Pair& pair) {
  if (!overlap(boxes[pair.a], boxes[pair.b], pair.shift_W)) return false;
  return any_shapes(pair, [&](const auto& a, const auto& at_a, const auto& b, const auto& at_b) {
    const WorldBox box_a{at_a.X_WC.translation(), at_a.half_W};
    const WorldBox box_b{at_b.X_WC.translation(), at_b.half_W};
    if (!overlap(box_a, box_b, pair.shift_W)) return false;
    if (oriented_bound(a.core, at_a, b.core, at_b, pair.shift_W) > kMargin) return false;
    if (a.core.is_exact_segment && b.core.is_exact_segment) return true;
    return fcl_touch(a, at_a, b, at_b, pair.shift_W);
  });
}

bool World::Impl::touch_by_fcl(const Pair& pair) {
  return any_shapes(pair, [&](const auto& a, const auto& at_a, const auto& b, const auto& at_b) {
    return fcl_touch(a, at_a, b, at_b, pair.shift_W);
  });
}

double World::Impl::bound(const Pair& pair) const {
  double least = std::numeric_limits<double>::infinity();
  any_shapes(pair, [&](const auto& a, const auto& at_a, const auto& b, const auto& at_b) {
    least = std::min(least, shape_distance_bound(a.core, at_a, b.core, at_b, pair.shift_W));
    return least <= 0;
  });
  return least;
}

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
  for (const auto& body : impl_->bodies) {
    if (body->name == name) throw std::invalid_argument("body '" + name + "' is already there");
  }
  if (shapes.empty()) throw std::invalid_argument("body '" + name + "' must have a shape");
  Body body{name, {}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string what = "body '" + name + "' shapes[" + std::to_string(i) + "]";
    body.shapes.push_back(make_collision_shape(shapes[i], what));
  }
  impl_->first_placement.push_back(static_cast<int>(impl_->placements.size()));
  impl_->placements.resize(impl_->placements.size() + shapes.size());
  impl_->bodies.push_back(std::make_shared<const Body>(std::move(body)));
  impl_->poses.push_back(Eigen::Isometry3d::Identity());
  impl_->boxes.emplace_back();
  impl_->place(num_bodies() - 1);
  return num_bodies() - 1;
}

int World::num_bodies() const { return static_cast<int>(impl_->bodies.size()); }

int World::body(const std::string& name) const {
  std::string names;
  for (int i = 0; i < num_bodies(); ++i) {
    if (impl_->bodies[i]->name == name) return i;
    names += (i == 0 ? "" : ", ") + impl_->bodies[i]->name;
  }
  throw std::invalid_argument("no body '" + name + "'; choose from: " + names);
}

const std::string& World::name(int body) const {
  impl_->require_body(body, "body");
  return impl_->bodies[body]->name;
}

void World::set_pose(int body, const Eigen::Isometry3d& X_WB) {
  impl_->require_body(body, "body");
  if (!X_WB.matrix().allFinite()) {
    throw std::invalid_argument("pose of body '" + name(body) + "' must be finite");
  }
  impl_->poses[body] = X_WB;
  impl_->place(body);
}

const Eigen::Isometry3d& World::pose(int body) const {
  impl_->require_body(body, "body");
  return impl_->poses[body];
}

void World::add_pair(int a, int b) {
  impl_->require_body(a, "a");
  impl_->require_body(b, "b");
  if (a == b) throw std::invalid_argument("body '" + name(a) + "' cannot be tested against itself");
  if (impl_->find(a, b) < 0) impl_->pairs.push_back({std::min(a, b), std::max(a, b)});
}

void World::remove_pair(int a, int b) {
  const int pair = impl_->find(a, b);
  if (pair >= 0) impl_->pairs.erase(impl_->pairs.begin() + pair);
}

void World::allow_contact(int a, int b, const Eigen::Vector3d& normal_W, double depth) {
  impl_->require_body(a, "a");
  impl_->require_body(b, "b");
  const int pair = impl_->find(a, b);
  if (pair < 0) {
    throw std::invalid_argument("bodies '" + name(a) + "' and '" + name(b) + "' are not tested");
  }
  if (!(depth >= 0) || !std::isfinite(depth)) {
    throw std::invalid_argument("depth must be finite and not negative, not " +
                                std::to_string(depth));
  }
  const double length = normal_W.norm();
  if (!(length > 0) || !std::isfinite(length)) {
    std::ostringstream fault;
    fault << "normal_W must be finite and not zero, not (" << normal_W.transpose() << ")";
    throw std::invalid_argument(fault.str());
  }
  // Moving the first of a pair is moving the second the other way.
  const double sign = a < b ? -1 : 1;
  impl_->pairs[pair].shift_W = sign * depth / length * normal_W;
}

int World::num_pairs() const { return static_cast<int>(impl_->pairs.size()); }

std::pair<int, int> World::pair(int index) const {
  const Pair& pair = impl_->pairs[index];
  return {pair.a, pair.b};
}

std::vector<std::pair<int, int>> World::pairs() const {
  std::vector<std::pair<int, int>> all;
  for (const Pair& pair : impl_->pairs) all.emplace_back(pair.a, pair.b);
  return all;
}

bool World::collides() { return first_collision().has_value(); }

std::optional<std::pair<int, int>> World::first_collision() {
  ++impl_->checks;
  for (const Pair& pair : impl_->pairs) {
    if (impl_->touch(pair)) return std::make_pair(pair.a, pair.b);
  }
  return std::nullopt;
}

std::vector<std::pair<int, int>> World::all_collisions() {
  std::vector<std::pair<int, int>> touching;
  for (const Pair& pair : impl_->pairs) {
    if (impl_->touch_by_fcl(pair)) touching.emplace_back(pair.a, pair.b);
  }
  return touching;
}

bool World::touches(int pair) { return impl_->touch(impl_->pairs[pair]); }

double World::distance_bound(int pair) const { return impl_->bound(impl_->pairs[pair]); }

const std::vector<double>& World::distance_bounds() {
  impl_->bounds.resize(impl_->pairs.size());
  for (int i = 0; i < num_pairs(); ++i) impl_->bounds[i] = distance_bound(i);
  return impl_->bounds;
}

int World::num_checks() const { return impl_->checks; }

int World::num_failures() const { return impl_->failures; }

}  // namespace graspless::collision
