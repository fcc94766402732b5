// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "graspless/robot/ik.hpp"

#include "slide/contact_space.hpp"
#include "slide/placement.hpp"
#include "slide/rows.hpp"

namespace graspless::slide {

/// What one plan() works with.
struct GRASPLESS_API Query {
  Query(const Problem& problem, const Options& options, const planning::Budget& budget);

  const Problem& problem;
  const Options& options;
  planning::Clock clock;
  std::mt19937_64 rng;
  Statistics statistics;

  Arm arm;
  robot::Ik tip_ik, grasp_ik;
  ContactSpace contact;  ///< pressing and sliding
  scene::Scene free;     ///< everything else: nothing may touch, the object stands still
  int object_body;       ///< of `free`
  Planar object_start;   ///< kappa_s in S
  double top;            ///< z_s: height of the object's top face over S
  Eigen::Isometry3d X_WS;

  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(rng);
  }
  void refuse(const char* why) { ++statistics.refusals[why]; }

  /// Whether a straight motion of all joints is free in `free`, at the steps of a replay.
  bool is_motion_free(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
    return free.is_free(from, to, replay_step(from, to, options.resolution));
  }

  /// Pose of the commanded tip in the world whose effective contact, pressed `depth` after touching
  /// at the same pitch, is `contact` (position and heading in S).
  Eigen::Isometry3d pressed_tip(const Planar& contact, double depth, double pitch) const;

  /// Configurations of the arm that put a frame at a pose, for one draw of what the pose leaves
  /// free: the closed form at the given value of the free joint, or one descent from `near`.
  std::vector<Eigen::VectorXd> draw_ik(const robot::Ik& ik, const Eigen::Isometry3d& X_WF,
                                       const Eigen::VectorXd& near, double free_joint);

  /// What a closed form's answers are compared with, or where a descent begins: home, or for a
  /// descent also a random configuration.
  Eigen::VectorXd draw_seed();
  /// A value of the closed form's free joint, the arm's third; 0 for an arm without one.
  double draw_free_joint();
  double free_joint_of(const Eigen::VectorXd& arm) const {
    return arm.size() > kFree ? arm[kFree] : 0;
  }

  /// The carried object of a start configuration.
  ContactSpace::Carried carried_from(const Eigen::VectorXd& start) {
    return {contact.effective_tip_at(start), object_start};
  }

 private:
  static constexpr int kFree = 2;
};

}  // namespace graspless::slide
