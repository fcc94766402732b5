// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "graspless/robot/robot.hpp"

namespace graspless::robot {

/// Pose of a joint in the one before, whose axis is z.
struct JointOrigin {
  Eigen::Vector3d xyz, rpy;
};

using Limits = std::vector<std::array<double, 2>>;  // of each joint [rad]

/// An arm of revolute joints, written down by its makers' dimensions. The last origin is the
/// flange's.
struct Arm {
  std::string name;
  std::vector<JointOrigin> origins;
  int free_joint = -1;  // -1: none

  int dof() const { return static_cast<int>(origins.size()) - 1; }

  /// With limits of its own, or +-limit for every joint.
  Robot robot(double limit, const Limits& limits = {}) const {
    std::ostringstream urdf;
    urdf.precision(17);
    urdf << "<robot name='" << name << "'><link name='l0'/>";
    for (int i = 1; i <= dof() + 1; ++i) {
      const auto index = static_cast<std::size_t>(i - 1);
      const auto& [xyz, rpy] = origins[index];
      const auto [lower, upper] = index < limits.size() ? limits[index] : std::array{-limit, limit};
      urdf << "<link name='l" << i << "'/><joint name='j" << i << "' type='"
           << (i <= dof() ? "revolute" : "fixed") << "'><origin xyz='" << xyz.transpose()
           << "' rpy='" << rpy.transpose() << "'/><parent link='l" << i - 1 << "'/><child link='l"
           << i << "'/><axis xyz='0 0 1'/><limit lower='" << lower << "' upper='" << upper
           << "' velocity='1' effort='1'/></joint>";
    }
    return Robot::from_urdf(urdf.str() + "</robot>", {});
  }

  std::vector<int> group() const {
    std::vector<int> joints;
    for (int i = 0; i < dof(); ++i) joints.push_back(i);
    return joints;
  }

  /// The same arm with errors of its dimensions, uniform up to `length` [m] and `angle` [rad].
  Arm calibrated(double length, double angle, std::mt19937_64& rng) const {
    std::uniform_real_distribution<double> unit(-1, 1);
    Arm arm = *this;
    arm.name += "_calibrated";
    for (JointOrigin& origin : arm.origins) {
      for (int i = 0; i < 3; ++i) origin.xyz[i] += length * unit(rng);
      for (int i = 0; i < 3; ++i) origin.rpy[i] += angle * unit(rng);
    }
    return arm;
  }
};

struct DhRow {
  double a, alpha, d;
};

/// Denavit and Hartenberg's parameters: z turns by q and shifts by d, then x turns by alpha and
/// shifts by a.
inline Arm dh_arm(const std::string& name, const std::vector<DhRow>& rows, int free_joint = -1) {
  Arm arm{name, {{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()}}, free_joint};
  for (const auto& [a, alpha, d] : rows) arm.origins.push_back({{a, 0, d}, {alpha, 0, 0}});
  return arm;
}

/// Craig's parameters: first x, then z.
inline Arm craig_arm(const std::string& name, const std::vector<DhRow>& rows, int free_joint) {
  Arm arm{name, {}, free_joint};
  for (const auto& [a, alpha, d] : rows) {
    arm.origins.push_back({{a, -std::sin(alpha) * d, std::cos(alpha) * d}, {alpha, 0, 0}});
  }
  arm.origins.push_back({Eigen::Vector3d(0, 0, 0.1), Eigen::Vector3d::Zero()});
  return arm;
}

constexpr double kRight = M_PI / 2;

inline Arm ur5() {
  return dh_arm("ur5", {{0, kRight, 0.089159},
                        {-0.425, 0, 0},
                        {-0.39225, 0, 0},
                        {0, kRight, 0.10915},
                        {0, -kRight, 0.09465},
                        {0, 0, 0.0823}});
}

inline Arm ur5e() {
  return dh_arm("ur5e", {{0, kRight, 0.1625},
                         {-0.425, 0, 0},
                         {-0.3922, 0, 0},
                         {0, kRight, 0.1333},
                         {0, -kRight, 0.0997},
                         {0, 0, 0.0996}});
}

/// KUKA KR 5 sixx R850: shoulder and elbow are offset.
inline Arm kr5_bare() {
  return dh_arm("kr5", {{0.075, -kRight, 0.335},
                        {0.365, 0, 0},
                        {0.09, -kRight, 0},
                        {0, kRight, 0.405},
                        {0, -kRight, 0},
                        {0, 0, 0.08}});
}

/// ABB's IRB 140, with a lateral offset as Staubli's arms have.
inline Arm irb140() {
  return dh_arm("irb140", {{0.07, -kRight, 0.352},
                           {0.36, 0, 0.05},
                           {0, -kRight, 0},
                           {0, kRight, 0.38},
                           {0, -kRight, 0},
                           {0, 0, 0.065}});
}

inline Arm iiwa() {
  return dh_arm("iiwa",
                {{0, -kRight, 0.34},
                 {0, kRight, 0},
                 {0, kRight, 0.4},
                 {0, -kRight, 0},
                 {0, -kRight, 0.4},
                 {0, kRight, 0},
                 {0, 0, 0.126}},
                2);
}

/// Kinova Gen3: axes 1 and 3 miss each other by 11.8 mm, so that joint 1 is the free one.
inline Arm gen3() {
  return dh_arm("gen3",
                {{0, kRight, -0.2848},
                 {0, kRight, -0.0118},
                 {0, kRight, -0.4208},
                 {0, kRight, -0.0128},
                 {0, kRight, -0.3143},
                 {0, kRight, 0},
                 {0, M_PI, -0.1674}},
                0);
}

inline Arm panda() {
  return craig_arm("panda",
                   {{0, 0, 0.333},
                    {0, -kRight, 0},
                    {0, kRight, 0.316},
                    {0.0825, kRight, 0},
                    {-0.0825, -kRight, 0.384},
                    {0, kRight, 0},
                    {0.088, kRight, 0}},
                   6);
}

inline Arm xarm7() {
  return craig_arm("xarm7",
                   {{0, 0, 0.267},
                    {0, -kRight, 0},
                    {0, kRight, 0.293},
                    {0.0525, kRight, 0},
                    {0.0775, kRight, 0.3425},
                    {0, kRight, 0},
                    {0.076, -kRight, 0}},
                   6);
}

/// A shoulder with an offset before a spherical one, as Fetch and PR2 have.
inline Arm fetch() {
  return dh_arm("fetch",
                {{0.117, -kRight, 0.06},
                 {0, kRight, 0},
                 {0, -kRight, 0.352},
                 {0, kRight, 0},
                 {0, -kRight, 0.3215},
                 {0, kRight, 0},
                 {0, 0, 0.138}},
                0);
}

inline Limits iiwa_limits() {
  const double a = 2.96706, b = 2.0944, c = 3.05433;
  return {{-a, a}, {-b, b}, {-a, a}, {-b, b}, {-a, a}, {-b, b}, {-c, c}};
}

inline Limits gen3_limits() {
  return {{-M_PI, M_PI}, {-2.41, 2.41}, {-M_PI, M_PI}, {-2.66, 2.66},
          {-M_PI, M_PI}, {-2.23, 2.23}, {-M_PI, M_PI}};
}

inline Limits panda_limits() {
  const double a = 2.8973;
  return {{-a, a}, {-1.7628, 1.7628}, {-a, a}, {-3.0718, -0.0698},
          {-a, a}, {-0.0175, 3.7525}, {-a, a}};
}

inline std::vector<Arm> ideal_arms() {
  return {ur5(), ur5e(), kr5_bare(), irb140(), iiwa(), gen3(), panda(), xarm7(), fetch()};
}

}  // namespace graspless::robot
