// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace graspless::robot {

/// The tree that the links and joints of a URDF span.
struct UrdfTree {
  std::string root;
  std::vector<std::string> joints;  ///< depth first; those of one link in the order of the file
};

/// Checks everything of a URDF that makes it a tree of movable joints with limits, line by line,
/// before urdfdom sees it: urdfdom sorts joints by name, takes a link with two parents for a tree,
/// and leaks on a cycle. Throws std::invalid_argument with the line.
UrdfTree read_urdf_tree(const std::string& xml);

}  // namespace graspless::robot
