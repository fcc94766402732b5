// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/rays_around.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "graspless/watch.hpp"

#include "geometry/masks.hpp"

namespace graspless::perception {
namespace {

constexpr int kAround = 4;              // pixels around the object
constexpr double kMostPixels = 60'000;  // of an image of rays
constexpr double kBottom = 0.4;         // least height of a bottom, relative to min_thickness
constexpr double kGround = 0.01;        // around an object [m]
constexpr double kQuantum = 1e-4;       // of depths [m]

using geometry::Mask;

/// The part of a view around an object: every stride-th pixel from (u, v).
struct Window {
  int u, v, stride;
  Eigen::Index rows, columns;

  int column(Eigen::Index x) const { return u + stride * static_cast<int>(x); }
  int row(Eigen::Index y) const { return v + stride * static_cast<int>(y); }
};

Window window_of(const Eigen::AlignedBox2i& box, const Sight& sight) {
  const Eigen::Vector2i first = (box.min().array() - kAround).max(0);
  const Eigen::Vector2i last =
      (box.max().array() + kAround).min(Eigen::Array2i(sight.width() - 1, sight.height() - 1));
  const Eigen::Vector2i size = last - first + Eigen::Vector2i::Ones();
  const double pixels = static_cast<double>(size.x()) * size.y();
  const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kMostPixels))));
  return {first.x(), first.y(), stride, (size.y() + stride - 1) / stride,
          (size.x() + stride - 1) / stride};
}

bool is_low(Level level) { return level == Level::level || level == Level::below; }

/// Finds the patches of the support in a window.
class Patches {
 public:
  Patches(const Window& window, const Sighting& from, const PixelSet& set)
      : window_(window), from_(from), low_(window.rows, window.columns) {
    for (Eigen::Index y = 0; y < low_.rows(); ++y) {
      for (Eigen::Index x = 0; x < low_.cols(); ++x) {
        const int u = window.column(x), v = window.row(y);
        low_(y, x) = is_low(from.heights.level(v, u)) && !set.has(u, v);
      }
    }
  }

  /// Pixels of patches that are as high as the support. Patches are at least two pixels wide
  /// everywhere, so that the bottom of a dish is not one with the table around it.
  Mask reliable(const NoiseModel& noise, double highest, double height_error) const {
    Mask inner = geometry::opened(low_);
    Mask result = Mask::Constant(low_.rows(), low_.cols(), false);
    std::vector<Eigen::Index> patch;
    for (Eigen::Index seed = 0; seed < inner.size(); ++seed) {
      if (!inner.data()[seed]) continue;
      poll();
      geometry::take_connected(inner, seed, patch);
      if (!(height_of(patch, noise, height_error) <= highest)) continue;
      for (const Eigen::Index at : patch) result.data()[at] = true;
    }
    return result;
  }

 private:
  /// Upper bound of the mean height of a patch, by two standard errors [m].
  double height_of(const std::vector<Eigen::Index>& patch, const NoiseModel& noise,
                   double height_error) const {
    double sum = 0, variance = 0;
    for (const Eigen::Index at : patch) {
      const int u = window_.column(at % low_.cols()), v = window_.row(at / low_.cols());
      const double z = static_cast<double>(from_.sight->depth(v, u));
      sum += z * from_.heights.across.dot(Eigen::RowVector3d(u, v, 1)) + from_.heights.camera;
      const double deviation = from_.heights.deviation(noise, z, u, v);
      variance += deviation * deviation;
    }
    const auto n = static_cast<double>(patch.size());
    return sum / n + 2 * std::hypot(std::sqrt(variance) / n, height_error);
  }

  const Window& window_;
  const Sighting& from_;
  Mask low_;
};

float end_of(float depth) {
  return static_cast<float>(kQuantum * std::round(static_cast<double>(depth) / kQuantum));
}

/// The part of the support under an object, and a margin.
Eigen::AlignedBox2d ground_of(const Cluster& cluster) {
  Eigen::AlignedBox2d ground;
  for (const Pixel& pixel : cluster.pixels) ground.extend(pixel.p.cast<double>());
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(kGround);
  return {ground.min() - margin, ground.max() + margin};
}

/// `ground`: rays that end above it are unknown, unless they end on the object.
geometry::RayImage rays_in(const Window& window, const Sighting& from, const PixelSet& set,
                           const Mask& passes, const Rays& lines,
                           const Eigen::AlignedBox2d& ground) {
  geometry::RayImage rays;
  rays.K = from.sight->K;
  rays.K(0, 2) -= window.u;
  rays.K(1, 2) -= window.v;
  rays.K.topRows<2>() /= window.stride;
  rays.ends.resize(window.rows, window.columns);
  rays.clear.setZero(window.rows, window.columns);
  for (Eigen::Index y = 0; y < window.rows; ++y) {
    for (Eigen::Index x = 0; x < window.columns; ++x) {
      const int u = window.column(x), v = window.row(y);
      const float depth = end_of(from.sight->depth(v, u));
      if (set.has(u, v)) {
        rays.ends(y, x) = -depth;
      } else if (passes(y, x)) {
        rays.ends(y, x) = std::numeric_limits<float>::infinity();
      } else {
        const Eigen::Vector3d end = lines.at_depth(u, v, static_cast<double>(depth));
        const bool is_bottom = is_low(from.heights.level(v, u)),
                   is_unknown = is_bottom || ground.contains(end.head<2>().eval());
        rays.ends(y, x) = is_unknown ? 0 : depth;
        if (is_bottom && depth > 0) rays.clear(y, x) = depth;
      }
    }
  }
  return rays;
}

}  // namespace

std::vector<geometry::RayImage> rays_around(
    const Cluster& cluster, const std::vector<PixelSet>& sets, const Eigen::Isometry3d& X_WS,
    const Eigen::Isometry3d& X_WO, const std::vector<Sighting>& sightings, const NoiseModel& noise,
    const Options& options, double height_error) {
  std::vector<Eigen::AlignedBox2i> boxes(sightings.size());
  for (const Pixel& p : cluster.pixels) boxes[p.view].extend(Eigen::Vector2i(p.u, p.v));
  const Eigen::AlignedBox2d ground = ground_of(cluster);
  std::vector<geometry::RayImage> result;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    if (boxes[i].isEmpty()) continue;
    const Sight& sight = *sightings[i].sight;
    const Window window = window_of(boxes[i], sight);
    const Mask passes = Patches(window, sightings[i], sets[i])
                            .reliable(noise, kBottom * options.min_thickness, height_error);
    result.push_back(
        rays_in(window, sightings[i], sets[i], passes, Rays(sightings[i], X_WS), ground));
    result.back().X_OC = X_WO.inverse() * sight.X_WC;
  }
  return result;
}

}  // namespace graspless::perception
