// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Part of check(): where friction may leave the object.
#include <algorithm>

#include "slide/check/examination.hpp"
#include "slide/friction/course.hpp"
#include "text.hpp"

namespace graspless::slide {
namespace {

// Rounding of a plan file, which the integration amplifies [m, rad], and as a fraction.
constexpr double kRounded = 1e-4, kRelative = 0.01;

/// Row whose claimed bound is farthest below the true one; the number of rows if all are wide
/// enough.
std::size_t narrowest(const std::vector<double>& claimed, const std::vector<double>& needed) {
  std::size_t found = needed.size();
  double worst = 0;
  for (std::size_t row = 0; row < needed.size(); ++row) {
    const double lacks = (1 - kRelative) * needed[row] - kRounded - claimed[row];
    if (lacks <= worst) continue;  // infinite bounds lack nothing
    worst = lacks;
    found = row;
  }
  return found;
}

}  // namespace

/// The plan's tube must not be narrower than the one that follows from its rows. A plan without
/// values claims nothing.
void Examination::check_tube() {
  const Segment& slide = segment("slide");
  const std::vector<PressedRow> rows = pressed_rows(problem_, slide);
  const Course found = course(problem_, options_, rows);
  const bool is_resumed = plan_.resumed && !has("retreat");
  if (options_.refuse_lag && !is_resumed) {
    check_ends(found.ends);
    check_drag(rows);
  }
  const Tube& claimed = plan_.tube;
  if (claimed.position.empty() && claimed.angle.empty()) return;
  const auto is_bound = [](double value) { return value >= 0; };
  for (const std::vector<double>* values : {&claimed.position, &claimed.angle}) {
    if (values->size() != slide.positions.size() ||
        !std::all_of(values->begin(), values->end(), is_bound)) {
      fault("tube", "must have a bound of at least 0 for each row of the slide");
      return;
    }
  }
  const std::size_t moved = narrowest(claimed.position, found.tube.position);
  if (moved < slide.positions.size()) {
    fault("tube row " + std::to_string(moved),
          "the object may be " + figure(found.tube.position[moved]) + " m off, not " +
              figure(claimed.position[moved]) + " m at most");
  }
  const std::size_t turned = narrowest(claimed.angle, found.tube.angle);
  if (turned < slide.positions.size()) {
    fault("tube row " + std::to_string(turned),
          "the object may be " + figure(found.tube.angle[turned]) + " rad off, not " +
              figure(claimed.angle[turned]) + " rad at most");
  }
}

/// The support's drag and the finger's are a couple, with the top's height as its arm: it moves the
/// centre of pressure of a high object, but not off object or support.
void Examination::check_drag(const std::vector<PressedRow>& rows) {
  const Object& object = problem_.object;
  if (object.thickness() <= object.least_width() / 2) return;
  const double arm = object.top() * problem_.support.friction() * (1 + options_.friction_spread);
  for (std::size_t row = 1; row < rows.size(); ++row) {
    const Planar X_OO = rows[row].X_SO * rows[row - 1].X_SO.inverse();
    const Eigen::Vector2d center = pressure_center(problem_, rows[row - 1]);
    const Eigen::Vector2d way = X_OO * center - center;
    if (way.norm() < 1e-6) continue;
    const Eigen::Vector2d pressed = center + way * (arm / way.norm());
    const Eigen::Vector2d pressed_O = rows[row - 1].X_SO.inverse() * pressed;
    if (!(signed_depth(object.outline().vertices(), pressed_O) >= -kRounded) ||
        !(signed_depth(problem_.support.polygon().vertices(), pressed) >= -kRounded)) {
      fault("slide row " + std::to_string(row - 1), "drag may tip the object");
      return;
    }
  }
}

/// Wherever friction leaves the object, the support must hold it, and the hand must reach it if it
/// grasps it there.
void Examination::check_ends(const std::vector<Planar>& ends) {
  const bool is_grasped = !problem_.X_WO_end;
  const Protrusion planned = is_grasped ? protrusion() : Protrusion{};
  if (is_grasped && !planned.any) return;  // check_pair() finds that
  const Eigen::Matrix3d R_WS = problem_.support.X_WS().linear();
  const Eigen::Vector3d down_S = -R_WS.transpose().col(2);
  const Eigen::Vector3d planned_O = (X_SW_ * plan_.X_WO_goal).inverse() *
                                    Eigen::Vector3d(planned.center.x(), planned.center.y(), 0);
  const double planned_depth =
      signed_depth(problem_.object.outline().vertices(), planned_O.head<2>());
  const double least = std::min(0.0, planned_depth - kGraspGive);
  for (const Planar& X_SO : ends) {
    const Eigen::Vector3d& com_O = problem_.object.com();
    const Eigen::Vector2d foot =
        X_SO * Eigen::Vector2d(com_O.head<2>()) + down_S.head<2>() * (com_O.z() / -down_S.z());
    if (!(signed_depth(problem_.support.polygon().vertices(), foot) >= -kRounded)) {
      fault("tube", "friction may leave the centre of mass off the support");
    } else if (problem_.object.is_hollow() && !(held_by_rim(X_SO, foot) >= -kRimSpacing)) {
      fault("tube", "friction may leave the object tipping on its rim");
    }
    const Eigen::Vector2d grasp_O = X_SO.inverse() * planned.center;
    if (is_grasped &&
        !(signed_depth(problem_.object.outline().vertices(), grasp_O) >= least - kRounded)) {
      fault("tube", "friction may leave the object out of the hand");
    }
    const Planar off = planar(X_SW_ * plan_.X_WO_goal).inverse() * X_SO;
    const double turn = std::abs(std::atan2(off.linear()(1, 0), off.linear()(0, 0)));
    if (!(turn <= (1 + kRelative) * kMostLag.angle + kRounded))
      fault("tube", "friction may leave the object turned by " + figure(turn) + " rad");
    const Eigen::Vector2d com_xy = com_O.head<2>();
    const double distance = (off * com_xy - com_xy).norm();
    if (!(distance <= (1 + kRelative) * kMostLag.position + kRounded))
      fault("tube", "friction may leave the object " + figure(distance) + " m off");
  }
}

}  // namespace graspless::slide
