// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// check() of a realization: the shape of it, joints, and what each stretch has to be.
#include <algorithm>
#include <cmath>

#include "graspless/geometry/pose.hpp"

#include "realize/examination.hpp"
#include "realize/validate.hpp"
#include "scene/rows.hpp"
#include "text.hpp"

namespace graspless::realize {
namespace {

constexpr double kSame = 1e-9;  // of joints between segments [rad]

}  // namespace

Examination::Examination(const Problem& problem, const Plan& plan, const robot::Robot& robot,
                         const Carrier& carrier, const Realization& realization,
                         const RealizeOptions& options)
    : problem_(problem),
      plan_(plan),
      robot_(robot),
      carrier_(carrier),
      realization_(realization),
      options_(options),
      replay_(problem, robot) {}

std::vector<std::string> Examination::run() {
  expect_phases();
  if (!has_shape() || !assigns_fingertips()) return faults_;
  check_joints();
  for (segment_ = 0; segment_ < phases_.size(); ++segment_) {
    const JointSegment& segment = realization_.segments[segment_];
    const Phase& phase = phases_[segment_];
    check_object(segment, phase);
    check_ends(segment, phase);
    check_scrub(segment, phase);
    check_segment(segment, phase);
  }
  return faults_;
}

/// Lists the expected phases: from home onto the object, the plan's segments (a regrasp is three),
/// off the object and home.
void Examination::expect_phases() {
  const std::size_t count = plan_.segments.front().rows.front().fingers.size();
  const std::vector<bool> none(count, false), all(count, true);
  std::vector<FingerState> places = plan_.segments.front().rows.front().fingers;
  Eigen::Isometry3d X_WO = plan_.segments.front().X_WO.front();
  phases_.push_back({"approach", -1, {X_WO}, places, none, none});
  phases_.push_back({"touch", -1, {X_WO}, places, none, all});
  for (std::size_t k = 0; k < plan_.segments.size(); ++k) {
    const Segment& segment = plan_.segments[k];
    const int index = static_cast<int>(k);
    X_WO = segment.X_WO.back();
    if (segment.finger < 0) {
      phases_.push_back({segment.name, index, segment.X_WO, places, all, none});
      continue;
    }
    const auto finger = static_cast<std::size_t>(segment.finger);
    std::vector<bool> moves = none, holds = all;
    moves[finger] = true;
    holds[finger] = false;
    phases_.push_back({"release", index, {X_WO}, places, holds, moves});
    places[finger] = plan_.segments[k + 1].rows.front().fingers[finger];
    phases_.push_back({"reach", index, {X_WO}, places, holds, none});
    phases_.push_back({"touch", index, {X_WO}, places, holds, moves});
  }
  phases_.push_back({"release", -1, {X_WO}, places, none, all});
  phases_.push_back({"retreat", -1, {X_WO}, places, none, none});
}

bool Examination::has_shape() {
  if (!realization_) {
    fault("realization: not found: " + realization_.reason);
    return false;
  }
  const std::string wrong = scene::wrong_names(robot_, realization_.joint_names);
  if (!wrong.empty()) fault("realization: " + wrong);
  std::string expected, found;
  for (const Phase& phase : phases_)
    expected += phase.name + " (" + std::to_string(phase.plan_segment) + ") ";
  for (const JointSegment& segment : realization_.segments)
    found += segment.name + " (" + std::to_string(segment.plan_segment) + ") ";
  if (found != expected) fault("realization: segments are " + found + "instead of " + expected);
  for (segment_ = 0; segment_ < realization_.segments.size(); ++segment_)
    has_sound_rows(realization_.segments[segment_]);
  return faults_.empty();
}

bool Examination::has_sound_rows(const JointSegment& segment) {
  if (segment.positions.empty() || segment.positions.size() != segment.X_WO.size()) {
    fault(0, "needs rows, and one object pose for each");
    return false;
  }
  for (std::size_t i = 0; i < segment.positions.size(); ++i) {
    const Eigen::VectorXd& q = segment.positions[i];
    if (robot::is_configuration(robot_, q) && geometry::is_pose(segment.X_WO[i])) continue;
    fault(i, "has the wrong size or a value that is not finite");
    return false;
  }
  return true;
}

bool Examination::assigns_fingertips() {
  const std::size_t count = carrier_.fingertips.size();
  frame_of_finger_.assign(count, -1);
  links_of_finger_.resize(count);
  for (std::size_t tip = 0; tip < std::min(count, realization_.finger_of_fingertip.size()); ++tip) {
    const auto finger = static_cast<std::size_t>(realization_.finger_of_fingertip[tip]);
    if (finger >= count) break;
    frame_of_finger_[finger] = robot_.frame(carrier_.fingertips[tip]);
    links_of_finger_[finger] = carrier_.links[tip];
  }
  const bool is_complete =
      realization_.finger_of_fingertip.size() == count &&
      std::find(frame_of_finger_.begin(), frame_of_finger_.end(), -1) == frame_of_finger_.end();
  if (!is_complete)
    fault("realization: finger_of_fingertip does not give each fingertip a finger of its own");
  return is_complete;
}

void Examination::check_joints() {
  Eigen::VectorXd before = realization_.segments.front().positions.front();
  for (segment_ = 0; segment_ < realization_.segments.size(); ++segment_) {
    const auto& rows = realization_.segments[segment_].positions;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double step = (rows[i] - before).lpNorm<Eigen::Infinity>();
      if (i == 0 && step > kSame) fault(i, "does not continue the segment before it");
      if (step > options_.max_jump + kSame)
        fault(i, "a joint moves by " + figure(step) + " between rows");
      if (!robot_.is_within(rows[i], 1e-6)) fault(i, "leaves the joint limits");
      before = rows[i];
    }
  }
  const double away =
      (before - realization_.segments.front().positions.front()).lpNorm<Eigen::Infinity>();
  if (away > kSame) fault("retreat: does not end where the approach began");
}

void Examination::fault(std::size_t row, const std::string& what) {
  faults_.push_back(segment_name() + ", row " + std::to_string(row) + ": " + what);
}

std::string Examination::segment_name() const {
  return "joint segment " + std::to_string(segment_) + " (" + realization_.segments[segment_].name +
         ")";
}

}  // namespace graspless::realize

namespace graspless::fingertip {

std::vector<std::string> check(const Problem& problem, const Plan& plan, const robot::Robot& robot,
                               const Carrier& carrier, const Realization& realization,
                               const RealizeOptions& options) {
  realize::validate_realization(problem, plan, robot, carrier, options);
  return realize::Examination(problem, plan, robot, carrier, realization, options).run();
}

}  // namespace graspless::fingertip
