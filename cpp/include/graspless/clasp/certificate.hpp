// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <Eigen/Core>

#include "graspless/clasp/problem.hpp"
#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::clasp {

/// Options of certificate(); fields() describes them.
struct CertificateOptions {
  double tolerance = 0.002;
  int moves = 1000;
  std::uint64_t seed = 1;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const CertificateOptions&) {
  using planning::Field, planning::Range;
  using Options = CertificateOptions;
  return std::make_tuple(
      Field{"tolerance", &Options::tolerance, "m",
            "Width of the interval at which the search for a way out ends.",
            Range::closed(1e-4, 0.1)},
      Field{"moves", &Options::moves, "",
            "Largest number of moves of the object in the search for a way out. 0: no search; the "
            "upper bound needs none.",
            Range::closed(0, 100000)},
      Field{"seed", &Options::seed, "", "Seed of the moves.", Range::not_negative()});
}

/// Throws std::invalid_argument that names the option, its value and its range.
GRASPLESS_API void validate(const CertificateOptions& options);

/// Bounds on the opening through which a loop can leave a hand that does not move. The opening is
/// the largest clearance that the object can keep from the hand on its way out [m]. If it is
/// negative, the object must enter the hand as deep as that.
struct Certificate {
  /// True if `upper` is below 0: no motion takes the loop out of the hand.
  bool caged = false;
  double lower = 0;  ///< clearance on a way out that was found [m]
  double upper = 0;  ///< proven bound [m]; kUnlinked if no ring of the hand is linked with the loop
  /// Diameter of a ball that fits into the object all along the loop [m]; 0: nothing is known to be
  /// inside the object there.
  double thickness = 0;
  double gap = 0;  ///< widest gap in the hand's ring [m]; negative where balls overlap
  std::array<std::string, 2> between;  ///< links on both sides of the gap
  std::int64_t moves = 0;              ///< number of moves that were tried
};

constexpr double kUnlinked = 1e6;  ///< upper bound where nothing holds the loop [m]

/// Bounds the opening of the hand at configuration q for a loop of the object.
///
/// The hand is the balls that fill its links, as in test_stability(); a mesh that is not convex has
/// none. A ring is a closed chain of balls. The core is a closed curve in the object, where the
/// object has an inside, else the loop itself; a ball of diameter `thickness` fits into the object
/// all along it. While ring and core are linked, the core must pass between two neighbouring balls
/// to come free, which needs a clearance of at most (gap - thickness) / 2. `upper` is the least
/// that was found over all rings. This also holds for an object that bends, if its core stays as
/// thick.
///
/// `lower` belongs to a rigid motion that was found, on which the bound on the distance of every
/// ball holds between the poses as well. The core leaves a ball that contains the finger curves.
///
/// Throws std::invalid_argument on an invalid problem, loop, configuration or option.
GRASPLESS_API Certificate certificate(const Problem& problem, const Eigen::VectorXd& q, int loop,
                                      const CertificateOptions& options = {});

}  // namespace graspless::clasp
