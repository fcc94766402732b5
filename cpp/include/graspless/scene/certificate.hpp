// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::scene {

/// Motion below which an edge is not divided further [m].
constexpr double kFinest = 1e-6;

enum class Verdict { refuted, undecided };

/// Table of the values: name and text.
constexpr auto choices(Verdict) {
  using planning::Choice;
  return std::array{
      Choice{Verdict::refuted, "refuted", "A configuration on the edge violates a condition."},
      Choice{Verdict::undecided, "undecided",
             "No violation was found, but the bounds do not exclude one."}};
}
GRASPLESS_API std::string to_string(Verdict verdict);

/// An edge that is not proven.
struct Doubt {
  std::string segment;
  std::size_t row = 0;  ///< the edge leads to this row from the one before; 0: from the last row
                        ///< of the segment before
  double t = 0;         ///< place on the edge: 0 at the row before, 1 at `row`
  Verdict verdict = Verdict::undecided;
  std::string condition;  ///< pair of bodies "a - b", or a quantity that must stay in its band
  /// Refuted: depth of a collision, or how far the quantity is outside its band. Undecided: the
  /// distance that is proven for a pair, or how far the bounds reach out of the band.
  double amount = 0;
  std::string unit = "m";  ///< of `amount`: m or rad

  /// One sentence, as check() puts its faults.
  GRASPLESS_API std::string text() const;
};

/// Result of a proof over all edges of a plan: straight motions in joint space from row to row.
struct EdgeCertificate {
  std::size_t num_edges = 0;
  std::vector<Doubt> doubts;  ///< in the order of the edges

  GRASPLESS_API std::size_t num_certified() const;  ///< edges without a doubt

  /// True if every edge is proven.
  explicit operator bool() const { return doubts.empty(); }
};

}  // namespace graspless::scene
