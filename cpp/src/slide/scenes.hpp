// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "graspless/scene/scene.hpp"
#include "graspless/slide/slide.hpp"

namespace graspless::slide {

constexpr const char* kObjectBody = "object";
constexpr const char* kSupportBody = "support";

/// The robot, the support, the obstacles, and the object as a body that moves; nothing may touch.
scene::Scene make_scene(const Problem& problem);

/// A pose out of everybody's way, for an object whose place is not known.
Eigen::Isometry3d parked();

/// How deep the sliding finger's shapes reach below the faces while its tip is pressed `depth` below the top
/// face with a pitch in the tolerated range: the depths at which contact allowances must end.
struct PressDepths {
  double into_object;   ///< below the object's top face [m]
  double into_support;  ///< below the support's plane [m], 0 when it does not reach it
};
PressDepths press_depths(const Problem& problem, const Options& options, double depth);

/// Allows the sliding finger to press that deep; depth < 0 ends the allowances.
void allow_press(const Problem& problem, const Options& options, double depth, scene::Scene& scene);

}  // namespace graspless::slide
