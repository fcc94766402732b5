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

/// Inverse kinematics of one frame with the joints of one serial group; all other joints stay as
/// given.
///
/// Has two solvers. The closed form serves seven-joint arms whose first three axes meet in a point
/// and whose last three do too, such as the Barrett WAM; the elbow may be offset. It uses Paden and
/// Kahan's subproblems, with the third joint as free parameter. Every other chain uses damped least
/// squares with joint limits, restarts, and a null-space pull to the middle of the limits. KDL's
/// own solver is never called: it aborts in one process with Debian's OMPL (docs/architecture.md).
class GRASPLESS_API Ik {
 public:
  struct Options {
    double tolerance = 1e-9;  ///< largest pose error of an answer [m, rad]
    int max_iterations = 60;  ///< iterations of damped least squares per attempt
    int restarts = 12;        ///< random restarts of damped least squares in solve_all()
    int free_samples = 16;    ///< values of the free joint that solve_all() tries in closed form
  };

  /// `group`: joint indices of the chain, from the base outwards. Throws std::invalid_argument when
  /// they are not all between the root and `frame`.
  Ik(const Robot& robot, int frame, std::vector<int> group, const Options& options);
  Ik(const Robot& robot, int frame, std::vector<int> group)
      : Ik(robot, frame, std::move(group), Options{}) {}

  bool is_closed_form() const;
  const std::vector<int>& group() const;

  /// Finds all solutions within the limits for one value of the free joint, the third of the group:
  /// at most 8, and their copies a whole turn of a joint away. `q` gives the joints outside the
  /// group, and the angles that a solution leaves arbitrary. Writes configurations of all joints to
  /// the first columns of `solutions` and returns their number. Keep `solutions` between calls to
  /// avoid allocation: it never shrinks. Throws std::logic_error for a chain without closed form.
  int solve_free(const Eigen::Isometry3d& X_WF, double free_joint, const Eigen::VectorXd& q,
                 Eigen::MatrixXd& solutions) const;
  /// Same, but appends the solutions to a vector.
  void solve_free(const Eigen::Isometry3d& X_WF, double free_joint, const Eigen::VectorXd& q,
                  std::vector<Eigen::VectorXd>& solutions) const;

  /// Returns the solutions found on all branches, without duplicates, nearest to `q` first. Uses
  /// the closed form at samples of the free joint (first its value in `q`), or damped least squares
  /// from `q` and from random restarts. Deterministic in `rng`.
  std::vector<Eigen::VectorXd> solve_all(const Eigen::Isometry3d& X_WF, const Eigen::VectorXd& q,
                                         std::mt19937_64& rng) const;

  /// Returns the solution that continues from `q`: damped least squares without restarts, so that
  /// small motions of X_WF give small motions of q. Returns nothing if it does not converge within
  /// the limits.
  std::optional<Eigen::VectorXd> solve_near(const Eigen::Isometry3d& X_WF,
                                            const Eigen::VectorXd& q) const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace graspless::robot
