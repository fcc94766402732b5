// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graspless/watch.hpp"

#include "clasp/check/checker.hpp"
#include "scene/edges.hpp"
#include "scene/rows.hpp"

namespace graspless::clasp {
namespace {

/// Joints of the hand with their closing directions: 1 or -1, or 0 for a joint that does not move.
std::vector<std::pair<int, double>> closing_joints(const Problem& problem) {
  const robot::Robot& robot = problem.robot;
  const Eigen::VectorXd travel = robot.state(problem.hand.closed) - robot.state(problem.hand.open);
  std::vector<std::pair<int, double>> joints;
  for (const int joint : robot.group(problem.hand.hand)) {
    joints.emplace_back(joint, travel[joint] > 0 ? 1.0 : travel[joint] < 0 ? -1.0 : 0.0);
  }
  return joints;
}

}  // namespace

PlanChecker::PlanChecker(const Problem& problem, const Plan& plan, const Options& options)
    : grip_(problem, options, plan.fingers, plan.pre_shape),
      problem_(grip_.problem),
      plan_(plan),
      options_(grip_.options),
      replay_(problem.robot) {
  replay_.world().set_pose(replay_.add("object", problem.object.solid(), false), problem.X_WO);
  for (const Obstacle& obstacle : problem.obstacles) replay_.add(obstacle);
}

Faults PlanChecker::run() {
  if (!is_complete()) return faults_;
  check_rows();
  check_target();
  for (const Segment& segment : plan_.segments) {
    check_collisions(segment);
    check_linking(segment);
  }
  check_threshold();
  check_hand_closes();
  check_closed_until_contact();
  check_stability();
  check_certificate();
  return faults_;
}

const Eigen::Matrix3Xd& PlanChecker::loop_points() const {
  return problem_.object.loops().found[plan_.loop].points;
}

bool PlanChecker::is_complete() {
  if (!plan_) {
    fault("plan", "not solved: ", plan_.reason);
    return false;
  }
  const std::string wrong = scene::wrong_names(problem_.robot, plan_.joint_names);
  if (!wrong.empty()) fault("plan", wrong);
  if (plan_.segments.size() != 2 || reach().name != "reach" || close().name != "close") {
    fault("plan", "segments are not reach, close");
    return false;
  }
  if (!plan_.fingers.empty() && problem_.hand.fingers.size() != plan_.fingers.size()) {
    fault("plan", "its fingers are not fingers of the hand");
    return false;
  }
  if (!plan_.pre_shape.empty() && plan_.pre_shape != problem_.hand.open)
    fault("plan", "its pre-shape '", plan_.pre_shape, "' is none of the hand's");
  const auto& loops = problem_.object.loops().found;
  if (plan_.loop < 0 || plan_.loop >= static_cast<int>(loops.size()))
    fault("plan", "loop ", plan_.loop, " is not one of the object's ", loops.size());
  return has_sound_rows(reach()) && has_sound_rows(close()) && faults_.empty();
}

bool PlanChecker::has_sound_rows(const Segment& segment) {
  const auto rows = static_cast<Eigen::Index>(segment.positions.size());
  const auto curves = static_cast<Eigen::Index>(problem_.hand.fingers.size());
  if (rows == 0 || segment.virtual_linking.rows() != curves ||
      segment.virtual_linking.cols() != rows || !segment.virtual_linking.allFinite()) {
    fault(segment.name, "needs rows, and for each the virtual linking of ", curves, " curves");
    return false;
  }
  for (std::size_t row = 0; row < segment.positions.size(); ++row) {
    poll();
    const Eigen::VectorXd& q = segment.positions[row];
    if (robot::is_configuration(problem_.robot, q)) continue;
    fault(at(segment, row), "has the wrong size or a value that is not finite");
    return false;
  }
  return true;
}

void PlanChecker::check_rows() {
  Eigen::VectorXd before = problem_.q_start;
  if ((reach().positions[0] - before).lpNorm<Eigen::Infinity>() > kTolerance)
    fault("reach row 0", "is not where the robot stands");
  for (const Segment& segment : plan_.segments) {
    scene::check_rows(
        problem_.robot, before, kTolerance, segment.positions,
        [&](std::size_t row, const std::string& what) { fault(at(segment, row), what); });
    before = segment.positions.back();
  }
}

void PlanChecker::check_collisions(const Segment& segment) {
  std::size_t faulty_row = segment.positions.size();  // at most one fault per row is reported
  scene::replay_rows(problem_.robot, segment.positions,
                     [&](std::size_t row, const Eigen::VectorXd& q) {
                       const auto touching = replay_.touching(q);
                       if (touching.empty() || row == faulty_row) return;
                       faulty_row = row;
                       fault(at(segment, row), "collision ", touching.front());
                     });
}

scene::EdgeCertificate PlanChecker::certify() {
  if (!is_complete()) throw std::invalid_argument("plan: cannot be certified; " + faults_.front());
  scene::EdgeCertificateMaker certificate;
  for (const Segment& segment : plan_.segments) {
    certificate.add(segment.name, segment.positions,
                    scene::EdgeProver(segment.name, segment.positions, replay_, {}).run());
  }
  return certificate.take();
}

/// In the last segment only the hand moves, and only towards its closed state.
void PlanChecker::check_hand_closes() {
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(problem_.robot.dof());
  for (const auto& [joint, sign] : closing_joints(problem_)) direction[joint] = sign;
  for (std::size_t row = 1; row < close().positions.size(); ++row) {
    const Eigen::VectorXd moved = close().positions[row] - close().positions[row - 1];
    const bool closes = ((moved.array() == 0) || (moved.array() * direction.array() > 0)).all();
    if (!closes) fault(at(close(), row), "a joint moves that does not close the hand");
  }
}

/// At the end, no joint of the hand can close by another 0.01 rad or 1 mm: it touches or is closed.
/// FCL alone misses grazing contacts of two capsules, so the world's exact distances are used as
/// well.
void PlanChecker::check_closed_until_contact() {
  const Eigen::VectorXd& closed = problem_.robot.state(problem_.hand.closed);
  for (const auto& [joint, sign] : closing_joints(problem_)) {
    const double step = scene::kReplayStep / problem_.robot.step_weights()[joint];
    const double left = sign * (closed[joint] - q_end()[joint]);
    if (left < step) continue;
    Eigen::VectorXd q = q_end();
    q[joint] += sign * step;
    if (replay_.touching(q).empty() && !replay_.world().collides()) {
      fault("close", "joint ", problem_.robot.joint_names()[joint],
            " could close further before anything touches");
    }
  }
}

/// Repeats the planner's stability test, and runs another one, in which FCL decides.
void PlanChecker::check_stability() {
  const Stability found = test_stability(problem_, q_closed(), plan_.loop, options_.stability);
  if (found.secure != plan_.stability.secure || found.escapes != plan_.stability.escapes ||
      !(std::abs(found.margin - plan_.stability.margin) <= kTolerance) ||
      !(std::abs(found.withstands - plan_.stability.withstands) <= kTolerance * found.withstands) ||
      found.opens_first != plan_.stability.opens_first) {
    fault("plan", "stability is not what its test says: ", found.escapes, " escapes, margin ",
          found.margin, ", withstands ", found.withstands, " N until '", found.opens_first,
          "' opens");
  }
  if (!found.secure) check_pinch();
  if (found.secure && comes_free(problem_, plan_.loop, q_closed()))
    fault("plan", "the loop came out of the hand, though the stability test calls it secure");
}

/// Friction must hold what is not secure without it.
void PlanChecker::check_pinch() {
  const bool may = problem_.hand.fingers.size() == 1 && options_.friction > 0;
  const Pinch found =
      may ? test_pinch(problem_, q_closed(), options_.friction, options_.stability) : Pinch{};
  if (found.holds != plan_.pinch.has_value() ||
      (found.holds && !(std::abs(found.strength - plan_.pinch->strength) <= kTolerance &&
                        std::abs(found.load - plan_.pinch->load) <= kTolerance))) {
    fault("plan", "pinch is not what its test says: strength ", found.strength, ", load ",
          found.load, ", gap ", found.gap);
  }
  if (options_.must_be_secure && !found.holds) fault("plan", "the clasp is not secure");
}

/// Repeats the certificate. A plan without one claims nothing.
void PlanChecker::check_certificate() {
  if (!plan_.certificate) return;
  const Certificate& stated = *plan_.certificate;
  const Certificate found = certificate(problem_, q_closed(), plan_.loop, options_.certificate);
  const auto differ = [](double a, double b) { return !(std::abs(a - b) <= kTolerance); };
  if (found.caged != stated.caged || differ(found.lower, stated.lower) ||
      differ(found.upper, stated.upper) || differ(found.thickness, stated.thickness) ||
      differ(found.gap, stated.gap) || found.between != stated.between) {
    fault("plan", "certificate is not what is found again: opening from ", found.lower, " to ",
          found.upper, " m, between '", found.between[0], "' and '", found.between[1], "', ",
          found.caged ? "caged" : "not caged");
  }
}

std::vector<std::string> check(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem);
  validate(options);
  return PlanChecker(problem, plan, options).run();
}

scene::EdgeCertificate certify(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem);
  validate(options);
  return PlanChecker(problem, plan, options).certify();
}

}  // namespace graspless::clasp
