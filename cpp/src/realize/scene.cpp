// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// The robot among planes, obstacles and the object.
#include "realize/scene.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fingertip/model/screw.hpp"

namespace graspless::realize {
namespace {

// A half-space as a box [m]: wider than any robot reaches, thick enough that none steps through.
constexpr double kPlaneWidth = 20, kPlaneThickness = 1;

double span(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2) {
  return q1.size() == 0 ? 0 : (q2 - q1).lpNorm<Eigen::Infinity>();
}

/// Number of checks of the replay between two rows: half way and the end at least.
double looks(double length, double resolution) {
  return std::max(2.0, std::ceil(length / resolution - 1e-9));
}

/// A box that represents a half-space, its top face in the plane.
geometry::PlacedShape plane_box() {
  geometry::PlacedShape placed{geometry::Box{{kPlaneWidth, kPlaneWidth, kPlaneThickness}}};
  placed.X_BG = Eigen::Translation3d(0, 0, -kPlaneThickness / 2);
  return placed;
}

Eigen::Isometry3d plane_pose(const Plane& plane, const Eigen::Vector3d& p_W) {
  const Eigen::Vector3d n_W = plane.n_W.normalized();
  Eigen::Isometry3d X_WB;
  X_WB = Eigen::Translation3d(p_W + (plane.offset - n_W.dot(p_W)) * n_W) *
         Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), n_W);
  return X_WB;
}

}  // namespace

HandScene::HandScene(const Problem& problem, const robot::Robot& robot,
                     std::vector<std::vector<int>> links, double allowance)
    : scene_(robot),
      links_(std::move(links)),
      allowance_(allowance),
      n_O_(3, static_cast<Eigen::Index>(links_.size())) {
  const Eigen::Vector3d p_WB = robot.X_WB().translation();
  for (const Plane& plane : problem.planes)
    scene_.add_obstacle(plane.name, {plane_box()}, plane_pose(plane, p_WB));
  for (const Obstacle& obstacle : problem.obstacles)
    scene_.add_obstacle(obstacle.name, obstacle.shapes, obstacle.X_WB);
  object_ = scene_.add_object(problem.object.name(), problem.object.solid());
  n_O_.colwise() = Eigen::Vector3d::UnitZ();
}

void HandScene::set_contacts(const Eigen::Matrix3Xd& n_O, FingerMask touching) {
  n_O_ = n_O;
  touching_ = touching;
  allow();
}

void HandScene::place_object(const Eigen::Isometry3d& X_WO) {
  X_WO_ = X_WO;
  scene_.move_object(object_, X_WO);
  allow();
}

void HandScene::allow() {
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Eigen::Vector3d out_W = -(X_WO_.linear() * n_O_.col(static_cast<Eigen::Index>(i)));
    const double depth = (touching_ >> i & 1U) != 0 ? allowance_ : 0;
    for (const int link : links_[i]) {
      if (scene_.link_body(link) < 0) continue;
      scene_.world().allow_contact(scene_.link_body(link), object_, out_W, depth);
    }
  }
}

bool HandScene::is_motion_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2,
                               double row_step, double resolution) {
  constexpr double kRounding = 1 + 1e-12;
  const double length = span(q1, q2);
  if (length == 0) return scene_.is_free(q1);
  const double rows = std::ceil(length / row_step);
  const double steps = rows * looks(length / rows, resolution);
  return scene_.is_free(q1, q2, length / steps * kRounding);
}

bool HandScene::is_motion_free(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2,
                               const Eigen::Isometry3d& X_WO2, double resolution) {
  const Eigen::Isometry3d X_WO1 = X_WO_;
  const mechanics::Vector6d twist_O = fingertip::screw_between(X_WO1, X_WO2);
  const int steps = static_cast<int>(looks(span(q1, q2), resolution));
  for (int i = 1; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    place_object(fingertip::along_screw(X_WO1, twist_O, s));
    if (!scene_.is_free(q1 + s * (q2 - q1))) return false;
  }
  return true;
}

std::string HandScene::collision(const Eigen::VectorXd& q) {
  const auto [a, b] = scene_.collision(q);
  return a.empty() ? "" : "'" + a + "' touches '" + b + "'";
}

}  // namespace graspless::realize
