// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/walk.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <Eigen/Geometry>

#include "geometry/turn.hpp"

namespace graspless::clasp {

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
  const std::vector<BallGroup> groups = sort_into_groups(p_CB_W_, radii_);
  for (Eigen::Index i = 0; i < radii_.size(); ++i) {
    if (hits(i, R_OW_ * p_CB_W_.col(i) + p_OC_)) hits_at_start_ = true;
  }
  for (const BallGroup& group : groups) {
    const auto balls = Eigen::seq(group.begin, group.end - 1);
    groups_.push_back({group, distance_(balls).minCoeff(), {R_OW_, p_OC_}});
  }
  next_due_.resize(groups_.size() + static_cast<std::size_t>(radii_.size()));
  checked_at_start_ = checked_at_;
  distance_at_start_ = distance_;
  groups_at_start_ = groups_;
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

/// True if a ball of a group hits the object at this step. If not, schedules the next check: of the
/// group if it is far from the object, else of each ball.
template <typename Travel>
bool ObjectWalk::group_hits(int index, const Pose& pose, Travel travel, int step, int max_steps) {
  constexpr double kFar = 4;  // steps
  Group& group = groups_[index];
  const int item = static_cast<int>(radii_.size()) + index;
  const double around = group.balls.around;
  const double most = travel(group.balls.middle, group.balls.radius);
  const double far = around + kFar * most;
  const double lower = clearance_.rough_bounds(pose * group.balls.middle, far).lower;
  double least = std::numeric_limits<double>::infinity();
  if (lower > far) {
    least = lower - around;
    schedule(item, least, most, step, max_steps);
  } else {
    for (Eigen::Index ball = group.balls.begin; ball < group.balls.end; ++ball) {
      const Eigen::Vector3d p_O = pose * p_CB_W_.col(ball);
      double left = distance_[ball] - (p_O - checked_at_.col(ball)).norm();
      if (left <= 0) {
        if (hits(ball, p_O)) {
          remember(static_cast<int>(ball));
          return true;
        }
        left = distance_[ball];
      }
      least = std::min(least, left);
      schedule(static_cast<int>(ball), left, travel(p_CB_W_.col(ball), 0), step, max_steps);
    }
  }
  group.bound = least;
  group.at = pose;
  return false;
}

/// Schedules the next check of a ball or group: the first step at which it may hit, given a
/// distance of at least `bound` [m] at step `from`.
void ObjectWalk::schedule(int item, double bound, double travel, int from, int max_steps) {
  const double safe = bound / (travel + 1e-12);
  if (safe >= max_steps - from) return;
  int& first = first_due_[from + static_cast<int>(std::max(0.0, safe)) + 1];
  next_due_[item] = first;
  first = item;
}

/// Keeps a ball that hit the object as the first of a few.
void ObjectWalk::remember(int ball) {
  auto at = std::find(recent_.begin(), recent_.end(), ball);
  if (at == recent_.end()) {
    if (recent_.size() < kRecent) recent_.push_back(ball);
    at = std::prev(recent_.end());
    *at = ball;
  }
  std::rotate(recent_.begin(), at, std::next(at));
}

/// True if a ball that hit lately hits at the first step of a move, as most of those do that end
/// there. No other ball need then be looked at.
bool ObjectWalk::stays(const Pose& first) {
  for (const int ball : recent_) {
    const Eigen::Vector3d p_O = first * p_CB_W_.col(ball);
    if (distance_[ball] > (p_O - checked_at_.col(ball)).norm() || !hits(ball, p_O)) continue;
    remember(ball);
    return true;
  }
  return false;
}

/// Moves until the next step would hit, and returns the number of steps. travel(p_CB_W, radius):
/// bound on the motion of balls about a point in a step [m]. pose_at(step): pose of the hand.
template <typename Travel, typename PoseAt>
int ObjectWalk::advance(int max_steps, Travel travel, PoseAt pose_at) {
  if (stays(pose_at(1))) {
    ++steps_;
    return 0;
  }
  first_due_.assign(static_cast<std::size_t>(max_steps) + 1, -1);
  const auto balls = static_cast<int>(radii_.size());
  const Pose start{R_OW_, p_OC_};
  for (int i = 0; i < static_cast<int>(groups_.size()); ++i) {
    const Group& group = groups_[i];
    const double moved = (start * group.balls.middle - group.at * group.balls.middle).norm() +
                         group.balls.radius * geometry::most_apart(R_OW_, group.at.R_OW);
    schedule(balls + i, group.bound - moved, travel(group.balls.middle, group.balls.radius), 0,
             max_steps);
  }
  for (int step = 1; step <= max_steps; ++step) {
    int next = first_due_[step];
    if (next < 0) continue;
    const Pose pose = pose_at(step);
    while (next >= 0) {
      const int item = next;
      next = next_due_[item];
      const bool is_ball = item < balls;
      const bool hit = is_ball ? hits(item, pose * p_CB_W_.col(item))
                               : group_hits(item - balls, pose, travel, step, max_steps);
      if (hit) {
        if (is_ball) remember(item);
        steps_ += step;
        return step - 1;
      }
      if (is_ball) schedule(item, distance_[item], travel(p_CB_W_.col(item), 0), step, max_steps);
    }
  }
  steps_ += max_steps + 1;
  return max_steps;
}

void ObjectWalk::translate(const Eigen::Vector3d& direction_W, int max_steps) {
  // In O, the hand moves in the opposite direction.
  const Eigen::Vector3d step_O = R_OW_ * (-step_ * direction_W);
  const auto travel = [this](const Eigen::Vector3d&, double) { return step_; };
  const int gone = advance(max_steps, travel, [&](int step) -> Pose {
    return {R_OW_, p_OC_, step * step_O};
  });
  p_OC_ += gone * step_O;
}

void ObjectWalk::rotate(const Eigen::Vector3d& axis_W, int max_steps) {
  const auto turned = [&](int step) -> Eigen::Matrix3d {
    return R_OW_ * Eigen::AngleAxisd(-step * turn_, axis_W).toRotationMatrix();
  };
  const auto travel = [&](const Eigen::Vector3d& p_CB_W, double radius) {
    return turn_ * (axis_W.cross(p_CB_W).norm() + radius);
  };
  const int gone = advance(max_steps, travel, [&](int step) -> Pose {
    return {turned(step), p_OC_};
  });
  R_OW_ = turned(gone);
}

}  // namespace graspless::clasp
