// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Object on springs: its displacement under a disturbance, and the change of every contact force.
#include "mechanics/equilibrium/springs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "mechanics/stability/control.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kSoft = 1e-9;  // fraction of the largest stiffness below which a motion is free

/// Spring with its stiffness and its displacement.
struct LocatedSpring {
  Spring spring;
  Eigen::Matrix3d stiffness;              // force on the object per displacement against it
  Eigen::Matrix<double, 3, 6> displaced;  // displacement of the point per twist about the com
};

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

LocatedSpring located(const ContactSet& set, const Eigen::Vector3d& p_OC,
                      const Eigen::Vector3d& n_O, double friction) {
  LocatedSpring at;
  at.spring.n = n_O;
  at.spring.friction = friction;
  at.displaced << Eigen::Matrix3d::Identity(), -cross_matrix(p_OC - set.com_O);
  return at;
}

Eigen::Matrix3d isotropic(const Eigen::Vector3d& n, double normal, double tangential) {
  return tangential * Eigen::Matrix3d::Identity() + (normal - tangential) * n * n.transpose();
}

LocatedSpring of_contact(const ContactSet& set, const Contact& c, const Compliance& compliance) {
  LocatedSpring at = located(set, c.p_OC, c.n_O, c.friction);
  at.spring.follows = c.mode == ContactMode::slide;
  if (at.spring.follows) {
    const Eigen::Vector3d edge = c.n_O - c.friction * tangent(c.n_O, c.t_O);
    at.stiffness = compliance.environment_normal * edge * c.n_O.transpose();
  } else {
    at.stiffness =
        isotropic(c.n_O, compliance.environment_normal, compliance.environment_tangential);
  }
  return at;
}

LocatedSpring of_finger(const ContactSet& set, const Finger& f, FingerMode mode,
                        const Compliance& compliance) {
  LocatedSpring at = located(set, f.p_OC, f.n_O, f.friction);
  const bool force = mode == FingerMode::force;
  at.stiffness =
      isotropic(f.n_O, force ? 0 : compliance.finger_normal, compliance.finger_tangential);
  if (!force) at.spring.max_normal = f.max_normal_force;
  return at;
}

std::vector<LocatedSpring> all_of(const ContactSet& set, const std::vector<FingerMode>& modes,
                                  const Compliance& compliance) {
  std::vector<LocatedSpring> all;
  for (const Contact& contact : set.contacts) all.push_back(of_contact(set, contact, compliance));
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    all.push_back(of_finger(set, set.fingers[i], modes[i], compliance));
  }
  return all;
}

/// Returns true if the springs push the object back from every displacement: all eigenvalues of the
/// stiffness, in the scale of the disturbances, have positive real parts. Without sliding that is
/// positive definiteness; friction that follows a normal force makes the stiffness unsymmetric.
bool holds(const Matrix6d& stiffness, const Matrix6d& scale, bool slides) {
  const Matrix6d scaled = scale * stiffness * scale.transpose();
  const double soft = kSoft * scaled.norm();
  if (slides) return scaled.eigenvalues().real().minCoeff() > soft;
  return scaled.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() > soft;
}

/// All springs, and the stiffness that they give the object together.
struct System {
  std::vector<LocatedSpring> all;  // of the contacts, then of the fingers
  Matrix6d stiffness = Matrix6d::Zero();

  /// Nothing if the springs do not hold the object.
  static std::optional<System> of(const ContactSet& set, const std::vector<FingerMode>& modes,
                                  const Compliance& compliance) {
    System system{all_of(set, modes, compliance)};
    bool slides = false;
    for (const LocatedSpring& at : system.all) {
      system.stiffness += at.displaced.transpose() * at.stiffness * at.displaced;
      slides = slides || at.spring.follows;
    }
    if (!holds(system.stiffness, set.wrench_scale, slides)) return std::nullopt;
    return system;
  }

  /// Displacement under wrenches, and what it changes.
  Sprung moved_by(const Matrix6Xd& wrenches) const {
    Sprung found;
    found.moved = stiffness.partialPivLu().solve(Eigen::MatrixXd(wrenches));
    for (const LocatedSpring& at : all) {
      found.springs.push_back(at.spring);
      found.springs.back().changes = -at.stiffness * at.displaced * found.moved;
    }
    return found;
  }
};

/// Largest t at which force + t change lies within Coulomb's cone, for a nominal force inside it.
/// The quadratic a t^2 + 2 b t + c is negative inside.
double slip_limit(const Spring& spring, const Eigen::Vector3d& force,
                  const Eigen::Vector3d& change) {
  const double normal = spring.n.dot(force), grows = spring.n.dot(change);
  const Eigen::Vector3d along = force - normal * spring.n;
  const Eigen::Vector3d slips = change - grows * spring.n;
  const double mu2 = spring.friction * spring.friction;
  const double a = slips.squaredNorm() - mu2 * grows * grows;
  const double b = along.dot(slips) - mu2 * normal * grows;
  const double c = std::min(0.0, along.squaredNorm() - mu2 * normal * normal);
  if (c == 0 && b == 0) return a > 0 ? 0 : Spring::kUnlimited;
  const double root = b * b - a * c;
  if (root < 0) return Spring::kUnlimited;
  if (b < 0) return a > 0 ? (std::sqrt(root) - b) / a : Spring::kUnlimited;
  return b + std::sqrt(root) > 0 ? -c / (b + std::sqrt(root)) : Spring::kUnlimited;
}

}  // namespace

double Spring::within_cone(const Eigen::Vector3d& force_O) const {
  const double normal = std::max(0.0, n.dot(force_O));
  const double most = -(n.transpose() * changes).minCoeff();
  double t = most > 0 ? normal / most : kUnlimited;
  if (follows) return t;
  for (Eigen::Index k = 0; k < changes.cols(); ++k) {
    t = std::min(t, slip_limit(*this, force_O, changes.col(k)));
  }
  return t;
}

double Spring::within_limit(const Eigen::Vector3d& force_O) const {
  const double normal = std::max(0.0, n.dot(force_O));
  const double most = (n.transpose() * changes).maxCoeff();
  return most > 0 ? std::max(0.0, max_normal - normal) / most : kUnlimited;
}

double Spring::tolerates(const Eigen::Vector3d& force_O) const {
  const double normal = n.dot(force_O);
  const double slips = follows ? 0 : (force_O - normal * n).norm();
  const double mu = follows ? 1 : friction;  // of one that cannot slip, only the normal counts
  double grows = 0, turns = 0;
  for (Eigen::Index k = 0; k + 3 <= changes.cols(); k += 3) {
    const Eigen::Matrix3d of = changes.middleCols<3>(k);
    grows += (n.transpose() * of).norm();
    if (!follows) turns += largest_stretch(of - n * (n.transpose() * of));
  }
  const double room = std::max(0.0, mu * normal - slips);
  double e = kUnlimited;
  if (turns + mu * grows > 0) e = room / (turns + mu * grows);
  if (grows > 0) e = std::min(e, std::max(0.0, max_normal - normal) / grows);
  return e;
}

double largest_stretch(const Eigen::Matrix3d& of) {
  const Eigen::Matrix3d squares = of.transpose() * of;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(squares, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

Eigen::Vector3d force_at(const Equilibrium& forces, std::size_t i) {
  const auto contact = static_cast<Eigen::Index>(i), contacts = forces.contact_forces_O.cols();
  if (contact < contacts) return forces.contact_forces_O.col(contact);
  return forces.finger_forces_O.col(contact - contacts);
}

std::optional<Sprung> sprung(const ContactSet& set, const std::vector<FingerMode>& modes,
                             const Compliance& compliance, const Matrix6Xd& wrenches) {
  const auto system = System::of(set, modes, compliance);
  if (!system) return std::nullopt;
  return system->moved_by(-wrenches);  // the springs must supply the wrench
}

std::optional<Sprung> misplaced(const ContactSet& set, const std::vector<FingerMode>& modes,
                                const Compliance& compliance) {
  const auto system = System::of(set, modes, compliance);
  if (!system) return std::nullopt;
  const std::size_t contacts = set.contacts.size();
  const auto errors = 3 * static_cast<Eigen::Index>(set.fingers.size());
  Matrix6Xd pushes(6, errors);
  for (std::size_t j = 0; j < set.fingers.size(); ++j) {
    const LocatedSpring& at = system->all[contacts + j];
    pushes.middleCols<3>(3 * static_cast<Eigen::Index>(j)) =
        at.displaced.transpose() * at.stiffness;
  }
  Sprung found = system->moved_by(pushes);
  for (std::size_t j = 0; j < set.fingers.size(); ++j) {
    found.springs[contacts + j].changes.middleCols<3>(3 * static_cast<Eigen::Index>(j)) +=
        system->all[contacts + j].stiffness;
  }
  return found;
}

std::optional<Sprung> sprung_along(const ContactSet& set, const std::vector<FingerMode>& modes,
                                   const Compliance& compliance, const Matrix6Xd& directions) {
  validate(set);
  validate_modes(set, modes);
  planning::require_in_range("compliance.", compliance);
  validate_directions(directions);
  return sprung(set, modes, compliance, set.wrench_scale.partialPivLu().solve(directions));
}

}  // namespace graspless::mechanics
