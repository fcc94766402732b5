// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/motions.hpp"

#include <algorithm>
#include <cmath>

namespace graspless::slide {

using planning::Path;

namespace {

constexpr double kPressStep = 0.0025;  // between waypoints along the retreat line [m]
constexpr double kStill = 4e-4;        // allowed movement of the contact between them [m]
constexpr double kGraspStep = 0.01;    // between waypoints of the hand's straight final motion [m]
constexpr double kLineStep = 0.02;     // between waypoints of other straight motions [m]
constexpr std::size_t kGraspCandidates = 6;
constexpr std::size_t kRemembered = 8;          // goals whose grasps are known
constexpr std::size_t kSearchedCandidates = 2;  // of those, the nearest to which a tree is grown

/// Appends poses straight above X_WF, up to `height` [m].
void append_rise(const Query& query, const Eigen::Isometry3d& X_WF, double height,
                 std::vector<Eigen::Isometry3d>& poses) {
  const Eigen::Vector3d up_W = query.problem.support.normal_W();
  const int steps = height > 0 ? pieces(height, kLineStep) : 0;
  for (int i = 1; i <= steps; ++i)
    poses.push_back(Eigen::Translation3d(up_W * (height * i / steps)) * X_WF);
}

}  // namespace

bool Motions::is_pair_valid(const Eigen::VectorXd& start, const Eigen::VectorXd& goal) {
  const ContactSpace::Carried carried = query_.carried_from(start);
  Handling handling;
  handling.object_goal = query_.contact.carry(carried, goal);
  if (!is_goal(handling)) return false;
  const auto lift = lift_from(goal, handling.object_goal);
  if (!lift) {
    query_.refuse("pair: lift");
    ++num_refused_;
    return false;
  }
  handling.lift = *lift;
  const std::optional<Approach>& approach = approach_to(start);
  if (!approach) {
    query_.refuse("pair: start cannot be reached from home");
    ++num_refused_;
    return false;
  }
  if (!query_.object_end && !find_reach(handling)) {  // condition 3
    ++num_refused_;
    return false;
  }
  valid_approach_ = approach;
  handling_ = std::move(handling);
  return true;
}

/// Conditions 1 and 2: the object sticks out over an edge, and does not fall. Or it is where it
/// is to be left.
bool Motions::is_goal(Handling& handling) {
  if (query_.object_end) {
    if (!is_at_end(*query_.object_end, handling.object_goal)) {
      query_.refuse("pair: the object ends elsewhere");
      return false;
    }
    if (is_supported(query_.problem, handling.object_goal, query_.options.com_margin)) return true;
    query_.refuse("pair: centre of mass");
    return false;
  }
  handling.placement = placement(query_.problem, query_.options, handling.object_goal);
  if (handling.placement.overhang < query_.options.min_overhang) {  // condition 1
    query_.refuse("pair: " + handling.placement.fault);
    return false;
  }
  if (!handling.placement.com_inside) {  // condition 2
    query_.refuse("pair: centre of mass");
    return false;
  }
  return true;
}

bool Motions::is_graspable(const Planar& object_S, const Placement& place) {
  place_object(object_S);
  auto grasps = grasp_configurations(place, 1);
  if (grasps.empty()) return false;
  if (drawn_.size() == kRemembered) drawn_.erase(drawn_.begin());
  drawn_.push_back({object_S, place.out_center, std::move(grasps)});
  return true;
}

void Motions::place_object(const Planar& object_S) {
  query_.free.move_object(query_.object_body, query_.X_WS * spatial(object_S));
}

const std::optional<Approach>& Motions::approach_to(const Eigen::VectorXd& start) {
  KnownApproach& known = approaches_[std::vector<double>(start.begin(), start.end())];
  const int iterations = search_iterations();
  if (!known.found && known.iterations < iterations)
    known = {find_approach(start, iterations), iterations};
  return known.found;
}

std::optional<Approach> Motions::find_approach(const Eigen::VectorXd& start, int iterations) {
  const auto lift = lift_from(start, query_.object_start);
  if (!lift) return std::nullopt;
  place_object(query_.object_start);
  const auto free = free_path(query_.arm.part(query_.problem.q_home), lift->back(), iterations);
  if (!free) return std::nullopt;
  return Approach{*free, Path(lift->rbegin(), lift->rend())};
}

// Most free motions are straight. Growing a tree is expensive, and another pair may not need one,
// so its budget grows with the number of rejected pairs.
int Motions::search_iterations() const {
  constexpr int kFirst = 30, kDoublings = 5;
  return kFirst << std::min(num_refused_ / 2, kDoublings);
}

// Along the retreat line, on which the effective contact does not move, then straight up.
std::optional<Path> Motions::lift_from(const Eigen::VectorXd& pressed, const Planar& object_S) {
  const Tip tip = query_.contact.tip_at(pressed);
  const Planar contact = query_.contact.effective(tip);
  const double depth = query_.top - tip.height;
  std::vector<Eigen::Isometry3d> poses;
  const int press_steps = pieces(depth, kPressStep);
  for (int i = press_steps - 1; i >= 0; --i) {
    poses.push_back(query_.pressed_tip(contact, depth * i / press_steps, tip.pitch));
  }
  append_rise(query_, Eigen::Isometry3d(poses.back()), query_.options.lift_height, poses);
  auto path =
      hand_.track(query_.tip_ik, pressed, poses, query_.contact.scene_with_object_at(object_S));
  if (path && !stands_still(*path, press_steps, contact)) return std::nullopt;
  return path;
}

// Straight up without turning, to the height at which a lift ends.
std::optional<Path> Motions::rise_from(const Eigen::VectorXd& start, const Planar& object_S) {
  const int F = query_.problem.robot.frame(query_.problem.hand.fingertip);
  const double depth = query_.top - query_.contact.tip_at(start).height;
  std::vector<Eigen::Isometry3d> poses;
  append_rise(query_, query_.problem.robot.pose(F, query_.arm.full(start)),
              depth + query_.options.lift_height, poses);
  return hand_.track(query_.tip_ik, start, poses, query_.contact.scene_with_object_at(object_S));
}

/// True if position and heading of the effective contact stay the same along the first `steps` of a
/// lift, also halfway between waypoints, and just above, where check() still calls it a contact.
bool Motions::stands_still(const Path& lift, int steps, const Planar& contact) {
  constexpr double kTurn = 8e-4;  // [rad]
  const auto is_still = [&](const Tip& tip) {
    const Planar now = query_.contact.effective(tip);
    return (now.translation() - contact.translation()).norm() <= kStill &&
           (now.linear() - contact.linear()).col(0).norm() <= kTurn &&
           std::abs(tip.roll) <= 0.9 * kRollTolerance;
  };
  const auto top = static_cast<std::size_t>(steps);
  for (std::size_t i = 1; i <= top; ++i) {
    if (!is_still(query_.contact.tip_at((lift[i - 1] + lift[i]) / 2))) return false;
  }
  if (top + 1 >= lift.size()) return true;
  constexpr int kSamples = 20;
  for (int k = 1; k <= kSamples; ++k) {
    const Tip tip = query_.contact.tip_at(lift[top] + (lift[top + 1] - lift[top]) * k / kSamples);
    if (tip.height > query_.top + kHeightTolerance) break;
    if (!is_still(tip)) return false;
  }
  return true;
}

std::optional<Path> Motions::free_path(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                       int iterations) {
  return hand_.free_path(from, to, iterations, query_.rng, [&] { return query_.clock.is_out(); });
}

// Condition 3: a motion leads from the lifted finger to H_g.
bool Motions::find_reach(Handling& handling) {
  place_object(handling.object_goal);
  auto candidates = grasp_configurations(handling.placement, kGraspCandidates);
  for (const Drawn& drawn : drawn_) {
    if (!drawn.object_S.isApprox(handling.object_goal, 1e-9)) continue;
    // At a tie, rounding decides which part of the object is grasped.
    if (!drawn.out_center.isApprox(handling.placement.out_center, 1e-9)) continue;
    candidates.insert(candidates.end(), drawn.grasps.begin(), drawn.grasps.end());
  }
  if (candidates.empty()) {
    query_.refuse("pair: grasp reach");
    return false;
  }
  const Eigen::VectorXd& from = handling.lift.back();
  std::sort(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
    if (a.deep != b.deep) return a.deep > b.deep;
    return (a.arm - from).squaredNorm() < (b.arm - from).squaredNorm();
  });
  const auto is_same = [](const auto& a, const auto& b) { return a.arm == b.arm; };
  candidates.erase(std::unique(candidates.begin(), candidates.end(), is_same), candidates.end());
  std::vector<Handling> unreached;  // no straight motion leads there
  for (const auto& candidate : candidates) {
    if (query_.clock.is_out()) return false;
    Handling grasped = handling;
    if (!add_grasp(candidate, grasped)) continue;
    if (!add_reach(grasped, 0)) {
      unreached.push_back(std::move(grasped));
    } else if (add_close(grasped)) {
      handling = std::move(grasped);
      return true;
    }
  }
  std::size_t searched = 0;
  for (Handling& grasped : unreached) {
    if (query_.clock.is_out()) return false;
    if (searched == kSearchedCandidates) break;
    if (!add_close(grasped)) continue;
    ++searched;
    if (add_reach(grasped, search_iterations())) {
      handling = std::move(grasped);
      return true;
    }
  }
  query_.refuse("pair: grasp motion");
  return false;
}

bool Motions::add_grasp(const GraspConfiguration& grasp, Handling& handling) {
  const double back = query_.options.grasp_approach;
  std::vector<Eigen::Isometry3d> outwards;
  const int steps = pieces(back, kGraspStep);
  for (int i = 1; i <= steps; ++i) {
    outwards.push_back(
        grasp_pose(query_.problem, handling.placement, grasp.roll, back * i / steps - grasp.deep));
  }
  const auto out = hand_.track(query_.grasp_ik, grasp.arm, outwards);
  if (!out || !is_straight(*out, handling, grasp.roll)) {
    query_.refuse("pair: straight approach");
    return false;
  }
  handling.grasp = Path(out->rbegin(), out->rend());
  handling.X_WH = grasp_pose(query_.problem, handling.placement, grasp.roll, -grasp.deep);
  return true;
}

bool Motions::add_close(Handling& handling) {
  auto close = close_hand(handling.grasp.back());
  if (close) handling.close = std::move(*close);
  return close.has_value();
}

bool Motions::add_reach(Handling& handling, int iterations) {
  const auto reach = free_path(handling.lift.back(), handling.grasp.front(), iterations);
  if (reach) handling.reach = *reach;
  return reach.has_value();
}

// True if the hand stays on its line without turning, also halfway between waypoints.
bool Motions::is_straight(const Path& path, const Handling& handling, int roll) {
  constexpr double kSideways = 0.0025, kTurn = 0.025;  // [m], [rad]
  const robot::Robot& robot = query_.problem.robot;
  const int H = robot.frame(query_.problem.hand.grasp_frame);
  const Eigen::Isometry3d X_HW = grasp_pose(query_.problem, handling.placement, roll).inverse();
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Eigen::Isometry3d X_HH =
        X_HW * robot.pose(H, query_.arm.full((path[i - 1] + path[i]) / 2));
    if (X_HH.translation().head<2>().norm() > kSideways) return false;
    if (Eigen::AngleAxisd(X_HH.linear()).angle() > kTurn) return false;
  }
  return true;
}

// Closes the hand until the fingers touch the object. Returns nothing if they touch something else
// first, or nothing at all.
std::optional<std::vector<Eigen::VectorXd>> Motions::close_hand(const Eigen::VectorXd& arm) {
  HandMotion::Closing closing = hand_.close(arm);
  const auto& [a, b] = closing.touching;
  if (is_finger_on_object(query_.problem.hand, a, b)) return std::move(closing.rows);
  query_.refuse(a.empty() ? "pair: closing: the closed fingers do not reach the object"
                          : "pair: closing: " + a + " touches " + b);
  return std::nullopt;
}

}  // namespace graspless::slide
