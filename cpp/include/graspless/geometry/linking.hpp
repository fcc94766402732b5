// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Linking of curves (Stork, Pokorny, Kragic 2013, Sections III-A and IV-C). A curve is a polyline
// with one corner per column (3 x n) [m]. A closed curve does not repeat its first corner. Pairs
// of segments that touch or are collinear contribute 0, so every value is finite.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"

namespace graspless::geometry {

/// Gauss linking integral, eq. (1), of two polylines, in closed form for every pair of segments
/// (Klenin, Langowski 2000). An integer up to rounding if both are closed. Throws
/// std::invalid_argument if a curve has fewer than 2 corners (3 if closed) or is not finite.
GRASPLESS_API double gauss_linking(const Eigen::Matrix3Xd& a, bool a_is_closed,
                                   const Eigen::Matrix3Xd& b, bool b_is_closed);

/// Linking number Lk of two closed polylines: eq. (1) as an exact integer, by signed crossings. If
/// the curves touch to within rounding, the integral is rounded instead, a half towards zero.
GRASPLESS_API int linking_number(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b);

/// First factor of eq. (2) for an open curve: 1 - chord / (chord + length of the curve). The chord
/// runs from the last corner to the first. 1 if the ends meet, 0 for a point.
GRASPLESS_API double closedness(const Eigen::Matrix3Xd& curve);
/// Same, with the gradient with respect to the corners (3 x n) [1/m].
GRASPLESS_API double closedness(const Eigen::Matrix3Xd& curve, Eigen::Matrix3Xd& gradient);

/// Virtual linking VLk, eq. (2): closedness(curve) * Lk(loop, curve closed by its chord). `loop` is
/// closed, `curve` is open. Signed.
GRASPLESS_API double virtual_linking(const Eigen::Matrix3Xd& loop, const Eigen::Matrix3Xd& curve);

/// Virtual linking with its gradient with respect to the curve's corners. Lk is piecewise constant,
/// so the gradient is Lk times that of the closedness. Zero if not linked.
struct VirtualLinking {
  double value = 0;
  int linking_number = 0;
  Eigen::Matrix3Xd gradient;  ///< (3 x n), column i for corner i of the curve [1/m]
};
GRASPLESS_API VirtualLinking virtual_linking_gradient(const Eigen::Matrix3Xd& loop,
                                                      const Eigen::Matrix3Xd& curve);

/// A closed loop preprocessed for many linking queries: its corners in a layout for SIMD, with
/// bounding boxes. Immutable and thread-safe.
class GRASPLESS_API PreparedLoop {
 public:
  explicit PreparedLoop(const Eigen::Matrix3Xd& loop);
  const Eigen::Matrix3Xd& points() const { return points_; }
  /// Same as the free functions, with this loop as the first curve.
  double gauss_linking(const Eigen::Matrix3Xd& curve, bool is_closed) const;
  int linking_number(const Eigen::Matrix3Xd& closed_curve) const;
  /// Vector field whose line integral along a curve is gauss_linking() of that curve [1/m]. It is
  /// the magnetic field of a unit current in the loop. Zero on the loop itself.
  Eigen::Vector3d field(const Eigen::Vector3d& point) const;
  /// Batch versions, one value per curve.
  std::vector<double> gauss_linking(const std::vector<Eigen::Matrix3Xd>& curves,
                                    bool are_closed) const;
  std::vector<int> linking_numbers(const std::vector<Eigen::Matrix3Xd>& closed_curves) const;

 private:
  Eigen::Matrix3Xd points_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> corners_;  // a column per coordinate, first repeated
  double max_coordinate_ = 0;                         // absolute value [m]
  Eigen::Matrix<double, 6, Eigen::Dynamic> boxes_;    // (lower, upper) of each run of segments
};

}  // namespace graspless::geometry
