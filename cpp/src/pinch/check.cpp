// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "graspless/pinch/pinch.hpp"
#include "graspless/watch.hpp"

#include "pinch/check_contacts.hpp"
#include "pinch/jaw.hpp"
#include "scene/edges.hpp"
#include "scene/rows.hpp"
#include "slide/check/replay.hpp"
#include "text.hpp"

namespace graspless::pinch {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;
using Faults = std::vector<std::string>;

constexpr double kSame = 1e-6;         // [m, rad]
constexpr double kUnevenEnd = 0.0035;  // gap left at one finger when the other touches [m]
constexpr double kPressed = 0.001;     // depth of the fingers in the object at the end [m]
constexpr double kSideways = 0.0025;   // of the hand from its straight line [m]
constexpr double kTurn = 0.025;        // of the hand on it [rad]
constexpr double kLean = 0.011;        // of a hand on an arm of fewer than six joints [rad]
constexpr double kArrived = 0.001;     // height over its end at which the hand may go sideways [m]
constexpr double kNearer = 2.5e-4;     // of a finger to the object, between waypoints [m]
constexpr double kPreshaped = 5e-4;    // of joints of a hand that is not quite open [rad or m]
const std::vector<std::string> kNames = {"approach", "grasp", "close"};

/// Replays one plan and collects its faults.
class Examination {
 public:
  Examination(const Problem& problem, const Plan& plan, const Options& options)
      : problem_(problem),
        plan_(plan),
        options_(options),
        jaw_(problem, options),
        strict_(problem, 0) {}

  Faults run() {
    if (!has_shape()) return faults_;
    check_rows();
    check_joints();
    for (const Segment& segment : plan_.segments)
      check_collisions(segment, slide::contacts_of(segment.name));
    check_straight();
    check_margin();
    check_closing();
    check_untouched();
    check_contacts();
    return faults_;
  }

  scene::EdgeCertificate certify() {
    if (!has_shape()) throw std::invalid_argument("plan: cannot be certified; " + faults_.front());
    scene::EdgeCertificateMaker certificate;
    for (const Segment& segment : plan_.segments) {
      slide::Replay world = strict_.with(slide::contacts_of(segment.name));
      world.move_object(problem_.X_WO_start);
      certificate.add(segment.name, segment.positions,
                      scene::EdgeProver(segment.name, segment.positions, world.bodies(), {}).run());
    }
    return certificate.take();
  }

 private:
  void fault(const std::string& where, const std::string& what) {
    faults_.push_back(where + ": " + what);
  }
  void fault(const Segment& segment, std::size_t row, const std::string& what) {
    fault(segment.name + " row " + std::to_string(row), what);
  }

  bool has_shape() {
    if (!plan_) {
      fault("plan", "not solved: " + plan_.reason);
      return false;
    }
    scene::check_shape(
        problem_.robot, plan_, kNames,
        [&](const std::string& place, const std::string& what) { fault(place, what); });
    const double opening = jaw_.widest();
    if (!(std::abs(plan_.opening - opening) <= kSame))
      fault("plan", "opening must be " + figure(opening) + " m, not " + figure(plan_.opening));
    if (plan_.contacts_O.cols() != 2 || !plan_.contacts_O.allFinite())
      fault("plan", "must have two contacts");
    return faults_.empty();
  }

  void check_rows() {
    VectorXd before = problem_.q_home;
    if ((plan_.segments[0].positions[0] - before).lpNorm<Eigen::Infinity>() > kSame)
      fault(plan_.segments[0], 0, "is not the home configuration q_home");
    for (const Segment& segment : plan_.segments) {
      scene::check_rows(
          problem_.robot, before, kSame, segment.positions,
          [&](std::size_t row, const std::string& what) { fault(segment, row, what); });
      before = segment.positions.back();
      for (std::size_t i = 0; i < segment.object_poses.size(); ++i) {
        if (!scene::is_same(segment.object_poses[i], problem_.X_WO_start, kSame))
          fault(segment, i, "the object moves though nothing holds it");
      }
    }
  }

  /// The hand that comes to the object: open, or closed as far as options.opening asks.
  VectorXd coming() const {
    const VectorXd open = problem_.robot.state(problem_.hand.open, problem_.q_home),
                   closed = problem_.robot.state(problem_.hand.closed, open);
    if (!options_.opening || jaw_.gap(open) <= *options_.opening) return open;
    double less = 0, more = 1;  // closed
    constexpr int kHalvings = 40;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (less + more) / 2;
      (jaw_.gap(open + middle * (closed - open)) >= *options_.opening ? less : more) = middle;
    }
    return open + less * (closed - open);
  }

  /// The hand is as open as asked on the straight line, and only the hand moves while it closes.
  void check_joints() {
    VectorXd hand = VectorXd::Ones(problem_.robot.dof());
    for (const int joint : problem_.robot.group(problem_.hand.arm)) hand[joint] = 0;
    const VectorXd open = coming();
    const Segment &grasp = plan_.segments[1], &close = plan_.segments[2];
    for (std::size_t i = 0; i < grasp.positions.size(); ++i) {
      const VectorXd off = (grasp.positions[i] - open).cwiseProduct(hand);
      if (off.lpNorm<Eigen::Infinity>() > (options_.opening ? kPreshaped : kSame))
        fault(grasp, i, "the hand is not open");
    }
    for (std::size_t i = 0; i < close.positions.size(); ++i) {
      const VectorXd off = (close.positions[i] - grasp.positions.back())
                               .cwiseProduct(VectorXd::Ones(hand.size()) - hand);
      if (off.lpNorm<Eigen::Infinity>() > kSame)
        fault(close, i, "the arm moves while the hand closes");
    }
  }

  void check_collisions(const Segment& segment, slide::Contacts contacts) {
    slide::Replay world = strict_.with(contacts);
    std::size_t faulty_row = segment.positions.size();  // one fault per row is enough
    scene::replay_rows(problem_.robot, segment.positions, [&](std::size_t row, const VectorXd& q) {
      if (row == faulty_row) return;
      const auto touching = world.touching(q, problem_.X_WO_start);
      if (touching.empty()) return;
      faulty_row = row;
      fault(segment, row, "collision " + touching.front());
    });
  }

  /// Nothing touches the object until the last row, where the hand has closed on it.
  void check_untouched() {
    Segment closing = plan_.segments[2];
    closing.positions.pop_back();
    if (!closing.positions.empty()) check_collisions(closing, slide::Contacts::none);
  }

  Isometry3d hand_at(const VectorXd& q) const {
    return problem_.robot.pose(problem_.robot.frame(problem_.hand.grasp_frame), q);
  }

  /// The hand comes straight, aside of where it closes if one jaw opens too little, and goes
  /// sideways at the end.
  void check_straight() {
    const Segment& grasp = plan_.segments[1];
    const Isometry3d X_HW = plan_.X_WH_grasp.inverse();
    const double aside = (X_HW * hand_at(grasp.positions.front())).translation().y();
    for (std::size_t i = 0; i < grasp.positions.size(); ++i) {
      const Isometry3d X_HH = X_HW * hand_at(grasp.positions[i]);
      const Vector3d p = X_HH.translation();
      const double end = p.z() < -kArrived ? aside : 0,
                   line = std::clamp(p.y(), std::min(aside, end), std::max(aside, end));
      if (std::hypot(p.x(), p.y() - line) > kSideways)
        fault(grasp, i, "the hand leaves its straight line");
      if (Eigen::AngleAxisd(X_HH.linear()).angle() > kTurn) fault(grasp, i, "the hand turns");
    }
    const double length = -(X_HW * hand_at(grasp.positions.front())).translation().z();
    if (length < options_.approach / 2 - kSideways)
      fault(grasp, 0, "the hand comes straight by less than half of options.approach");
    if (!scene::is_same(hand_at(grasp.positions.back()), plan_.X_WH_grasp, kSame))
      fault("plan", "X_WH_grasp is not where the hand ends");
  }

  /// Each finger of the hand that comes keeps the margin from the face on its side.
  void check_margin() {
    const Segment& grasp = plan_.segments[1];
    const Grip grip = jaw_.at(grasp.positions.front());
    const double middle = grip.contact_H.y(), half = grip.gap / 2;
    bool is_told = false;
    scene::replay_rows(problem_.robot, grasp.positions, [&](std::size_t row, const VectorXd& q) {
      const Isometry3d X_HW = hand_at(q).inverse(), X_HO = X_HW * problem_.X_WO_start;
      if (is_told || (X_HW * plan_.X_WH_grasp).translation().z() < kArrived) return;
      const double a = (X_HO * contact(0)).y(), b = (X_HO * contact(1)).y(),
                   gap = half - std::max(std::abs(a - middle), std::abs(b - middle));
      if (gap >= options_.margin - kNearer) return;
      is_told = true;
      fault(grasp, row, "a finger passes at " + figure(gap) + " m, less than options.margin");
    });
  }

  /// Interval that the shapes of one side of the hand take along a direction of W at q [m].
  std::pair<double, double> interval(const VectorXd& q, const Vector3d& direction,
                                     bool sliding) const {
    robot::Poses X_WL;
    problem_.robot.forward(q, X_WL);
    return {-foremost(problem_, X_WL, -direction, sliding).extent,
            foremost(problem_, X_WL, direction, sliding).extent};
  }

  /// The opening at the end is the distance of the contacts, and the fingers are off the support.
  void check_closing() {
    const VectorXd& q = plan_.segments[2].positions.back();
    const Vector3d y = hand_at(q).linear().col(1), n = problem_.support.normal_W();
    const double gap = jaw_.gap(q);
    const double width = (contact(1) - contact(0)).norm();
    const auto& heights = problem_.object.heights();  // whose faces are staircases of cells
    const double uneven = 2 * (kPressed + (heights ? heights->cell : 0));
    if (gap > width + kUnevenEnd || gap < width - uneven) {
      fault("close", "the fingers end " + figure(gap) + " m apart, the contacts are " +
                         figure(width) + " m apart");
    }
    check_hand_at_contacts(q, uneven + kUnevenEnd);
    const double support = n.dot(problem_.support.X_WS().translation());
    const auto up = interval(q, n, true), other_up = interval(q, n, false);
    const double low = std::min(up.first, other_up.first) - support;
    if (low < options_.clearance - kSame)
      fault("close", "a finger ends " + figure(low) + " m above the support");
    const double level = n.dot(problem_.X_WO_start * contact(0));
    for (const auto& [first, last] : {up, other_up}) {
      if (level < first || level > last) fault("close", "a finger ends beside its contact");
    }
    Vector3d across = problem_.X_WO_start.linear() * (contact(1) - contact(0));
    across -= n * n.dot(across);  // an object may be tilted a little
    const bool may_lean = problem_.robot.group(problem_.hand.arm).size() < 6;
    if (!(std::abs(across.normalized().dot(y)) >= (may_lean ? std::cos(kLean) : 1 - kSame)))
      fault("plan", "the fingers do not close along the line of contacts");
  }

  /// The contacts are midway between the fingers, and within the width of the pads.
  void check_hand_at_contacts(const VectorXd& q, double uneven) {
    const Vector3d middle_O = (contact(0) + contact(1)) / 2;
    const Vector3d off_H =
        hand_at(q).inverse() * (problem_.X_WO_start * middle_O) - jaw_.at(q).contact_H;
    if (!(std::abs(off_H.x()) <= problem_.hand.pad_width / 2 + kUnevenEnd))
      fault("close", "the contacts are beside the pads");
    if (!(std::abs(off_H.y()) <= uneven))
      fault("close", "the fingers end elsewhere than the contacts");
  }

  Vector3d contact(int i) const { return plan_.contacts_O.col(i); }

  /// The contacts lie on faces that are opposite each other.
  void check_contacts() {
    if (!(plan_.friction >= 0 && plan_.friction <= options_.friction))
      fault("plan", "needs a coefficient of friction of " + figure(plan_.friction));
    if (std::abs(contact(1).z() - contact(0).z()) > kSame)
      fault("plan", "the contacts are not equally high");
    const bool has_walls = problem_.object.heights().has_value();
    const Faults found = has_walls ? faults_of_wall(problem_, plan_, options_)
                                   : faults_of_faces(problem_, plan_, options_);
    faults_.insert(faults_.end(), found.begin(), found.end());
  }

  const Problem& problem_;
  const Plan& plan_;
  const Options& options_;
  Jaw jaw_;
  slide::Replay strict_;
  Faults faults_;
};

}  // namespace

std::vector<std::string> check(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem, false);
  validate(options);
  return Examination(problem, plan, options).run();
}

scene::EdgeCertificate certify(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem, false);
  validate(options);
  return Examination(problem, plan, options).certify();
}

}  // namespace graspless::pinch
