// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "fingertip/model/instants.hpp"
#include "fingertip/model/locations.hpp"

namespace graspless::fingertip {

/// The stability of placements at instants, each solved once. One a thread.
class Evaluator {
 public:
  Evaluator(const Instants& instants, const Locations& locations, const Options& options);

  /// z with the best control modes, when it is at least min_stability; else 0. Below `needed`, it
  /// may be an upper bound that is below `needed`, too.
  double stability(int instant, const Placement& placement, double needed = 0);
  /// Known already? Then as stability(), without work; else -1.
  double known(int instant, const Placement& placement) const;
  /// All of it but the binding directions: modes and commanded forces too, for fingers at these
  /// locations in any order, when z is at least min_stability. Ties as
  /// mechanics::best_control_modes says.
  mechanics::ControlModes control_modes(int instant, const std::vector<int>& fingers,
                                        const std::vector<FingerMode>& previous);
  /// Takes over what another one knows of a placement at an instant, if it does.
  void adopt(const Evaluator& other, int instant, const Placement& placement);
  /// Forgets what is known, after Instants::add_friction().
  void forget();

  mechanics::StabilitySolver& solver() { return solver_; }
  const Instants& instants() const { return instants_; }
  const mechanics::StabilitySolver& solver() const { return solver_; }

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
  using Best = mechanics::StabilitySolver::Best;
  struct Known {
    double z;  // 0: below min_stability
    int best;  // index into bests_; -1: none
  };
  Known solve(int instant, const Placement& placement, double needed = 0);
  void set(int instant, const Placement& placement);
  const Instants& instants_;
  const Locations& locations_;
  const Options& options_;
  mechanics::StabilitySolver solver_;
  std::unordered_map<Key, Known, Hash> known_;
  std::vector<Best> bests_;                                          // of what is stable
  std::vector<const mechanics::EnvironmentWrenches*> environments_;  // scratch
  std::vector<const mechanics::FingerWrenches*> fingers_;            // scratch
};

/// The contact set of an instant with fingers at these locations.
mechanics::ContactSet contact_set(const Instant& instant, const Locations& locations,
                                  const Fingers& fingers, const std::vector<int>& at);

}  // namespace graspless::fingertip
