// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Corners of a contact patch, with a tolerance for edges that a mesh file leaves not quite
// straight.
#include "mechanics/contacts/patch_corners.hpp"

#include <algorithm>
#include <numeric>

#include "geometry/segment.hpp"

namespace graspless::mechanics {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Rotates the points so that the first coordinate runs along the patch. The order along it is then
/// well defined even for a patch that is nearly a line.
Eigen::Matrix2Xd turned(const Eigen::Matrix2Xd& points) {
  const Eigen::Vector2d centre = points.rowwise().mean();
  Eigen::Index far = 0;
  const double reach = (points.colwise() - centre).colwise().norm().maxCoeff(&far);
  if (!(reach > 0)) return points;
  const Eigen::Vector2d u = (points.col(far) - centre) / reach;
  Eigen::Matrix2d R;
  R << u.x(), u.y(), -u.y(), u.x();
  return R * points;
}

/// One side of Andrew's monotone chain, without its last point.
void chain(const Eigen::Matrix2Xd& points, const std::vector<int>& order, std::vector<int>* hull) {
  const std::size_t first = hull->size();
  for (const int i : order) {
    while (hull->size() >= first + 2) {
      const Eigen::Vector2d a = points.col((*hull)[hull->size() - 2]);
      const Eigen::Vector2d b = points.col(hull->back());
      if (cross(b - a, points.col(i) - a) > 0) break;
      hull->pop_back();
    }
    hull->push_back(i);
  }
  hull->pop_back();
}

}  // namespace

std::vector<int> patch_corners(const Eigen::Matrix2Xd& raw, double tolerance) {
  if (raw.cols() == 0) return {};
  const Eigen::Matrix2Xd points = turned(raw);
  std::vector<int> order(points.cols());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) {
    if (points(0, i) != points(0, j)) return points(0, i) < points(0, j);
    return points(1, i) != points(1, j) ? points(1, i) < points(1, j) : i < j;
  });
  if (order.size() == 1) return order;
  std::vector<int> hull;
  chain(points, order, &hull);
  std::reverse(order.begin(), order.end());
  chain(points, order, &hull);

  for (std::size_t k = 0; k < hull.size() && hull.size() > 1;) {
    const std::size_t n = hull.size();
    const double off = geometry::distance_to_segment(
        points.col(hull[k]), points.col(hull[(k + n - 1) % n]), points.col(hull[(k + 1) % n]));
    if (off > tolerance) {
      ++k;
    } else {
      hull.erase(hull.begin() + k);
      k = 0;  // the neighbours of the erased point must be checked again
    }
  }
  std::sort(hull.begin(), hull.end());
  return hull;
}

}  // namespace graspless::mechanics
