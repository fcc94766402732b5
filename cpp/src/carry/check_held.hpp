// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Parts that check() of a straight path and of a place share. They use no code of the search.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "graspless/carry/carry.hpp"

#include "scene/edges.hpp"
#include "scene/replay.hpp"

namespace graspless::carry {

constexpr double kSame = 1e-6;  // [m, rad]

/// World in which a held object moves with its frame.
class HeldReplay {
 public:
  HeldReplay(const Problem& problem, const Options& options)
      : HeldReplay(problem, problem.object, problem.rests_on, options) {}
  /// `object` in place of problem.object, which rests on `rests`.
  HeldReplay(const Problem& problem, const Obstacle& object, std::vector<Rest> rests,
             const Options& options);

  Eigen::Isometry3d object_at(const Eigen::VectorXd& q) const {
    return robot_.pose(frame_, q) * X_FO_;
  }
  /// Puts the object somewhere, and returns the names of pairs that touch.
  std::vector<std::string> touching(const Eigen::VectorXd& q, const Eigen::Isometry3d& X_WO);
  /// Tests the object against the links that hold it from now on.
  void let_go();
  /// Lets the object be lower than that on which it is put down by `depth` [m].
  void allow_sunk(const Places& places, double depth);
  /// Stops testing the object against what it touches at q.
  void ignore_touched(const Eigen::VectorXd& q);
  /// Doubts about the edges of a motion; the object moves with its frame, or stays at `put`.
  std::vector<scene::Doubt> prove_free(const Segment& segment);
  std::vector<scene::Doubt> prove_free(const Segment& segment, const Eigen::Isometry3d& put);
  /// Bounds on the motion of the object, by a step of the joints.
  scene::FrameRates rates(const Eigen::VectorXd& step) const {
    return scene::frame_rates(robot_, frame_, step, X_FO_.translation());
  }

 private:
  void exclude_hand(const Problem& problem);

  const robot::Robot& robot_;
  int frame_;
  Eigen::Isometry3d X_FO_;  // the object in the frame that holds it
  scene::Replay replay_;
  int object_;
  std::vector<int> holding_;  // bodies
};

/// World in which a loose object hangs in the hand; none if it does not.
std::optional<HeldReplay> hanging_replay(const Problem& problem, const Options& options);

/// The straight path of the object, from one pose to another, with a twist about its line.
struct StraightWay {
  Eigen::Isometry3d start, goal;
  double max_twist = 0;

  /// The object's distance [m] and angle [rad] from the path.
  struct Deviation {
    double distance, angle;
  };

  bool is_turn() const { return (goal.translation() - start.translation()).norm() <= kSame; }
  Deviation deviation(const Eigen::Isometry3d& X_WO) const;
  /// Describes how a pose leaves the path; empty if it does not.
  std::string fault_of(const Eigen::Isometry3d& X_WO, const Options& options) const;
  /// Bounds deviation() on each edge: its distance is a convex function of the object's place, and
  /// its angle changes by at most the turns of the object and of the pose on the straight path.
  std::vector<scene::Doubt> prove(const HeldReplay& held, const Segment& segment,
                                  const Options& options) const;
};

/// Angle between two attitudes [rad].
double angle_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b);

std::vector<std::string> check_places(const Problem& problem, const Plan& plan,
                                      const Options& options);
scene::EdgeCertificate certify_places(const Problem& problem, const Plan& plan,
                                      const Options& options);

/// Faults of the sizes and numbers of a plan, whose segments must have `names`.
std::vector<std::string> shape_faults(const Problem& problem, const Plan& plan,
                                      const std::vector<std::string>& names);

/// Distance of the joints inside (or outside) the arm's group between two configurations.
double moved(const Problem& problem, bool in_arm, const Eigen::VectorXd& from,
             const Eigen::VectorXd& to);

}  // namespace graspless::carry
