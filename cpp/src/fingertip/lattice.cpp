// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <stdexcept>

#include "fingertip/motions.hpp"

namespace graspless::fingertip {

Plan plan_lattice(Workshop&, const Lattice&, planning::Clock&) {
  throw std::invalid_argument("motion: no lattice so far");
}

}  // namespace graspless::fingertip
