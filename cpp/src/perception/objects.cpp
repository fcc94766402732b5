// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/objects.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "geometry/quantile.hpp"
#include "perception/footprint.hpp"
#include "perception/rays_around.hpp"

namespace graspless::perception {
namespace {

constexpr double kTop = 0.995;           // quantile of the heights of what is not flat
constexpr double kFlat = 0.15;           // spread of the heights of what is flat, by the thickness
constexpr double kFlatSpread = 0.0015;   // and at least [m]
constexpr double kSignificantTop = 4.5;  // deviations of the mean of a window
constexpr int kBorder = 3;               // pixels

/// Heights of a cluster.
struct Top {
  double thickness, error;
  bool is_flat;
};

double deviation_of(const Cluster& cluster, const std::vector<Sighting>& sightings,
                    const NoiseModel& noise) {
  const Pixel& pixel = cluster.pixels[cluster.pixels.size() / 2];
  const Sighting& from = sightings[pixel.view];
  return from.heights.deviation(noise, static_cast<double>(from.sight->depth(pixel.v, pixel.u)),
                                pixel.u, pixel.v);
}

/// Pixels whose neighbours belong to the cluster too.
std::vector<const Pixel*> interior(const Cluster& cluster, const std::vector<PixelSet>& sets) {
  std::vector<const Pixel*> result;
  for (const Pixel& p : cluster.pixels) {
    if (sets[p.view].has_around(p.u, p.v)) result.push_back(&p);
  }
  return result;
}

Top top_of(const Cluster& cluster, const std::vector<PixelSet>& sets, const Support& support,
           double deviation) {
  auto inner = interior(cluster, sets);
  if (inner.size() < 5) {
    inner.clear();
    for (const Pixel& p : cluster.pixels) inner.push_back(&p);
  }
  std::vector<float> heights;
  double sum = 0;
  for (const Pixel* p : inner) {
    heights.push_back(p->height);
    sum += static_cast<double>(p->raw);
  }
  const auto n = static_cast<double>(inner.size());
  const double middle = static_cast<double>(geometry::quantile(heights, 0.5));
  const double spread =
      static_cast<double>(geometry::quantile(heights, 0.95) - geometry::quantile(heights, 0.05));
  // Means of 5 x 5 pixels still spread by a fifth of the noise.
  const double expected = 3.3 * deviation / 5;
  const double plane = std::hypot(support.height_error, 0.3e-3);
  if (spread < std::max(kFlatSpread, kFlat * middle) + expected) {
    return {sum / n, std::hypot(deviation / std::sqrt(n), plane), true};
  }
  return {static_cast<double>(geometry::quantile(heights, kTop)), std::hypot(deviation / 5, plane),
          false};
}

/// Centroid and longest axis of the cells.
Eigen::Isometry3d frame_in(const Raster& raster, double& length) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  double count = 0;
  for (int y = 0; y < raster.ny; ++y) {
    for (int x = 0; x < raster.nx; ++x) {
      if (!raster.at(x, y)) continue;
      const Eigen::Vector2d p = raster.center(x, y);
      mean += p;
      spread += p * p.transpose();
      count += 1;
    }
  }
  mean /= count;
  spread = spread / count - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  Eigen::Vector2d x = axes.eigenvectors().col(1);
  if (x.x() < 0 || (x.x() == 0 && x.y() < 0)) x = -x;  // to the right, as the camera sees it
  length = std::sqrt(12 * std::max(axes.eigenvalues()[1], 1e-12));
  Eigen::Isometry3d X_SO = Eigen::Isometry3d::Identity();
  X_SO.linear().col(0) << x.x(), x.y(), 0;
  X_SO.linear().col(1) << -x.y(), x.x(), 0;
  X_SO.translation().head<2>() = mean;
  return X_SO;
}

/// True if no view has the whole object in its image.
bool is_cut_off(const Cluster& cluster, const std::vector<Sighting>& sightings) {
  std::vector<bool> has_whole(sightings.size(), false);
  for (const Pixel& p : cluster.pixels) has_whole[p.view] = true;
  for (const Pixel& p : cluster.pixels) {
    const auto view = static_cast<std::size_t>(p.view);
    const Sight& sight = *sightings[view].sight;
    const bool is_at_border = p.u < kBorder || p.v < kBorder || p.u >= sight.width() - kBorder ||
                              p.v >= sight.height() - kBorder;
    if (is_at_border) has_whole[view] = false;
  }
  return std::find(has_whole.begin(), has_whole.end(), true) == has_whole.end();
}

/// True if something nearer to the camera is beside many pixels of the object, so that it may hide
/// a part of it.
bool is_partly_hidden(const Cluster& cluster, const std::vector<Sighting>& sightings,
                      const NoiseModel& noise) {
  constexpr int kBeside = 3;
  std::size_t hidden = 0;
  for (const Pixel& p : cluster.pixels) {
    const Sight& sight = *sightings[p.view].sight;
    const double z = static_cast<double>(sight.depth(p.v, p.u));
    const double step = 2 * largest_step(sight, noise, z);
    const auto is_nearer = [&](int dv, int du) {
      const int v = p.v + dv, u = p.u + du;
      if (u < 0 || v < 0 || u >= sight.width() || v >= sight.height()) return false;
      const double other = static_cast<double>(sight.depth(v, u));
      return other > 0 && other < z - step;
    };
    hidden += is_nearer(kBeside, 0) || is_nearer(-kBeside, 0) || is_nearer(0, kBeside) ||
              is_nearer(0, -kBeside);
  }
  const double around = 4 * std::sqrt(static_cast<double>(cluster.pixels.size()));
  return static_cast<double>(hidden) > 0.15 * around;
}

/// Two heights at which much of the object is level; empty if there are none. Such objects may be
/// two, one on top of the other.
std::vector<double> levels_of(const Cluster& cluster) {
  constexpr double kBin = 0.004;    // [m]
  constexpr double kLeast = 0.15;   // share of the pixels at each height
  constexpr double kApart = 0.012;  // [m]
  std::vector<double> bins;
  for (const Pixel& p : cluster.pixels) {
    const auto bin = static_cast<std::size_t>(std::max(0.0, static_cast<double>(p.height) / kBin));
    if (bins.size() <= bin + 2) bins.resize(bin + 3, 0);
    bins[bin] += 1 / static_cast<double>(cluster.pixels.size());
  }
  std::vector<double> levels;
  for (std::size_t i = 1; i + 1 < bins.size(); ++i) {
    const double around = bins[i - 1] + bins[i] + bins[i + 1];
    const bool is_peak = bins[i] >= bins[i - 1] && bins[i] > bins[i + 1] && bins[i] > 0.5 * around;
    if (is_peak && around > kLeast) levels.push_back((static_cast<double>(i) + 0.5) * kBin);
  }
  if (levels.size() < 2 || levels.back() - levels.front() < kApart) levels.clear();
  return levels;
}

void warn(Object& object, const Cluster& cluster, const std::vector<Sighting>& sightings,
          const NoiseModel& noise) {
  if (object.touches_border) {
    object.warnings.push_back(
        "the image cuts it off: outline and centre are those of the part in the image; move the "
        "camera");
  }
  if (is_partly_hidden(cluster, sightings, noise)) {
    object.warnings.push_back(
        "something nearer may hide part of it: outline and centre are those of what was seen; add "
        "a view from another side");
  }
  const std::vector<double> levels = levels_of(cluster);
  if (!object.is_flat && !levels.empty()) {
    std::ostringstream text;
    text.precision(2);
    text << "it has level faces at heights of";
    for (const double level : levels) text << ' ' << 100 * level;
    text << " cm: it may be several objects, one on top of another";
    object.warnings.push_back(text.str());
  }
}

}  // namespace

std::optional<Object> measure(const Cluster& cluster, const Region& region, const Support& support,
                              const std::vector<Sighting>& sightings, const NoiseModel& noise,
                              const Options& options) {
  const double deviation = deviation_of(cluster, sightings, noise);
  const std::vector<PixelSet> sets = sets_of(cluster, sightings.size());
  const Top top = top_of(cluster, sets, support, deviation);
  const Raster raster = footprint_of(cluster, sets, region, sightings, top.is_flat, top.thickness);
  const auto cells = std::count(raster.values.begin(), raster.values.end(), 1);
  const double area = static_cast<double>(cells) * raster.cell * raster.cell;
  const Pixel& middle = cluster.pixels[cluster.pixels.size() / 2];
  const int window = sightings[middle.view].heights.window;
  const double least = std::max(options.min_thickness, kSignificantTop * deviation / window);
  // A cluster that only its mean tells from noise must fill a good part of a window in every view.
  const double fewest = 0.4 * window * window * static_cast<double>(sightings.size());
  const bool is_speck = top.thickness < kSignificantTop * deviation &&
                        static_cast<double>(cluster.pixels.size()) < fewest;
  if (is_speck || area < options.min_object_area || top.thickness < least) return std::nullopt;
  double length = 0;
  const Eigen::Isometry3d X_SO = frame_in(raster, length);
  const geometry::Polygon in_S = simple_polygon(raster, boundary_of(raster), raster.cell);
  Eigen::Matrix2Xd vertices = in_S.vertices().colwise() - X_SO.translation().head<2>();
  vertices = X_SO.linear().topLeftCorner<2, 2>().transpose() * vertices;
  Object object{"",
                support.name,
                geometry::Polygon(vertices),
                region.X_WS * X_SO,
                top.thickness,
                top.error,
                top.is_flat,
                0.5 * cluster.footprint,
                cluster.footprint / length,
                Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(cluster.pixels.size())),
                rays_around(cluster, sets, region.X_WS, region.X_WS * X_SO, sightings, noise,
                            options, support.height_error),
                is_cut_off(cluster, sightings),
                {}};
  const Eigen::Isometry3d X_OS = X_SO.inverse();
  for (std::size_t i = 0; i < cluster.pixels.size(); ++i) {
    const Pixel& p = cluster.pixels[i];
    object.points.col(i) =
        X_OS * Eigen::Vector3d(static_cast<double>(p.p.x()), static_cast<double>(p.p.y()),
                               static_cast<double>(p.height));
  }
  warn(object, cluster, sightings, noise);
  return object;
}

}  // namespace graspless::perception
