// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/free_space/link_spheres.hpp"

#include <algorithm>

namespace graspless::clasp {
namespace {

using Spheres = std::vector<Sphere>;

/// Builds a tree over spheres by recursive bisection along the longest side.
class TreeBuilder {
 public:
  explicit TreeBuilder(const std::vector<CoveredShape>& shapes) : shapes_(shapes) {
    for (const CoveredShape& shape : shapes) {
      leaves_.insert(leaves_.end(), shape.spheres.begin(), shape.spheres.end());
    }
  }

  SphereTree build() {
    if (!leaves_.empty()) add(leaves_.begin(), leaves_.end());
    return std::move(tree_);
  }

 private:
  double depth(const Eigen::Vector3d& p) const {
    double deepest = -1;
    for (const CoveredShape& shape : shapes_) deepest = std::max(deepest, shape.depth(p));
    return deepest > 0 ? deepest : -1;
  }

  void add(Spheres::iterator begin, Spheres::iterator end) {
    Eigen::Vector3d low = begin->center, high = low;
    for (auto leaf = begin; leaf != end; ++leaf) {
      low = low.cwiseMin(leaf->center);
      high = high.cwiseMax(leaf->center);
    }
    const Eigen::Vector3d middle = (low + high) / 2;
    double outer = 0;
    for (auto leaf = begin; leaf != end; ++leaf) {
      outer = std::max(outer, (leaf->center - middle).norm() + leaf->radius);
    }
    const std::size_t node = tree_.size();
    tree_.push_back({middle, outer, depth(middle), 0});
    if (end - begin > 1) {
      Eigen::Index axis = 0;
      (high - low).maxCoeff(&axis);
      const auto half = begin + (end - begin) / 2;
      std::nth_element(begin, half, end, [axis](const Sphere& a, const Sphere& b) {
        return a.center[axis] < b.center[axis];
      });
      add(begin, half);
      add(half, end);
    }
    tree_[node].next = static_cast<int>(tree_.size());
  }

  const std::vector<CoveredShape>& shapes_;
  Spheres leaves_;
  SphereTree tree_;
};

}  // namespace

SphereTree sphere_tree(const std::vector<CoveredShape>& shapes) {
  return TreeBuilder(shapes).build();
}

std::vector<SphereTree> link_spheres(const robot::Robot& robot) {
  std::vector<std::vector<CoveredShape>> shapes(robot.frame_names().size());
  for (const robot::LinkShape& shape : robot.shapes()) {
    shapes[shape.link].push_back(covered(shape.placed, MeshInside::hollow));
  }
  std::vector<SphereTree> trees;
  for (const auto& of_link : shapes) trees.push_back(sphere_tree(of_link));
  return trees;
}

}  // namespace graspless::clasp
