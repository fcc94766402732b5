// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Validation of control modes, commanded forces and directions of disturbances.
#include "mechanics/stability/control.hpp"

#include <sstream>
#include <stdexcept>
#include <string>

#include "text.hpp"

namespace graspless::mechanics {
namespace {

constexpr double kAboveLimit = 1e-9;  // relative, for the rounding error of a force at its limit

void require_one_each(const ContactSet& set, const std::string& field, std::size_t given) {
  if (given == set.fingers.size()) return;
  throw std::invalid_argument(field + " must have " + std::to_string(set.fingers.size()) +
                              " entries, one for each finger, not " + std::to_string(given));
}

}  // namespace

void validate_modes(const ContactSet& set, const std::vector<FingerMode>& modes) {
  require_one_each(set, "modes", modes.size());
}

ForceMask force_mask(const ContactSet& set, const std::vector<FingerMode>& modes) {
  validate_modes(set, modes);
  ForceMask mask = 0;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] == FingerMode::force) mask |= 1U << i;
  }
  return mask;
}

void validate_commanded_forces(const ContactSet& set, const std::vector<FingerMode>& modes,
                               const Eigen::VectorXd& commanded_forces) {
  require_one_each(set, "commanded_forces", static_cast<std::size_t>(commanded_forces.size()));
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] != FingerMode::force) continue;
    const double force = commanded_forces[i];
    const double limit = set.fingers[i].max_normal_force;
    if (force >= 0 && force <= limit * (1 + kAboveLimit)) continue;
    throw std::invalid_argument("commanded_forces[" + std::to_string(i) +
                                "] must lie between 0 and the finger's max_normal_force " +
                                figure(limit) + " N, not " + figure(force));
  }
}

void validate_directions(const Matrix6Xd& directions) {
  if (directions.cols() == 0) throw std::invalid_argument("directions must be one at least");
  for (Eigen::Index i = 0; i < directions.cols(); ++i) {
    const double length = directions.col(i).stableNorm();
    if (length >= kMinDirection && length <= kMaxDirection) continue;
    std::ostringstream text;
    text << "directions must be finite, with lengths in [" << kMinDirection << ", " << kMaxDirection
         << "]; the length of directions[" << i << "] is " << length;
    throw std::invalid_argument(text.str());
  }
}

}  // namespace graspless::mechanics
