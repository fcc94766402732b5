// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "pinch/grasps.hpp"
#include "pinch/press.hpp"

namespace graspless::pinch {

/// The poses of a hand for pairs of faces, by the lengths of hand and object.
class Poses {
 public:
  Poses(const Problem& problem, const Options& options, const Jaw& jaw);

  /// Adds the poses for a pair of faces, where the pads bear the object.
  void add(const Faces& pair);
  /// Writes the poses, best first, or why there are none.
  void finish(Grasps& result);

 private:
  /// Adds poses of one orientation. `fingers`: wherever they may be while they close, in H.
  void add(Faces pair, const Grip& grip, const std::vector<Shapes>& fingers,
           const Eigen::Matrix3d& R_SH, double tilt);
  bool is_borne(Faces& pair, double height, double below);
  double above() const { return has_walls_ ? options_.patch : options_.clearance; }

  const Problem& problem_;
  const Options& options_;
  const Jaw& jaw_;
  bool has_walls_;
  double most_, best_;
  Eigen::Isometry3d X_SO_;
  std::optional<Press> press_;  // of a prism, if it is known
  std::vector<Grasp> all_;
  std::optional<Faces> heavy_;                               // those that bear most, but too little
  double lowest_ = std::numeric_limits<double>::infinity();  // height of contacts over S [m]
};

}  // namespace graspless::pinch
