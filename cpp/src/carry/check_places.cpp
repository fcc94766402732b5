// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "carry/check_held.hpp"
#include "scene/bands.hpp"
#include "scene/rows.hpp"

namespace graspless::carry {
namespace {

using Eigen::Isometry3d, Eigen::Vector3d, Eigen::VectorXd;

/// Replays one plan that puts the object down, and collects its faults.
class PlaceExamination {
 public:
  PlaceExamination(const Problem& problem, const Plan& plan, const Options& options)
      : problem_(problem), places_(*problem.places), plan_(plan), options_(options) {
    faults_ = shape_faults(problem, plan, {"transfer", "lower", "open", "retreat"});
    const int given = static_cast<int>(places_.X_WO.size());
    if (faults_.empty() && (plan.place < 0 || plan.place >= given))
      faults_.push_back("plan: place must lie in [0, " + std::to_string(given - 1) + "], not " +
                        std::to_string(plan.place));
  }

  std::vector<std::string> run() {
    if (!faults_.empty()) return faults_;
    check_rows();
    check_joints();
    check_object_poses();
    check_lengths();
    HeldReplay world(problem_, options_);
    std::optional<HeldReplay> hanging = hanging_replay(problem_, options_);
    replay(segment("transfer"), world, hanging);
    if (hanging) hanging->allow_sunk(places_, options_.height);
    replay(segment("lower"), world, hanging);
    hanging.reset();
    replay(segment("open"), world, hanging);
    world.let_go();
    const Segment& retreat = segment("retreat");
    replay(retreat, world, hanging);
    return faults_;
  }

  scene::EdgeCertificate certify() {
    if (!faults_.empty())
      throw std::invalid_argument("plan: cannot be certified; " + faults_.front());
    scene::EdgeCertificateMaker certificate;
    HeldReplay world(problem_, options_);
    std::optional<HeldReplay> hanging = hanging_replay(problem_, options_);
    for (const Segment& part : plan_.segments) {
      std::vector<scene::Doubt> doubts;
      if (part.name == "transfer") doubts = prove_level(world, part);
      if (part.name == "lower") doubts = way_down().prove(world, part, options_);
      if (part.name == "retreat") world.let_go();
      auto more = is_held(part) ? world.prove_free(part) : world.prove_free(part, put());
      for (auto& doubt : more) doubts.push_back(std::move(doubt));
      if (hanging && is_held(part)) {
        if (part.name == "lower") hanging->allow_sunk(places_, options_.height);
        for (auto& doubt : hanging->prove_free(part)) doubts.push_back(std::move(doubt));
      }
      certificate.add(part.name, part.positions, std::move(doubts));
    }
    return certificate.take();
  }

 private:
  const Segment& segment(const std::string& name) const {
    return *std::find_if(plan_.segments.begin(), plan_.segments.end(),
                         [&](const Segment& other) { return other.name == name; });
  }
  const Isometry3d& place() const { return places_.X_WO[plan_.place]; }
  /// Where the object was lowered to: its place, for an arm of six or more joints.
  const Isometry3d& put() const { return segment("lower").object_poses.back(); }
  static bool is_held(const Segment& part) {
    return part.name == "transfer" || part.name == "lower";
  }

  void fault(const Segment& part, std::size_t row, const std::string& what) {
    faults_.push_back(part.name + " row " + std::to_string(row) + ": " + what);
  }

  void check_rows() {
    VectorXd before = problem_.q_start;
    if ((plan_.segments[0].positions[0] - before).lpNorm<Eigen::Infinity>() > kSame)
      fault(plan_.segments[0], 0, "is not q_start");
    for (const Segment& part : plan_.segments) {
      scene::check_rows(problem_.robot, before, kSame, part.positions,
                        [&](std::size_t row, const std::string& what) { fault(part, row, what); });
      before = part.positions.back();
    }
  }

  /// The hand stays closed until it opens, with the arm at rest, and then stays open.
  void check_joints() {
    for (const Segment& part : plan_.segments) {
      const bool opens = part.name == "open";
      const bool leaves = part.name == "retreat" && !places_.way_out.empty();
      const VectorXd& hand = part.name == "retreat" ? places_.q_open : problem_.q_start;
      for (std::size_t row = 0; row < (leaves ? 1 : part.positions.size()); ++row) {
        const VectorXd& q = part.positions[row];
        if (opens && moved(problem_, true, part.positions[0], q) > kSame)
          fault(part, row, "the arm moves while the hand opens");
        if (!opens && moved(problem_, false, hand, q) > kSame)
          fault(part, row, "a joint outside the arm's group moves");
      }
    }
  }

  Isometry3d object_at(const VectorXd& q) const {
    const int frame = problem_.robot.frame(problem_.frame);
    const Isometry3d X_FO =
        problem_.robot.pose(frame, problem_.q_start).inverse() * problem_.object.X_WB;
    return problem_.robot.pose(frame, q) * X_FO;
  }

  void check_object_poses() {
    const Segment& lower = segment("lower");
    for (const Segment& part : plan_.segments) {
      for (std::size_t row = 0; row < part.object_poses.size(); ++row) {
        const Isometry3d expected = is_held(part) ? object_at(part.positions[row]) : put();
        if (!scene::is_same(part.object_poses[row], expected, kSame))
          fault(part, row,
                is_held(part) ? "the object moves relative to the hand"
                              : "the object is not at its place");
      }
    }
    // An arm of fewer than six joints may be off by as much as on a straight path.
    const bool may_lean = problem_.robot.group(problem_.arm).size() < 6;
    const double off = may_lean ? options_.tolerance : kSame,
                 lean = may_lean ? options_.angle_tolerance : kSame;
    if ((put().translation() - place().translation()).norm() > off ||
        angle_between(put().linear(), place().linear()) > lean)
      fault(lower, lower.positions.size() - 1, "the object is not at its place");
  }

  /// The object is lowered from `height`, and the hand ends `retreat` away.
  void check_lengths() {
    const Segment &lower = segment("lower"), &retreat = segment("retreat");
    const Vector3d down = lower.object_poses.front().translation() - place().translation();
    if (std::abs(down.dot(places_.normal_W) - options_.height) > options_.tolerance)
      fault(lower, 0, "the object is not lowered from options.height");
    const int frame = problem_.robot.frame(problem_.frame);
    const Isometry3d from = problem_.robot.pose(frame, retreat.positions.front());
    const Isometry3d to = problem_.robot.pose(frame, retreat.positions.back());
    if (!places_.way_out.empty()) return check_way_out(retreat, from.inverse() * to);
    if ((to.translation() - from.translation()).norm() < options_.retreat - options_.tolerance)
      fault(retreat, retreat.positions.size() - 1, "the hand is not options.retreat away");
    const StraightWay way{from, to};
    for (std::size_t row = 0; row < retreat.positions.size(); ++row) {
      const std::string off =
          way.fault_of(problem_.robot.pose(frame, retreat.positions[row]), options_);
      if (!off.empty()) fault(retreat, row, "the hand leaves its straight path");
    }
  }

  /// The hand ends as far from where it opened as its way out leads, with those fingers.
  void check_way_out(const Segment& retreat, const Isometry3d& X_FF) {
    const VectorXd &first = places_.way_out.front(), &last = places_.way_out.back();
    const int frame = problem_.robot.frame(problem_.frame);
    const Isometry3d asked =
        problem_.robot.pose(frame, first).inverse() * problem_.robot.pose(frame, last);
    const bool is_there = (X_FF.translation() - asked.translation()).norm() <= options_.tolerance &&
                          angle_between(X_FF.linear(), asked.linear()) <= options_.angle_tolerance;
    const std::size_t end = retreat.positions.size() - 1;
    if (!is_there) fault(retreat, end, "the hand is not at the end of its way out");
    if (moved(problem_, false, last, retreat.positions[end]) > kSame)
      fault(retreat, end, "the fingers are not as at the end of its way out");
  }

  StraightWay way_down() const {
    Isometry3d above = place();
    Vector3d up = places_.normal_W;
    if (!places_.down_O.isZero()) up = -(place().linear() * places_.down_O);
    above.pretranslate(up / up.dot(places_.normal_W) * options_.height);
    return {above, place()};
  }

  /// Angle between the object's vertical and that at the start or at the place, the smaller [rad].
  double tilt(const Isometry3d& X_WO) const {
    const Vector3d up_O = place().linear().transpose() * places_.normal_W;
    const Vector3d up = X_WO.linear() * up_O, before = problem_.object.X_WB.linear() * up_O;
    const auto angle = [&](const Vector3d& to) {
      return std::atan2(up.cross(to).norm(), up.dot(to));
    };
    return std::min(angle(before), angle(places_.normal_W));
  }

  void replay(const Segment& part, HeldReplay& world, std::optional<HeldReplay>& hanging) {
    std::size_t faulty_row = part.positions.size();  // one fault per row is enough
    const StraightWay down = way_down();
    scene::replay_rows(problem_.robot, part.positions, [&](std::size_t row, const VectorXd& q) {
      if (row == faulty_row) return;
      const Isometry3d X_WO = is_held(part) ? object_at(q) : put();
      auto touching = world.touching(q, X_WO);
      if (touching.empty() && hanging) touching = hanging->touching(q, hanging->object_at(q));
      std::string wrong = touching.empty() ? "" : "collision " + touching.front();
      if (part.name == "lower" && wrong.empty()) wrong = down.fault_of(X_WO, options_);
      if (part.name == "transfer" && wrong.empty() && tilt(X_WO) > options_.max_tilt + kSame)
        wrong = "the object tilts by more than options.max_tilt";
      if (wrong.empty()) return;
      faulty_row = row;
      fault(part, row, wrong);
    });
  }

  /// On each edge, the tilt changes by at most the object's turn.
  std::vector<scene::Doubt> prove_level(const HeldReplay& held, const Segment& part) const {
    std::vector<scene::Doubt> doubts;
    for (std::size_t edge = 0; edge + 1 < part.positions.size(); ++edge) {
      const VectorXd& from = part.positions[edge];
      const VectorXd step = part.positions[edge + 1] - from;
      const double rate = held.rates(step).turn;
      const auto slack = [&](double t0, const Isometry3d& a, double t1, const Isometry3d& b) {
        scene::Slack slack;
        slack.add(options_.max_tilt + kSame - (tilt(a) + tilt(b) + rate * (t1 - t0)) / 2,
                  "tilt of the object", "rad");
        return slack;
      };
      const auto doubt = scene::find_doubt(
          part.name, edge, [&](double t) { return held.object_at(from + t * step); }, slack);
      if (doubt) doubts.push_back(*doubt);
    }
    return doubts;
  }

  const Problem& problem_;
  const Places& places_;
  const Plan& plan_;
  const Options& options_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> check_places(const Problem& problem, const Plan& plan,
                                      const Options& options) {
  return PlaceExamination(problem, plan, options).run();
}

scene::EdgeCertificate certify_places(const Problem& problem, const Plan& plan,
                                      const Options& options) {
  return PlaceExamination(problem, plan, options).certify();
}

}  // namespace graspless::carry
