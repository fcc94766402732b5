// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Free motions by the planners' common search; motions that hold fingers still by CBiRRT over the
// positions of the held fingertips.
#include "planning/grow_path.hpp"
#include "planning/joints.hpp"
#include "realize/track.hpp"

namespace graspless::realize {
namespace {

using Configurations = planning::Path;
using planning::Joints;  // those that move fingertips

constexpr double kRange = 0.25;  // longest extension while fingers are held [rad]
constexpr int kProjections = 12;
constexpr int kShortcuts = 30;
constexpr int kDeepest = 12;  // halvings of a motion between two configurations

/// The joints' ranges, without a test of motions. It keeps references.
planning::FreeSpace space_of(Hand& hand, const Joints& joints, planning::Clock& clock) {
  return {joints.part(hand.ik.robot().lower()), joints.part(hand.ik.robot().upper()),
          [&](const Eigen::VectorXd& part) { return hand.scene.is_free(joints.full(part)); },
          nullptr, [&] { return clock.is_out(); }};
}

std::optional<Configurations> free_path(Hand& hand, const Eigen::VectorXd& from,
                                        const Eigen::VectorXd& to, int iterations,
                                        planning::Clock& clock, std::mt19937_64& rng) {
  const Joints joints{hand.ik.joints(), from};
  planning::FreeSpace space = space_of(hand, joints, clock);
  space.is_motion_free = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return hand.scene.is_motion_free(joints.full(a), joints.full(b), hand.options.max_jump,
                                     hand.options.resolution);
  };
  const auto path =
      planning::find_free_path(space, joints.part(from), joints.part(to), iterations, rng);
  if (!path) return std::nullopt;
  return planning::subdivided(joints.full(*path), hand.options.max_jump);
}

/// Motions on the manifold where the held fingertips stay where they are.
class HeldSpace {
 public:
  HeldSpace(Hand& hand, const TipTargets& held, const Joints& joints)
      : hand_(hand), held_(held), joints_(joints) {}

  bool project(Eigen::VectorXd& q) { return hand_.ik.solve(held_, kIkTolerance, kProjections, q); }

  /// Rows between two configurations near each other, without the first. Empty if the motion leaves
  /// the manifold or touches something. The same in both directions.
  std::optional<Configurations> rows(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    Configurations out;
    if (!append(a, b, kDeepest, out)) return std::nullopt;
    return out;
  }

  std::optional<Configurations> rows(const Configurations& path) {
    Configurations out{path.front()};
    for (std::size_t i = 1; i < path.size(); ++i) {
      const auto more = rows(path[i - 1], path[i]);
      if (!more) return std::nullopt;
      out.insert(out.end(), more->begin(), more->end());
    }
    return out;
  }

  std::optional<Configurations> grow(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                     int iterations, planning::Clock& clock, std::mt19937_64& rng);

 private:
  bool append(const Eigen::VectorXd& a, const Eigen::VectorXd& b, int deeper, Configurations& out) {
    const Eigen::VectorXd middle = (a + b) / 2;
    const double length = (b - a).lpNorm<Eigen::Infinity>();
    const bool is_near = length <= hand_.options.max_jump;
    if (is_near && hand_.ik.miss(held_, middle).first <= 0.8 * hand_.options.position_tolerance) {
      if (!hand_.scene.is_motion_free(a, b, hand_.options.max_jump, hand_.options.resolution)) {
        return false;
      }
      out.push_back(b);
      return true;
    }
    Eigen::VectorXd on = middle;
    if (deeper == 0 || !project(on) || !hand_.scene.is_free(on)) return false;
    if ((on - middle).lpNorm<Eigen::Infinity>() > length / 4 + 1e-6) return false;
    return append(a, on, deeper - 1, out) && append(on, b, deeper - 1, out);
  }

  Hand& hand_;
  const TipTargets& held_;
  const Joints& joints_;
};

std::optional<Configurations> HeldSpace::grow(const Eigen::VectorXd& from,
                                              const Eigen::VectorXd& to, int iterations,
                                              planning::Clock& clock, std::mt19937_64& rng) {
  planning::FreeSpace space = space_of(hand_, joints_, clock);
  space.is_motion_free = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return rows(joints_.full(a), joints_.full(b)).has_value();
  };
  const auto project_part = [&](Eigen::VectorXd& part) {
    Eigen::VectorXd q = joints_.full(part);
    if (!project(q)) return false;
    part = joints_.part(q);
    return true;
  };
  const Eigen::VectorXd start = joints_.part(from), end = joints_.part(to);
  if (!space.is_free(start) || !space.is_free(end)) return std::nullopt;
  const auto path = planning::grow_path(space, start, end, kRange, project_part, iterations, rng);
  if (!path) return std::nullopt;
  return joints_.full(*path);
}

std::optional<Configurations> held_path(Hand& hand, const TipTargets& held,
                                        const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                        int iterations, planning::Clock& clock,
                                        std::mt19937_64& rng) {
  const Joints joints{hand.ik.joints(), from};
  HeldSpace space(hand, held, joints);
  if (const auto straight = space.rows(Configurations{from, to})) return straight;
  const auto path = space.grow(from, to, iterations, clock, rng);
  if (!path) return std::nullopt;
  const planning::Connect connect = [&](const Eigen::VectorXd& a,
                                        const Eigen::VectorXd& b) -> std::optional<Configurations> {
    if (!space.rows(a, b)) return std::nullopt;
    return Configurations{a, b};
  };
  return space.rows(planning::shortcut(*path, connect, kShortcuts, rng));
}

}  // namespace

std::optional<Configurations> reach(Hand& hand, const TipTargets& held, const Eigen::VectorXd& from,
                                    const Eigen::VectorXd& to, int iterations,
                                    planning::Clock& clock, std::mt19937_64& rng) {
  if (held.held == 0) return free_path(hand, from, to, iterations, clock, rng);
  return held_path(hand, held, from, to, iterations, clock, rng);
}

}  // namespace graspless::realize
