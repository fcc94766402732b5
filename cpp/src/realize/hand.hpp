// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// A robot's fingertips among planes, obstacles and the object, and their inverse kinematics.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "graspless/fingertip/problem.hpp"
#include "graspless/robot/robot.hpp"
#include "graspless/scene/scene.hpp"

#include "realize/validate.hpp"

namespace graspless::realize {

/// A set of fingers, as bits: finger i by 1 << i.
using FingerMask = unsigned;

/// Target positions of fingertips: column i for finger i, those in `held` only.
struct TipTargets {
  Eigen::Matrix3Xd p_WT;  // [m]
  FingerMask held = 0;
};

/// Damped least squares over all joints that move any fingertip, within limits. Joints that move
/// none stay as they are.
class TipIk {
 public:
  /// `frames`: of each finger's fingertip.
  TipIk(const robot::Robot& robot, std::vector<int> frames);

  const robot::Robot& robot() const { return robot_; }
  const std::vector<int>& joints() const { return joints_; }  // that move a fingertip
  const std::string& fingertip(int finger) const;
  Eigen::Isometry3d pose(int finger, const Eigen::VectorXd& q) const;

  /// Moves q to the targets by steps of least norm, within the joints' limits. True if every
  /// fingertip came to within `tolerance` [m]. If not, q is the best that was found.
  bool solve(const TipTargets& targets, double tolerance, int max_iterations, Eigen::VectorXd& q);

  /// A step from q towards the targets that turns the held fingertips with an object, as far as
  /// their positions leave room. The object turns by `turn_W` [rad] meanwhile. Rotation about the
  /// contacts' normals (columns of n_W) is free. Spheres whose contact points stay should not roll
  /// on the surface.
  Eigen::VectorXd step_along(const TipTargets& targets, const Eigen::Vector3d& turn_W,
                             const Eigen::Matrix3Xd& n_W, const Eigen::VectorXd& q);

  /// The largest distance of a fingertip from its target [m], and which finger's.
  std::pair<double, int> miss(const TipTargets& targets, const Eigen::VectorXd& q);

 private:
  using Jacobian = Eigen::Matrix<double, 6, Eigen::Dynamic>;
  double errors(const TipTargets& targets, const Eigen::VectorXd& q);
  void jacobians(const TipTargets& targets);
  Eigen::VectorXd with(const Eigen::VectorXd& q, const Eigen::VectorXd& dq) const;
  Eigen::VectorXd step(const Eigen::VectorXd& q, double damping);

  robot::Robot robot_;
  std::vector<int> frames_, joints_;
  robot::Poses X_WL_;
  Eigen::VectorXd error_;   // stacked, 3 a held finger [m]
  Eigen::MatrixXd J_;       // of the stacked positions by joints_
  Eigen::MatrixXd J_turn_;  // of the stacked rotations
  Jacobian J_frame_;
};

class HandScene {
 public:
  /// `links`: of each finger, those that may touch the object.
  HandScene(const Problem& problem, const robot::Robot& robot, std::vector<std::vector<int>> links,
            double allowance);

  /// Allows the fingers in `touching` to touch the object where its surface has the normal n_O
  /// (column i for finger i, into the object).
  void set_contacts(const Eigen::Matrix3Xd& n_O, FingerMask touching);
  void place_object(const Eigen::Isometry3d& X_WO);

  bool is_free(const Eigen::VectorXd& q) { return scene_.is_free(q); }
  /// True if the straight motion of the joints is free while the object stands still where it was
  /// placed. It is checked at even steps, as the replay of its rows will.
  bool is_motion_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2, double row_step,
                      double resolution);
  /// The same while the object moves along the screw to X_WO2, where it is left.
  bool is_motion_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2,
                      const Eigen::Isometry3d& X_WO2, double resolution);
  /// "a touches b" at the configuration, or empty.
  std::string collision(const Eigen::VectorXd& q);

  scene::Scene& scene() { return scene_; }
  int object() const { return object_; }

 private:
  void allow();

  scene::Scene scene_;
  std::vector<std::vector<int>> links_;
  double allowance_;
  int object_ = -1;
  Eigen::Isometry3d X_WO_ = Eigen::Isometry3d::Identity();
  Eigen::Matrix3Xd n_O_;
  FingerMask touching_ = 0;
};

constexpr double kIkTolerance = 1e-7;  // of fingertips at rows [m]

/// One assignment of the robot's fingertips to a plan's fingers, with the scene and the inverse
/// kinematics that move them.
struct Hand {
  Hand(const Problem& problem, const robot::Robot& robot, const Carrier& carrier,
       const std::vector<int>& finger_of_fingertip, const RealizeOptions& options);

  std::vector<int> finger_of_fingertip;
  TipIk ik;
  HandScene scene;
  double radius;  // of the fingertips [m]
  const RealizeOptions& options;
};

/// "'a' touches 'b': c leaves room", or empty if nothing touches.
std::string describe_collision(Hand& hand, const Eigen::VectorXd& q);
/// "fingertip 'a' misses the place of finger 0 by 12.3 mm: nearer to the robot, ..."
std::string describe_miss(Hand& hand, const TipTargets& targets, const Eigen::VectorXd& q);

}  // namespace graspless::realize
