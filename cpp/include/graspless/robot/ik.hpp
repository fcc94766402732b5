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
/// Has two solvers. The closed form serves six revolute joints with a spherical wrist (or shoulder)
/// whose other three joints have two axes that meet or axes 2 and 3 parallel (KUKA, ABB, Fanuc,
/// Staubli), and six with parallel axes 2 to 4 and axes 5 and 6 that meet (Universal Robots). It
/// serves seven revolute joints if this holds once one of them is given: the third where both
/// shoulder and wrist are spherical (iiwa, WAM), otherwise the last (Panda, xArm7) or the first.
/// Offsets up to 1 cm or 0.01 rad from such a geometry are allowed for: Newton's method polishes
/// these solutions. Every other chain uses damped least squares with joint limits, restarts, and a
/// null-space pull to the middle of the limits.
class GRASPLESS_API Ik {
 public:
  /// A copy shares all data. Moving copies, so that no object is left empty.
  Ik(const Ik&) = default;
  Ik& operator=(const Ik&) = default;

  static constexpr double kMostLean = 0.1;  ///< [rad]

  struct Options {
    double tolerance = 1e-9;  ///< largest pose error of an answer [m, rad]
    int max_iterations = 60;  ///< iterations of damped least squares per attempt
    int restarts = 12;        ///< random restarts of damped least squares in solve_all()
    int free_samples = 16;    ///< values of the free joint that solve_all() tries in closed form,
                              ///< at most 10000
    /// Angle error that is allowed where damped least squares cannot turn the frame further, as
    /// with five joints; at most kMostLean [rad].
    double lean = 0;
    bool whole_turns = true;  ///< return a solution's copies a whole turn of a joint away, too;
                              ///< otherwise of each solution the one nearest to the given q
  };

  /// `group`: joint indices of the chain, from the base outwards. Throws std::invalid_argument when
  /// they are not all between the root and `frame`, or occur twice, or an option is out of range.
  Ik(const Robot& robot, int frame, std::vector<int> group, const Options& options);
  Ik(const Robot& robot, int frame, std::vector<int> group)
      : Ik(robot, frame, std::move(group), Options{}) {}

  bool is_closed_form() const;
  const std::vector<int>& group() const;
  /// Joint index whose value solve_free() takes. Nothing for six joints, or without closed form.
  std::optional<int> free_joint() const;

  /// Finds all solutions within the limits for one value of free_joint(); without one, all
  /// solutions, and `value` is ignored. There are at most 8, and their copies. `q` gives the joints
  /// outside the group, and the angles that a solution leaves arbitrary. Writes configurations of
  /// all joints to the first columns of `solutions` and returns their number. Keep `solutions`
  /// between calls to avoid allocation: it never shrinks. Throws std::logic_error for a chain
  /// without closed form.
  int solve_free(const Eigen::Isometry3d& X_WF, double value, const Eigen::VectorXd& q,
                 Eigen::MatrixXd& solutions) const;
  /// Same, but appends the solutions to a vector.
  void solve_free(const Eigen::Isometry3d& X_WF, double value, const Eigen::VectorXd& q,
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
