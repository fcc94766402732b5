// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "graspless/clasp/problem.hpp"
#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::clasp {

/// Options of the stability test (Stork 2013, Section V-A). The hand does not move. The object
/// makes random moves, each until it hits the hand. Some penetration is allowed, unlike in the
/// paper, so the test errs towards escape. But a link with a concave mesh is filled to its convex
/// hull, which errs the other way.
struct StabilityOptions {
  int sequences = 10;
  int moves = 500;
  double step = 0.002;
  double turn = 0.01;
  double penetration = 0.003;
  double escape_distance = 0;
  double force = 2.5, torque = 0.15;
  std::uint64_t seed = 1;  ///< of the random moves
  int threads = 1;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const StabilityOptions&) {
  using planning::Field, planning::Range;
  using Options = StabilityOptions;
  return std::make_tuple(
      Field{"sequences", &Options::sequences, "",
            "Number of sequences of random moves, each starting from the clasp.",
            Range::closed(1, 1000)},
      Field{"moves", &Options::moves, "",
            "Number of moves in a sequence: translations and rotations in turn.",
            Range::closed(1, 10000)},
      Field{"step", &Options::step, "m", "Length of a translation between two collision tests.",
            Range::closed(1e-4, 0.1)},
      Field{"turn", &Options::turn, "rad",
            "Angle of a rotation about the hand's centre between two collision tests.",
            Range::closed(1e-3, 1)},
      Field{"penetration", &Options::penetration, "m",
            "Depth of penetration that does not count as a collision.", Range::closed(0, 0.05)},
      Field{"escape_distance", &Options::escape_distance, "m",
            "The object has escaped when every point of the loop is farther than this from the "
            "hand's centre. 0: half the length of the longest finger curve, the reach of any hand.",
            Range::closed(0, 10)},
      Field{"force", &Options::force, "N",
            "Force on the object, in any direction, that the motors of the hand should withstand "
            "when it acts suddenly. A hand of two fingers must. At least the object's weight; the "
            "default is that of 250 g.",
            Range::closed(0, 1e6)},
      Field{"torque", &Options::torque, "Nm",
            "Moment about the mean of the object's points that they should withstand together with "
            "the force. Where both are 0, forces are not tested.",
            Range::closed(0, 1e6)},
      Field{"seed", &Options::seed, "", "Seed of the random moves.", Range::not_negative()},
      Field{"threads", &Options::threads, "",
            "Number of threads that share sequences and loads. Results do not depend on it.",
            Range::closed(1, 256)});
}

/// Throws std::invalid_argument that names the option, its value and what it may be.
GRASPLESS_API void validate(const StabilityOptions& options);

/// Result of the stability test.
struct Stability {
  /// True if the loop escaped in no sequence and, for a hand of two fingers, if its motors
  /// withstand the load.
  bool secure = false;
  int escapes = 0;  ///< number of sequences in which the loop escaped
  /// Largest force that may act suddenly in any direction, with moments in proportion as in the
  /// options, before a joint of the hand gives way at its effort limit [N]; 1e6 if none does, 0 if
  /// that was not tested or the loop escaped.
  double withstands = 0;
  std::string opens_first;  ///< the joint that gives way first, if any
  /// 1 - r / escape_distance, where r is the largest distance of the loop from the hand's centre in
  /// any sequence. 1: the object cannot move; 0 or less: it escaped.
  double margin = 0;
  /// Number of poses checked. 0 without an escape: nothing was tested, as the hand is in the object
  /// by more than the options allow.
  std::int64_t checks = 0;
};

/// Result of the test of a pinch: the forces that a hand of two fingers can exert on the object.
struct Pinch {
  /// True if both fingers touch, and their forces resist every wrench, and the whole load.
  bool holds = false;
  /// Largest force in any direction that friction resists for each newton with which a finger
  /// presses, with as large a moment divided by the object's radius of gyration, both about the
  /// mean of its points.
  double strength = 0;
  double press = 0;  ///< normal force of each finger at half the effort limits of the joints [N]
  double load = 0;   ///< largest multiple of the load, acting suddenly, that friction resists then
  double gap = 0;    ///< of the finger that is farther from the object [m]; it must touch, to 3 mm
};

/// Pose in which an object hangs in a closed hand that carries it.
struct Hang {
  /// True if the hand holds it up: it comes to rest with the loop no farther from the hand's centre
  /// than the escape distance.
  bool holds = false;
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();  ///< where it comes to rest
  double drop = 0;   ///< distance by which the mean of its surface is lower there [m]
  double swing = 0;  ///< angle by which it is turned there [rad]
};

/// Lets the object sink from problem.X_WO by its own weight, without friction and inertia, until
/// links of the robot at q hold it up. The weight acts along -z of the world on the mean of the
/// points of the object's surface. There is no support and no obstacle, and no joint gives way.
/// Throws std::invalid_argument on an invalid problem, loop or configuration.
GRASPLESS_API Hang find_hang(const Problem& problem, const Eigen::VectorXd& q, int loop);

/// Tests if friction holds the object between finger and thumb at configuration q. Each presses
/// with 1 N on two points, the ends of its contact with the object along the bar, and
/// mechanics::max_stability() tells which wrenches they resist; a strength below 0.01 is none. The
/// normals are those of the finger, because the cloud is rough. `options` give the load, force and
/// torque. Throws std::invalid_argument on an invalid problem, configuration or load, more than one
/// finger besides the thumb, a joint of the hand without an effort limit, or friction outside [0,
/// 10].
GRASPLESS_API Pinch test_pinch(const Problem& problem, const Eigen::VectorXd& q, double friction,
                               const StabilityOptions& options = {});

/// Tests if the object's loop stays in the hand at configuration q (Stork 2013, Section V-A). All
/// links of the robot are obstacles, filled with balls; a mesh that is not convex is filled to its
/// hull. The clasp is not secure if the robot is deeper than `penetration` in the object. The
/// hand's centre is that of the bounding box of the finger curves. A move without a hit ends after
/// twice the escape distance or a full turn.
///
/// If the loop did not escape, loads act on the object: force and torque along the axes of the
/// palm, all 36 pairs. The object moves under the load, without friction, until the hand blocks it.
/// A joint gives way where the load would gain more work than its motor does at the effort limit. A
/// load that acts suddenly counts twice. Joints that close may be forced open, and those that do
/// not, to both sides; a joint without a limit never gives way. Throws std::invalid_argument on an
/// invalid problem, loop or configuration, and if a joint of a hand of two fingers has no effort
/// limit.
GRASPLESS_API Stability test_stability(const Problem& problem, const Eigen::VectorXd& q, int loop,
                                       const StabilityOptions& options = {});

}  // namespace graspless::clasp
