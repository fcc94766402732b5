// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "fingertip/lattice/space.hpp"

namespace graspless::fingertip {

/// How far a fingertip's sphere has to go at least from each pose to the goal, along the lattice
/// and round what stops the object, whatever its stability. Worked out for each location when asked
/// for; locations one above the other share a table.
class LatticeDistances {
 public:
  LatticeDistances(LatticeSpace& space, const Locations& locations);

  /// Of every pose; infinite where a way from the start to the goal costs `limit` or more. Limits
  /// may only fall from call to call.
  const double* to_goal(int location, double limit);

  std::int64_t memory() const;

 private:
  struct Entry {
    double distance;
    int pose;
    // The top of a std heap is its greatest.
    bool operator<(const Entry& other) const { return distance > other.distance; }
  };
  std::vector<double> search(int location, double limit);

  LatticeSpace& space_;
  std::vector<int> table_of_;  // locations
  std::vector<std::vector<double>> tables_;
  std::vector<Entry> heap_;
};

}  // namespace graspless::fingertip
