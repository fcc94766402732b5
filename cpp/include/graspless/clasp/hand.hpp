// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "graspless/export.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::clasp {

/// A corner of a finger curve, fixed in a link.
struct CurveNode {
  std::string link;
  Eigen::Vector3d p_L = Eigen::Vector3d::Zero();  ///< in the link's frame [m]
};

/// A finger: the corners of its half of the curve, from the palm to the tip.
struct Finger {
  std::string name;
  std::vector<CurveNode> nodes;
};

/// What the planner must know of a hand. Links, groups and states are the robot's.
///
/// Every finger opposes the thumb: finger curve i (alpha_i of the paper) runs from the tip of
/// finger i down to the palm and up the thumb to its tip.
struct Hand {
  std::string arm = "arm";     ///< group of joints that carry the hand, base to wrist
  std::string hand = "hand";   ///< group of the hand's joints that close
  std::string frame = "palm";  ///< link H
  Eigen::Vector3d forward_H = Eigen::Vector3d::UnitZ();   ///< v_fwd: towards what is clasped
  Eigen::Vector3d sideways_H = Eigen::Vector3d::UnitY();  ///< v_swd: along what is clasped
  std::vector<Finger> fingers;
  Finger thumb;
  std::string open = "open";  ///< state of the hand's joints with which the search begins
  /// State towards which every joint closes; one that is the same in both states does not.
  std::string closed = "closed";
};

/// Reads a hand from YAML (the grammar: docs/task-files.md; the files beside our URDFs are
/// examples). Throws std::invalid_argument that names `what`, the line, the field, the value and
/// the choices.
GRASPLESS_API Hand hand_from_yaml(const std::string& text, const std::string& what = "hand");
GRASPLESS_API Hand hand_from_yaml_file(const std::string& path);

/// Throws std::invalid_argument that names the field, the value and the choices: unknown links,
/// groups or states; no finger; a finger or thumb with fewer than two nodes, or nodes that
/// coincide; a finger whose tip no joint of the hand moves, or that does not meet the thumb in the
/// palm; a frame that the arm does not carry; forward and sideways not orthogonal unit vectors; arm
/// and hand that share joints; open and closed that are the same.
GRASPLESS_API void validate(const Hand& hand, const robot::Robot& robot);

}  // namespace graspless::clasp
