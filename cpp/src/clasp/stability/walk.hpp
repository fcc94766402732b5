// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Random moves of the object against a hand that does not move.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "graspless/clasp/stability.hpp"
#include "graspless/collision/clearance.hpp"

#include "clasp/stability/balls.hpp"

namespace graspless::clasp {

/// Moves the object until it hits one of the balls. Computations are in O, where the balls move.
///
/// For every ball, the position of its last check and its distance from the object are stored. The
/// ball is checked again only when it may have moved by that distance. Balls come in groups, which
/// are looked at only when the nearest of their balls may be due.
class ObjectWalk {
 public:
  /// `p_CB_W`: centres of the balls relative to the hand's centre C, in W [m]. `R_OW`, `p_OC`:
  /// orientation of W and position of C in O.
  ObjectWalk(const Eigen::Matrix3Xd& p_CB_W, const Eigen::VectorXd& radii,
             const Eigen::Matrix3d& R_OW, const Eigen::Vector3d& p_OC,
             const StabilityOptions& options, collision::Clearance& clearance);

  bool hits_at_start() const { return hits_at_start_; }
  void reset();
  /// Moves the object along a unit vector by steps of options.step until the next step would hit,
  /// at most `max_steps`.
  void translate(const Eigen::Vector3d& direction_W, int max_steps);
  /// Same for a rotation about an axis through the hand's centre, by steps of options.turn.
  void rotate(const Eigen::Vector3d& axis_W, int max_steps);

  const Eigen::Vector3d& p_OC() const { return p_OC_; }  ///< hand's centre in O [m]
  std::int64_t steps() const { return steps_; }          ///< number of poses so far

 private:
  /// Pose of the hand in O, and a translation after it [m].
  struct Pose {
    Eigen::Matrix3d R_OW;
    Eigen::Vector3d p_OC, shift_O = Eigen::Vector3d::Zero();
    Eigen::Vector3d operator*(const Eigen::Vector3d& p_CB_W) const {
      return R_OW * p_CB_W + p_OC + shift_O;
    }
  };
  /// Neighbouring balls, none of which was nearer to the object than `bound` [m] at pose `at`.
  struct Group {
    BallGroup balls;
    double bound;
    Pose at;
  };

  template <typename Travel, typename PoseAt>
  int advance(int max_steps, Travel travel, PoseAt pose_at);
  void schedule(int item, double bound, double travel, int from, int max_steps);
  template <typename Travel>
  bool group_hits(int index, const Pose& pose, Travel travel, int step, int max_steps);
  bool hits(Eigen::Index ball, const Eigen::Vector3d& p_O);
  void remember(int ball);
  bool stays(const Pose& first);

  Eigen::Matrix3Xd p_CB_W_;
  Eigen::VectorXd radii_;
  Eigen::Matrix3d R_OW_, R_OW_start_;
  Eigen::Vector3d p_OC_, p_OC_start_;
  double step_, turn_;
  collision::Clearance& clearance_;
  bool hits_at_start_ = false;
  Eigen::Matrix3Xd checked_at_, checked_at_start_;  // position at its last check, in O
  Eigen::VectorXd distance_, distance_at_start_;    // lower bound on the distance there
  std::vector<Group> groups_, groups_at_start_;
  // Linked lists of the balls and groups due at each step of the current move; -1 at the end.
  std::vector<int> first_due_, next_due_;
  static constexpr std::size_t kRecent = 8;
  std::vector<int> recent_;  // balls that hit, the last one first
  std::int64_t steps_ = 0;
};

}  // namespace graspless::clasp
