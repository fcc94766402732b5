// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Validation of arguments for realize() and its check().
#include "realize/validate.hpp"

#include <cmath>
#include <set>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"

#include "text.hpp"

namespace graspless::realize {
namespace {

void check_fingertip(const robot::Robot& robot, const std::string& field, const std::string& link) {
  if ((robot.reach(robot.frame(link)).array() > 0).any()) return;
  throw std::invalid_argument(field + " '" + link + "' is not moved by any joint of the robot");
}

void check_carrier(const Carrier& carrier, const robot::Robot& robot, int fingers) {
  const auto count = static_cast<std::size_t>(fingers);
  if (carrier.fingertips.size() != count || carrier.links.size() != count) {
    throw std::invalid_argument(
        "carrier.fingertips and carrier.links must have one entry for each of the " +
        std::to_string(fingers) + " fingers, not " + std::to_string(carrier.fingertips.size()) +
        " and " + std::to_string(carrier.links.size()));
  }
  std::set<std::string> taken;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string field = "carrier.fingertips[" + std::to_string(i) + "]";
    check_fingertip(robot, field, carrier.fingertips[i]);
    if (!taken.insert(carrier.fingertips[i]).second) {
      throw std::invalid_argument(field + " '" + carrier.fingertips[i] + "' is given twice");
    }
    for (const std::string& link : carrier.links[i]) robot.frame(link);
  }
}

std::invalid_argument malformed(std::size_t segment, const std::string& what) {
  return std::invalid_argument("plan.segments[" + std::to_string(segment) + "] " + what);
}

void check_row(const Row& row, std::size_t segment, std::size_t fingers) {
  if (row.fingers.size() != fingers)
    throw malformed(segment, "has a row of " + std::to_string(row.fingers.size()) +
                                 " fingers instead of " + std::to_string(fingers));
  for (const FingerState& finger : row.fingers) {
    if (!finger.p_OC.allFinite()) throw malformed(segment, "has a contact that is not finite");
    if (!(std::abs(finger.n_O.norm() - 1) < 1e-3))
      throw malformed(segment, "has a normal of length " + figure(finger.n_O.norm()) + ", not 1");
  }
}

void check_segment(const Plan& plan, std::size_t k, std::size_t fingers) {
  const Segment& segment = plan.segments[k];
  const bool is_regrasp = segment.finger >= 0;
  if (is_regrasp && (k == 0 || k + 1 == plan.segments.size()))
    throw malformed(k, "is a regrasp: the first and the last must be displacements");
  if (segment.finger >= static_cast<int>(fingers))
    throw malformed(
        k, "moves finger " + std::to_string(segment.finger) + " of " + std::to_string(fingers));
  if (segment.X_WO.size() < (is_regrasp ? 1U : 2U)) throw malformed(k, "has too few poses");
  const std::size_t arcs = segment.X_WO.size() - 1;
  if (segment.rows.empty() || (arcs > 0 && segment.rows.size() % arcs != 0))
    throw malformed(k, "must have P rows for each of its " + std::to_string(arcs) + " arcs, not " +
                           std::to_string(segment.rows.size()) + " in all");
  for (const Eigen::Isometry3d& X_WO : segment.X_WO) {
    if (!geometry::is_pose(X_WO)) throw malformed(k, "has a pose that is not rigid");
  }
  for (const Row& row : segment.rows) check_row(row, k, fingers);
}

}  // namespace

void validate_realization(const Problem& problem, const Plan& plan, const robot::Robot& robot,
                          const Carrier& carrier, const RealizeOptions& options) {
  validate(problem);
  planning::require_in_range("options.", options);
  if (!plan) throw std::invalid_argument("plan is not solved: " + plan.reason);
  if (plan.segments.empty()) throw std::invalid_argument("plan.segments must not be empty");
  check_carrier(carrier, robot, problem.fingers.count);
  for (std::size_t k = 0; k < plan.segments.size(); ++k)
    check_segment(plan, k, static_cast<std::size_t>(problem.fingers.count));
}

}  // namespace graspless::realize
