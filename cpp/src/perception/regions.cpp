// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graspless/watch.hpp"

namespace graspless::perception {
namespace {

constexpr int kMostCells = 420;         // along a side of the raster
constexpr double kFinest = 0.0015;      // [m]
constexpr double kSurroundings = 0.08;  // of the cells of the fit, that the raster covers too [m]
constexpr int kMargin = 3;              // pixels along the image's border that are not trusted
constexpr int kReach = 6;               // cells without a depth between an edge and what is beyond
constexpr double kTolerance = 0.004;    // of the polygon, at least [m]
constexpr double kMoved = 2;            // and in deviations of the depth
constexpr double kLeastReal = 0.02;     // length of a real edge [m]
constexpr double kLeastDepth = 0.05;    // to the camera [m]
constexpr double kStrip = 0.025;        // widest strip where a wall crosses the plane, [m]
constexpr double kStripNoise = 12;      // and in deviations of the depth

/// z out of the plane, x to the right of the first camera that sees it.
Eigen::Isometry3d frame_of(const Plane& plane, const std::vector<Sighting>& sightings) {
  const int first =
      std::min_element(plane.cells.begin(), plane.cells.end(), [](const Cell& a, const Cell& b) {
        return a.view < b.view;
      })->view;
  const Eigen::Matrix3d R_WC = sightings[first].sight->X_WC.linear();
  Eigen::Isometry3d X_WS = Eigen::Isometry3d::Identity();
  Eigen::Vector3d x = R_WC.col(0) - plane.n_W * plane.n_W.dot(R_WC.col(0));
  if (x.norm() < 0.1) x = R_WC.col(1) - plane.n_W * plane.n_W.dot(R_WC.col(1));
  X_WS.linear().col(0) = x.normalized();
  X_WS.linear().col(1) = plane.n_W.cross(x.normalized());
  X_WS.linear().col(2) = plane.n_W;
  X_WS.translation() = plane.center_W - plane.n_W * plane.above(plane.center_W);
  return X_WS;
}

Raster raster_of(const Plane& plane, const Eigen::Isometry3d& X_WS,
                 const std::vector<Sighting>& sightings) {
  Eigen::AlignedBox2d box;
  double footprint = 1;
  for (const Cell& cell : plane.cells) {
    const Sight& sight = *sightings[cell.view].sight;
    const double reach = kSurroundings + 16 * cell.depth / sight.K(0, 0);
    const Eigen::Vector2d at = (X_WS.inverse() * cell.p_W).head<2>();
    box.extend(at - Eigen::Vector2d::Constant(reach));
    box.extend(at + Eigen::Vector2d::Constant(reach));
    footprint = std::min(footprint, cell.depth / sight.K(0, 0));
  }
  return cover(box, std::max(kFinest, 1.2 * footprint), kMostCells);
}

Ground ground_of(Level level) {
  switch (level) {
    case Level::missing:
      return Ground::unknown;
    case Level::below:
      return Ground::passed;
    case Level::level:
      return Ground::seen;
    case Level::above:
      break;
  }
  return Ground::hidden;
}

/// Looks up, for every cell, the pixel in which one view would see it.
void look(const Sighting& from, const Eigen::Isometry3d& X_WS, Raster& ground) {
  const Sight& sight = *from.sight;
  const Eigen::Matrix3d KR = sight.K * (sight.X_WC.inverse() * X_WS).linear();
  const Eigen::Vector3d corner = sight.K * (sight.X_WC.inverse() * X_WS).translation();
  const Eigen::Vector3d dx = KR.col(0) * ground.cell;
  for (int y = 0; y < ground.ny; ++y) {
    poll();
    const Eigen::Vector2d first = ground.center(0, y);
    Eigen::Vector3d uvw = corner + KR.col(0) * first.x() + KR.col(1) * first.y();
    for (int x = 0; x < ground.nx; ++x, uvw += dx) {
      if (uvw.z() < kLeastDepth) continue;
      const double u = uvw.x() / uvw.z(), v = uvw.y() / uvw.z();
      if (!(u >= kMargin && v >= kMargin && u < sight.width() - kMargin &&
            v < sight.height() - kMargin)) {
        continue;
      }
      const Level level = from.heights.level(static_cast<int>(v + 0.5), static_cast<int>(u + 0.5));
      std::uint8_t& value = ground.values[ground.index(x, y)];
      value = std::max(value, static_cast<std::uint8_t>(ground_of(level)));
    }
  }
}

/// Fills hidden cells between cells of the mask in the same row or column.
void fill_shadows(const Raster& ground, Raster& mask) {
  constexpr double kWidest = 0.4;  // [m]
  const Raster seen = mask;
  const auto fill = [&](int count, const auto& cell) {
    int last = -1;  // of the mask, with hidden or unknown cells since
    for (int i = 0; i < count; ++i) {
      const std::size_t at = cell(i);
      if (seen.values[at]) {
        for (int k = last + 1; last >= 0 && k < i && (i - last) * ground.cell < kWidest; ++k) {
          mask.values[cell(k)] = 1;
        }
        last = i;
      } else if (ground.values[at] != static_cast<std::uint8_t>(Ground::hidden) &&
                 ground.values[at] != static_cast<std::uint8_t>(Ground::unknown)) {
        last = -1;
      }
    }
  };
  for (int y = 0; y < mask.ny; ++y) fill(mask.nx, [&](int x) { return mask.index(x, y); });
  for (int x = 0; x < mask.nx; ++x) fill(mask.ny, [&](int y) { return mask.index(x, y); });
}

/// Deviation of the depths of a plane, where a camera is nearest to its middle.
double noise_of(const Plane& plane, const std::vector<Sighting>& sightings,
                const NoiseModel& noise) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Sighting& sighting : sightings) {
    const double z = (sighting.sight->X_WC.inverse() * plane.center_W).z();
    if (z > kLeastDepth) nearest = std::min(nearest, z);
  }
  return std::isfinite(nearest) ? noise(nearest) : 0;
}

EdgeLabel label_of(const Step& step, const Raster& ground) {
  // Filled cells were not seen: nobody knows whether the support ends there.
  const auto is_seen = [&](int k) {
    return ground.at(step.in_x - k * step.out_x, step.in_y - k * step.out_y) ==
           static_cast<std::uint8_t>(Ground::seen);
  };
  if (!is_seen(0) && !is_seen(1) && !is_seen(2)) return EdgeLabel::occluded;
  for (int k = 1; k <= kReach; ++k) {
    switch (
        static_cast<Ground>(ground.at(step.in_x + k * step.out_x, step.in_y + k * step.out_y))) {
      case Ground::outside:
        return EdgeLabel::image_border;
      case Ground::passed:
        return EdgeLabel::real;
      case Ground::hidden:
        return EdgeLabel::occluded;
      case Ground::unknown:
      case Ground::seen:
        break;
    }
  }
  return EdgeLabel::occluded;
}

double area_of(const Raster& mask) {
  const auto cells = std::count(mask.values.begin(), mask.values.end(), 1);
  return static_cast<double>(cells) * mask.cell * mask.cell;
}

}  // namespace

std::vector<Region> regions_of(const Plane& plane, const std::vector<Sighting>& sightings,
                               const NoiseModel& noise, const Options& options) {
  const Eigen::Isometry3d X_WS = frame_of(plane, sightings);
  Raster ground = raster_of(plane, X_WS, sightings);
  for (const Sighting& sighting : sightings) look(sighting, X_WS, ground);
  const double deviation = noise_of(plane, sightings, noise);
  // Where the side below an edge is seen, pixels of it within the noise of the plane move the edge.
  const double tolerance = std::max({kTolerance, 3 * ground.cell, kMoved * deviation});
  const double strip = std::max(kStrip, kStripNoise * deviation);
  Raster seen = ground;
  for (auto& value : seen.values) value = value == static_cast<std::uint8_t>(Ground::seen);
  const Pieces pieces = pieces_of(seen, false);
  std::vector<Region> regions;
  for (std::size_t k = 0; k < pieces.size.size(); ++k) {
    const double area = static_cast<double>(pieces.size[k]) * ground.cell * ground.cell;
    if (area < options.min_support_area) continue;
    Raster mask = ground;
    for (std::size_t i = 0; i < mask.values.size(); ++i) {
      mask.values[i] = pieces.label[i] == static_cast<int>(k);
    }
    fill_shadows(ground, mask);
    keep_largest(mask);
    clear_strips(mask, static_cast<int>(std::ceil(strip / 2 / ground.cell)));
    keep_largest(mask);
    if (area_of(mask) < options.min_support_area) continue;  // nearly all of it is narrow
    const auto boundary = boundary_of(mask);
    std::vector<EdgeLabel> labels;
    for (const Step& step : boundary) labels.push_back(label_of(step, ground));
    auto outline = fitted_polygon(mask, boundary, labels, tolerance, kLeastReal);
    regions.push_back({X_WS, ground, std::move(mask), std::move(outline), area});
  }
  std::stable_sort(regions.begin(), regions.end(),
                   [](const Region& a, const Region& b) { return a.area > b.area; });
  return regions;
}

std::vector<std::size_t> joined_to(const Region& region) {
  Raster open = region.ground;
  for (std::uint8_t& value : open.values) {
    value = value != static_cast<std::uint8_t>(Ground::outside) &&
            value != static_cast<std::uint8_t>(Ground::passed);
  }
  const Pieces pieces = pieces_of(open, false);
  std::vector<bool> is_joined(pieces.size.size(), false);
  for (std::size_t k = 0; k < open.values.size(); ++k) {
    if (pieces.label[k] >= 0 && region.inside.values[k]) is_joined[pieces.label[k]] = true;
  }
  std::vector<std::size_t> joined;
  for (std::size_t k = 0; k < open.values.size(); ++k) {
    if (pieces.label[k] >= 0 && is_joined[pieces.label[k]]) joined.push_back(k);
  }
  return joined;
}

}  // namespace graspless::perception
