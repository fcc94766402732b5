// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "fingertip/model/evaluator.hpp"
#include "fingertip/model/pose_graph.hpp"

namespace graspless::fingertip {

/// Stabilities of placements at instants that keep coming: solved when they must be known, bounded
/// from above until then. For any y with y . g <= 0 for all generators g of an instant's
/// environment, z <= (y . known + sum over fingers of h(y, location)) / max over d of y . l_d: what
/// one solution teaches bounds other placements, and other instants for which y is as good.
class LatticeBounds {
 public:
  LatticeBounds(const PoseGraph& graph, Evaluator& evaluator);

  /// At least z.
  double bound(int instant, const Placement& placement);
  /// z when it is at least min_stability, else 0.
  double solve(int instant, const Placement& placement);

  std::int64_t count() const { return count_; }  // of functionals in the tables
  std::int64_t memory() const;

 private:
  static constexpr int kWidth = 32;     // functionals an instant
  static constexpr int kMaxPool = 512;  // functionals offered to instants met later

  struct Table {
    std::vector<float> h;        // locations x kWidth
    std::vector<float> offsets;  // kWidth
    int size = 0, oldest = 0;
  };
  Table& table(int instant);
  void learn(int instant, const mechanics::Vector6d& y, const Placement& placement);
  bool store(int instant, Table& table, const mechanics::Vector6d& y, const Placement* placement);
  float row(const mechanics::Vector6d& y);

  const Locations& locations_;
  const Options& options_;
  Evaluator& evaluator_;
  std::vector<Table> tables_;  // instants
  std::vector<mechanics::Vector6d> pool_;
  std::vector<float> edges_;  // f_max c_j / normal_j: edge, component, location
  int num_edges_ = 0;
  std::vector<float> row_;  // h of one functional
  std::int64_t count_ = 0;
};

}  // namespace graspless::fingertip
