// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/clearance_tree.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "graspless/watch.hpp"

namespace graspless::collision {
namespace {

using Eigen::Vector3d;

constexpr double kNowhere = std::numeric_limits<double>::infinity();
constexpr double kBeyond = 1e-9;  // how far beyond the limit a search goes [m]

}  // namespace

ClearanceTree::ClearanceTree(std::vector<SurfaceTriangle> triangles)
    : triangles_(std::move(triangles)) {}

const ClearanceTree::Node& ClearanceTree::root() const {
  built_([this] {
    nodes_.clear();  // of a call that was stopped
    std::vector<int> all(triangles_.size());
    std::iota(all.begin(), all.end(), 0);
    add_node(all.begin(), all.end());
  });
  return nodes_.front();
}

/// Adds the node of some triangles and those below it. Returns its index.
int ClearanceTree::add_node(Iterator begin, Iterator end) const {
  poll();
  const std::size_t index = nodes_.size();
  nodes_.emplace_back();
  nodes_[index].low.setConstant(kNowhere);
  nodes_[index].high.setConstant(kNowhere);
  const Iterator half = halve(begin, end);
  const std::array ends = {begin, halve(begin, half), half, halve(half, end), end};
  for (std::size_t k = 0; k < kChildren; ++k) {
    const auto count = ends[k + 1] - ends[k];
    if (count == 0) continue;
    Eigen::AlignedBox3d box;
    std::for_each(ends[k], ends[k + 1], [&](int i) {
      const SurfaceTriangle& t = triangle(i);
      box.extend(t.a).extend(t.a + t.ab).extend(t.a + t.ac);
    });
    const int child = count == 1 ? ~*ends[k] : add_node(ends[k], ends[k + 1]);
    Node& node = nodes_[index];
    node.low.row(k) = box.min().transpose();
    node.high.row(k) = box.max().transpose();
    node.children[k] = child;
  }
  return static_cast<int>(index);
}

/// Sorts triangles into halves across the direction in which they are spread most.
ClearanceTree::Iterator ClearanceTree::halve(Iterator begin, Iterator end) const {
  const Iterator half = begin + (end - begin) / 2;
  Eigen::AlignedBox3d middles;
  std::for_each(begin, end, [&](int i) { middles.extend(triangle(i).middle); });
  Eigen::Index axis = 0;
  middles.sizes().maxCoeff(&axis);
  std::nth_element(begin, half, end, [&](int i, int k) {
    return triangle(i).middle[axis] < triangle(k).middle[axis];
  });
  return half;
}

ClearanceTree::Squares ClearanceTree::Node::squared_distances(const Vector3d& point) const {
  Squares squares = Squares::Zero();
  for (int axis = 0; axis < 3; ++axis)
    squares += (low.col(axis) - point[axis]).max(point[axis] - high.col(axis)).max(0).square();
  return squares;
}

/// Searches the boxes that are nearer than the best triangle, the nearest first, until that is near
/// enough.
void ClearanceTree::search(const Node& node, const Vector3d& point, double enough,
                           NearTriangle& best) const {
  Squares squares = node.squared_distances(point);
  Eigen::Index nearest = 0;
  while (best.squared > enough && squares.minCoeff(&nearest) < best.squared) {
    squares[nearest] = kNowhere;
    const int child = node.children[nearest];
    if (child >= 0) {
      search(nodes_[child], point, enough, best);
    } else {
      const double squared = squared_distance(triangle(~child), point);
      if (squared < best.squared) best = {~child, squared};
    }
  }
}

NearTriangle ClearanceTree::nearest(const Vector3d& point, int hint, double enough) const {
  NearTriangle best{hint, squared_distance(triangle(hint), point)};
  search(root(), point, enough, best);
  return best;
}

double ClearanceTree::distance(const Vector3d& point, double limit) const {
  NearTriangle best{-1, (limit + kBeyond) * (limit + kBeyond)};
  search(root(), point, 0, best);
  const double distance = std::sqrt(best.squared);
  return best.triangle < 0 || distance > limit ? kNowhere : distance;
}

}  // namespace graspless::collision
