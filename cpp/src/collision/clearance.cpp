// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/clearance.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "collision/clearance_cells.hpp"
#include "collision/clearance_tree.hpp"
#include "text.hpp"

namespace graspless::collision {
namespace {

void require_finite(const Eigen::Vector3d& point) {
  if (!point.allFinite()) throw std::invalid_argument("point must be finite");
}

}  // namespace

Clearance::Clearance(const geometry::Mesh& mesh, double cell) {
  geometry::validate(mesh, "mesh");
  require(cell > 0 && cell <= geometry::kMaxLength, "cell", cell,
          "must be in (0, " + figure(geometry::kMaxLength) + "] m");
  tree_ = std::make_shared<const ClearanceTree>(surface_triangles(mesh));
  cells_ = std::make_unique<ClearanceCells>(tree_, cell);
}

Clearance::Clearance(const Clearance& other)
    : tree_(other.tree_),
      cells_(std::make_unique<ClearanceCells>(other.tree_, other.cells_->cell())) {}

Clearance::Clearance(std::shared_ptr<const ClearanceTree> tree,
                     std::unique_ptr<ClearanceCells> cells)
    : tree_(std::move(tree)), cells_(std::move(cells)) {}

Clearance Clearance::with_cells() const {
  return {tree_, std::make_unique<ClearanceCells>(*cells_)};
}

Clearance& Clearance::operator=(const Clearance& other) { return *this = Clearance(other); }

Clearance::Clearance(Clearance&&) noexcept = default;
Clearance& Clearance::operator=(Clearance&&) noexcept = default;
Clearance::~Clearance() = default;

double Clearance::distance(const Eigen::Vector3d& point, double limit) const {
  require_finite(point);
  return tree_->distance(point, std::max(limit, 0.0));
}

Clearance::Bounds Clearance::exactly(const Eigen::Vector3d& point) const {
  const double exact = distance(point);
  return {exact, exact};
}

Clearance::Bounds Clearance::bounds(const Eigen::Vector3d& point, double threshold) {
  return cells_->covers(point) ? cells_->bounds(point, threshold) : exactly(point);
}

Clearance::Bounds Clearance::rough_bounds(const Eigen::Vector3d& point, double threshold) {
  return cells_->covers(point) ? cells_->rough_bounds(point, threshold) : exactly(point);
}

}  // namespace graspless::collision
