// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(): what holds the object at each instant.
#include <algorithm>
#include <cmath>

#include "graspless/mechanics/contact_patch.hpp"

#include "fingertip/check/check.hpp"
#include "mechanics/contacts/cones.hpp"

namespace graspless::fingertip::checking {
namespace {

constexpr double kRoundStability = 1e-7;  // relative, of stabilities

bool differs(double a, double b) {
  return !(std::abs(a - b) <= kRoundStability * std::max(1.0, b));
}

std::vector<mechanics::Plane> planes_of(const Problem& problem) {
  std::vector<mechanics::Plane> planes;
  for (const Plane& plane : problem.planes) {
    planes.push_back({plane.name, plane.n_W.normalized(), plane.offset, problem.friction.lower});
  }
  return planes;
}

}  // namespace

bool Examination::is_interval() const {
  return problem_.friction.lower < problem_.friction.upper ||
         problem_.fingers.friction.lower < problem_.fingers.friction.upper;
}

/// Pose and twist of the object. At rest the twist only turns the friction cones, and is that of
/// the motion that follows.
mechanics::BodyState Examination::state(std::size_t s, std::size_t r) const {
  mechanics::BodyState state;
  state.X_WO = row_pose(s, r);
  state.at_rest = is_regrasp(s);
  std::size_t moving = s, arc = r / static_cast<std::size_t>(options_.samples_per_arc);
  while (is_regrasp(moving)) ++moving, arc = 0;
  const Vector6d twist_O = arc_twist(moving, arc);
  state.twist_W << state.X_WO.linear() * twist_O.head<3>(), state.X_WO.linear() * twist_O.tail<3>();
  return state;
}

/// Takes contacts from geometry and fingers from the plan. Returns what is wrong with them.
std::string Examination::find_instant(std::size_t s, std::size_t r, Instant& instant) const {
  const Object& object = problem_.object;
  const mechanics::BodyState at = state(s, r);
  const mechanics::ContactPatches patches = mechanics::contact_patches(
      object.hull(), object.com(), planes_of(problem_), at, same_length_);
  if (!patches.fault.empty()) return patches.fault;
  if (patches.contacts.empty()) return "the object touches nothing";
  instant.set.contacts = patches.contacts;
  instant.set.com_O = object.com();
  instant.set.known_wrench_O =
      mechanics::gravity_wrench(object.mass(), at.X_WO.linear().transpose() * problem_.gravity_W);
  instant.set.wrench_scale = wrench_scale_;
  instant.set.cone_edges = options_.cone_edges;
  std::vector<double> commanded;
  for (const FingerState& finger : segment(s).rows[r].fingers) {
    if (!finger.touches) continue;
    instant.set.fingers.push_back({finger.p_OC, finger.n_O, problem_.fingers.friction.lower,
                                   problem_.fingers.max_normal_force, Eigen::Vector3d::Zero()});
    instant.modes.push_back(finger.mode);
    commanded.push_back(finger.commanded_force);
  }
  instant.commanded_forces =
      Eigen::Map<Eigen::VectorXd>(commanded.data(), static_cast<Eigen::Index>(commanded.size()));
  return "";
}

/// Verdict on an instant. Equal instants are solved once.
const Verdict& Examination::judged(const Instant& instant) {
  const double length = 1e-3 * same_length_, force = 1e-3 * same_force_;
  for (const Verdict& known : verdicts_) {
    if (is_near(known.instant, instant, length, force)) return known;
  }
  verdicts_.push_back(judge(instant));
  return verdicts_.back();
}

Verdict Examination::judge(const Instant& instant) const {
  const mechanics::Matrix6Xd& directions = options_.disturbance_directions;
  const FrictionInterval &env = problem_.friction, &fingers = problem_.fingers.friction;
  Verdict verdict;
  verdict.instant = instant;
  verdict.stability = stability_at(instant, directions);
  const auto cannot_jam = [&](double slide) {
    return mechanics::internal_force_is_bounded(
        with_friction(instant.set, slide, env.upper, fingers.upper), instant.modes,
        mechanics::Engine::reference);
  };
  verdict.is_bounded = cannot_jam(env.lower) && (!is_interval() || cannot_jam(env.upper));
  if (is_interval()) {
    // A wider cone can only help a contact that sticks. It turns the force of one that slides.
    Instant upper = instant;
    upper.set = with_friction(instant.set, env.upper, env.lower, fingers.lower);
    verdict.stability = std::min(verdict.stability, stability_at(upper, directions));
    verdict.over_friction =
        mechanics::holds_over_friction(instant.set, instant.modes, instant.commanded_forces, env,
                                       fingers, options_.min_stability, directions);
  }
  const auto nominal = mechanics::compliant_equilibrium(
      instant.set, instant.modes, instant.commanded_forces, options_.compliance, directions);
  if (nominal) {
    verdict.compliant_stability = mechanics::compliant_stability(
        instant.set, instant.modes, *nominal, options_.compliance, directions);
  }
  return verdict;
}

void Examination::check_mechanics(std::size_t s, std::size_t r) {
  Instant instant;
  const std::string wrong = find_instant(s, r, instant);
  if (!wrong.empty()) return fault(place(s, r), "contacts: " + wrong);
  const Row& row = segment(s).rows[r];
  const Verdict& found = judged(instant);
  if (!found.is_bounded) fault(place(s, r), "modes: the fingers can jam the object");
  // Where friction is an interval, a plan may promise less than both ends allow.
  const bool short_of = is_interval() ? row.stability > found.stability * (1 + kRoundStability)
                                      : differs(row.stability, found.stability);
  if (short_of || row.stability < options_.min_stability * (1 - kRoundStability)) {
    fault(place(s, r), "stability: " + figure(found.stability) + ", promised " +
                           figure(row.stability) + " (needed " + figure(options_.min_stability) +
                           ")");
  }
  if (is_interval() && !found.over_friction.holds) {
    fault(place(s, r), "friction: fails at " + figure(found.over_friction.environment) + ", " +
                           figure(found.over_friction.fingers) +
                           " (environment, fingers): " + found.over_friction.reason);
  }
  if (differs(row.compliant_stability, found.compliant_stability)) {
    fault(place(s, r), "compliant stability: " + figure(found.compliant_stability) + ", promised " +
                           figure(row.compliant_stability));
  }
  check_nominal(s, r, instant);
}

/// Checks the nominal forces: as commanded, within cones and limits, and in balance with some
/// forces of the environment.
void Examination::check_nominal(std::size_t s, std::size_t r, const Instant& instant) {
  const Row& row = segment(s).rows[r];
  Eigen::Matrix3Xd forces_O(3, static_cast<Eigen::Index>(instant.set.fingers.size()));
  Eigen::Index k = 0;
  for (std::size_t i = 0; i < row.fingers.size(); ++i) {
    const FingerState& finger = row.fingers[i];
    if (!finger.touches) continue;
    forces_O.col(k++) = finger.nominal_force_O;
    const double normal = finger.n_O.dot(finger.nominal_force_O);
    if (finger.mode == FingerMode::position) continue;
    if (std::abs(normal - finger.commanded_force) > same_force_) {
      fault(place(s, r), "finger " + std::to_string(i) + ": nominal force " + figure(normal) +
                             " N along the normal, commanded " + figure(finger.commanded_force));
    }
  }
  Instant round = instant;
  round.set = mechanics::with_round_cones(round.set);
  const auto margin = margin_of(round, forces_O, same_force_);
  if (!margin) {
    fault(place(s, r), "nominal forces: out of cones or limits, or not in balance");
  } else if (row.nominal_margin > *margin + 2 * same_force_ || row.nominal_margin < 0) {
    fault(place(s, r),
          "nominal margin: " + figure(*margin) + ", promised " + figure(row.nominal_margin));
  }
}

}  // namespace graspless::fingertip::checking
