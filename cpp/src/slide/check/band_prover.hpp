// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "scene/bands.hpp"
#include "slide/check/examination.hpp"

namespace graspless::slide {

/// Proves that the quantities which check() samples stay in their bands on the edges of a segment.
class BandProver {
 public:
  BandProver(const Examination& examination, const Segment& segment);

  /// Returns one doubt for each edge on which a band is not proven.
  std::vector<scene::Doubt> run();

 private:
  /// A configuration on an edge, as far as the bands depend on it.
  struct Place {
    ReplayedFinger finger;
    Eigen::Isometry3d X_GH;  // of the hand, from its goal; of the segment `grasp` only
  };
  /// The last point that was compared with a polygon.
  struct Anchor {
    Eigen::Vector2d p = Eigen::Vector2d::Zero();
    double depth = 0;
    bool is_set = false;
  };

  Place place(std::size_t edge, double t) const;
  scene::Slack slack(const Place& from, const Place& to, double width);
  void add_slide(const FingerSpan& span, const ReplayedFinger& from, const ReplayedFinger& to,
                 scene::Slack& slack);
  void add_touch(const FingerSpan& span, scene::Slack& slack) const;
  void add_still(const FingerSpan& span, const ReplayedFinger& from, const ReplayedFinger& to,
                 scene::Slack& slack) const;
  void add_inside(const FingerSpan& span, const ReplayedFinger& from, const ReplayedFinger& to,
                  double play, scene::Slack& slack);
  void add_straight(const Place& from, const Place& to, double width, scene::Slack& slack) const;
  double inside(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double off, double enough,
                Anchor& anchor) const;

  const Examination& examination_;
  const Segment& segment_;
  bool slides_, grasps_, retreats_, must_stay_;
  double touching_;  // depth above which the finger touches the object [m]
  int hand_;
  ReplayedFinger pressed_;
  bool is_support_convex_;
  Anchor commanded_, effective_;
  scene::FrameRates finger_rates_, hand_rates_;  // on the current edge
};

}  // namespace graspless::slide
