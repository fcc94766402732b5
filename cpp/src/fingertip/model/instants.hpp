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
  mechanics::ContactSet set;    // without fingers, friction at the nominal (lower) coefficient
  std::vector<int> surfaces;    // of each contact: index into Instants::frictions()
  bool turns_in_plane = false;  // a face turns about its normal while it slides
  // One for each choice of environment coefficients that is checked: both ends of the intervals,
  // and counter-examples found later. Cones that may only help are taken at the lower end, and
  // those that may jam at the upper. Only contacts that slide follow the coefficients.
  std::vector<mechanics::EnvironmentWrenches> environments;
};

/// The planes as mechanics sees them, with friction at the lower end.
std::vector<mechanics::Plane> contact_planes(const Problem& problem);

/// True if a plane has no friction of its own.
bool shares_friction(const Problem& problem);

/// Number of coefficients between object and planes of which only bounds are known.
int num_intervals(const Problem& problem);

/// True if the planes alone balance the object's weight at this pose, with friction at the lower
/// ends of its intervals.
bool stands_alone(const Problem& problem, const Eigen::Isometry3d& X_WO);

/// The distinct instants of a problem.
class Instants {
 public:
  Instants(const Problem& problem, const Options& options);

  /// The instant of this state; made when no equal one is there (to 1e-9 of the object's size).
  /// Throws std::invalid_argument with the reason when its contacts cannot be represented by
  /// points, or there is none.
  int add(const mechanics::BodyState& state);
  const Instant& operator[](int i) const { return all_[i]; }
  int size() const { return static_cast<int>(all_.size()); }

  /// Friction of each surface: first that of the problem, which planes without their own share,
  /// then that of each plane with its own.
  const std::vector<FrictionInterval>& frictions() const { return frictions_; }
  /// From now on also checks these coefficients, one for each surface.
  void add_friction(const std::vector<double>& coefficients);

  const Problem& problem() const { return problem_; }
  const Options& options() const { return options_; }

 private:
  mechanics::EnvironmentWrenches wrenches(const Instant& instant,
                                          const std::vector<double>& sliding,
                                          double FrictionInterval::*sticking) const;
  void add_environment(Instant& instant, const std::vector<double>& coefficients) const;
  const Problem& problem_;
  const Options& options_;
  mechanics::Matrix6d wrench_scale_;
  std::vector<mechanics::Plane> planes_;
  std::vector<FrictionInterval> frictions_;
  std::vector<int> surface_of_plane_;
  std::vector<std::vector<double>> coefficients_;  // that are checked
  std::vector<Instant> all_;
  std::vector<std::vector<double>> keys_;  // contents in units of their size, for comparison
};

}  // namespace graspless::fingertip
