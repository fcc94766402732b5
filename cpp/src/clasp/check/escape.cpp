// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// check(): an independent attempt to move the object out of the closed hand.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "graspless/watch.hpp"

#include "clasp/check/checker.hpp"
#include "clasp/free_space/link_spheres.hpp"
#include "clasp/free_space/object_collision.hpp"
#include "geometry/segment.hpp"
#include "geometry/turn.hpp"

namespace graspless::clasp {
namespace {

constexpr int kSequences = 3, kMoves = 100, kMaxSteps = 25;  // steps per move
constexpr double kStep = 0.004, kTurn = 0.02;                // [m], [rad]

/// The robot at q as fixed bodies, and the object as a moving body. FCL decides what touches. Links
/// that spheres prove apart from the object are not asked about; a mistake there would let the
/// object out, and be noticed.
class MovingObject {
 public:
  MovingObject(const Problem& problem, const Eigen::VectorXd& q)
      : spheres_(link_spheres(problem.robot)),
        proofs_(spheres_.size()),
        clearance_(problem.object.borrow_outer_clearance()) {
    object_ = world_.add_body("object", problem.object.solid());
    problem.robot.forward(q, X_WL_);
    for (const auto& shape : problem.robot.shapes()) {
      const int body = world_.add_body(std::to_string(world_.num_bodies()), {shape.placed});
      world_.set_pose(body, X_WL_[shape.link]);
      pairs_.push_back({shape.link, world_.num_pairs()});
      world_.add_pair(object_, body);
    }
  }
  bool is_free(const Eigen::Isometry3d& X_WO) {
    poll();
    world_.set_pose(object_, X_WO);
    const Eigen::Isometry3d X_OW = X_WO.inverse();
    const auto touching = std::find_if(pairs_.begin(), pairs_.end(), [&](const Pair& pair) {
      const auto link = static_cast<std::size_t>(pair.link);
      return (may_touch(link, X_OW) && world_.touches(pair.index)) || world_.swallows(pair.index);
    });
    if (touching == pairs_.end()) return true;
    std::rotate(pairs_.begin(), touching, touching + 1);  // first in the next test
    return false;
  }

 private:
  struct Pair {
    int link, index;  // of the world
  };
  /// The spheres of a link prove that it was `apart` [m] from the object, or more, at X_OL.
  struct Proof {
    double apart = 0;
    Eigen::Isometry3d X_OL = Eigen::Isometry3d::Identity();
  };

  /// False if spheres prove a link apart from the object, here or where they did so last: no point
  /// of it has come as far since then.
  bool may_touch(std::size_t link, const Eigen::Isometry3d& X_OW) {
    constexpr double kEnough = 0.008;  // [m]
    const SphereTree& tree = spheres_[link];
    Proof& proof = proofs_[link];
    const Eigen::Isometry3d X_OL = X_OW * X_WL_[link];
    const double moved = (X_OL * tree[0].p_L - proof.X_OL * tree[0].p_L).norm() +
                         tree[0].outer * geometry::most_apart(X_OL.linear(), proof.X_OL.linear());
    if (moved >= proof.apart && moved > 0)
      proof = {distance_by_spheres(tree, X_OL, kEnough, *clearance_), X_OL};
    return proof.apart <= 0;
  }

  collision::World world_;
  int object_;
  std::vector<Pair> pairs_;
  std::vector<SphereTree> spheres_;  // of each link, as all that follow
  std::vector<Proof> proofs_;
  robot::Poses X_WL_;
  std::shared_ptr<collision::Clearance> clearance_;
};

Eigen::Vector3d random_direction(std::mt19937_64& rng) {
  std::normal_distribution<double> normal;
  Eigen::Vector3d v;
  do v = {normal(rng), normal(rng), normal(rng)};
  while (v.norm() < 1e-6);
  return v.normalized();
}

/// A small motion in W: a translation, or a rotation about an axis through the hand's centre.
Eigen::Isometry3d random_step(bool turns, const Eigen::Vector3d& center_W, std::mt19937_64& rng) {
  const Eigen::Vector3d direction = random_direction(rng);
  Eigen::Isometry3d step = Eigen::Isometry3d::Identity();
  if (!turns) {
    step.translation() = kStep * direction;
    return step;
  }
  return Eigen::Translation3d(center_W) * Eigen::AngleAxisd(kTurn, direction) *
         Eigen::Translation3d(-center_W);
}

/// Smallest ball about the mean of the nodes that contains the finger curves.
struct HandBall {
  Eigen::Vector3d center_W;
  double radius;  // [m]
};

HandBall hand_ball(const Problem& problem, const Eigen::VectorXd& q) {
  Eigen::Matrix3Xd nodes(3, 0);
  for (int i = 0; i < static_cast<int>(problem.hand.fingers.size()); ++i) {
    const Eigen::Matrix3Xd curve = curve_in_world(problem, i, q);
    nodes.conservativeResize(3, nodes.cols() + curve.cols());
    nodes.rightCols(curve.cols()) = curve;
  }
  const Eigen::Vector3d center = nodes.rowwise().mean();
  return {center, (nodes.colwise() - center).colwise().norm().maxCoeff()};
}

}  // namespace

bool comes_free(const Problem& problem, int loop, const Eigen::VectorXd& q) {
  const Eigen::Matrix3Xd& p_OL = problem.object.loops().found[loop].points;
  const HandBall hand = hand_ball(problem, q);
  // The curves lie in this ball, so a loop outside it is out of the hand.
  const auto is_out = [&](const Eigen::Isometry3d& X_WO) {
    const Eigen::Vector3d center_O = X_WO.inverse() * hand.center_W;
    return geometry::distance_to_loop(p_OL, center_O) > 1.2 * hand.radius;
  };
  MovingObject object(problem, q);
  std::mt19937_64 rng(20130901);
  for (int sequence = 0; sequence < kSequences; ++sequence) {
    Eigen::Isometry3d X_WO = problem.X_WO;
    for (int move = 0; move < kMoves; ++move) {
      const Eigen::Isometry3d step = random_step(move % 2 == 1, hand.center_W, rng);
      for (int i = 0; i < kMaxSteps && object.is_free(step * X_WO); ++i) X_WO = step * X_WO;
      if (is_out(X_WO)) return true;
    }
  }
  return false;
}

}  // namespace graspless::clasp
