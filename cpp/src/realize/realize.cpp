// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Joint paths for a fingertip plan: which fingertip plays which finger, and from where to begin.
#include "graspless/realize/realize.hpp"

#include <algorithm>
#include <numeric>

#include "realize/attempt.hpp"
#include "realize/validate.hpp"

namespace graspless::realize {
namespace {

constexpr double kLittle = 0.01;  // scrub, in radii, that nobody needs to improve

/// All values of finger_of_fingertip.
std::vector<std::vector<int>> assignments(int fingers) {
  std::vector<int> assignment(fingers);
  std::iota(assignment.begin(), assignment.end(), 0);
  std::vector<std::vector<int>> all;
  do all.push_back(assignment);
  while (std::next_permutation(assignment.begin(), assignment.end()));
  return all;
}

double total_scrub(const std::vector<JointSegment>& segments) {
  double sum = 0;
  for (const JointSegment& segment : segments) sum += segment.scrub;
  return sum;
}

void keep_better(const Attempts& attempt, Realization& result) {
  if (result.found && total_scrub(attempt.segments()) >= total_scrub(result.segments)) return;
  result.found = true;
  result.finger_of_fingertip = attempt.finger_of_fingertip();
  result.segments = attempt.segments();
}

std::string reason(planning::Clock& clock, const Misses& misses) {
  if (!clock.ran_out()) return misses.farthest();
  const std::string what = clock.was_interrupted() ? "interrupted" : "out of time";
  return what + "; the farthest attempt ended at " + misses.farthest();
}

/// Fills the result; stops as soon as the fingertips hardly scrub.
void search(const Problem& problem, const Plan& plan, const robot::Robot& robot,
            const Carrier& carrier, const Eigen::VectorXd& q_home, const RealizeOptions& options,
            planning::Clock& clock, std::mt19937_64& rng, Realization& result) {
  validate_realization(problem, plan, robot, carrier, options);
  robot::require_configuration(robot, q_home, "q_home");
  Misses misses;
  std::vector<Attempts> attempts;
  for (const std::vector<int>& assignment : assignments(problem.fingers.count)) {
    Hand hand(problem, robot, carrier, assignment, options);
    attempts.emplace_back(problem, plan, q_home, std::move(hand), clock, rng, misses);
  }
  result.reason = home_collision(problem, plan, robot, carrier, q_home, options);
  if (!result.reason.empty()) return;
  int found = 0;
  for (int round = 0; round < options.restarts && found < options.solutions && !clock.ran_out();
       ++round) {
    for (Attempts& attempt : attempts) {
      if (!clock.spend()) break;
      if (!attempt.run(round)) continue;
      ++found;
      keep_better(attempt, result);
      if (total_scrub(result.segments) <= kLittle * problem.fingers.radius) return;
    }
  }
  if (!result) result.reason = reason(clock, misses);
}

}  // namespace

std::string home_collision(const Problem& problem, const Plan& plan, const robot::Robot& robot,
                           const Carrier& carrier, const Eigen::VectorXd& q_home,
                           const RealizeOptions& options) {
  Hand hand(problem, robot, carrier, assignments(problem.fingers.count).front(), options);
  hand.scene.place_object(plan.segments.front().X_WO.front());
  const std::string collision = hand.scene.collision(q_home);
  return collision.empty() ? "" : "q_home: " + collision;
}

}  // namespace graspless::realize

namespace graspless::fingertip {

Realization realize(const Problem& problem, const Plan& plan, const robot::Robot& robot,
                    const Carrier& carrier, const Eigen::VectorXd& q_home,
                    const RealizeOptions& options, const planning::Budget& budget) {
  planning::Clock clock(budget);
  std::mt19937_64 rng(budget.seed);
  Realization result;
  result.joint_names = robot.joint_names();
  const auto search = [&] {
    graspless::realize::search(problem, plan, robot, carrier, q_home, options, clock, rng, result);
  };
  if (!clock.run(search) && !result) result.reason = clock.reason();
  return result;
}

}  // namespace graspless::fingertip
