// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/footprint.hpp"

#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

namespace graspless::perception {
namespace {

constexpr int kMostOutlineCells = 700;  // along a side of the raster

/// The pixels of a cluster. Those along its boundary get the mean height of the planes of their
/// neighbours within, since theirs may be mixed with the height of what is behind.
std::vector<Pixel> without_mixed_heights(const Cluster& cluster,
                                         const std::vector<PixelSet>& sets) {
  std::vector<Pixel> pixels = cluster.pixels;
  for (Pixel& p : pixels) {
    const PixelSet& set = sets[p.view];
    if (set.has_around(p.u, p.v)) continue;
    float sum = 0, count = 0;
    for (int dv = -1; dv <= 1; ++dv) {
      for (int du = -1; du <= 1; ++du) {
        if (!set.has_around(p.u + du, p.v + dv)) continue;
        const Pixel& inner = cluster.pixels[set.at(p.u + du, p.v + dv)];
        sum += inner.height - static_cast<float>(du) * inner.slope.x() -
               static_cast<float>(dv) * inner.slope.y();
        count += 1;
      }
    }
    if (count > 0) p.height = sum / count;
  }
  return pixels;
}

/// Marks the cells that a pixel covers at its height.
void draw(const Pixel& pixel, const Rays& rays, Raster& raster) {
  const auto at = [&](double du, double dv) {
    return Eigen::Vector2d(rays.at_height(pixel.u + du, pixel.v + dv,
                                          static_cast<double>(pixel.height),
                                          static_cast<double>(pixel.depth))
                               .head<2>());
  };
  const Eigen::Vector2d center = at(0, 0), along_u = at(0.5, 0) - at(-0.5, 0),
                        along_v = at(0, 0.5) - at(0, -0.5);
  const auto count = [&](const Eigen::Vector2d& side) {
    return std::clamp(static_cast<int>(std::ceil(side.norm() / raster.cell)), 1, 12);
  };
  const int nu = count(along_u), nv = count(along_v);
  for (int i = 0; i < nu; ++i) {
    for (int j = 0; j < nv; ++j) {
      const Eigen::Vector2d p =
          center + along_u * ((i + 0.5) / nu - 0.5) + along_v * ((j + 0.5) / nv - 0.5);
      const int x = raster.column(p.x()), y = raster.row(p.y());
      if (raster.has(x, y)) raster.values[raster.index(x, y)] = 1;
    }
  }
}

/// Marks the cells that are seen in pixels of the cluster if they are as high as a flat object's
/// top, and also if they are half as high. Its outline in the image runs along the edge of the top
/// on the far side, but half way down its wall on the near side.
void fill_flat(double thickness, const std::vector<PixelSet>& sets, const std::vector<Rays>& rays,
               Raster& raster) {
  const auto is_covered = [&](std::size_t i, const Eigen::Vector2d& at, double height) {
    const Eigen::Vector3d uvw = rays[i].pixel_of({at.x(), at.y(), height});
    return sets[i].has(static_cast<int>(std::lround(uvw.x() / uvw.z())),
                       static_cast<int>(std::lround(uvw.y() / uvw.z())));
  };
  for (int y = 0; y < raster.ny; ++y) {
    poll();
    for (int x = 0; x < raster.nx; ++x) {
      const Eigen::Vector2d at = raster.center(x, y);
      for (std::size_t i = 0; i < sets.size(); ++i) {
        if (is_covered(i, at, thickness) && is_covered(i, at, thickness / 2)) {
          raster.values[raster.index(x, y)] = 1;
        }
      }
    }
  }
}

}  // namespace

PixelSet::PixelSet(const Cluster& cluster, int view) {
  for (const Pixel& p : cluster.pixels) {
    if (p.view == view) box_.extend(Eigen::Vector2i(p.u, p.v));
  }
  if (box_.isEmpty()) return;
  const Eigen::Vector2i size = box_.sizes() + Eigen::Vector2i::Ones();
  index_.setConstant(size.y(), size.x(), -1);
  for (std::size_t i = 0; i < cluster.pixels.size(); ++i) {
    const Pixel& p = cluster.pixels[i];
    if (p.view == view) index_(p.v - box_.min().y(), p.u - box_.min().x()) = static_cast<int>(i);
  }
}

std::vector<PixelSet> sets_of(const Cluster& cluster, std::size_t views) {
  std::vector<PixelSet> sets;
  for (std::size_t i = 0; i < views; ++i) sets.emplace_back(cluster, static_cast<int>(i));
  return sets;
}

Raster footprint_of(const Cluster& cluster, const std::vector<PixelSet>& sets, const Region& region,
                    const std::vector<Sighting>& sightings, bool is_flat, double thickness) {
  std::vector<Rays> rays;
  for (const Sighting& sighting : sightings) rays.emplace_back(sighting, region.X_WS);
  Eigen::AlignedBox2d box;
  for (const Pixel& p : cluster.pixels) box.extend(p.p.cast<double>());
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(6 * cluster.footprint);
  box.extend(box.min() - margin);
  box.extend(box.max() + margin);
  Raster raster = cover(box, std::max(4e-4, 0.5 * cluster.footprint), kMostOutlineCells);
  if (is_flat) {
    fill_flat(thickness, sets, rays, raster);
  } else {
    for (const Pixel& p : without_mixed_heights(cluster, sets)) {
      draw(p, rays[p.view], raster);
    }
    close_gaps(raster);
  }
  vote(raster);
  keep_largest(raster);
  return raster;
}

}  // namespace graspless::perception
