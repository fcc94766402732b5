// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/thread_search.hpp"

#include <algorithm>
#include <cmath>

#include "graspless/planning/free_path.hpp"
#include "graspless/watch.hpp"

#include "clasp/hand/palm.hpp"
#include "clasp/parameters.hpp"
#include "clasp/search/hole.hpp"
#include "planning/joints.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kSamplesPerCycle = 50;
constexpr double kTilt = 0.35;      // of a finger in the hole, largest standard deviation [rad]
constexpr double kAside = 0.25;     // from the hole's centre, the same, relative to its width
constexpr double kRetreat = 0.005;  // step of the way out of the hole [m]
constexpr double kRoom = 0.02;      // between finger and hole at the end of the way out [m]
constexpr double kJump = 0.3;       // longer steps have left the branch of the arm [rad]
constexpr int kIterations = 500;    // of the search for a path to the hole

robot::Ik arm_ik(const Problem& problem) {
  robot::Ik::Options options;
  options.restarts = 1;
  options.free_samples = 4;
  return {problem.robot, problem.robot.frame(problem.hand.frame),
          problem.robot.group(problem.hand.arm), options};
}

/// Unit normal of the area that a closed polyline spans.
Vector3d normal_of(const Eigen::Matrix3Xd& loop) {
  Vector3d area = Vector3d::Zero();
  for (Eigen::Index i = 0; i < loop.cols(); ++i)
    area += (loop.col(i) - loop.col(0)).cross(loop.col((i + 1) % loop.cols()) - loop.col(0));
  return area.norm() > 0 ? area.normalized() : Vector3d::UnitZ();
}

}  // namespace

ThreadSearch::ThreadSearch(Query& query, const LoopTask& task, const VectorXd& q_start)
    : ClaspSearch(query, task),
      q_start_(q_start),
      ik_(arm_ik(query.problem)),
      palm_(query.problem.robot.frame(query.problem.hand.frame)),
      normal_W_(normal_of(task.points_W)) {
  const Hand& hand = query.problem.hand;
  digits_ = {digit(hand.fingers.front()), digit(hand.thumb)};
  const Hole hole = widest_place(query.problem.object, task.loop);
  center_W_ = query.problem.X_WO * hole.center_O;
  width_ = hole.width;
}

ThreadSearch::Digit ThreadSearch::digit(const Finger& finger) const {
  const robot::Robot& robot = query_.problem.robot;
  Digit digit{finger.nodes[finger.nodes.size() - 2], finger.nodes.back(), {}};
  const auto tip_H = [&](const VectorXd& q) -> Vector3d {
    return robot.pose(palm_, q).inverse() * node_position(robot, digit.tip, q);
  };
  for (const int joint : robot.group(query_.problem.hand.hand)) {
    VectorXd moved = q_start_;
    moved[joint] += 0.1;
    if ((tip_H(moved) - tip_H(q_start_)).norm() > 1e-6) digit.joints.push_back(joint);
  }
  return digit;
}

bool ThreadSearch::cycle() {
  if (samples_ == 0) ++effort_.cycles;
  while (samples_ < kSamplesPerCycle && !query_.clock.is_out()) {
    ++samples_;
    if (sample()) return true;
  }
  samples_ = 0;
  return false;
}

/// Draws a configuration with a digit in the hole. Returns false if it is not free or not linked.
bool ThreadSearch::sample() {
  poll();
  const robot::Robot& robot = query_.problem.robot;
  const VectorXd &open = robot.state(query_.problem.hand.open),
                 &closed = robot.state(query_.problem.hand.closed);
  std::uniform_real_distribution<double> part(0, 1);
  const Digit& digit = digits_[query_.rng() % digits_.size()];
  VectorXd q = q_start_;
  for (const int joint : digit.joints) {  // near the closed state, where the others meet it
    const double left = part(query_.rng);
    q[joint] = open[joint] + (1 - left * left) * (closed[joint] - open[joint]);
  }
  robot.forward(q, X_WL_);
  const Isometry3d X_WH = placed_W(digit);
  for (const VectorXd& solution : ik_.solve_all(X_WH, q, query_.rng)) {
    if (!query_.free.is_free(solution)) continue;
    if (!is_linked(solution)) return false;
    q_ = solution;
    return true;
  }
  return false;
}

Vector3d ThreadSearch::in_palm(const CurveNode& node) const {
  const auto link = static_cast<std::size_t>(query_.problem.robot.frame(node.link));
  return X_WL_[palm_].inverse() * (X_WL_[link] * node.p_L);
}

/// Draws a pose of the palm in which a point of the digit is near the hole's centre.
Isometry3d ThreadSearch::placed_W(const Digit& digit) {
  std::mt19937_64& rng = query_.rng;
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> part(0, 1);
  const double loose = part(rng);  // small for a narrow hole, large where the finger fits askew
  const auto deviation = [&]() -> Vector3d {
    return loose * Vector3d{normal(rng), normal(rng), normal(rng)};  // from left to right
  };
  const Vector3d tip_H = in_palm(digit.tip), along_H = tip_H - in_palm(digit.before);
  const double side = rng() % 2 == 0 ? 1 : -1;
  beyond_ = part(rng) * along_H.norm();
  along_W_ = (side * normal_W_ + kTilt * deviation()).normalized();
  const Vector3d in_hole_H = tip_H - beyond_ * along_H.normalized();
  Isometry3d X_WH = Isometry3d::Identity();
  X_WH.linear() = (Eigen::AngleAxisd(2 * M_PI * part(rng), along_W_) *
                   Eigen::Quaterniond::FromTwoVectors(along_H, along_W_))
                      .toRotationMatrix();
  X_WH.translation() = center_W_ + kAside * width_ * deviation() - X_WH.linear() * in_hole_H;
  return X_WH;
}

/// Path of the palm back along the digit, as far as it is free, from the sample.
planning::Path ThreadSearch::way_out() {
  const robot::Robot& robot = query_.problem.robot;
  const Isometry3d X_WH = robot.pose(palm_, q_);
  const double length = beyond_ + 2 * finger_radius(robot, query_.problem.hand) + kRoom;
  planning::Path path{q_};
  for (double back = kRetreat; back < length; back += kRetreat) {
    const auto next = ik_.solve_near(Eigen::Translation3d(-back * along_W_) * X_WH, path.back());
    if (!next || robot.step(path.back(), *next) > kJump ||
        !query_.is_motion_free(path.back(), *next))
      break;
    path.push_back(*next);
  }
  return path;
}

bool ThreadSearch::connect(planning::Path& reach) {
  const robot::Robot& robot = query_.problem.robot;
  VectorXd shaped = q_start_;  // the hand as in the sample
  for (const int joint : robot.group(query_.problem.hand.hand)) shaped[joint] = q_[joint];
  if (!query_.is_motion_free(q_start_, shaped)) return false;
  const planning::Joints joints{robot.group(query_.problem.hand.arm), shaped};
  const planning::FreeSpace space{
      joints.part(robot.lower()), joints.part(robot.upper()),
      [&](const VectorXd& arm) { return query_.free.is_free(joints.full(arm)); },
      [&](const VectorXd& a, const VectorXd& b) {
        return query_.is_motion_free(joints.full(a), joints.full(b));
      },
      [&] { return query_.clock.is_out(); }};
  const planning::Path out = way_out();
  const auto arm = planning::find_free_path(space, joints.part(shaped), joints.part(out.back()),
                                            kIterations, query_.rng);
  if (!arm) return false;
  planning::Path path{q_start_};
  for (const VectorXd& q : *arm) path.push_back(joints.full(q));
  path.insert(path.end(), out.rbegin() + 1, out.rend());
  reach.insert(reach.begin(), path.begin(), path.end() - 1);  // which is the sample
  set_tree(reach);
  return true;
}

/// The path as a tree without branches.
void ThreadSearch::set_tree(const planning::Path& reach) {
  tree_ = {};
  tree_.p_W.resize(3, static_cast<Eigen::Index>(reach.size()));
  for (std::size_t i = 0; i < reach.size(); ++i) {
    const int node = static_cast<int>(i);
    tree_.p_W.col(node) = project(reach[i]).head<3>();
    tree_.parents.push_back(std::max(0, node - 1));
    tree_.path.push_back(node);
  }
  effort_.nodes += static_cast<std::int64_t>(reach.size());
}

}  // namespace graspless::clasp
