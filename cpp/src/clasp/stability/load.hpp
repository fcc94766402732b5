// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "graspless/clasp/problem.hpp"
#include "graspless/clasp/stability.hpp"
#include "graspless/mechanics/contact.hpp"

#include "clasp/stability/distance.hpp"
#include "clasp/stability/load_step.hpp"

namespace graspless::clasp {

/// Forces and moments about the object's mean point that a clasp must withstand: every axis of the
/// palm with every axis, 6 x 36 in W [N, Nm].
mechanics::Matrix6Xd loads_W(const Eigen::Matrix3d& R_WH, double force, double torque);

constexpr double kSudden = 2;  ///< force of a load that acts suddenly, relative to one at rest

/// Test whether a load forces open the closed hand. The object moves without friction and without
/// inertia, by small steps, until the hand blocks it; a linear program finds the contact forces
/// there, and the efforts of the joints that balance them. Not thread-safe.
class LoadTester {
 public:
  explicit LoadTester(const Problem& problem);

  /// Largest effort of a joint of the hand under any of the loads, which act suddenly, as a
  /// fraction of its limit. `center_W`, `reach`: ball that contains the finger curves.
  double effort(const Eigen::VectorXd& q, const Eigen::Vector3d& center_W, double reach,
                double force, double torque) const;

  /// Shape of a link, and a ball around it.
  struct Body {
    int link;
    Distance distance;
    Eigen::Vector3d center_L;
    double radius;  // [m]
  };

 private:
  /// A point of the object, and a body that it may touch.
  struct Pair {
    Eigen::Vector3d p_W;
    std::size_t body;
    double distance;             // when it was last measured [m]
    Eigen::Vector3d measured_W;  // where the point was then
  };
  /// The hand at one configuration.
  struct Posture {
    robot::Poses X_WL, X_LW;                   // of each link
    std::vector<mechanics::Matrix6Xd> twists;  // of each link by each joint, at W's origin
    Eigen::Vector3d center_W;                  // of the finger curves
  };

  Posture posture(const Eigen::VectorXd& q, const Eigen::Vector3d& center_W) const;
  std::vector<Pair> pairs(const Posture& hand, double reach) const;
  std::vector<LoadContact> contacts(std::vector<Pair>& pairs, const Eigen::Isometry3d& moved,
                                    const Posture& hand) const;
  LoadContact contact(const Eigen::Vector3d& p_W, const Body& body, const Posture& hand) const;
  double effort_of(const mechanics::Vector6d& load, std::vector<Pair> pairs,
                   std::vector<LoadContact> contacts_now, const Posture& hand) const;

  Problem problem_;
  std::vector<Body> bodies_;
  std::vector<int> joints_;     // of the hand, which open
  Eigen::VectorXd directions_;  // in which they open
  Eigen::VectorXd units_;       // lengths in mm: 1 for a prismatic joint, 1000 for others
  Eigen::VectorXd limits_;      // [N or N mm]
  Eigen::Vector3d mean_O_;      // of the object's points
};

/// Throws std::invalid_argument if a load is to be tested, and a joint of a hand of two fingers has
/// no effort limit.
void require_efforts(const Problem& problem, const StabilityOptions& options);

}  // namespace graspless::clasp
