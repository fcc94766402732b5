// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Sequences of random moves of the object, each from the clasp on.
#pragma once

#include <cstdint>
#include <memory>

#include <Eigen/Core>

#include "graspless/clasp/stability.hpp"
#include "graspless/collision/clearance.hpp"

#include "clasp/stability/walk.hpp"
#include "crew.hpp"

namespace graspless::clasp {

/// A walk with a grid of distances that no other walk uses at the same time.
struct Walker {
  std::shared_ptr<collision::Clearance> clearance;
  ObjectWalk walk;
};

/// Where a loop has come in some sequences.
struct Sequences {
  int escapes = 0;          ///< number of sequences in which it escaped
  double farthest = 0;      ///< largest distance from the hand's centre in any [m]
  std::int64_t checks = 0;  ///< number of poses checked
};

/// Runs options.sequences. If the loop escaped in one of the first `least_sequences`, ends after
/// these. `escape`: distance of the loop from the hand's centre at which it has escaped [m]. A
/// sequence goes on where the random numbers of the one before ended. The result does not depend on
/// the number of threads.
Sequences run_sequences(const Eigen::Matrix3Xd& loop_O, double escape,
                        const StabilityOptions& options, int least_sequences,
                        Spares<Walker>& walkers, Crew& crew);

}  // namespace graspless::clasp
