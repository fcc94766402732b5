// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::collision {

/// The shapes of a body, prepared for collision tests (hulls, bounding volume trees). Worlds that
/// contain the body share it. Immutable; copies are cheap.
class GRASPLESS_API Solid {
 public:
  /// A copy shares all data. Moving copies, so that no object is left empty.
  Solid(const Solid&) = default;
  Solid& operator=(const Solid&) = default;

  /// Throws std::invalid_argument that names `what` if there is no shape or geometry::validate
  /// rejects one.
  explicit Solid(const std::vector<geometry::PlacedShape>& shapes,
                 const std::string& what = "solid");

  struct Data;  // not part of the interface
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace graspless::collision
