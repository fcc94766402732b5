// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Compares the frames that a hand's description names with the shapes of its fingers. A wrong frame
// is the likeliest mistake with a new hand, and no other check would notice it.
#include "slide/task/hand_frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "robot/names.hpp"
#include "slide/contact.hpp"
#include "slide/refusals.hpp"
#include "text.hpp"

namespace graspless::slide {
namespace {

using Eigen::Vector3d;

constexpr double kAlong = 0.7;  // cosine: within about 45 degrees

/// Largest coordinate of a link's shape along a unit direction of A, from A's origin [m].
double extent(const robot::LinkShape& shape, const Eigen::Isometry3d& X_AL,
              const Vector3d& direction_A) {
  return geometry::extent(shape.placed, X_AL.linear().transpose() * direction_A) +
         direction_A.dot(X_AL.translation());
}

/// Middle of the box of W around a link's shape [m].
Vector3d middle_of(const robot::LinkShape& shape, const Eigen::Isometry3d& X_WL) {
  Vector3d middle;
  for (int i = 0; i < 3; ++i) {
    const Vector3d axis = Vector3d::Unit(i);
    middle[i] = (extent(shape, X_WL, axis) - extent(shape, X_WL, -axis)) / 2;
  }
  return middle;
}

/// Mean position of the links' collision shapes, in W, with the hand open [m]. Throws if there are
/// none; `what` names the links.
Vector3d middle_of(const Problem& problem, const std::vector<std::string>& links,
                   const std::string& what) {
  const robot::Robot& robot = problem.robot;
  robot::Poses X_WL;
  robot.forward(robot.state(problem.hand.open), X_WL);
  Vector3d sum = Vector3d::Zero();
  int count = 0;
  for (const robot::LinkShape& shape : robot.shapes()) {
    const std::string& link = robot.frame_names()[shape.link];
    if (!robot::contains(links, link)) continue;
    sum += middle_of(shape, X_WL[shape.link]);
    ++count;
  }
  if (count == 0) throw std::invalid_argument(what + " must name a link with a collision shape");
  return sum / count;
}

void require_frame(bool holds, const std::string& field, const std::string& frame,
                   const std::string& must) {
  if (holds) return;
  throw std::invalid_argument("hand." + field + " '" + frame + "': " + must +
                              " (judged by the collision shapes of the open hand)");
}

/// Links of hand.fingers that are not of the finger that slides.
std::vector<std::string> other_links(const Hand& hand) {
  std::vector<std::string> others;
  for (const std::string& link : hand.fingers) {
    if (!robot::contains(hand.sliding_finger, link)) others.push_back(link);
  }
  return others;
}

/// True if finger or wrist give way by the whole depth.
bool yields(const Hand& hand) {
  return hand.finger_model == FingerModel::flexure || hand.finger_model == FingerModel::impedance;
}

/// Interval that the shapes of links take along a direction of W at q [m].
std::pair<double, double> interval(const Problem& problem, const Eigen::VectorXd& q,
                                   const std::vector<std::string>& links,
                                   const Vector3d& direction) {
  robot::Poses X_WL;
  problem.robot.forward(q, X_WL);
  std::pair<double, double> found{std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity()};
  for (const robot::LinkShape& shape : problem.robot.shapes()) {
    const auto link = static_cast<std::size_t>(shape.link);
    if (!robot::contains(links, problem.robot.frame_names()[link])) continue;
    found.first = std::min(found.first, -extent(shape, X_WL[link], -direction));
    found.second = std::max(found.second, extent(shape, X_WL[link], direction));
  }
  return found;
}

}  // namespace

FingerProfile::FingerProfile(const Problem& problem) {
  const robot::Robot& robot = problem.robot;
  robot::Poses X_WL;
  robot.forward(robot.state(problem.hand.open), X_WL);
  const auto F = static_cast<std::size_t>(robot.frame(problem.hand.fingertip));
  for (const robot::LinkShape& shape : robot.shapes()) {
    const auto link = static_cast<std::size_t>(shape.link);
    if (!robot::contains(problem.hand.sliding_finger, robot.frame_names()[link])) continue;
    shapes_.push_back(shape.placed);
    shapes_.back().X_BG = X_WL[F].inverse() * X_WL[link] * shape.placed.X_BG;
  }
}

double FingerProfile::below(double pitch) const {
  const Vector3d down_F(0, -std::cos(pitch), std::sin(pitch));
  double below = -std::numeric_limits<double>::infinity();
  for (const auto& placed : shapes_) below = std::max(below, geometry::extent(placed, down_F));
  return below;
}

// Between two directions less than pi apart, the farthest point of a set along any direction is at
// most (sin(b) h1 + sin(a) h2) / sin(a + b) away, with the angles a and b to both and their h.
double FingerProfile::below(double min_pitch, double max_pitch) const {
  const double most = std::max(below(min_pitch), below(max_pitch));
  return most <= 0 ? most : most / std::cos((max_pitch - min_pitch) / 2);
}

void check_closing(const Problem& problem) {
  const Hand& hand = problem.hand;
  const Eigen::VectorXd& q = problem.robot.state(hand.closed);
  const Vector3d across =
      problem.robot.pose(problem.robot.frame(hand.grasp_frame), q).linear().col(1);
  const auto own = interval(problem, q, hand.sliding_finger, across);
  const auto other = interval(problem, q, other_links(hand), across);
  const double apart = std::max(other.first - own.second, own.first - other.second);
  if (!(apart > problem.object.thickness())) return;
  throw std::invalid_argument("hand.closed '" + hand.closed + "': the fingers stay " +
                              in_mm(apart) + " apart, but the object '" + problem.object.name() +
                              "' is only " + in_mm(problem.object.thickness()) + " thick");
}

std::string jaw_lengths(const Problem& problem, const Eigen::VectorXd& q,
                        const Eigen::Isometry3d& X_WO, const std::string& link) {
  const Vector3d up = problem.support.normal_W();
  const auto own = interval(problem, q, problem.hand.sliding_finger, up);
  const auto other = interval(problem, q, other_links(problem.hand), up);
  const auto jaw = interval(problem, q, {link}, up);
  const double under = X_WO.translation().dot(up), thickness = problem.object.thickness();
  const double apart = std::max(other.first - own.second, own.first - other.second);
  const double below = under - std::min(own.first, other.first),
               above = std::max(own.second, other.second) - under - thickness;
  return (apart > 0 ? "the fingers open " + in_mm(apart) : "the open fingers overlap") + ", " +
         link + " is " + in_mm(jaw.second - jaw.first) + " thick, the object " + in_mm(thickness) +
         "; the hand needs " + in_mm(below) + " below the object and " + in_mm(above) + " above it";
}

double allowed_sink(const Hand& hand) { return yields(hand) ? 0.008 : 0.005; }

void check_finger_fits(const Problem& problem, const Options& options) {
  constexpr double kReach = 0.003;  // [m]
  constexpr int kSamples = 9;
  const auto [min_depth, max_depth] = depth_band(problem.hand, options);
  const Hand& hand = problem.hand;
  const double allowed = allowed_sink(hand);
  const FingerProfile profile(problem);
  // Depth of the finger's shapes below the contact after it has yielded; negative above it.
  const auto sink = [&](double depth, double pitch) {
    return profile.below(yielded_pitch(hand, depth, pitch)) + (yields(hand) ? 0 : depth);
  };
  for (int i = 0; i < kSamples; ++i) {
    const double pitch = options.pitch + options.pitch_tolerance * (2.0 * i / (kSamples - 1) - 1);
    const double least = sink(min_depth, pitch), most = sink(max_depth, pitch);
    const auto at = [&](double depth) {
      return "hand.fingertip '" + hand.fingertip + "': at pitch " + figure(pitch) +
             " rad and depth " + in_mm(depth);
    };
    if (most > allowed) {
      throw std::invalid_argument(at(max_depth) + ", the sliding finger is " + in_mm(most) +
                                  " below the contact, more than " + in_mm(allowed) +
                                  "; the frame must lie on the finger's surface, at the lower "
                                  "edge of its tip; flatter pitches (options.pitch less "
                                  "options.pitch_tolerance) and larger options.max_depth sink "
                                  "the finger deeper");
    }
    if (least < -kReach) {
      throw std::invalid_argument(at(min_depth) + ", the sliding finger ends " + in_mm(-least) +
                                  " above the contact; the frame must lie on the finger's surface");
    }
  }
}

void check_hand_frames(const Problem& problem) {
  const Hand& hand = problem.hand;
  const std::vector<std::string> others = other_links(hand);
  if (others.empty()) {
    throw std::invalid_argument(
        "hand.fingers must name at least one finger besides hand.sliding_finger");
  }
  const robot::Robot& robot = problem.robot;
  const Eigen::VectorXd& open = robot.state(hand.open);
  const Eigen::Isometry3d X_WF = robot.pose(robot.frame(hand.fingertip), open);
  const Eigen::Isometry3d X_WH = robot.pose(robot.frame(hand.grasp_frame), open);
  const Vector3d finger = middle_of(problem, hand.sliding_finger, "hand.sliding_finger"),
                 other = middle_of(problem, others,
                                   "hand.fingers, besides those of hand.sliding_finger,");
  const Vector3d across = (other - finger).normalized();

  require_frame(X_WF.linear().col(2).dot(X_WF.translation() - finger) > 0, "fingertip",
                hand.fingertip, "its Z axis must point out of the tip");
  require_frame(X_WF.linear().col(1).dot(across) > kAlong, "fingertip", hand.fingertip,
                "its Y axis must point towards the other finger");
  require_frame(X_WH.linear().col(2).dot(X_WH.translation() - (finger + other) / 2) > 0,
                "grasp_frame", hand.grasp_frame,
                "its Z axis must point out of the hand, its origin lie between the open tips");
  require_frame(std::abs(X_WH.linear().col(1).dot(across)) > kAlong, "grasp_frame",
                hand.grasp_frame, "its Y axis must run from finger to finger");
}

}  // namespace graspless::slide
