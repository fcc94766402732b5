// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/clearance.hpp"

#include <stdexcept>
#include <string>

#include "collision/clearance_cells.hpp"
#include "collision/clearance_tree.hpp"

namespace graspless::collision {
namespace {

void require_finite(const Eigen::Vector3d& point) {
  if (!point.allFinite()) throw std::invalid_argument("point must be finite");
}

double checked(double cell) {
  if (cell > 0 && cell <= geometry::kMaxLength) return cell;
  throw std::invalid_argument("cell must be in (0, " + std::to_string(geometry::kMaxLength) +
                              "] m, not " + std::to_string(cell));
}

}  // namespace

struct Clearance::Surface {
  explicit Surface(const geometry::Mesh& mesh)
      : triangles(std::make_shared<const ClearanceCells::Triangles>(surface_triangles(mesh))),
        tree(std::make_shared<const ClearanceTree>(*triangles)) {}

  std::shared_ptr<const ClearanceCells::Triangles> triangles;
  std::shared_ptr<const ClearanceTree> tree;
};

struct Clearance::Grid {
  ClearanceCells cells;
};

Clearance::Clearance(const geometry::Mesh& mesh, double cell) {
  geometry::validate(mesh, "mesh");
  checked(cell);
  surface_ = std::make_shared<const Surface>(mesh);
  grid_ = std::make_unique<Grid>(Grid{{surface_->triangles, surface_->tree, cell}});
}

Clearance::Clearance(const Clearance& other)
    : surface_(other.surface_),
      grid_(std::make_unique<Grid>(
          Grid{{surface_->triangles, surface_->tree, other.grid_->cells.cell()}})) {}

Clearance& Clearance::operator=(const Clearance& other) { return *this = Clearance(other); }

Clearance::Clearance(Clearance&&) noexcept = default;
Clearance& Clearance::operator=(Clearance&&) noexcept = default;
Clearance::~Clearance() = default;

double Clearance::distance(const Eigen::Vector3d& point, double limit) const {
  require_finite(point);
  return surface_->tree->distance(point, std::max(limit, 0.0));
}

Clearance::Bounds Clearance::exactly(const Eigen::Vector3d& point) const {
  const double exact = distance(point);
  return {exact, exact};
}

Clearance::Bounds Clearance::bounds(const Eigen::Vector3d& point) {
  return grid_->cells.covers(point) ? grid_->cells.bounds(point) : exactly(point);
}

Clearance::Bounds Clearance::bounds(const Eigen::Vector3d& point, double threshold) {
  return grid_->cells.covers(point) ? grid_->cells.bounds(point, threshold) : exactly(point);
}

Clearance::Bounds Clearance::rough_bounds(const Eigen::Vector3d& point, double threshold) {
  return grid_->cells.covers(point) ? grid_->cells.rough_bounds(point, threshold) : exactly(point);
}

}  // namespace graspless::collision
