// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "graspless/export.hpp"
#include "graspless/robot/robot.hpp"

namespace graspless::robot {

/// URDF text that a robot was read from: a plan file holds it.
GRASPLESS_API const std::string& urdf_of(const Robot& robot);

/// SRDF, packages, folder and pose that a robot was read with.
GRASPLESS_API const Robot::Options& options_of(const Robot& robot);

}  // namespace graspless::robot
