// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// An object that sinks by its own weight, until the hand holds it up. Lengths in the linear
// programs are mm.
#include <Eigen/Geometry>

#include "graspless/watch.hpp"

#include "clasp/stability/load.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using mechanics::Vector6d;

constexpr double kSettled = 0.01;   // a step that promises less ends the motion [mm]
constexpr double kKept = 0.3;       // least part of a promise that a step keeps
constexpr double kShortest = 1e-3;  // scale of a step
constexpr int kSteps = 500;         // in all
constexpr int kStepsOfPoints = 2;   // with the same near points: shorter than kReach

}  // namespace

Vector3d mean_of_surface(const Object& object) {
  return object.loops().surface.points.rowwise().mean();
}

/// One step down; false if there is none. `moved` is the motion of the object since its mean was at
/// mean_W.
bool LoadTester::sink(const Posture& hand, NearPoints& points, LoadStepper& stepper,
                      const Vector3d& mean_W, Isometry3d& moved) const {
  const auto height = [&](const Isometry3d& at) { return (at * mean_W).z() * kMetre; };
  Vector6d weight;
  weight << 0, 0, -1, (moved * mean_W - hand.center_W).cross(-Vector3d::UnitZ()) * kMetre / kArm;
  PosedContacts contacts(points, moved, bodies_, hand);
  const Vector6d move = stepper.step(weight, contacts).move;
  const double promised = weight.dot(move);
  if (promised < kSettled) return false;
  // The program is linear in the turn; a shorter step is allowed, too.
  for (double scale = 1; scale > kShortest; scale /= 2) {
    const Isometry3d next = motion_of(scale * move, hand.center_W) * moved;
    if (height(moved) - height(next) < kKept * scale * promised) continue;
    moved = next;
    return true;
  }
  return false;
}

Isometry3d LoadTester::hang(const Eigen::VectorXd& q, const Vector3d& center_W, double reach,
                            double most) const {
  Posture hand = posture(q, center_W);
  for (auto& twists : hand.twists) twists.resize(6, 0);  // no joint gives way
  Isometry3d X_WO = problem_.X_WO;
  const Vector3d mean_O = mean_of_surface(problem_.object);
  const double highest = (X_WO * mean_O).z();
  for (int steps = 0; steps < kSteps; steps += kStepsOfPoints) {
    NearPoints points = near_points(hand, reach + kReach, X_WO);
    LoadStepper stepper{Eigen::VectorXd()};
    Isometry3d moved = Isometry3d::Identity();
    int kept = 0;
    while (kept < kStepsOfPoints && sink(hand, points, stepper, X_WO * mean_O, moved)) {
      poll();
      ++kept;
    }
    X_WO = moved * X_WO;
    if (kept < kStepsOfPoints || highest - (X_WO * mean_O).z() > most) break;
  }
  return X_WO;
}

}  // namespace graspless::clasp
