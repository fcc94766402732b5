// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/one_sided.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "graspless/geometry/sampling.hpp"
#include "graspless/watch.hpp"

#include "geometry/directions.hpp"

namespace graspless::geometry {
namespace {

constexpr int kViewDirections = 128;
constexpr std::size_t kTried = 3;  // the best of them
/// Share of the points that one camera sees. Clouds of one view, of 36 shapes and 9 scans, have
/// 0.84 and more (all but one), clouds of all sides of objects with holes at most 0.79.
constexpr double kNearlyAll = 0.82;
constexpr double kFar = 4;     // of a camera, relative to the radius of the cloud
constexpr double kCell = 2;    // side of a pixel, in spacings
constexpr double kBehind = 4;  // depth at which a point hides behind another, in spacings

/// Share of the points behind which, in their pixel, no other is much nearer to a camera far away
/// in a direction; 0 if less than kNearlyAll.
class DepthBuffer {
 public:
  DepthBuffer(const Eigen::Matrix3Xd& points, double spacing)
      : points_(points.transpose()), cell_(kCell * spacing), behind_(kBehind * spacing) {}

  double share(const Eigen::Vector3d& towards) {
    const Eigen::Vector3d x = towards.unitOrthogonal(), y = towards.cross(x);
    const Eigen::ArrayXd u = along(x), v = along(y), height = along(towards);
    project(u, v);
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      double& nearest = nearest_[static_cast<std::size_t>(pixel_[i])];
      nearest = std::max(nearest, height[i]);
    }
    Eigen::Index hidden = 0;
    const auto share = [&] {
      return static_cast<double>(u.size() - hidden) / static_cast<double>(u.size());
    };
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      hidden += !(height[i] > nearest_[static_cast<std::size_t>(pixel_[i])] - behind_);
      if (i % 64 == 0 && share() < kNearlyAll) return 0;
    }
    return share();
  }

 private:
  Eigen::ArrayXd along(const Eigen::Vector3d& direction) const {
    return direction.x() * points_.col(0) + direction.y() * points_.col(1) +
           direction.z() * points_.col(2);
  }

  /// Finds the pixels of points, and clears all. There are about 10^6 at most, as kCell spacings
  /// are no less than a thousandth of the cloud.
  void project(const Eigen::ArrayXd& u, const Eigen::ArrayXd& v) {
    const double left = u.minCoeff(), low = v.minCoeff();
    const int width = static_cast<int>((u.maxCoeff() - left) / cell_) + 1;
    const int rows = static_cast<int>((v.maxCoeff() - low) / cell_) + 1;
    nearest_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(rows),
                    -std::numeric_limits<double>::infinity());
    pixel_.resize(u.size());
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      pixel_[i] =
          static_cast<int>((v[i] - low) / cell_) * width + static_cast<int>((u[i] - left) / cell_);
    }
  }

  const Eigen::ArrayX3d points_;
  double cell_, behind_;
  std::vector<double> nearest_;  // of each pixel
  Eigen::ArrayXi pixel_;         // of each point
};

}  // namespace

bool is_one_sided(const Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
  const Eigen::Vector3d middle = (low + high) / 2;
  const double radius = (points.colwise() - middle).colwise().norm().maxCoeff();
  const double apart = std::max(spacing(points), 1e-3 * radius);
  std::vector<std::pair<double, Eigen::Vector3d>> candidates;
  DepthBuffer buffer(points, apart);
  for (int i = 0; i < kViewDirections; ++i) {
    poll();
    const Eigen::Vector3d towards = spread_direction(i, kViewDirections);
    const double share = buffer.share(towards);
    if (share >= kNearlyAll) candidates.emplace_back(share, towards);
  }
  const std::size_t tried = std::min(kTried, candidates.size());
  std::partial_sort(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(tried),
                    candidates.end(),
                    [](const auto& a, const auto& b) { return a.first > b.first; });
  return std::any_of(candidates.begin(), candidates.begin() + static_cast<std::ptrdiff_t>(tried),
                     [&](const auto& candidate) {
                       const Eigen::Vector3d eye = middle + kFar * radius * candidate.second;
                       const auto seen = static_cast<double>(visible_points(points, eye).size());
                       return seen >= kNearlyAll * static_cast<double>(points.cols());
                     });
}

void doubt_if_one_sided(const Eigen::Matrix3Xd& points, Loops& result) {
  if (result.found.empty() || !is_one_sided(points)) return;
  for (Loop& loop : result.found) {
    loop.reason =
        "one camera could have seen all points, so it may be a rim, or the edge of what was seen; "
        "give rays or viewpoints of the cameras, or points of all sides";
    result.uncertain.push_back(std::move(loop));
  }
  result.found.clear();
  std::stable_sort(result.uncertain.begin(), result.uncertain.end(),
                   [](const Loop& a, const Loop& b) { return a.length < b.length; });
}

}  // namespace graspless::geometry
