// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "graspless/carry/carry.hpp"
#include "graspless/robot/ik.hpp"
#include "graspless/scene/scene.hpp"

#include "carry/straight_path.hpp"

namespace graspless::carry {

/// True for an arm of fewer than six joints.
inline bool may_lean(const Problem& problem) { return problem.robot.group(problem.arm).size() < 6; }

/// What such an arm could not do.
constexpr const char* kNotTurned =
    "out of the arm's reach or limits, or its joints cannot turn the object so within "
    "options.angle_tolerance";

/// Inverse kinematics of the frame that holds the object. An arm of fewer than six joints may lean
/// by half of what a straight path allows: URDFs round right angles, and tables are not level.
robot::Ik make_ik(const Problem& problem, const Options& options, bool whole_turns);

/// Depth-first search over a grid of three coordinates: distance along the path, value of the arm's
/// free joint, and twist. Each step leads from the configuration in one cell to a neighbouring
/// cell, straight ahead first.
class Search {
 public:
  Search(const Problem& problem, const Options& options, planning::Clock& clock);

  /// Names of the first pair that touches at q_start; empty if nothing touches.
  std::pair<std::string, std::string> touching_at_start();
  /// Returns configurations along the path, starting with q_start; empty if none were found.
  std::vector<Eigen::VectorXd> run();

  const StraightPath& object_path() const { return object_path_; }
  double reached() const {
    return static_cast<double>(farthest_) / steps_;
  }  ///< fraction of the path, in [0, 1]
  Eigen::Isometry3d object_at(const Eigen::VectorXd& q) const;
  const Eigen::VectorXd& step_weights() const { return problem_.robot.step_weights(); }
  Statistics statistics();

 private:
  using Cell = std::array<int, 3>;  // steps along the path, of the free joint, of the twist
  struct Node {
    Cell cell;
    Eigen::VectorXd q;
    int parent;
  };

  std::vector<Cell> neighbours(const Cell& cell) const;
  std::optional<Eigen::VectorXd> step(const Node& from, const Cell& to);
  std::optional<Eigen::VectorXd> solve(const Cell& to, const Eigen::VectorXd& near);
  bool is_motion_valid(const Eigen::VectorXd& from, const Eigen::VectorXd& to);
  std::vector<Eigen::VectorXd> path_to(int node) const;
  void ignore_touched(int body);
  void refuse(const std::string& why) { ++statistics_.refusals[why]; }

  const Problem& problem_;
  const Options& options_;
  planning::Clock& clock_;
  StraightPath object_path_;
  robot::Ik ik_;
  int frame_;
  Eigen::Isometry3d X_FO_;
  scene::Scene scene_;
  int steps_;  // grid cells along the path
  int farthest_ = 0;
  std::vector<Node> nodes_;
  std::set<Cell> visited_;
  Statistics statistics_;
};

/// Adds the obstacles to a scene in which `object` is a body: it may touch those that it rests on,
/// and that on which it is put down.
void add_obstacles(scene::Scene& scene, int object, const Problem& problem, const Options& options);

/// Adds the object a second time, as it hangs at q_start, and attaches it to `frame`; -1 if it does
/// not hang.
int add_hanging(scene::Scene& scene, int frame, const std::vector<int>& hand,
                const Problem& problem);

/// Indices of the links that do not move relative to `frame` while the joints of `arm` move.
std::vector<int> links_with(const robot::Robot& robot, int frame, const std::vector<int>& arm);

}  // namespace graspless::carry
