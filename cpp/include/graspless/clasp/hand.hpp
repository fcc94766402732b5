// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::clasp {

/// A corner of a finger curve, fixed to a link.
struct CurveNode {
  std::string link;
  Eigen::Vector3d p_L = Eigen::Vector3d::Zero();  ///< in the link's frame [m]
};

/// A finger: the corners of its part of the finger curve, from the palm to the tip.
struct Finger {
  std::string name;
  std::vector<CurveNode> nodes;
};

/// Description of a hand for the planner (Stork 2013, Section IV-B). Names of links, groups and
/// states refer to the robot.
///
/// Every finger opposes the thumb. Finger curve i (alpha_i) runs from the tip of finger i to the
/// palm and along the thumb to its tip.
struct Hand {
  std::string arm = "arm";     ///< group of the joints that carry the hand, base to wrist
  std::string hand = "hand";   ///< group of the joints that close the hand
  std::string frame = "palm";  ///< link of the palm, H
  Eigen::Vector3d forward_H = Eigen::Vector3d::UnitZ();   ///< v_fwd: unit vector towards the handle
  Eigen::Vector3d sideways_H = Eigen::Vector3d::UnitY();  ///< v_swd: unit vector along the handle
  std::vector<Finger> fingers;
  Finger thumb;
  std::string open = "open";  ///< state of the hand's joints at the start of the search: pre-shape
  /// States of further pre-shapes. The search tries them, in turn with the first, if it has clasped
  /// nothing in 20 cycles a loop.
  std::vector<std::string> pre_shapes;
  /// State towards which the joints close. A joint with equal values in both states does not move.
  std::string closed = "closed";
};

/// Reads a hand from YAML. docs/task-files.md has the grammar, and the folder urdf/ has examples.
/// Throws std::invalid_argument that names `what`, the line, the field, the value and the choices.
GRASPLESS_API Hand hand_from_yaml(const std::string& text, const std::string& what = "hand");
GRASPLESS_API Hand hand_from_yaml_file(const std::string& path);

/// Returns the hand with a corner in the palm (`frame`) at the beginning of each finger and thumb
/// whose first node joints of the hand move against the palm, such as those of a parallel gripper.
/// The corner lies half way between the node's positions in the palm with the hand open and closed.
/// It takes the place of a first node that is in the same position in both states. Other hands are
/// returned as they are. Throws std::invalid_argument like validate() for unknown names.
GRASPLESS_API Hand with_palm_corners(const Hand& hand, const robot::Robot& robot);

/// Throws std::invalid_argument that names the field, the value and the choices in these cases:
/// - a link, group or state is unknown, or arm and hand share joints;
/// - `frame` is not carried by the arm, or `forward` and `sideways` are not orthogonal unit
/// vectors;
/// - there is no finger, or a finger has fewer than two nodes or nodes that coincide;
/// - a finger's tip is moved by no joint of the hand, or the finger does not meet the thumb in the
///   palm;
/// - `open` and `closed` are equal.
GRASPLESS_API void validate(const Hand& hand, const robot::Robot& robot);

}  // namespace graspless::clasp
