// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "graspless/fingertip/fingertip.hpp"
#include "graspless/mechanics/contact_patch.hpp"
#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::fingertip {

/// An instant of the object's motion without its fingers. Equal mechanics, equal instant: a slide
/// has one for all its samples, a tumble one a sample.
struct Instant {
  mechanics::ContactSet set;  // without fingers, friction at the nominal (lower) coefficient
  // One for each environment coefficient that is looked at: both ends of the interval, and
  // counter-examples found later.
  std::vector<mechanics::EnvironmentWrenches> environments;
};

/// The distinct instants of a problem.
class Instants {
 public:
  Instants(const Problem& problem, const Options& options);

  /// The instant of this state; made when no equal one is there (to 1e-9 of the object's size).
  /// Throws std::invalid_argument with the reason when its contacts cannot be stood for by points,
  /// or there is none.
  int add(const mechanics::BodyState& state);
  const Instant& operator[](int i) const { return all_[static_cast<std::size_t>(i)]; }
  int size() const { return static_cast<int>(all_.size()); }
  bool turns_in_plane() const { return turns_in_plane_; }  // whether any face turned while it slid

  /// Looks at another coefficient of environment friction too from now on.
  void add_friction(double coefficient);

 private:
  const Problem& problem_;
  const Options& options_;
  mechanics::Matrix6d wrench_scale_;
  std::vector<mechanics::Plane> planes_;
  std::vector<double> frictions_;
  std::vector<Instant> all_;
  std::vector<std::vector<std::int64_t>> keys_;  // rounded contents, for comparison
  bool turns_in_plane_ = false;
};

}  // namespace graspless::fingertip
