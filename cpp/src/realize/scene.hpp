// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The robot among planes, obstacles and the object, with fingertips that may touch the object.
#pragma once

#include <string>
#include <vector>

#include "graspless/fingertip/problem.hpp"
#include "graspless/scene/scene.hpp"

#include "realize/tips.hpp"
#include "realize/validate.hpp"

namespace graspless::realize {

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

}  // namespace graspless::realize
