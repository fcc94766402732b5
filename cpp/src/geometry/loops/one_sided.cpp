// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/one_sided.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include "graspless/geometry/sampling.hpp"
#include "graspless/watch.hpp"

#include "geometry/directions.hpp"
#include "geometry/quantile.hpp"
#include "geometry/sampling/downsample.hpp"

namespace graspless::geometry {
namespace {

constexpr int kViewDirections = 128;
constexpr std::size_t kTried = 3;  // the best of them
/// Share of the points that one camera sees. Clouds of one view, of 36 shapes and 9 scans, have
/// 0.84 and more (all but one), clouds of all sides of objects with holes at most 0.79. With noise
/// of 0.5 and 1 mm, nine tenths of the views of 29 scans have more after they are thinned, and
/// clouds of all sides at most 0.77.
constexpr double kNearlyAll = 0.82;
constexpr double kSmooth = 0.15;  // roughness up to which hidden points are told
/// Roughness that noise as large as the spacing makes. Rods and rims that are thinner than the
/// spacing are rougher, and noise leaves no surface to look at.
constexpr double kNoSurface = 0.65;
constexpr Eigen::Index kNeighbours = 13;
/// Part of the roughness that is left among twice as many neighbours, at most, if noise makes it.
/// Thin rods and rings are rougher there.
constexpr double kFalls = 0.95;
constexpr int kLeastCount = 60;  // points
constexpr double kFar = 4;       // of a camera, relative to the radius of the cloud
constexpr double kCell = 2;      // side of a pixel, in spacings
constexpr double kBehind = 4;    // depth at which a point hides behind another, in spacings

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
      double& nearest = nearest_[pixel_[i]];
      nearest = std::max(nearest, height[i]);
    }
    Eigen::Index hidden = 0;
    const auto share = [&] {
      return static_cast<double>(u.size() - hidden) / static_cast<double>(u.size());
    };
    for (Eigen::Index i = 0; i < u.size(); ++i) {
      hidden += !(height[i] > nearest_[pixel_[i]] - behind_);
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

/// Deviation of the points from the planes of their neighbourhoods, as a part of that along them:
/// 0.05 on a smooth surface, 0.5 with noise of half the spacing. A median.
double roughness(const Eigen::Matrix3Xd& points, Eigen::Index neighbours) {
  constexpr Eigen::Index kLooks = 100;
  const Eigen::Index n = points.cols(), count = std::min(neighbours, n);
  std::vector<double> rough;
  std::vector<std::pair<double, Eigen::Index>> near(n);
  for (Eigen::Index i = 0; i < n; i += std::max<Eigen::Index>(1, n / kLooks)) {
    poll();
    for (Eigen::Index k = 0; k < n; ++k)
      near[k] = {(points.col(k) - points.col(i)).squaredNorm(), k};
    std::nth_element(near.begin(), near.begin() + (count - 1), near.end());
    Eigen::Matrix3Xd around(3, count);
    for (Eigen::Index k = 0; k < count; ++k) around.col(k) = points.col(near[k].second);
    around.colwise() -= around.rowwise().mean().eval();
    const Eigen::Vector3d squares =  // ascending
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(around * around.transpose(),
                                                       Eigen::EigenvaluesOnly)
            .eigenvalues();
    if (squares[1] > 0) rough.push_back(std::sqrt(std::max(0.0, squares[0]) / squares[1]));
  }
  return rough.empty() ? 0 : median(rough);
}

/// A cloud, and the directions in which it may show nearly all of its points to a camera.
struct Cloud {
  const Eigen::Matrix3Xd& points;
  Eigen::Vector3d middle;
  double radius;
  std::vector<Eigen::Vector3d> directions;  // those in which fewest are hidden

  explicit Cloud(const Eigen::Matrix3Xd& given) : points(given) {
    const Eigen::Vector3d low = points.rowwise().minCoeff(), high = points.rowwise().maxCoeff();
    middle = (low + high) / 2;
    radius = (points.colwise() - middle).colwise().norm().maxCoeff();
    std::vector<std::pair<double, Eigen::Vector3d>> candidates;
    DepthBuffer buffer(points, std::max(spacing(points), 1e-3 * radius));
    for (int i = 0; i < kViewDirections; ++i) {
      poll();
      const Eigen::Vector3d towards = spread_direction(i, kViewDirections);
      const double share = buffer.share(towards);
      if (share >= kNearlyAll) candidates.emplace_back(share, towards);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    for (std::size_t i = 0; i < std::min(kTried, candidates.size()); ++i)
      directions.push_back(candidates[i].second);
  }

  /// True if a camera in one of the directions sees nearly all points.
  bool is_seen() const {
    return std::any_of(directions.begin(), directions.end(), [&](const auto& towards) {
      const Eigen::Vector3d eye = middle + kFar * radius * towards;
      const auto seen = static_cast<double>(visible_points(points, eye).size());
      return seen >= kNearlyAll * static_cast<double>(points.cols());
    });
  }
};

}  // namespace

bool is_one_sided(const Eigen::Matrix3Xd& points) {
  const Cloud cloud(points);
  if (cloud.directions.empty()) return false;
  if (cloud.is_seen()) return true;
  const double rough = roughness(points, kNeighbours);
  if (rough <= kSmooth || rough >= kNoSurface) return false;
  if (roughness(points, 2 * kNeighbours) > kFalls * rough) return false;
  // Points that noise lifts hide those around them. Fewer points lie farther apart.
  const double share = std::pow(kSmooth / rough, 2);
  const int count =
      std::max(kLeastCount, static_cast<int>(share * static_cast<double>(points.cols())));
  const Eigen::Matrix3Xd fewer = points(Eigen::all, downsample_to(points, count));
  return Cloud(fewer).is_seen();
}

void doubt_if_one_sided(const Eigen::Matrix3Xd& points, Loops& result) {
  if (result.found.empty() || !is_one_sided(points)) return;
  for (Loop& loop : result.found) {
    loop.reason =
        "one camera could have seen all points, so it may be a rim, or the edge of what was seen; "
        "give rays or viewpoints of the cameras, or set all_sides if the points are of all sides";
    result.uncertain.push_back(std::move(loop));
  }
  result.found.clear();
  std::stable_sort(result.uncertain.begin(), result.uncertain.end(),
                   [](const Loop& a, const Loop& b) { return a.length < b.length; });
}

}  // namespace graspless::geometry
