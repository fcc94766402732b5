// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/planes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>

#include "graspless/watch.hpp"

#include "geometry/quantile.hpp"

namespace graspless::perception {
namespace {

constexpr int kDraws = 600;  // triples of cells
constexpr int kRefits = 4;
constexpr std::size_t kMostPlanes = 8;  // planes
constexpr double kTurned = 0.2;  // angle between the normals of cell and plane, at most [rad]
const double kCosTurned = std::cos(kTurned);
constexpr double kCellSigmas = 4;    // of a cell's centre
constexpr double kUneven = 1e-3;     // distance of a centre from the plane that is always allowed
constexpr double kDistorted = 1e-3;  // the same, per metre of depth
constexpr double kRough = 1.2;       // times what is expected, and what is usual in the plane

double allowed(const Cell& cell) {
  return kCellSigmas * cell.deviation + kUneven + kDistorted * cell.depth;
}

bool lies_in(const Cell& cell, const Plane& plane) {
  return std::abs(plane.above(cell.p_W)) < allowed(cell) && cell.n_W.dot(plane.n_W) > kCosTurned;
}

double area_in(const std::vector<Cell>& cells, const Plane& plane) {
  double area = 0;
  for (const Cell& cell : cells) {
    if (lies_in(cell, plane)) area += cell.area;
  }
  return area;
}

/// The plane through the centres of three cells.
std::optional<Plane> through(const Cell& a, const Cell& b, const Cell& c) {
  const Eigen::Vector3d n = (b.p_W - a.p_W).cross(c.p_W - a.p_W);
  if (n.norm() < 1e-6) return std::nullopt;
  Plane plane;
  plane.n_W = n.normalized() * (n.dot(a.n_W) > 0 ? 1 : -1);
  plane.offset = -plane.n_W.dot(a.p_W);
  for (const Cell* cell : {&a, &b, &c}) {
    if (!lies_in(*cell, plane)) return std::nullopt;
  }
  return plane;
}

double median_roughness(const std::vector<Cell>& cells) {
  std::vector<double> roughness;
  for (const Cell& cell : cells) roughness.push_back(cell.roughness);
  return geometry::median(roughness);
}

/// Fits a plane to the cells that lie in it, by weighted least squares. Cells that are rougher than
/// noise makes them hold the edge of something, which would tilt the plane: they have no weight.
void refit(Plane& plane, const std::vector<Cell>& cells) {
  plane.cells.clear();
  for (const Cell& cell : cells) {
    if (lies_in(cell, plane)) plane.cells.push_back(cell);
  }
  if (plane.cells.size() < 3) return;
  constexpr std::ptrdiff_t kFew = 12;  // cells, of which none is left out
  const double usual = kRough * std::max(1.0, median_roughness(plane.cells));
  const auto is_smooth = [usual](const Cell& cell) { return cell.roughness <= usual; };
  const bool has_many = std::count_if(plane.cells.begin(), plane.cells.end(), is_smooth) > kFew;
  const auto weight = [&](const Cell& cell) {
    return has_many && !is_smooth(cell) ? 0 : 1 / (cell.deviation * cell.deviation);
  };
  double weights = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Cell& cell : plane.cells) {
    weights += weight(cell);
    mean += weight(cell) * cell.p_W;
  }
  mean /= weights;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Cell& cell : plane.cells) {
    spread += weight(cell) * (cell.p_W - mean) * (cell.p_W - mean).transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  const Eigen::Vector3d n = axes.eigenvectors().col(0);
  plane.n_W = n.dot(plane.n_W) > 0 ? n : Eigen::Vector3d(-n);
  plane.offset = -plane.n_W.dot(mean);
  plane.center_W = mean;
  plane.height_error = 1 / std::sqrt(weights);
  plane.angle_error = 1 / std::sqrt(std::max(axes.eigenvalues()[1], 1e-12));
}

/// Draws one cell, then two others, from its neighbourhood in every second draw.
class Draw {
 public:
  Draw(const std::vector<Cell>& cells, std::uint64_t seed) : cells_(cells), rng_(seed) {}

  std::optional<Plane> operator()(bool is_local) {
    const Cell& first = cells_[any()];
    return through(first, another(first, is_local), another(first, is_local));
  }

 private:
  std::size_t any() { return static_cast<std::size_t>(rng_() % cells_.size()); }

  const Cell& another(const Cell& first, bool is_local) {
    constexpr int kAttempts = 30, kNear = 8;  // cells
    for (int i = 0; i < kAttempts && is_local; ++i) {
      const Cell& cell = cells_[any()];
      if (cell.view == first.view && std::abs(cell.row - first.row) <= kNear &&
          std::abs(cell.column - first.column) <= kNear) {
        return cell;
      }
    }
    return cells_[any()];
  }

  const std::vector<Cell>& cells_;
  std::mt19937_64 rng_;
};

std::optional<Plane> best_plane(const std::vector<Cell>& cells, std::uint64_t seed) {
  std::optional<Plane> best;
  double most = 0;
  Draw draw(cells, seed);
  for (int i = 0; i < kDraws; ++i) {
    poll();
    const auto plane = draw(i % 2 == 0);
    if (!plane) continue;
    const double area = area_in(cells, *plane);
    if (area > most) {
      most = area;
      best = plane;
    }
  }
  for (int i = 0; best && i < kRefits; ++i) refit(*best, cells);
  return best;
}

/// Areas and noise count one view only where several see the same place. Returns the area in all
/// views.
double measure_plane(Plane& plane) {
  std::vector<double> of_view;
  for (const Cell& cell : plane.cells) {
    of_view.resize(std::max(of_view.size(), static_cast<std::size_t>(cell.view) + 1));
    of_view[cell.view] += cell.area;
  }
  plane.area = of_view.empty() ? 0 : *std::max_element(of_view.begin(), of_view.end());
  if (plane.cells.empty()) return 0;
  plane.noise_scale = median_roughness(plane.cells);
  return std::accumulate(of_view.begin(), of_view.end(), 0.0);
}

}  // namespace

std::vector<Plane> find_planes(std::vector<Cell> cells, const Options& options, bool is_below) {
  const double least = std::cos(options.max_tilt + kTurned);
  const auto is_steep = [&](const Cell& cell) {
    return (is_below ? -cell.n_W.z() : cell.n_W.z()) < least;
  };
  cells.erase(std::remove_if(cells.begin(), cells.end(), is_steep), cells.end());
  std::vector<Plane> planes;
  for (std::uint64_t i = 0; cells.size() >= 3 && planes.size() < kMostPlanes; ++i) {
    auto plane = best_plane(cells, options.seed + i);
    if (!plane) break;
    const double in_all_views = measure_plane(*plane);
    if (plane->cells.size() < 3 || in_all_views < options.min_support_area) break;
    const auto lies = [&](const Cell& cell) { return lies_in(cell, *plane); };
    cells.erase(std::remove_if(cells.begin(), cells.end(), lies), cells.end());
    const bool is_large = plane->area >= options.min_support_area;
    if (is_large && std::abs(plane->n_W.z()) >= std::cos(options.max_tilt)) {
      planes.push_back(*plane);
    }
  }
  return planes;
}

}  // namespace graspless::perception
