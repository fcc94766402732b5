// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(): where the fingers are on the object, and that they stay there but for regrasps.
#include <optional>

#include "fingertip/check/check.hpp"

namespace graspless::fingertip::checking {
namespace {

bool is_same_contact(const FingerState& a, const FingerState& b, double length) {
  return (a.p_OC - b.p_OC).norm() <= length && (a.n_O - b.n_O).norm() <= 1e-9;
}

}  // namespace

Eigen::Vector3d Examination::center(const FingerState& finger) const {
  return finger.p_OC - problem_.fingers.radius * finger.n_O;
}

/// Walks through all rows with what each finger holds: only a regrasp lets go of it.
void Examination::check_fingers() {
  const auto count = static_cast<std::size_t>(problem_.fingers.count);
  std::vector<std::optional<FingerState>> held(count);
  for (std::size_t s = 0; s < plan_.segments.size(); ++s) {
    if (is_regrasp(s)) held[static_cast<std::size_t>(segment(s).finger)].reset();
    for (std::size_t r = 0; r < segment(s).rows.size(); ++r) {
      for (std::size_t i = 0; i < count; ++i) {
        const FingerState& finger = segment(s).rows[r].fingers[i];
        if (!finger.touches) continue;
        if (held[i] && is_same_contact(*held[i], finger, same_length_)) continue;
        if (held[i]) {
          fault(place(s, r), "finger " + std::to_string(i) + " has moved without a regrasp");
        }
        check_contact(s, r, i);
        held[i] = finger;
      }
    }
  }
}

void Examination::check_contact(std::size_t s, std::size_t r, std::size_t i) {
  const FingerState& finger = segment(s).rows[r].fingers[i];
  const std::string who = "finger " + std::to_string(i);
  if (is_on_surface(problem_.object.mesh(), finger.p_OC, finger.n_O, same_length_)) return;
  fault(place(s, r), who + ": contact: not on the object's surface with that normal into it");
}

}  // namespace graspless::fingertip::checking
