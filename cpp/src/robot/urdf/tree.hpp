// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace graspless::robot {

/// The tree of a URDF's links and joints.
struct UrdfTree {
  std::string root;
  std::vector<std::string> joints;    ///< depth first; those of one link in the order of the file
  std::vector<std::string> warnings;  ///< about links without collision shapes, and odd joints
  std::string xml;                    ///< the URDF with an effort and a velocity in each <limit>
};

/// Checks that a URDF is a tree of supported joints with limits, before urdfdom reads it: urdfdom
/// sorts joints by name, accepts a link with two parents, and leaks on a cycle. A <limit> without
/// effort or velocity, which urdfdom refuses, gets 0, which stands for unknown, and a warning.
/// Throws std::invalid_argument with the line number.
UrdfTree read_urdf_tree(const std::string& xml);

}  // namespace graspless::robot
