// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/search/reachability.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <random>
#include <sstream>
#include <stdexcept>

#include "graspless/robot/ik.hpp"
#include "graspless/watch.hpp"

#include "clasp/hand/kinematics.hpp"
#include "clasp/hand/reach.hpp"
#include "clasp/search/targets.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kTargets = 8, kAngles = 6;  // on all loops together; about the tangent of a target
constexpr int kSamples = 2000;            // configurations that tell how far the arm reaches

/// Axes forward, sideways and across as columns.
Matrix3d axes(const Vector3d& forward, const Vector3d& sideways) {
  Matrix3d R;
  R << forward, sideways, forward.cross(sideways);
  return R;
}

/// Poses of the palm with the open hand around a target, at even angles about its tangent.
std::vector<Isometry3d> poses_around(const geometry::ClaspTarget& target_W, const Hand& hand,
                                     const Vector3d& center_H) {
  const Vector3d u = target_W.tangent.unitOrthogonal(), v = target_W.tangent.cross(u);
  std::vector<Isometry3d> poses;
  for (int i = 0; i < kAngles; ++i) {
    const double angle = 2 * M_PI * i / kAngles;
    const Vector3d forward = std::cos(angle) * u + std::sin(angle) * v;
    for (const double sign : {1.0, -1.0}) {
      Isometry3d X_WH = Isometry3d::Identity();
      X_WH.linear() = axes(forward, sign * target_W.tangent) *
                      axes(hand.forward_H, hand.sideways_H).transpose();
      X_WH.translation() = target_W.point - X_WH.linear() * center_H;
      poses.push_back(X_WH);
    }
  }
  return poses;
}

std::vector<Isometry3d> palm_poses(const Problem& problem, const VectorXd& q) {
  HandKinematics kinematics(problem.robot, problem.hand);
  kinematics.update(q);
  const int frame = problem.robot.frame(problem.hand.frame);
  const Isometry3d X_HW = problem.robot.pose(frame, q).inverse();
  const Eigen::Matrix3Xd nodes_H = X_HW * kinematics.nodes();
  const Vector3d center_H = (nodes_H.rowwise().minCoeff() + nodes_H.rowwise().maxCoeff()) / 2;
  const std::vector<int> loops = allowed_loops(problem);
  const int count = std::max(1, kTargets / static_cast<int>(loops.size()));
  std::vector<Isometry3d> poses;
  for (std::size_t i = 0; i < loops.size() && poses.size() < 2 * kTargets * kAngles; ++i) {
    poll();
    const auto& loop = problem.object.loops().found[loops[i]];
    for (const geometry::ClaspTarget& target : geometry::clasp_targets(loop.points, count)) {
      const geometry::ClaspTarget target_W{problem.X_WO * target.point,
                                           problem.X_WO.linear() * target.tangent};
      const auto around = poses_around(target_W, problem.hand, center_H);
      poses.insert(poses.end(), around.begin(), around.end());
    }
  }
  return poses;
}

/// Largest distance of the palm from the base in random configurations of the arm [m].
double farthest(const Problem& problem, VectorXd q, const Vector3d& base_W) {
  const robot::Robot& robot = problem.robot;
  const int frame = robot.frame(problem.hand.frame);
  std::mt19937_64 rng(1);
  double most = 0;
  for (int i = 0; i < kSamples; ++i) {
    poll();
    for (const int joint : robot.group(problem.hand.arm)) {
      q[joint] =
          std::uniform_real_distribution<double>(robot.lower()[joint], robot.upper()[joint])(rng);
    }
    most = std::max(most, (robot.pose(frame, q).translation() - base_W).norm());
  }
  return most;
}

}  // namespace

std::string describe_reach(const Problem& problem) {
  VectorXd q = problem.q_start;
  const VectorXd open = problem.robot.state(problem.hand.open);
  for (const int joint : problem.robot.group(problem.hand.hand)) q[joint] = open[joint];
  const std::vector<Isometry3d> poses = palm_poses(problem, q);
  robot::Ik::Options options;
  options.restarts = 2;
  std::optional<robot::Ik> ik;
  try {
    ik.emplace(problem.robot, problem.robot.frame(problem.hand.frame),
               problem.robot.group(problem.hand.arm), options);
  } catch (const std::invalid_argument&) {
    return "";
  }
  const Vector3d base_W = arm_reach(problem.robot, problem.hand, q).base_W;
  const double reach = farthest(problem, q, base_W);
  std::mt19937_64 rng(1);
  std::size_t reached = 0, far = 0;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const Isometry3d& X_WH : poses) {
    poll();
    const double excess = (X_WH.translation() - base_W).norm() - reach;
    if (!ik->solve_all(X_WH, q, rng).empty()) {
      ++reached;
    } else if (excess > 0) {
      ++far;
      least = std::min(least, excess);
      most = std::max(most, excess);
    }
  }
  std::ostringstream out;
  out << std::fixed << std::setprecision(2) << "the arm reaches " << reached << " of "
      << poses.size() << " palm poses around the loops";
  if (far > 0) {
    const bool is_one = std::lround(100 * least) == std::lround(100 * most);
    out << "; " << far << " are ";
    if (!is_one) out << least << " to ";
    out << most << " m beyond the " << reach << " m from '" << problem.hand.frame
        << "' to the arm's base";
  }
  const std::size_t limited = poses.size() - reached - far;
  if (limited > 0) out << "; " << limited << " have no solution within the joint limits";
  return out.str();
}

}  // namespace graspless::clasp
