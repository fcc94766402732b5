// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/tester.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "clasp/stability/sequences.hpp"
#include "geometry/segment.hpp"

namespace graspless::clasp {

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

Crew& StabilityTester::crew(int threads) {
  if (threads_ != threads) crew_ = std::make_unique<Crew>(threads);
  threads_ = threads;
  return *crew_;
}

Hang StabilityTester::hang(const Eigen::VectorXd& q, const Eigen::Matrix3Xd& loop_O) {
  kinematics_.update(q);
  const Eigen::Matrix3Xd& nodes = kinematics_.nodes();
  const Eigen::Vector3d p_WC = kinematics_.center_W();
  const double reach = (nodes.colwise() - p_WC).colwise().norm().maxCoeff();
  const double escape = kinematics_.longest_curve() / 2;
  Hang result;
  result.X_WO = loads().hang(q, p_WC, reach, 2 * escape);
  const Eigen::Isometry3d moved = result.X_WO * X_OW_;
  const Eigen::Vector3d mean_W = problem_.X_WO * mean_of_surface(problem_.object);
  result.drop = mean_W.z() - (moved * mean_W).z();
  result.swing = Eigen::AngleAxisd(moved.linear()).angle();
  result.holds =
      geometry::distance_to_loop(result.X_WO * loop_O, p_WC) <= escape && result.drop < 2 * escape;
  return result;
}

/// Sets what the motors withstand.
void StabilityTester::load(const Eigen::VectorXd& q, const Eigen::Vector3d& p_WC,
                           const StabilityOptions& options, double enough, Stability& result) {
  const double reach = (kinematics_.nodes().colwise() - p_WC).colwise().norm().maxCoeff();
  const LoadEffort most = loads().effort(q, p_WC, reach, options.force, options.torque,
                                         options.force / enough, &crew(options.threads));
  result.withstands = std::min(options.force / most.effort, mechanics::kMaxForce);
  if (most.joint >= 0) result.opens_first = problem_.robot.joint_names()[most.joint];
}

Stability StabilityTester::test(const Eigen::VectorXd& q, const Eigen::Matrix3Xd& loop_O,
                                const StabilityOptions& options, int least_sequences,
                                double enough) {
  kinematics_.update(q);
  const Eigen::Vector3d p_WC = kinematics_.center_W();
  const double escape =
      options.escape_distance > 0 ? options.escape_distance : kinematics_.longest_curve() / 2;
  // At least half of each ball remains, so that the object cannot pass through thin fingers.
  const Eigen::ArrayXd whole = balls_.radii();
  const Eigen::VectorXd radii = (whole - options.penetration).max(whole / 2);
  const Eigen::Matrix3Xd p_CB_W = balls_.centers_W(kinematics_.poses()).colwise() - p_WC;
  bool is_first = true;  // its grid stays for the next tests; the others begin with a copy
  Spares<Walker> walkers([&] {
    auto grid = std::exchange(is_first, false)
                    ? clearance_
                    : std::make_shared<collision::Clearance>(clearance_->with_cells());
    collision::Clearance& clearance = *grid;
    return std::make_unique<Walker>(
        Walker{std::move(grid), {p_CB_W, radii, X_OW_.linear(), X_OW_ * p_WC, options, clearance}});
  });
  Stability result;
  walkers.stock(1);
  if (walkers.lend([](const Walker& walker) { return walker.walk.hits_at_start(); })) return result;
  const Sequences moved =
      run_sequences(loop_O, escape, options, least_sequences, walkers, crew(options.threads));
  result.escapes = moved.escapes;
  if (result.escapes == 0 && options.force > 0) load(q, p_WC, options, enough, result);
  const bool must_withstand = problem_.hand.fingers.size() == 1;
  result.secure = result.escapes == 0 && (!must_withstand || result.withstands >= options.force);
  result.margin = 1 - moved.farthest / escape;
  result.checks = moved.checks;
  return result;
}

}  // namespace graspless::clasp
