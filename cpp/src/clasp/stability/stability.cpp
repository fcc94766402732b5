// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/stability.hpp"

#include <stdexcept>
#include <string>

#include "clasp/stability/tester.hpp"

namespace graspless::clasp {
void validate(const StabilityOptions& options) {
  planning::require_in_range("stability.", options);
  if (options.force == 0 && options.torque > 0) {
    throw std::invalid_argument(
        "stability.torque acts with a force, so stability.force must be above 0 where it is, not "
        "0; both may be 0");
  }
}

Stability test_stability(const Problem& problem, const Eigen::VectorXd& q, int loop,
                         const StabilityOptions& options) {
  validate(problem);
  validate(options);
  require_efforts(problem, options);
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
