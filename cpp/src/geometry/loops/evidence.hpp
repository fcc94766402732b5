// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "graspless/geometry/loops.hpp"

namespace graspless::geometry {

/// Findings of rays about a loop.
struct Passage {
  std::vector<char> is_passed;   ///< per open region: true if all its rays are linked with the loop
  std::vector<char> is_touched;  ///< same, if some are
  double seen_through = 0;       ///< as in Loop
  double unseen = 0;             ///< as in Loop
  double gap = 0;                ///< longest step that rays passed [m]; 0: none
};

/// The open regions in the images of cameras: connected pixels whose rays pass the object.
///
/// A ray from the camera to infinity that keeps clear of the object is a closed curve outside it.
/// If it is linked with a loop on the object, the loop cannot be drawn together: it runs around a
/// hole. The two are linked if the loop's projection winds around the ray's pixel an odd number of
/// times. Pixels of one region are linked alike, or the loop leaves the object between them.
class Evidence {
 public:
  /// `points`: of the object [m]. Keeps a reference to `rays`.
  Evidence(const std::vector<RayImage>& rays, const Eigen::Matrix3Xd& points);

  /// `loop`: corners [m]. `spacing`: of the points [m]; shorter steps than some of it count as
  /// seen.
  Passage of(const Eigen::Matrix3Xd& loop, double spacing) const;

 private:
  using Labels = Eigen::Array<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  struct View {
    const RayImage* rays;
    Eigen::Isometry3d X_CO;
    Labels region;  // of each pixel; -1: none
  };
  void count_linked(const View& view, const Eigen::Matrix3Xd& loop, Passage& passage) const;
  void examine_steps(const Eigen::Matrix3Xd& loop, double spacing, Passage& passage) const;

  std::vector<View> views_;
  std::vector<int> size_;  // of each region [pixels]
};

/// Decides by rays which loops are holes, and moves the others to `uncertain` with the reason.
void weigh(const Evidence& evidence, double spacing, Loops& result);

}  // namespace graspless::geometry
