// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "graspless/geometry/shape.hpp"

#include "collision/fcl_shape.hpp"

namespace graspless::collision {

/// Returns what `make` returns for a mesh. The last meshes of a process are kept: planners, checks
/// and strategies make worlds of the same robot again and again, and its trees take milliseconds.
/// Thread-safe.
CollisionShape prepared(const geometry::Mesh& mesh,
                        const std::function<CollisionShape(const geometry::Mesh&)>& make);

bool is_same(const geometry::Mesh& a, const geometry::Mesh& b);

}  // namespace graspless::collision
