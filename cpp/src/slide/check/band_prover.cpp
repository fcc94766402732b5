// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Every condition that contact.cpp and goal.cpp test at configurations, for a part of
// an edge: a part is divided until the bounds of finger_span.cpp keep all bands on it.
#include "slide/check/band_prover.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace graspless::slide {
namespace {

double angle_of(const Eigen::Isometry3d& X) { return Eigen::AngleAxisd(X.linear()).angle(); }

}  // namespace

BandProver::BandProver(const Examination& examination, const Segment& segment)
    : examination_(examination),
      segment_(segment),
      slides_(segment.name == "slide"),
      grasps_(segment.name == "grasp"),
      retreats_(segment.name == "retreat"),
      hand_(examination.problem_.robot.frame(examination.problem_.hand.grasp_frame)),
      is_support_convex_(examination.problem_.support.polygon().is_convex()) {
  const bool flexes = examination.problem_.hand.finger_model == FingerModel::flexure;
  touching_ = flexes || retreats_ ? 0 : -kHeightTolerance;
  pressed_ = examination.finger(segment.name == "press" ? segment.positions.back()
                                                        : segment.positions.front());
  must_stay_ = !retreats_ || examination.is_on_object(segment, pressed_);
}

std::vector<scene::Doubt> BandProver::run() {
  const bool touches = slides_ || retreats_ || segment_.name == "press" || segment_.name == "lift";
  if (!touches && !grasps_) return {};
  const robot::Robot& robot = examination_.problem_.robot;
  std::vector<scene::Doubt> doubts;
  for (std::size_t edge = 0; edge + 1 < segment_.positions.size(); ++edge) {
    const Eigen::VectorXd step = segment_.positions[edge + 1] - segment_.positions[edge];
    finger_rates_ = scene::frame_rates(robot, examination_.fingertip_, step);
    hand_rates_ = scene::frame_rates(robot, hand_, step);
    const auto doubt = scene::find_doubt(
        segment_.name, edge, [&](double t) { return place(edge, t); },
        [&](double from, const Place& at_from, double to, const Place& at_to) {
          return slack(at_from, at_to, to - from);
        });
    if (doubt) doubts.push_back(*doubt);
  }
  return doubts;
}

BandProver::Place BandProver::place(std::size_t edge, double t) const {
  const Eigen::VectorXd& from = segment_.positions[edge];
  const Eigen::VectorXd q = from + t * (segment_.positions[edge + 1] - from);
  const robot::Robot& robot = examination_.problem_.robot;
  if (!grasps_) return {examination_.finger(q), Eigen::Isometry3d::Identity()};
  return {{}, examination_.plan_.X_WH_grasp.inverse() * robot.pose(hand_, q)};
}

scene::Slack BandProver::slack(const Place& from, const Place& to, double width) {
  scene::Slack slack;
  if (grasps_) {
    add_straight(from, to, width, slack);
    return slack;
  }
  const FingerSpan span =
      finger_span(examination_.problem_.hand, from.finger, to.finger, finger_rates_, width);
  slack.add(examination_.depths_.max + kHeightTolerance + kRound - span.max_depth,
            "depth of the fingertip out of its band");
  if (slides_) {
    add_slide(span, from.finger, to.finger, slack);
  } else if (span.max_depth > touching_) {
    if (must_stay_) add_still(span, from.finger, to.finger, slack);
    if (retreats_) return slack;
    add_touch(span, slack);
    add_inside(span, from.finger, to.finger, kStray, slack);
  }
  return slack;
}

void BandProver::add_slide(const FingerSpan& span, const ReplayedFinger& from,
                           const ReplayedFinger& to, scene::Slack& slack) {
  slack.add(span.min_depth - examination_.depths_.min + kHeightTolerance + kRound,
            "depth of the fingertip out of its band");
  add_touch(span, slack);
  add_inside(span, from, to, kRound, slack);
}

/// Conditions of check_touching_row() but those of the support.
void BandProver::add_touch(const FingerSpan& span, scene::Slack& slack) const {
  const Options& options = examination_.options_;
  const Hand& hand = examination_.problem_.hand;
  const double aside = std::max(span.max_pitch - options.pitch, options.pitch - span.min_pitch);
  slack.add(options.pitch_tolerance + kRound - aside, "pitch of the finger out of its band", "rad");
  slack.add(kRollTolerance + kRound - span.max_roll, "roll of the finger out of its band", "rad");
  const bool yields =
      hand.finger_model == FingerModel::flexure || hand.finger_model == FingerModel::impedance;
  const double sink =
      examination_.profile_.below(span.min_bent, span.max_bent) + (yields ? 0 : span.max_depth);
  slack.add(allowed_sink(hand) + kHeightTolerance - sink, "finger below the object's top face");
  slack.add(span.min_other_finger_up - std::numeric_limits<double>::min(),
            "other finger pointing down", "rad");
}

/// The contact must stay where it is pressed; both distances are convex along a straight line.
void BandProver::add_still(const FingerSpan& span, const ReplayedFinger& from,
                           const ReplayedFinger& to, scene::Slack& slack) const {
  const double moved = std::max((from.effective - pressed_.effective).norm(),
                                (to.effective - pressed_.effective).norm());
  slack.add(kStray - moved - span.effective_off, "movement of the contact out of its band");
  const double turned =
      std::max((from.heading - pressed_.heading).norm(), (to.heading - pressed_.heading).norm());
  slack.add(kStrayTurn - turned - span.heading_off, "turn of the contact out of its band", "rad");
}

void BandProver::add_inside(const FingerSpan& span, const ReplayedFinger& from,
                            const ReplayedFinger& to, double play, scene::Slack& slack) {
  const double margin = examination_.options_.tip_margin;
  slack.add(inside(from.commanded, to.commanded, span.commanded_off, -play, commanded_) + play,
            "fingertip off the support");
  slack.add(inside(from.effective, to.effective, span.effective_off, margin - play, effective_) -
                margin + play,
            "contact too near the support's edge");
}

/// Lower bound on the depth in the support of points within `off` of a straight line. At least
/// `enough` is enough.
double BandProver::inside(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double off,
                          double enough, Anchor& anchor) const {
  if (anchor.is_set) {
    const double known =
        anchor.depth - std::max((from - anchor.p).norm(), (to - anchor.p).norm()) - off;
    if (known >= enough) return known;
  }
  const Eigen::Matrix2Xd& Q = examination_.problem_.support.polygon().vertices();
  const double first = signed_depth(Q, from);
  const double last = from == to ? first : signed_depth(Q, to);
  anchor = {to, last, true};
  // The depth in a convex polygon is a concave function; in any other it grows by at most 1 per
  // metre.
  const double least =
      is_support_convex_ ? std::min(first, last) : (first + last - (to - from).norm()) / 2;
  return least - off;
}

void BandProver::add_straight(const Place& from, const Place& to, double width,
                              scene::Slack& slack) const {
  const double aside =
      std::max(from.X_GH.translation().head<2>().norm(), to.X_GH.translation().head<2>().norm());
  slack.add(kSideways - aside - hand_rates_.curvature * width * width / 8,
            "hand off its straight approach");
  const double turned = (angle_of(from.X_GH) + angle_of(to.X_GH) + hand_rates_.turn * width) / 2;
  slack.add(kTurned - turned, "turn of the hand off its straight approach", "rad");
}

}  // namespace graspless::slide
