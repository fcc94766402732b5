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

#include "carry/way.hpp"

namespace graspless::carry {

/// Depth first over a grid of how far along the way, which value of the arm's free joint and which
/// twist: from a configuration at one place to its neighbours, the next one straight ahead first.
class Search {
 public:
  Search(const Problem& problem, const Options& options, planning::Clock& clock);

  /// What touches where the robot stands; empty names when nothing does.
  std::pair<std::string, std::string> touching_at_start();
  /// Configurations along the way, the first q_start; empty when there are none.
  std::vector<Eigen::VectorXd> run();

  const Way& way() const { return way_; }
  double reached() const { return static_cast<double>(farthest_) / layers_; }  ///< 0 to 1
  Eigen::Isometry3d object_at(const Eigen::VectorXd& q) const;
  Statistics statistics();

 private:
  using Place = std::array<int, 3>;  // layer, steps of the free joint, steps of the twist
  struct Node {
    Place place;
    Eigen::VectorXd q;
    int parent;
  };

  bool has_free_joint() const { return ik_.is_closed_form(); }
  std::vector<Place> neighbours(const Place& place) const;
  std::optional<Eigen::VectorXd> step(const Node& from, const Place& to);
  std::optional<Eigen::VectorXd> solve(const Place& to, const Eigen::VectorXd& near);
  bool is_motion_good(const Eigen::VectorXd& from, const Eigen::VectorXd& to);
  std::vector<Eigen::VectorXd> way_to(int node) const;
  void refuse(const std::string& why) { ++statistics_.refusals[why]; }

  const Problem& problem_;
  const Options& options_;
  planning::Clock& clock_;
  Way way_;
  robot::Ik ik_;
  int frame_;
  Eigen::Isometry3d X_FO_;
  scene::Scene scene_;
  int layers_;
  int farthest_ = 0;
  std::vector<Node> nodes_;
  std::set<Place> known_;
  Statistics statistics_;
};

/// Links that keep their place to `frame` while the joints of `arm` move.
std::vector<int> links_with(const robot::Robot& robot, int frame, const std::vector<int>& arm);

}  // namespace graspless::carry
