// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"

namespace graspless::geometry {

/// K_d of a cloud: the edges and triangles of its Delaunay triangulation (CGAL) whose edges are all
/// shorter than d. Interior triangles too; every point stays a vertex.
struct Complex {
  Eigen::Matrix3Xd points;     ///< [m]
  Eigen::Matrix2Xi edges;      ///< columns of point indices, the smaller first; sorted
  Eigen::Matrix3Xi triangles;  ///< columns of point indices, ascending; sorted
  double max_edge_length = 0;  ///< d [m]
};

/// A step function of d: `loops[i]` for d above `max_edge_length[i]` up to the next, that included;
/// nothing below the first.
struct BettiCurve {
  std::vector<double> max_edge_length;  ///< ascending [m]
  std::vector<int> loops;               ///< dimension of H_1(K_d; Z_2)
};

/// A stretch of d, lower < d <= upper, over which the same loops live.
struct Plateau {
  double lower = 0, upper = 0;  ///< of d [m]
  int loops = 0;
  double ratio() const { return lower > 0 ? upper / lower : 0; }
};

/// A class of H_1 that K_d has for birth < d <= death [m].
struct PersistencePair {
  double birth = 0, death = 0;
};

/// The least ratio death / birth of a loop that is not taken for noise.
constexpr double kLasting = 1.12;

/// The Delaunay triangulation of a cloud, its simplices in order of their longest edge: every K_d
/// at once. Immutable; copies share.
class GRASPLESS_API Filtration {
 public:
  /// Points are the columns [m]. Equal points count once (the first index stays a vertex, the
  /// others hang on it by nothing). Throws std::invalid_argument, naming `what`, when there are
  /// fewer than 4 distinct points, one is not finite or beyond kMaxLength, or all lie in a plane.
  explicit Filtration(const Eigen::Matrix3Xd& points, const std::string& what = "points");

  const Eigen::Matrix3Xd& points() const;
  /// Distinct points.
  int num_vertices() const;
  /// K_d for d = max_edge_length [m].
  Complex complex(double max_edge_length) const;
  /// The persistence of H_1 over Z_2, longest ratio death / birth first; pairs that die at birth
  /// are left out.
  const std::vector<PersistencePair>& persistence() const;
  /// The whole Betti-1 curve.
  const BettiCurve& betti() const;
  /// Stretches of d with at least one lasting loop, widest ratio first. A loop lasts whose ratio
  /// death / birth is at least `lasting`: those that come and go at once are the cloud's noise. 1
  /// counts all, as the Betti curve does.
  std::vector<Plateau> plateaus(double lasting = kLasting) const;
  /// From when to when the class of a closed walk of K_d lives: birth is where the first walk of
  /// its class appears, death where it is filled; equal where it is filled in K_d itself. `cycle`
  /// holds columns, the first not repeated. Throws std::invalid_argument on a step that is no edge.
  PersistencePair span(const std::vector<int>& cycle, double max_edge_length) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace graspless::geometry
