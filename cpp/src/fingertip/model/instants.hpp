// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/fingertip/fingertip.hpp"
#include "graspless/mechanics/contact_patch.hpp"
#include "graspless/mechanics/stability_solver.hpp"

namespace graspless::fingertip {

/// A vertex within this part of the object's size of a plane touches it.
constexpr double kContactTolerance = 1e-6;

/// An instant of the object's motion without its fingers. Equal mechanics, equal instant: a slide
/// has one for all its samples, a tumble one a sample.
struct Instant {
  mechanics::ContactSet set;  // without fingers, friction at the nominal (lower) coefficient
  // One for each environment coefficient that is looked at: both ends of the interval, and
  // counter-examples found later. Cones that may only help are taken at the lower end, and those
  // that may jam at the upper: contacts that slide alone follow the coefficient.
  std::vector<mechanics::EnvironmentWrenches> environments;
};

/// The planes as mechanics sees them, with this coefficient of friction.
std::vector<mechanics::Plane> contact_planes(const Problem& problem, double friction);

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

  const Problem& problem() const { return problem_; }
  const Options& options() const { return options_; }

 private:
  void add_environment(Instant& instant, double coefficient) const;
  const Problem& problem_;
  const Options& options_;
  mechanics::Matrix6d wrench_scale_;
  std::vector<mechanics::Plane> planes_;
  std::vector<double> frictions_;
  std::vector<Instant> all_;
  std::vector<std::vector<double>> keys_;  // contents in units of their size, for comparison
  bool turns_in_plane_ = false;
};

}  // namespace graspless::fingertip
