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

class Replay {
 public:
  /// `max_depth` of the commanded fingertip below the top face [m].
  Replay(const Problem& problem, double max_depth, Contacts contacts);

  /// Names of touching pairs, "a - b", with the robot at q and the object at X_WO.
  std::vector<std::string> touching(const Eigen::VectorXd& q, const Eigen::Isometry3d& X_WO);

 private:
  void add_surroundings();
  void allow_press(double max_depth);
  void ignore_fingers();

  const Problem& problem_;
  scene::Replay replay_;
  int support_ = 0, object_ = 0;
};

}  // namespace graspless::slide
