// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "graspless/export.hpp"
#include "graspless/geometry/shape.hpp"

namespace graspless::collision {

/// The shapes of a body, prepared for collision tests (hulls, bounding volume trees): made once,
/// shared by every world the body stands in. Immutable; copies are cheap.
class GRASPLESS_API Solid {
 public:
  /// Throws std::invalid_argument, naming `what`, when there is no shape or geometry::validate
  /// refuses one.
  explicit Solid(const std::vector<geometry::PlacedShape>& shapes,
                 const std::string& what = "solid");

  struct Data;  // not part of the interface
  const Data& data() const { return *data_; }

 private:
  std::shared_ptr<const Data> data_;
};

}  // namespace graspless::collision
