// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/planning/budget.hpp"
#include "graspless/scene/certificate.hpp"
#include "graspless/slide/options.hpp"
#include "graspless/slide/problem.hpp"
#include "graspless/slide/status.hpp"
#include "graspless/slide/tube.hpp"

namespace graspless::slide {

/// Band of the commanded depth of the fingertip below the object's top face [m].
struct DepthBand {
  double min, max;
};

/// Returns the band of the options. A bound that they leave out is that of hand.finger_model.
GRASPLESS_API DepthBand depth_band(const Hand& hand, const Options& options);

/// Validates both, and also that the finger can yield by the depth, and that its shapes fit its tip
/// frame: they reach the contact within 3 mm, and do not reach below it by more than 5 mm, or 8 mm
/// for a finger that yields. Called by plan() and check().
GRASPLESS_API void validate(const Problem& problem, const Options& options);

/// State in which a slide was interrupted: the finger presses on the object.
struct Interruption {
  Eigen::VectorXd q;                           ///< commanded joints, all of them [rad or m]
  Eigen::Isometry3d X_WO;                      ///< measured pose of the object
  std::optional<Eigen::Isometry3d> X_WO_goal;  ///< of the interrupted plan; it is tried first
};

/// Part of a motion: Robot::step() between rows of `positions` is 0.05 rad at most.
struct Segment {
  std::string name;  ///< approach, press, slide, lift, reach, grasp, close or retreat
  std::vector<Eigen::VectorXd> positions;       ///< all joints [rad or m]
  std::vector<Eigen::Isometry3d> object_poses;  ///< X_WO at each row
};

/// Counters of the search; fields() describes them.
struct Statistics {
  double seconds = 0;
  std::int64_t iterations = 0;
  std::int64_t nodes = 0;
  std::int64_t start_roots = 0;
  std::int64_t goal_roots = 0;
  std::int64_t collision_checks = 0;
  std::int64_t projections = 0;
  std::int64_t ik_calls = 0;
  std::int64_t pairs = 0;
  std::map<std::string, std::int64_t> refusals;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Statistics&) {
  using planning::Field;
  return std::make_tuple(
      Field{"seconds", &Statistics::seconds, "s", "Wall-clock time."},
      Field{"iterations", &Statistics::iterations, "", "Iterations of Algorithm 1."},
      Field{"nodes", &Statistics::nodes, "", "Nodes in both forests."},
      Field{"start_roots", &Statistics::start_roots, "", "Roots of the start forest.", {}, "N_s"},
      Field{"goal_roots", &Statistics::goal_roots, "", "Roots of the goal forest.", {}, "N_g"},
      Field{"collision_checks", &Statistics::collision_checks, "",
            "Configurations checked against every body."},
      Field{"projections", &Statistics::projections, "",
            "Projections of a configuration onto the contact constraint."},
      Field{"ik_calls", &Statistics::ik_calls, "", "Calls of the inverse kinematics."},
      Field{"pairs", &Statistics::pairs, "", "Start-goal pairs validated."},
      Field{"refusals", &Statistics::refusals, "",
            "Rejected roots and pairs by reason: \"start: reach\", \"pair: overhang\"."});
}

/// Result of plan(), resume() or restart(): a motion, or the reason why there is none.
struct Plan {
  Status status = Status::not_connected;
  std::string reason;  ///< one sentence for the user
  std::vector<std::string> joint_names;
  std::optional<Interruption> resumed;  ///< of resume() and restart(): where the plan begins
  std::vector<Segment> segments;
  Eigen::Isometry3d X_WO_goal = Eigen::Isometry3d::Identity();   ///< kappa_g
  Eigen::Isometry3d X_WH_grasp = Eigen::Isometry3d::Identity();  ///< H_g; means nothing with an end
  double overhang = 0;                                           ///< u at the goal [m]; as above
  /// Largest mass that the fingers bear when they lift the object [kg]. None for a problem with an
  /// end, and if a joint that must bear it has no effort limit, or one that is a placeholder: a
  /// finger would press with more than 500 N.
  std::optional<double> max_mass;
  Tube tube;                          ///< of the slide; a plan without values claims no bounds
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
/// `options`: those of plan().
[[nodiscard]] GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                                           const Options& options = {});

/// Proves what check() samples: on every edge of a plan, for every t, nothing touches that may not,
/// and all bands of check() are kept. Edges are divided down to scene::kFinest where bounds on the
/// motion decide nothing. Throws std::invalid_argument if the plan is not solved or malformed.
[[nodiscard]] GRASPLESS_API scene::EdgeCertificate certify(const Problem& problem, const Plan& plan,
                                                           const Options& options = {});

}  // namespace graspless::slide
