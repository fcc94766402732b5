// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/stability.hpp"

#include <stdexcept>

#include "clasp/parameters.hpp"
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
  return StabilityTester(problem).test(q, loop_points(problem, loop), options);
}

Hang find_hang(const Problem& problem, const Eigen::VectorXd& q, int loop) {
  validate(problem);
  robot::require_configuration(problem.robot, q, "q");
  return StabilityTester(problem).hang(q, loop_points(problem, loop));
}

}  // namespace graspless::clasp
