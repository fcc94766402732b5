// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "graspless/fingertip/fingertip.hpp"

namespace graspless::fingertip {

/// A pose that the object must take and at which the fingers find no place.
struct Blocked {
  std::string limit;   ///< reach of the lattice: no location is clear; geometry: too few, apart
  std::string reason;  ///< which pose, and what is in the way
};

/// The first such pose of the motion: of a path any, else start and goal.
std::optional<Blocked> find_blocked(const Problem& problem, const Options& options);

}  // namespace graspless::fingertip
