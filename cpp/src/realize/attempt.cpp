// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// One assignment of fingertips to fingers, carried through a plan.
#include "realize/attempt.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "realize/track.hpp"

namespace graspless::realize {
namespace {

constexpr int kBiases = 2;        // tried for a displacement, beside none
constexpr int kRegraspDraws = 8;  // configurations tried for a finger's new place
constexpr int kFirstIterations = 100, kDoublings = 4;  // of tree searches

Grip grip_of(const Row& row, double radius) {
  const auto count = static_cast<Eigen::Index>(row.fingers.size());
  Grip grip{Eigen::Matrix3Xd(3, count), Eigen::Matrix3Xd(3, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const FingerState& finger = row.fingers[i];
    grip.n_O.col(i) = finger.n_O.normalized();
    grip.center_O.col(i) = finger.p_OC - radius * grip.n_O.col(i);
  }
  return grip;
}

/// Grips of all segments; of a regrasp, the grip at its end.
std::vector<Grip> grips_of(const Plan& plan, double radius) {
  std::vector<Grip> grips;
  for (std::size_t k = 0; k < plan.segments.size(); ++k) {
    const int finger = plan.segments[k].finger;
    if (finger < 0) {
      grips.push_back(grip_of(plan.segments[k].rows.front(), radius));
      continue;
    }
    const Grip next = grip_of(plan.segments[k + 1].rows.front(), radius);
    grips.push_back(grips.back());
    grips.back().center_O.col(finger) = next.center_O.col(finger);
    grips.back().n_O.col(finger) = next.n_O.col(finger);
  }
  return grips;
}

// Parts of options.approach, tried in turn: a hand may not open as wide as that asks.
constexpr double kShorter[] = {1, 0.5, 0.25, 0.125};

}  // namespace

void Misses::note(int stage, double progress, const std::string& what) {
  if (std::tie(stage, progress) < std::tie(stage_, progress_)) return;
  if (std::tie(stage, progress) > std::tie(stage_, progress_)) counts_.clear();
  stage_ = stage;
  progress_ = progress;
  ++counts_[what];
}

std::string Misses::farthest() const {
  if (counts_.empty()) return "nothing was tried";
  const auto fewer = [](const auto& a, const auto& b) { return a.second < b.second; };
  return std::max_element(counts_.begin(), counts_.end(), fewer)->first;
}

Attempts::Attempts(const Problem& problem, const Plan& plan, const Eigen::VectorXd& q_home,
                   Hand hand, planning::Clock& clock, std::mt19937_64& rng, Misses& misses)
    : plan_(plan),
      q_home_(q_home),
      hand_(std::move(hand)),
      clock_(clock),
      rng_(rng),
      misses_(misses),
      grips_(grips_of(plan, problem.fingers.radius)) {}

bool Attempts::run(int round) {
  segments_.clear();
  is_strict_ = round < hand_.options.restarts / 4;
  reach_iterations_ = kFirstIterations << std::min(round / 4, kDoublings);
  const Grip& grip = grips_[0];
  const Eigen::Isometry3d& X_WO = plan_.segments.front().X_WO.front();
  const auto q = draw_grip(round);
  if (!q) return false;
  first_ = leave(grip, all(), X_WO, *q, 2, "before " + name(0));
  if (!first_) return false;
  push_reversed("touch", first_->rows, -1);
  if (!carry(0, *q)) return false;
  hand_.scene.set_contacts(grip.n_O, 0);
  hand_.scene.place_object(X_WO);
  const auto approach = reach(hand_, {}, q_home_, first_->q, reach_iterations_, clock_, rng_);
  if (!approach) {
    misses_.note(1 << 20, 1, "approach: no free path found from q_home to the first grip");
    return false;
  }
  push_still("approach", *approach, X_WO, -1);
  std::rotate(segments_.begin(), segments_.end() - 1, segments_.end());
  return true;
}

bool Attempts::carry(Index k, const Eigen::VectorXd& q) {
  if (clock_.is_out()) return false;
  if (k == plan_.segments.size()) return leave_for_good(q);
  return plan_.segments[k].finger < 0 ? displace(k, q) : regrasp(k, q);
}

bool Attempts::displace(Index k, const Eigen::VectorXd& q) {
  const Segment& segment = plan_.segments[k];
  const Grip& grip = grips_[k];
  const auto arcs = segment.X_WO.size() - 1;
  const auto samples = static_cast<int>(segment.rows.size() / arcs);
  const Stretch free{segment.X_WO, 2 * samples, grip.center_O, grip.center_O, all()};
  Stretch turning = free;
  turning.n_O = grip.n_O;
  for (int way = 0; way < 2 + kBiases && !clock_.is_out(); ++way) {
    if (way > 0 && is_strict_) break;
    const Bias bias = way < 2 ? std::nullopt : draw_bias(k, q);
    if (way >= 2 && !bias) break;
    hand_.scene.set_contacts(grip.n_O, all());
    Tracked rows = track(hand_, way == 0 ? turning : free, q, bias);
    if (!rows.is_complete()) {
      const int row = static_cast<int>(rows.reached * samples);
      misses_.note(stage(k), rows.reached,
                   name(k) + ", row " + std::to_string(row) + ": " + rows.fault);
      continue;
    }
    const Eigen::VectorXd last = rows.positions.back();
    push(segment.name, std::move(rows), static_cast<int>(k));
    segments_.back().scrub = scrub(hand_, segments_.back(), grip.n_O, all());
    if (carry(k + 1, last)) return true;
    segments_.pop_back();
  }
  return false;
}

bool Attempts::regrasp(Index k, const Eigen::VectorXd& q) {
  const int finger = plan_.segments[k].finger;
  const FingerMask moving = 1U << finger;
  const Grip &before = grips_[k - 1], &after = grips_[k];
  const Eigen::Isometry3d& X_WO = plan_.segments[k].X_WO.front();
  const auto off = leave(before, moving, X_WO, q, stage(k), name(k));
  if (!off) return false;
  TipTargets held = Stretch{{X_WO}, 1, before.center_O, before.center_O, all()}.targets(0);
  held.held = all() & ~moving;
  for (int draw = 0; draw < kRegraspDraws && !clock_.is_out(); ++draw) {
    const auto next = configuration(
        after, X_WO, draw == 0 ? off->q : Eigen::VectorXd((off->q + draw_seed(9, draw)) / 2),
        stage(k) + 1, name(k) + ", at the new place");
    if (!next) continue;
    const auto on = leave(after, moving, X_WO, *next, stage(k) + 2, name(k));
    if (!on) continue;
    hand_.scene.set_contacts(after.n_O, held.held);
    hand_.scene.place_object(X_WO);
    const auto way = reach(hand_, held, off->q, on->q, reach_iterations_, clock_, rng_);
    if (!way) {
      misses_.note(
          stage(k) + 3, 0,
          name(k) + ": no way found for finger " + std::to_string(finger) + " to its new place");
      continue;
    }
    push("release", off->rows, static_cast<int>(k));
    push_still("reach", *way, X_WO, static_cast<int>(k));
    push_reversed("touch", on->rows, static_cast<int>(k));
    for (auto s = segments_.end() - 3; s != segments_.end(); ++s)
      s->scrub = scrub(hand_, *s, after.n_O, held.held);
    if (carry(k + 1, *next)) return true;
    segments_.resize(segments_.size() - 3);
  }
  return false;
}

bool Attempts::leave_for_good(const Eigen::VectorXd& q) {
  const Index last = plan_.segments.size() - 1;
  const Eigen::Isometry3d& X_WO = plan_.segments[last].X_WO.back();
  const auto off = leave(grips_[last], all(), X_WO, q, stage(last + 1), "after " + name(last));
  if (!off) return false;
  hand_.scene.set_contacts(grips_[last].n_O, 0);
  hand_.scene.place_object(X_WO);
  const auto home = reach(hand_, {}, off->q, q_home_, reach_iterations_, clock_, rng_);
  if (!home) {
    misses_.note(1 << 20, 0, "retreat: no free path found back to q_home");
    return false;
  }
  push("release", off->rows, -1);
  push_still("retreat", *home, X_WO, -1);
  return true;
}

/// Moves fingers straight off the surface, as far as the hand opens.
std::optional<Attempts::Leaving> Attempts::leave(const Grip& grip, FingerMask fingers,
                                                 const Eigen::Isometry3d& X_WO,
                                                 const Eigen::VectorXd& q, int stage,
                                                 const std::string& where) {
  constexpr double kRowStep = 0.0025;  // [m]
  for (const double share : kShorter) {
    const double distance = share * hand_.options.approach;
    Stretch out{{X_WO},
                static_cast<int>(std::ceil(distance / kRowStep)),
                grip.center_O,
                grip.center_O,
                all()};
    for (Eigen::Index i = 0; i < grip.n_O.cols(); ++i) {
      if ((fingers >> i & 1U) != 0) out.to_O.col(i) -= distance * grip.n_O.col(i);
    }
    if (fingers != all()) out.n_O = grip.n_O;  // those that stay should not roll
    hand_.scene.set_contacts(grip.n_O, all());
    Tracked rows = track(hand_, out, q);
    if (!rows.is_complete()) {
      misses_.note(stage, rows.reached * distance, where + ", off the surface: " + rows.fault);
      continue;
    }
    hand_.scene.set_contacts(grip.n_O, all() & ~fingers);
    const Eigen::VectorXd last = rows.positions.back();
    if (hand_.scene.is_free(last)) return Leaving{std::move(rows), last};
    misses_.note(stage, distance, where + ", off the surface: " + describe_collision(hand_, last));
  }
  return std::nullopt;
}

std::string Attempts::name(Index k) const {
  return "segment " + std::to_string(k) + " (" + plan_.segments[k].name + ")";
}

FingerMask Attempts::all() const { return (1U << hand_.finger_of_fingertip.size()) - 1U; }

void Attempts::push(const std::string& name, Tracked rows, int plan_segment) {
  segments_.push_back({name, std::move(rows.positions), std::move(rows.X_WO), plan_segment});
}

void Attempts::push_reversed(const std::string& name, const Tracked& rows, int plan_segment) {
  segments_.push_back({name,
                       {rows.positions.rbegin(), rows.positions.rend()},
                       {rows.X_WO.rbegin(), rows.X_WO.rend()},
                       plan_segment});
}

void Attempts::push_still(const std::string& name, const std::vector<Eigen::VectorXd>& rows,
                          const Eigen::Isometry3d& X_WO, int plan_segment) {
  segments_.push_back(
      {name, rows, std::vector<Eigen::Isometry3d>(rows.size(), X_WO), plan_segment});
}

}  // namespace graspless::realize
