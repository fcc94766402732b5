// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/collision/clearance.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "collision/clearance_cells.hpp"
#include "collision/clearance_tree.hpp"

namespace graspless::collision {
namespace {

constexpr double kFineCells = 4;    // to a coarse one
constexpr double kRounding = 1e-7;  // of a distance in single precision

Clearance::Bounds around(double distance, double offset) {
  const double slack = offset + kRounding * distance;
  return {std::max(0.0, distance - slack), distance + slack};
}

void require_finite(const Eigen::Vector3d& point) {
  if (!point.allFinite()) throw std::invalid_argument("point must be finite");
}

}  // namespace

struct Clearance::Grid {
  explicit Grid(double cell) : size(cell), coarse(cell), fine(cell / kFineCells) {}

  double size;
  ClearanceCells coarse, fine;
  Eigen::Vector3d near = Eigen::Vector3d::Zero();  // a point of the surface, the last one found

  Bounds bounds(ClearanceCells& cells, const Eigen::Vector3d& point, const ClearanceTree& tree) {
    if (!cells.covers(point)) {
      require_finite(point);
      return around(tree.distance(point), 0);
    }
    const auto sample = cells.sample(point, tree, near);
    return around(static_cast<double>(sample.distance), sample.offset);
  }
};

Clearance::Clearance(const geometry::Mesh& mesh, double cell) {
  geometry::validate(mesh, "mesh");
  if (!(cell > 0 && cell <= geometry::kMaxLength)) {
    throw std::invalid_argument("cell must be in (0, " + std::to_string(geometry::kMaxLength) +
                                "] m, not " + std::to_string(cell));
  }
  tree_ = std::make_shared<const ClearanceTree>(mesh);
  grid_ = std::make_unique<Grid>(cell);
  grid_->near = tree_->any_point();
}

Clearance::Clearance(const Clearance& other)
    : tree_(other.tree_), grid_(std::make_unique<Grid>(other.grid_->size)) {
  grid_->near = tree_->any_point();
}

Clearance& Clearance::operator=(const Clearance& other) { return *this = Clearance(other); }

Clearance::Clearance(Clearance&&) noexcept = default;
Clearance& Clearance::operator=(Clearance&&) noexcept = default;
Clearance::~Clearance() = default;

double Clearance::distance(const Eigen::Vector3d& point) const {
  require_finite(point);
  return tree_->distance(point);
}

Clearance::Bounds Clearance::bounds(const Eigen::Vector3d& point) {
  return grid_->bounds(grid_->coarse, point, *tree_);
}

Clearance::Bounds Clearance::bounds(const Eigen::Vector3d& point, double threshold) {
  const Bounds rough = bounds(point);
  if (rough.lower > threshold || rough.upper < threshold) return rough;
  const Bounds fine = grid_->bounds(grid_->fine, point, *tree_);
  return {std::max(rough.lower, fine.lower), std::min(rough.upper, fine.upper)};
}

}  // namespace graspless::collision
