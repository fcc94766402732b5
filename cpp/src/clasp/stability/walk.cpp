// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability/walk.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace graspless::clasp {

ObjectWalk::ObjectWalk(const Eigen::Matrix3Xd& p_CB_W, const Eigen::VectorXd& radii,
                       const Eigen::Matrix3d& R_OW, const Eigen::Vector3d& p_OC,
                       const StabilityOptions& options, collision::Clearance& clearance)
    : p_CB_W_(p_CB_W),
      radii_(radii),
      travel_of_step_(Eigen::VectorXd::Constant(radii.size(), options.step)),
      travel_of_turn_(options.turn * p_CB_W.colwise().norm().transpose()),
      R_OW_(R_OW),
      R_OW_start_(R_OW),
      p_OC_(p_OC),
      p_OC_start_(p_OC),
      step_(options.step),
      turn_(options.turn),
      clearance_(clearance),
      checked_at_(3, radii.size()),
      distance_(radii.size()),
      next_due_(static_cast<std::size_t>(radii.size())) {
  for (Eigen::Index i = 0; i < radii_.size(); ++i) {
    if (hits(i, R_OW_ * p_CB_W_.col(i) + p_OC_)) hits_at_start_ = true;
  }
  checked_at_start_ = checked_at_;
  distance_at_start_ = distance_;
}

void ObjectWalk::reset() {
  R_OW_ = R_OW_start_;
  p_OC_ = p_OC_start_;
  checked_at_ = checked_at_start_;
  distance_ = distance_at_start_;
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

/// Schedules the next check of a ball: the first step at which it may hit, given a distance of at
/// least `bound` [m] at step `from`.
void ObjectWalk::schedule(int ball, double bound, double travel, int from, int max_steps) {
  const double safe = bound / (travel + 1e-12);
  if (safe >= max_steps - from) return;
  int& first =
      first_due_[static_cast<std::size_t>(from + static_cast<int>(std::max(0.0, safe)) + 1)];
  next_due_[static_cast<std::size_t>(ball)] = first;
  first = ball;
}

/// Moves until the next step would hit, and returns the number of steps. `travel`: bound on the
/// motion of each ball in a step [m]. place_at(ball, step): position of a ball in O.
template <typename PlaceAt>
int ObjectWalk::advance(const Eigen::VectorXd& travel, int max_steps, PlaceAt place_at) {
  first_due_.assign(static_cast<std::size_t>(max_steps) + 1, -1);
  for (int i = 0; i < static_cast<int>(radii_.size()); ++i) {
    schedule(i, distance_[i] - (place_at(i, 0) - checked_at_.col(i)).norm(), travel[i], 0,
             max_steps);
  }
  for (int step = 1; step <= max_steps; ++step) {
    int next = first_due_[static_cast<std::size_t>(step)];
    while (next >= 0) {
      const int ball = next;
      next = next_due_[static_cast<std::size_t>(ball)];
      if (hits(ball, place_at(ball, step))) {
        steps_ += step;
        return step - 1;
      }
      schedule(ball, distance_[ball], travel[ball], step, max_steps);
    }
  }
  steps_ += max_steps + 1;
  return max_steps;
}

void ObjectWalk::translate(const Eigen::Vector3d& direction_W, int max_steps) {
  // In O, the hand moves in the opposite direction.
  const Eigen::Vector3d step_O = R_OW_ * (-step_ * direction_W);
  const int gone = advance(travel_of_step_, max_steps, [&](int ball, int step) -> Eigen::Vector3d {
    return R_OW_ * p_CB_W_.col(ball) + p_OC_ + step * step_O;
  });
  p_OC_ += gone * step_O;
}

void ObjectWalk::rotate(const Eigen::Vector3d& axis_W, int max_steps) {
  const auto turned = [&](int step) -> Eigen::Matrix3d {
    return R_OW_ * Eigen::AngleAxisd(-step * turn_, axis_W).toRotationMatrix();
  };
  int at = -1;
  Eigen::Matrix3d R_OW;  // cached for that step, at which several balls may be due
  const int gone = advance(travel_of_turn_, max_steps, [&](int ball, int step) -> Eigen::Vector3d {
    if (step != at) R_OW = turned(at = step);
    return R_OW * p_CB_W_.col(ball) + p_OC_;
  });
  R_OW_ = turned(gone);
}

}  // namespace graspless::clasp
