// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace graspless::clasp {
namespace {

constexpr int kGroup = 8;  // balls

}  // namespace

ObjectWalk::ObjectWalk(const Eigen::Matrix3Xd& p_CB_W, const Eigen::VectorXd& radii,
                       const Eigen::Matrix3d& R_OW, const Eigen::Vector3d& p_OC,
                       const StabilityOptions& options, collision::Clearance& clearance)
    : p_CB_W_(p_CB_W),
      radii_(radii),
      R_OW_(R_OW),
      R_OW_start_(R_OW),
      p_OC_(p_OC),
      p_OC_start_(p_OC),
      step_(options.step),
      turn_(options.turn),
      clearance_(clearance),
      checked_at_(Eigen::Matrix3Xd::Zero(3, radii.size())),
      distance_(Eigen::VectorXd::Zero(radii.size())) {
  for (Eigen::Index i = 0; i < radii_.size(); ++i) {
    if (hits(i, R_OW_ * p_CB_W_.col(i) + p_OC_)) hits_at_start_ = true;
  }
  make_groups();
  checked_at_start_ = checked_at_;
  distance_at_start_ = distance_;
  groups_at_start_ = groups_;
}

void ObjectWalk::make_groups() {
  const auto balls = static_cast<int>(radii_.size());
  for (int begin = 0; begin < balls; begin += kGroup) {
    const int count = std::min(kGroup, balls - begin);
    const auto centers = p_CB_W_.middleCols(begin, count);
    const Eigen::Vector3d middle = centers.rowwise().mean();
    groups_.push_back({begin, begin + count, middle,
                       (centers.colwise() - middle).colwise().norm().maxCoeff(),
                       distance_.segment(begin, count).minCoeff(),
                       {R_OW_, p_OC_}});
  }
  const auto groups = static_cast<int>(groups_.size());
  travel_of_step_.setConstant(balls + groups, step_);
  travel_of_turn_.resize(balls + groups);
  travel_of_turn_.head(balls) = turn_ * p_CB_W_.colwise().norm().transpose();
  for (int i = 0; i < groups; ++i) {
    const auto& [begin, end, middle, radius, bound, at] = groups_[static_cast<std::size_t>(i)];
    travel_of_turn_[balls + i] = travel_of_turn_.segment(begin, end - begin).maxCoeff();
  }
  next_due_.resize(static_cast<std::size_t>(balls + groups));
}

void ObjectWalk::reset() {
  R_OW_ = R_OW_start_;
  p_OC_ = p_OC_start_;
  checked_at_ = checked_at_start_;
  distance_ = distance_at_start_;
  groups_ = groups_at_start_;
}

/// True if a ball at p_O hits the object. If not, stores its distance.
bool ObjectWalk::hits(Eigen::Index ball, const Eigen::Vector3d& p_O) {
  const double radius = radii_[ball];
  const auto distance = clearance_.bounds(p_O, radius);
  if (distance.upper < radius) return true;
  checked_at_.col(ball) = p_O;
  distance_[ball] = std::max(0.0, distance.lower - radius);
  return false;
}

/// True if a ball of a group hits the object at this step. If not, schedules the next check of each.
bool ObjectWalk::group_hits(Group& group, const Pose& pose, const Eigen::VectorXd& travel, int step,
                            int max_steps) {
  double least = std::numeric_limits<double>::infinity();
  for (int ball = group.begin; ball < group.end; ++ball) {
    const Eigen::Vector3d p_O = pose * p_CB_W_.col(ball);
    double left = distance_[ball] - (p_O - checked_at_.col(ball)).norm();
    if (left <= 0) {
      if (hits(ball, p_O)) return true;
      left = distance_[ball];
    }
    least = std::min(least, left);
    schedule(ball, left, travel[ball], step, max_steps);
  }
  group.bound = least;
  group.at = pose;
  return false;
}

/// Schedules the next check of a ball or group: the first step at which it may hit, given a distance
/// of at least `bound` [m] at step `from`.
void ObjectWalk::schedule(int item, double bound, double travel, int from, int max_steps) {
  const double safe = bound / (travel + 1e-12);
  if (safe >= max_steps - from) return;
  int& first =
      first_due_[static_cast<std::size_t>(from + static_cast<int>(std::max(0.0, safe)) + 1)];
  next_due_[static_cast<std::size_t>(item)] = first;
  first = item;
}

/// Moves until the next step would hit, and returns the number of steps. `travel`: bound on the
/// motion of each ball and group in a step [m]. pose_at(step): pose of the hand.
template <typename PoseAt>
int ObjectWalk::advance(const Eigen::VectorXd& travel, int max_steps, PoseAt pose_at) {
  first_due_.assign(static_cast<std::size_t>(max_steps) + 1, -1);
  const auto balls = static_cast<int>(radii_.size());
  const Pose start{R_OW_, p_OC_};
  for (int i = 0; i < static_cast<int>(groups_.size()); ++i) {
    const Group& group = groups_[static_cast<std::size_t>(i)];
    // The largest singular value of the difference of two rotations is its norm / sqrt(2).
    const double moved = (start * group.middle_C - group.at * group.middle_C).norm() +
                         group.radius * (R_OW_ - group.at.R_OW).norm() / M_SQRT2;
    schedule(balls + i, group.bound - moved, travel[balls + i], 0, max_steps);
  }
  for (int step = 1; step <= max_steps; ++step) {
    int next = first_due_[static_cast<std::size_t>(step)];
    if (next < 0) continue;
    const Pose pose = pose_at(step);
    while (next >= 0) {
      const int item = next;
      next = next_due_[static_cast<std::size_t>(item)];
      const bool is_ball = item < balls;
      const bool hit = is_ball ? hits(item, pose * p_CB_W_.col(item))
                               : group_hits(groups_[static_cast<std::size_t>(item - balls)], pose,
                                            travel, step, max_steps);
      if (hit) {
        steps_ += step;
        return step - 1;
      }
      if (is_ball) schedule(item, distance_[item], travel[item], step, max_steps);
    }
  }
  steps_ += max_steps + 1;
  return max_steps;
}

void ObjectWalk::translate(const Eigen::Vector3d& direction_W, int max_steps) {
  // In O, the hand moves in the opposite direction.
  const Eigen::Vector3d step_O = R_OW_ * (-step_ * direction_W);
  const int gone = advance(travel_of_step_, max_steps, [&](int step) -> Pose {
    return {R_OW_, p_OC_, step * step_O};
  });
  p_OC_ += gone * step_O;
}

void ObjectWalk::rotate(const Eigen::Vector3d& axis_W, int max_steps) {
  const auto turned = [&](int step) -> Eigen::Matrix3d {
    return R_OW_ * Eigen::AngleAxisd(-step * turn_, axis_W).toRotationMatrix();
  };
  const int gone = advance(travel_of_turn_, max_steps,
                           [&](int step) -> Pose { return {turned(step), p_OC_}; });
  R_OW_ = turned(gone);
}

}  // namespace graspless::clasp
