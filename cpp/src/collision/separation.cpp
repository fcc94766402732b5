// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// A direction in which one convex body ends before the other begins proves a distance. Gilbert,
// Johnson and Keerthi's method finds the best one. Each of its steps yields a bound that holds
// whatever rounding does to the search.
#include "collision/separation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace graspless::collision {
namespace {

using Eigen::Vector3d;

constexpr int kMaxSteps = 16;       // of the search for a direction
constexpr double kTolerance = 0.1;  // relative, of a bound
constexpr int kMaxPairs = 256;      // of hulls; then the bounds so far must do
constexpr std::size_t kMany = 16;   // witnesses; a new search may find fewer
constexpr double kMuch = 2;         // a search hardly ever improves a bound by this factor
constexpr double kNear = 0.5;       // a bound this close to another is as good
constexpr double kLarge = 0.25;     // of the hulls; parts hardly improve a larger bound
constexpr int kMaxFacets = 4096;    // pairs with a triangle, in one search

/// Up to four points, and the point of their hull nearest to the origin.
class Simplex {
 public:
  /// Adds a point and drops those that the nearest point does not need. Returns that point; zero if
  /// the hull contains the origin.
  Vector3d add(const Vector3d& point) {
    points_[size_++] = point;
    if (size_ == 1) return point;
    if (size_ == 2) return take(of_segment(points_[0], points_[1]));
    if (size_ == 3) return take(of_triangle(points_[0], points_[1], points_[2]));
    return of_tetrahedron();
  }

 private:
  struct Part {
    Vector3d nearest;
    std::array<Vector3d, 3> points;
    int size;
  };

  Vector3d take(const Part& part) {
    std::copy_n(part.points.begin(), part.size, points_.begin());
    size_ = part.size;
    return part.nearest;
  }

  static Part of_segment(const Vector3d& a, const Vector3d& b) {
    const Vector3d ab = b - a;
    const double along = -a.dot(ab), length = ab.squaredNorm();
    if (along <= 0 || length == 0) return {a, {a}, 1};
    if (along >= length) return {b, {b}, 1};
    return {a + along / length * ab, {a, b}, 2};
  }

  // Ericson, Real-Time Collision Detection, 5.1.5.
  static Part of_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const Vector3d ab = b - a, ac = c - a, normal = ab.cross(ac);
    const double square = normal.squaredNorm();
    const double u = b.cross(c).dot(normal), v = c.cross(a).dot(normal), w = a.cross(b).dot(normal);
    if (square > 0 && u > 0 && v > 0 && w > 0) {
      return {a.dot(normal) / square * normal, {a, b, c}, 3};
    }
    Part best = of_segment(a, b);
    for (const Part& part : {of_segment(b, c), of_segment(c, a)}) {
      if (part.nearest.squaredNorm() < best.nearest.squaredNorm()) best = part;
    }
    return best;
  }

  Vector3d of_tetrahedron() {
    constexpr int kSides[4][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 3, 2, 0}};
    std::optional<Part> best;
    for (const auto& side : kSides) {
      const Vector3d &a = points_[side[0]], &b = points_[side[1]], &c = points_[side[2]];
      const Vector3d normal = (b - a).cross(c - a);
      // Outside if the origin and the fourth point lie on different sides.
      if (-a.dot(normal) * (points_[side[3]] - a).dot(normal) > 0) continue;
      const Part part = of_triangle(a, b, c);
      if (!best || part.nearest.squaredNorm() < best->nearest.squaredNorm()) best = part;
    }
    return best ? take(*best) : Vector3d::Zero();
  }

  std::array<Vector3d, 4> points_;
  int size_ = 0;
};

/// Finds and uses witnesses that two shapes lie apart.
class Separation {
 public:
  Separation(const HullTree& a, const HullTree& b, const Eigen::Isometry3d& X_AB, double enough,
             bool by_triangle, Witnesses& witnesses)
      : a_(a),
        b_(b),
        X_AB_(X_AB),
        enough_(enough),
        by_triangle_(by_triangle),
        witnesses_(witnesses) {}

  /// Searches where the witnesses of the last search do not prove enough. With `is_quick`, only
  /// where a search may improve what they prove to be enough.
  double run(bool is_quick) {
    const double known = confirm();
    if (known >= enough_ || (is_quick && known > 0 && kMuch * known < enough_)) return known;
    if (witnesses_.empty() || witnesses_.size() > kMany) {
      witnesses_.clear();
      const Vector3d start = a_.hulls[0].middle - X_AB_ * b_.hulls[0].middle;
      descend(0, 0, bound(0, 0, start.norm() > 0 ? start.normalized() : Vector3d::UnitX()));
    } else {
      repair();
    }
    if (answer_ == 0) witnesses_.clear();
    return answer_;
  }

 private:
  struct Bound {
    double distance;
    Vector3d direction_A;
  };

  void repair() {
    Witnesses known;
    std::swap(known, witnesses_);
    for (const auto& [i, j, direction_A] : known) {
      const Bound now{nearest(i, j, direction_A).dot(direction_A) - radii_, direction_A};
      descend(i, j, now.distance >= enough_ ? now : bound(i, j, direction_A));
    }
  }

  void settle(int i, int j, const Bound& known) {
    answer_ = std::min(answer_, known.distance);
    least_ = std::min(least_, kNear * answer_);
    witnesses_.push_back({i, j, known.direction_A});
  }

  /// Finds a lower bound on the distance of two hulls, of which `known` is one.
  void descend(int i, int j, const Bound& known) {
    if (answer_ == 0) return;
    if (by_triangle_ && has_facets(i, j, known.distance)) return split(i, j, known);
    if (!can_gain(i, j, known.distance) || pairs_ > kMaxPairs) return settle(i, j, known);
    const Hull &a = a_.hulls[i], &b = b_.hulls[j];
    const bool cut_a = b.child < 0 || (a.child >= 0 && a.half.squaredNorm() > b.half.squaredNorm());
    const int i0 = cut_a ? a.child : i, j0 = cut_a ? j : b.child;
    const int i1 = cut_a ? i0 + 1 : i, j1 = cut_a ? j : j0 + 1;
    const Bound first = bound(i0, j0, known.direction_A), second = bound(i1, j1, known.direction_A);
    if (first.distance <= second.distance) {
      descend(i0, j0, first);
      descend(i1, j1, second);
    } else {
      descend(i1, j1, second);
      descend(i0, j0, first);
    }
  }

  static const Hull* hull(const HullTree& tree, int part) {
    return part < static_cast<int>(tree.hulls.size()) ? &tree.hulls[part] : nullptr;
  }
  /// Number of triangles of a part, if it is a leaf of a surface.
  static int num_facets(const Hull* leaf) { return leaf ? leaf->end - leaf->begin : 0; }

  /// True if no hull is left to cut, and triangles may be farther apart than their hulls.
  bool has_facets(int i, int j, double known) const {
    const Hull *a = hull(a_, i), *b = hull(b_, j);
    if ((a && a->child >= 0) || (b && b->child >= 0) || facets_ > kMaxFacets) return false;
    const double sizes =
        (num_facets(a) > 0 ? a->half.norm() : 0) + (num_facets(b) > 0 ? b->half.norm() : 0);
    return known < std::min({least_, enough_, kLarge * sizes});
  }

  /// Goes through the triangles of a leaf.
  void split(int i, int j, const Bound& known) {
    const Hull *a = hull(a_, i), *b = hull(b_, j);
    const bool split_a =
        num_facets(b) == 0 || (num_facets(a) > 0 && a->half.squaredNorm() > b->half.squaredNorm());
    const HullTree& tree = split_a ? a_ : b_;
    const Hull& leaf = split_a ? *a : *b;
    const int first = static_cast<int>(tree.hulls.size());
    for (int k = leaf.begin; k < leaf.end && answer_ > 0; ++k) {
      const int facet = first + tree.order[k];
      const int at_a = split_a ? facet : i, at_b = split_a ? j : facet;
      descend(at_a, at_b, bound(at_a, at_b, known.direction_A));
    }
  }

  /// True if parts of two hulls may be farther apart than the hulls, by more than it costs to see.
  bool can_gain(int i, int j, double known) const {
    const Hull *a = hull(a_, i), *b = hull(b_, j);
    if (!a || !b || known >= least_ || known >= enough_ || (a->child < 0 && b->child < 0)) {
      return false;
    }
    return known <
           kLarge * ((a->child < 0 ? 0 : a->half.norm()) + (b->child < 0 ? 0 : b->half.norm()));
  }

  /// Point of the hulls' difference a - b that lies farthest against a direction.
  Vector3d nearest(int i, int j, const Vector3d& direction_A) const {
    return farthest(a_, i, -direction_A) -
           X_AB_ * farthest(b_, j, X_AB_.linear().transpose() * direction_A);
  }
  static Vector3d farthest(const HullTree& tree, int part, const Vector3d& direction) {
    const int facet = part - static_cast<int>(tree.hulls.size());
    return facet < 0 ? tree.farthest(tree.hulls[part], direction)
                     : tree.farthest_corner(facet, direction);
  }

  /// Returns the least distance that the witnesses prove; 0 without any.
  double confirm() const {
    double least = witnesses_.empty() ? 0 : std::numeric_limits<double>::infinity();
    for (const auto& [i, j, direction_A] : witnesses_) {
      const Vector3d w = nearest(i, j, direction_A);
      least = std::min(least, w.dot(direction_A) - radii_);
      if (least <= 0) return 0;
    }
    return least;
  }

  Bound bound(int i, int j, const Vector3d& start_A) {
    ++(hull(a_, i) && hull(b_, j) ? pairs_ : facets_);
    const double wanted = std::min(enough_, least_);
    Bound best{0, start_A};
    Vector3d direction_A = start_A;
    Simplex simplex;
    double length = std::numeric_limits<double>::infinity();  // of a point of the difference
    for (int step = 0; step < kMaxSteps; ++step) {
      const Vector3d w = nearest(i, j, direction_A);
      const double along = w.dot(direction_A);
      if (along - radii_ > best.distance) best = {along - radii_, direction_A};
      if (best.distance >= wanted || along - radii_ >= (1 - kTolerance) * (length - radii_)) break;
      const Vector3d v = simplex.add(w);
      length = v.norm();
      const double most = length - radii_;
      if (!(length > 0 && most > 0)) break;
      if (most < wanted && can_gain(i, j, most)) break;
      direction_A = v / length;
    }
    return best;
  }

  const HullTree &a_, &b_;
  const Eigen::Isometry3d& X_AB_;
  double enough_;
  bool by_triangle_;
  Witnesses& witnesses_;
  double radii_ = a_.radius + b_.radius;
  double answer_ = std::numeric_limits<double>::infinity();
  double least_ = answer_;  // a pair with this bound is not worth cutting
  int pairs_ = 0, facets_ = 0;
};

}  // namespace

double separation(const HullTree& a, const HullTree& b, const Eigen::Isometry3d& X_AB,
                  double enough, bool by_triangle, Witnesses& witnesses) {
  return Separation(a, b, X_AB, enough, by_triangle, witnesses).run(true);
}

bool are_apart(const HullTree& a, const HullTree& b, const Eigen::Isometry3d& X_AB, double margin,
               Witnesses& witnesses) {
  return Separation(a, b, X_AB, 2 * margin, false, witnesses).run(false) > margin;
}

}  // namespace graspless::collision
