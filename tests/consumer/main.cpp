// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include <graspless/scene/scene.hpp>
#include <graspless/slide/slide.hpp>

// Loads a robot, looks whether it is free above a box, and has a bad problem refused.
int main(int argc, char** argv) {
  using namespace graspless;
  if (argc != 2) return 2;
  const auto robot = robot::Robot::from_urdf_file(argv[1]);
  scene::Scene scene(robot);
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translation() << 2, 0, 0;
  scene.add_obstacle("box", {{geometry::Box{Eigen::Vector3d::Constant(0.1)}}}, X_WB);
  if (!scene.is_free(Eigen::VectorXd::Zero(robot.dof()))) return 1;
  try {
    slide::Options options;
    options.min_depth = 1;  // above max_depth
    slide::validate(options);
    return 1;
  } catch (const std::invalid_argument&) {
    std::cout << robot.name() << " " << robot.dof() << "\n";
  }
}
