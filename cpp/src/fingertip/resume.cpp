// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The rest of a plan: the place of the object among its poses, the poses that are left, and the
// fingers where they are.
#include "graspless/fingertip/resume.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"

#include "fingertip/model/screw.hpp"
#include "text.hpp"

namespace graspless::fingertip {
namespace {

using Poses = std::vector<Eigen::Isometry3d>;

/// A place on a segment: on the way from pose `k` to the next.
struct Place {
  Eigen::Isometry3d X_WO;
  std::size_t k = 0;
  double distance = std::numeric_limits<double>::infinity();  // root mean square of corners [m]
};

/// The place of a segment where the corners of the object's hull are nearest to the measured ones.
Place nearest_place(const Object& object, const Poses& way, const Eigen::Isometry3d& X_WO) {
  const Eigen::Matrix3Xd measured = X_WO * object.hull();
  const auto at = [&](const Eigen::Isometry3d& X, std::size_t k) {
    const double rms = (X * object.hull() - measured).norm() /
                       std::sqrt(static_cast<double>(object.hull().cols()));
    return Place{X, k, rms};
  };
  Place best = at(way.front(), 0);
  for (std::size_t k = 0; k + 1 < way.size(); ++k) {
    const mechanics::Vector6d twist_O = screw_between(way[k], way[k + 1]);
    const auto on_arc = [&](double part) { return at(along_screw(way[k], twist_O, part), k); };
    double from = 0, to = 1;  // ternary search: the distance has one minimum on a short arc
    for (int i = 0; i < 60; ++i) {
      const double third = (to - from) / 3;
      on_arc(from + third).distance < on_arc(to - third).distance ? to -= third : from += third;
    }
    for (const double part : {(from + to) / 2, 1.0}) {
      const Place place = on_arc(part);
      if (place.distance < best.distance) best = place;
    }
  }
  return best;
}

/// A measured displacement, in parts along the floor and off it.
struct Displacement {
  Eigen::Vector3d aside_W;  // of the centre of mass, along the floor [m]
  double turn;              // about the floor's normal [rad]
  double height, tilt;      // off the floor [m], and about other axes [rad]
};

Displacement between(const Problem& problem, const Eigen::Isometry3d& X_WO,
                     const Eigen::Isometry3d& measured) {
  const Eigen::Vector3d& n_W = problem.planes.front().n_W;
  const Eigen::Vector3d shift_W = (measured * problem.object.com()) - (X_WO * problem.object.com());
  const Eigen::AngleAxisd turn(measured.linear() * X_WO.linear().transpose());
  const Eigen::Vector3d turn_W = turn.angle() * turn.axis();
  const double height = shift_W.dot(n_W), about = turn_W.dot(n_W);
  return {shift_W - height * n_W, about, std::abs(height), (turn_W - about * n_W).norm()};
}

bool is_near(const Displacement& d) {
  return d.aside_W.norm() <= kMaxAside && d.height <= kMaxAside && std::abs(d.turn) <= kMaxTurned &&
         d.tilt <= kMaxTurned;
}

/// A pose moved along the floor, and turned about its normal through the centre of mass.
Eigen::Isometry3d moved(const Problem& problem, const Eigen::Isometry3d& X_WO,
                        const Displacement& d) {
  const Eigen::Vector3d com_W = X_WO * problem.object.com();
  return Eigen::Translation3d(com_W + d.aside_W) *
         Eigen::AngleAxisd(d.turn, problem.planes.front().n_W) * Eigen::Translation3d(-com_W) *
         X_WO;
}

/// The poses of a plan after a place on a segment.
Poses poses_after(const Plan& plan, std::size_t segment, const Place& place) {
  const Poses& way = plan.segments[segment].X_WO;
  Poses left(way.begin() + place.k + 1, way.end());
  for (std::size_t s = segment + 1; s < plan.segments.size(); ++s) {
    if (plan.segments[s].finger >= 0) continue;  // a regrasp stays at the last pose
    left.insert(left.end(), plan.segments[s].X_WO.begin() + 1, plan.segments[s].X_WO.end());
  }
  return left;
}

bool is_reached(const Object& object, const Eigen::Isometry3d& X_WO,
                const Eigen::Isometry3d& pose) {
  return (pose * object.hull() - X_WO * object.hull()).colwise().norm().maxCoeff() <
         1e-6 * object.size();
}

/// Drops poses that the object has reached.
void drop_reached(const Object& object, const Eigen::Isometry3d& X_WO, Poses& left) {
  while (!left.empty() && is_reached(object, X_WO, left.front())) left.erase(left.begin());
}

bool is_regrasp(const Plan& plan, std::size_t segment) {
  return segment < plan.segments.size() && plan.segments[segment].finger >= 0;
}

/// The places of the fingers during a segment; in a regrasp, those after it and those that follow.
std::vector<Eigen::Vector3d> places_in(const Plan& plan, std::size_t segment) {
  while (is_regrasp(plan, segment)) ++segment;
  const std::size_t last = plan.segments.size() - 1;
  std::vector<Eigen::Vector3d> places;
  for (const FingerState& finger : plan.segments[std::min(segment, last)].rows.front().fingers) {
    places.push_back(finger.p_OC);
  }
  return places;
}

void require_plan(const Problem& problem, const Plan& plan, int segment) {
  if (!plan) throw std::invalid_argument("plan is " + to_string(plan.status) + ", not solved");
  if (plan.segments.empty()) throw std::invalid_argument("plan has no segments");
  if (segment < 0 || segment >= static_cast<int>(plan.segments.size())) {
    throw std::invalid_argument("segment must be 0 to " + std::to_string(plan.segments.size() - 1) +
                                ", not " + std::to_string(segment));
  }
  for (const Segment& each : plan.segments) {
    if (!each.X_WO.empty() && !each.rows.empty()) continue;
    throw std::invalid_argument("plan: segment '" + each.name + "' has no poses or no rows");
  }
  const std::size_t count = plan.segments.front().rows.front().fingers.size();
  if (static_cast<int>(count) != problem.fingers.count) {
    throw std::invalid_argument("plan has " + std::to_string(count) +
                                " fingers, and the problem has " +
                                std::to_string(problem.fingers.count));
  }
}

Plan not_resumed(Status status, const std::string& reason) {
  Plan plan;
  plan.status = status;
  plan.reason = reason;
  return plan;
}

Plan off_path(const Displacement& d, const std::string& segment) {
  std::ostringstream reason;
  reason.precision(3);
  reason << "the object is " << 1e3 * d.aside_W.norm() << " mm and " << std::abs(d.turn) / kDegree
         << " degrees aside of the nearest pose of segment '" << segment << "', " << 1e3 * d.height
         << " mm above or below it and tilted by " << d.tilt / kDegree << " degrees; "
         << 1e3 * kMaxAside << " mm and " << kMaxTurned / kDegree << " degrees are allowed";
  return not_resumed(Status::off_path, reason.str());
}

/// Empty if a problem is valid, else what is wrong with it.
std::string fault_of(const Problem& problem, const Options& options) {
  try {
    validate(problem, options);
    return "";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace

Rest resume(const Problem& problem, const Plan& plan, int segment, const Eigen::Isometry3d& X_WO,
            const Options& options, const planning::Budget& budget) {
  validate(problem, options);
  require_plan(problem, plan, segment);
  geometry::require_pose(X_WO, "X_WO");
  const auto s = static_cast<std::size_t>(segment);
  const Place place = nearest_place(problem.object, plan.segments[s].X_WO, X_WO);
  const Displacement aside = between(problem, place.X_WO, X_WO);
  Rest rest{problem, {}};
  if (!is_near(aside)) {
    rest.plan = off_path(aside, plan.segments[s].name);
    return rest;
  }
  rest.problem.fingers.start = places_in(plan, s);
  const Poses left = poses_after(plan, s, place);
  std::string fault;
  for (const bool as_measured : {true, false}) {
    const Eigen::Isometry3d from = as_measured ? moved(problem, place.X_WO, aside) : place.X_WO;
    Poses way = left;
    drop_reached(problem.object, from, way);
    if (way.empty()) {
      rest.plan = not_resumed(Status::at_goal, "the object is at the last pose of the plan");
      return rest;
    }
    way.insert(way.begin(), from);
    rest.problem.motion = Path{way};
    fault = fault_of(rest.problem, options);
    if (!fault.empty()) continue;
    rest.plan = fingertip::plan(rest.problem, options, budget);
    if (!rest.plan && is_regrasp(plan, s + 1) &&
        is_reached(problem.object, plan.segments[s].X_WO.back(), place.X_WO)) {
      rest.plan.reason +=
          "; the plan regrasps at this pose: do that first, and resume after segment " +
          std::to_string(s + 1);
    }
    if (!as_measured) {
      std::ostringstream warning;
      warning.precision(3);
      warning << "the object is taken to be at a pose of the plan, " << 1e3 * place.distance
              << " mm from where it was measured";
      rest.plan.warnings.push_back(warning.str());
    }
    return rest;
  }
  rest.plan = not_resumed(Status::off_path, "no path leads on from the measured pose: " + fault);
  return rest;
}

}  // namespace graspless::fingertip
