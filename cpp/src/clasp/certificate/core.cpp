// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clasp/certificate/core.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <Eigen/Geometry>

#include "graspless/watch.hpp"

#include "geometry/complex/delaunay.hpp"

namespace graspless::clasp {
namespace {

using Eigen::Vector3d;
using Facet = geometry::Delaunay::Facet;

/// For each facet of the triangulation, true if it is a triangle of the surface.
std::vector<bool> closed_facets(const std::vector<Facet>& facets,
                                const geometry::Complex& complex) {
  std::vector<std::array<int, 3>> triangles;
  triangles.reserve(complex.triangles.cols());
  for (const auto& column : complex.triangles.colwise())
    triangles.push_back({column[0], column[1], column[2]});
  std::sort(triangles.begin(), triangles.end());
  std::vector<bool> closed;
  closed.reserve(facets.size());
  for (const Facet& facet : facets) {
    poll();
    closed.push_back(std::binary_search(triangles.begin(), triangles.end(), facet.vertices));
  }
  return closed;
}

/// Regions that can be reached from outside through facets that are not closed.
std::vector<bool> outside(const geometry::Delaunay& delaunay, const std::vector<bool>& closed) {
  std::vector<std::vector<int>> beyond(delaunay.num_regions);
  for (std::size_t i = 0; i < delaunay.facets.size(); ++i) {
    if (closed[i]) continue;
    const auto [a, b] = delaunay.facets[i].regions;
    beyond[a].push_back(b);
    beyond[b].push_back(a);
  }
  std::vector<bool> reached(beyond.size(), false);
  std::vector<int> open{0};
  reached[0] = true;
  while (!open.empty()) {
    poll();
    const auto at = static_cast<std::size_t>(open.back());
    open.pop_back();
    for (const int next : beyond[at]) {
      if (reached[next]) continue;
      reached[next] = true;
      open.push_back(next);
    }
  }
  return reached;
}

const Vector3d kRay(0.5377, 0.3191, 0.7804);  // along no axis of a model

/// Two directions across the ray, in rows.
Eigen::Matrix<double, 2, 3> across_ray() {
  Eigen::Matrix<double, 2, 3> directions;
  directions.row(0) = kRay.unitOrthogonal().transpose();
  directions.row(1) = kRay.normalized().cross(kRay.unitOrthogonal()).transpose();
  return directions;
}

Vector3d middle(const Facet& facet, const Eigen::Matrix3Xd& points) {
  return (points.col(facet.vertices[0]) + points.col(facet.vertices[1]) +
          points.col(facet.vertices[2])) /
         3;
}

}  // namespace

Core::Core(const geometry::Complex& complex) {
  const geometry::Delaunay delaunay = geometry::delaunay(complex.points);
  if (delaunay.dimension < 3) return;
  const std::vector<bool> is_out = outside(delaunay, closed_facets(delaunay.facets, complex));
  const auto in = [&](int region) { return !is_out[region]; };

  std::vector<int> node_of_region(is_out.size(), -1), corners(is_out.size(), 0);
  std::vector<Vector3d> nodes;
  const auto node_of = [&](int region) -> int& {
    int& node = node_of_region[region];
    if (node < 0) {
      node = static_cast<int>(nodes.size());
      nodes.push_back(Vector3d::Zero());
    }
    return node;
  };
  std::vector<Eigen::Vector3i> rim;
  for (const Facet& facet : delaunay.facets) {
    poll();
    const bool first = in(facet.regions[0]), second = in(facet.regions[1]);
    if (first != second) rim.emplace_back(facet.vertices.data());
    const Vector3d at = middle(facet, complex.points);
    // The mean of the middles of its four facets is the middle of a tetrahedron.
    if (first) nodes[node_of(facet.regions[0])] += at / 4;
    if (second) nodes[node_of(facet.regions[1])] += at / 4;
  }
  if (rim.empty()) return;
  boundary_.vertices = complex.points;
  boundary_.triangles.resize(3, static_cast<Eigen::Index>(rim.size()));
  for (std::size_t i = 0; i < rim.size(); ++i) boundary_.triangles.col(i) = rim[i];
  surface_ = std::make_unique<collision::ClearanceTree>(collision::surface_triangles(boundary_));
  cast_shadows();

  std::vector<Thin> clear;
  for (const Vector3d& p : nodes) {
    poll();
    clear.push_back(thin(p, clear.empty() ? 0 : clear.back().near));  // one beside the last
  }
  for (const Facet& facet : delaunay.facets) {
    poll();
    if (!in(facet.regions[0]) || !in(facet.regions[1])) continue;
    const Vector3d at = middle(facet, complex.points);
    const auto node = static_cast<int>(nodes.size());
    nodes.push_back(at);
    const Thin& beside = clear[node_of(facet.regions[0])];
    const double here = thin(at, beside.near).clear;
    for (const int region : facet.regions) {
      const int other = node_of(region);
      edges_.push_back({other, node, -std::min(here, clear[other].clear)});
    }
  }
  points_.resize(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t i = 0; i < nodes.size(); ++i) points_.col(i) = nodes[i];
}

/// Computes shadows_.
void Core::cast_shadows() {
  constexpr double kRound = 1e-9;  // [m]
  const Eigen::Matrix2Xd flat = across_ray() * boundary_.vertices;
  shadows_.resize(boundary_.triangles.cols(), 4);
  for (Eigen::Index i = 0; i < shadows_.rows(); ++i) {
    const Eigen::Matrix<double, 2, 3> corners = flat(Eigen::all, boundary_.triangles.col(i));
    const Eigen::Vector2d low = corners.rowwise().minCoeff(), high = corners.rowwise().maxCoeff();
    shadows_.row(i) << low[0] - kRound, high[0] + kRound, low[1] - kRound, high[1] + kRound;
  }
}

/// True if a ray from p leaves the material once more often than it enters it.
bool Core::contains(const Vector3d& p) const {
  const Vector3d ray = kRay;
  const Eigen::Vector2d at = across_ray() * p;
  bool inside = false;
  for (Eigen::Index i = 0; i < shadows_.rows(); ++i) {
    if (at[0] < shadows_(i, 0) || at[0] > shadows_(i, 1) || at[1] < shadows_(i, 2) ||
        at[1] > shadows_(i, 3))
      continue;
    const auto corners = boundary_.triangles.col(i);
    const Vector3d a = boundary_.vertices.col(corners[0]) - p,
                   b = boundary_.vertices.col(corners[1]) - p,
                   c = boundary_.vertices.col(corners[2]) - p;
    const double ab = ray.dot(a.cross(b)), bc = ray.dot(b.cross(c)), ca = ray.dot(c.cross(a));
    const bool ahead = ab >= 0 && bc >= 0 && ca >= 0, behind = ab < 0 && bc < 0 && ca < 0;
    if (!ahead && !behind) continue;
    const double volume = a.dot(b.cross(c));
    if ((volume >= 0) == ahead) inside = !inside;
  }
  return inside;
}

/// A point and its clearance.
Core::Thin Core::thin(const Vector3d& p, int hint) const {
  const collision::NearTriangle near = surface_->nearest(p, hint);
  return {p, std::sqrt(near.squared), near.triangle};
}

/// Lower bound on the least clearance along a side, and where that is; in the material if above 0.
/// Exact to 0.05 mm where it is below `enough`.
Core::Thin Core::thinnest(const Thin& a, const Thin& b, double enough) const {
  constexpr double kExact = 5e-5;
  const double bound = (a.clear + b.clear - (b.at - a.at).norm()) / 2;  // 1-Lipschitz
  const Thin& end = a.clear < b.clear ? a : b;
  if (bound >= enough || end.clear - bound <= kExact) return {end.at, bound, end.near};
  const Thin half = thin((a.at + b.at) / 2, a.near);
  const Thin first = thinnest(a, half, enough);
  const Thin second = thinnest(half, b, std::min(enough, first.clear));
  return first.clear <= second.clear ? first : second;
}

/// Moves a point across a direction to where the clearance is larger. It stays in the material, as
/// no step is longer than the clearance.
Core::Thin Core::centered(Thin point, Vector3d along) const {
  constexpr int kRounds = 4, kDirections = 6;
  if (!(along.norm() > 0)) return point;
  along.normalize();
  const Vector3d x = along.unitOrthogonal(), y = along.cross(x);
  for (int round = 0; round < kRounds; ++round) {
    const double step = point.clear / (2 << round);
    const Vector3d from = point.at;
    for (int k = 0; k < kDirections; ++k) {
      const double angle = 2 * M_PI * k / kDirections;
      const Vector3d p = from + step * (std::cos(angle) * x + std::sin(angle) * y);
      const double passed = point.clear * point.clear;  // less does not help
      const collision::NearTriangle near = surface_->nearest(p, point.near, passed);
      const double here = std::sqrt(near.squared);
      if (here > point.clear) point = {p, here, near.triangle};
    }
  }
  return point;
}

/// Moves a loop towards the middle of the material where that is thin.
void Core::center(std::vector<Thin>& loop) const {
  constexpr int kRounds = 8, kReach = 2;
  constexpr double kThin = 2;  // where the clearance is above this multiple of the least, it stays
  for (int round = 0; round < kRounds; ++round) {
    double least = std::numeric_limits<double>::infinity();
    for (const Thin& corner : loop) least = std::min(least, corner.clear);
    loop = resampled(loop, least);
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
      poll();
      if (loop[i].clear > kThin * least) continue;
      loop[i] = centered(loop[i], loop[(i + kReach) % n].at - loop[(i + n - kReach) % n].at);
    }
  }
}

/// Corners at equal distances along the loop, about `spacing` [m].
std::vector<Core::Thin> Core::resampled(const std::vector<Thin>& loop, double spacing) const {
  constexpr double kMost = 500;
  const auto next = [&](std::size_t i) { return loop[(i + 1) % loop.size()].at; };
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) length += (next(i) - loop[i].at).norm();
  const double count = std::clamp(std::ceil(length / spacing), 12.0, kMost), step = length / count;
  std::vector<Thin> result;
  double from = 0;  // length up to the side
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double side = (next(i) - loop[i].at).norm();
    while (static_cast<double>(result.size()) < count &&
           static_cast<double>(result.size()) * step <= from + side) {
      const double t = side > 0 ? (static_cast<double>(result.size()) * step - from) / side : 0;
      const Vector3d p = loop[i].at + t * (next(i) - loop[i].at);
      result.push_back(thin(p, loop[i].near));
    }
    from += side;
  }
  return result;
}

/// Adds corners where a loop is thinnest, as long as that makes it thicker. Returns its radius.
double Core::thicken(std::vector<Thin>& loop) const {
  constexpr int kMost = 200;
  constexpr double kGain = 5e-5;               // [m]
  std::vector<double> bounds(loop.size(), 0);  // on the clearance along each side
  for (int round = 0;; ++round) {
    poll();
    Thin worst{{}, std::numeric_limits<double>::infinity()};
    std::size_t side = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (bounds[i] >= worst.clear) continue;
      const Thin here = thinnest(loop[i], loop[(i + 1) % loop.size()], worst.clear);
      bounds[i] = here.clear;
      if (here.clear >= worst.clear) continue;
      worst = here;
      side = i;
    }
    const Vector3d along = loop[(side + 1) % loop.size()].at - loop[side].at;
    const Thin moved = centered(thin(worst.at, worst.near), along);
    if (round == kMost || moved.clear < worst.clear + kGain) return worst.clear;
    const auto after = static_cast<std::ptrdiff_t>(side) + 1;
    loop.insert(loop.begin() + after, moved);
    bounds[side] = 0;
    bounds.insert(bounds.begin() + after, 0);
  }
}

CoreLoop Core::loop(const Eigen::Matrix3Xd& curve) const {
  CoreLoop result;
  if (!surface_) return result;
  const std::vector<int> cycle = tightest_cycle(points_, edges_, curve);
  if (cycle.empty()) return result;
  std::vector<Thin> loop;
  for (const int node : cycle) loop.push_back(thin(points_.col(node), 0));
  center(loop);
  // The clearance does not tell inside from outside: one corner does, for all.
  if (contains(loop[0].at)) result.radius = std::max(0.0, thicken(loop));
  result.points.resize(3, static_cast<Eigen::Index>(loop.size()));
  for (std::size_t i = 0; i < loop.size(); ++i) result.points.col(i) = loop[i].at;
  return result;
}

}  // namespace graspless::clasp
