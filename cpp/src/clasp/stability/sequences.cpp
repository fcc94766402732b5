// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/sequences.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "graspless/watch.hpp"

#include "geometry/segment.hpp"

namespace graspless::clasp {
namespace {

Eigen::Vector3d random_direction(std::mt19937_64& rng) {
  std::uniform_real_distribution<double> side(-1, 1);
  while (true) {
    const Eigen::Vector3d v(side(rng), side(rng), side(rng));
    const double square = v.squaredNorm();
    if (square <= 1 && square > 1e-4) return v / std::sqrt(square);
  }
}

/// Moves in turn are translations and rotations.
struct Sequence {
  std::mt19937_64 rng;                      // before the directions were drawn
  std::vector<Eigen::Vector3d> directions;  // of its moves
  int moves = 0;                            // those made
  bool escapes = false;
  double farthest = 0;  // [m]
  std::int64_t checks = 0;
};

/// The numbers that its moves take if the loop does not escape before the last.
Sequence drawn(std::mt19937_64& rng, int moves) {
  Sequence sequence;
  sequence.rng = rng;
  for (int i = 0; i < moves; ++i) sequence.directions.push_back(random_direction(rng));
  return sequence;
}

void run(const Eigen::Matrix3Xd& loop_O, double escape, const StabilityOptions& options,
         ObjectWalk& walk, Sequence& sequence) {
  // No move needs to be longer than the diameter of the escape sphere, or than a full turn.
  const int max_steps = static_cast<int>(std::ceil(2 * escape / options.step));
  const int max_turns = static_cast<int>(std::ceil(2 * M_PI / options.turn));
  walk.reset();
  const std::int64_t before = walk.steps();
  double distance = geometry::distance_to_loop(loop_O, walk.p_OC());
  sequence.farthest = distance;
  for (const Eigen::Vector3d& direction : sequence.directions) {
    if (distance > escape) break;
    poll();
    if (sequence.moves++ % 2 == 0) {
      walk.translate(direction, max_steps);
      distance = geometry::distance_to_loop(loop_O, walk.p_OC());
      sequence.farthest = std::max(sequence.farthest, distance);
    } else {
      walk.rotate(direction, max_turns);
    }
  }
  sequence.escapes = distance > escape;
  sequence.checks = walk.steps() - before;
}

}  // namespace

Sequences run_sequences(const Eigen::Matrix3Xd& loop_O, double escape,
                        const StabilityOptions& options, int least_sequences,
                        Spares<Walker>& walkers, Crew& crew) {
  Sequences result;
  std::mt19937_64 rng(options.seed);
  for (int done = 0; done < options.sequences;) {
    if (result.escapes > 0 && done == least_sequences) break;
    // Together only where no escape is likely, as what follows one is in vain.
    const bool is_alone = options.threads == 1 || done == 0 || result.escapes > 0;
    std::vector<Sequence> round;
    for (int i = 0; i < (is_alone ? 1 : options.sequences - done); ++i)
      round.push_back(drawn(rng, options.moves));
    walkers.stock(std::min(round.size(), static_cast<std::size_t>(options.threads)));
    crew.share(round.size(), [&](std::size_t i) {
      walkers.lend([&](Walker& walker) {
        run(loop_O, escape, options, walker.walk, round[i]);
        return true;
      });
    });
    for (Sequence& sequence : round) {
      ++done;
      result.farthest = std::max(result.farthest, sequence.farthest);
      result.checks += sequence.checks;
      if (!sequence.escapes) continue;
      ++result.escapes;
      rng = sequence.rng;
      for (int i = 0; i < sequence.moves; ++i) random_direction(rng);
      break;
    }
  }
  return result;
}

}  // namespace graspless::clasp
