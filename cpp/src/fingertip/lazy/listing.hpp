// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "fingertip/lazy/state.hpp"

namespace graspless::fingertip {

/// Placements that can carry the object all the way, as far as bounds at a few instants tell. Where
/// one instant tells all, as in a slide, the most stable ones come first: of four fingers there are
/// many millions, and all but a few cost more than the best.
class Listing {
 public:
  explicit Listing(LazyState& lazy);

  /// True if next() begins anew, and what it found before is void. Bounds that have risen do not
  /// tell which placements have been found.
  bool begins_anew() const;
  /// Calls found(placement, cost) for some more.
  void next(const std::function<void(const Placement&, double)>& found);
  /// No placement that next() has still to find costs less; infinite if there is none.
  double least_cost() const { return least_cost_; }
  /// A placement's least cost all the way, without a look at each arc. Infinite if it cannot be, or
  /// if next() will find it again.
  double cost(const Placement& placement) const;

 private:
  double cost_at(double displacement, float z) const;
  float next_level() const;
  float greatest_bound() const;
  float needed() const;

  LazyState& lazy_;
  std::vector<int> instants_, clear_;
  bool single_;  // there is one instant alone
  float level_;  // placements whose bound is as much have been found
  double least_cost_;
};

}  // namespace graspless::fingertip
