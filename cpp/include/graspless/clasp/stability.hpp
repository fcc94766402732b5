// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "graspless/clasp/problem.hpp"
#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::clasp {

/// The test of Section V-A: the hand stands still, the object moves at random, each move until it
/// hits the hand. Deeper penetration than the paper's none, so that the test errs towards escape;
/// but a link that is a concave mesh is filled to its hull, which errs the other way.
struct StabilityOptions {
  int sequences = 10;
  int moves = 500;
  double step = 0.002;
  double turn = 0.01;
  double penetration = 0.003;
  double escape_distance = 0;
  std::uint64_t seed = 1;
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
      Field{"seed", &Options::seed, "", "Seed of the random moves.", Range::not_negative()});
}

/// Throws std::invalid_argument that names the option, its value and what it may be.
GRASPLESS_API void validate(const StabilityOptions& options);

struct Stability {
  bool secure = false;
  int escapes = 0;  ///< sequences in which the loop came free
  /// 1 - farthest / escape_distance, of the farthest that the loop's nearest point came from the
  /// hand's centre in any sequence: 1 cannot move, 0 or less escaped.
  double margin = 0;
  std::int64_t checks = 0;  ///< poses looked at
};

/// Whether the object's loop stays in the hand at q. All links are in the way, filled by balls (of
/// a mesh that is not convex, its hull); a robot that stands deeper than `penetration` in the
/// object holds nothing. The hand's centre is the middle of its curves' box. One move ends, if
/// nothing is hit, after twice the escape distance or a whole turn. Throws std::invalid_argument on
/// a bad problem, loop or configuration.
GRASPLESS_API Stability test_stability(const Problem& problem, const Eigen::VectorXd& q, int loop,
                                       const StabilityOptions& options = {});

}  // namespace graspless::clasp
