// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// One assignment of fingertips to fingers, carried through a plan from configurations drawn at
// random.
#pragma once

#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "graspless/planning/budget.hpp"
#include "graspless/realize/realize.hpp"

#include "realize/track.hpp"

namespace graspless::realize {

/// "q_home: a touches b", with the object where the plan begins; or empty.
std::string home_collision(const Problem& problem, const Plan& plan, const robot::Robot& robot,
                           const Carrier& carrier, const Eigen::VectorXd& q_home,
                           const RealizeOptions& options);

/// Progress of the attempts, for the reason of a failure. Only the farthest attempts count; the
/// reason is what happened to most of them.
class Misses {
 public:
  /// Farther is a higher stage, then more progress.
  void note(int stage, double progress, const std::string& what);
  std::string farthest() const;

 private:
  int stage_ = -1;
  double progress_ = 0;
  std::map<std::string, int> counts_;
};

class Attempts {
 public:
  Attempts(const Problem& problem, const Plan& plan, const Eigen::VectorXd& q_home, Hand hand,
           planning::Clock& clock, std::mt19937_64& rng, Misses& misses);

  /// Draws a first grip and follows the plan from it; later rounds draw farther from home.
  bool run(int round);

  const std::vector<int>& finger_of_fingertip() const { return hand_.finger_of_fingertip; }
  const std::vector<JointSegment>& segments() const { return segments_; }

 private:
  using Index = std::size_t;
  struct Leaving {  // off the surface along the normals
    Tracked rows;
    Eigen::VectorXd q;  // the last one's
  };

  std::optional<Eigen::VectorXd> draw_grip(int round);
  Eigen::VectorXd draw_seed(int round, int draw);
  Eigen::VectorXd scatter(int round, bool about_home);
  std::optional<Eigen::VectorXd> configuration(const Grip& grip, const Eigen::Isometry3d& X_WO,
                                               Eigen::VectorXd seed, int stage,
                                               const std::string& where);
  bool carry(Index k, const Eigen::VectorXd& q);
  bool displace(Index k, const Eigen::VectorXd& q);
  bool regrasp(Index k, const Eigen::VectorXd& q);
  bool leave_for_good(const Eigen::VectorXd& q);
  Bias draw_bias(Index k, const Eigen::VectorXd& q);
  std::optional<Leaving> leave(const Grip& grip, FingerMask fingers, const Eigen::Isometry3d& X_WO,
                               const Eigen::VectorXd& q, int stage, const std::string& where);

  std::string name(Index k) const;
  int stage(Index k) const { return 4 + 4 * static_cast<int>(k); }
  FingerMask all() const;
  void push(const std::string& name, Tracked rows, int plan_segment);
  void push_reversed(const std::string& name, const Tracked& rows, int plan_segment);
  void push_still(const std::string& name, const std::vector<Eigen::VectorXd>& rows,
                  const Eigen::Isometry3d& X_WO, int plan_segment);

  const Plan& plan_;
  const Eigen::VectorXd& q_home_;
  Hand hand_;
  planning::Clock& clock_;
  std::mt19937_64& rng_;
  Misses& misses_;
  std::vector<Grip> grips_;  // of each segment, a regrasp's as it ends
  int reach_iterations_ = 0;
  bool is_strict_ = true;         // early rounds: only motions in which the fingertips do not roll
  std::optional<Leaving> first_;  // off the first grip: the approach's end, backwards
  std::vector<JointSegment> segments_;
};

}  // namespace graspless::realize
