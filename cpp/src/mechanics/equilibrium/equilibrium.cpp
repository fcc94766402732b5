// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Nominal forces: among the equilibria that are deep inside their limits, the least.
#include "graspless/mechanics/equilibrium.hpp"

#include <algorithm>

#include "mechanics/contacts/cones.hpp"
#include "mechanics/stability/control.hpp"
#include "mechanics/equilibrium/inner_forces.hpp"
#include "mechanics/equilibrium/springs.hpp"

namespace graspless::mechanics {
namespace {

// The optimum of either programme is a vertex, and rarely the only one: rounding would choose
// between forces far apart. So a share of it is given up, and of what that allows the coefficients
// of least squares are taken: one answer, which follows the contacts continuously.
constexpr double kKeptMargin = 0.9, kKeptStability = 0.99;
// How often forces are looked for: first with reserves along the axes of the cones, then along the
// forces found. That reaches 97 % of the best index there is (median of 54 rows), and more rounds
// hardly help.
constexpr int kRounds = 2;

void validate_all(const ContactSet& set, const std::vector<FingerMode>& modes,
                  const Eigen::VectorXd& commanded_forces) {
  validate(set);
  validate_modes(set, modes);
  validate_commanded_forces(set, modes, commanded_forces);
}

/// All coefficients at least t.
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

/// What the springs ask for under the worst of all disturbances, along the forces that there are.
/// Nothing where one of them has no room at all within its cone.
std::optional<std::vector<Reserve>> spring_reserves(const std::vector<Spring>& springs,
                                                    const Equilibrium& forces) {
  std::vector<Reserve> reserves;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const Eigen::Vector3d force_O = force_at(forces, i);
    const double room = springs[i].within_cone(force_O);
    if (!(room > 0)) return std::nullopt;
    const Eigen::RowVectorXd normals = springs[i].n.transpose() * springs[i].changes;
    reserves.push_back({force_O / room, std::max(0.0, normals.maxCoeff())});
  }
  return reserves;
}

/// Unit forces along the normals: of contacts that slide, along their one edge.
Equilibrium along_normals(const ContactSet& set) {
  Equilibrium units;
  units.contact_forces_O.resize(3, static_cast<Eigen::Index>(set.contacts.size()));
  units.finger_forces_O.resize(3, static_cast<Eigen::Index>(set.fingers.size()));
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    const Contact& contact = set.contacts[i];
    units.contact_forces_O.col(static_cast<Eigen::Index>(i)) =
        contact.mode == ContactMode::slide ? Eigen::Vector3d(cone_of(contact, set.cone_edges))
                                           : contact.n_O;
  }
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    units.finger_forces_O.col(static_cast<Eigen::Index>(i)) = set.fingers[i].n_O;
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
                                                 const Compliance& compliance,
                                                 const Matrix6Xd& directions) {
  validate_all(set, modes, commanded_forces);
  const ContactSet round = with_round_cones(set);
  const auto springs = springs_under(round, modes, compliance, directions);
  const double t_max = largest_force(round);
  const auto solve = [&](const std::vector<Reserve>& reserves, double kept) {
    return inner_forces(round, modes, commanded_forces, reserves, t_max, kept);
  };
  std::optional<Equilibrium> forces;
  auto reserves = springs ? spring_reserves(*springs, along_normals(round)) : std::nullopt;
  for (int k = 0; reserves && k < kRounds; ++k) {
    const auto better = solve(*reserves, kKeptStability);
    if (!better) break;
    forces = better;
    reserves = spring_reserves(*springs, *forces);
  }
  return forces ? forces : solve(equal_reserves(round), kKeptMargin);
}

}  // namespace graspless::mechanics
