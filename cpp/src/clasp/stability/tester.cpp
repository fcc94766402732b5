// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/tester.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "graspless/watch.hpp"

#include "clasp/stability/walk.hpp"

namespace graspless::clasp {
namespace {

/// Half the length of the longest curve [m]: the largest possible distance of a corner from the
/// curve's centre.
double half_length(const HandKinematics& hand) {
  double longest = 0;
  for (int i = 0; i < hand.num_curves(); ++i) {
    const Eigen::Matrix3Xd curve = hand.curve_points(i);
    const Eigen::Index sides = curve.cols() - 1;
    longest =
        std::max(longest, (curve.rightCols(sides) - curve.leftCols(sides)).colwise().norm().sum());
  }
  return longest / 2;
}

double distance_to_loop(const Eigen::Matrix3Xd& loop, const Eigen::Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < loop.cols(); ++i) {
    const Eigen::Vector3d a = loop.col(i), side = loop.col((i + 1) % loop.cols()) - a;
    const double along = (p - a).dot(side) / std::max(side.squaredNorm(), 1e-18);
    least = std::min(least, (p - a - std::clamp(along, 0.0, 1.0) * side).squaredNorm());
  }
  return std::sqrt(least);
}

Eigen::Vector3d random_direction(std::mt19937_64& rng) {
  std::uniform_real_distribution<double> side(-1, 1);
  while (true) {
    const Eigen::Vector3d v(side(rng), side(rng), side(rng));
    const double square = v.squaredNorm();
    if (square <= 1 && square > 1e-4) return v / std::sqrt(square);
  }
}

}  // namespace

StabilityTester::StabilityTester(const Problem& problem)
    : problem_(problem),
      X_OW_(problem.X_WO.inverse()),
      kinematics_(problem.robot, problem.hand),
      balls_(problem.robot),
      clearance_(problem.object.borrow_outer_clearance()) {}

const LoadTester& StabilityTester::loads() {
  if (!load_) load_.emplace(problem_);
  return *load_;
}

Hang StabilityTester::hang(const Eigen::VectorXd& q, const Eigen::Matrix3Xd& loop_O) {
  kinematics_.update(q);
  const Eigen::Matrix3Xd& nodes = kinematics_.nodes();
  const Eigen::Vector3d p_WC = (nodes.rowwise().minCoeff() + nodes.rowwise().maxCoeff()) / 2;
  const double reach = (nodes.colwise() - p_WC).colwise().norm().maxCoeff();
  const double escape = half_length(kinematics_);
  Hang result;
  result.X_WO = loads().hang(q, p_WC, reach, 2 * escape);
  const Eigen::Isometry3d moved = result.X_WO * X_OW_;
  const Eigen::Vector3d mean_W = problem_.X_WO * mean_of_surface(problem_.object);
  result.drop = mean_W.z() - (moved * mean_W).z();
  result.swing = Eigen::AngleAxisd(moved.linear()).angle();
  result.holds = distance_to_loop(result.X_WO * loop_O, p_WC) <= escape && result.drop < 2 * escape;
  return result;
}

/// Sets what the motors withstand.
void StabilityTester::load(const Eigen::VectorXd& q, const Eigen::Vector3d& p_WC,
                           const StabilityOptions& options, double enough, Stability& result) {
  const double reach = (kinematics_.nodes().colwise() - p_WC).colwise().norm().maxCoeff();
  const LoadEffort most =
      loads().effort(q, p_WC, reach, options.force, options.torque, options.force / enough);
  result.withstands = std::min(options.force / most.effort, mechanics::kMaxForce);
  if (most.joint >= 0)
    result.opens_first = problem_.robot.joint_names()[static_cast<std::size_t>(most.joint)];
}

Stability StabilityTester::test(const Eigen::VectorXd& q, const Eigen::Matrix3Xd& loop_O,
                                const StabilityOptions& options, int least_sequences,
                                double enough) {
  kinematics_.update(q);
  const Eigen::Matrix3Xd& nodes = kinematics_.nodes();
  const Eigen::Vector3d p_WC = (nodes.rowwise().minCoeff() + nodes.rowwise().maxCoeff()) / 2;
  const double escape =
      options.escape_distance > 0 ? options.escape_distance : half_length(kinematics_);
  // No move needs to be longer than the diameter of the escape sphere, or than a full turn.
  const int max_steps = static_cast<int>(std::ceil(2 * escape / options.step));
  const int max_turns = static_cast<int>(std::ceil(2 * M_PI / options.turn));

  // At least half of each ball remains, so that the object cannot pass through thin fingers.
  const Eigen::ArrayXd whole = balls_.radii();
  const Eigen::VectorXd radii = (whole - options.penetration).max(whole / 2);
  ObjectWalk walk(balls_.centers_W(kinematics_.poses()).colwise() - p_WC, radii, X_OW_.linear(),
                  X_OW_ * p_WC, options, *clearance_);
  Stability result;
  if (walk.hits_at_start()) return result;
  double farthest = 0;
  std::mt19937_64 rng(options.seed);
  for (int sequence = 0; sequence < options.sequences; ++sequence) {
    if (result.escapes > 0 && sequence == least_sequences) break;
    walk.reset();
    double distance = distance_to_loop(loop_O, walk.p_OC());
    for (int move = 0; move < options.moves && distance <= escape; ++move) {
      poll();
      if (move % 2 == 0) {
        walk.translate(random_direction(rng), max_steps);
        distance = distance_to_loop(loop_O, walk.p_OC());
        farthest = std::max(farthest, distance);
      } else {
        walk.rotate(random_direction(rng), max_turns);
      }
    }
    result.escapes += distance > escape;
  }
  if (result.escapes == 0 && options.force > 0) load(q, p_WC, options, enough, result);
  const bool must_withstand = problem_.hand.fingers.size() == 1;
  result.secure = result.escapes == 0 && (!must_withstand || result.withstands >= options.force);
  result.margin = 1 - farthest / escape;
  result.checks = walk.steps();
  return result;
}

}  // namespace graspless::clasp
