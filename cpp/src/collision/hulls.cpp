// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/hulls.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "graspless/watch.hpp"

#include "geometry/simd.hpp"

namespace graspless::collision {
namespace {

using Eigen::Vector3d;

constexpr int kLeaf = 24;          // triangles of a part that is not cut further
constexpr int kMaxVertices = 512;  // of a hull; a larger part is bounded by its box
constexpr int kLanes = 4;
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double)), aligned(8), may_alias));

/// Returns the index of the point farthest along a direction, the first of several.
GRASPLESS_SIMD int index_of_farthest(const double* x, int count, const double* direction) {
  const int blocks = count / kLanes;
  const auto* X = reinterpret_cast<const Lanes*>(x);
  const Lanes *Y = X + blocks, *Z = Y + blocks;
  Lanes most = Lanes{} - std::numeric_limits<double>::max(), block = {};
  for (int i = 0; i < blocks; ++i) {
    const Lanes along = direction[0] * X[i] + direction[1] * Y[i] + direction[2] * Z[i];
    block = along > most ? Lanes{} + static_cast<double>(i) : block;
    most = along > most ? along : most;
  }
  int best = 0;
  for (int k = 1; k < kLanes; ++k) {
    if (most[k] > most[best] || (most[k] == most[best] && block[k] < block[best])) best = k;
  }
  return kLanes * static_cast<int>(block[best]) + best;
}

/// Cuts the triangles of a surface into parts.
class SurfaceCutter {
 public:
  SurfaceCutter(const Eigen::Matrix3Xd& vertices, const Eigen::Matrix3Xi& triangles)
      : vertices_(vertices),
        triangles_(triangles),
        order_(triangles.cols()),
        used_by_(vertices.cols(), -1) {
    std::iota(order_.begin(), order_.end(), 0);
    middles_.resize(3, triangles.cols());
    for (Eigen::Index i = 0; i < triangles.cols(); ++i) {
      middles_.col(i) = vertices(Eigen::all, triangles.col(i)).rowwise().mean();
    }
  }

  HullTree run(const Eigen::Matrix3Xd& hull) {
    tree_.hulls.emplace_back();
    set_vertices(0, hull);
    cut(0, 0, static_cast<int>(order_.size()));
    tree_.order = std::move(order_);
    return std::move(tree_);
  }

 private:
  void cut(int at, int begin, int end) {
    poll();
    if (end - begin <= kLeaf) {
      tree_.hulls[at].begin = begin;
      tree_.hulls[at].end = end;
      return;
    }
    Eigen::Index axis = 0;
    const auto range = order_.begin();
    Vector3d low = middles_.col(order_[begin]), high = low;
    for (int i = begin; i < end; ++i) {
      low = low.cwiseMin(middles_.col(order_[i]));
      high = high.cwiseMax(middles_.col(order_[i]));
    }
    (high - low).maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(range + begin, range + middle, range + end, [&](int i, int j) {
      return std::make_pair(middles_(axis, i), i) < std::make_pair(middles_(axis, j), j);
    });
    const int child = static_cast<int>(tree_.hulls.size());
    tree_.hulls[at].child = child;
    tree_.hulls.resize(tree_.hulls.size() + 2);
    add(child, begin, middle);
    add(child + 1, middle, end);
  }

  void add(int at, int begin, int end) {
    std::vector<int> used;
    for (int i = begin; i < end; ++i) {
      for (int k = 0; k < 3; ++k) {
        const int vertex = triangles_(k, order_[i]);
        if (std::exchange(used_by_[vertex], at) != at) used.push_back(vertex);
      }
    }
    if (used.size() <= kMaxVertices)
      std::sort(used.begin(), used.end());  // else only the box counts
    set_vertices(at, vertices_(Eigen::all, used));
    cut(at, begin, end);
  }

  void set_vertices(int at, const Eigen::Matrix3Xd& part) {
    const Vector3d low = part.rowwise().minCoeff(), high = part.rowwise().maxCoeff();
    Hull& hull = tree_.hulls[at];
    hull.middle = (low + high) / 2;
    hull.half = (high - low) / 2;
    if (part.cols() > kMaxVertices) return;
    hull.first = static_cast<int>(tree_.coordinates.size());
    const Eigen::Index padding = (kLanes - part.cols() % kLanes) % kLanes;
    hull.count = static_cast<int>(part.cols() + padding);
    for (const auto& row : part.rowwise()) {
      tree_.coordinates.insert(tree_.coordinates.end(), row.begin(), row.end());
      tree_.coordinates.insert(tree_.coordinates.end(), padding, row.tail<1>().value());
    }
  }

  const Eigen::Matrix3Xd& vertices_;
  const Eigen::Matrix3Xi& triangles_;
  std::vector<int> order_;
  std::vector<int> used_by_;  // of each vertex: the part that had it last
  Eigen::Matrix3Xd middles_;
  HullTree tree_;
};

}  // namespace

Eigen::Vector3d HullTree::farthest(const Hull& hull, const Eigen::Vector3d& direction) const {
  if (hull.count == 0) {
    return hull.middle + hull.half.cwiseProduct(
                             (direction.array() < 0).select(-Vector3d::Ones(), Vector3d::Ones()));
  }
  const double* p = coordinates.data() + hull.first;
  const int best = index_of_farthest(p, hull.count, direction.data());
  return {p[best], p[hull.count + best], p[2 * hull.count + best]};
}

Eigen::Vector3d HullTree::farthest_corner(int triangle, const Eigen::Vector3d& direction) const {
  const auto corners = surface->triangles.col(triangle);
  int best = corners[0];
  double most = surface->vertices.col(best).dot(direction);
  for (int k = 1; k < 3; ++k) {
    const double along = surface->vertices.col(corners[k]).dot(direction);
    if (along > most) best = corners[k];
    most = std::max(most, along);
  }
  return surface->vertices.col(best);
}

HullTree box_tree(const Core& core) {
  HullTree tree;
  tree.hulls.push_back({Vector3d::Zero(), core.half});
  tree.radius = core.radius;
  return tree;
}

HullTree convex_tree(const Eigen::Matrix3Xd& vertices) {
  return SurfaceCutter(vertices, Eigen::Matrix3Xi(3, 0)).run(vertices);
}

HullTree surface_tree(std::shared_ptr<const geometry::Mesh> surface, const Eigen::Matrix3Xd& hull) {
  HullTree tree = SurfaceCutter(surface->vertices, surface->triangles).run(hull);
  tree.surface = std::move(surface);
  return tree;
}

}  // namespace graspless::collision
