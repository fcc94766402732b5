// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"
#include "graspless/slide/resume.hpp"

#include "planning/obstruction.hpp"
#include "slide/refusals.hpp"
#include "text.hpp"

namespace graspless::slide {
namespace {

using Eigen::VectorXd;

/// Why the object does not lie flat on the support; empty if it does.
std::string why_not_flat(const Problem& problem, const Eigen::Isometry3d& X_SO) {
  const Eigen::Vector3d com_O = problem.object.com();
  const double height = (X_SO * com_O).z() - com_O.z();
  const double tilt = std::acos(std::clamp(X_SO.linear()(2, 2), -1.0, 1.0));
  if (std::abs(height) > kFlatHeight) {
    return "the object is " + in_mm(std::abs(height)) + (height > 0 ? " above" : " below") +
           " the support, measured at its centre of mass; at most " + in_mm(kFlatHeight) +
           " is allowed";
  }
  if (tilt > kFlatTilt) {
    return "the object is tilted by " + figure(tilt / kDegree, 3) +
           " degrees against the support; at most " + figure(kFlatTilt / kDegree, 3) +
           " degrees are allowed";
  }
  return "";
}

/// Lays the object flat, with its yaw and its centre of mass in the plane as measured.
Planar laid_flat(const Object& object, const Eigen::Isometry3d& X_SO) {
  Planar flat = planar(X_SO);
  flat.translation() = (X_SO * object.com()).head<2>() - flat.linear() * object.com().head<2>();
  return flat;
}

/// Why the fingertip does not press at p_OC, a position on the object; empty if it does.
std::string why_off_object(const Query& query, const Eigen::Vector2d& p_OC) {
  const Object& object = query.problem.object;
  constexpr double kAtRim = 0.001;    // check()'s tolerance: contacts lie at the margin, too [m]
  constexpr double kSpacings = 1.25;  // from a position on the object to the nearest of its points
  const double inside = object.outline().depth(p_OC);
  if (inside < 0) return "the fingertip presses " + in_mm(-inside) + " beside the object";
  const double nearest = (object.points().colwise() - p_OC).colwise().norm().minCoeff();
  if (nearest > kSpacings * object.spacing()) {
    return "the fingertip presses into a hole of the object, " + in_mm(nearest) +
           " from its nearest point";
  }
  if (!can_press_at(query.problem, query.options, p_OC))
    return "the fingertip presses where the object is not level";
  const double margin = rim_margin(object, query.options);
  if (inside >= margin - kAtRim) return "";
  return "the fingertip presses only " + in_mm(inside) +
         " inside the object's outline; options.rim_margin asks for " + in_mm(margin);
}

/// Why q is too far from a configuration to be taken there; empty if it is near.
std::string why_far(const Query& query, const VectorXd& q, const VectorXd& corrected) {
  const robot::Robot& robot = query.problem.robot;
  const double step = robot.step(q, corrected);
  if (step <= kMaxCorrection) return "";
  Eigen::Index joint = 0;
  (corrected - q).cwiseProduct(robot.step_weights()).cwiseAbs().maxCoeff(&joint);
  return "q is " + figure(step, 3) + " rad from the nearest configuration to begin at (joint '" +
         robot.joint_names()[joint] + "'); at most " + figure(kMaxCorrection, 3) +
         " rad is allowed";
}

Tip tip_at(const Query& query, const VectorXd& q) {
  const robot::Robot& robot = query.problem.robot;
  return tip(query.X_WS.inverse() * robot.pose(robot.frame(query.problem.hand.fingertip), q));
}

/// Returns the arm's joints of q within their limits, which measured joints may exceed.
VectorXd within_limits(const Query& query, const VectorXd& q) {
  return query.arm.part(q).cwiseMax(query.arm.lower()).cwiseMin(query.arm.upper());
}

std::nullopt_t refuse(Plan& plan, Status status, const std::string& why) {
  plan.status = status;
  plan.reason = why;
  return std::nullopt;
}

/// Refuses a start for which contact.is_valid() has just returned false.
std::nullopt_t refuse_invalid(Query& query, const VectorXd& start, Plan& plan) {
  if (const auto& touching = query.contact.touching()) {
    const collision::World& world = query.contact.scene().world();
    return refuse(plan, Status::start_in_collision,
                  "where the slide is to go on, " +
                      planning::contact(world.name(touching->first), world.name(touching->second)));
  }
  const Tip tip = query.contact.tip_at(start);
  const geometry::Polygon& polygon = query.problem.support.polygon();
  const double inside = polygon.depth(query.contact.effective(tip).translation());
  if (inside < query.options.tip_margin) {
    return refuse(plan, Status::contact_lost,
                  "the fingertip presses " + beside_edge(inside) +
                      " of the support; options.tip_margin asks for " +
                      in_mm(query.options.tip_margin) + " inside");
  }
  if (const double commanded = polygon.depth(tip.position); commanded < 0) {
    return refuse(plan, Status::contact_lost,
                  "the fingertip, if it did not yield, would be " + beside_edge(commanded) +
                      " of the support");
  }
  return refuse(plan, Status::contact_lost, "the hand is not in the attitude in which it presses");
}

/// Lets the motion begin at q, where links may be nearer to each other than plans let them come.
void admit_links(Query& query, const VectorXd& q) {
  for (scene::Scene* scene : {&query.contact.scene(), &query.free})
    keep_links_apart(*scene, query.problem, {q});
}

}  // namespace

void validate(const Problem& problem, const Interruption& at) {
  const auto dof = problem.robot.dof();
  if (at.q.size() != dof || !at.q.allFinite()) {
    throw std::invalid_argument(
        "q must have " + std::to_string(dof) + " finite values, not " +
        (at.q.size() != dof ? std::to_string(at.q.size()) : "some that are not finite"));
  }
  geometry::require_pose(at.X_WO, "X_WO");
  if (at.X_WO_goal) geometry::require_pose(*at.X_WO_goal, "X_WO_goal");
}

std::optional<VectorXd> find_pressed_start(Query& query, const Interruption& at, Plan& plan) {
  const Eigen::Isometry3d X_SO = query.X_WS.inverse() * at.X_WO;
  const std::string off = why_not_flat(query.problem, X_SO);
  if (!off.empty()) return refuse(plan, Status::off_support, off);
  const Tip given = tip_at(query, at.q);
  if (given.height - query.top > kTouchHeight) {
    return refuse(
        plan, Status::contact_lost,
        "the fingertip is " + in_mm(given.height - query.top) + " above the object's top face");
  }
  VectorXd start = within_limits(query, at.q);
  const bool presses = query.contact.is_pressing(start) || query.contact.project(start);
  const std::string far = why_far(query, at.q, query.arm.full(start));
  if (!presses || !far.empty()) {
    return refuse(plan, Status::contact_lost,
                  presses ? far : "no configuration near q presses on the object");
  }
  const ContactSpace::Carried moved{
      effective_tip(query.problem.hand, given, query.top, query.options.pitch),
      laid_flat(query.problem.object, X_SO)};
  query.object_start = query.contact.carry(moved, start);
  const ContactSpace::Carried carried = query.carried_from(start);
  const Eigen::Vector2d p_OC = query.object_start.inverse() * carried.tip_start.translation();
  const std::string beside = why_off_object(query, p_OC);
  if (!beside.empty()) return refuse(plan, Status::contact_lost, beside);
  admit_links(query, query.arm.full(start));
  if (!query.contact.is_valid(start, carried)) return refuse_invalid(query, start, plan);
  return start;
}

std::optional<Retreat> find_retreat(Query& query, const Interruption& at, Plan& plan) {
  const Object& object = query.problem.object;
  const Eigen::Isometry3d X_SO = query.X_WS.inverse() * at.X_WO;
  const std::string off = why_not_flat(query.problem, X_SO);
  if (!off.empty()) return refuse(plan, Status::off_support, off);
  query.object_start = laid_flat(object, X_SO);
  if (!is_supported(query.problem, query.object_start, 0)) {
    const bool tips = is_com_inside(query.problem, query.object_start, 0);
    return refuse(plan, Status::off_support,
                  std::string("the centre of mass is beyond ") +
                      (tips ? "the part of the rim that is on the support" : "the support's edge") +
                      ": the object falls when the finger leaves it");
  }
  VectorXd start = within_limits(query, at.q);
  if (!query.contact.is_pressing(start)) {
    VectorXd pressed = start;
    const bool is_near =
        query.contact.project(pressed) && why_far(query, at.q, query.arm.full(pressed)).empty();
    if (is_near) start = pressed;
  }
  const std::string far = why_far(query, at.q, query.arm.full(start));
  if (!far.empty()) return refuse(plan, Status::contact_lost, "the hand is not open: " + far);
  const double depth = query.top - query.contact.tip_at(start).height;
  const double deepest = depth_band(query.problem.hand, query.options).max;
  if (depth > deepest + kHeightTolerance) {
    return refuse(plan, Status::contact_lost,
                  "the fingertip is " + in_mm(depth) + " below the object's top face; at most " +
                      in_mm(deepest) + " is allowed");
  }
  const Eigen::Vector2d p_OC =
      query.object_start.inverse() * query.contact.effective_tip_at(start).translation();
  const bool presses = depth > 0 && object.outline().depth(p_OC) >= 0;
  admit_links(query, query.arm.full(start));
  Motions motions(query);
  const auto path = presses ? motions.lift_from(start, query.object_start)
                            : motions.rise_from(start, query.object_start);
  if (path) return Retreat{*path, query.object_start};
  return refuse(plan, Status::start_in_collision,
                "the finger cannot be lifted off: the arm collides or does not reach");
}

}  // namespace graspless::slide
