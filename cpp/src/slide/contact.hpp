// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "graspless/slide/slide.hpp"

/// The contact between fingertip and object, in the support's frame S.
///
/// The finger's heading h is the horizontal direction of Z_F, its pitch the angle of Z_F below the
/// surface. With X_F level and the other finger up,
///   X_F = z x h,   Y_F = cos(pitch) z + sin(pitch) h,   Z_F = cos(pitch) h - sin(pitch) z.
namespace graspless::slide {

/// A pose in the plane of S.
using Planar = Eigen::Isometry2d;

/// Tolerances that the search keeps and check() allows. A straight motion between two projected
/// configurations 0.1 rad apart leaves the surface by a few tenths of a millimetre; both are far
/// less than a pad yields.
inline constexpr double kHeightTolerance = 5e-4;  ///< of the depth [m]
inline constexpr double kRollTolerance = 1e-3;    ///< tilt of the line contact [rad]

/// Tolerances of the place where an object is left, for numerical inverse kinematics [m, rad].
inline constexpr double kEndDistance = 1e-4, kEndTurn = 1e-3;

/// Largest commanded depth of a rigid finger: its pad yields by this much [m].
inline constexpr double kPadGive = 0.003;

/// The fingertip as commanded.
struct Tip {
  Eigen::Vector2d position;  ///< of the frame's origin, in S [m]
  double height;             ///< of the frame's origin above S [m]
  Eigen::Vector2d heading;   ///< unit
  double pitch;              ///< [rad]
  double roll;               ///< tilt of X_F out of the surface [rad]
  bool other_finger_up;  ///< Y_F points up: the other of the two configurations with this height
                         ///< and pitch points it down
};

Tip tip(const Eigen::Isometry3d& X_SF);
Eigen::Isometry3d tip_pose(const Eigen::Vector2d& position, double height,
                           const Eigen::Vector2d& heading, double pitch);

/// Pitch of the sliding finger after it has yielded, for a tip commanded `depth` [m] below the
/// contact [rad].
double yielded_pitch(const Hand& hand, double depth, double pitch);

/// Distance of the contact ahead of the commanded tip, along the heading, for a tip commanded
/// `depth` below the top face [m]. For a finger that bends about a point L behind its tip, with a
/// pad of radius r:
///   pitch' = asin(sin(pitch) - depth / L),
///   shift = L (cos(pitch') - cos(pitch)) + r (touch_pitch - pitch').
/// Zero for every other model: the wrist gives way along the normal, or nothing does.
double contact_shift(const Hand& hand, double depth, double pitch, double touch_pitch);

/// The effective tip: position and heading of the actual contact. Eq. (2) moves the object with it,
/// in SE(2): height and pitch of the finger do not lift or tilt the object.
Planar effective_tip(const Hand& hand, const Tip& tip, double top, double touch_pitch);

/// Eq. (2): kappa_t = Gamma(phi_t) inv(Gamma(phi_s)) kappa_s, all in the plane of S.
inline Planar object_pose(const Planar& tip_now, const Planar& tip_start,
                          const Planar& object_start) {
  return tip_now * tip_start.inverse() * object_start;
}

/// True if the object is where it is to be left.
bool is_at_end(const Planar& object_end, const Planar& object_S);

/// Projects a pose onto the plane of S.
Planar planar(const Eigen::Isometry3d& X);
Eigen::Isometry3d spatial(const Planar& X);

}  // namespace graspless::slide
