// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Nominal forces: the smallest among the equilibria that are well inside their limits.
#include "graspless/mechanics/equilibrium.hpp"

#include <algorithm>

#include "mechanics/contacts/cones.hpp"
#include "mechanics/equilibrium/inner_forces.hpp"
#include "mechanics/equilibrium/springs.hpp"
#include "mechanics/stability/control.hpp"

namespace graspless::mechanics {
namespace {

// The optimum of either program is a vertex, and rarely unique: rounding would choose between very
// different forces. So a fraction of the optimum is given up, and among the forces that this allows
// those of least squares are taken. They are unique and continuous in the contacts.
constexpr double kKeptMargin = 0.9, kKeptStability = 0.99;
// Number of rounds: the first one has reserves along the axes of the cones, the next one along the
// forces found. That reaches 97 % of the best possible margin (median of 54 rows); more rounds
// hardly help.
constexpr int kRounds = 2;
// A force below this fraction of the largest one is zero up to rounding; its direction is
// meaningless.
constexpr double kNoForce = 1e-6;

void validate_all(const ContactSet& set, const std::vector<FingerMode>& modes,
                  const Eigen::VectorXd& commanded_forces) {
  validate(set);
  validate_modes(set, modes);
  validate_commanded_forces(set, modes, commanded_forces);
}

/// Reserves that make all coefficients at least t.
std::vector<Reserve> equal_reserves(const ContactSet& set) {
  std::vector<Reserve> reserves;
  for (const Contact& contact : set.contacts) {
    reserves.push_back({cone_of(contact, set.cone_edges).rowwise().sum(), 0});
  }
  for (const Finger& finger : set.fingers) {
    reserves.push_back({cone_of(finger, set.cone_edges).rowwise().sum(), 1});
  }
  return reserves;
}

/// Reserves for the changes of force under the worst disturbance, along the given forces. Nothing
/// if one of these has no margin within its cone, such as a finger commanded to press with 0 N.
std::optional<std::vector<Reserve>> spring_reserves(const std::vector<Spring>& springs,
                                                    const Equilibrium& forces) {
  double largest = 0;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    largest = std::max(largest, force_at(forces, i).norm());
  }
  std::vector<Reserve> reserves;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const Eigen::Vector3d force_O = force_at(forces, i);
    const double room = springs[i].within_cone(force_O);
    if (force_O.norm() <= kNoForce * largest || !(room > 0)) return std::nullopt;
    const Eigen::RowVectorXd normals = springs[i].n.transpose() * springs[i].changes;
    reserves.push_back({force_O / room, std::max(0.0, normals.maxCoeff())});
  }
  return reserves;
}

/// Unit forces along the normals; along their one edge for sliding contacts.
Equilibrium along_normals(const ContactSet& set) {
  Equilibrium units;
  units.contact_forces_O.resize(3, static_cast<Eigen::Index>(set.contacts.size()));
  units.finger_forces_O.resize(3, static_cast<Eigen::Index>(set.fingers.size()));
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    const Contact& contact = set.contacts[i];
    units.contact_forces_O.col(i) = contact.mode == ContactMode::slide
                                        ? Eigen::Vector3d(cone_of(contact, set.cone_edges))
                                        : contact.n_O;
  }
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    units.finger_forces_O.col(i) = set.fingers[i].n_O;
  }
  return units;
}

}  // namespace

std::optional<Equilibrium> interior_equilibrium(const ContactSet& set,
                                                const std::vector<FingerMode>& modes,
                                                const Eigen::VectorXd& commanded_forces) {
  validate_all(set, modes, commanded_forces);
  return inner_forces(set, modes, commanded_forces, equal_reserves(set), largest_force(set),
                      kKeptMargin);
}

std::optional<Equilibrium> compliant_equilibrium(const ContactSet& set,
                                                 const std::vector<FingerMode>& modes,
                                                 const Eigen::VectorXd& commanded_forces,
                                                 const std::optional<Sprung>& found) {
  validate_commanded_forces(set, modes, commanded_forces);
  const ContactSet round = with_round_cones(set);  // with the same springs
  const double t_max = largest_force(round);
  const auto solve = [&](const std::vector<Reserve>& reserves, double kept) {
    return inner_forces(round, modes, commanded_forces, reserves, t_max, kept);
  };
  std::optional<Equilibrium> forces;
  auto reserves = found ? spring_reserves(found->springs, along_normals(round)) : std::nullopt;
  for (int k = 0; reserves && k < kRounds; ++k) {
    const auto better = solve(*reserves, kKeptStability);
    if (!better) break;
    forces = better;
    reserves = spring_reserves(found->springs, *forces);
  }
  return forces ? forces : solve(equal_reserves(round), kKeptMargin);
}

std::optional<Equilibrium> compliant_equilibrium(const ContactSet& set,
                                                 const std::vector<FingerMode>& modes,
                                                 const Eigen::VectorXd& commanded_forces,
                                                 const Compliance& compliance,
                                                 const Matrix6Xd& directions) {
  validate_all(set, modes, commanded_forces);
  return compliant_equilibrium(set, modes, commanded_forces,
                               sprung_along(set, modes, compliance, directions));
}

}  // namespace graspless::mechanics
