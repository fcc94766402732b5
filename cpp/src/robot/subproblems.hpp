// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Subproblems of inverse kinematics: 1 to 3 of Paden and Kahan (Murray, Li and Sastry, A
// Mathematical Introduction to Robotic Manipulation, 1994, Section 3.3), and 4 as numbered by
// Elias and Wen (IK-Geo, 2025).
//
// Cosines and sines are taken from the geometry, not from the angles: arctangents already take most
// of the time. `slack` admits a target that much out of reach: kRounding, or more where the
// solutions are polished afterwards.
#pragma once

#include <cmath>

#include <Eigen/Geometry>

namespace graspless::robot {

constexpr double kRounding = 1e-13;  // excess over the reach that counts as rounding (unit vectors)
constexpr double kClose = 1e-6;      // excess that an earlier angle near a singularity may cause

/// An axis of rotation: all points p + t * axis.
struct Screw {
  Eigen::Vector3d axis;  // unit
  Eigen::Vector3d point;
};

/// Component of v perpendicular to a unit axis.
inline Eigen::Vector3d across(const Eigen::Vector3d& axis, const Eigen::Vector3d& v) {
  return v - axis * axis.dot(v);
}

/// A rotation about a known axis.
struct Turn {
  double angle = 0, c = 1, s = 0;
  double lever2 = 1e300;  // squared length that the angle turns, of vectors known to kRounding

  /// Change of the angle whose effect is within rounding.
  double slack() const { return kRounding / std::sqrt(lever2); }

  static Turn by(double angle);

  /// Subproblem 1: the rotation about `axis` that takes u to v; by `free` if they lie on the axis.
  static Turn from_to(const Eigen::Vector3d& axis, const Eigen::Vector3d& u,
                      const Eigen::Vector3d& v, double free);

  Eigen::Vector3d apply(const Eigen::Vector3d& axis, const Eigen::Vector3d& v) const {
    return c * v + s * axis.cross(v) + (1 - c) * axis.dot(v) * axis;
  }
  Eigen::Vector3d undo(const Eigen::Vector3d& axis, const Eigen::Vector3d& v) const {
    return c * v - s * axis.cross(v) + (1 - c) * axis.dot(v) * axis;
  }
};

/// Up to two rotations.
struct Turns {
  Turn turn[2];
  int count = 0;
  bool is_close = false;  // true if there are none, but would be with a slack of kClose

  const Turn* begin() const { return turn; }
  const Turn* end() const { return turn + count; }
};

/// Subproblem 2: rotations with first(second(u)) = v, for unit vectors u and v.
struct TwoTurns {
  TwoTurns(const Eigen::Vector3d& a1, const Eigen::Vector3d& a2, const Eigen::Vector3d& u,
           const Eigen::Vector3d& v, double slack);

  /// Returns the i-th intermediate vector, second(u).
  Eigen::Vector3d between(int i) const { return in_plane + (i == 0 ? 1 : -1) * out_of_plane; }

  Eigen::Vector3d in_plane, out_of_plane;
  int count = 0;
  bool is_close = false;  // as in Turns

 private:
  void build(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double along_a, double along_b,
             double square, double slack);
};

/// Subproblem 3: turns of a point about an axis, to a given distance from a fixed point.
/// |fixed to turned point|^2 = sum - product cos(angle - nearest).
struct Elbow {
  static Elbow of(const Screw& screw, const Eigen::Vector3d& fixed, const Eigen::Vector3d& moving);

  Turns turns(double distance, double slack) const;
  /// Returns the vector from the fixed to the turned point.
  Eigen::Vector3d reached(const Turn& turn) const { return p_SE + turn.apply(axis, p_EW); }

  Eigen::Vector3d axis;
  Eigen::Vector3d p_SE, p_EW;  // fixed point to axis, axis to moving point
  double sum, product;         // [m^2]
  double angle, c, s;          // angle at which the points are nearest, its cosine and sine
};

/// Subproblem 4: rotations of u about `axis` after which its component along `direction` is
/// `component`; by `free` if u lies on the axis.
Turns turns_to_component(const Eigen::Vector3d& axis, const Eigen::Vector3d& u,
                         const Eigen::Vector3d& direction, double component, double free,
                         double slack);

}  // namespace graspless::robot
