// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/stability.hpp"

#include <sstream>
#include <stdexcept>
#include <string>

#include "clasp/stability/tester.hpp"

namespace graspless::clasp {
namespace {

void require(bool good, const std::string& field, double value, const std::string& choices) {
  if (good) return;
  std::ostringstream text;
  text.precision(10);
  text << "stability." << field << " must be " << choices << ", not " << value;
  throw std::invalid_argument(text.str());
}

}  // namespace

void validate(const StabilityOptions& options) {
  const auto in = [](double value, double low, double high) {
    return value >= low && value <= high;
  };
  require(in(options.sequences, 1, 1000), "sequences", options.sequences, "in [1, 1000]");
  require(in(options.moves, 1, 10000), "moves", options.moves, "in [1, 10000]");
  require(in(options.step, 1e-4, 0.1), "step", options.step, "in [0.0001, 0.1] m");
  require(in(options.turn, 1e-3, 1), "turn", options.turn, "in [0.001, 1] rad");
  require(in(options.penetration, 0, 0.05), "penetration", options.penetration, "in [0, 0.05] m");
  require(in(options.escape_distance, 0, 10), "escape_distance", options.escape_distance,
          "0 or at most 10 m");
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
