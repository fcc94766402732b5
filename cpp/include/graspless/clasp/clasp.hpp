// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "graspless/clasp/certificate.hpp"
#include "graspless/clasp/options.hpp"
#include "graspless/clasp/problem.hpp"
#include "graspless/clasp/stability.hpp"
#include "graspless/export.hpp"
#include "graspless/planning/budget.hpp"
#include "graspless/scene/certificate.hpp"

namespace graspless::clasp {

enum class Status {
  solved,
  start_in_collision,
  no_reliable_hole,
  no_target_in_reach,
  too_thick,
  hole_too_narrow,
  not_found,
  not_secure,
  interrupted,
  out_of_memory,
};

/// Table of the values: name and text.
constexpr auto choices(Status) {
  using planning::Choice;
  return std::array{
      Choice{Status::solved, "solved", "A plan was found."},
      Choice{Status::start_in_collision, "start_in_collision",
             "The robot touches something in its start configuration."},
      Choice{Status::no_reliable_hole, "no_reliable_hole",
             "The point cloud shows no hole to clasp. Object.loops has its Betti numbers."},
      Choice{Status::no_target_in_reach, "no_target_in_reach",
             "Every target is farther away than the arm is long."},
      Choice{Status::too_thick, "too_thick",
             "Every handle in reach is thicker than the two fingers of the hand open."},
      Choice{Status::hole_too_narrow, "hole_too_narrow",
             "Every hole is narrower than a finger; the reason has both widths."},
      Choice{Status::not_found, "not_found", "No motion to a clasp was found within the budget."},
      Choice{
          Status::not_secure, "not_secure",
          "Clasps were found within the budget, and none passed the stability test or is held by "
          "friction."},
      Choice{Status::interrupted, "interrupted", "The query was stopped from outside."},
      Choice{Status::out_of_memory, "out_of_memory",
             "The search would need more memory than options.max_memory."}};
}
GRASPLESS_API std::string to_string(Status status);

/// Part of a motion: Robot::step() between rows of `positions` is 0.05 rad at most.
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

/// Counters of the search; fields() describes them.
struct Statistics {
  double seconds = 0;
  double stability_seconds = 0;
  double certificate_seconds = 0;
  std::int64_t cycles = 0;
  std::int64_t nodes = 0;
  std::int64_t restarts = 0;
  std::int64_t control_steps = 0;
  std::int64_t collision_checks = 0;
  std::int64_t fcl_checks = 0;
  std::int64_t stability_tests = 0;
  std::map<std::string, std::int64_t> refusals;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Statistics&) {
  using planning::Field;
  return std::make_tuple(
      Field{"seconds", &Statistics::seconds, "s", "Wall-clock time."},
      Field{"stability_seconds", &Statistics::stability_seconds, "s",
            "Part of the wall-clock time that was spent in stability tests."},
      Field{"certificate_seconds", &Statistics::certificate_seconds, "s",
            "Part of the wall-clock time that was spent on the certificate."},
      Field{"cycles", &Statistics::cycles, "",
            "Cycles of Algorithm 1 after the pre-expansions, over all trees."},
      Field{"nodes", &Statistics::nodes, "", "Nodes of all trees."},
      Field{"restarts", &Statistics::restarts, "", "Number of trees given up."},
      Field{
          "control_steps", &Statistics::control_steps, "", "TS-CONTROL steps.", {}, "Algorithm 4"},
      Field{"collision_checks", &Statistics::collision_checks, "", "Configurations checked."},
      Field{"fcl_checks", &Statistics::fcl_checks, "",
            "Checks of a link against the object by FCL, where the clearance left it open."},
      Field{"stability_tests", &Statistics::stability_tests, "", "Stability tests run."},
      Field{"refusals", &Statistics::refusals, "",
            "Number of rejected targets, connections and clasps by reason."});
}

/// Result of plan(): a motion that clasps the object, or the reason for failure.
struct Plan {
  Status status = Status::not_found;
  std::string reason;  ///< explanation of the status in one sentence
  std::vector<std::string> joint_names;
  std::vector<Segment> segments;
  int loop = -1;  ///< index of the clasped loop in object.loops().found
  /// Names of the fingers that clasp it together with the thumb. In a small hole these may be fewer
  /// than the hand has; the others close, too, but are not linked with the loop.
  std::vector<std::string> fingers;
  /// Pre-shape with which the search began; empty: Hand::open. The hand may be partly closed when
  /// it arrives.
  std::string pre_shape;
  geometry::ClaspTarget target;  ///< target that the hand holds, in O
  double min_linking = 0;        ///< threshold on |VLk| of the closed hand
  Stability stability;           ///< of the last row
  std::optional<Pinch> pinch;    ///< of the last row, if only friction holds the object there
  std::optional<Certificate> certificate;  ///< of the last row, unless time ran out
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
/// the search, with two exceptions: the threshold derived from the hand, and the tests of stability
/// and of a pinch and the certificate, which are run again. A second escape test uses FCL alone.
/// `options`: those of plan().
[[nodiscard]] GRASPLESS_API std::vector<std::string> check(const Problem& problem, const Plan& plan,
                                                           const Options& options = {});

/// Proves what check() samples: on every edge of a plan, for every t, nothing touches. See
/// slide::certify(). Throws std::invalid_argument if the plan is not solved or malformed.
[[nodiscard]] GRASPLESS_API scene::EdgeCertificate certify(const Problem& problem, const Plan& plan,
                                                           const Options& options = {});

}  // namespace graspless::clasp
