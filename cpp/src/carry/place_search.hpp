// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "graspless/carry/carry.hpp"
#include "graspless/planning/free_path.hpp"
#include "graspless/planning/path.hpp"
#include "graspless/robot/ik.hpp"
#include "graspless/scene/scene.hpp"

namespace graspless::carry {

constexpr double kWaypoint = 0.005;  // between poses of straight motions [m]

/// Search for a place where the held object can be put down. Places are tried in their order: the
/// hand comes there, goes straight up from there, opens, and withdraws. A tree is grown to the
/// first places for which only the way from the start is missing.
class PlaceSearch {
 public:
  PlaceSearch(const Problem& problem, const Options& options, planning::Clock& clock,
              std::uint64_t seed);

  /// Fills a plan, but for its joint names.
  void run(Plan& plan);
  Statistics statistics();

 private:
  /// Everything but the way from the start.
  struct Putting {
    int place;
    planning::Path lower, open, retreat;
  };

  std::vector<Eigen::VectorXd> configurations(const Eigen::Isometry3d& X_WO);
  Eigen::Vector3d rise(int place) const;
  std::optional<Putting> put_at(int place, const Eigen::VectorXd& q);
  std::optional<Putting> let_go(int place, planning::Path lower);
  bool go_straight(int place, Plan& plan);
  std::optional<planning::Path> withdrawn(const Eigen::VectorXd& q);
  std::optional<planning::Path> along_way_out(const Eigen::VectorXd& q);
  std::vector<Eigen::Isometry3d> line(const Eigen::VectorXd& q, const Eigen::Vector3d& along,
                                      double length) const;
  std::optional<planning::Path> follow(const Eigen::VectorXd& q,
                                       const std::vector<Eigen::Isometry3d>& poses);
  void assemble(const planning::Path& transfer, const Putting& putting, Plan& plan) const;
  planning::FreeSpace held_space();
  planning::Path shortened(const planning::Path& path);
  std::optional<planning::Path> way_to(const Putting& putting, int iterations);
  bool go_around(const std::vector<Putting>& puttings, Plan& plan);
  double detour_of(const planning::Path& path) const;
  bool is_level(const Eigen::VectorXd& q) const;
  bool is_level(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const;
  bool is_free(const Eigen::VectorXd& from, const Eigen::VectorXd& to);
  double checked_step(const Eigen::VectorXd& from, const Eigen::VectorXd& to) const;
  Eigen::Isometry3d object_at(const Eigen::VectorXd& q) const;
  void hold(double depth);
  void let_stand(const Eigen::VectorXd& q);
  void append(const std::string& name, const planning::Path& path, bool held, Plan& plan) const;
  void fail(std::size_t tried, Plan& plan) const;
  std::string touching(const Eigen::VectorXd& q);
  bool refuse(const std::string& why) {
    ++statistics_.refusals[why];
    return false;
  }

  const Problem& problem_;
  const Places& places_;
  const Options& options_;
  planning::Clock& clock_;
  std::mt19937_64 rng_;
  robot::Ik ik_;
  int frame_;
  Eigen::Isometry3d X_FO_;
  Eigen::Vector3d up_O_;  // the support's normal at the places, in O
  scene::Scene scene_;
  int object_;
  int hanging_ = -1;       // the object as it hangs
  std::vector<int> hand_;  // links that move with the object
  Statistics statistics_;
};

}  // namespace graspless::carry
