// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Alpha shapes of points in the plane (Edelsbrunner, Kirkpatrick, Seidel 1983).
#pragma once

#include <limits>
#include <vector>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <Eigen/Core>

namespace graspless::geometry::alpha {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

struct FaceInfo {
  double squared_radius = std::numeric_limits<double>::infinity();  // of the circumcircle [m^2]
  int index = -1;                                                   // of finite faces
};
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;  // index of the vertex
using Face = CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;

/// A closed boundary, with the interior on its left.
struct Loop {
  std::vector<Eigen::Vector2d> points;
  bool touches = false;  ///< it meets itself or another loop at a point
};

/// Longest side of the points' box [m]; there must be points.
double extent(const Eigen::Matrix2Xd& points);

/// The alpha shapes of points in the plane, regularized: for each alpha, the faces of the Delaunay
/// triangulation whose squared circumradius is alpha at most. CGAL's Alpha_shape_2 keeps intervals
/// of all faces, edges and vertices in maps, which takes five times as long.
class AlphaShapes {
 public:
  explicit AlphaShapes(const Eigen::Matrix2Xd& points);

  bool span_an_area() const { return delaunay_.dimension() == 2; }

  /// Alpha at which all points lie on one piece, and somewhat more: CGAL's find_optimal_alpha(1)
  /// returns the next value of its spectrum, which may be the vast one of a needle.
  double optimal_alpha() const;

  /// Median distance of a point to its nearest neighbour [m].
  double median_spacing() const;

  /// Number of distinct points.
  int num_points() const { return static_cast<int>(delaunay_.number_of_vertices()); }

  /// Number of distinct points that steps of at most `longest` [m] from point to point do not join
  /// with most of the others.
  int count_strays(double longest) const;

  /// Boundaries of the shape, with the interior on the left. Where the shape touches itself at a
  /// point, the part outside decides which edges follow each other: a hole that touches the outer
  /// boundary has a loop of its own.
  std::vector<Loop> loops(double alpha) const;

 private:
  using FaceHandle = Delaunay::Face_handle;
  using VertexHandle = Delaunay::Vertex_handle;

  struct Edge {
    VertexHandle from, to;
  };

  static bool is_left_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b);
  static Eigen::Vector2d position(VertexHandle vertex);
  static const Kernel::Point_2& corner(FaceHandle face, int i) { return face->vertex(i)->point(); }

  /// Rounds points to multiples of 2^-25 of their extent: determinants of differences are exact.
  static Eigen::Matrix2Xd rounded(const Eigen::Matrix2Xd& points);

  /// Computes the circles of the finite faces. Returns false at a needle: a triangle has a positive
  /// area, which predicates find exactly, but its determinant is 0 in double precision.
  bool read_faces();

  /// As CGAL inserts a range of points, but with polls.
  void insert(const Eigen::Matrix2Xd& points);

  /// Values of alpha at which the general alpha shape changes: squared radii of faces, and of edges
  /// whose smallest circle holds no other point; ascending.
  std::vector<double> alpha_spectrum() const;

  /// Least alpha at which every point is a corner of the shape.
  double least_covering() const;

  /// Number of pieces, connected by edges, at each value.
  std::vector<int> count_pieces(const std::vector<double>& values) const;

  /// Boundary edges of the shape, with the interior on the left, by their first vertex.
  std::vector<Edge> boundary(double alpha) const;

  /// True if another edge leaves the start of an edge.
  static bool meets(const std::vector<Edge>& edges, std::size_t at);

  /// The first edge that leaves the end of an edge, counter-clockwise from there: across the
  /// outside.
  static std::size_t following(const std::vector<Edge>& edges, std::size_t at);

  Delaunay delaunay_;
  std::vector<FaceHandle> faces_;  // finite ones by ascending circumradius
};

}  // namespace graspless::geometry::alpha
