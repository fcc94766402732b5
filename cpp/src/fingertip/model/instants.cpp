// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The mechanics of each instant of a motion, without the fingers, kept once.
#include "fingertip/model/instants.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "graspless/mechanics/equilibrium.hpp"
#include "graspless/watch.hpp"

#include "fingertip/model/screw.hpp"
#include "mechanics/contacts/cones.hpp"
#include "mechanics/contacts/wrenches.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kEqual = 1e-9;

void append(std::vector<double>& key, const Eigen::VectorXd& values) {
  key.insert(key.end(), values.data(), values.data() + values.size());
}

/// All that tells one instant from another, in units of the object.
std::vector<double> key_of(const mechanics::ContactSet& set, double size) {
  std::vector<double> key;
  for (const mechanics::Contact& contact : set.contacts) {
    key.push_back(contact.mode == mechanics::ContactMode::slide ? 1 : 0);
    append(key, contact.p_OC / size);
    append(key, contact.n_O);
    append(key, mechanics::tangent(contact.n_O, contact.t_O));
  }
  const double weight = set.known_wrench_O.norm();
  if (weight > 0) append(key, set.known_wrench_O / weight);
  return key;
}

bool are_equal(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) {
           return std::abs(x - y) <= kEqual;
         });
}

/// Throws std::invalid_argument when points cannot represent the contacts, or there is none.
mechanics::ContactPatches patches_at(const Problem& problem,
                                     const std::vector<mechanics::Plane>& planes,
                                     const mechanics::BodyState& state) {
  const Object& object = problem.object;
  mechanics::ContactPatches patches = mechanics::contact_patches(
      object.hull(), object.com(), planes, state, kContactTolerance * object.size());
  if (!patches.fault.empty()) throw std::invalid_argument("motion: " + patches.fault);
  if (patches.contacts.empty()) {
    throw std::invalid_argument("motion: the object floats, touching no plane");
  }
  return patches;
}

/// These contacts, and the object's weight.
mechanics::ContactSet loaded(const Problem& problem, const Eigen::Isometry3d& X_WO,
                             std::vector<mechanics::Contact> contacts) {
  mechanics::ContactSet set;
  set.contacts = std::move(contacts);
  set.com_O = problem.object.com();
  set.known_wrench_O = mechanics::gravity_wrench(problem.object.mass(),
                                                 X_WO.linear().transpose() * problem.gravity_W);
  return set;
}

}  // namespace

std::vector<mechanics::Plane> contact_planes(const Problem& problem) {
  std::vector<mechanics::Plane> planes;
  for (const Plane& plane : problem.planes) {
    const FrictionInterval friction = plane.friction.value_or(problem.friction);
    planes.push_back({plane.name, plane.n_W.normalized(), plane.offset, friction.lower});
  }
  return planes;
}

bool shares_friction(const Problem& problem) {
  return std::any_of(problem.planes.begin(), problem.planes.end(),
                     [](const Plane& plane) { return !plane.friction; });
}

int num_intervals(const Problem& problem) {
  const FrictionInterval& shared = problem.friction;
  int count = shares_friction(problem) && shared.lower < shared.upper ? 1 : 0;
  for (const Plane& plane : problem.planes) {
    count += plane.friction && plane.friction->lower < plane.friction->upper ? 1 : 0;
  }
  return count;
}

bool stands_alone(const Problem& problem, const Eigen::Isometry3d& X_WO) {
  const mechanics::BodyState state = resting_state(X_WO, mechanics::Vector6d::Zero());
  const mechanics::ContactSet set =
      loaded(problem, X_WO, patches_at(problem, contact_planes(problem), state).contacts);
  return mechanics::interior_equilibrium(mechanics::with_round_cones(set), {}, {}).has_value();
}

Instants::Instants(const Problem& problem, const Options& options)
    : problem_(problem),
      options_(options),
      wrench_scale_(mechanics::wrench_scale(problem.object.mass(), problem.object.inertia())),
      planes_(contact_planes(problem)),
      frictions_{problem.friction} {
  if (!shares_friction(problem)) frictions_[0].upper = frictions_[0].lower;  // of no contact
  for (const Plane& plane : problem.planes) {
    surface_of_plane_.push_back(plane.friction ? static_cast<int>(frictions_.size()) : 0);
    if (plane.friction) frictions_.push_back(*plane.friction);
  }
  std::vector<double> lower, upper;
  for (const FrictionInterval& friction : frictions_) {
    lower.push_back(friction.lower);
    upper.push_back(friction.upper);
  }
  coefficients_ = {lower};
  if (num_intervals(problem) > 0) coefficients_.push_back(upper);
}

int Instants::add(const mechanics::BodyState& state) {
  poll();
  mechanics::ContactPatches patches = patches_at(problem_, planes_, state);
  Instant instant;
  instant.set = loaded(problem_, state.X_WO, std::move(patches.contacts));
  for (const int plane : patches.plane) {
    instant.surfaces.push_back(surface_of_plane_[plane]);
  }
  instant.set.wrench_scale = wrench_scale_;
  instant.set.cone_edges = options_.cone_edges;
  instant.turns_in_plane = patches.turns_in_plane;

  std::vector<double> key = key_of(instant.set, problem_.object.size());
  key.insert(key.end(), instant.surfaces.begin(), instant.surfaces.end());
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (are_equal(keys_[i], key)) return static_cast<int>(i);
  }
  for (const auto& coefficients : coefficients_) add_environment(instant, coefficients);
  all_.push_back(std::move(instant));
  keys_.push_back(std::move(key));
  return size() - 1;
}

/// R^1/2 W C of all contacts. Those that slide have the given coefficients, those that stick the
/// ends of their intervals.
mechanics::EnvironmentWrenches Instants::wrenches(const Instant& instant,
                                                  const std::vector<double>& sliding,
                                                  double FrictionInterval::*sticking) const {
  mechanics::ContactSet set = instant.set;
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    const auto surface = static_cast<std::size_t>(instant.surfaces[i]);
    const bool slides = set.contacts[i].mode == mechanics::ContactMode::slide;
    set.contacts[i].friction = slides ? sliding[surface] : frictions_[surface].*sticking;
  }
  return mechanics::wrenches_of_environment(set);
}

void Instants::add_environment(Instant& instant, const std::vector<double>& coefficients) const {
  instant.environments.push_back(wrenches(instant, coefficients, &FrictionInterval::lower));
  if (num_intervals(problem_) > 0) {
    instant.environments.back().jam_generators =
        wrenches(instant, coefficients, &FrictionInterval::upper).generators;
  }
}

void Instants::add_friction(const std::vector<double>& coefficients) {
  coefficients_.push_back(coefficients);
  for (Instant& instant : all_) {
    poll();
    add_environment(instant, coefficients);
  }
}

}  // namespace graspless::fingertip
