// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/clasp/problem.hpp"
#include "graspless/clasp/stability.hpp"
#include "graspless/mechanics/contact.hpp"

#include "clasp/stability/distance.hpp"
#include "clasp/stability/load_contacts.hpp"
#include "clasp/stability/load_step.hpp"
#include "crew.hpp"

namespace graspless::clasp {

/// Forces and moments about the object's mean point that a clasp must withstand: every axis of the
/// palm with every axis, 6 x 36 in W [N, Nm].
mechanics::Matrix6Xd loads_W(const Eigen::Matrix3d& R_WH, double force, double torque);

/// Motion of a body whose step is given in mm (angles as arcs of kArm), about a point.
Eigen::Isometry3d motion_of(const mechanics::Vector6d& move, const Eigen::Vector3d& center_W);

/// Mean of the points of the object's surface, which is as dense everywhere, in O: its centre of
/// mass when it hangs.
Eigen::Vector3d mean_of_surface(const Object& object);

constexpr double kSudden = 2;  ///< force of a load that acts suddenly, relative to one at rest

/// Largest effort that loads ask of a joint of the hand.
struct LoadEffort {
  double effort = 0;  ///< as a fraction of its limit
  int joint = -1;     ///< the joint that gives way first; -1: none is loaded
};

/// Test of the loads that force open the closed hand. The object moves without friction and without
/// inertia until the hand blocks it, by up to six steps of 2 mm; where it meets nothing on them, it
/// flies on until it meets the hand, and takes six steps from there. At each step a linear program
/// compares the work that the load gains if joints give way with the work of their motors. Not
/// thread-safe.
class LoadTester {
 public:
  explicit LoadTester(const Problem& problem);

  /// Largest effort of a joint of the hand under any of the loads, which act suddenly, in any step.
  /// Ends at the first load whose effort is above `enough`. `center_W`, `reach`: ball that contains
  /// the finger curves. `crew`: shares the loads, if it is given.
  LoadEffort effort(const Eigen::VectorXd& q, const Eigen::Vector3d& center_W, double reach,
                    double force, double torque,
                    double enough = std::numeric_limits<double>::infinity(),
                    Crew* crew = nullptr) const;

  /// Pose of the object where its weight has brought it to rest in a hand that does not yield, or
  /// where it has sunk by more than `most` [m].
  Eigen::Isometry3d hang(const Eigen::VectorXd& q, const Eigen::Vector3d& center_W, double reach,
                         double most) const;

 private:
  Posture posture(const Eigen::VectorXd& q, const Eigen::Vector3d& center_W) const;
  NearPoints near_points(const Posture& hand, double reach, const Eigen::Isometry3d& X_WO) const;
  bool sink(const Posture& hand, NearPoints& points, LoadStepper& stepper,
            const Eigen::Vector3d& mean_W, Eigen::Isometry3d& moved) const;
  /// A few steps under a load.
  struct Pressed {
    LoadEffort most;
    Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();  // in these steps
    bool is_free = true;                                      // nothing stopped it
    bool is_at_rest = false;
  };
  struct Measured;
  Pressed press(const mechanics::Vector6d& load, Measured& known, const Posture& hand,
                const Eigen::Vector3d& mean_W, int moves) const;
  LoadEffort effort_of(const mechanics::Vector6d& load, Measured& known, const Posture& hand,
                       double reach) const;

  Problem problem_;
  std::vector<Body> bodies_;
  // Ways in which joints of the hand give way: those that close may open, the others may turn to
  // both sides, and stand here twice.
  std::vector<int> joints_;
  Eigen::VectorXd directions_;  // 1 or -1
  Eigen::VectorXd units_;       // lengths in mm: 1 for a prismatic joint, 1000 for others
  Eigen::VectorXd limits_;      // [N or N mm]
  double give_ = kGive;         // of a step, as LoadStepper takes it [N mm]
  Eigen::Vector3d mean_O_;      // of the object's points
};

/// A joint without effort limit of a hand of two fingers, if a load is to be tested. Such a joint
/// of another hand is taken as one that never gives way.
std::optional<int> missing_effort(const Problem& problem, const StabilityOptions& options);
/// Throws std::invalid_argument if missing_effort() finds a joint.
void require_efforts(const Problem& problem, const StabilityOptions& options);

}  // namespace graspless::clasp
