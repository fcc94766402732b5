// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/grip.hpp"

#include <algorithm>

#include "clasp/parameters.hpp"

namespace graspless::clasp {

Grip::Grip(const Problem& all, const Options& options, const std::vector<std::string>& names,
           const std::string& pre_shape)
    : problem(all), options(options) {
  std::vector<std::string>& others = problem.hand.pre_shapes;
  if (std::find(others.begin(), others.end(), pre_shape) != others.end())
    problem.hand.open = pre_shape;
  others.clear();
  if (names.empty()) return;
  std::vector<Finger>& fingers = problem.hand.fingers;
  const auto is_other = [&](const Finger& finger) {
    return std::find(names.begin(), names.end(), finger.name) == names.end();
  };
  fingers.erase(std::remove_if(fingers.begin(), fingers.end(), is_other), fingers.end());
  if (fingers.size() < all.hand.fingers.size()) this->options.friction = 0;
}

std::vector<std::vector<std::string>> finger_runs(const Hand& hand) {
  std::vector<std::vector<std::string>> runs;
  for (std::size_t length = hand.fingers.size(); length > 0; --length) {
    for (std::size_t first = 0; first + length <= hand.fingers.size(); ++first) {
      runs.emplace_back();
      for (std::size_t i = first; i < first + length; ++i)
        runs.back().push_back(hand.fingers[i].name);
    }
  }
  return runs;
}

double hand_width(const Problem& problem) { return 2 * half_width(problem.robot, problem.hand); }

/// A ball as wide as the edges that fill the hole passes it.
bool is_small(const Problem& problem, int loop, double hand_width) {
  return problem.object.loops().found[loop].death < hand_width;
}

}  // namespace graspless::clasp
