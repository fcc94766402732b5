// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include <Eigen/Geometry>

#include "graspless/clasp/problem.hpp"
#include "graspless/clasp/stability.hpp"
#include "graspless/collision/clearance.hpp"

#include "clasp/hand/kinematics.hpp"
#include "clasp/stability/balls.hpp"
#include "clasp/stability/load.hpp"
#include "crew.hpp"

namespace graspless::clasp {

/// Stability test for many configurations of one problem. Not thread-safe.
class StabilityTester {
 public:
  explicit StabilityTester(const Problem& problem);

  /// Runs the test for a loop, 3 x n in O [m]. q and the options must be valid.
  Stability test(const Eigen::VectorXd& q, const Eigen::Matrix3Xd& loop_O,
                 const StabilityOptions& options) {
    return test(q, loop_O, options, options.sequences, 0);
  }
  /// Same, but ends with the first sequence if the loop escapes in it, or with the first load that
  /// shows that the clasp withstands less than `enough` [N].
  Stability test_quickly(const Eigen::VectorXd& q, const Eigen::Matrix3Xd& loop_O,
                         const StabilityOptions& options, double enough) {
    return test(q, loop_O, options, 1, enough);
  }

  /// How the object hangs; see find_hang(). q must be valid.
  Hang hang(const Eigen::VectorXd& q, const Eigen::Matrix3Xd& loop_O);

 private:
  Stability test(const Eigen::VectorXd& q, const Eigen::Matrix3Xd& loop_O,
                 const StabilityOptions& options, int least_sequences, double enough);
  const LoadTester& loads();
  Crew& crew(int threads);
  void load(const Eigen::VectorXd& q, const Eigen::Vector3d& p_WC, const StabilityOptions& options,
            double enough, Stability& result);

  Problem problem_;
  Eigen::Isometry3d X_OW_;
  HandKinematics kinematics_;
  LinkBalls balls_;
  std::shared_ptr<collision::Clearance> clearance_;
  std::optional<LoadTester> load_;  // made with the first load
  std::unique_ptr<Crew> crew_;      // made with the first test
  int threads_ = 0;                 // of it
};

}  // namespace graspless::clasp
