// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "graspless/carry/carry.hpp"

#include "scene/bands.hpp"
#include "scene/edges.hpp"
#include "scene/rows.hpp"

namespace graspless::carry {
namespace {

using Eigen::Isometry3d, Eigen::Quaterniond, Eigen::Vector3d, Eigen::VectorXd;
using Faults = std::vector<std::string>;

constexpr double kSame = 1e-6;  // [m, rad]

double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(a.transpose() * b)).angle();
}

/// Replays one plan and collects its faults.
class Examination {
 public:
  Examination(const Problem& problem, const Plan& plan, const Options& options)
      : problem_(problem),
        plan_(plan),
        options_(options),
        frame_(problem.robot.frame(problem.frame)),
        X_FO_(problem.robot.pose(frame_, problem.q_start).inverse() * problem.object.X_WB),
        replay_(problem.robot) {
    object_ = replay_.add(problem.object.name,
                          collision::Solid(problem.object.shapes, problem.object.name), false);
    exclude_hand();
    add_obstacles();
  }

  /// Proves what lies between the rows.
  scene::EdgeCertificate certify() {
    if (!has_shape()) throw std::invalid_argument("plan: cannot be certified; " + faults_.front());
    scene::EdgeCertificateMaker certificate;
    auto doubts = prove_straight();
    for (auto& doubt : prove_free()) doubts.push_back(std::move(doubt));
    certificate.add(carried().name, carried().positions, std::move(doubts));
    return certificate.take();
  }

  Faults run() {
    if (!has_shape()) return faults_;
    check_rows();
    check_still_joints();
    check_object_poses();
    replay();
    check_end();
    return faults_;
  }

 private:
  const Segment& carried() const { return plan_.segments[0]; }

  void fault(const std::string& where, const std::string& what) {
    faults_.push_back(where + ": " + what);
  }
  void fault(std::size_t row, const std::string& what) {
    fault("carry row " + std::to_string(row), what);
  }

  /// Stops testing the object against links that never move relative to it: those beyond the arm's
  /// last joint. They are found by moving each joint of the arm alone.
  void exclude_hand() {
    const robot::Robot& robot = problem_.robot;
    for (int link = 0; link < static_cast<int>(robot.frame_names().size()); ++link) {
      bool stays = true;
      for (const int joint : robot.group(problem_.arm)) {
        VectorXd q = problem_.q_start;
        const Isometry3d before = robot.pose(frame_, q).inverse() * robot.pose(link, q);
        q[joint] += 0.2;
        const Isometry3d after = robot.pose(frame_, q).inverse() * robot.pose(link, q);
        stays = stays && scene::is_same(before, after, kSame);
      }
      const int body = replay_.body_of(robot.frame_names()[static_cast<std::size_t>(link)]);
      if (stays && body >= 0) replay_.world().remove_pair(body, object_);
    }
  }

  void add_obstacles() {
    for (const Obstacle& obstacle : problem_.obstacles) {
      const int body = replay_.add(obstacle);
      replay_.world().add_pair(object_, body);
      for (const Rest& rest : problem_.rests_on) {
        if (rest.obstacle != obstacle.name) continue;
        replay_.world().allow_contact(object_, body, rest.normal_W, options_.contact_depth);
      }
    }
  }

  bool has_shape() {
    if (!plan_) {
      fault("plan", "not solved: " + plan_.reason);
      return false;
    }
    if (plan_.joint_names != problem_.robot.joint_names())
      fault("plan", "joint names are not the robot's");
    if (plan_.segments.size() != 1 || plan_.segments[0].name != "carry") {
      fault("plan", "must have exactly one segment, 'carry'");
      return false;
    }
    if (carried().positions.empty() || carried().positions.size() != carried().object_poses.size())
      fault("carry", "must have rows, and one object pose for each row");
    for (std::size_t row = 0; faults_.empty() && row < carried().positions.size(); ++row) {
      const VectorXd& q = carried().positions[row];
      const bool sound = q.size() == problem_.robot.dof() && q.allFinite() &&
                         carried().object_poses[row].matrix().allFinite();
      if (!sound) fault(row, "has the wrong size or a value that is not finite");
    }
    return faults_.empty();
  }

  void check_rows() {
    if ((carried().positions[0] - problem_.q_start).lpNorm<Eigen::Infinity>() > kSame)
      fault(0, "is not q_start");
    scene::check_rows(problem_.robot, problem_.q_start, kSame, carried().positions,
                      [&](std::size_t row, const std::string& what) { fault(row, what); });
  }

  void check_still_joints() {
    VectorXd moving = VectorXd::Zero(problem_.robot.dof());
    for (const int joint : problem_.robot.group(problem_.arm)) moving[joint] = 1;
    for (std::size_t row = 0; row < carried().positions.size(); ++row) {
      const VectorXd off = (carried().positions[row] - problem_.q_start)
                               .cwiseProduct(VectorXd::Ones(moving.size()) - moving);
      if (off.lpNorm<Eigen::Infinity>() > kSame)
        fault(row, "a joint outside the arm's group moves");
    }
  }

  Isometry3d object_at(const VectorXd& q) const { return problem_.robot.pose(frame_, q) * X_FO_; }

  void check_object_poses() {
    for (std::size_t row = 0; row < carried().positions.size(); ++row) {
      if (!scene::is_same(carried().object_poses[row], object_at(carried().positions[row]), kSame))
        fault(row, "the object moves relative to the hand");
    }
  }

  void replay() {
    std::size_t faulty_row = carried().positions.size();  // one fault per row is enough
    scene::replay_rows(problem_.robot, carried().positions,
                       [&](std::size_t row, const VectorXd& q) {
                         if (row == faulty_row) return;
                         const Isometry3d X_WO = object_at(q);
                         replay_.world().set_pose(object_, X_WO);
                         const auto touching = replay_.touching(q);
                         const std::string off = fault_of(deviation(X_WO));
                         if (touching.empty() && off.empty()) return;
                         faulty_row = row;
                         fault(row, touching.empty() ? off : "collision " + touching.front());
                       });
  }

  std::vector<scene::Doubt> prove_free() {
    scene::Companion object;
    object.body = object_;
    object.carrier = {frame_, {X_FO_.translation(), replay_.world().radius(object_)}};
    object.place = [&](std::size_t, double, const robot::Poses& X_WL) {
      replay_.world().set_pose(object_, X_WL[static_cast<std::size_t>(frame_)] * X_FO_);
    };
    return scene::EdgeProver(carried().name, carried().positions, replay_, object).run();
  }

  /// Bounds deviation() on each edge: its distance is a convex function of the object's place, and
  /// its angle changes by at most the turns of the object and of the pose on the straight path.
  std::vector<scene::Doubt> prove_straight() const {
    const robot::Robot& robot = problem_.robot;
    const double length =
        (problem_.X_WO_goal.translation() - problem_.object.X_WB.translation()).norm();
    const double turn = angle_between(problem_.object.X_WB.linear(), problem_.X_WO_goal.linear());
    std::vector<scene::Doubt> doubts;
    for (std::size_t edge = 0; edge + 1 < carried().positions.size(); ++edge) {
      const VectorXd& from = carried().positions[edge];
      const VectorXd step = carried().positions[edge + 1] - from;
      const scene::FrameRates rates = scene::frame_rates(robot, frame_, step, X_FO_.translation());
      const auto slack = [&](double t0, const Isometry3d& first, double t1,
                             const Isometry3d& last) {
        const double width = t1 - t0, bend = rates.curvature * width * width;
        const Deviation a = deviation(first), b = deviation(last);
        const double path = (last.translation() - first.translation()).norm() + bend / 2;
        const double turned =
            rates.turn * width + (is_turn() ? rates.turn * width : turn * path / length);
        scene::Slack slack;
        slack.add(options_.tolerance + kSame - std::max(a.distance, b.distance) - bend / 8 -
                      (is_turn() && width > 0 ? length : 0),
                  "distance of the object from its straight path");
        slack.add(options_.angle_tolerance + kSame - (a.angle + b.angle + turned) / 2,
                  "turn of the object off its straight path", "rad");
        return slack;
      };
      const auto doubt = scene::find_doubt(
          carried().name, edge, [&](double t) { return object_at(from + t * step); }, slack);
      if (doubt) doubts.push_back(*doubt);
    }
    return doubts;
  }

  /// The object's distance [m] and angle [rad] from its straight path.
  struct Deviation {
    double distance, angle;
  };

  bool is_turn() const {
    return (problem_.X_WO_goal.translation() - problem_.object.X_WB.translation()).norm() <= 1e-6;
  }

  Deviation deviation(const Isometry3d& X_WO) const {
    const Isometry3d &start = problem_.object.X_WB, &goal = problem_.X_WO_goal;
    const Vector3d a = start.translation(), b = goal.translation(), p = X_WO.translation();
    const Quaterniond from(start.linear()), to(goal.linear()), now(X_WO.linear());
    double s =
        is_turn() ? fraction_turned(from, to, now) : (p - a).dot(b - a) / (b - a).squaredNorm();
    s = std::clamp(s, 0.0, 1.0);
    const Quaterniond wanted = from.slerp(s, to);
    const double twist =
        is_turn() ? 0 : twist_about((b - a).normalized(), now * wanted.conjugate());
    const double kept = std::clamp(twist, -options_.max_twist, options_.max_twist);
    const Eigen::AngleAxisd turned(is_turn() ? 0 : kept,
                                   is_turn() ? Vector3d::UnitX() : Vector3d((b - a).normalized()));
    return {(p - a - s * (b - a)).norm(), now.angularDistance(Quaterniond(turned) * wanted)};
  }

  /// Describes how a pose of the object leaves the straight path; empty if it does not.
  std::string fault_of(const Deviation& off) const {
    std::ostringstream text;
    if (off.distance > options_.tolerance + kSame) {
      text << "the object is " << off.distance << " m off its straight path";
    } else if (off.angle > options_.angle_tolerance + kSame) {
      text << "the object is turned by " << off.angle << " rad off its straight path";
    }
    return text.str();
  }

  static double fraction_turned(const Quaterniond& from, const Quaterniond& to,
                                const Quaterniond& now) {
    const double whole = from.angularDistance(to);
    return now.angularDistance(from) / whole;
  }

  /// Angle of the rotation about `axis` that is nearest to `turn`, in (-pi, pi] [rad].
  static double twist_about(const Vector3d& axis, const Quaterniond& turn) {
    const double angle = 2 * std::atan2(turn.vec().dot(axis), turn.w());
    return std::atan2(std::sin(angle), std::cos(angle));
  }

  void check_end() {
    const Vector3d missing =
        carried().object_poses.back().translation() - problem_.X_WO_goal.translation();
    const double turned =
        angle_between(carried().object_poses.back().linear(), problem_.X_WO_goal.linear());
    const double allowed = options_.max_twist + options_.angle_tolerance;
    if (missing.norm() > options_.tolerance || turned > allowed + kSame)
      fault(carried().positions.size() - 1, "the object is not at its goal");
  }

  const Problem& problem_;
  const Plan& plan_;
  const Options& options_;
  int frame_;
  Isometry3d X_FO_;  // the object in the frame that holds it
  scene::Replay replay_;
  int object_ = -1;
  Faults faults_;
};

}  // namespace

std::vector<std::string> check(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem);
  validate(options);
  return Examination(problem, plan, options).run();
}

scene::EdgeCertificate certify(const Problem& problem, const Plan& plan, const Options& options) {
  validate(problem);
  validate(options);
  return Examination(problem, plan, options).certify();
}

}  // namespace graspless::carry
