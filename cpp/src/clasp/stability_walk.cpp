// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/stability_walk.hpp"

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
      bound_(radii.size()),
      looked_(radii.size()) {
  for (Eigen::Index i = 0; i < radii_.size(); ++i) {
    if (look(i, R_OW_ * p_CB_W_.col(i) + p_OC_)) hits_at_start_ = true;
  }
  bound_start_ = bound_;
}

void ObjectWalk::to_start() {
  R_OW_ = R_OW_start_;
  p_OC_ = p_OC_start_;
  bound_ = bound_start_;
}

/// Whether a ball hits the object; if not, how far it is from it.
bool ObjectWalk::look(Eigen::Index ball, const Eigen::Vector3d& p_O) {
  const double radius = radii_[ball];
  const auto distance = clearance_.bounds(p_O, radius);
  if (distance.upper < radius) return true;
  bound_[ball] = std::max(0.0, distance.lower - radius);
  return false;
}

/// Goes on until a ball hits; returns the steps gone. `travel` of each ball in a step [m];
/// place_at(ball, step) is where it is then, in O.
template <typename PlaceAt>
int ObjectWalk::advance(const Eigen::VectorXd& travel, int most, PlaceAt place_at) {
  const auto later = [](const Due& a, const Due& b) {
    return a.step != b.step ? a.step > b.step : a.ball > b.ball;
  };
  // The first step at which a ball whose bound was found at step `from` may hit.
  const auto due_step = [&](Eigen::Index ball, int from) {
    const double safe = bound_[ball] / (travel[ball] + 1e-12);
    return safe < most ? from + static_cast<int>(safe) + 1 : most + 1;
  };
  due_.clear();
  looked_.setZero();
  for (Eigen::Index i = 0; i < radii_.size(); ++i) {
    const int step = due_step(i, 0);
    if (step <= most) due_.push_back({step, static_cast<int>(i)});
  }
  std::make_heap(due_.begin(), due_.end(), later);
  int gone = most;
  while (!due_.empty()) {
    std::pop_heap(due_.begin(), due_.end(), later);
    const Due next = due_.back();
    due_.pop_back();
    if (look(next.ball, place_at(next.ball, next.step))) {
      gone = next.step - 1;
      break;
    }
    looked_[next.ball] = next.step;
    const int again = due_step(next.ball, next.step);
    if (again > most) continue;
    due_.push_back({again, next.ball});
    std::push_heap(due_.begin(), due_.end(), later);
  }
  bound_ -= (gone - looked_.array()).abs().cast<double>().matrix().cwiseProduct(travel);
  bound_ = bound_.cwiseMax(0);
  steps_ += gone + 1;
  return gone;
}

void ObjectWalk::translate(const Eigen::Vector3d& direction_W, int most) {
  // Seen from the object, the hand goes the other way.
  const Eigen::Vector3d step_O = R_OW_ * (-step_ * direction_W);
  const int gone = advance(travel_of_step_, most, [&](int ball, int step) -> Eigen::Vector3d {
    return R_OW_ * p_CB_W_.col(ball) + p_OC_ + step * step_O;
  });
  p_OC_ += gone * step_O;
}

void ObjectWalk::rotate(const Eigen::Vector3d& axis_W, int most) {
  const auto turned = [&](int step) -> Eigen::Matrix3d {
    return R_OW_ * Eigen::AngleAxisd(-step * turn_, axis_W).toRotationMatrix();
  };
  int at = -1;
  Eigen::Matrix3d R_OW;  // at that step: several balls are often due at one
  const int gone = advance(travel_of_turn_, most, [&](int ball, int step) -> Eigen::Vector3d {
    if (step != at) R_OW = turned(at = step);
    return R_OW * p_CB_W_.col(ball) + p_OC_;
  });
  R_OW_ = turned(gone);
}

}  // namespace graspless::clasp
