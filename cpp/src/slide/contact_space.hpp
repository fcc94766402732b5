// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "graspless/planning/path.hpp"
#include "graspless/planning/projection.hpp"
#include "graspless/scene/scene.hpp"

#include "slide/arm.hpp"
#include "slide/contact.hpp"

namespace graspless::slide {

constexpr const char* kObjectBody = "object";
constexpr const char* kSupportBody = "support";

/// Makes a scene of the robot, the support, the obstacles, and the object as a movable body, in
/// which nothing may touch, and links keep kLinkClearance.
scene::Scene make_scene(const Problem& problem);

/// Lets the links keep kLinkClearance, except pairs that are built close to each other, or nearer
/// in one of the configurations `given`, from which the motion has to begin.
void keep_links_apart(scene::Scene& scene, const Problem& problem,
                      const std::vector<Eigen::VectorXd>& given);

/// The arm while its fingertip presses on the object: the relaxed constraint of Section IV-C.3.
///
/// Three constraint rows over the arm's joints: height of the tip over S, sine of its pitch, and
/// roll. Two more conditions have no gradient: the tip and its effective contact stay over the
/// support, and nothing collides.
class GRASPLESS_API ContactSpace {
 public:
  /// Effective tip and object pose at the start of the slide. Absent while the start is not known.
  struct Carried {
    Planar tip_start, object_start;
  };

  /// `scene`: as from make_scene(); copied.
  ContactSpace(const Problem& problem, const Options& options, const Arm& arm,
               const scene::Scene& scene);
  ContactSpace(const ContactSpace&) = delete;  // the projection calls back
  ContactSpace& operator=(const ContactSpace&) = delete;

  /// Writes the height of the tip over S [m], the sine of its pitch and its roll; unless `J` is
  /// null, also their derivatives.
  void rows(const Eigen::VectorXd& arm, planning::BandProjection::Values& value,
            planning::BandProjection::Jacobian* J);
  /// Projects the arm's joints onto the constraint; false if that fails.
  bool project(Eigen::VectorXd& arm) {
    ++num_projections_;
    return projection_.project(arm);
  }

  /// True if the constraint rows are in their bands; says nothing about the other conditions.
  bool is_pressing(const Eigen::VectorXd& arm) const { return projection_.is_satisfied(arm); }

  /// True if the motion between two near configurations keeps the constraint without collision, at
  /// joint steps of `resolution` [rad]. With `carried`, the object moves along and must not collide
  /// either.
  bool is_motion_valid(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                       const std::optional<Carried>& carried, double resolution);
  bool is_valid(const Eigen::VectorXd& arm, const std::optional<Carried>& carried);
  /// Pair of bodies of scene() that touched when is_valid() last returned false; nothing if the
  /// constraint was not kept.
  const std::optional<std::pair<int, int>>& touching() const { return touching_; }
  scene::Scene& scene() { return scene_; }
  /// Returns the straight motion, projected at steps of options.range; nothing if a projection or a
  /// check fails.
  std::optional<planning::Path> connect(const Eigen::VectorXd& from, const Eigen::VectorXd& to,
                                        const std::optional<Carried>& carried);

  /// The commanded tip at a configuration.
  Tip tip_at(const Eigen::VectorXd& arm);
  Planar effective_tip_at(const Eigen::VectorXd& arm) { return effective(tip_at(arm)); }
  Planar effective(const Tip& tip) const;
  /// The object's pose at a configuration of the slide, Eq. (2).
  Planar carry(const Carried& carried, const Eigen::VectorXd& arm) {
    return object_pose(effective_tip_at(arm), carried.tip_start, carried.object_start);
  }

  /// Returns the scene with the object at a fixed pose in S and without tests of the sliding finger
  /// against it. For pressing and lifting, which stay within the depths that the bands allow.
  scene::Scene& scene_with_object_at(const Planar& object_S);
  int num_checks() const { return scene_.world().num_checks(); }
  int num_projections() const { return num_projections_; }

 private:
  void row_values(planning::BandProjection::Values& value) const;
  bool keeps_contact(Planar& effective) const;
  void place_object(const std::optional<Carried>& carried, const Planar& effective);
  planning::BandProjection make_projection();

  const Problem& problem_;
  const Options& options_;
  const Arm& arm_;
  Eigen::Isometry3d X_SW_;
  Eigen::Vector3d normal_W_;
  double top_;  // height of the object's top face over S: z_s
  int fingertip_;
  scene::Scene scene_;
  int object_body_;
  bool object_parked_ = true;
  std::optional<std::pair<int, int>> touching_;  // found by the last is_valid()
  int num_projections_ = 0;
  Eigen::VectorXd q_;  // scratch: all joints
  robot::Poses X_WL_;  // scratch: frames up to the fingertip
  Eigen::Matrix<double, 6, Eigen::Dynamic> J_;
  planning::BandProjection projection_;
};

}  // namespace graspless::slide
