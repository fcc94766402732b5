// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <unordered_map>

#include "fingertip/instants.hpp"
#include "fingertip/locations.hpp"

namespace graspless::fingertip {

/// The stability of placements at instants, each solved once. One a thread.
class Evaluator {
 public:
  Evaluator(const Instants& instants, const Locations& locations, const Options& options);

  /// z with the best control modes, when it is at least min_stability; else 0.
  double stability(int instant, const Placement& placement);
  /// Known already? Then as stability(), without work; else -1.
  double known(int instant, const Placement& placement) const;
  /// All of it: modes and commanded forces too. Ties as mechanics::best_control_modes says.
  mechanics::ControlModes control_modes(int instant, const Placement& placement,
                                        const std::vector<FingerMode>& previous);

  mechanics::StabilitySolver& solver() { return solver_; }

 private:
  struct Key {
    int instant;
    Placement placement;
    bool operator==(const Key& other) const {
      return instant == other.instant && placement == other.placement;
    }
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  const Instants& instants_;
  const Locations& locations_;
  const Options& options_;
  mechanics::StabilitySolver solver_;
  std::unordered_map<Key, double, Hash> known_;
};

}  // namespace graspless::fingertip
