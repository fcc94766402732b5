// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/slide/slide.hpp"

#include "scene/replay.hpp"

/// World in which check() replays a plan. Contact allowances replace the depth bands on which the
/// search relies.
namespace graspless::slide {

/// Contacts that a segment may have.
enum class Contacts {
  none,
  press,  ///< the sliding finger presses into object and support, to a stated depth
  close,  ///< the fingers touch the object
};

/// Names of the segments of plans, in their order.
const std::vector<std::string>& segment_names();

/// Contacts that the segment of a name may have.
Contacts contacts_of(const std::string& name);

class Replay {
 public:
  /// `max_depth` of the commanded fingertip below the top face [m]. Nothing may touch.
  Replay(const Problem& problem, double max_depth);

  /// Returns a copy in which some contacts are allowed.
  Replay with(Contacts contacts) const;

  /// Names of touching pairs, "a - b", with the robot at q and the object at X_WO.
  std::vector<std::string> touching(const Eigen::VectorXd& q, const Eigen::Isometry3d& X_WO);

  /// Raises the support along its normal [m].
  void raise_support(double rise);
  void move_object(const Eigen::Isometry3d& X_WO) { replay_.world().set_pose(object_, X_WO); }
  int object() const { return object_; }  ///< index of the object in the world
  scene::Replay& bodies() { return replay_; }

 private:
  void add_surroundings();
  void allow_press();
  void ignore_fingers();

  const Problem& problem_;
  double max_depth_;
  scene::Replay replay_;
  int support_ = 0, object_ = 0;
};

}  // namespace graspless::slide
