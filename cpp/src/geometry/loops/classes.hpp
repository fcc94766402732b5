// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "graspless/geometry/complex.hpp"
#include "graspless/geometry/loops.hpp"

namespace graspless::geometry {

/// A class of H_1 that lives long enough to be listed, with what it is taken for.
struct JudgedClass {
  enum class Kind { found, uncertain, meridian };
  Kind kind = Kind::found;
  PersistencePair span;
  int pair = -1;        ///< index in Filtration::persistence()
  double openness = 0;  ///< as in Loop
  double jump = 0;      ///< as in Loop
  std::string reason;   ///< why it is uncertain
  /// Largest d of a complex in which its loop is still at its own scale [m].
  double coarsest() const;
};

/// Classes alive at `max_edge_length`, or at any d if that is 0, which live long enough to be
/// listed. Longest ratio first.
std::vector<JudgedClass> judged_classes(const Filtration& filtration, const LoopOptions& options);

}  // namespace graspless::geometry
