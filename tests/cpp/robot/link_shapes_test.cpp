// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include <gtest/gtest.h>

#include "graspless/robot/robot.hpp"

#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

TEST(LinkShapes, ShapesBecomeCapsulesPrismsAndMeshes) {
  const Robot arm = wam();
  int capsules = 0;
  for (const LinkShape& shape : arm.shapes()) {
    capsules += std::holds_alternative<geometry::Capsule>(shape.placed.shape);
    EXPECT_FALSE(std::holds_alternative<geometry::Sphere>(shape.placed.shape));
  }
  EXPECT_EQ(capsules, 8);

  const Robot robot = oddity();
  ASSERT_EQ(robot.shapes().size(), 6u);
  const auto& prism = std::get<geometry::Convex>(robot.shapes()[1].placed.shape).vertices;
  ASSERT_EQ(prism.cols(), 48);
  const double radius = prism.topRows<2>().colwise().norm().maxCoeff();
  EXPECT_NEAR(radius * std::cos(M_PI / 24), 0.05, 1e-12);  // its sides touch the cylinder
  EXPECT_NEAR(prism.row(2).maxCoeff(), 0.1, 1e-12);
  const auto& mesh = std::get<geometry::Mesh>(robot.shapes()[3].placed.shape);
  EXPECT_NEAR(mesh.vertices.row(2).maxCoeff(), 0.2, 1e-12);  // scaled
  EXPECT_EQ(mesh.triangles.cols(), 4);
}

TEST(LinkShapes, CapsulesMayShareAnEnd) {
  const auto element = [](const std::string& xyz, const std::string& geometry) {
    return "<collision><origin xyz='" + xyz + "'/><geometry>" + geometry +
           "</geometry></collision>";
  };
  const std::string cylinder = "<cylinder radius='0.1' length='1'/>",
                    ball = "<sphere radius='0.1'/>";
  const Robot robot = Robot::from_urdf(
      "<robot name='r'><link name='a'>" + element("0 0 0.5", cylinder) +
          element("0 0 1.5", cylinder) + element("0 0 0", ball) + element("0 0 1", ball) +
          element("0 0 2", ball) + element("0 0 3", ball) + "</link></robot>",
      {});
  ASSERT_EQ(robot.shapes().size(), 3u);
  EXPECT_EQ(std::get<geometry::Capsule>(robot.shapes()[1].placed.shape).length, 1);
  EXPECT_TRUE(std::holds_alternative<geometry::Sphere>(robot.shapes()[2].placed.shape));
}

}  // namespace
}  // namespace graspless::robot
