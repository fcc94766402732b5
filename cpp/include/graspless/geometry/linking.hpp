// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"

/// How curves wind around one another (Stork, Pokorny, Kragic 2013). A curve is a polyline, one
/// corner a column [m]; a closed one does not repeat its first corner. Segments that touch or lie
/// on one line count 0: every value is finite.
namespace graspless::geometry {

/// The Gauss linking integral (1) of two polylines, in closed form for every pair of segments
/// (Klenin, Langowski 2000). An integer where both are closed. Throws std::invalid_argument on a
/// curve of fewer than 2 corners (3 when closed) or one that is not finite.
GRASPLESS_API double gauss_linking(const Eigen::Matrix3Xd& a, bool a_is_closed,
                                   const Eigen::Matrix3Xd& b, bool b_is_closed);

/// Lk of two closed polylines by signed crossings: the integral (1) as an integer. Where the curves
/// touch to within rounding, the integral rounded, a half towards zero.
GRASPLESS_API int linking_number(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b);

/// The first factor of eq. (2): 1 - chord / length of an open curve, with the chord from its last
/// corner to its first and the length of both together; 1 when the ends meet, 0 for a point.
GRASPLESS_API double closedness(const Eigen::Matrix3Xd& curve);
/// The same, with its derivative by the corners, one a column [1/m].
GRASPLESS_API double closedness(const Eigen::Matrix3Xd& curve, Eigen::Matrix3Xd& gradient);

/// VLk of eq. (2): closedness(curve) times Lk(loop, curve and chord). `loop` is closed, `curve`
/// open. Signed.
GRASPLESS_API double virtual_linking(const Eigen::Matrix3Xd& loop, const Eigen::Matrix3Xd& curve);

/// VLk with its derivative by the curve's corners. Lk is constant but where curves cross, so that
/// the derivative is that of the chord's factor times Lk; zero when not linked.
struct VirtualLinking {
  double value = 0;
  int linking_number = 0;
  Eigen::Matrix3Xd gradient;  ///< column i: by corner i of the curve [1/m]
};
GRASPLESS_API VirtualLinking virtual_linking_gradient(const Eigen::Matrix3Xd& loop,
                                                      const Eigen::Matrix3Xd& curve);

/// A closed loop prepared for many questions: its corners in the order that vector units like.
/// Immutable; may be used from several threads.
class GRASPLESS_API PreparedLoop {
 public:
  explicit PreparedLoop(const Eigen::Matrix3Xd& loop);
  const Eigen::Matrix3Xd& points() const { return points_; }
  /// As the free functions, with this loop as the first curve.
  double gauss_linking(const Eigen::Matrix3Xd& curve, bool is_closed) const;
  int linking_number(const Eigen::Matrix3Xd& closed_curve) const;
  /// The field whose integral along a curve is gauss_linking() of that curve: that of a current in
  /// the loop [1/m]. Zero on the loop itself.
  Eigen::Vector3d field(const Eigen::Vector3d& point) const;
  /// All curves at once.
  std::vector<double> gauss_linking(const std::vector<Eigen::Matrix3Xd>& curves,
                                    bool are_closed) const;
  std::vector<int> linking_numbers(const std::vector<Eigen::Matrix3Xd>& closed_curves) const;

 private:
  Eigen::Matrix3Xd points_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> corners_;  // a column per coordinate, the first repeated
  double reach_ = 0;                                  // largest coordinate
  Eigen::Matrix<double, 6, Eigen::Dynamic> boxes_;    // low, high of every few segments in turn
};

}  // namespace graspless::geometry
