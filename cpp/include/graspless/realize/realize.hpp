// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/fingertip/fingertip.hpp"
#include "graspless/planning/budget.hpp"
#include "graspless/planning/fields.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::fingertip {

/// Parts of a robot that carry the fingertips.
struct Carrier {
  /// One frame a finger of the plan, each the centre of a fingertip's sphere.
  std::vector<std::string> fingertips = {"left_tip_center", "right_tip_center"};
  /// Links that may touch the object: those the spheres belong to.
  std::vector<std::vector<std::string>> links = {{"left_finger"}, {"right_finger"}};
};

/// Options of realize(); fields() describes them.
struct RealizeOptions {
  double approach = 0.03;
  double resolution = 0.01;
  double max_jump = 0.05;
  double position_tolerance = 1e-4;
  int restarts = 40;
  int solutions = 8;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const RealizeOptions&) {
  using planning::Field, planning::Range;
  using Options = RealizeOptions;
  return std::make_tuple(
      Field{"approach", &Options::approach, "m",
            "Distance over which a finger approaches and leaves the surface along its normal. "
            "Where the hand does not open so far, a half, a quarter or an eighth of it.",
            Range::positive()},
      Field{"resolution", &Options::resolution, "rad",
            "Largest joint step between checked configurations.", Range::positive()},
      Field{"max_jump", &Options::max_jump, "rad or m", "Largest joint step between two rows.",
            Range::positive()},
      Field{"position_tolerance", &Options::position_tolerance, "m",
            "Largest distance of a fingertip from its planned position, at rows and between them.",
            Range::positive()},
      Field{"restarts", &Options::restarts, "",
            "Number of rounds of initial configurations to search from.", Range::closed(1, 1e6)},
      Field{"solutions", &Options::solutions, "",
            "Number of solutions to find; the one with the least scrub is kept.",
            Range::closed(1, 1e6)});
}

/// A stretch of joint motion; rows follow each other by at most max_jump in any joint.
struct JointSegment {
  /// approach, touch, those of the plan (slide, turn, tumble; for a regrasp release, reach, touch),
  /// release, retreat
  std::string name;
  std::vector<Eigen::VectorXd> positions;
  std::vector<Eigen::Isometry3d> X_WO;
  int plan_segment = -1;  ///< the segment of the plan that it carries out; -1 for free motions
  /// The plan's contacts are points that stay. A fingertip that turns about its centre otherwise
  /// than about the normal slips on its point by its radius times that turning: how far, over the
  /// segment, for the worst of the fingers that touch [m].
  double scrub = 0;
};

/// Joint paths that carry a plan's fingertips, or where it is impossible.
struct Realization {
  bool found = false;
  std::string reason;  ///< which segment, row and finger fails, and why
  std::vector<std::string> joint_names;
  std::vector<int> finger_of_fingertip;  ///< which finger of the plan each fingertip plays
  std::vector<JointSegment> segments;
  explicit operator bool() const { return found; }
};

/// Gives a plan an arm: from q_home to the first grip, through every row with the fingertips'
/// centres where the plan has them (inverse kinematics from row to row, continuous, within limits,
/// nothing touching but fingertips and object), through regrasps, and back home. All joints that
/// move a fingertip take part; the object stands still but for the plan's displacements. Planes are
/// solid to the robot, but for its root. A touching finger's links may reach into the object by a
/// few tenths of a millimetre: what position_tolerance takes. Tries each assignment of fingertips
/// to fingers. Throws std::invalid_argument on unknown frames or links, a home outside the limits,
/// or a plan that is not solved.
GRASPLESS_API Realization realize(const Problem& problem, const Plan& plan,
                                  const robot::Robot& robot, const Carrier& carrier,
                                  const Eigen::VectorXd& q_home, const RealizeOptions& options = {},
                                  const planning::Budget& budget = {});

/// Replays a realization against problem and plan: limits, joint steps, fingertips within the
/// tolerance of the plan's, collisions by FCL, the object's poses. Empty: it holds.
GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                             const robot::Robot& robot, const Carrier& carrier,
                                             const Realization& realization,
                                             const RealizeOptions& options = {});

}  // namespace graspless::fingertip
