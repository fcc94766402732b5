// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Nodes as numbers, and the heuristic (11).
#include <algorithm>
#include <stdexcept>
#include <string>

#include "fingertip/search/graph_search.hpp"

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

Heuristic::Heuristic(const PathQuery& query, bool is_on) : query_(query), is_on_(is_on) {
  if (!is_on) return;
  const int L = query.locations.size();
  remaining_.assign(static_cast<std::size_t>(query.num_poses() * L), 0);
  for (int arc = query.num_arcs(); arc-- > 0;) {
    for (int l = 0; l < L; ++l) {
      const auto here = static_cast<std::size_t>(arc * L + l);
      remaining_[here] = remaining_[here + static_cast<std::size_t>(L)] +
                         query.options.samples_per_arc * query.displacement(arc, l);
    }
  }
}

double Heuristic::operator()(const Node& node) const {
  if (!is_on_) return 0;
  const double X_regr = query_.options.regrasp_cost;
  const int goal = query_.num_arcs(), L = query_.locations.size();
  double displacement = 0;  // max_i |Delta q*_i|
  int n_regr = 0;
  for (int i = 0; i < num_fingers(node.placement); ++i) {
    const int l = node.placement[static_cast<std::size_t>(i)];
    if (!query_.is_clear(goal, l)) ++n_regr;
    displacement = std::max(displacement, remaining_[static_cast<std::size_t>(node.pose * L + l)]);
  }
  // (11) as printed takes the displacement; to regrasp may be cheaper.
  return n_regr > 0 ? n_regr * X_regr : std::min(displacement, X_regr);
}

}  // namespace graspless::fingertip
