// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// All placements that the bounds allow, finger by finger.
#include <algorithm>
#include <array>

#include "fingertip/lazy/candidates.hpp"

namespace graspless::fingertip {

namespace {

using Step = Supports::Step;

/// Depth-first over fingers. Sums of the table's rows over the fingers so far bound what any
/// completion can reach: those with the best location for each missing finger.
class Enumeration {
 public:
  Enumeration(const PathQuery& query, const Supports& supports, int count,
              const std::vector<int>& locations, const std::vector<int>& instants,
              const std::function<bool(const Placement&)>& found)
      : query_(query),
        supports_(supports),
        count_(count),
        locations_(locations),
        instants_(instants),
        found_(found),
        needed_(static_cast<float>(query.options.min_stability)),
        used_(supports.used(instants.front())) {
    sums_.resize(static_cast<std::size_t>(count + 1) * static_cast<std::size_t>(used_));
    best_.assign(static_cast<std::size_t>(used_), 0.0F);
    for (int k = 0; k < used_; ++k) sum(0)[k] = supports.offsets(instants.front())[k];
    if (used_ == 0) return;
    for (const int location : locations) {
      const float* h = supports.block(instants.front(), location);
      for (int k = 0; k < used_; ++k)
        best_[static_cast<std::size_t>(k)] = std::max(best_[static_cast<std::size_t>(k)], h[k]);
    }
  }

  bool run() { return place(0, 0); }

 private:
  float* sum(int depth) {
    return sums_.data() + static_cast<std::size_t>(depth) * static_cast<std::size_t>(used_);
  }

  bool is_apart(int depth, int location) const {
    for (int i = 0; i < depth && i < mechanics::kMaxFingers; ++i) {
      if (!query_.locations.are_apart(placement_[static_cast<std::size_t>(i)], location)) {
        return false;
      }
    }
    return true;
  }

  // Whether the sums with `missing` more fingers at their best reach what is needed.
  bool extend(int depth, int location, int missing) {
    if (used_ == 0) return true;
    const float* h = supports_.block(instants_.front(), location);
    for (int i = 0; i < used_; i += kStep) {
      Eigen::Map<Step> to(sum(depth + 1) + i);
      to = Eigen::Map<const Step>(sum(depth) + i) + Eigen::Map<const Step>(h + i);
      const Step reach =
          to + static_cast<float>(missing) * Eigen::Map<const Step>(best_.data() + i);
      if (reach.minCoeff() < needed_) return false;
    }
    return true;
  }

  bool place(int depth, std::size_t first) {
    if (depth >= count_ || depth >= mechanics::kMaxFingers) return accept();
    const int missing = count_ - depth - 1;
    for (std::size_t i = first; i + static_cast<std::size_t>(missing) < locations_.size(); ++i) {
      if (!extend(depth, locations_[i], missing) || !is_apart(depth, locations_[i])) continue;
      placement_[static_cast<std::size_t>(depth)] = locations_[i];
      if (!place(depth + 1, i + 1)) return false;
      placement_[static_cast<std::size_t>(depth)] = -1;
    }
    return true;
  }

  bool accept() {
    for (std::size_t i = 1; i < instants_.size(); ++i) {
      if (supports_.bound(instants_[i], placement_) < needed_) return true;
    }
    return found_(placement_);
  }

  const PathQuery& query_;
  const Supports& supports_;
  const int count_;
  const std::vector<int>& locations_;
  const std::vector<int>& instants_;
  const std::function<bool(const Placement&)>& found_;
  const float needed_;
  const int used_;
  std::vector<float> sums_, best_;
  Placement placement_ = kNoFingers;
};

}  // namespace

void for_each_placement(const PathQuery& query, const Supports& supports, int count,
                        const std::vector<int>& locations, const std::vector<int>& instants,
                        const std::function<bool(const Placement&)>& found) {
  Enumeration(query, supports, count, locations, instants, found).run();
}

}  // namespace graspless::fingertip
