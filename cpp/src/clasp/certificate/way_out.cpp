// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/certificate/way_out.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graspless/geometry/linking.hpp"
#include "graspless/watch.hpp"

#include "geometry/segment.hpp"
#include "geometry/turn.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d random_vector(std::mt19937_64& rng, double size) {
  std::normal_distribution<double> normal(0, size);
  const double x = normal(rng), y = normal(rng), z = normal(rng);
  return {x, y, z};
}

Quaterniond rotation(const Vector3d& v) {
  const double angle = v.norm();
  return angle > 1e-12 ? Quaterniond(Eigen::AngleAxisd(angle, v / angle)) : Quaterniond::Identity();
}

}  // namespace

WayOut::WayOut(const StillHand& hand, const HandRing& ring, const Eigen::Matrix3Xd& curve_O,
               collision::Clearance& clearance, std::uint64_t seed)
    : p_CB_(hand.p_OB.colwise() - hand.p_OC),
      radii_(hand.radii),
      ring_C_(ring.points_O.colwise() - hand.p_OC),
      curve_O_(curve_O),
      reach_(hand.reach),
      clearance_(clearance),
      rng_(seed),
      clasp_{Quaterniond::Identity(), hand.p_OC},
      start_(clasp_),
      at_start_(std::numeric_limits<double>::infinity()) {
  const std::vector<BallGroup> groups = sort_into_groups(p_CB_, radii_);
  far_ = p_CB_.colwise().norm().transpose();
  clear_.resize(radii_.size());
  for (Eigen::Index i = 0; i < radii_.size(); ++i) {
    clear_[i] = clearance.distance(moved(clasp_, p_CB_.col(i))) - radii_[i];
    at_start_ = std::min(at_start_, clear_[i]);
  }
  for (const BallGroup& group : groups) {
    const auto range = Eigen::seq(group.begin, group.end - 1);
    groups_.push_back({group, clear_(range).minCoeff(), far_(range).maxCoeff()});
  }
  if (ring.points_O.cols() == 0) return;
  const auto [a, b] = ring.balls;
  across_C_ = (hand.p_OB.col(b) - hand.p_OB.col(a)).normalized();
  gap_C_ = (hand.p_OB.col(a) + hand.p_OB.col(b) + (hand.radii[a] - hand.radii[b]) * across_C_) / 2 -
           hand.p_OC;
}

/// Calls visit(ball, travel) for each ball that may come too near on a way to `pose`, until it
/// returns false. `shift` and `angle` are those of the way, `travel` bounds the length of the
/// ball's.
template <typename Visit>
bool WayOut::all_near(const Pose& pose, double shift, double angle, Visit visit) const {
  constexpr double kMargin = 1e-4;  // above the least length that stays_free() halves [m]
  const Eigen::Matrix3d R = pose.turn.toRotationMatrix();
  const Eigen::Matrix3d turned = R - Eigen::Matrix3d::Identity();
  const Vector3d shifted = pose.p_OC - clasp_.p_OC;
  const double most_turned = geometry::most_apart(R, Eigen::Matrix3d::Identity());
  for (const Group& group : groups_) {
    const double moved =
        (turned * group.balls.middle + shifted).norm() + most_turned * group.balls.radius;
    if (group.clear - level_ - moved > shift + angle * group.far + kMargin) continue;
    for (Eigen::Index i = group.balls.begin; i < group.balls.end; ++i) {
      const double travel = shift + angle * far_[i];
      const double left = clear_[i] - level_ - (turned * p_CB_.col(i) + shifted).norm();
      if (left <= travel + kMargin && !visit(i, travel)) return false;
    }
  }
  return true;
}

double WayOut::away(const Pose& pose) const {
  return geometry::distance_to_loop(curve_O_, pose.p_OC);
}

bool WayOut::is_linked(const Pose& pose) const {
  const Eigen::Matrix3Xd ring_O = (pose.turn.toRotationMatrix() * ring_C_).colwise() + pose.p_OC;
  return geometry::linking_number(curve_O_, ring_O) != 0;
}

/// Distance of a ball from the object beyond what it must keep, a lower bound [m].
double WayOut::spare(const Pose& pose, Eigen::Index ball) {
  const double radius = radii_[ball] + level_;
  if (radius <= 0) return std::numeric_limits<double>::infinity();
  return clearance_.bounds(moved(pose, p_CB_.col(ball)), radius).lower - radius;
}

bool WayOut::is_free(const Pose& pose) { return find_near(pose, 0, 0); }

/// True if no ball is too near at the end of a way; `near_` are then those that may be on it.
bool WayOut::find_near(const Pose& pose, double shift, double angle) {
  near_.clear();
  if (radii_.size() == 0) return true;
  if (spare(pose, last_touched_) < 0) return false;
  return all_near(pose, shift, angle, [&](Eigen::Index ball, double travel) {
    const double left = spare(pose, ball);
    if (left < 0) last_touched_ = ball;
    if (left < travel) near_.emplace_back(ball, left);
    return left >= 0;
  });
}

/// True if a ball keeps its distance on the way between two poses. `at_from`, `at_to`: what it has
/// to spare there, `travel`: bound on the length of its way.
bool WayOut::stays_free(Eigen::Index ball, const Pose& from, double at_from, const Pose& to,
                        double at_to, double travel) {
  constexpr double kLeast = 1e-5;  // [m]
  if (at_from + at_to >= travel) return true;
  if (travel < kLeast) return false;
  const Pose half{from.turn.slerp(0.5, to.turn), (from.p_OC + to.p_OC) / 2};
  const double at_half = spare(half, ball);
  return at_half >= 0 && stays_free(ball, from, at_from, half, at_half, travel / 2) &&
         stays_free(ball, half, at_half, to, at_to, travel / 2);
}

/// True if no ball comes too near on the way. The first pose is free.
bool WayOut::is_free(const Pose& from, const Pose& to) {
  const double shift = (to.p_OC - from.p_OC).norm(), angle = from.turn.angularDistance(to.turn);
  if (!find_near(to, shift, angle)) return false;
  return std::all_of(near_.begin(), near_.end(), [&](const auto& near) {
    const auto& [ball, at_to] = near;
    const double travel = shift + angle * far_[ball];
    return stays_free(ball, from, std::max(0.0, spare(from, ball)), to, at_to, travel);
  });
}

/// A pose in which a corner of the loop lies in the middle of the gap, square to it. Corners near
/// the hand are likelier.
WayOut::Pose WayOut::gate() {
  constexpr double kTurn = 0.3, kAlong = 0.15;  // spread [rad], and as a fraction of the loop
  const Eigen::Index n = curve_O_.cols();
  Eigen::Index at = 0;
  (curve_O_.colwise() - moved(start_, gap_C_)).colwise().squaredNorm().minCoeff(&at);
  std::normal_distribution<double> normal(0, kAlong * static_cast<double>(n));
  at = ((at + static_cast<Eigen::Index>(std::lround(normal(rng_)))) % n + n) % n;
  const Vector3d along = (curve_O_.col((at + 2) % n) - curve_O_.col((at + n - 2) % n)).normalized();
  Pose pose{rotation(random_vector(rng_, kTurn)) * start_.turn, Vector3d::Zero()};
  const Vector3d across = pose.turn * across_C_, square = across - along * along.dot(across);
  if (square.norm() > 1e-6) pose.turn = Quaterniond::FromTwoVectors(across, square) * pose.turn;
  pose.p_OC = curve_O_.col(at) - pose.turn * gap_C_;
  return pose;
}

/// A pose farther away from the nearest point of the loop.
WayOut::Pose WayOut::outwards(const Pose& from) {
  Eigen::Index at = 0;
  (curve_O_.colwise() - from.p_OC).colwise().squaredNorm().minCoeff(&at);
  const Vector3d out = (from.p_OC - curve_O_.col(at)).normalized();
  return {rotation(random_vector(rng_, 0.05)) * from.turn,
          from.p_OC + reach_ * out + random_vector(rng_, 0.02)};
}

/// A pose at a random distance, small ones as often as large ones.
WayOut::Pose WayOut::nearby(const Pose& from, double most) {
  constexpr double kLeast = 3e-4, kLever = 0.1;  // [m]
  std::uniform_real_distribution<double> power(std::log(kLeast), std::log(most));
  const double size = std::exp(power(rng_));
  return {rotation(random_vector(rng_, size / kLever)) * from.turn,
          from.p_OC + random_vector(rng_, size)};
}

double WayOut::settle(double enough, int moves) {
  constexpr double kRise = 2e-4, kMost = 0.01;  // [m]
  level_ = at_start_;
  for (int move = 0; move < moves && level_ < enough; ++move) {
    poll();
    ++moves_;
    const Pose to = nearby(start_, kMost);
    const double before = level_;
    if (!is_free(start_, to)) continue;
    level_ = std::min(enough, level_ + kRise);
    if (!is_free(to) || !is_linked(to)) {
      level_ = before;
      continue;
    }
    start_ = to;
  }
  return at_start_ = level_;
}

/// A node, rather one that is far from the clasp.
std::size_t WayOut::pick() {
  constexpr int kDraws = 3;
  std::uniform_int_distribution<std::size_t> any(0, tree_.size() - 1);
  std::size_t best = any(rng_);
  for (int i = 1; i < kDraws; ++i) {
    const std::size_t other = any(rng_);
    if (tree_[other].away > tree_[best].away) best = other;
  }
  return best;
}

/// Goes from a node towards a pose, as far as halving the way finds free.
bool WayOut::go(std::size_t node, const Pose& to) {
  constexpr int kHalvings = 3;
  const Pose from = tree_[node].pose;
  double t = 1;
  for (int i = 0; i <= kHalvings; ++i, t /= 2) {
    const Pose goal{from.turn.slerp(t, to.turn), from.p_OC + t * (to.p_OC - from.p_OC)};
    if (!is_free(from, goal)) continue;
    tree_.push_back({goal, away(goal)});
    return true;
  }
  return false;
}

bool WayOut::exists(double clearance, int moves) {
  level_ = clearance;
  tree_.clear();
  if (!is_free(start_)) return false;
  tree_.push_back({start_, away(start_)});
  std::uniform_real_distribution<double> unit(0, 1);
  for (int move = 0; move < moves; ++move) {
    poll();
    ++moves_;
    const std::size_t node = pick();
    const Pose& from = tree_[node].pose;
    const double kind = unit(rng_);
    const Pose to = kind < 0.3 ? gate() : kind < 0.5 ? outwards(from) : nearby(from, 0.06);
    if (go(node, to) && tree_.back().away > reach_) return true;
  }
  return false;
}

}  // namespace graspless::clasp
