// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Configurations drawn at random: first grips, and where a displacement may end.
#include "realize/attempt.hpp"

namespace graspless::realize {
namespace {

constexpr int kFarIterations = 80;  // of inverse kinematics from a random configuration
constexpr int kGripDraws = 12;      // configurations a round
constexpr int kBiasDraws = 12;      // configurations at its end tried for one of them

}  // namespace

/// Draws home first, then farther and farther about it, and every other one from anywhere. A
/// configuration that touches something (such as crossed fingers) seldom leads to one that does
/// not.
Eigen::VectorXd Attempts::draw_seed(int round, int draw) {
  constexpr int kTries = 20;
  if (round == 0 && draw == 0) return q_home_;
  hand_.scene.set_contacts(grips_[0].n_O, 0);
  Eigen::VectorXd q = scatter(round, draw % 2 == 0);
  for (int i = 1; i < kTries && !hand_.scene.is_free(q); ++i) q = scatter(round, draw % 2 == 0);
  return q;
}

Eigen::VectorXd Attempts::scatter(int round, bool about_home) {
  const robot::Robot& robot = hand_.ik.robot();
  std::uniform_real_distribution<double> uniform(0, 1);
  std::normal_distribution<double> normal(0, 0.1 * (1 + std::min(round, 9)));
  Eigen::VectorXd q = q_home_;
  for (const int joint : hand_.ik.joints()) {
    const double lower = robot.lower()[joint], upper = robot.upper()[joint];
    if (about_home)
      q[joint] += normal(rng_) * std::min(1.0, upper - lower);
    else
      q[joint] = lower + uniform(rng_) * (upper - lower);
  }
  return robot.clamp(q);
}

std::optional<Eigen::VectorXd> Attempts::configuration(const Grip& grip,
                                                       const Eigen::Isometry3d& X_WO,
                                                       Eigen::VectorXd q, int stage,
                                                       const std::string& where) {
  const Stretch still{{X_WO}, 1, grip.center_O, grip.center_O, all()};
  const TipTargets targets = still.targets(0);
  if (!hand_.ik.solve(targets, kIkTolerance, kFarIterations, q)) {
    misses_.note(stage, -hand_.ik.miss(targets, q).first,
                 where + ": " + describe_miss(hand_, targets, q));
    return std::nullopt;
  }
  hand_.scene.set_contacts(grip.n_O, all());
  hand_.scene.place_object(X_WO);
  if (hand_.scene.is_free(q)) return q;
  misses_.note(stage + 1, 0, where + ": " + describe_collision(hand_, q));
  return std::nullopt;
}

std::optional<Eigen::VectorXd> Attempts::draw_grip(int round) {
  const Grip& grip = grips_[0];
  for (int draw = 0; draw < kGripDraws && !clock_.is_out(); ++draw) {
    const auto q = configuration(grip, plan_.segments.front().X_WO.front(), draw_seed(round, draw),
                                 0, name(0) + ", row 0");
    if (q) return q;
  }
  return std::nullopt;
}

/// Draws a configuration at the end of displacement k to head for.
Bias Attempts::draw_bias(Index k, const Eigen::VectorXd& q) {
  for (int draw = 0; draw < kBiasDraws; ++draw) {
    Eigen::VectorXd seed = draw % 3 == 0 ? q : draw_seed(9, draw);
    if (draw % 3 == 0 && draw > 0) seed = (q + draw_seed(9, 1)) / 2;
    const auto bias = configuration(grips_[k], plan_.segments[k].X_WO.back(), seed, stage(k) - 1,
                                    name(k) + ", last row");
    if (bias && (draw > 0 || !bias->isApprox(q, 1e-6))) return bias;
  }
  return std::nullopt;
}

}  // namespace graspless::realize
