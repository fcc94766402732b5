// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slide/contact_space.hpp"

#include <cmath>

#include "graspless/watch.hpp"

#include "scene/rows.hpp"
#include "slide/task/hand_frames.hpp"

namespace graspless::slide {

using planning::BandProjection;

namespace {

// Part of each tolerance is reserved for the straight motions between projected configurations.
constexpr double kPitchPlay = 2e-3;  // [rad]
constexpr double kColumns = 0.0055;  // by which columns may be higher than a level face [m]

/// A pose out of reach, for an object whose pose is not known yet.
Eigen::Isometry3d parked() {
  constexpr double kFar = 1e3;  // [m]
  return Eigen::Isometry3d(Eigen::Translation3d(0, 0, kFar));
}

}  // namespace

scene::Scene make_scene(const Problem& problem) {
  scene::Scene scene(problem.robot);
  scene.add_obstacle(kSupportBody, problem.support.solid(), problem.support.X_WS());
  const int object = scene.add_object(kObjectBody, problem.object.solid());
  for (const Obstacle& obstacle : problem.obstacles) {
    const int body = scene.add_obstacle(obstacle.label(), obstacle.solid(), obstacle.X_WB);
    scene.world().add_pair(object, body);
  }
  scene.move_object(object, problem.X_WO_start);
  const Arm arm(problem);
  keep_links_apart(scene, problem, {problem.q_home, arm.open()});
  return scene;
}

void keep_links_apart(scene::Scene& scene, const Problem& problem,
                      const std::vector<Eigen::VectorXd>& given) {
  scene.keep_links_apart(kLinkClearance, problem.robot.group(problem.hand.arm), given);
}

ContactSpace::ContactSpace(const Problem& problem, const Options& options, const Arm& arm,
                           const scene::Scene& scene)
    : problem_(problem),
      options_(options),
      arm_(arm),
      X_SW_(problem.support.X_WS().inverse()),
      normal_W_(problem.support.normal_W()),
      top_(problem.object.top()),
      fingertip_(problem.robot.frame(problem.hand.fingertip)),
      scene_(scene),
      object_body_(scene_.world().body(kObjectBody)),
      q_(arm.open()),
      projection_(make_projection()) {
  // The bands limit the depth of the sliding finger, so its contacts with support and prisms need
  // no test here. check() tests them. Other objects may have walls beside the finger.
  const double deepest =
      depth_band(problem.hand, options).max + allowed_sink(problem.hand) + kHeightTolerance;
  for (const std::string& link : problem.hand.sliding_finger) {
    const int body = scene_.link_body(problem.robot.frame(link));
    if (body < 0) continue;
    if (problem.object.heights())
      scene_.world().allow_contact(body, object_body_, normal_W_, deepest + kColumns);
    else
      scene_.world().remove_pair(body, object_body_);
    scene_.world().remove_pair(body, scene_.world().body(kSupportBody));
  }
  scene_.move_object(object_body_, parked());
}

BandProjection ContactSpace::make_projection() {
  const double play = std::min(kPitchPlay, options_.pitch_tolerance / 4);
  const double tolerance = options_.pitch_tolerance - play;
  BandProjection::Bands bands{BandProjection::Values(3), BandProjection::Values(3),
                              BandProjection::Values(3)};
  const DepthBand depth = depth_band(problem_.hand, options_);
  bands.lower << top_ - depth.max, std::sin(options_.pitch - tolerance), -kRollTolerance / 2;
  bands.upper << top_ - depth.min, std::sin(options_.pitch + tolerance), kRollTolerance / 2;
  bands.slack << kHeightTolerance, play * std::cos(options_.pitch + options_.pitch_tolerance),
      kRollTolerance / 2;
  // Between two checked configurations a value may exceed its band a little more.
  constexpr double kBetweenSamples = 0.9;
  bands.slack *= kBetweenSamples;
  return BandProjection([this](const auto& arm, auto& value, auto* J) { rows(arm, value, J); },
                        bands, {arm_.lower(), arm_.upper()});
}

void ContactSpace::rows(const Eigen::VectorXd& arm, BandProjection::Values& value,
                        BandProjection::Jacobian* J) {
  arm_.write(arm, q_);
  problem_.robot.forward_to(fingertip_, q_, X_WL_);
  row_values(value);
  if (!J) return;
  const Eigen::Isometry3d& X_WF = X_WL_[fingertip_];
  const Eigen::Vector3d x = X_WF.linear().col(0), z = X_WF.linear().col(2);
  problem_.robot.jacobian(fingertip_, X_WL_, J_);
  const Eigen::Vector3d dpitch = -z.cross(normal_W_),
                        droll = x.cross(normal_W_);  // (w x z).n = w.(z x n)
  for (int i = 0; i < arm_.dof(); ++i) {
    const auto column = J_.col(arm_.joints()[i]);
    J->col(i) << normal_W_.dot(column.head<3>()), dpitch.dot(column.tail<3>()),
        droll.dot(column.tail<3>());
  }
}

void ContactSpace::row_values(BandProjection::Values& value) const {
  const Eigen::Isometry3d& X_WF = X_WL_[fingertip_];
  value << normal_W_.dot(X_WF.translation() - problem_.support.X_WS().translation()),
      -X_WF.linear().col(2).dot(normal_W_), X_WF.linear().col(0).dot(normal_W_);
}

Tip ContactSpace::tip_at(const Eigen::VectorXd& arm) {
  arm_.write(arm, q_);
  problem_.robot.forward_to(fingertip_, q_, X_WL_);
  return tip(X_SW_ * X_WL_[fingertip_]);
}

Planar ContactSpace::effective(const Tip& tip) const {
  return effective_tip(problem_.hand, tip, top_, options_.pitch);
}

bool ContactSpace::keeps_contact(Planar& effective) const {
  BandProjection::Values value(3);
  row_values(value);
  if (!projection_.is_satisfied(value)) return false;
  const Tip now = tip(X_SW_ * X_WL_[fingertip_]);
  if (!now.other_finger_up) return false;
  effective = this->effective(now);
  const geometry::Polygon& Q = problem_.support.polygon();
  return Q.contains(now.position) && Q.has_margin(effective.translation(), options_.tip_margin);
}

scene::Scene& ContactSpace::scene_with_object_at(const Planar& object_S) {
  scene_.move_object(object_body_, problem_.support.X_WS() * spatial(object_S));
  object_parked_ = false;
  return scene_;
}

void ContactSpace::place_object(const std::optional<Carried>& carried, const Planar& effective) {
  if (carried) {
    scene_with_object_at(object_pose(effective, carried->tip_start, carried->object_start));
  } else if (!object_parked_) {
    scene_.move_object(object_body_, parked());
    object_parked_ = true;
  }
}

bool ContactSpace::is_valid(const Eigen::VectorXd& arm, const std::optional<Carried>& carried) {
  Planar effective;
  arm_.write(arm, q_);
  problem_.robot.forward(q_, X_WL_);
  touching_.reset();
  if (!keeps_contact(effective)) return false;
  place_object(carried, effective);
  touching_ = scene_.first_collision(X_WL_);
  return !touching_;
}

bool ContactSpace::is_motion_valid(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                   const std::optional<Carried>& carried, double resolution) {
  const Eigen::VectorXd step = to - from;
  const int pieces = scene::replay_steps(arm_.span(step), resolution);
  // Backwards from the far end, where a violation shows earliest.
  for (int i = pieces; i >= 1; --i) {
    poll();
    if (!is_valid(from + step * i / pieces, carried)) return false;
  }
  return true;
}

std::optional<planning::Path> ContactSpace::connect(const Eigen::VectorXd& from,
                                                    const Eigen::VectorXd& to,
                                                    const std::optional<Carried>& carried) {
  planning::Path path{from};
  for (double left = (to - from).norm(); left > 0;) {
    poll();
    Eigen::VectorXd next = path.back() + std::min(1.0, options_.range / left) * (to - path.back());
    if (left <= options_.range) next = to;
    if (!project(next)) return std::nullopt;
    double now_left = (to - next).norm();
    if (now_left < 1e-12) now_left = 0;  // the target may be nearer than the least progress
    if ((now_left > 0 && now_left > left - 1e-3 * options_.range) ||
        !is_motion_valid(path.back(), next, carried, options_.resolution)) {
      return std::nullopt;
    }
    path.push_back(next);
    left = now_left;
  }
  return path;
}

}  // namespace graspless::slide
