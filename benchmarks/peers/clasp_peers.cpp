// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp_peers.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "graspless/geometry/linking.hpp"
#include "graspless/geometry/sampling.hpp"

#include "clasp/close.hpp"
#include "clasp/free_space/free_space.hpp"
#include "clasp/hand/kinematics.hpp"
#include "grasp_quality.hpp"

namespace graspless::benchmarks {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kResolution = 0.02;  // between checked configurations [rad]
constexpr double kTouching = 0.004;   // a hand's point this near to the object touches it [m]
constexpr int kPointsPerLink = 150;

class GraspRrt {
 public:
  GraspRrt(const clasp::Problem& problem, const GraspRrtOptions& options,
           const planning::Budget& budget)
      : problem_(problem),
        options_(options),
        budget_(budget),
        free_(problem),
        hand_(problem.robot, problem.hand),
        arm_(problem.robot.group(problem.hand.arm)),
        frame_(problem.robot.frame(problem.hand.frame)),
        rng_(budget.seed) {
    sample_hand();
    const Eigen::Matrix3Xd& cloud = problem.object.points();
    center_O_ = cloud.rowwise().mean();
    size_ = (cloud.colwise() - center_O_).colwise().norm().maxCoeff();
  }

  Grasp search() {
    planning::Clock clock(budget_);
    tree_.push_back(problem_.q_start);
    while (!grasp_.found && clock.spend()) {
      extend();
      if (unit() < options_.approach_probability) try_grasp();
    }
    grasp_.nodes = static_cast<std::int64_t>(tree_.size());
    grasp_.seconds = clock.seconds();
    return grasp_;
  }

 private:
  double unit() { return std::uniform_real_distribution<double>()(rng_); }

  void extend() {
    VectorXd q_random = problem_.q_start;
    for (const int joint : arm_) {
      const double lower = problem_.robot.lower()[joint], upper = problem_.robot.upper()[joint];
      q_random[joint] = lower + unit() * (upper - lower);
    }
    const auto distance = [&](const VectorXd& q) { return (q - q_random).squaredNorm(); };
    const VectorXd& near = *std::min_element(
        tree_.begin(), tree_.end(),
        [&](const VectorXd& a, const VectorXd& b) { return distance(a) < distance(b); });
    const VectorXd step = q_random - near;
    const double longest = step.cwiseAbs().maxCoeff();
    VectorXd q = near + step * std::min(1.0, options_.max_step / longest);
    if (free_.is_free(near, q, kResolution)) tree_.push_back(std::move(q));
  }

  /// From a node at random towards a point of the surface at random; then the fingers close.
  void try_grasp() {
    ++grasp_.approaches;
    const VectorXd& q_from = tree_[static_cast<std::size_t>(unit() * num(tree_.size()))];
    const Eigen::Matrix3Xd& cloud = problem_.object.points();
    const auto target = static_cast<Eigen::Index>(unit() * num(cloud.cols()));
    const std::optional<VectorXd> q = approach(q_from, problem_.X_WO * cloud.col(target));
    if (!q) return;
    const VectorXd q_closed = clasp::close_hand(free_, problem_.robot, problem_.hand, *q).back();
    const std::vector<GraspContact> contacts = contacts_at(q_closed);
    if (contacts.size() < 2) return;
    ++grasp_.grasps;
    const double quality = grasp_quality(contacts, center_O_, size_, options_.friction);
    if (quality < options_.min_quality) return;
    note(q_closed, quality, contacts);
  }

  /// The hand's middle goes to the point, its forward axis turned along the way, until that is
  /// reached or the hand touches something.
  std::optional<VectorXd> approach(VectorXd q, const Vector3d& p_W) {
    constexpr int kMaxSteps = 300;
    constexpr double kReached = 0.01;
    hand_.update(q);
    const Vector3d direction = (p_W - middle()).normalized();
    for (int i = 0; i < kMaxSteps; ++i) {
      hand_.update(q);
      if ((p_W - middle()).norm() < kReached) return q;
      const VectorXd next = step_towards(q, p_W, direction);
      if ((next - q).cwiseAbs().maxCoeff() < 1e-4) return std::nullopt;
      if (!free_.is_free(q, next, kResolution))
        return touches_object(next) ? std::optional(q) : std::nullopt;
      q = next;
    }
    return std::nullopt;
  }

  bool touches_object(const VectorXd& q) {
    const auto [a, b] = free_.collision(q);
    return a == problem_.object.name() || b == problem_.object.name();
  }

  VectorXd step_towards(const VectorXd& q, const Vector3d& p_W, const Vector3d& direction) {
    constexpr double kMaxTurn = 0.05, kDamping = 0.05;
    const Eigen::Isometry3d X_WH = hand_.poses()[frame_];
    Eigen::Matrix<double, 6, Eigen::Dynamic> J_all;
    problem_.robot.jacobian(frame_, hand_.poses(), J_all);
    Eigen::Matrix<double, 6, 1> error;
    error << p_W - middle(), hand_.forward_W().cross(direction);
    error.head<3>() *= std::min(1.0, 0.02 / error.head<3>().norm());
    error.tail<3>() *= 0.2;
    Eigen::MatrixXd J(6, static_cast<Eigen::Index>(arm_.size()));
    const Vector3d lever = middle() - X_WH.translation();
    for (std::size_t i = 0; i < arm_.size(); ++i) {
      const Vector3d turn = J_all.col(arm_[i]).tail<3>();
      const Vector3d linear = J_all.col(arm_[i]).head<3>() + turn.cross(lever);
      J.col(i) << linear, 0.3 * turn;  // lengths for angles [m]
    }
    error.tail<3>() *= 0.3;
    const Eigen::Matrix<double, 6, 6> damped =
        J * J.transpose() + kDamping * kDamping * Eigen::Matrix<double, 6, 6>::Identity();
    VectorXd dq = J.transpose() * damped.ldlt().solve(error);
    dq *= std::min(1.0, kMaxTurn / std::max(1e-12, dq.cwiseAbs().maxCoeff()));
    VectorXd next = q;
    for (std::size_t i = 0; i < arm_.size(); ++i) next[arm_[i]] += dq[i];
    return problem_.robot.clamp(next);
  }

  Vector3d middle() const {
    const Eigen::Matrix3Xd& nodes = hand_.nodes();
    return (nodes.rowwise().minCoeff() + nodes.rowwise().maxCoeff()) / 2;
  }

  /// Points on the links that the hand's joints move, and on the palm.
  void sample_hand() {
    std::vector<std::vector<geometry::PlacedShape>> shapes(problem_.robot.frame_names().size());
    for (const auto& shape : problem_.robot.shapes()) {
      if (is_of_hand(shape.link)) shapes[shape.link].push_back(shape.placed);
    }
    for (std::size_t link = 0; link < shapes.size(); ++link) {
      if (shapes[link].empty()) continue;
      links_.push_back(
          {static_cast<int>(link), geometry::sample_surface(shapes[link], kPointsPerLink)});
    }
  }

  bool is_of_hand(int link) const {
    for (; link >= 0; link = problem_.robot.parent(link)) {
      if (link == frame_) return true;
    }
    return false;
  }

  /// The nearest point of every link that touches; the normal from how the distance grows there.
  std::vector<GraspContact> contacts_at(const VectorXd& q) {
    hand_.update(q);
    const Eigen::Isometry3d X_OW = problem_.X_WO.inverse();
    const auto distance = [&](const Vector3d& p) {
      return problem_.object.clearance().distance(p);
    };
    std::vector<GraspContact> contacts;
    for (const auto& [link, points_L] : links_) {
      const Eigen::Isometry3d X_OL = X_OW * hand_.poses()[link];
      double least = kTouching;
      Vector3d nearest = Vector3d::Zero();
      for (const auto& p_L : points_L.colwise()) {
        const Vector3d p_O = X_OL * p_L;
        const double d = distance(p_O);
        if (d >= least) continue;
        least = d;
        nearest = p_O;
      }
      if (least >= kTouching) continue;
      constexpr double kStep = 1e-5;
      Vector3d away;
      for (int axis = 0; axis < 3; ++axis) {
        const Vector3d step = kStep * Vector3d::Unit(axis);
        away[axis] = distance(nearest + step) - distance(nearest - step);
      }
      if (away.norm() > 0) contacts.push_back({nearest, -away.normalized()});
    }
    return contacts;
  }

  void note(const VectorXd& q, double quality, const std::vector<GraspContact>& contacts) {
    grasp_.found = true;
    grasp_.q = q;
    grasp_.quality = quality;
    grasp_.p_OC.resize(3, static_cast<Eigen::Index>(contacts.size()));
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      grasp_.p_OC.col(i) = contacts[i].p_O;
    }
    hand_.update(q);
    for (int i = 0; i < hand_.num_curves(); ++i) {
      int most = 0;
      for (const geometry::Loop& loop : problem_.object.loops().found) {
        most = std::max(most, std::abs(geometry::linking_number(problem_.X_WO * loop.points,
                                                                hand_.curve_points(i))));
      }
      grasp_.linking.push_back(most);
      grasp_.envelops |= most > 0;
    }
  }

  static double num(std::size_t count) { return static_cast<double>(count); }
  static double num(Eigen::Index count) { return static_cast<double>(count); }

  struct LinkPoints {
    int link;
    Eigen::Matrix3Xd points_L;
  };

  const clasp::Problem& problem_;
  GraspRrtOptions options_;
  const planning::Budget& budget_;
  clasp::FreeSpace free_;
  clasp::HandKinematics hand_;
  std::vector<int> arm_;
  int frame_;
  std::mt19937_64 rng_;
  std::vector<VectorXd> tree_;
  std::vector<LinkPoints> links_;
  Vector3d center_O_;
  double size_;
  Grasp grasp_;
};

}  // namespace

Grasp grasp_rrt(const clasp::Problem& problem, const GraspRrtOptions& options,
                const planning::Budget& budget) {
  clasp::validate(problem);
  return GraspRrt(problem, options, budget).search();
}

}  // namespace graspless::benchmarks
