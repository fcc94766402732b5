// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "graspless/fingertip/fingertip.hpp"

/// The paper's four problems of Section 5, one of its units of length as 1 m.
namespace graspless::fingertip {

inline Eigen::Isometry3d at(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

inline Fingers paper_fingers(double max_normal_force) {
  Fingers fingers;
  fingers.radius = 1;
  fingers.max_normal_force = max_normal_force;
  return fingers;
}

/// The cuboid slides along its short side, 10 along x: cases a (10 N) and b (5 N).
inline Problem slide_case(double max_normal_force, int segments = 30) {
  const Eigen::Isometry3d X_WO = at(0, 0, 2.5);
  return {Object::box("cuboid", {5, 10, 5}, 1),
          paper_fingers(max_normal_force),
          {Plane{}},
          {0.5, 0.5},
          slide_path(X_WO, {10, 0, 0}, segments),
          {}};
}

/// The cuboid stands on end and tumbles forward over its edge at x = 2.5, with a wall behind it,
/// and perhaps beside it: cases c and d.
inline Problem tumble_case(bool has_side_wall, int segments = 30) {
  const Eigen::Isometry3d X_WO = at(0, 0, 5);
  Problem problem{Object::box("cuboid", {5, 5, 10}, 1),
                  paper_fingers(10),
                  {Plane{}, {"behind", Eigen::Vector3d::UnitX(), -3}},
                  {0.5, 0.5},
                  turn_path(X_WO, {2.5, 0, 0}, Eigen::Vector3d::UnitY(), M_PI / 2, segments),
                  {}};
  if (has_side_wall) problem.planes.push_back({"beside", -Eigen::Vector3d::UnitY(), -3});
  return problem;
}

struct Case {
  std::string name;
  Problem problem;
  double cost;  // optimal on the paper's lattice
  int regrasps;
};

inline std::vector<Case> paper_cases() {
  return {{"a", slide_case(10), 10.016453262, 0},
          {"b", slide_case(5), 10.043263194, 0},
          {"c", tumble_case(false), 10.264282664, 0},
          {"d", tumble_case(true), 117.392208834, 1}};
}

inline Options with_engine(Search search) {
  Options options;
  options.search = search;
  return options;
}

}  // namespace graspless::fingertip
