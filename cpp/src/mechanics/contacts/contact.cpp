// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Normals, tangents and friction cones of contacts, Eqs. (1) and (2).
#include "graspless/mechanics/contact.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "graspless/geometry/shape.hpp"

#include "mechanics/contacts/wrenches.hpp"
#include "text.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kUnit = 1e-9;  // tolerance of a unit normal's length
constexpr int kMaxConeEdges = 1000;
constexpr double kParallel = 1e-9;  // sine below which a direction is along the normal

[[noreturn]] void refuse(const std::string& field, const std::string& must, double value) {
  throw std::invalid_argument(field + " must " + must + ", not " + figure(value));
}

void check_finite(const Eigen::Ref<const Eigen::MatrixXd>& values, const std::string& field) {
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double value = values(i % values.rows(), i / values.rows());
    if (!std::isfinite(value)) refuse(field, "be finite", value);
  }
}

/// Requires that every value is finite and at most `largest`, positive or negative.
void check_within(const Eigen::Ref<const Eigen::MatrixXd>& values, const std::string& field,
                  double largest, const std::string& unit) {
  check_finite(values, field);
  const double value = values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0;
  if (value <= largest) return;
  refuse(field, "lie within +-" + figure(largest) + unit, value);
}

Eigen::Vector3d along_surface(const Eigen::Vector3d& n_O, const Eigen::Vector3d& t_O) {
  return t_O - n_O * n_O.dot(t_O);
}

/// Validates the fields that contacts and fingers have in common.
template <typename Touch>
void check_touch(const Touch& touch, const std::string& field) {
  check_within(touch.p_OC, field + ".p_OC", geometry::kMaxLength, " m");
  check_finite(touch.n_O, field + ".n_O");
  check_finite(touch.t_O, field + ".t_O");
  const double length = touch.n_O.norm();
  if (std::abs(length - 1) > kUnit) refuse(field + ".n_O", "be a unit vector", length);
  require_within(field + ".friction", touch.friction, 0, kMaxFriction);
}

void check_slide(const Contact& contact, const std::string& field) {
  if (contact.mode != ContactMode::slide) return;
  const double length = along_surface(contact.n_O, contact.t_O).norm();
  if (length > kParallel * contact.t_O.norm()) return;
  throw std::invalid_argument(field + ".t_O must have a part along the surface: the contact " +
                              "slides, and friction acts against the motion");
}

void normalize(Eigen::Vector3d* n_O, const std::string& field) {
  const double length = n_O->stableNorm();  // without overflow or underflow
  if (!n_O->allFinite() || !(length > 0)) {
    throw std::invalid_argument(field + ".n_O must have a direction, not length " + figure(length));
  }
  *n_O = (*n_O / length).normalized();
}

}  // namespace

void validate(const ContactSet& set, const std::string& what) {
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    const std::string field = what + ": contacts[" + std::to_string(i) + "]";
    check_touch(set.contacts[i], field);
    check_slide(set.contacts[i], field);
  }
  if (set.fingers.size() > kMaxFingers) {
    throw std::invalid_argument(what + ": fingers must be at most " + std::to_string(kMaxFingers) +
                                ", not " + std::to_string(set.fingers.size()));
  }
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    const std::string field = what + ": fingers[" + std::to_string(i) + "]";
    check_touch(set.fingers[i], field);
    require_within(field + ".max_normal_force", set.fingers[i].max_normal_force, kMinForce,
                   kMaxForce, " N");
  }
  check_within(set.com_O, what + ": com_O", geometry::kMaxLength, " m");
  check_within(set.known_wrench_O.head<3>(), what + ": force of known_wrench_O", kMaxForce, " N");
  check_within(set.known_wrench_O.tail<3>(), what + ": moment of known_wrench_O",
               kMaxForce * geometry::kMaxLength, " N m");
  check_within(set.wrench_scale, what + ": wrench_scale", kMaxScale, "");
  if (!Eigen::FullPivLU<Matrix6d>(set.wrench_scale).isInvertible()) {
    throw std::invalid_argument(what + ": wrench_scale must be regular");
  }
  require_within(what + ": cone_edges", set.cone_edges, 3, kMaxConeEdges);
}

ContactSet normalized(ContactSet set, const std::string& what) {
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    normalize(&set.contacts[i].n_O, what + ": contacts[" + std::to_string(i) + "]");
  }
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    normalize(&set.fingers[i].n_O, what + ": fingers[" + std::to_string(i) + "]");
  }
  return set;
}

Eigen::Vector3d tangent(const Eigen::Vector3d& n_O, const Eigen::Vector3d& t_O) {
  const Eigen::Vector3d t = along_surface(n_O, t_O);
  if (t.norm() > kParallel * t_O.norm()) return t.normalized();
  Eigen::Index longest = 0;
  n_O.cwiseAbs().maxCoeff(&longest);
  return along_surface(n_O, Eigen::Vector3d::Unit((longest + 1) % 3)).normalized();
}

Eigen::Matrix3Xd friction_cone(const Eigen::Vector3d& n_O, double friction, int edges,
                               const Eigen::Vector3d& tangent) {
  require(edges >= 3, "edges", edges, "must be at least 3");
  const Eigen::Vector3d left = n_O.cross(tangent);
  const double step = 2 * M_PI / edges;
  Eigen::Matrix3Xd cone(3, edges);
  for (int j = 0; j < edges; ++j) {
    const Eigen::Vector3d around = std::cos(step * j) * tangent + std::sin(step * j) * left;
    cone.col(j) = (n_O + friction * around) / std::sqrt(1 + friction * friction);
  }
  return cone;
}

Vector6d gravity_wrench(double mass, const Eigen::Vector3d& gravity_O) {
  require_within("mass", mass, kMinMass, kMaxMass, " kg");
  check_within(gravity_O, "gravity_O", kMaxGravity, " m/s^2");
  Vector6d wrench = Vector6d::Zero();
  wrench.head<3>() = mass * gravity_O;
  return wrench;
}

}  // namespace graspless::mechanics
