// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/export.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::robot {

/// Inverse kinematics of one frame by the joints of one serial group; all other joints stay as
/// given.
///
/// Two solvers behind one interface: closed form for a seven-joint arm whose first three and whose
/// last three axes each meet in a point (the Barrett WAM, although its elbow is offset), by Paden
/// and Kahan's subproblems with the third joint as free parameter; damped least squares with
/// limits, restarts and a null-space pull to the middle of the limits for any other chain. KDL's
/// own solver is never called: in one process with Debian's OMPL it aborts (docs/architecture.md).
class GRASPLESS_API Ik {
 public:
  struct Options {
    double tolerance = 1e-9;  ///< largest pose error of an answer [m, rad]
    int max_iterations = 60;  ///< of damped least squares, per attempt
    int restarts = 12;        ///< random seeds of damped least squares in solve_all()
    int free_samples = 16;    ///< values of the free joint tried in solve_all() by the closed form
  };

  /// `group`: joint indices of the chain, from the base outwards. Throws std::invalid_argument when
  /// they are not all between the root and `frame`.
  Ik(const Robot& robot, int frame, std::vector<int> group, const Options& options);
  Ik(const Robot& robot, int frame, std::vector<int> group)
      : Ik(robot, frame, std::move(group), Options{}) {}

  bool is_closed_form() const;
  const std::vector<int>& group() const;

  /// All solutions within the limits for one value of the free joint, the third of the group:
  /// closed form, at most 8 and their copies a whole turn of a joint away. `q` gives the values of
  /// the joints outside the group and decides where an angle is arbitrary; each answer is a whole
  /// configuration. Writes them to the first columns of `solutions` and returns how many; a matrix
  /// kept between calls is only ever grown, so that nothing is allocated. Throws std::logic_error
  /// for a chain without closed form.
  int solve_free(const Eigen::Isometry3d& X_WF, double free_joint, const Eigen::VectorXd& q,
                 Eigen::MatrixXd& solutions) const;
  /// The same, appended.
  void solve_free(const Eigen::Isometry3d& X_WF, double free_joint, const Eigen::VectorXd& q,
                  std::vector<Eigen::VectorXd>& solutions) const;

  /// All branches found: closed form over samples of the free joint (that of `q` first), or damped
  /// least squares from `q` and random restarts; duplicates removed, nearest to `q` first.
  /// Deterministic in rng.
  std::vector<Eigen::VectorXd> solve_all(const Eigen::Isometry3d& X_WF, const Eigen::VectorXd& q,
                                         std::mt19937_64& rng) const;

  /// The one solution that continues from `q`: damped least squares without restarts, so that small
  /// motions of X_WF give small motions of q. Nothing when it does not converge within the limits.
  std::optional<Eigen::VectorXd> solve_near(const Eigen::Isometry3d& X_WF,
                                            const Eigen::VectorXd& q) const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace graspless::robot
