// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Planners to compare the slide planner with.
#pragma once

#include <cstdint>
#include <memory>

#include <Eigen/Core>

#include "graspless/planning/path.hpp"
#include "graspless/slide/slide.hpp"

namespace graspless::benchmarks {

enum class Peer {
  forest,   ///< ours, with nothing but the pair: the fast search's connection
  cbirrt,   ///< Algorithm 1 with the pair's start and goal for its only roots
  cbirrt2,  ///< Algorithm 1 with the pair's start for its only start root; goals are sampled
  // OMPL's planners over its constrained spaces, between start and goal. An equality holds height,
  // pitch and roll of the fingertip: these spaces know no bands.
  tangent_bundle_rrt_connect,
  projected_biest,
  atlas_rrt_connect,
  projected_rrt_connect,
};

/// How a goal is found for a start that was drawn from C_s.
enum class PairDraw {
  independent,  ///< from C_g, until the pair is valid: the paper's precomputed pairs
  fitting,      ///< drawn to fit the start, on the nearest branch of its inverse kinematics
};

struct Answer {
  slide::Plan plan;    ///< whole, so that slide::check() can replay it
  double seconds = 0;  ///< of the peer alone: setup, search, and the path made dense [s]
};

/// A problem with one start and one goal that IsPairValid accepts, for planners that want these.
class PairProblem {
 public:
  /// Draws the pair; the same seed gives the same. Throws std::invalid_argument as slide::plan
  /// does.
  PairProblem(const slide::Problem& problem, const slide::Options& options, PairDraw draw,
              std::uint64_t seed);
  ~PairProblem();

  /// Whether a pair was found.
  bool has_pair() const;
  const Eigen::VectorXd& start() const;  ///< of the arm's joints [rad]
  const Eigen::VectorXd& goal() const;

  /// Lets a peer slide from start to goal; the motions before and after are the pair's. Uses the
  /// budget's time, seed and interruption. Throws std::logic_error without a pair.
  Answer run(Peer peer, const planning::Budget& budget);

  /// True if the arm at `arm` keeps the contact of the slide from start(), and nothing collides.
  bool is_valid(const Eigen::VectorXd& arm);
  /// Returns the plan whose slide is `path` from start() to goal().
  slide::Plan completed(const planning::Path& path);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace graspless::benchmarks
