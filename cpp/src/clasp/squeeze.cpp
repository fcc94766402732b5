// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/squeeze.hpp"

#include <cmath>
#include <random>

#include "graspless/watch.hpp"

#include "clasp/close.hpp"

namespace graspless::clasp {
namespace {

using Eigen::VectorXd;

constexpr int kFailures = 20;                   // in a row that end it
constexpr double kGain = 0.01;                  // in closure()
constexpr double kLeast = 0.003, kMost = 0.05;  // steps of the arm, Robot::step() [rad]
constexpr double kOpen = 0.2;                   // of the fingers before they close again [rad]

/// Random motion of the arm, of a random size.
VectorXd random_move(const Problem& problem, std::mt19937_64& rng) {
  std::uniform_real_distribution<double> side(-1, 1), part(0, 1);
  const double step = kLeast * std::pow(kMost / kLeast, part(rng));
  VectorXd move = VectorXd::Zero(problem.robot.dof());
  for (const int joint : problem.robot.group(problem.hand.arm))
    move[joint] = step * side(rng) / problem.robot.step_weights()[joint];
  return move;
}

/// Fingers moved towards the open state by kOpen.
VectorXd loosened(const Problem& problem, VectorXd q) {
  const VectorXd& open = problem.robot.state(problem.hand.open);
  for (const int joint : problem.robot.group(problem.hand.hand)) {
    const double most = kOpen / problem.robot.step_weights()[joint];
    q[joint] += std::clamp(open[joint] - q[joint], -most, most);
  }
  return q;
}

/// Sum over the joints of the hand of the way that they have closed, as a part of their whole way.
double closure(const Problem& problem, const VectorXd& q) {
  const VectorXd &open = problem.robot.state(problem.hand.open),
                 &closed = problem.robot.state(problem.hand.closed);
  double sum = 0;
  for (const int joint : problem.robot.group(problem.hand.hand)) {
    const double whole = closed[joint] - open[joint];
    if (whole != 0) sum += (q[joint] - open[joint]) / whole;
  }
  return sum;
}

}  // namespace

bool squeeze(ClaspSearch& search, planning::Path& reach, planning::Path& close) {
  Query& query = search.query();
  const Problem& problem = query.problem;
  double best = closure(problem, close.back());
  bool is_better = false;
  VectorXd move = random_move(problem, query.rng);
  for (int failures = 0; failures < kFailures;) {
    poll();
    const VectorXd q = problem.robot.clamp(loosened(problem, close.back()) + move);
    planning::Path again;
    if (search.is_linked(q) && query.is_motion_free(close.back(), q))
      again = close_hand(query.free, problem.robot, problem.hand, q);
    if (again.empty() || !search.is_clasped(again.back()) ||
        closure(problem, again.back()) < best + kGain) {
      move = random_move(problem, query.rng);  // else the same again, as long as it helps
      ++failures;
      continue;
    }
    reach.insert(reach.end(), close.begin() + 1, close.end());
    reach.push_back(q);
    close = std::move(again);
    best = closure(problem, close.back());
    failures = 0;
    is_better = true;
  }
  return is_better;
}

}  // namespace graspless::clasp
