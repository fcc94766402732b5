// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/clasp/object.hpp"

#include <mutex>
#include <optional>
#include <utility>

#include "graspless/geometry/sampling.hpp"

#include "clasp/certificate/core.hpp"
#include "clasp/object/surface.hpp"
#include "once.hpp"

namespace graspless::clasp {

/// A grid of distances that is lent to one user at a time.
class GridLender {
 public:
  /// `owner` lives as long as the grid is lent.
  std::shared_ptr<collision::Clearance> lend(const std::shared_ptr<const void>& owner,
                                             const collision::Clearance& original) {
    std::unique_ptr<collision::Clearance> grid;
    {
      const std::lock_guard lock(mutex_);
      grid = std::move(grid_);
    }
    if (!grid) grid = std::make_unique<collision::Clearance>(original);
    return {grid.release(), [owner, this](collision::Clearance* used) {
              std::unique_ptr<collision::Clearance> back(used);
              const std::lock_guard lock(mutex_);
              if (!grid_) grid_ = std::move(back);
            }};
  }

 private:
  std::mutex mutex_;
  std::unique_ptr<collision::Clearance> grid_;  // nothing while somebody has it
};

/// Data for collision tests is built on first use, so that finding loops alone stays fast.
struct Object::Data {
  std::string name;
  Eigen::Matrix3Xd points;
  geometry::LoopOptions options;
  std::vector<geometry::RayImage> rays;
  geometry::Loops loops;
  geometry::Mesh surface;
  double spacing = 0;

  mutable Once solid_made, clearance_made, outer_made, core_made;
  mutable std::optional<collision::Solid> solid;
  mutable std::optional<collision::Clearance> clearance, outer;
  mutable std::optional<Core> core;

  mutable GridLender outer_grid;
};

Object Object::from_cloud(const std::string& name, const Eigen::Matrix3Xd& p_OP,
                          const geometry::LoopOptions& options,
                          const std::vector<geometry::RayImage>& rays) {
  auto data = std::make_shared<Data>();
  data->loops = geometry::shortest_loops(p_OP, options, rays);
  data->rays = rays;
  data->name = name;
  data->points = p_OP;
  data->options = options;
  data->surface = surface_of(data->loops.surface);
  data->spacing = geometry::spacing(data->loops.surface.points);
  return Object(std::move(data));
}

const std::string& Object::name() const { return data_->name; }
const Eigen::Matrix3Xd& Object::points() const { return data_->points; }
const geometry::Loops& Object::loops() const { return data_->loops; }
const geometry::LoopOptions& Object::loop_options() const { return data_->options; }
const std::vector<geometry::RayImage>& Object::rays() const { return data_->rays; }
const geometry::Mesh& Object::surface() const { return data_->surface; }
double Object::spacing() const { return data_->spacing; }

const collision::Solid& Object::solid() const {
  data_->solid_made([&] {
    data_->solid.emplace(std::vector<geometry::PlacedShape>{{data_->surface}},
                         "object '" + data_->name + "'");
  });
  return *data_->solid;
}

const collision::Clearance& Object::clearance() const {
  data_->clearance_made([&] { data_->clearance.emplace(data_->surface); });
  return *data_->clearance;
}

const collision::Clearance& Object::outer_clearance() const {
  data_->outer_made([&] { data_->outer.emplace(shell_of(data_->loops.surface)); });
  return *data_->outer;
}

std::shared_ptr<collision::Clearance> Object::borrow_outer_clearance() const {
  return data_->outer_grid.lend(data_, outer_clearance());
}

const Core& Object::core() const {
  data_->core_made([&] { data_->core.emplace(data_->loops.surface); });
  return *data_->core;
}

}  // namespace graspless::clasp
