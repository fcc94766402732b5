// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "fingertip/model/pose_graph.hpp"
#include "text.hpp"

namespace graspless::fingertip {

/// A node of the graph as one number: pose, placement and the number of regrasps so far (where
/// that is limited). A placement with fewer fingers than the hand has is a hub: the fingers that a
/// regrasp keeps.
class NodeCode {
 public:
  /// Throws std::invalid_argument if there are more nodes than numbers.
  NodeCode(int num_poses, int num_locations, int num_fingers, int num_layers)
      : base_(static_cast<std::uint64_t>(num_locations) + 1),
        layers_(static_cast<std::uint64_t>(num_layers)),
        num_fingers_(num_fingers) {
    double count = static_cast<double>(num_poses) * num_layers;
    for (int i = 0; i < num_fingers; ++i) count *= num_locations + 1;
    if (count < 1e19) return;
    throw std::invalid_argument("the graph has " + figure(count) +
                                " nodes, more than can be numbered: take fewer locations");
  }

  std::uint64_t pack(const Node& node, int layer) const {
    std::uint64_t code =
        static_cast<std::uint64_t>(node.pose) * layers_ + static_cast<std::uint64_t>(layer);
    for (int i = 0; i < num_fingers_; ++i) {
      const std::int32_t location = node.placement[i];
      code = code * base_ + static_cast<std::uint64_t>(location + 1);
    }
    return code;
  }

  Node unpack(std::uint64_t code, int* layer) const {
    Node node{0, kNoFingers};
    for (int i = num_fingers_; i-- > 0; code /= base_) {
      node.placement[i] = static_cast<std::int32_t>(code % base_) - 1;
    }
    *layer = static_cast<int>(code % layers_);
    node.pose = static_cast<int>(code / layers_);
    return node;
  }

 private:
  std::uint64_t base_, layers_;
  int num_fingers_;
};

/// Costs and parents of a search's nodes by their codes: a flat hash table with open addressing,
/// which takes a third of the memory and time of std::unordered_map.
class NodeTable {
 public:
  static constexpr std::uint64_t kNone = ~std::uint64_t{0};
  struct Entry {
    std::uint64_t code = kNone;
    std::uint64_t parent = kNone;
    double cost = 0;
  };

  NodeTable() : entries_(std::size_t{1} << 12U) {}

  /// The node's entry, or the empty one (code kNone) that would be its own.
  Entry& find(std::uint64_t code) {
    std::size_t i = hash(code);
    while (entries_[i].code != kNone && entries_[i].code != code) i = (i + 1) & mask();
    return entries_[i];
  }
  /// Enters a node or a cheaper path to it; false if the path is no cheaper than the known one.
  bool improve(std::uint64_t code, std::uint64_t parent, double cost) {
    Entry& entry = find(code);
    const bool is_new = entry.code == kNone;
    if (!is_new && entry.cost <= cost) return false;
    entry = {code, parent, cost};
    if (is_new && 2 * ++size_ > entries_.size()) grow();
    return true;
  }
  std::size_t memory() const { return entries_.size() * sizeof(Entry); }  // [bytes]

 private:
  std::size_t mask() const { return entries_.size() - 1; }
  std::size_t hash(std::uint64_t code) const {
    code *= 0x9E3779B97F4A7C15U;
    return static_cast<std::size_t>(code ^ (code >> 32U)) & mask();
  }
  void grow() {
    std::vector<Entry> old(2 * entries_.size());
    old.swap(entries_);
    for (const Entry& entry : old) {
      if (entry.code != kNone) find(entry.code) = entry;
    }
  }
  std::vector<Entry> entries_;
  std::size_t size_ = 0;
};

}  // namespace graspless::fingertip
