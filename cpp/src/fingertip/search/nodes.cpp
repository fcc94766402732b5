// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/search/nodes.hpp"

#include <stdexcept>
#include <string>

namespace graspless::fingertip {

NodeCode::NodeCode(int num_poses, int num_locations, int num_fingers, int num_layers)
    : base_(static_cast<std::uint64_t>(num_locations) + 1),
      layers_(static_cast<std::uint64_t>(num_layers)),
      num_fingers_(num_fingers) {
  double count = static_cast<double>(num_poses) * num_layers;
  for (int i = 0; i < num_fingers; ++i) count *= num_locations + 1;
  if (count < 1e19) return;
  throw std::invalid_argument("the graph has " + std::to_string(count) +
                              " nodes, more than can be numbered: take fewer locations");
}

std::uint64_t NodeCode::pack(const Node& node, int layer) const {
  std::uint64_t code =
      static_cast<std::uint64_t>(node.pose) * layers_ + static_cast<std::uint64_t>(layer);
  for (int i = 0; i < num_fingers_; ++i) {
    code =
        code * base_ + static_cast<std::uint64_t>(node.placement[static_cast<std::size_t>(i)] + 1);
  }
  return code;
}

Node NodeCode::unpack(std::uint64_t code, int* layer) const {
  Node node{0, kNoFingers};
  for (int i = num_fingers_; i-- > 0; code /= base_) {
    node.placement[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(code % base_) - 1;
  }
  *layer = static_cast<int>(code % layers_);
  node.pose = static_cast<int>(code / layers_);
  return node;
}

}  // namespace graspless::fingertip
