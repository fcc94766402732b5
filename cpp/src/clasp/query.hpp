// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <random>
#include <string>

#include "graspless/clasp/clasp.hpp"
#include "graspless/planning/path.hpp"

#include "clasp/free_space/free_space.hpp"
#include "clasp/stability/pinch.hpp"
#include "clasp/stability/tester.hpp"
#include "scene/rows.hpp"

namespace graspless::clasp {

// Refusals of closed hands. The first two make the status of a failed search "not_secure".
constexpr const char* kNotSecure = "clasp: not secure";
constexpr const char* kForcedOpen = "clasp: forced open by the load";
constexpr const char* kBlocked = "clasp: the closed hand is in the object";

/// State of one call of plan().
struct Query {
  Query(const Problem& problem, const Options& options, planning::Clock& clock, std::uint64_t seed,
        double width = 0)
      : problem(problem), options(options), width(width), clock(clock), rng(seed), free(problem) {}

  const Problem& problem;
  const Options& options;
  const double width;  ///< of the whole hand [m]
  planning::Clock& clock;
  std::mt19937_64 rng;
  FreeSpace free;
  std::optional<StabilityTester> tester;    ///< created with the first clasp to test
  std::optional<PinchTester> pinch_tester;  ///< the same, for hands of two fingers
  Statistics statistics;
  // Of clasps that were refused:
  double most_withstood = 0;    ///< where the load is more [N]
  Pinch best_pinch;             ///< the one that resists most
  int num_escaped = 0;          ///< number of clasps that the object came free of
  double best_margin = -1e9;    ///< of these
  Eigen::VectorXd best_closed;  ///< hand and arm of the one with this margin
  int best_loop = 0;            ///< its loop
  int next_ring = 4;            ///< number of them before the next ring is computed
  Certificate best_ring;        ///< of the one with the best margin then

  /// Adds the counters of another query with the same object, and what it knows better.
  void add(const Query& other);

  /// Test of pinches, made at its first use.
  PinchTester& pinching() {
    if (!pinch_tester) pinch_tester.emplace(problem);
    return *pinch_tester;
  }
  /// True if the hand has two fingers, which may pinch.
  bool may_pinch() const { return problem.hand.fingers.size() == 1 && options.friction > 0; }

  void refuse(const std::string& why) { ++statistics.refusals[why]; }

  /// True if a straight motion is collision-free at the configurations that check() will test: rows
  /// of scene::kRowStep, subdivided at options.resolution.
  bool is_motion_free(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
    return !first_collision(from, to);
  }

  /// Same, but counts a rejected motion by the links that touch first.
  bool accept_motion(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
    const auto stretch = first_collision(from, to);
    if (!stretch) return true;
    std::string why = "motion: collision";
    for (const auto& q :
         planning::subdivided(*stretch, options.resolution, problem.robot.step_weights())) {
      const auto [a, b] = free.collision(q);
      if (a.empty()) continue;
      why += " of " + a + " with " + b;
      break;
    }
    refuse(why);
    return false;
  }

 private:
  /// Returns the first two rows of a straight motion between which it is not free.
  std::optional<planning::Path> first_collision(const Eigen::VectorXd& from,
                                                const Eigen::VectorXd& to) {
    const planning::Path rows =
        planning::subdivided({from, to}, scene::kRowStep, problem.robot.step_weights());
    for (std::size_t i = 1; i < rows.size(); ++i) {
      if (!free.is_free(rows[i - 1], rows[i], options.resolution)) return {{rows[i - 1], rows[i]}};
    }
    return std::nullopt;
  }
};

}  // namespace graspless::clasp
