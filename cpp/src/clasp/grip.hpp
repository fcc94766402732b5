// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "graspless/clasp/options.hpp"
#include "graspless/clasp/problem.hpp"

namespace graspless::clasp {

/// Some fingers of the hand that clasp together with the thumb, from a pre-shape; no names: all of
/// them, from the first. The others close, too, but need not be linked with the loop. Two fingers
/// that are not the whole hand must withstand the load, and may not pinch.
struct Grip {
  Grip(const Problem& all, const Options& options, const std::vector<std::string>& fingers,
       const std::string& pre_shape);

  Problem problem;  ///< its hand has these fingers and this pre-shape only
  Options options;
};

/// Names of runs of neighbouring fingers, longest first, the whole hand included.
std::vector<std::vector<std::string>> finger_runs(const Hand& hand);

/// Width of the whole hand across its fingers [m]. A hole is small if it may be narrower.
double hand_width(const Problem& problem);
bool is_small(const Problem& problem, int loop, double hand_width);

}  // namespace graspless::clasp
