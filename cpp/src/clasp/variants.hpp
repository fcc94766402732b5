// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "clasp/grip.hpp"
#include "clasp/search/clasp_search.hpp"

namespace graspless::clasp {

/// Start configuration with the hand in its pre-shape; nothing if it cannot open without collision.
std::optional<Eigen::VectorXd> opened(Query& query);

/// Searches for what the hand does not clasp with all its fingers from its first pre-shape: from
/// its other pre-shapes and, where the hole is small for the hand, with fewer fingers and with a
/// finger put through the hole.
class Variants {
 public:
  /// Number of cycles a loop after which a hand that has clasped nothing tries them, too.
  static constexpr std::size_t kPatience = 20;

  /// The plan is warned of pre-shapes to which the hand cannot open. Later calls add nothing.
  void add_to(std::vector<std::unique_ptr<ClaspSearch>>& searches, Query& all, Plan& plan);
  /// Adds the counters of these searches.
  void report_to(Query& all) const;

 private:
  void add(const Problem& problem, const std::vector<std::string>& fingers,
           const std::string& pre_shape, Query& all,
           std::vector<std::unique_ptr<ClaspSearch>>& searches, Plan& plan);

  std::deque<Grip> grips_;  // deques, as queries and searches keep references
  std::deque<Query> queries_;
  bool are_added_ = false;
};

}  // namespace graspless::clasp
