// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "graspless/planning/path.hpp"
#include "graspless/robot/ik.hpp"
#include "graspless/scene/scene.hpp"

#include "slide/arm.hpp"

namespace graspless::slide {

/// Motions of arm and hand among bodies that do not move. Paths are configurations of the arm, with
/// the hand open. Every motion is checked at the steps at which check() replays it.
class HandMotion {
 public:
  /// Keeps all arguments by reference, and counts calls of inverse kinematics in `ik_calls`.
  HandMotion(const robot::Robot& robot, const Arm& arm, scene::Scene& scene, double resolution,
             std::int64_t& ik_calls)
      : robot_(robot), arm_(arm), scene_(scene), resolution_(resolution), ik_calls_(ik_calls) {}

  /// True if the straight motion of all joints is free.
  bool is_free(const Eigen::VectorXd& from, const Eigen::VectorXd& to);

  /// Returns the path through poses of the frame of `ik`, which begins at `from`; nothing if it
  /// collides in `scene` or leaves the branch of inverse kinematics.
  std::optional<planning::Path> track(const robot::Ik& ik, const Eigen::VectorXd& from,
                                      const std::vector<Eigen::Isometry3d>& poses,
                                      scene::Scene& scene);
  std::optional<planning::Path> track(const robot::Ik& ik, const Eigen::VectorXd& from,
                                      const std::vector<Eigen::Isometry3d>& poses) {
    return track(ik, from, poses, scene_);
  }

  /// planning::find_free_path() of the arm.
  std::optional<planning::Path> free_path(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                          int iterations, std::mt19937_64& rng,
                                          const std::function<bool()>& is_out);

  /// A hand that closes until something touches.
  struct Closing {
    std::vector<Eigen::VectorXd> rows;             ///< all joints; the last one touches
    std::pair<std::string, std::string> touching;  ///< bodies; empty: nothing
  };
  Closing close(const Eigen::VectorXd& arm);

 private:
  const robot::Robot& robot_;
  const Arm& arm_;
  scene::Scene& scene_;
  double resolution_;
  std::int64_t& ik_calls_;
};

/// True if two bodies of make_scene() are a finger and the object.
bool is_finger_on_object(const Hand& hand, const std::string& a, const std::string& b);

/// Number of equal pieces of a length, each at most `step`.
int pieces(double length, double step);

}  // namespace graspless::slide
