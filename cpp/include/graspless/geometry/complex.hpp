// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"

namespace graspless::geometry {

/// Simplicial complex K_d of a cloud (Stork 2013, Section IV-A): the edges and triangles of its
/// Delaunay triangulation (CGAL) with all edges shorter than d. Includes interior triangles. Every
/// point is a vertex.
struct Complex {
  Eigen::Matrix3Xd points;     ///< [m]
  Eigen::Matrix2Xi edges;      ///< columns of point indices, the smaller first; sorted
  Eigen::Matrix3Xi triangles;  ///< columns of point indices, ascending; sorted
  double max_edge_length = 0;  ///< d [m]
};

/// Number of independent loops of K_d as a step function of d: loops[i] for d in
/// (max_edge_length[i], max_edge_length[i + 1]], and 0 up to max_edge_length[0].
struct BettiCurve {
  std::vector<double> max_edge_length;  ///< ascending [m]
  std::vector<int> loops;               ///< dimension of H_1(K_d; Z_2)
};

/// Interval (lower, upper] of d over which the set of lasting loops does not change.
struct Plateau {
  double lower = 0, upper = 0;  ///< bounds of d [m]
  int loops = 0;                ///< number of lasting loops
  double ratio() const { return lower > 0 ? upper / lower : 0; }
};

/// A class of H_1(K_d), present for d in (birth, death] [m].
struct PersistencePair {
  double birth = 0, death = 0;
  std::array<int, 2> closing{-1, -1};  ///< points of the edge that closes the class's first loop
  std::array<int, 3> filling{-1, -1, -1};  ///< points of the triangle that fills its last loop
};

/// Bits for each edge of a complex. Those of a cycle's edges add up, over Z_2, to the classes that
/// the cycle contains.
struct ClassLabels {
  int num_classes = 0, words = 1;
  std::vector<std::uint64_t> bits;  ///< `words` words for each edge
};

/// Smallest ratio death / birth of a lasting loop. Loops below it count as noise.
constexpr double kLastingRatio = 1.12;

/// The Delaunay triangulation of a cloud with its simplices ordered by longest edge. It represents
/// K_d for every d. Immutable; copies share their data.
class GRASPLESS_API Filtration {
 public:
  /// A copy shares all data. Moving copies, so that no object is left empty.
  Filtration(const Filtration&) = default;
  Filtration& operator=(const Filtration&) = default;

  /// `points`: 3 x n [m]. Equal points count once: the first is a vertex of edges, the others are
  /// isolated. Throws std::invalid_argument that names `what` if there are fewer than 4 distinct
  /// points, if one is not finite or beyond kMaxLength, or if all lie in a plane.
  explicit Filtration(const Eigen::Matrix3Xd& points, const std::string& what = "points");

  const Eigen::Matrix3Xd& points() const;
  /// Number of distinct points.
  int num_vertices() const;
  /// Returns K_d for d = max_edge_length [m]. Throws std::invalid_argument if it is negative.
  Complex complex(double max_edge_length) const;
  /// Persistence pairs of H_1 over Z_2, largest ratio death / birth first. Omits pairs that die at
  /// birth.
  const std::vector<PersistencePair>& persistence() const;
  /// Number of independent loops for every d (first Betti number).
  const BettiCurve& betti() const;
  /// Plateaus with at least one lasting loop, largest ratio upper / lower first. A loop is lasting
  /// if its ratio death / birth is at least `lasting_ratio`; 1 counts every loop, as betti() does.
  /// Throws std::invalid_argument if it is less.
  std::vector<Plateau> plateaus(double lasting_ratio = kLastingRatio) const;
  /// Labels of the edges of complex(max_edge_length) for some of the classes that are alive in it:
  /// bit i is for persistence()[classes[i]]. A cycle contains a class if the sum of its edges'
  /// labels has the bit. Other classes have no label. Throws std::invalid_argument if a class is
  /// not alive at max_edge_length.
  ClassLabels labels(double max_edge_length, const std::vector<int>& classes) const;
  /// Ratio of the edge that closes the loop of a pair to the longest other step on the way round,
  /// in the tree of shortest edges. About 1 where points are spread evenly; larger across a gap.
  /// Throws std::invalid_argument if pair.closing is no edge between two points.
  double jump(const PersistencePair& pair) const;
  /// Birth and death of the homology class of a closed walk in K_d. The class is born when the
  /// first walk in it appears, and dies when it is filled. The two are equal if the walk is filled
  /// in K_d itself. `cycle` lists columns of points() without repeating the first. Throws
  /// std::invalid_argument if a step of the walk is not an edge of K_d, or if it has fewer than 3.
  PersistencePair span(const std::vector<int>& cycle, double max_edge_length) const;

 private:
  struct Data;
  std::shared_ptr<const Data> data_;
};

}  // namespace graspless::geometry
