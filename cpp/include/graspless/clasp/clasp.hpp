// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "graspless/clasp/problem.hpp"
#include "graspless/clasp/stability.hpp"
#include "graspless/export.hpp"
#include "graspless/planning/budget.hpp"

namespace graspless::clasp {

/// How to search. Zero means: derived from object and hand.
struct Options {
  /// Virtual linking that every finger curve must reach before the hand closes, and keep, in (0,
  /// 1). 0: the hand closes as soon as every curve is linked, and closed must come half way from
  /// its open state to what it reaches around a bar as thick as the loop's handle.
  double min_linking = 0;
  /// Clasp targets a loop; 0: one every half width of the hand, from 4 to 64.
  int targets = 0;
  /// n: random extensions before a tree is connected to targets; 0: 20 for the first tree, 50, 100,
  /// then 200.
  int pre_expansions = 0;
  double random_probability = 0.1;  ///< P
  int restart_cycles = 5;           ///< cycles before a tree is given up; 0: never
  // TS-CONTROL, Algorithm 4
  double dt = 0.5;                ///< Delta_t
  double max_step = 0.12;         ///< LIMIT-STEP-SIZE: of any joint [rad]
  double blend_distance = 0.02;   ///< where GAIN is a half [m]
  double blend_slope = 120;       ///< of GAIN there [1/m]
  double position_damping = 0.2;  ///< of the pseudo-inverses [m]
  double alignment_damping = 0.1;
  double linking_damping = 0.02;
  /// How much the hand waits on its way while it is misaligned; 0: not at all, as the paper has it.
  double patience = 20;
  double linking_weight = 0.3;   ///< of the linking in the nearest-neighbour distance [m]
  double exploring_step = 0.35;  ///< longest step of TS-EXTEND, of any joint [rad]
  int max_connect_steps = 150;   ///< control steps of one connection
  /// Attract an open hand by the open curves' Gauss integral while it is not linked.
  bool attract = false;
  double resolution = 0.01;  ///< largest joint step between checked configurations [rad]
  int shortcut_rounds = 60;  ///< of randomised path pruning
  StabilityOptions stability;
  /// Take a clasp only if it passes the stability test; else the search goes on.
  bool must_be_secure = true;
};

/// Throws std::invalid_argument that names the field, its value and what it may be.
GRASPLESS_API void validate(const Options& options);

enum class Status {
  solved,
  start_in_collision,  ///< the robot at q_start touches something
  no_reliable_hole,    ///< the cloud shows no hole to clasp: see Object::loops().betti
  no_target_in_reach,  ///< every target is farther away than the arm is long
  not_found,           ///< no motion led to a clasp in time
  not_secure,          ///< clasps were found in time, and none passed the stability test
  interrupted,
};
GRASPLESS_API std::string to_string(Status status);

/// Part of a motion: consecutive rows of `positions` differ by at most 0.05 rad in any joint.
struct Segment {
  std::string name;                        ///< "reach" or "close"
  std::vector<Eigen::VectorXd> positions;  ///< of all joints [rad or m]
  /// |VLk|, eq. (2), of every finger curve with the clasped loop, curves x rows, in [0, 1].
  Eigen::MatrixXd virtual_linking;
};

/// The search tree that contains the clasp, for visualisation.
struct Tree {
  Eigen::Matrix3Xd p_W;      ///< centre of the finger curves at every node, 3 x n [m]
  std::vector<int> parents;  ///< index of every node's parent; the root is its own parent
  std::vector<int> path;     ///< nodes from the root to the clasp
};

/// What the search did.
struct Statistics {
  double seconds = 0;
  double stability_seconds = 0;  ///< of these, in stability tests
  std::int64_t cycles = 0;       ///< of Algorithm 1 after the pre-expansions, over all trees
  std::int64_t nodes = 0;        ///< over all trees
  std::int64_t restarts = 0;     ///< trees given up
  std::int64_t control_steps = 0;
  std::int64_t collision_checks = 0;  ///< configurations looked at
  std::int64_t fcl_checks = 0;        ///< link against object by FCL: what the clearance left open
  std::int64_t stability_tests = 0;
  std::map<std::string, std::int64_t> refusals;  ///< why targets, connections and clasps failed
};

/// Result of plan(): a motion that clasps the object, or the reason for failure.
struct Plan {
  Status status = Status::not_found;
  std::string reason;  ///< explanation of the status in one sentence
  std::vector<std::string> joint_names;
  std::vector<Segment> segments;
  int loop = -1;                 ///< index of the clasped loop in object.loops().loops
  geometry::ClaspTarget target;  ///< target that the hand holds, in O
  double min_linking = 0;        ///< threshold on |VLk| of the closed hand
  Stability stability;           ///< of the last row
  Tree tree;
  std::vector<std::string> warnings;
  Statistics statistics;
  explicit operator bool() const { return status == Status::solved; }
};

/// Plans a motion of arm and hand that ends in a clasp: reach, then close until contact (Stork
/// 2013, Section IV). One iteration of the budget is one cycle of Algorithm 1. The same seed and
/// number of iterations give the same plan, bit by bit. Throws std::invalid_argument on an invalid
/// problem, options or budget. Failure to find a plan is a status.
GRASPLESS_API Plan plan(const Problem& problem, const Options& options = {},
                        const planning::Budget& budget = {});

/// Replays a plan at steps of 0.01 rad and returns its faults; an empty list means that the plan is
/// valid. Checks joint limits, collisions by FCL, linking by the double integral, eq. (1), that the
/// target is one of those requested, and that the fingers closed until contact. It uses no code of
/// the search, with two exceptions: the threshold derived from the hand, and the stability test,
/// which is run again. A second escape test uses FCL alone.
GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                             const Options& options = {});

}  // namespace graspless::clasp
