// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(): what a plan says of itself, and the order of the examination.
#include "fingertip/check/check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"

#include "text.hpp"

namespace graspless::fingertip::checking {
namespace {

constexpr double kRound = 1e-9;  // relative

bool is_finite(const FingerState& finger) {
  return finger.p_OC.allFinite() && finger.n_O.allFinite() &&
         std::isfinite(finger.commanded_force) && finger.nominal_force_O.allFinite();
}

bool is_finite(const Row& row) {
  return row.X_WO.matrix().allFinite() && std::isfinite(row.stability) &&
         std::isfinite(row.compliant_stability) && std::isfinite(row.nominal_margin) &&
         std::isfinite(row.withstands) && std::isfinite(row.place_tolerance) &&
         std::all_of(row.fingers.begin(), row.fingers.end(),
                     [](const FingerState& finger) { return is_finite(finger); });
}

}  // namespace

Examination::Examination(const Problem& problem, const Plan& plan, const Options& options)
    : problem_(problem),
      plan_(plan),
      options_(options),
      same_length_(1e-6 * problem.object.size()),
      same_force_(1e-6 * std::max(problem.object.mass() * problem.gravity_W.norm(),
                                  problem.fingers.max_normal_force)),
      wrench_scale_(mechanics::wrench_scale(problem.object.mass(), problem.object.inertia())),
      stabilities_(options.disturbance_directions) {}

/// Runs one part of the examination. An exception is a fault: what a kernel cannot decide is not
/// proven.
template <typename Part>
void Examination::attempt(const std::string& where, const Part& part) {
  try {
    part();
  } catch (const std::logic_error& error) {
    fault(where, std::string("could not be examined: ") + error.what());
  } catch (const std::runtime_error& error) {
    fault(where, std::string("could not be examined: ") + error.what());
  }
}

Faults Examination::run() {
  if (!has_shape()) return faults_;
  check_chain();
  check_fingers();
  check_start();
  attempt("plan", [&] { check_clearances(); });
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) {
    for (std::size_t r = 0; r < segment(s).rows.size(); ++r) {
      attempt(place(s, r), [&] { check_mechanics(s, r); });
    }
  }
  check_cost();
  check_weakest();
  return faults_;
}

void Examination::fault(const std::string& where, const std::string& what) {
  faults_.push_back(where + ": " + what);
}

std::string Examination::place(std::size_t s) const {
  return "segment " + std::to_string(s) + " (" + segment(s).name + ")";
}

std::string Examination::place(std::size_t s, std::size_t row) const {
  return place(s) + ", row " + std::to_string(row);
}

bool Examination::has_shape() {
  if (!plan_) {
    fault("plan", "not solved: " + plan_.reason);
    return false;
  }
  if (plan_.segments.empty()) fault("plan", "has no segments");
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) check_shape(s);
  if (!faults_.empty()) return false;
  for (const std::size_t s : {std::size_t{0}, plan_.segments.size() - 1}) {
    if (is_regrasp(s)) fault(place(s), "a plan begins and ends with all fingers on the object");
  }
  return faults_.empty();
}

void Examination::check_shape(std::size_t s) {
  const Segment& it = segment(s);
  const bool regrasp = it.name == "regrasp";
  if (!regrasp && it.name != "slide" && it.name != "turn" && it.name != "tumble") {
    fault(place(s), "is none of slide, turn, tumble, regrasp");
  }
  if (regrasp ? it.finger < 0 || it.finger >= problem_.fingers.count : it.finger != -1) {
    fault(place(s), "has finger " + std::to_string(it.finger) + " regrasp");
  }
  const auto parts = static_cast<std::size_t>(options_.samples_per_arc);
  const std::size_t poses = it.X_WO.size();
  if (regrasp ? poses != 1 : poses < 2) fault(place(s), "has " + std::to_string(poses) + " poses");
  const std::size_t rows = regrasp ? 1 : poses < 2 ? 0 : (poses - 1) * parts;
  if (it.rows.size() != rows) {
    fault(place(s), "has " + std::to_string(it.rows.size()) + " rows, not " + std::to_string(rows));
  }
  for (std::size_t k = 0; k < poses; ++k) {
    if (!geometry::is_pose(it.X_WO[k]))
      fault(place(s), "pose " + std::to_string(k) + " is not rigid");
  }
  for (std::size_t r = 0; r < it.rows.size(); ++r) check_state(s, r);
}

/// Checks sizes, that numbers are finite, and forces against control modes.
void Examination::check_state(std::size_t s, std::size_t r) {
  const Row& row = segment(s).rows[r];
  if (row.fingers.size() != static_cast<std::size_t>(problem_.fingers.count)) {
    return fault(place(s, r), "has " + std::to_string(row.fingers.size()) + " fingers, not " +
                                  std::to_string(problem_.fingers.count));
  }
  if (!is_finite(row)) return fault(place(s, r), "has a value that is not finite");
  for (std::size_t i = 0; i < row.fingers.size(); ++i) {
    const FingerState& finger = row.fingers[i];
    const std::string who = "finger " + std::to_string(i);
    const bool lifts = segment(s).finger == static_cast<int>(i);
    if (finger.touches == lifts) {
      fault(place(s, r), who + (lifts ? " touches while it regrasps" : " does not touch"));
    }
    const double limit = finger.mode == FingerMode::force ? problem_.fingers.max_normal_force : 0.0;
    if (!finger.touches) continue;
    if (finger.commanded_force < 0 || finger.commanded_force > limit * (1 + kRound)) {
      fault(place(s, r), who + ": commanded force " + figure(finger.commanded_force) +
                             " N is not within 0 and " + figure(limit));
    }
  }
}

/// Cost (9): the path of the finger that goes farthest, weighted more where the object is less
/// stable.
double Examination::arc_cost(std::size_t s, std::size_t arc) const {
  const auto parts = static_cast<std::size_t>(options_.samples_per_arc);
  double dearest = 0;
  for (int i = 0; i < problem_.fingers.count; ++i) {
    double cost = 0;
    for (std::size_t j = 0; j < parts; ++j) {
      const Row& row = segment(s).rows[arc * parts + j];
      const Eigen::Vector3d center_O = center(row.fingers[i]);
      const Vector6d twist_O = arc_twist(s, arc);
      const Eigen::Vector3d way_O = twist_O.head<3>() + twist_O.tail<3>().cross(center_O);
      cost += (1 + options_.stability_weight / row.stability) * way_O.norm() /
              static_cast<double>(parts);
    }
    dearest = std::max(dearest, cost);
  }
  return dearest;
}

void Examination::check_cost() {
  double cost = 0;
  int regrasps = 0;
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) {
    if (is_regrasp(s)) {
      cost += options_.regrasp_cost;  // Eq. (10)
      ++regrasps;
    } else {
      for (std::size_t arc = 0; arc + 1 < segment(s).X_WO.size(); ++arc) cost += arc_cost(s, arc);
    }
  }
  if (!(std::abs(plan_.cost - cost) <= kRound * cost)) {
    fault("plan", "cost: " + figure(cost) + ", promised " + figure(plan_.cost));
  }
  if (!(plan_.lower_bound >= 0 && plan_.lower_bound <= cost * (1 + kRound))) {
    fault("plan", "lower bound " + figure(plan_.lower_bound) + " for a cost of " + figure(cost));
  }
  if (plan_.regrasps != regrasps) {
    fault("plan",
          "says " + std::to_string(plan_.regrasps) + " regrasps, has " + std::to_string(regrasps));
  }
  if (regrasps > options_.max_regrasps) {
    fault("plan", "has " + std::to_string(regrasps) + " regrasps, options.max_regrasps allows " +
                      std::to_string(options_.max_regrasps));
  }
}

void Examination::check_weakest() {
  double least = std::numeric_limits<double>::infinity(), named = least, withstands = least;
  double tolerance = least;
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) {
    for (std::size_t r = 0; r < segment(s).rows.size(); ++r) {
      const double z = segment(s).rows[r].stability;
      least = std::min(least, z);
      withstands = std::min(withstands, segment(s).rows[r].withstands);
      tolerance = std::min(tolerance, segment(s).rows[r].place_tolerance);
      const bool is_named =
          plan_.weakest_segment == static_cast<int>(s) && plan_.weakest_row == static_cast<int>(r);
      if (is_named) named = z;
    }
  }
  if (!(std::abs(plan_.withstands - withstands) <= kRound * std::max(1.0, withstands))) {
    fault("plan", "withstands: " + figure(withstands) + ", promised " + figure(plan_.withstands));
  }
  if (!(std::abs(plan_.place_tolerance - tolerance) <= kRound * tolerance)) {
    fault("plan",
          "place tolerance: " + figure(tolerance) + ", promised " + figure(plan_.place_tolerance));
  }
  if (named <= least * (1 + kRound)) return;
  fault("plan", "segment " + std::to_string(plan_.weakest_segment) + ", row " +
                    std::to_string(plan_.weakest_row) + " is not the weakest");
}

}  // namespace graspless::fingertip::checking

namespace graspless::fingertip {

std::vector<std::string> check(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem, options);
  return checking::Examination(problem, plan, options).run();
}

}  // namespace graspless::fingertip
