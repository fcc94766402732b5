// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "fingertip/model/instants.hpp"
#include "fingertip/planner.hpp"

namespace graspless::fingertip {
namespace {

constexpr double kFine = 1.01;           // relaxations are found to 1 %
constexpr double kFarthest = 1000;       // how far limits are turned at most, as a factor
constexpr double kLeastFriction = 0.05;  // coefficient from which a friction of 0 is scaled
// Factors tried on coefficients of friction. Solvable values may lie between others, so each factor
// is tried.
constexpr double kLadder[] = {1.05, 1.1, 1.2, 1.4, 1.8, 2.6, 4.2, 7.4, 13.8};

/// A parameter that can be changed to make a problem easier.
struct Knob {
  std::string field, limit;
  double given;  ///< value in the problem
  double value;  ///< the same, or the value that factors scale where it is 0
  std::function<void(Problem&, Options&, double factor)> turn;
};

double scalable(double friction) { return friction > 0 ? friction : kLeastFriction; }

void scale(FrictionInterval& friction, double factor) {
  friction.lower = scalable(friction.lower) * factor;
  friction.upper = scalable(friction.upper) * factor;
}

const auto turn_finger_friction = [](Problem& problem, Options&, double factor) {
  scale(problem.fingers.friction, factor);
};
const auto turn_friction = [](Problem& problem, Options&, double factor) {
  scale(problem.friction, factor);
};
const auto turn_force = [](Problem& problem, Options&, double factor) {
  problem.fingers.max_normal_force *= factor;
};
const auto turn_stability = [](Problem&, Options& options, double factor) {
  options.min_stability *= factor;
};

/// Plans anew with other parameters.
class Trials {
 public:
  Trials(const Problem& problem, const Options& options, planning::Clock& clock)
      : problem_(problem), options_(options), clock_(clock) {
    options_.explain = false;
    options_.search = Search::fast;
    max_regrasps_ = options.max_regrasps;
  }

  /// Excluding many regrasps takes long. Without them a trial takes milliseconds.
  void allow_regrasps(int count) { options_.max_regrasps = std::min(count, max_regrasps_); }

  bool solves(const std::function<void(Problem&, Options&)>& change) {
    if (clock_.is_out()) return false;
    Problem problem = problem_;
    Options options = options_;
    change(problem, options);
    planning::Budget rest;
    rest.seconds = std::numeric_limits<double>::infinity();
    rest.interrupted = [this] { return clock_.is_out(); };
    try {
      return plan(problem, options, rest).status == Status::solved;
    } catch (const std::logic_error&) {  // no longer a problem that can be posed
      return false;
    } catch (const std::runtime_error&) {  // nor solved
      return false;
    }
  }
  bool solves(const Knob& knob, double factor) {
    return solves([&](Problem& problem, Options& options) { knob.turn(problem, options, factor); });
  }

 private:
  const Problem& problem_;
  Options options_;
  planning::Clock& clock_;
  int max_regrasps_;
};

/// The least factor that helps, between one that does not and one that does.
double bisect(Trials& trials, const Knob& knob, double fails, double helps) {
  while (std::abs(std::log(helps / fails)) > std::log(kFine)) {
    const double middle = std::sqrt(fails * helps);
    (trials.solves(knob, middle) ? helps : fails) = middle;
  }
  return helps;
}

/// The least factor that helps, where more always helps.
std::optional<double> least_of_monotone(Trials& trials, const Knob& knob, double farthest) {
  if (!trials.solves(knob, farthest)) return std::nullopt;
  return bisect(trials, knob, 1, farthest);
}

/// The least factor that helps, found step by step: upwards and, if wanted, downwards.
std::optional<double> least_of_ladder(Trials& trials, const Knob& knob, bool down_too) {
  double last = 1;
  for (const double factor : kLadder) {
    if (trials.solves(knob, factor)) return bisect(trials, knob, last, factor);
    if (down_too && trials.solves(knob, 1 / factor)) {
      return bisect(trials, knob, 1 / last, 1 / factor);
    }
    last = factor;
  }
  return std::nullopt;
}

/// A change that helps.
struct Found {
  Knob knob;
  double factor;
};

/// Friction that planes share, and that of each plane with its own.
std::vector<Knob> friction_knobs(const Problem& problem) {
  std::vector<Knob> knobs;
  const auto add = [&](const std::string& field, const FrictionInterval& given,
                       const std::function<void(Problem&, Options&, double)>& turn) {
    knobs.push_back({field, "friction", given.lower, scalable(given.lower), turn});
  };
  if (shares_friction(problem)) add("friction", problem.friction, turn_friction);
  for (std::size_t i = 0; i < problem.planes.size(); ++i) {
    const Plane& plane = problem.planes[i];
    if (!plane.friction) continue;
    add("planes[" + std::to_string(i) + "] '" + plane.name + "'.friction", *plane.friction,
        [i](Problem& changed, Options&, double factor) {
          scale(*changed.planes[i].friction, factor);
        });
  }
  return knobs;
}

std::vector<Found> find_helpful(const Problem& problem, const Options& options, Trials& trials) {
  const Knob force = {"fingers.max_normal_force", "force limit", problem.fingers.max_normal_force,
                      problem.fingers.max_normal_force, turn_force};
  const Knob fingers = {"fingers.friction", "friction", problem.fingers.friction.lower,
                        scalable(problem.fingers.friction.lower), turn_finger_friction};
  const Knob stability = {"min_stability", "stability", options.min_stability,
                          options.min_stability, turn_stability};
  std::vector<Found> found;
  const auto keep = [&](const Knob& knob, std::optional<double> factor) {
    if (factor) found.push_back({knob, *factor});
  };
  if (options.min_stability > 0) {
    keep(stability, least_of_monotone(trials, stability, 1 / kFarthest));
  }
  keep(force, least_of_monotone(trials, force, kFarthest));
  keep(fingers, least_of_ladder(trials, fingers, false));
  for (const Knob& plane : friction_knobs(problem)) {
    keep(plane, least_of_ladder(trials, plane, true));
  }
  return found;
}

void sort_least_first(std::vector<Found>& found) {
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    return std::abs(std::log(a.factor)) < std::abs(std::log(b.factor));
  });
}

/// Single changes that help, the smallest first. They are found with one regrasp at most. In the
/// time left, smaller changes are tried with more regrasps.
std::vector<Found> relax(const Problem& problem, const Options& options, Trials& trials) {
  trials.allow_regrasps(1);
  std::vector<Found> found = find_helpful(problem, options, trials);
  sort_least_first(found);
  if (options.max_regrasps <= 1) return found;
  trials.allow_regrasps(options.max_regrasps);
  if (found.empty()) found = find_helpful(problem, options, trials);
  for (Found& each : found) {
    const double less = each.factor > 1 ? each.factor / kFine : each.factor * kFine;
    if (trials.solves(each.knob, less)) each.factor = bisect(trials, each.knob, 1, less);
  }
  sort_least_first(found);
  return found;
}

bool all_at_once_solve(Trials& trials) {
  return trials.solves([](Problem& problem, Options& options) {
    turn_force(problem, options, kFarthest);
    turn_stability(problem, options, 1 / kFarthest);
    turn_finger_friction(problem, options, 2);
  });
}

std::string sentence(const Found& best) {
  std::ostringstream out;
  out << "; " << best.knob.field << " " << best.knob.value * best.factor << " instead of "
      << best.knob.given << " would do";
  return out.str();
}

}  // namespace

void explain(const Problem& problem, const Options& options, planning::Clock& clock, Plan& plan) {
  if (plan.status != Status::no_location && plan.status != Status::unstable) return;
  if (!plan.limit.empty()) return;  // the motion itself was out of reach
  if (const auto blocked = find_blocked(problem, options)) {
    plan.limit = blocked->limit;
    plan.reason = blocked->reason;
    return;
  }
  Trials trials(problem, options, clock);
  const std::vector<Found> found = relax(problem, options, trials);
  for (const Found& each : found) {
    plan.relaxations.push_back({each.knob.field, each.knob.value * each.factor});
  }
  if (!found.empty()) {
    plan.limit = found.front().knob.limit;
    plan.reason += sentence(found.front());
  } else if (!clock.is_out()) {
    plan.limit = all_at_once_solve(trials) ? "stability" : "reach of the lattice";
    plan.reason += "; no single change of friction, force limit or min_stability would help";
  }
}

}  // namespace graspless::fingertip
