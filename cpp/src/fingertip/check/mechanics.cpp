// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(): what holds the object at each instant.
#include <algorithm>
#include <cmath>

#include "graspless/mechanics/contact_patch.hpp"

#include "fingertip/check/check.hpp"
#include "mechanics/contacts/cones.hpp"
#include "text.hpp"

namespace graspless::fingertip::checking {
namespace {

constexpr double kRoundStability = 1e-7;   // relative, of stabilities
constexpr double kRoundWithstands = 1e-6;  // relative, of what springs withstand
constexpr double kRoundPlace = 1e-9;       // [m]

bool differs(double a, double b) {
  return !(std::abs(a - b) <= kRoundStability * std::max(1.0, b));
}

std::vector<mechanics::Plane> planes_of(const Problem& problem) {
  std::vector<mechanics::Plane> planes;
  for (const Plane& plane : problem.planes) {
    const double friction = (plane.friction ? *plane.friction : problem.friction).lower;
    planes.push_back({plane.name, plane.n_W.normalized(), plane.offset, friction});
  }
  return planes;
}

bool is_wide(const FrictionInterval& friction) { return friction.lower < friction.upper; }

/// Planes that have no friction of their own are one surface, each of the others is another.
mechanics::Surfaces surfaces_of(const Problem& problem, const std::vector<int>& plane_of_contact) {
  mechanics::Surfaces surfaces;
  surfaces.friction = {problem.friction};
  std::vector<int> of_plane;
  for (const Plane& plane : problem.planes) {
    of_plane.push_back(plane.friction ? static_cast<int>(surfaces.friction.size()) : 0);
    if (plane.friction) surfaces.friction.push_back(*plane.friction);
  }
  if (std::count(of_plane.begin(), of_plane.end(), 0) == 0)  // nothing has the shared friction
    surfaces.friction.front().upper = surfaces.friction.front().lower;
  for (const int plane : plane_of_contact) {
    surfaces.of_contact.push_back(of_plane[plane]);
  }
  return surfaces;
}

}  // namespace

bool Examination::is_interval() const {
  return is_wide(problem_.friction) || is_wide(problem_.fingers.friction) ||
         std::any_of(problem_.planes.begin(), problem_.planes.end(),
                     [](const Plane& plane) { return plane.friction && is_wide(*plane.friction); });
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
  instant.surfaces = surfaces_of(problem_, patches.plane);
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

Verdict Examination::judge(const Instant& instant) {
  const mechanics::Matrix6Xd& directions = options_.disturbance_directions;
  const FrictionInterval& fingers = problem_.fingers.friction;
  const End lower = &FrictionInterval::lower, upper = &FrictionInterval::upper;
  Verdict verdict;
  verdict.instant = instant;
  verdict.stability = stabilities_.least(instant);
  const auto cannot_jam = [&](End slide) {
    return mechanics::internal_force_is_bounded(with_friction(instant, slide, upper, fingers.upper),
                                                instant.modes, mechanics::Engine::reference);
  };
  verdict.is_bounded = cannot_jam(lower) && (!is_interval() || cannot_jam(upper));
  if (is_interval()) {
    // A wider cone can only help a contact that sticks. It turns the force of one that slides.
    Instant turned = instant;
    turned.set = with_friction(instant, upper, lower, fingers.lower);
    verdict.stability = std::min(verdict.stability, stabilities_.least(turned));
    verdict.over_friction = mechanics::holds_over_friction(
        instant.set, instant.modes, instant.commanded_forces, instant.surfaces, fingers,
        options_.min_stability, directions);
  }
  const auto springs =
      mechanics::sprung_along(instant.set, instant.modes, options_.compliance, directions);
  verdict.nominal = mechanics::compliant_equilibrium(instant.set, instant.modes,
                                                     instant.commanded_forces, springs);
  if (verdict.nominal) {
    verdict.compliant_stability =
        mechanics::compliant_stability(instant.set, *verdict.nominal, springs);
    verdict.promise = promise_of(instant, *verdict.nominal, springs);
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
    std::string at;
    for (const double mu : found.over_friction.environment) at += figure(mu) + ", ";
    fault(place(s, r), "friction: fails at " + at + figure(found.over_friction.fingers) +
                           " (environment, fingers): " + found.over_friction.reason);
  }
  if (differs(row.compliant_stability, found.compliant_stability)) {
    fault(place(s, r), "compliant stability: " + figure(found.compliant_stability) + ", promised " +
                           figure(row.compliant_stability));
  }
  check_nominal(s, r, instant);
  check_withstands(s, r, instant, found);
}

/// Change of gravity in O between a row at an end of its segment and that end, where nominal forces
/// stay as they are [N].
double Examination::drift(std::size_t s, std::size_t r) const {
  if (is_regrasp(s)) return 0;
  double most = 0;
  const auto to = [&](const Eigen::Isometry3d& end) {
    const Eigen::Matrix3d turned = row_pose(s, r).linear().transpose() - end.linear().transpose();
    most += problem_.object.mass() * (turned * problem_.gravity_W).norm();
  };
  if (r == 0) to(segment(s).X_WO.front());
  if (r + 1 == segment(s).rows.size()) to(segment(s).X_WO.back());
  return most;
}

/// The first number anew, the second by the planner's code.
mechanics::Promise Examination::promise_of(const Instant& instant,
                                           const mechanics::Equilibrium& nominal,
                                           const std::optional<mechanics::Sprung>& springs) const {
  const Eigen::Matrix3Xd& hull = problem_.object.hull();
  mechanics::Promise promise =
      mechanics::promise(instant.set, instant.modes, nominal, options_.compliance,
                         {hull, options_.max_yield}, options_.disturbance_directions, springs);
  promise.withstands = withstands_at(instant, nominal, options_, hull);
  return promise;
}

/// The forces that the row itself feeds forward decide; mostly they are those of the verdict.
void Examination::check_withstands(std::size_t s, std::size_t r, const Instant& instant,
                                   const Verdict& found) {
  const Row& row = segment(s).rows[r];
  mechanics::Promise holds = found.promise;
  if (found.nominal) {
    mechanics::Equilibrium own = *found.nominal;
    Eigen::Index k = 0;
    for (const FingerState& finger : row.fingers) {
      if (finger.touches) own.finger_forces_O.col(k++) = finger.nominal_force_O;
    }
    const double off = (own.finger_forces_O - found.nominal->finger_forces_O).norm();
    if (off > 1e-3 * same_force_) {
      holds = promise_of(instant, own,
                         mechanics::sprung_along(instant.set, instant.modes, options_.compliance,
                                                 options_.disturbance_directions));
    }
  }
  const double left = std::max(0.0, holds.withstands - drift(s, r));
  if (holds.withstands > 0) holds.place_tolerance *= left / holds.withstands;
  if (!(std::abs(row.withstands - left) <= kRoundWithstands * std::max(1.0, left))) {
    fault(place(s, r), "withstands: " + figure(left) + ", promised " + figure(row.withstands));
  }
  if (!(row.place_tolerance >= 0 &&
        row.place_tolerance <= holds.place_tolerance * (1 + kRoundWithstands) + kRoundPlace)) {
    fault(place(s, r), "place tolerance: " + figure(holds.place_tolerance) + ", promised " +
                           figure(row.place_tolerance));
  }
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
  const auto margin = margin_of(round, forces_O, same_force_, margin_basis_);
  if (!margin) {
    fault(place(s, r), "nominal forces: out of cones or limits, or not in balance");
  } else if (row.nominal_margin > *margin + 2 * same_force_ || row.nominal_margin < 0) {
    fault(place(s, r),
          "nominal margin: " + figure(*margin) + ", promised " + figure(row.nominal_margin));
  }
}

}  // namespace graspless::fingertip::checking
