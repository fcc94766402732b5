// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Nominal forces: among the equilibria that are deep inside their limits, the least.
#include "graspless/mechanics/equilibrium.hpp"

#include <algorithm>

#include "mechanics/cones.hpp"
#include "mechanics/control.hpp"
#include "mechanics/inner_forces.hpp"
#include "mechanics/springs.hpp"

namespace graspless::mechanics {
namespace {

// The optimum of either programme is a vertex, and rarely the only one: rounding would choose
// between forces far apart. So a share of it is given up, and of what that allows the coefficients
// of least squares are taken: one answer, which follows the contacts continuously.
constexpr double kKeptMargin = 0.9, kKeptStability = 0.99;
// How often reserves are placed anew, along the forces last found: no round loses anything but the
// share above, and after the second the index hardly grows (96 % of the best there is, median).
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
  auto forces =
      inner_forces(round, modes, commanded_forces, equal_reserves(round), t_max, kKeptMargin);
  for (int k = 0; springs && forces && k < kRounds; ++k) {
    const auto reserves = spring_reserves(*springs, *forces);
    if (!reserves) break;
    const auto better =
        inner_forces(round, modes, commanded_forces, *reserves, t_max, kKeptStability);
    if (!better) break;
    forces = better;
  }
  return forces;
}

}  // namespace graspless::mechanics
