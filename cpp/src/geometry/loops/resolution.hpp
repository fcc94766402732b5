// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/geometry/complex.hpp"

#include "geometry/cycles/shortest_basis.hpp"

namespace graspless::geometry {

/// Tells neighbours on a surface from points with open space between them, by the local spacing of
/// the cloud. d of K_d follows the holes, not the spacing: where the widest plateau begins at a
/// large d, K_d also fills what is open.
class Resolution {
 public:
  explicit Resolution(const Complex& complex);

  /// Distance of two points relative to the smaller spacing of both.
  double relative_length(int a, int b) const;
  /// True if the edge between two points of the complex crosses open space.
  bool is_gap(int a, int b) const;
  /// Longest edge of a cycle that crosses open space [m]; 0 if none does.
  double widest_gap(const Cycle& cycle) const;

 private:
  const Eigen::Matrix3Xd& points_;  // of the complex, which must outlive this object
  /// Per point [m]: the distance of the sixth nearest neighbour, the median over the point and
  /// these neighbours. 0 for a point without an edge.
  std::vector<double> spacing_;
};

/// The edges and triangles of a complex that cross no open space. Its max_edge_length is the length
/// of the longest, or that of the complex if that crosses none.
Complex surface_of(const Complex& complex, const Resolution& resolution);

}  // namespace graspless::geometry
