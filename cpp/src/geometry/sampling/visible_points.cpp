// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Hidden point removal (Katz, Tal, Basri 2007).
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Extreme_points_traits_adapter_3.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/property_map.h>

#include "graspless/geometry/sampling.hpp"
#include "graspless/watch.hpp"

#include "geometry/require_points.hpp"

namespace graspless::geometry {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// Radius of the sphere relative to the distance of the farthest point. With a larger one, points
// behind gaps of the cloud count as visible. With a smaller one, slanted surfaces are lost.
constexpr double kRadiusRatio = 100;

/// Points by their indices; polls where CGAL's loops look at them.
struct PollingPoints {
  using key_type = int;
  using value_type = Kernel::Point_3;
  using reference = const value_type&;
  using category = boost::lvalue_property_map_tag;

  const std::vector<value_type>* points;

  friend reference get(const PollingPoints& map, int index) {
    poll();
    return (*map.points)[index];
  }
};

}  // namespace

std::vector<int> visible_points(const Eigen::Matrix3Xd& points, const Eigen::Vector3d& viewpoint) {
  require_points(points, "points");
  require_points(viewpoint, "viewpoint");
  const Eigen::Matrix3Xd from_view = points.colwise() - viewpoint;
  if (points.cols() == 0) return {};
  const Eigen::VectorXd distance = from_view.colwise().norm();
  if (!(distance.minCoeff() > 0)) {
    throw std::invalid_argument("viewpoint must not be one of the points");
  }
  // Each point is flipped along its ray to beyond the sphere. The visible points are the vertices
  // of the convex hull of the flipped points and the viewpoint.
  const double radius = kRadiusRatio * distance.maxCoeff();
  std::vector<Kernel::Point_3> flipped;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d p = from_view.col(i) * (2 * radius / distance[i] - 1);
    flipped.emplace_back(p.x(), p.y(), p.z());
  }
  const int n = static_cast<int>(points.cols());
  flipped.emplace_back(0, 0, 0);
  std::vector<int> indices(flipped.size());
  std::iota(indices.begin(), indices.end(), 0);
  std::vector<int> visible;
  CGAL::extreme_points_3(indices, std::back_inserter(visible),
                         CGAL::make_extreme_points_traits_adapter(PollingPoints{&flipped}));
  visible.erase(std::remove(visible.begin(), visible.end(), n), visible.end());
  std::sort(visible.begin(), visible.end());
  return visible;
}

}  // namespace graspless::geometry
