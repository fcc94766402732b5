// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/clusters.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "graspless/watch.hpp"

namespace graspless::perception {
namespace {

constexpr double kSpacing = 2;         // side of a cell, in pixels projected onto the plane
constexpr double kFinestCell = 0.003;  // [m]
constexpr int kMostAlong = 600;        // cells
constexpr double kLeastInside = 0.3;   // least share of an object's cells that lie over the region
constexpr double kLeastOver = 0.5;  // the same, with those that the image does not show the foot of
constexpr int kFewest = 12;         // pixels of an object
constexpr int kFewestHigh = 50;     // pixels of something that is higher than objects
constexpr int kHalf = 2;            // of the window that smooths heights [pixels]
constexpr float kLeastSpread = 2;   // of pixels whose slope is known [pixels^2]

/// A plane through the heights around a pixel: its height there, and its slopes along u and v.
struct Patch {
  float height;
  Eigen::Vector2f slope;
};

/// Fits a plane to the heights of a pixel above the support and of its neighbours on the same
/// surface. Their mean would lift a pixel at the foot of a wall, whose neighbours are all higher;
/// it is taken where they are too few for a slope.
Patch smoothed(const Sighting& from, const NoiseModel& noise, int u, int v) {
  const DepthImage& depth = from.sight->depth;
  const float z = depth(v, u);
  const auto step = static_cast<float>(largest_step(*from.sight, noise, static_cast<double>(z)));
  int n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;  // numbers, as sums of small matrices wait
  float h = 0, hx = 0, hy = 0;
  for (int y = std::max(v - kHalf, 0); y <= std::min(v + kHalf, from.sight->height() - 1); ++y) {
    for (int x = std::max(u - kHalf, 0); x <= std::min(u + kHalf, from.sight->width() - 1); ++x) {
      if (!(std::abs(depth(y, x) - z) < step) || from.heights.level(y, x) != Level::above) continue;
      const int dx = x - u, dy = y - v;
      const float height = from.heights.height(y, x);
      ++n;
      sx += dx;
      sy += dy;
      sxx += dx * dx;
      sxy += dx * dy;
      syy += dy * dy;
      h += height;
      hx += height * static_cast<float>(dx);
      hy += height * static_cast<float>(dy);
    }
  }
  Eigen::Matrix3i counts;
  counts << n, sx, sy, sx, sxx, sxy, sy, sxy, syy;
  const Eigen::Matrix3f squares = counts.cast<float>();
  const Eigen::Vector3f sums(h, hx, hy);
  const Eigen::LDLT<Eigen::Matrix3f> solver(squares);
  if (solver.vectorD().minCoeff() < kLeastSpread) {
    return {sums[0] / squares(0, 0), Eigen::Vector2f::Zero()};
  }
  const Eigen::Vector3f fit = solver.solve(sums);
  return {fit[0], fit.tail<2>()};
}

/// Raw height of a pixel [m].
float raw_height(const Sighting& from, int u, int v) {
  const double z = static_cast<double>(from.sight->depth(v, u));
  return static_cast<float>(z * from.heights.across.dot(Eigen::RowVector3d(u, v, 1)) +
                            from.heights.camera);
}

/// Pixels over a region that are too high for an object.
struct TooHigh {
  int count = 0;
  float height = 0;  ///< of the highest [m]
};

/// All free pixels of a view that lie above the plane, near the region.
void collect(const Sighting& from, int view, const Region& region, const NoiseModel& noise,
             const Options& options, const Claims& claims, std::vector<Pixel>& pixels,
             TooHigh& too_high) {
  const Sight& sight = *from.sight;
  const Rays rays(from, region.X_WS);
  const Raster& mask = region.inside;
  const auto highest = static_cast<float>(options.max_height);
  for (int v = 0; v < sight.height(); ++v) {
    poll();
    for (int u = 0; u < sight.width(); ++u) {
      if (from.heights.level(v, u) != Level::above) continue;
      if (claims[view](v, u)) continue;
      const double z = static_cast<double>(sight.depth(v, u));
      const Eigen::Vector3d p = rays.at_depth(u, v, z);
      const int column = mask.column(p.x()), row = mask.row(p.y());
      if (const float height = from.heights.height(v, u); height > highest) {
        if (!mask.at(column, row)) continue;
        ++too_high.count;
        too_high.height = std::max(too_high.height, height);
        continue;
      }
      if (!mask.has(column, row)) continue;
      const Patch patch = smoothed(from, noise, u, v);
      // The smoother height also gives a smoother place on the ray.
      const Eigen::Vector3d placed = rays.at_height(u, v, static_cast<double>(patch.height), z);
      pixels.push_back({view, u, v, sight.depth(v, u), patch.height, patch.slope,
                        raw_height(from, u, v), placed.head<2>().cast<float>()});
    }
  }
}

/// Pixels of a cluster.
struct Counts {
  std::size_t all = 0;
  std::size_t inside = 0;   ///< over the region
  std::size_t outside = 0;  ///< over places that are not in the images
};

/// True if something stands on the region, as far as the images show where it stands: of what the
/// lower border cuts off, they may show the top alone.
bool stands_there(const Counts& counts) {
  const auto all = static_cast<double>(counts.all), inside = static_cast<double>(counts.inside);
  if (inside >= kLeastInside * all) return true;
  return inside >= kFewest && inside + static_cast<double>(counts.outside) >= kLeastOver * all;
}

double spacing_of(const std::vector<Pixel>& pixels, const std::vector<Sighting>& sightings,
                  const Region& region) {
  const Pixel& pixel = pixels[pixels.size() / 2];
  const Rays rays(sightings[pixel.view], region.X_WS);
  const auto at = [&](int dv) {
    return rays.at_height(pixel.u, pixel.v + dv, static_cast<double>(pixel.height),
                          static_cast<double>(pixel.depth));
  };
  return (at(1) - at(0)).head<2>().norm();
}

}  // namespace

Rays::Rays(const Sighting& from, const Eigen::Isometry3d& X_WS)
    : across_(from.heights.across), camera_(from.heights.camera) {
  const Eigen::Isometry3d X_SC = X_WS.inverse() * from.sight->X_WC;
  origin_ = X_SC.translation();
  directions_ = X_SC.linear() * from.sight->K.inverse();
  to_pixels_ = from.sight->K * X_SC.linear().transpose();
}

std::vector<Cluster> clusters_over(const Region& region, const std::vector<Sighting>& sightings,
                                   const NoiseModel& noise, const Options& options, Claims& claims,
                                   double& left_out) {
  std::vector<Pixel> pixels;
  TooHigh too_high;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    collect(sightings[i], static_cast<int>(i), region, noise, options, claims, pixels, too_high);
  }
  left_out = too_high.count < kFewestHigh ? 0 : static_cast<double>(too_high.height);
  if (pixels.empty()) return {};
  Eigen::AlignedBox2d box;
  for (const Pixel& pixel : pixels) box.extend(pixel.p.cast<double>());
  const double cell = std::max(kFinestCell, kSpacing * spacing_of(pixels, sightings, region));
  Raster occupied = cover(box, cell, kMostAlong);
  const auto index = [&](const Pixel& pixel) {
    return occupied.index(occupied.column(static_cast<double>(pixel.p.x())),
                          occupied.row(static_cast<double>(pixel.p.y())));
  };
  for (const Pixel& pixel : pixels) occupied.values[index(pixel)] = 1;
  const Pieces pieces = pieces_of(occupied, true);
  std::vector<Cluster> clusters(pieces.size.size());
  std::vector<Counts> counts(pieces.size.size());
  for (const Pixel& pixel : pixels) {
    const auto label = static_cast<std::size_t>(pieces.label[index(pixel)]);
    clusters[label].pixels.push_back(pixel);
    const Eigen::Vector2d p = pixel.p.cast<double>();
    const int column = region.inside.column(p.x()), row = region.inside.row(p.y());
    ++counts[label].all;
    counts[label].inside += region.inside.at(column, row);
    counts[label].outside +=
        region.ground.at(column, row) == static_cast<std::uint8_t>(Ground::outside);
  }
  std::vector<Cluster> kept;
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    Cluster& cluster = clusters[k];
    if (static_cast<int>(cluster.pixels.size()) < kFewest) continue;
    if (!stands_there(counts[k])) continue;
    for (const Pixel& pixel : cluster.pixels) {
      claims[pixel.view](pixel.v, pixel.u) = true;
    }
    const Pixel& middle = cluster.pixels[cluster.pixels.size() / 2];
    const Sight& sight = *sightings[middle.view].sight;
    cluster.footprint = static_cast<double>(sight.depth(middle.v, middle.u)) / sight.K(0, 0);
    kept.push_back(std::move(cluster));
  }
  return kept;
}

}  // namespace graspless::perception
