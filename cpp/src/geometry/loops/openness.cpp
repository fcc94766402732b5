// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/loops/openness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>

#include "graspless/watch.hpp"

#include "geometry/directions.hpp"

namespace graspless::geometry {
namespace {

constexpr std::size_t kRays = 256;
/// Largest distance of a corner of a triangle from its mean, relative to its longest edge: two
/// thirds of a median, which is shorter than the edge.
constexpr double kSize = 2. / 3;

using Rays = std::array<Eigen::Vector3d, kRays>;

Rays make_rays() {
  Rays rays;
  for (std::size_t i = 0; i < kRays; ++i)
    rays[i] = spread_direction(static_cast<int>(i), static_cast<int>(kRays));
  return rays;
}

/// A set of rays, as bits.
using RaySet = std::array<std::uint64_t, kRays / 64>;

/// The rays that may hit a triangle, by the place of one corner: a cube of cells about the origin,
/// with one set for each ratio of the triangle's size to its distance.
class RayTable {
 public:
  explicit RayTable(const Rays& rays) {
    all_.fill(~std::uint64_t{0});
    for (int side = 0; side < 6; ++side) {
      for (int v = 0; v < kCells; ++v) {
        for (int u = 0; u < kCells; ++u) fill(rays, side, u, v);
      }
    }
  }

  /// `size` [m]: no point of the triangle is farther than this from its mean, nor is the corner.
  const RaySet& near(const Eigen::Vector3d& corner, double size) const {
    const double distance = corner.norm();
    for (std::size_t i = 0; i < kRatios.size(); ++i) {
      if (size <= kRatios[i] * distance) return sets_[cell_of(corner)][i];
    }
    return all_;
  }

 private:
  static constexpr int kCells = 16;  // along a side
  static constexpr std::array<double, 5> kRatios{1. / 32, 1. / 16, 1. / 8, 1. / 4, 1. / 3};
  static constexpr double kRounding = 1e-6;

  static std::size_t index(int side, int u, int v) {
    return static_cast<std::size_t>((side * kCells + v) * kCells + u);
  }

  static std::size_t cell_of(const Eigen::Vector3d& p) {
    Eigen::Index axis = 0;
    const double height = p.cwiseAbs().maxCoeff(&axis);
    const auto place = [&](Eigen::Index i) {
      return std::min(kCells - 1, static_cast<int>((p[i % 3] / height + 1) * (kCells / 2)));
    };
    const int side = 2 * static_cast<int>(axis) + (p[axis] > 0 ? 1 : 0);
    return index(side, place(axis + 1), place(axis + 2));
  }

  static Eigen::Vector3d direction(int side, double u, double v) {
    const int axis = side / 2;
    Eigen::Vector3d p;
    p[axis] = side % 2 == 1 ? 1 : -1;
    p[(axis + 1) % 3] = 2 * u / kCells - 1;
    p[(axis + 2) % 3] = 2 * v / kCells - 1;
    return p.normalized();
  }

  /// A triangle lies in a cone about its mean, and the corner is seen from the mean at no more than
  /// the size. With the ratio q, the rays are within asin(q) + asin(q / (1 - q)) of the corner.
  void fill(const Rays& rays, int side, int u, int v) {
    const Eigen::Vector3d middle = direction(side, u + 0.5, v + 0.5);
    double least = 1;  // cosine within the cell
    for (const int i : {0, 1}) {
      for (const int k : {0, 1}) least = std::min(least, middle.dot(direction(side, u + i, v + k)));
    }
    std::array<double, kRatios.size()> cosines{};
    for (std::size_t i = 0; i < kRatios.size(); ++i) {
      const double q = kRatios[i], cone = std::asin(q) + std::asin(q / (1 - q));
      cosines[i] = std::cos(std::acos(least) + cone + kRounding);
    }
    std::array<RaySet, kRatios.size()>& sets = sets_[index(side, u, v)];
    for (std::size_t r = 0; r < kRays; ++r) {
      const double along = middle.dot(rays[r]);
      for (std::size_t i = 0; i < kRatios.size(); ++i) {
        if (along >= cosines[i]) sets[i][r / 64] |= std::uint64_t{1} << (r % 64);
      }
    }
  }

  RaySet all_{};
  std::array<std::array<RaySet, kRatios.size()>, 6 * kCells * kCells> sets_{};
};

/// True if a ray from the origin hits a triangle (Moeller, Trumbore 1997).
bool hits(const Eigen::Vector3d& ray, const Eigen::Vector3d& a, const Eigen::Vector3d& ab,
          const Eigen::Vector3d& ac) {
  const Eigen::Vector3d normal = ray.cross(ac);
  const double det = ab.dot(normal);
  if (det == 0) return false;
  const double u = -a.dot(normal) / det;
  if (u < 0 || u > 1) return false;
  const Eigen::Vector3d q = ab.cross(a);
  const double v = ray.dot(q) / det;
  return v >= 0 && u + v <= 1 && ac.dot(q) / det > 0;
}

/// Removes the rays that hit a triangle.
void block(const Rays& rays, const RaySet& near, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
           const Eigen::Vector3d& c, RaySet& open) {
  // A cone about the triangle decides which rays are tested.
  const Eigen::Vector3d mean = (a + b + c) / 3;
  const double distance = mean.norm();
  const double radius = std::sqrt(
      std::max({(a - mean).squaredNorm(), (b - mean).squaredNorm(), (c - mean).squaredNorm()}));
  double least = -1;  // cosine
  if (radius < distance) least = std::sqrt(1 - radius * radius / (distance * distance));
  const Eigen::Vector3d middle = mean / distance;
  for (std::size_t w = 0; w < open.size(); ++w) {
    for (std::uint64_t left = near[w] & open[w]; left != 0; left &= left - 1) {
      const auto bit = static_cast<std::size_t>(__builtin_ctzll(left));
      const Eigen::Vector3d& ray = rays[64 * w + bit];
      const double along = ray[0] * middle[0] + ray[1] * middle[1] + ray[2] * middle[2];
      if (along < least) continue;
      if (hits(ray, a, b - a, c - a)) open[w] &= ~(std::uint64_t{1} << bit);
    }
  }
}

/// The rays from the origin that no triangle blocks.
RaySet open_rays(const Rays& rays, const Eigen::Matrix3Xd& points, const Complex& complex) {
  static const RayTable table(rays);
  RaySet open, near{};
  open.fill(~std::uint64_t{0});
  int corner = -1;
  bool is_near = false;
  for (Eigen::Index t = 0; t < complex.triangles.cols(); ++t) {
    if (t % 1024 == 0) poll();
    const auto corners = complex.triangles.col(t);
    if (corners[0] != corner) {  // triangles with the same first corner follow each other
      corner = corners[0];
      near = table.near(points.col(corner), kSize * complex.max_edge_length);
      is_near = false;
      for (std::size_t w = 0; w < near.size(); ++w) is_near |= (near[w] &= open[w]) != 0;
    }
    if (!is_near) continue;
    block(rays, near, points.col(corner), points.col(corners[1]), points.col(corners[2]), open);
  }
  return open;
}

}  // namespace

Openness openness(const Complex& complex, const Eigen::Vector3d& middle,
                  const Eigen::Vector3d& normal) {
  static const Rays rays = make_rays();
  const RaySet set = open_rays(rays, complex.points.colwise() - middle, complex);
  std::array<int, 2> open{}, all{};
  for (std::size_t i = 0; i < kRays; ++i) {
    const std::size_t side = rays[i].dot(normal) > 0 ? 0 : 1;
    ++all[side];
    open[side] += static_cast<int>((set[i / 64] >> (i % 64)) & 1);
  }
  return {static_cast<double>(open[0]) / std::max(1, all[0]),
          static_cast<double>(open[1]) / std::max(1, all[1])};
}

}  // namespace graspless::geometry
