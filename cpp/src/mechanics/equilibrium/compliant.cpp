// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Largest disturbance before the first spring contact slips or lifts off.
#include <algorithm>
#include <limits>
#include <stdexcept>

#include "graspless/mechanics/equilibrium.hpp"

#include "mechanics/equilibrium/springs.hpp"

namespace graspless::mechanics {
void validate_nominal(const ContactSet& set, const Equilibrium& nominal) {
  const auto contacts = static_cast<Eigen::Index>(set.contacts.size());
  const auto fingers = static_cast<Eigen::Index>(set.fingers.size());
  if (nominal.contact_forces_O.cols() != contacts || nominal.finger_forces_O.cols() != fingers) {
    throw std::invalid_argument("nominal must hold one force a contact and one a finger");
  }
  if (!nominal.contact_forces_O.allFinite() || !nominal.finger_forces_O.allFinite()) {
    throw std::invalid_argument("nominal forces must be finite");
  }
}

double compliant_stability(const ContactSet& set, const Equilibrium& nominal,
                           const std::optional<Sprung>& found) {
  validate_nominal(set, nominal);
  if (!found) return 0;
  double t = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < found->springs.size(); ++i) {
    const Spring& spring = found->springs[i];
    const Eigen::Vector3d force_O = force_at(nominal, i);
    t = std::min({t, spring.within_cone(force_O), spring.within_limit(force_O)});
  }
  return t;
}

double compliant_stability(const ContactSet& set, const std::vector<FingerMode>& modes,
                           const Equilibrium& nominal, const Compliance& compliance,
                           const Matrix6Xd& directions) {
  return compliant_stability(set, nominal, sprung_along(set, modes, compliance, directions));
}

}  // namespace graspless::mechanics
