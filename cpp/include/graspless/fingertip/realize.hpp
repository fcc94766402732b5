// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/fingertip/fingertip.hpp"
#include "graspless/planning/budget.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::fingertip {

/// Which parts of a robot carry the fingertips.
struct Carrier {
  /// One frame a finger of the plan, each the centre of a fingertip's sphere.
  std::vector<std::string> fingertips = {"left_fingertip", "right_fingertip"};
  /// Links that may touch the object: those the spheres belong to.
  std::vector<std::vector<std::string>> links = {{"left_finger"}, {"right_finger"}};
};

struct RealizeOptions {
  double approach = 0.03;    ///< a finger leaves and comes to the surface along its normal [m]
  double resolution = 0.01;  ///< largest joint step between checked configurations [rad]
  double max_jump = 0.05;    ///< largest joint step between rows [rad]
  double position_tolerance = 1e-4;  ///< of fingertips [m]
  int restarts = 40;                 ///< configurations to start from
};

/// A stretch of joint motion; rows follow each other by at most max_jump in any joint.
struct JointSegment {
  std::string name;  ///< approach, push, turn, slide, tumble, release, reach, touch, retreat
  std::vector<Eigen::VectorXd> positions;
  std::vector<Eigen::Isometry3d> X_WO;
  int plan_segment = -1;  ///< the segment of the plan that it carries out; -1 for free motions
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
/// nothing touching but fingertips and object), through regrasps, and away. Tries each assignment
/// of fingertips to fingers. Throws std::invalid_argument on unknown frames or links, a home
/// outside the limits, or a plan that is not solved.
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
