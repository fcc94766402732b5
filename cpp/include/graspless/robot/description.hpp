// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include <Eigen/Geometry>

#include "graspless/export.hpp"

namespace graspless::robot {

/// Files of a robot, before they are read as one.
struct Description {
  std::string urdf;                             ///< URDF text
  std::string srdf;                             ///< SRDF text; empty: none
  std::map<std::string, std::string> packages;  ///< directory of each package://NAME/
  std::string directory;                        ///< directory that relative mesh paths start from
};

/// Mounting of a gripper on an arm.
struct Mount {
  std::string link;                                        ///< link M of the arm
  Eigen::Isometry3d X_MG = Eigen::Isometry3d::Identity();  ///< pose of the gripper's root link
  std::string prefix;  ///< of the gripper's names; empty: "gripper_" where names clash
  std::string root;    ///< link of the gripper to mount, with all that it carries; empty: all links
};

/// Finds the folders of the packages that the meshes of a URDF name as package://NAME/.... Returns
/// `description.packages` and those found: in ROS_PACKAGE_PATH, in AMENT_PREFIX_PATH (share/NAME),
/// or beside the URDF, as a folder above `directory` that is called NAME, contains NAME or, failing
/// that, contains the mesh itself. The first folder that contains the mesh is used. Throws
/// std::invalid_argument that says where a collision mesh's package was looked for.
GRASPLESS_API std::map<std::string, std::string> find_packages(const Description& description);

/// Path of a mesh by its name in the URDF: package://, file://, or relative to `directory`. Throws
/// std::invalid_argument if the package is unknown.
GRASPLESS_API std::string mesh_path(const std::string& name, const Description& description);

/// Joins two robots: a fixed joint carries the root link of the gripper. Paths of meshes become
/// absolute. Groups of the gripper's SRDF are renamed as links are; states of the same name are
/// merged when the result is read. With `mount.root`, the gripper's SRDF is left out. Throws
/// std::invalid_argument that names the faulty description, a pose that is not rigid, the unknown
/// link, or names that clash in spite of the prefix.
GRASPLESS_API Description join(const Description& arm, const Description& gripper,
                               const Mount& mount);

}  // namespace graspless::robot
