// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include "graspless/robot/ik.hpp"

#include "scene/rows.hpp"
#include "slide/contact_space.hpp"
#include "slide/friction/course.hpp"
#include "slide/placement.hpp"

namespace graspless::slide {

/// A collision for which a configuration was rejected.
struct Collision {
  scene::Scene* scene;
  std::pair<int, int> bodies;
  Eigen::VectorXd q;
  Eigen::Isometry3d X_WO;
  std::string frame;
};

/// A slide, and where friction takes the object.
struct Slid {
  Segment segment;
  std::vector<PressedRow> pressed;
  Tube tube;
};

/// Working state of one plan(): the problem, its budget, and the solvers and scenes made from it.
struct GRASPLESS_API Query {
  Query(const Problem& problem, const Options& options, planning::Clock& clock, std::uint64_t seed);

  const Problem& problem;
  const Options& options;
  planning::Clock& clock;
  std::mt19937_64 rng;
  Statistics statistics;
  Slid slid;  ///< the last one whose lag was found small
  /// True if friction refuses slides. One that is resumed is not refused: who measured the object
  /// can measure it again, and resume again.
  bool refuses_lag;
  int num_lags = 0;                             ///< rejections by friction
  std::map<std::string, Lag> lags;              ///< the smallest of each reason in the statistics
  std::map<std::string, Collision> collisions;  ///< the first of each reason in the statistics

  Arm arm;
  robot::Ik tip_ik, grasp_ik;
  scene::Scene free;     ///< all motions but slides: nothing may touch, the object does not move
  ContactSpace contact;  ///< pressing and sliding
  int object_body;       ///< index of the object in `free`
  Planar object_start;   ///< kappa_s in S
  std::optional<Planar> object_end;  ///< where the object is left, in S
  double top;                        ///< z_s: height of the object's top face over S
  Eigen::Isometry3d X_WS;

  double uniform(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(rng);
  }
  void refuse(const std::string& why) { ++statistics.refusals[why]; }
  /// Counts a collision that `scene` has found at q (all joints), and keeps the first one of its
  /// kind. `frame` of the robot tells where the hand is.
  void refuse_collision(const std::string& when, scene::Scene& scene, std::pair<int, int> bodies,
                        const Eigen::VectorXd& q, const std::string& frame);
  /// Counts a configuration of the arm for which contact.is_valid() has just returned false.
  void refuse_press(const std::string& when, const Eigen::VectorXd& arm_part);

  /// True if friction lets the object follow a slide well enough to be grasped; it is kept then.
  /// Otherwise counts the rejection, and keeps the smallest lag of its kind.
  bool is_lag_small(Slid slide);
  /// Estimates the same for a finger that moves and turns the object evenly to the goal, at
  /// constant depth and pitch. Counts a rejection.
  bool is_lag_likely_small(const ContactSpace::Carried& carried, double depth,
                           const std::optional<Placement>& place, const Planar& object_goal);
  /// Tests the ends of a slide. `grasp` returns the middle of the planned grasp, in S; nothing if
  /// the object is left where it is.
  bool allows_lag(const std::string& what, const std::vector<Planar>& ends, const Planar& goal,
                  const std::function<std::optional<Eigen::Vector2d>()>& grasp);

  /// True if the straight motion of all joints is free of collision, at the steps at which check()
  /// replays it.
  bool is_motion_free(const Eigen::VectorXd& from, const Eigen::VectorXd& to) {
    return free.is_free(from, to, scene::replay_step(problem.robot, from, to, options.resolution));
  }

  /// Returns the pose in W of a commanded tip that presses `depth` [m] deep at `pitch` [rad] and
  /// whose effective contact is `contact` (position and heading in S).
  Eigen::Isometry3d pressed_tip(const Planar& contact, double depth, double pitch) const;

  /// Returns configurations that put a frame at the pose X_WF, for one draw of the redundancy: the
  /// closed form, at the given value of the free joint if there is one, or one numerical descent
  /// from `near`.
  std::vector<Eigen::VectorXd> draw_ik(const robot::Ik& ik, const Eigen::Isometry3d& X_WF,
                                       const Eigen::VectorXd& near, double free_joint);

  /// Draws the configuration that inverse kinematics stays near: q_home, or for a numerical descent
  /// also a random configuration.
  Eigen::VectorXd draw_seed();
  /// Draws a value of the closed form's free joint; 0 for an arm without one.
  double draw_free_joint();
  /// The same, within 0.5 rad of a value.
  double draw_free_joint(double near);
  /// Returns the value of the free joint in a configuration of all joints; 0 without one.
  double free_joint_of(const Eigen::VectorXd& q) const {
    const std::optional<int> joint = tip_ik.free_joint();
    return joint ? q[*joint] : 0;
  }

  /// Returns how the object is carried by a slide that begins at `start`.
  ContactSpace::Carried carried_from(const Eigen::VectorXd& start) {
    return {contact.effective_tip_at(start), object_start};
  }
};

}  // namespace graspless::slide
