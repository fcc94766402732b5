// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "graspless/geometry/pose.hpp"
#include "graspless/slide/resume.hpp"
#include "graspless/watch.hpp"

#include "geometry/segment.hpp"
#include "slide/check/examination.hpp"
#include "slide/check/replay.hpp"
#include "slide/friction/warnings.hpp"
#include "text.hpp"

namespace graspless::slide {

double signed_depth(const Eigen::Matrix2Xd& polygon, const Eigen::Vector2d& p) {
  const Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  double turned = 0, nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < polygon.cols(); ++i) {
    const Eigen::Vector2d a = polygon.col(i) - p, b = polygon.col((i + 1) % polygon.cols()) - p;
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    nearest = std::min(nearest, geometry::distance_to_segment(origin, a, b));
  }
  return std::abs(turned) > M_PI ? nearest : -nearest;
}

Faults Examination::run() {
  if (!has_shape()) return faults_;
  check_rows();
  check_object_poses();
  check_hand_open();
  for (const Segment& segment : plan_.segments) check_collisions(segment);
  if (has("retreat")) check_retreat(segment("retreat"));
  if (has("press")) check_pressing(segment("press"));
  check_pressing(segment("lift"));
  check_clearance();
  check_slide();
  if (problem_.X_WO_end) {
    check_end();
  } else {
    check_pair();
    check_grasp();
    check_closing();
  }
  check_tube();
  check_warnings();
  return faults_;
}

/// Names of the segments that the plan must have, in order.
std::vector<std::string> Examination::names() const {
  constexpr std::ptrdiff_t kApproach = 1, kSlide = 3, kReach = 5;
  const std::vector<std::string>& all = segment_names();
  const auto end = problem_.X_WO_end ? all.begin() + kReach : all.end();
  const std::ptrdiff_t first = !plan_.resumed ? kApproach : has("retreat") ? 0 : kSlide;
  return {all.begin() + first, end};
}

bool Examination::has(const std::string& name) const {
  return std::any_of(plan_.segments.begin(), plan_.segments.end(),
                     [&](const Segment& segment) { return segment.name == name; });
}

const Segment& Examination::segment(const std::string& name) const {
  return *std::find_if(plan_.segments.begin(), plan_.segments.end(),
                       [&](const Segment& segment) { return segment.name == name; });
}

bool Examination::has_shape() {
  if (!plan_) {
    fault("plan", "not solved: " + plan_.reason);
    return false;
  }
  scene::check_shape(
      problem_.robot, plan_, names(),
      [&](const std::string& place, const std::string& what) { fault(place, what); });
  if (!geometry::is_pose(plan_.X_WO_goal) || !geometry::is_pose(plan_.X_WH_grasp)) {
    fault("plan", "X_WO_goal or X_WH_grasp is no pose within 1e4 m");
  }
  if (plan_.resumed && !(robot::is_configuration(problem_.robot, plan_.resumed->q) &&
                         geometry::is_pose(plan_.resumed->X_WO))) {
    fault("resumed", "q has the wrong size or a value that is not finite, or X_WO is no pose");
  }
  return faults_.empty();
}

void Examination::check_rows() {
  Eigen::VectorXd before = plan_.segments[0].positions[0];
  if (plan_.resumed) {
    const double step = problem_.robot.step(plan_.resumed->q, before);
    if (!(step <= scene::kLongestStep)) {
      fault(plan_.segments[0], 0,
            "is " + figure(step) + " rad from where the slide was interrupted");
    }
  } else if ((before - problem_.q_home).lpNorm<Eigen::Infinity>() > kSame) {
    fault("approach row 0", "is not the home configuration q_home");
  }
  for (const Segment& s : plan_.segments) {
    scene::check_rows(problem_.robot, before, kSame, s.positions,
                      [&](std::size_t row, const std::string& what) { fault(s, row, what); });
    before = s.positions.back();
  }
}

/// The object's pose at the start: X_WO_start, laid flat on the support. In a plan that was
/// resumed: where it was measured, and has followed the finger to the first row of the slide.
Eigen::Isometry3d Examination::object_start() const {
  if (has("retreat")) return flat_where_interrupted();
  if (plan_.resumed) {
    return followed(flat_where_interrupted(), finger(plan_.resumed->q),
                    finger(plan_.segments[0].positions[0]));
  }
  const Eigen::Isometry3d X_SO = X_SW_ * problem_.X_WO_start;
  const double yaw = std::atan2(X_SO.linear()(1, 0), X_SO.linear()(0, 0));
  const Eigen::Vector3d p_SO(X_SO.translation().x(), X_SO.translation().y(), 0);
  return problem_.support.X_WS() * Eigen::Translation3d(p_SO) *
         Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ());
}

/// The measured pose, laid flat on the support: centre of mass and yaw stay.
Eigen::Isometry3d Examination::flat_where_interrupted() const {
  const Eigen::Isometry3d X_SO = X_SW_ * plan_.resumed->X_WO;
  const Eigen::Vector3d com_O = problem_.object.com();
  const Eigen::Vector3d com_S = X_SO * com_O;
  const Eigen::Vector3d ahead = X_SO.linear().col(0);
  return problem_.support.X_WS() * Eigen::Translation3d(com_S.x(), com_S.y(), 0) *
         Eigen::AngleAxisd(std::atan2(ahead.y(), ahead.x()), Eigen::Vector3d::UnitZ()) *
         Eigen::Translation3d(-com_O.x(), -com_O.y(), 0);
}

void Examination::check_lies_flat() {
  const Eigen::Vector3d n = problem_.support.normal_W();
  const Eigen::Isometry3d& X_WO = plan_.resumed->X_WO;
  const Eigen::Vector3d off =
      X_WO * problem_.object.com() - flat_where_interrupted() * problem_.object.com();
  const double upright = X_WO.linear().col(2).dot(n);
  if (!(off.norm() <= kFlatHeight + kSame) || !(upright >= std::cos(kFlatTilt) - kSame)) {
    fault("resumed", "the object does not lie flat on the support");
  }
}

void Examination::check_object_poses() {
  const Eigen::Isometry3d& X_WO_slid = segment("slide").object_poses.back();
  if (!scene::is_same(plan_.segments[0].object_poses[0], object_start(), kSame)) {
    fault(plan_.segments[0], 0, "the object is not at its start");
  }
  if (plan_.resumed) check_lies_flat();
  if (!scene::is_same(plan_.X_WO_goal, X_WO_slid, kSame))
    fault("plan", "X_WO_goal is not where the slide ends");
  for (const Segment& s : plan_.segments) {
    if (s.name == "slide") continue;
    const bool before = s.name == "retreat" || s.name == "approach" || s.name == "press";
    const Eigen::Isometry3d& still = before ? plan_.segments[0].object_poses[0] : X_WO_slid;
    for (std::size_t i = 0; i < s.object_poses.size(); ++i) {
      if (!scene::is_same(s.object_poses[i], still, kSame))
        fault(s, i, "the object moves though nothing slides it");
    }
  }
}

/// The hand must stay open in every segment but approach and close.
void Examination::check_hand_open() {
  const Eigen::VectorXd open = problem_.robot.state(problem_.hand.open, problem_.q_home);
  const std::vector<int>& arm = problem_.robot.group(problem_.hand.arm);
  for (const Segment& s : plan_.segments) {
    if (s.name == "approach" || s.name == "close") continue;
    for (std::size_t i = 0; i < s.positions.size(); ++i) {
      poll();
      Eigen::VectorXd off = s.positions[i] - open;
      for (int joint : arm) off[joint] = 0;
      if (off.lpNorm<Eigen::Infinity>() > kSame) fault(s, i, "the hand is not open");
    }
  }
}

void Examination::check_collisions(const Segment& segment) {
  Replay world = strict_.with(contacts_of(segment.name));
  const bool slides = segment.name == "slide";
  const Finger start = finger(segment.positions[0]);
  std::size_t faulty_row = segment.positions.size();  // one fault per row is enough
  scene::replay_rows(
      problem_.robot, segment.positions, [&](std::size_t row, const Eigen::VectorXd& q) {
        const Eigen::Isometry3d X_WO = slides ? followed(segment.object_poses[0], start, finger(q))
                                              : segment.object_poses[row];
        const auto touching = world.touching(q, X_WO);
        if (touching.empty() || row == faulty_row) return;
        faulty_row = row;
        fault(segment, row, "collision " + touching.front());
      });
}

/// The plan must carry every kind of warning that this problem calls for; friction or mass may have
/// been edited.
void Examination::check_warnings() {
  constexpr double kClearly = 1.01;
  const auto has = [&](const Warning& warning) {
    return std::any_of(plan_.warnings.begin(), plan_.warnings.end(),
                       [&](const std::string& text) { return text.rfind(warning.risk, 0) == 0; });
  };
  const std::optional<Bearing> held = bearing(problem_, plan_);
  if (plan_.max_mass &&
      !(held && *plan_.max_mass > 0 && *plan_.max_mass <= kClearly * held->max_mass)) {
    fault("plan", "max_mass must be above 0 and at most what the fingers bear, which is " +
                      (held ? figure(held->max_mass) + " kg" : "unknown"));
  }
  for (const Warning& warning : warnings(problem_, pressed_rows(problem_, plan_), held, kClearly)) {
    if (!has(warning)) fault("warnings", "the plan lacks this one: " + warning.text());
  }
}

std::vector<std::string> check(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem, options);
  return Examination(problem, plan, options).run();
}

}  // namespace graspless::slide
