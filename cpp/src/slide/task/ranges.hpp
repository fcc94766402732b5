// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Ranges of the lengths and coefficients that describe a task.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

#include "graspless/geometry/polygon.hpp"

namespace graspless::slide {

/// Throws std::invalid_argument that names `what`, its value and the range, unless it is within.
inline void check_within(const std::string& what, double value, double least, double largest,
                         const std::string& unit) {
  if (value >= least && value <= largest) return;
  std::ostringstream fault;
  fault << what << " must lie in [" << least << ", " << largest << "]" << unit << ", not " << value;
  throw std::invalid_argument(fault.str());
}

/// Returns a length [m] that is within the range of geometry. Throws like check_within().
inline double length(const std::string& what, double value) {
  check_within(what, value, geometry::kMinLength, geometry::kMaxLength, " m");
  return value;
}

}  // namespace graspless::slide
