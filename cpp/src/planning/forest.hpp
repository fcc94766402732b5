// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include <ompl/base/SpaceInformation.h>

namespace graspless::planning {

/// Trees in one array of nodes. A root is its own parent. Owns its states.
class Forest {
 public:
  explicit Forest(ompl::base::SpaceInformationPtr si) : si_(std::move(si)) {}
  ~Forest() {
    for (const Node& node : nodes_) si_->freeState(node.state);
  }
  Forest(const Forest&) = delete;
  Forest& operator=(const Forest&) = delete;

  int add_root(const ompl::base::State* state) {
    const int node = size();
    nodes_.push_back({si_->cloneState(state), node, node});
    roots_.push_back(node);
    return node;
  }
  int add(const ompl::base::State* state, int parent) {
    nodes_.push_back({si_->cloneState(state), parent, root(parent)});
    return size() - 1;
  }

  /// NearestTree() of Algorithm 1: the nearest node of the whole forest, or -1 if it is empty. A
  /// linear scan: the forests of a query hold a few thousand nodes, and a scan breaks ties the same
  /// way in every run.
  int nearest(const ompl::base::State* state) const {
    int best = -1;
    double least = 0;
    for (int i = 0; i < size(); ++i) {
      const double d = si_->distance(nodes_[i].state, state);
      if (best < 0 || d < least) {
        least = d;
        best = i;
      }
    }
    return best;
  }

  int size() const { return static_cast<int>(nodes_.size()); }
  const std::vector<int>& roots() const { return roots_; }
  const ompl::base::State* state(int node) const { return nodes_[node].state; }
  int parent(int node) const { return nodes_[node].parent; }
  int root(int node) const { return nodes_[node].root; }

  /// Returns the nodes between two nodes of one tree, both included.
  std::vector<int> path(int from, int to) const {
    std::vector<int> up = to_root(from), down = to_root(to);
    while (up.size() > 1 && down.size() > 1 && up[up.size() - 2] == down[down.size() - 2]) {
      up.pop_back();
      down.pop_back();
    }
    up.insert(up.end(), down.rbegin() + 1, down.rend());
    return up;
  }

 private:
  struct Node {
    ompl::base::State* state;
    int parent, root;
  };
  std::vector<int> to_root(int node) const {
    std::vector<int> nodes{node};
    while (parent(nodes.back()) != nodes.back()) nodes.push_back(parent(nodes.back()));
    return nodes;
  }

  ompl::base::SpaceInformationPtr si_;
  std::vector<Node> nodes_;
  std::vector<int> roots_;
};

}  // namespace graspless::planning
