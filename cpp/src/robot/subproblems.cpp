// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "robot/subproblems.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::robot {
namespace {

using Eigen::Vector3d;

constexpr double kNoAngle = 1e-28;  // squared length below which a vector has no direction

/// Least distance from the end of the reach [squared, of a unit vector]: an approximate geometry
/// keeps its two solutions apart, so that each can be polished.
double apart(double slack) { return slack > kClose ? slack : 0; }

}  // namespace

Turn Turn::by(double angle) { return {angle, std::cos(angle), std::sin(angle)}; }

Turn Turn::from_to(const Vector3d& axis, const Vector3d& u, const Vector3d& v, double free) {
  // Projected first: near the axis, a difference of dot products would lose all digits.
  const Vector3d u_across = across(axis, u), v_across = across(axis, v);
  const double c = u_across.dot(v_across), s = axis.dot(u_across.cross(v_across));
  const double square = c * c + s * s;
  if (!(square > kNoAngle * kNoAngle)) return by(free);
  const double length2 = std::sqrt(square);
  return {std::atan2(s, c), c / length2, s / length2, length2};
}

// The intermediate vector z = second(u) has v's component along a1 and u's component along a2. Near
// an axis, the cosine does not tell how far z is from it. So z is built around the axis that it is
// nearer to, from the length of its component perpendicular to that axis.
TwoTurns::TwoTurns(const Vector3d& a1, const Vector3d& a2, const Vector3d& u, const Vector3d& v,
                   double slack) {
  const double along1 = a1.dot(v), along2 = a2.dot(u);
  if (std::abs(along1) > std::abs(along2)) {
    build(a1, a2, along1, along2, across(a1, v).squaredNorm(), slack);
  } else {
    build(a2, a1, along2, along1, across(a2, u).squaredNorm(), slack);
  }
}

/// a: the axis that z is built around; b: the other. `square`: squared length of z's component
/// perpendicular to a.
void TwoTurns::build(const Vector3d& a, const Vector3d& b, double along_a, double along_b,
                     double square, double slack) {
  const double cosine = a.dot(b);
  const Vector3d cross = a.cross(b);
  const double sine = cross.norm();
  const double x =
      (along_b - cosine * along_a) / sine;  // of z in the plane of a and b, perpendicular to a
  const double y2 = square - x * x;         // squared component out of that plane
  const double excess = slack * (std::sqrt(square) + slack);
  in_plane = along_a * a + x / sine * (b - cosine * a);
  const double least = apart(slack);
  out_of_plane = std::sqrt(std::max(least, y2)) / sine * cross;
  count = y2 < -excess ? 0 : y2 <= 0 && least == 0 ? 1 : 2;
  is_close = count == 0 && y2 > -kClose;
}

Elbow Elbow::of(const Screw& screw, const Vector3d& fixed, const Vector3d& moving) {
  Elbow elbow;
  elbow.axis = screw.axis;
  elbow.p_SE = screw.point - fixed;
  elbow.p_EW = moving - screw.point;
  const Turn nearest = Turn::from_to(screw.axis, elbow.p_EW, -elbow.p_SE, 0);
  elbow.angle = nearest.angle;
  elbow.c = nearest.c;
  elbow.s = nearest.s;
  elbow.sum = elbow.p_EW.squaredNorm() + elbow.p_SE.squaredNorm() +
              2 * screw.axis.dot(elbow.p_EW) * screw.axis.dot(elbow.p_SE);
  elbow.product = 2 * across(screw.axis, elbow.p_EW).norm() * across(screw.axis, elbow.p_SE).norm();
  return elbow;
}

Turns Elbow::turns(double distance, double slack) const {
  const double cosine = (sum - distance * distance) / product;
  Turns found;
  if (!(std::abs(cosine) <= 1 + slack)) {
    found.is_close = std::abs(cosine) < 1 + kClose;
    return found;
  }
  const double limit = 1 - apart(slack);
  const double c0 = std::clamp(cosine, -limit, limit), s0 = std::sqrt((1 - c0) * (1 + c0));
  const double angle0 = std::atan2(s0, c0);
  for (const int sign : {1, -1}) {
    if (sign < 0 && s0 == 0) break;
    found.turn[found.count++] = {angle + sign * angle0, c * c0 - s * sign * s0,
                                 s * c0 + c * sign * s0};
  }
  return found;
}

Turns turns_to_component(const Vector3d& axis, const Vector3d& u, const Vector3d& direction,
                         double component, double free, double slack) {
  // The component is x cos(angle) + y sin(angle) + fixed.
  const Vector3d u_across = across(axis, u);
  const double x = direction.dot(u_across), y = direction.dot(axis.cross(u));
  const double amplitude2 = x * x + y * y;
  const double needed = component - direction.dot(axis) * axis.dot(u);
  Turns found;
  if (!(std::abs(needed) <= std::sqrt(amplitude2) * (1 + slack) + slack)) {
    found.is_close = std::abs(needed) < std::sqrt(amplitude2) + kClose;
    return found;
  }
  if (!(amplitude2 > kNoAngle)) {
    found.turn[found.count++] = Turn::by(free);
    return found;
  }
  const double amplitude = std::sqrt(amplitude2), limit = 1 - apart(slack);
  const double c0 = std::clamp(needed / amplitude, -limit, limit);
  const double s0 = std::sqrt((1 - c0) * (1 + c0));
  for (const int sign : {1, -1}) {
    if (sign < 0 && s0 == 0) break;
    const double c = (x * c0 - y * sign * s0) / amplitude;
    const double s = (y * c0 + x * sign * s0) / amplitude;
    // Moves the component by rounding only, even where it has its extreme.
    found.turn[found.count++] = {std::atan2(s, c), c, s, std::max(s0 * s0, kClose * kClose)};
  }
  return found;
}

}  // namespace graspless::robot
