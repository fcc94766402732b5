// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Inverse kinematics of several fingertips at once (Levenberg and Marquardt's damping, limits by an
// active set), and the robot among planes, obstacles and the object.
#include "realize/hand.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include <Eigen/Cholesky>

#include "fingertip/model/screw.hpp"
#include "geometry/turn.hpp"

namespace graspless::realize {
namespace {

constexpr double kLongestStep = 0.3;    // of a joint in one iteration [rad or m]
constexpr double kLeastDamping = 1e-9;  // [m^2]
constexpr double kMostDamping = 1e3;

bool moves(const robot::Robot& robot, int frame, int joint) {
  const Eigen::VectorXd& lever = robot.reach(frame);
  return lever[joint] > 0;
}

// A half-space as a box [m]: wider than any robot reaches, thick enough that none steps through.
constexpr double kPlaneWidth = 20, kPlaneThickness = 1;

double span(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2) {
  return q1.size() == 0 ? 0 : (q2 - q1).lpNorm<Eigen::Infinity>();
}

/// Number of checks of the replay between two rows: half way and the end at least.
double looks(double length, double resolution) {
  return std::max(2.0, std::ceil(length / resolution - 1e-9));
}

/// A box that represents a half-space, its top face in the plane.
geometry::PlacedShape plane_box() {
  geometry::PlacedShape placed{geometry::Box{{kPlaneWidth, kPlaneWidth, kPlaneThickness}}};
  placed.X_BG = Eigen::Translation3d(0, 0, -kPlaneThickness / 2);
  return placed;
}

Eigen::Isometry3d plane_pose(const Plane& plane, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d n_W = plane.n_W.normalized();
  Eigen::Isometry3d X_WB;
  X_WB =
      Eigen::Translation3d(p_W + (plane.offset - n_W.dot(p_W)) * n_W) * geometry::turn_from_z(n_W);
  return X_WB;
}

std::vector<std::vector<int>> links_of_fingers(const robot::Robot& robot, const Carrier& carrier,
                                               const std::vector<int>& finger_of_fingertip) {
  std::vector<std::vector<int>> links(finger_of_fingertip.size());
  for (std::size_t tip = 0; tip < links.size(); ++tip) {
    auto& own = links[finger_of_fingertip[tip]];
    for (const std::string& link : carrier.links[tip]) own.push_back(robot.frame(link));
  }
  return links;
}

std::vector<int> frames_of_fingers(const robot::Robot& robot, const Carrier& carrier,
                                   const std::vector<int>& finger_of_fingertip) {
  std::vector<int> frames(finger_of_fingertip.size());
  for (std::size_t tip = 0; tip < frames.size(); ++tip) {
    frames[finger_of_fingertip[tip]] = robot.frame(carrier.fingertips[tip]);
  }
  return frames;
}

}  // namespace

TipIk::TipIk(const robot::Robot& robot, std::vector<int> frames)
    : robot_(robot), frames_(std::move(frames)) {
  for (int joint = 0; joint < robot_.dof(); ++joint) {
    const bool carries = std::any_of(frames_.begin(), frames_.end(),
                                     [&](int frame) { return moves(robot_, frame, joint); });
    if (carries) joints_.push_back(joint);
  }
}

const std::string& TipIk::fingertip(int finger) const {
  const auto frame = static_cast<std::size_t>(frames_[finger]);
  return robot_.frame_names()[frame];
}

Eigen::Isometry3d TipIk::pose(int finger, const Eigen::VectorXd& q) const {
  return robot_.pose(frames_[finger], q);
}

double TipIk::errors(const TipTargets& targets, const Eigen::VectorXd& q) {
  robot_.forward(q, X_WL_);
  error_.resize(3 * static_cast<Eigen::Index>(frames_.size()));
  Eigen::Index rows = 0;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if ((targets.held >> i & 1U) == 0) continue;
    const Eigen::Vector3d p_WT = X_WL_[frames_[i]].translation();
    error_.segment<3>(rows) = targets.p_WT.col(i) - p_WT;
    rows += 3;
  }
  error_.conservativeResize(rows);
  return error_.squaredNorm();
}

void TipIk::jacobians(const TipTargets& targets) {
  J_.resize(error_.size(), static_cast<Eigen::Index>(joints_.size()));
  J_turn_.resize(J_.rows(), J_.cols());
  Eigen::Index rows = 0;
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if ((targets.held >> i & 1U) == 0) continue;
    robot_.jacobian(frames_[i], X_WL_, J_frame_);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      const auto column = static_cast<Eigen::Index>(j);
      J_.block<3, 1>(rows, column) = J_frame_.block<3, 1>(0, joints_[j]);
      J_turn_.block<3, 1>(rows, column) = J_frame_.block<3, 1>(3, joints_[j]);
    }
    rows += 3;
  }
}

/// The damped step from q, with joints that would leave their limits taken out one after the other.
Eigen::VectorXd TipIk::step(const Eigen::VectorXd& q, double damping) {
  Eigen::MatrixXd J = J_;
  Eigen::VectorXd dq;
  for (std::size_t round = 0; round <= joints_.size(); ++round) {
    Eigen::MatrixXd A = J * J.transpose();
    A.diagonal().array() += damping;
    dq = J.transpose() * A.ldlt().solve(error_);
    bool stopped = false;
    for (Eigen::Index j = 0; j < dq.size(); ++j) {
      const int joint = joints_[j];
      const bool at_lower = dq[j] < 0 && q[joint] <= robot_.lower()[joint];
      const bool at_upper = dq[j] > 0 && q[joint] >= robot_.upper()[joint];
      if (!at_lower && !at_upper) continue;
      J.col(j).setZero();
      stopped = true;
    }
    if (!stopped) break;
  }
  const double longest = dq.size() == 0 ? 0 : dq.lpNorm<Eigen::Infinity>();
  return longest > kLongestStep ? Eigen::VectorXd(dq * (kLongestStep / longest)) : dq;
}

bool TipIk::solve(const TipTargets& targets, double tolerance, int max_iterations,
                  Eigen::VectorXd& q) {
  double damping = 1e-6;
  double now = errors(targets, q);
  const double enough = tolerance * tolerance;
  for (int i = 0; i < max_iterations && now > enough && damping < kMostDamping; ++i) {
    jacobians(targets);
    const Eigen::VectorXd next = with(q, step(q, damping));
    const double then = errors(targets, next);
    if (then < now) {
      q = next;
      now = then;
      damping = std::max(kLeastDamping, 0.1 * damping);
    } else {
      damping = std::max(1e-4, 10 * damping);
      errors(targets, q);  // the Jacobian is taken anew where q still is
    }
  }
  return now <= enough;
}

Eigen::VectorXd TipIk::with(const Eigen::VectorXd& q, const Eigen::VectorXd& dq) const {
  Eigen::VectorXd next = q;
  for (std::size_t j = 0; j < joints_.size(); ++j) next[joints_[j]] += dq[j];
  return robot_.clamp(next);
}

Eigen::VectorXd TipIk::step_along(const TipTargets& targets, const Eigen::Vector3d& turn_W,
                                  const Eigen::Matrix3Xd& n_W, const Eigen::VectorXd& q) {
  constexpr double kDamping = 1e-8, kTurnDamping = 1e-3;  // [m^2], [1]
  errors(targets, q);
  jacobians(targets);
  Eigen::VectorXd turns(error_.size());
  Eigen::Index rows = 0;
  for (Eigen::Index i = 0; i < n_W.cols(); ++i) {
    if ((targets.held >> i & 1U) == 0) continue;
    const Eigen::Matrix3d across =
        Eigen::Matrix3d::Identity() - n_W.col(i) * n_W.col(i).transpose();
    turns.segment<3>(rows) = across * turn_W;
    J_turn_.middleRows<3>(rows) = across * J_turn_.middleRows<3>(rows).eval();
    rows += 3;
  }
  Eigen::MatrixXd A = J_ * J_.transpose();
  A.diagonal().array() += kDamping;
  const Eigen::LDLT<Eigen::MatrixXd> solver(A);
  const Eigen::VectorXd to_targets = J_.transpose() * solver.solve(error_);
  const Eigen::MatrixXd free = J_turn_ - J_turn_ * J_.transpose() * solver.solve(J_);
  Eigen::MatrixXd B = free * free.transpose();
  B.diagonal().array() += kTurnDamping;
  const Eigen::VectorXd along = free.transpose() * B.ldlt().solve(turns - J_turn_ * to_targets);
  return with(q, to_targets + along);
}

std::pair<double, int> TipIk::miss(const TipTargets& targets, const Eigen::VectorXd& q) {
  errors(targets, q);
  std::pair<double, int> worst{0, -1};
  Eigen::Index rows = 0;
  for (int i = 0; i < static_cast<int>(frames_.size()); ++i) {
    if ((targets.held >> i & 1U) == 0) continue;
    const double distance = error_.segment<3>(rows).norm();
    if (worst.second < 0 || distance > worst.first) worst = {distance, i};
    rows += 3;
  }
  return worst;
}

HandScene::HandScene(const Problem& problem, const robot::Robot& robot,
                     std::vector<std::vector<int>> links, double allowance)
    : scene_(robot),
      links_(std::move(links)),
      allowance_(allowance),
      n_O_(3, static_cast<Eigen::Index>(links_.size())) {
  const Eigen::Vector3d p_WB = robot.X_WB().translation();
  for (const Plane& plane : problem.planes)
    scene_.add_obstacle(plane.name, {plane_box()}, plane_pose(plane, p_WB));
  for (const Obstacle& obstacle : problem.obstacles)
    scene_.add_obstacle(obstacle.label(), obstacle.solid(), obstacle.X_WB);
  object_ = scene_.add_object(problem.object.name(), problem.object.solid());
  n_O_.colwise() = Eigen::Vector3d::UnitZ();
}

void HandScene::set_contacts(const Eigen::Matrix3Xd& n_O, FingerMask touching) {
  n_O_ = n_O;
  touching_ = touching;
  allow();
}

void HandScene::place_object(const Eigen::Isometry3d& X_WO) {
  X_WO_ = X_WO;
  scene_.move_object(object_, X_WO);
  allow();
}

void HandScene::allow() {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Eigen::Vector3d out_W = -(X_WO_.linear() * n_O_.col(i));
    const double depth = (touching_ >> i & 1U) != 0 ? allowance_ : 0;
    for (const int link : links_[i]) {
      if (scene_.link_body(link) < 0) continue;
      scene_.world().allow_contact(scene_.link_body(link), object_, out_W, depth);
    }
  }
}

bool HandScene::is_motion_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2,
                               double row_step, double resolution) {
  constexpr double kRounding = 1 + 1e-12;
  const double length = span(q1, q2);
  if (length == 0) return scene_.is_free(q1);
  const double rows = std::ceil(length / row_step);
  const double steps = rows * looks(length / rows, resolution);
  return scene_.is_free(q1, q2, scene_.robot().step(q1, q2) / steps * kRounding);
}

bool HandScene::is_motion_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2,
                               const Eigen::Isometry3d& X_WO2, double resolution) {
  const Eigen::Isometry3d X_WO1 = X_WO_;
  const mechanics::Vector6d twist_O = fingertip::screw_between(X_WO1, X_WO2);
  const int steps = static_cast<int>(looks(span(q1, q2), resolution));
  for (int i = 1; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    place_object(fingertip::along_screw(X_WO1, twist_O, s));
    if (!scene_.is_free(q1 + s * (q2 - q1))) return false;
  }
  return true;
}

std::string HandScene::collision(const Eigen::VectorXd& q) {
  const auto [a, b] = scene_.collision(q);
  return a.empty() ? "" : "'" + a + "' touches '" + b + "'";
}

Hand::Hand(const Problem& problem, const robot::Robot& robot, const Carrier& carrier,
           const std::vector<int>& assignment, const RealizeOptions& given)
    : finger_of_fingertip(assignment),
      ik(robot, frames_of_fingers(robot, carrier, assignment)),
      scene(problem, robot, links_of_fingers(robot, carrier, assignment),
            contact_allowance(given.position_tolerance)),
      radius(problem.fingers.radius),
      options(given) {}

}  // namespace graspless::realize
