// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The object's moves against a hand that stands still.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "graspless/clasp/stability.hpp"
#include "graspless/collision/clearance.hpp"

namespace graspless::clasp {

/// Moves the object until it hits one of the balls: seen from the object, the balls move.
///
/// Every ball remembers where it was looked at and how far from the object it was there: it is
/// looked at again only when it may have gone so far.
class ObjectWalk {
 public:
  /// Balls about the hand's centre, in W; where the hand's centre and the axes of W are in O.
  ObjectWalk(const Eigen::Matrix3Xd& p_CB_W, const Eigen::VectorXd& radii,
             const Eigen::Matrix3d& R_OW, const Eigen::Vector3d& p_OC,
             const StabilityOptions& options, collision::Clearance& clearance);

  bool hits_at_start() const { return hits_at_start_; }
  void to_start();
  /// Moves the object along a unit vector of W by steps of options.step, at most so many, until the
  /// next would hit.
  void translate(const Eigen::Vector3d& direction_W, int most);
  /// Turns the object about an axis through the hand's centre, likewise.
  void rotate(const Eigen::Vector3d& axis_W, int most);

  const Eigen::Vector3d& p_OC() const { return p_OC_; }  ///< the hand's centre [m]
  std::int64_t steps() const { return steps_; }          ///< poses gone through so far

 private:
  template <typename PlaceAt>
  int advance(const Eigen::VectorXd& travel, int most, PlaceAt place_at);
  void schedule(int ball, double bound, double travel, int from, int most);
  bool look(Eigen::Index ball, const Eigen::Vector3d& p_O);

  Eigen::Matrix3Xd p_CB_W_;
  Eigen::VectorXd radii_, travel_of_step_, travel_of_turn_;
  Eigen::Matrix3d R_OW_, R_OW_start_;
  Eigen::Vector3d p_OC_, p_OC_start_;
  double step_, turn_;
  collision::Clearance& clearance_;
  bool hits_at_start_ = false;
  Eigen::Matrix3Xd looked_, looked_at_start_;     // where, in O
  Eigen::VectorXd distance_, distance_at_start_;  // of each ball from the object there, at least
  // For each step of the present move the first ball that is due, and for each ball the one after
  // it; -1 at the end.
  std::vector<int> first_due_, next_due_;
  std::int64_t steps_ = 0;
};

}  // namespace graspless::clasp
