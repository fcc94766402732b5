// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fingertip/check/instant.hpp"

#include <algorithm>

namespace graspless::fingertip::checking {
namespace {

using mechanics::ContactMode;
using mechanics::FingerMode;
using mechanics::Matrix6Xd;
using mechanics::Vector6d;

using mechanics::kInfinity;

bool is_near(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double tolerance) {
  return (a - b).lpNorm<Eigen::Infinity>() <= tolerance;
}

bool is_near(const mechanics::Contact& a, const mechanics::Contact& b, double length) {
  const double same = 1e-9;
  return is_near(a.p_OC, b.p_OC, length) && is_near(a.n_O, b.n_O, same) && a.mode == b.mode &&
         a.friction == b.friction &&
         is_near(mechanics::tangent(a.n_O, a.t_O), mechanics::tangent(b.n_O, b.t_O), same);
}

bool is_near(const mechanics::Finger& a, const mechanics::Finger& b, double length) {
  const double same = 1e-9;
  return is_near(a.p_OC, b.p_OC, length) && is_near(a.n_O, b.n_O, same) && a.friction == b.friction;
}

/// R^1/2 W c: the wrenches of unit forces c (3 x m) at a point.
Matrix6Xd wrenches(const mechanics::ContactSet& set, const Eigen::Vector3d& p_O,
                   const Eigen::Matrix3Xd& forces_O) {
  Matrix6Xd w(6, forces_O.cols());
  for (Eigen::Index j = 0; j < forces_O.cols(); ++j) {
    const Eigen::Vector3d f = forces_O.col(j);
    w.col(j) << f, (p_O - set.com_O).cross(f);
  }
  return set.wrench_scale * w;
}

/// Eq. (1): all edges of the cone; of a sliding contact, the edge against the slide.
Eigen::Matrix3Xd edges(const mechanics::Contact& contact, int count) {
  const Eigen::Vector3d t = mechanics::tangent(contact.n_O, contact.t_O);
  if (contact.mode == ContactMode::slide) {
    return (contact.n_O - contact.friction * t).normalized();
  }
  return mechanics::friction_cone(contact.n_O, contact.friction, count, t);
}

Eigen::Matrix3Xd edges(const mechanics::Finger& finger, int count) {
  return mechanics::friction_cone(finger.n_O, finger.friction, count,
                                  mechanics::tangent(finger.n_O, finger.t_O));
}

Matrix6Xd environment(const mechanics::ContactSet& set) {
  Matrix6Xd all(6, 0);
  for (const mechanics::Contact& contact : set.contacts) {
    const Matrix6Xd w = wrenches(set, contact.p_OC, edges(contact, set.cone_edges));
    all.conservativeResize(6, all.cols() + w.cols());
    all.rightCols(w.cols()) = w;
  }
  return all;
}

/// Adds a coefficient of at least 0 for each column of `wrenches`, in rows 0 ... 5. Returns the
/// first.
int add_columns(mechanics::LinearProgram& lp, const Matrix6Xd& wrenches) {
  const auto first = static_cast<int>(lp.num_variables());
  for (Eigen::Index j = 0; j < wrenches.cols(); ++j) lp.add_variable(0, kInfinity);
  lp.set_block(0, first, wrenches);
  return first;
}

}  // namespace

bool is_near(const Instant& a, const Instant& b, double length, double force) {
  const auto same_contacts = [&](const auto& x, const auto& y) {
    return x.size() == y.size() &&
           std::equal(x.begin(), x.end(), y.begin(),
                      [&](const auto& p, const auto& q) { return is_near(p, q, length); });
  };
  return a.modes == b.modes && a.surfaces.of_contact == b.surfaces.of_contact &&
         (a.commanded_forces - b.commanded_forces).lpNorm<Eigen::Infinity>() <= force &&
         is_near(a.set.known_wrench_O.head<3>(), b.set.known_wrench_O.head<3>(), force) &&
         same_contacts(a.set.contacts, b.set.contacts) &&
         same_contacts(a.set.fingers, b.set.fingers);
}

mechanics::ContactSet with_friction(const Instant& instant, End slide, End stick, double fingers) {
  mechanics::ContactSet set = instant.set;
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    mechanics::Contact& contact = set.contacts[i];
    const auto surface = static_cast<std::size_t>(instant.surfaces.of_contact[i]);
    const End end = contact.mode == ContactMode::slide ? slide : stick;
    contact.friction = instant.surfaces.friction[surface].*end;
  }
  for (mechanics::Finger& finger : set.fingers) finger.friction = fingers;
  return set;
}

mechanics::LinearProgram balance(const Instant& instant) {
  const mechanics::ContactSet& set = instant.set;
  mechanics::LinearProgram lp;
  lp.add_variable(0, kInfinity, 1);
  const Vector6d known = set.wrench_scale * set.known_wrench_O;
  for (int row = 0; row < 6; ++row) lp.add_row(known[row], known[row]);
  add_columns(lp, -environment(set));
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    const mechanics::Finger& finger = set.fingers[i];
    const Eigen::Matrix3Xd cone = edges(finger, set.cone_edges);
    const double commanded = instant.commanded_forces[i];
    const int row = instant.modes[i] == FingerMode::force
                        ? lp.add_row(commanded, commanded)
                        : lp.add_row(-kInfinity, finger.max_normal_force);
    const int first = add_columns(lp, -wrenches(set, finger.p_OC, cone));
    lp.set_block(row, first, finger.n_O.transpose() * cone);
  }
  return lp;
}

std::optional<double> margin_of(const Instant& instant, const Eigen::Matrix3Xd& finger_forces_O,
                                double tolerance, mechanics::LpBasis& basis) {
  const mechanics::ContactSet& set = instant.set;
  const Matrix6Xd env = environment(set);
  Vector6d given = set.wrench_scale * set.known_wrench_O;
  double room = kInfinity;  // what is left to the limits
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    const mechanics::Finger& finger = set.fingers[i];
    const Eigen::Vector3d f = finger_forces_O.col(i);
    given += wrenches(set, finger.p_OC, f);
    if (instant.modes[i] == FingerMode::force) continue;
    room = std::min(room, finger.max_normal_force - finger.n_O.dot(f));
  }
  if (room < -tolerance) return std::nullopt;
  // Coefficients are t + k, k >= 0: column 0, t, has the sum of all edges.
  mechanics::LinearProgram lp;
  lp.add_variable(-tolerance, std::max(room, 0.0), 1);
  for (int row = 0; row < 6; ++row) lp.add_row(-given[row] - tolerance, -given[row] + tolerance);
  add_columns(lp, env);
  lp.set_block(0, 0, env.rowwise().sum());
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    const Eigen::Matrix3Xd cone = edges(set.fingers[i], set.cone_edges);
    const Eigen::Vector3d f = finger_forces_O.col(i);
    const auto row = static_cast<int>(lp.num_rows());
    for (int k = 0; k < 3; ++k) lp.add_row(f[k] - tolerance, f[k] + tolerance);
    const auto first = static_cast<int>(lp.num_variables());
    for (int j = 0; j < set.cone_edges; ++j) lp.add_variable(0, kInfinity);
    lp.set_block(row, first, cone);
    lp.set_block(row, 0, cone.rowwise().sum());
  }
  const mechanics::LpSolution found = mechanics::solve_lp(lp, basis);
  if (found.status == mechanics::LpStatus::infeasible) return std::nullopt;
  return found.objective;
}

}  // namespace graspless::fingertip::checking
