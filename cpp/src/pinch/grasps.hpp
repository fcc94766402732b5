// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "graspless/pinch/pinch.hpp"

#include "pinch/faces.hpp"
#include "pinch/jaw.hpp"

namespace graspless::pinch {

constexpr double kLever = 0.05;  // costs as much as a coefficient of friction of 1 [m]

/// A pose of the open hand from which it closes on two faces.
struct Grasp {
  Faces faces;
  double height;  ///< of the contacts over the support [m]
  double tilt;    ///< of the approach from straight down, about the closing direction [rad]
  Eigen::Isometry3d X_WH;
  double shift;  ///< along Y_H, with which the hand comes, so that both fingers keep the margin [m]
  double cost;   ///< the less, the sooner it is tried
};

/// Hand poses in the order of their cost; or why there are none.
struct Grasps {
  std::vector<Grasp> all;
  std::size_t num_faces = 0;  ///< pairs of faces that fit
  Status status = Status::solved;
  std::string reason;
};

/// Notes why no faces are left, and returns none.
std::vector<Faces> refuse(Grasps& result, Status status, const std::string& reason);

template <class Fits>
void keep(std::vector<Faces>& faces, const Fits& fits) {
  faces.erase(
      std::remove_if(faces.begin(), faces.end(), [&](const Faces& pair) { return !fits(pair); }),
      faces.end());
}

/// A formatted text, as by printf(), of at most 255 characters.
template <class... Numbers>
std::string text_of(const char* format, Numbers... numbers) {
  char text[256];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

/// Finds walls of an object with heights that fit the hand and hold the object, or notes in
/// `result` what the nearest of the others lack.
std::vector<Faces> select_walls(const Problem& problem, const Options& options, const Jaw& jaw,
                                Grasps& result);

/// Measures selected walls along fine lines, as check() does. Returns those that still fit the hand
/// and hold the object, or notes in `result` what the nearest of the others lack.
std::vector<Faces> measured_walls(std::vector<Faces> faces, const Problem& problem,
                                  const Options& options, const Jaw& jaw, Grasps& result);

/// The sooner faces are tried, the less.
double cost(const Faces& faces);

/// Returns faces with lever, offset and drop of the centre of mass from contacts at a height, as
/// gravity sees them: the support may be tilted.
Faces weighed(Faces faces, const Problem& problem, double height);

/// Rounded length for a reason: "118 mm".
std::string in_mm(double length);

/// Reason why an object of `mass` is too heavy for the best of some faces, which are `away` from
/// its centre of mass.
std::string too_heavy(const std::string& held_by, double away, const Faces& best, double press,
                      double mass);

/// Finds hand poses by the lengths of hand and object alone.
Grasps find_grasps(const Problem& problem, const Options& options, const Jaw& jaw);

}  // namespace graspless::pinch
