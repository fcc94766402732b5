// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Friction known as an interval, by counter-examples: a search looks at a few coefficients alone,
// and a plan it finds is proven for all or gives another to look at.
#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>
#include <vector>

#include "graspless/watch.hpp"

#include "fingertip/model/screw.hpp"
#include "fingertip/planner.hpp"

namespace graspless::fingertip {
namespace {

constexpr int kRounds = 6;  // for each uncertain surface

/// Maximum number of searches after the first.
int max_rounds(const Problem& problem) {
  const FrictionInterval& fingers = problem.fingers.friction;
  return kRounds * std::max(num_intervals(problem), fingers.lower < fingers.upper ? 1 : 0);
}

/// A row's contacts, modes and forces.
struct Asked {
  int instant;
  std::vector<FingerState> fingers;
};

bool are_same(const FingerState& a, const FingerState& b) {
  return a.touches == b.touches &&
         (!a.touches || (a.mode == b.mode && a.commanded_force == b.commanded_force &&
                         a.p_OC == b.p_OC && a.n_O == b.n_O));
}

bool are_same(const Asked& a, const Asked& b) {
  return a.instant == b.instant &&
         std::equal(a.fingers.begin(), a.fingers.end(), b.fingers.begin(), b.fingers.end(),
                    [](const FingerState& x, const FingerState& y) { return are_same(x, y); });
}

mechanics::FrictionVerdict verdict(const Problem& problem, const Options& options,
                                   const Instants& instants, int at,
                                   const std::vector<FingerState>& fingers) {
  const Instant& instant = instants[at];
  mechanics::ContactSet set = instant.set;
  std::vector<FingerMode> modes;
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(fingers.size()));
  for (const FingerState& finger : fingers) {
    if (!finger.touches) continue;
    forces[modes.size()] = finger.commanded_force;
    modes.push_back(finger.mode);
    set.fingers.push_back({finger.p_OC, finger.n_O, problem.fingers.friction.lower,
                           problem.fingers.max_normal_force, Eigen::Vector3d::Zero()});
  }
  forces.conservativeResize(static_cast<Eigen::Index>(modes.size()));
  return mechanics::holds_over_friction(
      set, modes, forces, {instants.frictions(), instant.surfaces}, problem.fingers.friction,
      options.min_stability, options.disturbance_directions);
}

/// The object's state at a row; a regrasp's cones turn with the motion that goes on after it.
mechanics::BodyState state_at(const Options& options, const Plan& plan, std::size_t s,
                              std::size_t r) {
  const Segment& segment = plan.segments[s];
  std::size_t next = s;
  while (next + 1 < plan.segments.size() && plan.segments[next].finger >= 0) ++next;
  const bool rests = segment.finger >= 0;
  const std::size_t arc = rests ? 0 : r / static_cast<std::size_t>(options.samples_per_arc);
  const std::vector<Eigen::Isometry3d>& X_WO = plan.segments[next].X_WO;
  const mechanics::Vector6d twist_O = screw_between(X_WO[arc], X_WO[arc + 1]);
  const Eigen::Isometry3d& at = segment.rows[r].X_WO;
  return rests ? resting_state(at, twist_O) : moving_state(at, twist_O);
}

/// "0.5 (environment), 0.2 (plane 'behind') and 0.7 (fingers)"
std::string coefficients_of(const Problem& problem, const mechanics::FrictionVerdict& verdict) {
  std::ostringstream out;
  auto coefficient = verdict.environment.begin();
  if (shares_friction(problem)) out << *coefficient << " (environment)";
  for (const Plane& plane : problem.planes) {
    if (!plane.friction) continue;
    out << (out.tellp() > 0 ? ", " : "") << *++coefficient << " (plane '" << plane.name << "')";
  }
  out << " and " << verdict.fingers << " (fingers)";
  return out.str();
}

std::string sentence(const Problem& problem, const Plan& plan, const FrictionFailure& failure,
                     bool gave_up) {
  std::ostringstream out;
  out << (gave_up ? "the search gave up, having found no plan that holds" : "no plan holds")
      << " for every friction in the intervals: the last one found fails at "
      << coefficients_of(problem, failure.verdict) << " in segment " << failure.segment << " ("
      << plan.segments[failure.segment].name << "), row " << failure.row << ": "
      << failure.verdict.reason;
  return out.str();
}

std::size_t num_rows(const Plan& plan) {
  std::size_t rows = 0;
  for (const Segment& segment : plan.segments) rows += segment.rows.size();
  return rows;
}

}  // namespace

std::optional<FrictionFailure> find_friction_failure(const Problem& problem, const Options& options,
                                                     Instants& instants, const Plan& plan) {
  std::vector<Asked> held;
  for (std::size_t s = 0; s < plan.segments.size(); ++s) {
    for (std::size_t r = 0; r < plan.segments[s].rows.size(); ++r) {
      poll();
      const Asked asked = {instants.add(state_at(options, plan, s, r)),
                           plan.segments[s].rows[r].fingers};
      if (std::any_of(held.begin(), held.end(),
                      [&](const Asked& other) { return are_same(asked, other); })) {
        continue;
      }
      const mechanics::FrictionVerdict found =
          verdict(problem, options, instants, asked.instant, asked.fingers);
      if (!found.holds) {
        return FrictionFailure{static_cast<int>(s), static_cast<int>(r), found};
      }
      held.push_back(asked);
    }
  }
  return std::nullopt;
}

void plan_over_friction(const Problem& problem, const Options& options, Instants& instants,
                        planning::Clock& clock, const std::function<Plan()>& search, Plan& plan) {
  plan = search();
  const int rounds = max_rounds(problem);
  if (rounds == 0) return;
  std::vector<double> last;
  for (int round = 0; plan; ++round) {
    std::optional<FrictionFailure> failure;
    const auto examine = [&] { failure = find_friction_failure(problem, options, instants, plan); };
    if (!clock.conclude(examine, num_rows(plan))) throw Stop{};
    if (!failure) break;
    // Coefficients that can be neither proven nor refuted come again, so the search ends.
    const bool gives_up = round == rounds || failure->verdict.environment == last;
    last = failure->verdict.environment;
    const std::string why = sentence(problem, plan, *failure, gives_up);
    if (!gives_up) {
      instants.add_friction(failure->verdict.environment);
      plan = search();
    } else {
      plan = Plan();
      plan.status = Status::unstable;
    }
    if (plan.status == Status::unstable) plan.reason = why;
  }
}

}  // namespace graspless::fingertip
