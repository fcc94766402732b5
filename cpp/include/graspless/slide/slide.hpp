// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/planning/budget.hpp"
#include "graspless/slide/problem.hpp"

namespace graspless::slide {

enum class Search {
  paper,  ///< Algorithm 1 as written
  fast,   ///< the same, with goals drawn to fit a start and connected directly first
};

/// How to search. The paper's values where it gives one.
struct Options {
  Search search = Search::fast;
  /// beta_0: the angle between the finger and the surface [rad].
  double pitch = 0.7853981633974483;
  /// Delta_beta: how far the pitch may stray while sliding [rad].
  double pitch_tolerance = 0.1;
  /// Delta_Z^-: least press of the commanded tip below the object's top face [m].
  double min_depth = 0.005;
  /// Delta_Z^+: deepest press of the commanded tip below the object's top face [m].
  double max_depth = 0.025;
  /// Numerical play of the depth band, for the motions between rows [m].
  double height_tolerance = 5e-4;
  /// Tilt of the line contact out of the surface [rad].
  double roll_tolerance = 1e-3;
  /// N* in Eq. (5): larger adds roots more freely.
  double root_scale = 100;
  /// u*: how far the object must stick out to be grasped [m].
  double min_overhang = 0.02;
  /// How far the centre of mass stays inside the edge [m]. In simulation the lift tipped some
  /// objects at 2 mm and none at 10 mm; the paper asks for no margin.
  double com_margin = 0.010;
  /// How far the effective tip stays inside the edge [m].
  double tip_margin = 0.010;
  /// How far the contact stays inside the object's outline at the start [m]; at most half of the
  /// farthest that a contact point can be. In simulation a pad that pressed on a rim lost it.
  double rim_margin = 0.005;
  /// Clearance above the object before the hand comes round for it [m].
  double lift_height = 0.08;
  /// Length of the hand's straight final motion [m].
  double grasp_approach = 0.06;
  /// Longest step of ConstrainedExtend, Euclidean in the joints [rad].
  double range = 0.1;
  /// Largest joint step between checked configurations [rad].
  double resolution = 0.01;
  /// Whether to shorten a slide that came from a tree.
  bool shortcut = true;
};

/// Throws std::invalid_argument that names the field, its value and what is allowed.
GRASPLESS_API void validate(const Options& options);
/// Validates both, and also that the finger can bend as deep as options.max_depth. Called by plan()
/// and check().
GRASPLESS_API void validate(const Problem& problem, const Options& options);

enum class Status {
  solved,
  start_in_collision,  ///< the robot at home touches something
  no_start_root,       ///< no configuration presses on the object
  no_goal_root,        ///< no configuration presses near an edge
  no_valid_pair,       ///< starts and goals were connected, or drawn, but no pair was valid
  not_connected,       ///< no valid pair could be connected in time
  interrupted,
};
GRASPLESS_API std::string to_string(Status status);

/// A stretch of motion: rows of `positions` follow each other by at most 0.05 rad in any joint.
struct Segment {
  std::string name;                        ///< approach, press, slide, lift, reach, grasp or close
  std::vector<Eigen::VectorXd> positions;  ///< all joints [rad or m]
  std::vector<Eigen::Isometry3d> object_poses;  ///< X_WO at each row
};

/// What the search did.
struct Statistics {
  double seconds = 0;
  std::int64_t iterations = 0;
  std::int64_t nodes = 0;        ///< in both forests
  std::int64_t start_roots = 0;  ///< N_s
  std::int64_t goal_roots = 0;   ///< N_g
  /// Configurations tested in full; those of a motion that only some pairs were looked at are not
  /// counted.
  std::int64_t collision_checks = 0;
  std::int64_t projections = 0;
  std::int64_t ik_calls = 0;
  std::int64_t pairs = 0;  ///< start-goal pairs validated
  /// Why roots and pairs were refused: "start: reach", "start: collision", "start: home", "goal:
  /// reach", "goal: collision", "pair: overhang", "pair: center of mass", "pair: grasp reach",
  /// "pair: grasp motion", ...
  std::map<std::string, std::int64_t> refusals;
};

/// Result of plan(): a motion, or the reason why there is none.
struct Plan {
  Status status = Status::not_connected;
  std::string reason;  ///< one sentence for the user
  std::vector<std::string> joint_names;
  std::vector<Segment> segments;
  Eigen::Isometry3d X_WO_goal = Eigen::Isometry3d::Identity();   ///< kappa_g
  Eigen::Isometry3d X_WH_grasp = Eigen::Isometry3d::Identity();  ///< H_g
  double overhang = 0;                                           ///< u at the goal [m]
  std::vector<std::string> warnings;  ///< risks that the plan carries, one sentence each
  Statistics statistics;
  explicit operator bool() const { return status == Status::solved; }
};

/// Plans the motion: approach, press, slide, lift, reach, grasp and close. Throws
/// std::invalid_argument on a bad problem, options or budget. Finding no plan is a status, not an
/// error. The same seed and iterations give the same plan, bit by bit.
GRASPLESS_API Plan plan(const Problem& problem, const Options& options = {},
                        const planning::Budget& budget = {});

/// Checks a plan against its problem by an independent replay at joint steps of 0.01 rad. Returns
/// one fault per entry, with segment and row; empty if the plan is valid.
GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                             const Options& options = {});

}  // namespace graspless::slide
