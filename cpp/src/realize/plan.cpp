// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Fingertip plans, the best one first, until the robot carries one out well.
#include <algorithm>
#include <limits>
#include <utility>

#include "graspless/realize/realize.hpp"

#include "realize/attempt.hpp"
#include "text.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kNearer = 0.96;  // of the fingertips' distance in the plan before
constexpr double kShare = 0.5;    // of the time that is left, for a plan that is not the last

/// Largest distance between the centres of two fingertips that touch [m].
double span_of(const Plan& plan, double radius) {
  double span = 0;
  for (const Segment& segment : plan.segments) {
    for (const Row& row : segment.rows) {
      for (const FingerState& a : row.fingers) {
        for (const FingerState& b : row.fingers) {
          if (!a.touches || !b.touches) continue;
          span = std::max(span, (a.p_OC - b.p_OC - radius * (a.n_O - b.n_O)).norm());
        }
      }
    }
  }
  return span;
}

double scrub_of(const Realization& realization) {
  if (!realization) return std::numeric_limits<double>::infinity();
  double most = 0;
  for (const JointSegment& segment : realization.segments) most = std::max(most, segment.scrub);
  return most;
}

planning::Budget rest(const planning::Budget& budget, const planning::Clock& clock, double share) {
  planning::Budget left = budget;
  left.seconds = std::max(1e-9, share * (budget.seconds - clock.seconds()));
  return left;
}

/// Says what became of the best plan, for one that is kept instead.
std::string warning(const CarriedPlan& best, const CarriedPlan& kept, double radius) {
  const double scrub = scrub_of(best.realization);
  return "the best plan costs " + figure(best.plan.cost, 3) + " m" +
         ", but the robot cannot carry it out" +
         (best.realization
              ? " with fingertips that slip by less than " + figure(1e3 * scrub, 3) + " mm"
              : ": " + best.realization.reason) +
         "; in this one, fingertips are at most " + figure(1e3 * span_of(kept.plan, radius), 3) +
         " mm" + " apart";
}

/// The best plan, with the reasons why neither it nor the last one that was tried is carried out.
CarriedPlan refused(CarriedPlan best, int tried, const std::string& last) {
  best.plan.status = Status::not_realized;
  best.plan.reason = best.realization.reason;
  if (tried > 1) {
    best.plan.reason += "; " + std::to_string(tried - 1) +
                        " more with fingertips nearer together failed too, the last: " + last;
  }
  return best;
}

/// The kept plan, with what became of the best.
CarriedPlan instead(const CarriedPlan& best, CarriedPlan kept, double radius) {
  kept.plan.lower_bound = std::min(best.plan.lower_bound, kept.plan.cost);
  kept.plan.warnings.push_back(warning(best, kept, radius));
  return kept;
}

}  // namespace

CarriedPlan plan_carried(const Problem& problem, const Options& options, const robot::Robot& robot,
                         const Carrier& carrier, const Eigen::VectorXd& q_home,
                         const RealizeOptions& realize_options, const planning::Budget& budget) {
  planning::Clock clock(budget);
  CarriedPlan next{plan(problem, options, budget), {}};
  if (!next.plan) return next;
  CarriedPlan best = next, kept = next;
  Problem nearer = problem;
  Options brief = options;
  brief.explain = false;
  const int plans = problem.fingers.start.empty() ? realize_options.plans : 1;
  std::string last;
  int tried = 0;
  while (next.plan && !(tried > 0 && clock.is_out())) {
    const bool is_last = ++tried == plans;
    next.realization = realize(problem, next.plan, robot, carrier, q_home, realize_options,
                               rest(budget, clock, is_last ? 1 : kShare));
    last = next.realization.reason;
    if (tried == 1) best = kept = next;
    const double scrub = scrub_of(next.realization);
    if (scrub < scrub_of(kept.realization)) kept = next;
    nearer.fingers.max_span = kNearer * span_of(next.plan, problem.fingers.radius);
    if (is_last || scrub <= realize_options.max_scrub ||
        nearer.fingers.max_span < 2 * problem.fingers.radius)
      break;
    // The start at home is that of the best plan, whichever is tried.
    if (tried == 1 &&
        !realize::home_collision(problem, best.plan, robot, carrier, q_home, realize_options)
             .empty())
      break;
    next.plan = plan(nearer, brief, rest(budget, clock, 1));
  }
  if (!kept.realization) return refused(std::move(best), tried, last);
  if (kept.plan.cost == best.plan.cost) return kept;
  return instead(best, std::move(kept), problem.fingers.radius);
}

}  // namespace graspless::fingertip
