// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The mechanics of each instant of a motion, without the fingers, kept once.
#include "fingertip/model/instants.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

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

/// R^1/2 W C of all contacts; those that slide have one coefficient, those that stick another.
mechanics::EnvironmentWrenches wrenches(mechanics::ContactSet set, double slide, double stick) {
  for (mechanics::Contact& contact : set.contacts) {
    contact.friction = contact.mode == mechanics::ContactMode::slide ? slide : stick;
  }
  return mechanics::environment_wrenches(set);
}

}  // namespace

std::vector<mechanics::Plane> contact_planes(const Problem& problem, double friction) {
  std::vector<mechanics::Plane> planes;
  for (const Plane& plane : problem.planes) {
    planes.push_back({plane.name, plane.n_W.normalized(), plane.offset, friction});
  }
  return planes;
}

Instants::Instants(const Problem& problem, const Options& options)
    : problem_(problem),
      options_(options),
      wrench_scale_(mechanics::wrench_scale(problem.object.mass(), problem.object.inertia())),
      planes_(contact_planes(problem, problem.friction.lower)),
      frictions_{problem.friction.lower} {
  if (problem.friction.upper > problem.friction.lower) {
    frictions_.push_back(problem.friction.upper);
  }
}

int Instants::add(const mechanics::BodyState& state) {
  const Object& object = problem_.object;
  mechanics::ContactPatches patches = mechanics::contact_patches(
      object.hull(), object.com(), planes_, state, kContactTolerance * object.size());
  if (!patches.fault.empty()) throw std::invalid_argument("motion: " + patches.fault);
  if (patches.contacts.empty()) {
    throw std::invalid_argument("motion: the object floats, touching no plane");
  }
  Instant instant;
  instant.set.contacts = std::move(patches.contacts);
  instant.set.com_O = object.com();
  instant.set.known_wrench_O = mechanics::gravity_wrench(
      object.mass(), state.X_WO.linear().transpose() * problem_.gravity_W);
  instant.set.wrench_scale = wrench_scale_;
  instant.set.cone_edges = options_.cone_edges;
  turns_in_plane_ = turns_in_plane_ || patches.turns_in_plane;

  std::vector<double> key = key_of(instant.set, object.size());
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (are_equal(keys_[i], key)) return static_cast<int>(i);
  }
  for (const double friction : frictions_) add_environment(instant, friction);
  all_.push_back(std::move(instant));
  keys_.push_back(std::move(key));
  return size() - 1;
}

void Instants::add_environment(Instant& instant, double coefficient) const {
  const FrictionInterval& friction = problem_.friction;
  instant.environments.push_back(wrenches(instant.set, coefficient, friction.lower));
  if (friction.upper > friction.lower) {
    instant.environments.back().jam_generators =
        wrenches(instant.set, coefficient, friction.upper).generators;
  }
}

void Instants::add_friction(double coefficient) {
  frictions_.push_back(coefficient);
  for (Instant& instant : all_) add_environment(instant, coefficient);
}

}  // namespace graspless::fingertip
