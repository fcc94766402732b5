// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/stability.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "clasp/stability_tester.hpp"

namespace graspless::clasp {
namespace {

void require(bool good, const std::string& field, double value, const std::string& choices) {
  if (good) return;
  throw std::invalid_argument("stability." + field + " must be " + choices + ", not " +
                              std::to_string(value));
}

}  // namespace

void validate(const StabilityOptions& options) {
  const auto in = [](double value, double low, double high) {
    return value > low && value <= high;
  };
  require(in(options.sequences, 0, 1000), "sequences", options.sequences, "1 to 1000");
  require(in(options.moves, 0, 100000), "moves", options.moves, "1 to 100000");
  require(in(options.step, 1e-6, 0.1), "step", options.step, "in (0.000001, 0.1] m");
  require(in(options.turn, 1e-6, 1), "turn", options.turn, "in (0.000001, 1] rad");
  require(options.penetration >= 0 && options.penetration <= 0.05, "penetration",
          options.penetration, "in [0, 0.05] m");
  require(options.escape_distance >= 0 && options.escape_distance <= 100, "escape_distance",
          options.escape_distance, "0 or a length of at most 100 m");
}

Stability test_stability(const Problem& problem, const Eigen::VectorXd& q, int loop,
                         const StabilityOptions& options) {
  validate(problem);
  validate(options);
  robot::require_configuration(problem.robot, q, "q");
  const auto& loops = problem.object.loops().loops;
  if (loop < 0 || loop >= static_cast<int>(loops.size())) {
    throw std::invalid_argument("loop must be the index of one of the " +
                                std::to_string(loops.size()) + " loops of object '" +
                                problem.object.name() + "', not " + std::to_string(loop));
  }
  return StabilityTester(problem).test(q, loops[static_cast<std::size_t>(loop)].points, options);
}

}  // namespace graspless::clasp
