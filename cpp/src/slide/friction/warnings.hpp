// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "slide/bearing.hpp"
#include "slide/friction/pressed.hpp"

namespace graspless::slide {

/// Risk of a plan: what may happen, and its measure with a remedy.
struct Warning {
  std::string risk, rest;
  std::string text() const { return risk + rest; }
};

/// Returns the risks that follow from the friction of a slide and from the weight after it, where
/// they exceed the smallest ones that are worth a warning by the factor `beyond`. See torsion.hpp.
std::vector<Warning> warnings(const Problem& problem, const std::vector<PressedRow>& rows,
                              const std::optional<Bearing>& held, double beyond = 1);

}  // namespace graspless::slide
