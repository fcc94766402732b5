// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// How far springs at the contacts carry a disturbance before the first of them slips or lets go.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "graspless/mechanics/equilibrium.hpp"

#include "mechanics/control.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kSoft = 1e-9;  // share of the stiffest motion below which one is not held

/// One contact as a spring about its nominal force.
struct Spring {
  Eigen::Vector3d n, force;               // nominal force
  Eigen::Matrix3d stiffness;              // force on the object per displacement against it
  Eigen::Matrix<double, 3, 6> displaced;  // displacement of the point per twist about the com
  double friction;
  double max_normal;
  bool follows;  // slides: its friction follows the normal force and cannot slip further
};

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Spring spring(const ContactSet& set, const Eigen::Vector3d& p_OC, const Eigen::Vector3d& n_O,
              double friction, const Eigen::Vector3d& force_O) {
  Spring spring;
  spring.n = n_O;
  spring.force = force_O;
  spring.displaced << Eigen::Matrix3d::Identity(), -cross_matrix(p_OC - set.com_O);
  spring.friction = friction;
  spring.max_normal = std::numeric_limits<double>::infinity();
  spring.follows = false;
  return spring;
}

Eigen::Matrix3d isotropic(const Eigen::Vector3d& n, double normal, double tangential) {
  return tangential * Eigen::Matrix3d::Identity() + (normal - tangential) * n * n.transpose();
}

std::vector<Spring> springs(const ContactSet& set, const std::vector<FingerMode>& modes,
                            const Equilibrium& nominal, const Compliance& compliance) {
  std::vector<Spring> all;
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    const Contact& c = set.contacts[i];
    Spring s = spring(set, c.p_OC, c.n_O, c.friction,
                      nominal.contact_forces_O.col(static_cast<Eigen::Index>(i)));
    s.follows = c.mode == ContactMode::slide;
    if (s.follows) {
      const Eigen::Vector3d edge = c.n_O - c.friction * tangent(c.n_O, c.t_O);
      s.stiffness = compliance.environment_normal * edge * c.n_O.transpose();
    } else {
      s.stiffness =
          isotropic(c.n_O, compliance.environment_normal, compliance.environment_tangential);
    }
    all.push_back(s);
  }
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    const Finger& f = set.fingers[i];
    Spring s = spring(set, f.p_OC, f.n_O, f.friction,
                      nominal.finger_forces_O.col(static_cast<Eigen::Index>(i)));
    const bool force = modes[i] == FingerMode::force;
    s.stiffness =
        isotropic(f.n_O, force ? 0 : compliance.finger_normal, compliance.finger_tangential);
    if (!force) s.max_normal = f.max_normal_force;
    all.push_back(s);
  }
  return all;
}

/// The largest t at which force + t change lies within Coulomb's cone; both are a nominal force
/// inside it and any direction. The quadratic a t^2 + 2 b t + c is negative inside.
double within_cone(const Spring& spring, const Eigen::Vector3d& change) {
  const double normal = spring.n.dot(spring.force), grows = spring.n.dot(change);
  const Eigen::Vector3d along = spring.force - normal * spring.n;
  const Eigen::Vector3d slips = change - grows * spring.n;
  const double mu2 = spring.friction * spring.friction;
  const double a = slips.squaredNorm() - mu2 * grows * grows;
  const double b = along.dot(slips) - mu2 * normal * grows;
  const double c = std::min(0.0, along.squaredNorm() - mu2 * normal * normal);
  const double root = b * b - a * c;
  double t = std::numeric_limits<double>::infinity();
  if (root >= 0 && b + std::sqrt(root) > 0) t = -c / (b + std::sqrt(root));
  return t;
}

/// The largest t that this contact withstands of a change of force.
double withstands(const Spring& spring, const Eigen::Vector3d& change) {
  const double normal = std::max(0.0, spring.n.dot(spring.force)), grows = spring.n.dot(change);
  double t = spring.follows ? std::numeric_limits<double>::infinity() : within_cone(spring, change);
  if (grows < 0) t = std::min(t, normal / -grows);
  if (grows > 0) t = std::min(t, std::max(0.0, spring.max_normal - normal) / grows);
  return t;
}

/// Whether the springs push the object back from every displacement: measured with the same scale
/// as disturbances, no motion of the stiffness has a rate of 0 or below. (Friction that follows a
/// normal force makes it unsymmetric; without sliding this is positive definiteness.)
bool holds(const Matrix6d& stiffness, const Matrix6d& scale) {
  const Matrix6d scaled = scale * stiffness * scale.transpose();
  const Eigen::EigenSolver<Matrix6d> rates(scaled, false);
  const Eigen::VectorXd real = rates.eigenvalues().real();
  return real.minCoeff() > kSoft * scaled.norm();
}

void validate_springs(const ContactSet& set, const Equilibrium& nominal,
                      const Compliance& compliance) {
  const auto positive = [](double value, const std::string& field) {
    if (value > 0 && std::isfinite(value)) return;
    throw std::invalid_argument("compliance." + field + " must be positive and finite, not " +
                                std::to_string(value));
  };
  positive(compliance.environment_normal, "environment_normal");
  positive(compliance.environment_tangential, "environment_tangential");
  positive(compliance.finger_normal, "finger_normal");
  positive(compliance.finger_tangential, "finger_tangential");
  const auto contacts = static_cast<Eigen::Index>(set.contacts.size());
  const auto fingers = static_cast<Eigen::Index>(set.fingers.size());
  if (nominal.contact_forces_O.cols() != contacts || nominal.finger_forces_O.cols() != fingers) {
    throw std::invalid_argument("nominal must hold one force a contact and one a finger");
  }
  if (!nominal.contact_forces_O.allFinite() || !nominal.finger_forces_O.allFinite()) {
    throw std::invalid_argument("nominal forces must be finite");
  }
}

}  // namespace

double compliant_stability(const ContactSet& set, const std::vector<FingerMode>& modes,
                           const Equilibrium& nominal, const Compliance& compliance,
                           const Matrix6Xd& directions) {
  validate(set);
  validate_modes(set, modes);
  validate_springs(set, nominal, compliance);
  if (directions.cols() == 0 || !directions.allFinite()) {
    throw std::invalid_argument("directions must be finite, one at least");
  }
  const std::vector<Spring> all = springs(set, modes, nominal, compliance);
  Matrix6d stiffness = Matrix6d::Zero();
  for (const Spring& s : all) stiffness += s.displaced.transpose() * s.stiffness * s.displaced;
  if (!holds(stiffness, set.wrench_scale)) return 0;

  // The springs must supply R^-1/2 t l_i: the object moves against them by that much.
  const Matrix6Xd moved = -stiffness.partialPivLu().solve(
      Eigen::MatrixXd(set.wrench_scale.partialPivLu().solve(directions)));
  double t = std::numeric_limits<double>::infinity();
  for (const Spring& s : all) {
    const Eigen::Matrix3Xd changes = -s.stiffness * s.displaced * moved;
    for (Eigen::Index i = 0; i < changes.cols(); ++i) {
      t = std::min(t, withstands(s, changes.col(i)));
    }
  }
  return t;
}

}  // namespace graspless::mechanics
