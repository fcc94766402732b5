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

}  // namespace graspless::slide
