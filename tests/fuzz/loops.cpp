// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/loops.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "graspless/geometry/sampling.hpp"

#include "fuzz/targets.hpp"

namespace graspless::fuzz {
namespace {

using namespace geometry;

Eigen::Vector3d on_ring(double around, double across, double tube) {
  const double u = 2 * M_PI * around, v = 2 * M_PI * across, r = 1 + tube * std::cos(v);
  return {r * std::cos(u), r * std::sin(u), tube * std::sin(v)};
}

/// Points on a ring or anywhere in a cube.
Eigen::Matrix3Xd cloud(Bytes& bytes) {
  const bool ring = bytes.chance(2);
  Eigen::Matrix3Xd points(3, bytes.whole(0, 120));
  for (auto p : points.colwise()) {
    p = bytes.vector(0, 1);
    if (ring) p = on_ring(p.x(), p.y(), 0.1 + 0.3 * p.z());
  }
  return points;
}

LoopOptions loop_options(Bytes& bytes) {
  LoopOptions options;
  if (bytes.chance(2)) options.max_edge_length = bytes.number(0, 2);
  options.min_ratio = bytes.number(1.01, 3);
  if (bytes.chance(4)) options.max_points = bytes.whole(90, 110);
  options.polish = bytes.chance(4);
  options.drop_meridians = !bytes.chance(4);
  return options;
}

/// Rays of cameras near the points, most of them valid.
std::vector<RayImage> ray_images(Bytes& bytes) {
  std::vector<RayImage> images(static_cast<std::size_t>(bytes.whole(0, 2)));
  for (RayImage& rays : images) {
    rays.ends.resize(bytes.whole(1, 12), bytes.whole(1, 12));
    for (float& end : rays.ends.reshaped()) {
      const double depth = bytes.number(-4, 6);
      end = static_cast<float>(depth > 4 ? std::numeric_limits<double>::infinity() : depth);
    }
    rays.K << bytes.number(1, 20), 0, bytes.number(0, 12), 0, bytes.number(1, 20), 6, 0, 0, 1;
    rays.X_OC.translation() = 3 * bytes.vector(-1, 1);
  }
  return images;
}

void require_loop(const Loop& loop, const Eigen::Matrix3Xd& points) {
  require(loop.vertices.size() >= 3, "a loop has three corners or more");
  require(std::isfinite(loop.length) && loop.length > 0, "the length of a loop is positive");
  require(loop.birth <= loop.death && loop.thickness >= 0, "a loop dies after its birth");
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    require(loop.vertices[i] >= 0 && loop.vertices[i] < points.cols(), "corners are points");
    require(loop.points.col(static_cast<Eigen::Index>(i)) == points.col(loop.vertices[i]),
            "corners are at their points");
  }
  for (const ClaspTarget& target : clasp_targets(loop.points, 8)) {
    require(target.point.allFinite() && std::abs(target.tangent.norm() - 1) < 1e-6,
            "tangents are unit vectors");
  }
}

}  // namespace

void find_loops(Bytes bytes) {
  accepts([&] {
    const LoopOptions options = loop_options(bytes);
    const double cell = bytes.number(0.01, 1);
    const Eigen::Matrix3Xd points = cloud(bytes);
    const Loops found = shortest_loops(points, options, ray_images(bytes));
    require((found.status == LoopStatus::found) != found.found.empty(),
            "the status is that of loops");
    for (const Loop& loop : found.found) require_loop(loop, points);
    for (const Loop& loop : found.meridians) require_loop(loop, points);
    for (const Loop& loop : found.uncertain) {
      require_loop(loop, points);
      require(!loop.reason.empty(), "an uncertain loop has a reason");
    }
    require(found.noise >= 0, "classes are counted once");
    require(!downsample(points, cell).empty(), "a downsampled cloud has a point");
    visible_points(points, bytes.vector(-3, 3));
  });
}

}  // namespace graspless::fuzz
