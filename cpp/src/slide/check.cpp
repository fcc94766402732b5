// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// check(): the promises of a plan, one function each. The formulas are written anew from the paper and from
// docs/architecture.md, so that a mistake in the search's cannot hide here.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "slide/replay.hpp"

namespace graspless::slide {
namespace {

constexpr double kReplayStep = 0.01;  // [rad]
constexpr double kRowStep = 0.05 + 1e-9;
constexpr double kSame = 1e-6;  // [m, rad]
constexpr double kPi = 3.14159265358979323846;

const std::vector<std::string> kNames = {"approach", "press", "slide", "lift", "reach", "grasp", "close"};

using Faults = std::vector<std::string>;

double angle_between(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

bool is_same(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double tolerance) {
  return (a.translation() - b.translation()).norm() <= tolerance && angle_between(a, b) <= tolerance;
}

/// Winding number by angles; distance to the boundary, positive inside.
double inside_by(const Eigen::Matrix2Xd& polygon, const Eigen::Vector2d& p) {
  double turned = 0, nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < polygon.cols(); ++i) {
    const Eigen::Vector2d a = polygon.col(i) - p, b = polygon.col((i + 1) % polygon.cols()) - p;
    turned += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    const Eigen::Vector2d ab = b - a;
    const double t = std::clamp(-a.dot(ab) / ab.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (a + t * ab).norm());
  }
  return std::abs(turned) > kPi ? nearest : -nearest;
}

/// One plan under examination.
class Examination {
 public:
  Examination(const Problem& problem, const Plan& plan, const Options& options)
      : problem_(problem), plan_(plan), options_(options), X_SW_(problem.support.X_WS().inverse()) {}

  Faults run() {
    if (!has_shape()) return faults_;
    check_rows();
    check_object_poses();
    for (const Segment& segment : plan_.segments) check_collisions(segment);
    check_pressing(segment("press"));
    check_pressing(segment("lift"));
    check_slide();
    check_pair();
    check_grasp();
    return faults_;
  }

 private:
  /// The finger against the support, from the frame's pose alone.
  struct Finger {
    double depth, pitch, roll;
    bool other_finger_up;
    Eigen::Vector2d commanded, effective, heading;
  };

  void fault(const std::string& where, const std::string& what) { faults_.push_back(where + ": " + what); }
  void fault(const Segment& segment, std::size_t row, const std::string& what) {
    fault(segment.name + " row " + std::to_string(row), what);
  }
  static std::string figure(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
  }
  const Segment& segment(const std::string& name) const {
    return plan_.segments[static_cast<std::size_t>(
        std::find(kNames.begin(), kNames.end(), name) - kNames.begin())];
  }

  bool has_shape();
  void check_rows();
  void check_object_poses();
  void check_collisions(const Segment& segment);
  void check_pressing(const Segment& segment);
  void check_slide();
  void check_slide_row(const Segment& slide, std::size_t row, const Eigen::VectorXd& q);
  geometry::Polygon::Edge faced_edge();
  void check_pair();
  void check_grasp();
  void check_straight(const Segment& grasp);
  Finger finger(const Eigen::VectorXd& q) const;
  Eigen::Isometry3d followed(const Finger& start, const Finger& now) const;
  /// Calls visit(row, q) at steps of 0.01 rad along a segment; `row` is the one that the step leads to.
  template <typename Visit>
  void replay(const Segment& segment, Visit visit) const;

  const Problem& problem_;
  const Plan& plan_;
  const Options& options_;
  Eigen::Isometry3d X_SW_;
  Faults faults_;
};

bool Examination::has_shape() {
  if (!plan_) {
    fault("plan", "not solved: " + plan_.reason);
    return false;
  }
  if (plan_.joint_names != problem_.robot.joint_names()) fault("plan", "joint names are not the robot's");
  std::vector<std::string> names;
  for (const Segment& s : plan_.segments) names.push_back(s.name);
  if (names != kNames) fault("plan", "segments are not approach, press, slide, lift, reach, grasp, close");
  for (const Segment& s : plan_.segments) {
    if (s.positions.empty() || s.positions.size() != s.object_poses.size()) {
      fault(s.name, "needs rows, and one object pose for each");
    }
    for (std::size_t i = 0; i < s.positions.size(); ++i) {
      const bool sound = s.positions[i].size() == problem_.robot.dof() && s.positions[i].allFinite() &&
                         s.object_poses[std::min(i, s.object_poses.size() - 1)].matrix().allFinite();
      if (!sound) fault(s, i, "has the wrong size or a value that is not finite");
    }
  }
  return faults_.empty();
}

void Examination::check_rows() {
  Eigen::VectorXd before = problem_.q_home;
  if ((plan_.segments[0].positions[0] - before).lpNorm<Eigen::Infinity>() > kSame) {
    fault("approach row 0", "is not the home configuration");
  }
  for (const Segment& s : plan_.segments) {
    for (std::size_t i = 0; i < s.positions.size(); ++i) {
      const double step = (s.positions[i] - before).lpNorm<Eigen::Infinity>();
      if (i == 0 && step > kSame) fault(s, i, "does not continue the segment before it");
      if (step > kRowStep) fault(s, i, "a joint moves by " + figure(step) + " rad between rows");
      if (!problem_.robot.is_within(s.positions[i], 1e-6)) fault(s, i, "leaves the joint limits");
      before = s.positions[i];
    }
  }
}

void Examination::check_object_poses() {
  const Eigen::Isometry3d& X_WO_slid = segment("slide").object_poses.back();
  constexpr double kFlat = 0.0175;  // a given pose may lie this far off the surface [m, rad]
  if (!is_same(plan_.segments[0].object_poses[0], problem_.X_WO_start, kFlat)) {
    fault("approach row 0", "the object is not at its start");
  }
  if (!is_same(plan_.X_WO_goal, X_WO_slid, kSame)) fault("plan", "X_WO_goal is not where the slide ends");
  for (const Segment& s : plan_.segments) {
    if (s.name == "slide") continue;
    const bool before = s.name == "approach" || s.name == "press";
    const Eigen::Isometry3d& still = before ? plan_.segments[0].object_poses[0] : X_WO_slid;
    for (std::size_t i = 0; i < s.object_poses.size(); ++i) {
      if (!is_same(s.object_poses[i], still, kSame)) fault(s, i, "the object moves though nothing slides it");
    }
  }
}

template <typename Visit>
void Examination::replay(const Segment& segment, Visit visit) const {
  visit(0, segment.positions[0]);
  for (std::size_t row = 1; row < segment.positions.size(); ++row) {
    const Eigen::VectorXd& from = segment.positions[row - 1];
    const Eigen::VectorXd step = segment.positions[row] - from;
    const int pieces =
        std::max(1, static_cast<int>(std::ceil(step.lpNorm<Eigen::Infinity>() / kReplayStep)));
    for (int i = 1; i <= pieces; ++i) visit(row, from + step * i / pieces);
  }
}

Examination::Finger Examination::finger(const Eigen::VectorXd& q) const {
  const Eigen::Isometry3d X_SF = X_SW_ * problem_.robot.pose(problem_.robot.frame(problem_.hand.fingertip), q);
  const Eigen::Matrix3d R = X_SF.linear();
  Finger f;
  f.depth = problem_.object.thickness() - X_SF.translation().z();
  f.pitch = std::atan2(-R(2, 2), R.col(2).head<2>().norm());
  f.roll = std::asin(std::clamp(R(2, 0), -1.0, 1.0));
  f.other_finger_up = R(2, 1) > 0;
  f.commanded = X_SF.translation().head<2>();
  f.heading = Eigen::Vector2d(R(1, 0), -R(0, 0)).normalized();  // across the line contact X_F
  f.effective = f.commanded;
  if (problem_.hand.finger_model == FingerModel::flexure) {
    // The flexure, a length L behind the commanded tip, stays; the finger turns up about it until its tip is in
    // the top face: L sin(pitch') = L sin(pitch) - depth. The pad then rolls by the turn.
    const double L = problem_.hand.flexure_length;
    const double bent = std::asin(std::clamp(std::sin(f.pitch) - f.depth / L, -1.0, 1.0));
    const double ahead = L * std::cos(bent) - L * std::cos(f.pitch);
    const double rolled = problem_.hand.tip_radius * (options_.pitch - bent);
    f.effective += (ahead + rolled) * f.heading;
  }
  return f;
}

/// The object's pose when it follows the effective contact rigidly from the start.
Eigen::Isometry3d Examination::followed(const Finger& start, const Finger& now) const {
  const double turn = std::atan2(start.heading.x() * now.heading.y() - start.heading.y() * now.heading.x(),
                                 start.heading.dot(now.heading));
  const Eigen::Isometry3d X_SO = X_SW_ * plan_.segments[0].object_poses[0];
  const Eigen::Vector3d from(start.effective.x(), start.effective.y(), 0), to(now.effective.x(), now.effective.y(), 0);
  return problem_.support.X_WS() * Eigen::Translation3d(to) *
         Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(-from) * X_SO;
}

void Examination::check_collisions(const Segment& segment) {
  const bool pressing = segment.name == "press" || segment.name == "slide" || segment.name == "lift";
  Replay world(problem_, options_,
               pressing ? Contacts::press : segment.name == "close" ? Contacts::close : Contacts::none);
  const bool slides = segment.name == "slide";
  const Finger start = finger(segment.positions[0]);
  std::size_t faulty_row = segment.positions.size();  // one report a row is enough
  replay(segment, [&](std::size_t row, const Eigen::VectorXd& q) {
    const Eigen::Isometry3d X_WO = slides ? followed(start, finger(q)) : segment.object_poses[row];
    const auto touching = world.touching(q, X_WO);
    if (touching.empty() || row == faulty_row) return;
    faulty_row = row;
    fault(segment, row, "collision " + touching.front());
  });
}

/// While the finger presses or lifts, the object must stand still: the effective contact does.
void Examination::check_pressing(const Segment& segment) {
  constexpr double kStill = 5e-4;  // [m]
  const bool press = segment.name == "press";
  const Finger pressed = finger(press ? segment.positions.back() : segment.positions.front());
  replay(segment, [&](std::size_t row, const Eigen::VectorXd& q) {
    const Finger now = finger(q);
    if (now.depth > options_.max_depth + options_.height_tolerance) {
      fault(segment, row, "pressed " + figure(now.depth) + " m deep");
    }
    if (now.depth <= 0) return;
    const double moved = (now.effective - pressed.effective).norm();
    if (moved > kStill) fault(segment, row, "the contact moves by " + figure(moved) + " m");
    if (std::abs(now.pitch - options_.pitch) > options_.pitch_tolerance) {
      fault(segment, row, "pitch " + figure(now.pitch) + " rad");
    }
  });
}

void Examination::check_slide() {
  const Segment& slide = segment("slide");
  const Finger start = finger(slide.positions.front());
  const Eigen::Isometry3d X_OS = (X_SW_ * slide.object_poses.front()).inverse();
  const Eigen::Vector3d contact_O = X_OS * Eigen::Vector3d(start.effective.x(), start.effective.y(), 0);
  if (inside_by(problem_.object.outline().vertices(), contact_O.head<2>()) < -0.001) {
    fault(slide, 0, "the contact is not on the object");
  }
  if (std::abs(start.pitch - options_.pitch) > 1e-4) {
    fault(slide, 0, "does not start at the given pitch: " + figure(start.pitch) + " rad");
  }
  replay(slide, [&](std::size_t row, const Eigen::VectorXd& q) { check_slide_row(slide, row, q); });
  for (std::size_t row = 0; row < slide.positions.size(); ++row) {
    if (!is_same(followed(start, finger(slide.positions[row])), slide.object_poses[row], kSame)) {
      fault(slide, row, "the object does not follow the contact");
    }
  }
}

void Examination::check_slide_row(const Segment& slide, std::size_t row, const Eigen::VectorXd& q) {
  constexpr double kRound = 1e-9;
  const Finger now = finger(q);
  const double play = options_.height_tolerance + kRound;
  if (now.depth < options_.min_depth - play || now.depth > options_.max_depth + play) {
    fault(slide, row, "depth " + figure(now.depth) + " m is out of its band");
  }
  if (std::abs(now.pitch - options_.pitch) > options_.pitch_tolerance + kRound) {
    fault(slide, row, "pitch " + figure(now.pitch) + " rad is out of its band");
  }
  if (std::abs(now.roll) > options_.roll_tolerance + kRound) fault(slide, row, "roll " + figure(now.roll) + " rad");
  if (!now.other_finger_up) fault(slide, row, "the other finger points down");
  const Eigen::Matrix2Xd& Q = problem_.support.polygon().vertices();
  if (inside_by(Q, now.commanded) < -kRound) fault(slide, row, "the fingertip leaves the support");
  if (inside_by(Q, now.effective) < options_.tip_margin - kRound) {
    fault(slide, row, "the contact comes too near the edge");
  }
}

/// The edge that the hand faces: of those across its way, the nearest to it.
geometry::Polygon::Edge Examination::faced_edge() {
  const geometry::Polygon& Q = problem_.support.polygon();
  const Eigen::Isometry3d X_SH = X_SW_ * plan_.X_WH_grasp;
  const Eigen::Vector2d in = X_SH.linear().col(2).head<2>(), hand = X_SH.translation().head<2>();
  geometry::Polygon::Edge faced = Q.edge(0);
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < Q.size(); ++i) {
    const auto edge = Q.edge(i);
    const double along = std::clamp((hand - edge.a).dot(edge.b - edge.a) / (edge.b - edge.a).squaredNorm(), 0.0, 1.0);
    const double distance = (hand - edge.a - along * (edge.b - edge.a)).norm();
    if (edge.inward.dot(in) < 1 - 1e-6 || distance >= nearest) continue;
    nearest = distance;
    faced = edge;
  }
  if (!std::isfinite(nearest)) fault("goal", "the hand does not come perpendicularly to an edge");
  return faced;
}

/// Conditions 1 and 2 of IsPairValid.
void Examination::check_pair() {
  const Eigen::Isometry3d X_SO = X_SW_ * plan_.X_WO_goal;
  const geometry::Polygon& Q = problem_.support.polygon();
  const geometry::Polygon::Edge edge = faced_edge();
  double overhang = 0;
  for (const auto& p_O : problem_.object.points().colwise()) {
    const Eigen::Vector2d p = (X_SO * Eigen::Vector3d(p_O.x(), p_O.y(), 0)).head<2>();
    if (inside_by(Q.vertices(), p) < 0) overhang = std::max(overhang, -edge.inward.dot(p - edge.a));
  }
  if (!(overhang >= options_.min_overhang - 1e-9)) {
    fault("goal", "the object sticks out by " + figure(overhang) + " m only");
  }
  if (std::abs(overhang - plan_.overhang) > kSame) fault("goal", "the overhang is not what the plan says");
  Eigen::Vector3d com_W = plan_.X_WO_goal * problem_.object.com();
  const Eigen::Vector3d n = problem_.support.normal_W();
  com_W.z() -= n.dot(com_W - problem_.support.X_WS().translation()) / n.z();  // along gravity, onto the surface
  const double inside = inside_by(Q.vertices(), (X_SW_ * com_W).head<2>());
  if (inside < options_.com_margin - 1e-9) {
    fault("goal", "the centre of mass is inside by " + figure(inside) + " m only");
  }
}

/// Condition 3: the hand arrives at H_g, straight, and closes on the object.
void Examination::check_grasp() {
  const Segment& grasp = segment("grasp");
  const robot::Robot& robot = problem_.robot;
  const int H = robot.frame(problem_.hand.grasp_frame);
  if (!is_same(robot.pose(H, grasp.positions.back()), plan_.X_WH_grasp, 1e-5)) {
    fault("grasp", "does not end at X_WH_grasp");
  }
  const Eigen::Isometry3d X_SH = X_SW_ * plan_.X_WH_grasp;
  if (std::abs(X_SH.linear()(2, 2)) > 1e-6 || std::abs(std::abs(X_SH.linear()(2, 1)) - 1) > 1e-6) {
    fault("grasp", "the finger plane is not vertical, or the hand not level with the surface");
  }
  if (std::abs(X_SH.translation().z() - problem_.object.thickness() / 2) > 1e-6) {
    fault("grasp", "the hand is not at half the object's height");
  }
  const Eigen::Isometry3d X_OH = plan_.X_WO_goal.inverse() * plan_.X_WH_grasp;
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& p : problem_.object.points().colwise()) {
    nearest = std::min(nearest, (X_OH.translation().head<2>() - p).norm());
  }
  if (nearest > 0.02) fault("grasp", "the hand closes beside the object");
  check_straight(grasp);

  Replay strict(problem_, options_, Contacts::none);
  const Segment& close = segment("close");
  if (strict.touching(close.positions.back(), close.object_poses.back()).empty()) {
    fault("close", "no finger touches the object at the end");
  }
}

void Examination::check_straight(const Segment& grasp) {
  constexpr double kSideways = 0.003, kTurn = 0.03;  // [m], [rad]
  const robot::Robot& robot = problem_.robot;
  const int H = robot.frame(problem_.hand.grasp_frame);
  double back = 0;
  replay(grasp, [&](std::size_t row, const Eigen::VectorXd& q) {
    const Eigen::Isometry3d X_HH = plan_.X_WH_grasp.inverse() * robot.pose(H, q);
    if (X_HH.translation().head<2>().norm() > kSideways || Eigen::AngleAxisd(X_HH.linear()).angle() > kTurn) {
      fault(grasp, row, "the hand does not come straight");
    }
    back = std::max(back, -X_HH.translation().z());
  });
  if (back < options_.grasp_approach - 1e-4) {
    fault("grasp", "the straight way is " + figure(back) + " m only");
  }
}

}  // namespace

std::vector<std::string> check(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem);
  validate(options);
  return Examination(problem, plan, options).run();
}

}  // namespace graspless::slide
