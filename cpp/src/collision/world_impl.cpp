// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/world_impl.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace graspless::collision {
namespace {

// Boxes this near are passed to FCL [m], so that rounding in our bounds never hides a contact.
constexpr double kMargin = 1e-9;
// Hulls hardly ever improve the bound of the boxes by this factor.
constexpr double kFar = 2;

inline bool overlap(const WorldBox& a, const WorldBox& b, const Eigen::Vector3d& shift_W,
                    double margin = kMargin) {
  const auto is_near = [&](int i) {
    return std::abs(b.middle[i] + shift_W[i] - a.middle[i]) - a.half[i] - b.half[i] <= margin;
  };
  return is_near(2) && is_near(0) && is_near(1);
}

Eigen::Isometry3d relative(const Placement& at_a, const Placement& at_b,
                           const Eigen::Vector3d& shift_W) {
  const Eigen::Matrix3d R_AW = at_a.X_WC.linear().transpose();
  Eigen::Isometry3d X_AB = Eigen::Isometry3d::Identity();
  X_AB.linear() = R_AW * at_b.X_WC.linear();
  X_AB.translation() = R_AW * (at_b.X_WC.translation() + shift_W - at_a.X_WC.translation());
  return X_AB;
}

}  // namespace

void World::Impl::require_body(int body, const char* what) const {
  if (body >= 0 && body < static_cast<int>(bodies.size())) return;
  throw std::invalid_argument(std::string(what) + " must be the index of one of the " +
                              std::to_string(bodies.size()) + " bodies, not " +
                              std::to_string(body));
}

int World::Impl::find(int a, int b) const {
  if (tested.count(std::minmax({a, b})) == 0) return -1;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i].a == std::min(a, b) && pairs[i].b == std::max(a, b)) return static_cast<int>(i);
  }
  return -1;
}

int World::Impl::require_pair(int a, int b) const {
  require_body(a, "a");
  require_body(b, "b");
  const int pair = find(a, b);
  if (pair >= 0) return pair;
  throw std::invalid_argument("bodies '" + bodies[a].name + "' and '" + bodies[b].name +
                              "' are not tested");
}

void World::Impl::place(int body) {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector3d high = -low;
  Placement* at = &placements[first_placement[body]];
  for (const CollisionShape& shape : bodies[body].solid.data().shapes) {
    at->X_WC.matrix().noalias() = poses[body].matrix() * shape.X_BC.matrix();
    at->half_W = half_in_world(shape.core, at->X_WC.linear());
    low = low.cwiseMin(at->X_WC.translation() - at->half_W);
    high = high.cwiseMax(at->X_WC.translation() + at->half_W);
    ++at;
  }
  boxes[body] = {(low + high) / 2, (high - low) / 2};
}

template <typename Visit>
bool World::Impl::any_shapes(const Pair& pair, Visit visit, bool tight) const {
  const auto &shapes_a = bodies[pair.a].solid.data().shapes,
             &shapes_b = bodies[pair.b].solid.data().shapes;
  std::vector<Witnesses>& known = tight ? pair.tight_witnesses : pair.witnesses;
  known.resize(shapes_a.size() * shapes_b.size());
  auto witnesses = known.begin();
  const Placement* at_a = &placements[first_placement[pair.a]];
  for (const CollisionShape& a : shapes_a) {
    const Placement* at_b = &placements[first_placement[pair.b]];
    for (const CollisionShape& b : shapes_b) {
      if (visit(a, *at_a, b, *at_b, *witnesses)) return true;
      ++at_b;
      ++witnesses;
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

bool World::Impl::is_far(const Pair& pair) const {
  return !overlap(boxes[pair.a], boxes[pair.b], pair.shift_W, pair.clearance + kMargin);
}

bool World::Impl::touch(const Pair& pair) {
  if (is_far(pair)) return false;
  const double margin = pair.clearance + kMargin;
  return any_shapes(pair, [&](const auto& a, const auto& at_a, const auto& b, const auto& at_b,
                              Witnesses& witnesses) {
    const WorldBox box_a{at_a.X_WC.translation(), at_a.half_W};
    const WorldBox box_b{at_b.X_WC.translation(), at_b.half_W};
    if (!overlap(box_a, box_b, pair.shift_W, margin)) return false;
    if (oriented_bound(a.core, at_a, b.core, at_b, pair.shift_W) > margin) return false;
    if (a.core.is_exact_segment && b.core.is_exact_segment) return true;
    const bool is_wide = pair.clearance > 0;                        // FCL knows no distances
    if (is_wide || a.hulls->has_parts() || b.hulls->has_parts()) {  // otherwise FCL is as fast
      const Eigen::Isometry3d X_AB = relative(at_a, at_b, pair.shift_W);
      if (are_apart(*a.hulls, *b.hulls, X_AB, margin, witnesses)) return false;
    }
    return is_wide || fcl_touch(a, at_a, b, at_b, pair.shift_W);
  });
}

bool World::Impl::touch_by_fcl(const Pair& pair) {
  if (!overlap(boxes[pair.a], boxes[pair.b], pair.shift_W)) return false;
  return any_shapes(
      pair, [&](const auto& a, const auto& at_a, const auto& b, const auto& at_b, Witnesses&) {
        const WorldBox box_a{at_a.X_WC.translation(), at_a.half_W};
        const WorldBox box_b{at_b.X_WC.translation(), at_b.half_W};
        return overlap(box_a, box_b, pair.shift_W) && fcl_touch(a, at_a, b, at_b, pair.shift_W);
      });
}

/// True if a shape of either body lies within a closed surface of the other. The bodies must not
/// touch, so that one point tells where a connected shape lies.
bool World::Impl::swallows(const Pair& pair) const {
  const bool has_surface =
      bodies[pair.a].solid.data().has_enclosure || bodies[pair.b].solid.data().has_enclosure;
  if (!has_surface || !overlap(boxes[pair.a], boxes[pair.b], pair.shift_W)) return false;
  const auto contains = [](const CollisionShape& outer, const CollisionShape& inner,
                           const Eigen::Isometry3d& X_OI) {
    const auto has = [&](const Eigen::Vector3d& p_O) {
      return (p_O.cwiseAbs().array() <= outer.core.half.array()).all() &&
             outer.enclosure->contains(p_O);
    };
    if (!inner.enclosure) return has(X_OI * inner.point);
    for (const auto& p_I : inner.enclosure->vertex_of_each_part().colwise()) {
      if (has(X_OI * p_I)) return true;
    }
    return false;
  };
  return any_shapes(pair, [&](const auto& a, const auto& at_a, const auto& b, const auto& at_b,
                              Witnesses&) {
    if (!a.enclosure && !b.enclosure) return false;
    const Eigen::Isometry3d X_AB = relative(at_a, at_b, pair.shift_W);
    return (a.enclosure && contains(a, b, X_AB)) || (b.enclosure && contains(b, a, X_AB.inverse()));
  });
}

double World::Impl::bound(const Pair& pair, double enough, bool tight) const {
  const WorldBox &box_a = boxes[pair.a], &box_b = boxes[pair.b];
  const double gap = box_gap(box_b.middle + pair.shift_W - box_a.middle, box_a.half + box_b.half);
  if (gap >= enough) return gap;
  double least = std::numeric_limits<double>::infinity();
  any_shapes(
      pair,
      [&](const auto& a, const auto& at_a, const auto& b, const auto& at_b, Witnesses& witnesses) {
        const double wanted = std::min(enough, least);
        double bound = shape_distance_bound(a.core, at_a, b.core, at_b, pair.shift_W, wanted);
        const bool has_hulls = tight || a.hulls->is_of_mesh || b.hulls->is_of_mesh;
        if (bound < wanted && has_hulls && !(bound > 0 && kFar * bound < wanted)) {
          const Eigen::Isometry3d X_AB = relative(at_a, at_b, pair.shift_W);
          bound = std::max(bound, separation(*a.hulls, *b.hulls, X_AB, wanted, tight, witnesses));
        }
        least = std::min(least, bound);
        return least <= gap;
      },
      tight);
  return std::max(gap, least);
}

}  // namespace graspless::collision
