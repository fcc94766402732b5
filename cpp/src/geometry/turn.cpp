// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/turn.hpp"

namespace graspless::geometry {

Eigen::Quaterniond turn_from_z(const Eigen::Vector3d& direction) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), direction);
}

}  // namespace graspless::geometry
