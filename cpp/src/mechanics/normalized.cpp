// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Mends the one fault of a contact set that has an obvious remedy.
#include <stdexcept>
#include <string>

#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {
namespace {

void normalize(Eigen::Vector3d* n_O, const std::string& field) {
  const double length = n_O->stableNorm();  // as long or short as doubles go
  if (!n_O->allFinite() || !(length > 0)) {
    throw std::invalid_argument(field + ".n_O must have a direction, not length " +
                                std::to_string(length));
  }
  *n_O = (*n_O / length).normalized();
}

}  // namespace

ContactSet normalized(ContactSet set, const std::string& what) {
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    normalize(&set.contacts[i].n_O, what + ": contacts[" + std::to_string(i) + "]");
  }
  for (std::size_t i = 0; i < set.fingers.size(); ++i) {
    normalize(&set.fingers[i].n_O, what + ": fingers[" + std::to_string(i) + "]");
  }
  return set;
}

}  // namespace graspless::mechanics
