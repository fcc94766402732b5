// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// From pose to pose with any face down: contact states first, then the search of each path.
#include "fingertip/goal/goal.hpp"

#include <stdexcept>
#include <string>

#include "fingertip/goal/contact_states.hpp"
#include "fingertip/goal/paths.hpp"
#include "fingertip/goal/search.hpp"

namespace graspless::fingertip {
namespace {

constexpr int kMaxSequences = 200;  // of one number of tumbles: a bound for hulls of many faces

/// The face that the object stands on by itself.
int standing_face(const Problem& problem, const ContactStates& states,
                  const Eigen::Isometry3d& X_WO, const std::string& field) {
  const Plane& floor = problem.planes.front();
  const double tolerance = kContactTolerance * problem.object.size();
  const int face = states.standing(X_WO, floor, tolerance);
  if (face < 0) {
    throw std::invalid_argument(field + " must have a face of the object's convex hull flush on '" +
                                floor.name + "'");
  }
  if (!states[face].is_stable) {
    throw std::invalid_argument(field + " must have the centre of mass over the face on '" +
                                floor.name + "': there the object would tip over");
  }
  return face;
}

void require_motion(const Problem& problem, const Goal& goal) {
  const Eigen::Isometry3d X = goal.X_WO_start.inverse() * goal.X_WO_goal;
  if (X.linear().isIdentity(1e-9) && X.translation().norm() < 1e-9 * problem.object.size()) {
    throw std::invalid_argument("motion.X_WO_goal must differ from motion.X_WO_start");
  }
}

Plan out_of_reach(int needed, const Goal& goal) {
  Plan plan;
  plan.status = Status::no_location;
  plan.limit = "reach of the lattice";
  plan.reason = needed < 0 ? "no sequence of tumbles leads to the goal's face"
                           : "the goal's face takes " + std::to_string(needed) +
                                 (needed == 1 ? " tumble" : " tumbles") + ", and max_tumbles is " +
                                 std::to_string(goal.max_tumbles);
  return plan;
}

/// Says that not all sequences of tumbles were looked at, and claims nothing of the others.
void admit_truncation(Plan& plan) {
  const std::string what = "only the first " + std::to_string(kMaxSequences) +
                           " ways to tumble to the goal's face were looked at";
  plan.warnings.push_back(what);
  if (plan.status == Status::solved) return;
  plan.lower_bound = 0;
  plan.reason += "; " + what;
  if (plan.status != Status::interrupted) plan.status = Status::out_of_time;
}

}  // namespace

Plan plan_goal(SearchContext& context, const Goal& goal, planning::Clock& clock) {
  const Problem& problem = context.problem;
  require_motion(problem, goal);
  const ContactStates states(problem.object);
  const int from = standing_face(problem, states, goal.X_WO_start, "motion.X_WO_start");
  const int to = standing_face(problem, states, goal.X_WO_goal, "motion.X_WO_goal");
  const int needed = states.tumbles_to(to)[static_cast<std::size_t>(from)];
  if (needed < 0 || needed > goal.max_tumbles) return out_of_reach(needed, goal);

  GoalSearch search(context, clock);
  bool is_truncated = false;
  for (int tumbles = needed; tumbles <= goal.max_tumbles; ++tumbles) {
    auto sequences = tumble_sequences(states, from, to, tumbles, kMaxSequences + 1);
    if (sequences.size() > kMaxSequences) {
      is_truncated = true;
      sequences.resize(kMaxSequences);
    }
    for (const TumbleSequence& sequence : sequences) {
      search.add(goal_paths(problem, goal, states, from, sequence), tumbles_alone(goal, sequence));
    }
    if (search.run()) break;
  }
  Plan plan = search.plan();
  if (is_truncated) admit_truncation(plan);
  return plan;
}

}  // namespace graspless::fingertip
