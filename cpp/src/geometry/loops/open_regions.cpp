// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/open_regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "graspless/geometry/pose.hpp"
#include "graspless/watch.hpp"

#include "geometry/convex_hull.hpp"
#include "geometry/masks.hpp"

namespace graspless::geometry {
namespace {

constexpr int kFewest = 9;  // pixels of a region
constexpr Eigen::Index kMostPixels = 25'000'000;

/// Length of a ray p + t r up to where it leaves the hull for good; 0 if it misses it.
double exit_of(const Planes& hull, const Eigen::Vector3d& p, const Eigen::Vector3d& r) {
  double in = 0, out = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < hull.rows(); ++i) {
    const Eigen::Vector3d n = hull.row(i).head<3>();
    const double slope = n.dot(r), room = hull(i, 3) - n.dot(p);
    if (slope > 0) {
      out = std::min(out, room / slope);
    } else if (slope < 0) {
      in = std::max(in, room / slope);
    } else if (room < 0) {
      return 0;
    }
    if (in > out) return 0;
  }
  return out;
}

Mask passing(const RayImage& rays, const Planes& hull) {
  const Eigen::Matrix3d directions = rays.X_OC.linear() * rays.K.inverse();
  const Eigen::Vector3d origin = rays.X_OC.translation();
  Mask passes(rays.ends.rows(), rays.ends.cols());
  for (Eigen::Index v = 0; v < passes.rows(); ++v) {
    poll();
    for (Eigen::Index u = 0; u < passes.cols(); ++u) {
      const auto end = static_cast<double>(rays.ends(v, u));
      const Eigen::Vector3d pixel(static_cast<double>(u), static_cast<double>(v), 1);
      passes(v, u) =
          end > 0 && (std::isinf(end) || end >= exit_of(hull, origin, directions * pixel));
    }
  }
  return passes;
}

}  // namespace

void validate(const RayImage& rays, const std::string& field) {
  const auto require = [&](bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument(field + what);
  };
  require(rays.ends.size() > 0 && rays.ends.size() <= kMostPixels,
          ".ends must have 1 to 25000000 pixels, not " + std::to_string(rays.ends.size()));
  const float lowest = -std::numeric_limits<float>::infinity();
  require((rays.ends > lowest).all(), ".ends must be numbers, and not -inf");
  const bool is_sound =
      rays.clear.size() == 0 ||
      (rays.clear.rows() == rays.ends.rows() && rays.clear.cols() == rays.ends.cols() &&
       rays.clear.isFinite().all() && (rays.clear >= 0).all());
  require(is_sound, ".clear must be as many finite depths as .ends, and none of them negative");
  const bool is_camera = rays.K.allFinite() && rays.K(0, 0) > 0 && rays.K(1, 1) > 0 &&
                         rays.K(0, 1) == 0 && rays.K(1, 0) == 0 &&
                         rays.K.row(2) == Eigen::RowVector3d(0, 0, 1);
  require(is_camera, ".K must be the matrix of a pinhole camera without skew");
  require_pose(rays.X_OC, field + ".X_OC");
}

Planes hull_of(const Eigen::Matrix3Xd& points) {
  return half_spaces(convex_hull(points)).transpose();
}

Eigen::Array<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> open_regions(
    const RayImage& rays, const Planes& hull, std::vector<int>& sizes) {
  Mask open = opened(passing(rays, hull));
  Eigen::Array<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> labels =
      Eigen::ArrayXXi::Constant(open.rows(), open.cols(), -1);
  std::vector<Eigen::Index> members;
  for (Eigen::Index seed = 0; seed < open.size(); ++seed) {
    if (!open.data()[seed]) continue;
    poll();
    take_connected(open, seed, members);
    if (static_cast<int>(members.size()) < kFewest) continue;
    for (const Eigen::Index at : members) labels.data()[at] = static_cast<int>(sizes.size());
    sizes.push_back(static_cast<int>(members.size()));
  }
  return labels;
}

}  // namespace graspless::geometry
