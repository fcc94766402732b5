// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Linking number of two closed polylines. The triangles from an apex to the segments of one curve
// form a surface bounded by that curve. The number is the sum of the signed crossings of the other
// curve through this surface.
#include <cmath>

#include "geometry/linking/strip.hpp"

namespace graspless::geometry::kernels {
namespace {

/// Bound on the relative rounding error of a determinant.
constexpr double kRounding = 1e-14;

/// The strip relative to the apex: its corners d, and the moments d x v of its segments v.
struct Moments {
  double x[kStrip + 1], y[kStrip + 1], z[kStrip + 1];
  double mx[kStrip], my[kStrip], mz[kStrip];
};

/// An edge of the fan, from the apex to a corner e of the curve.
struct Spoke {
  double e[3], length;
  double volume[kStrip];  // determinant with every segment of the strip
};

struct Count {
  double crossings[kLanes], doubts[kLanes];
};

GRASPLESS_INLINE void compute_moments(const Strip& strip, const double* apex, Moments& m) {
  for (int j = 0; j <= strip.count; ++j) {
    m.x[j] = strip.x[j] - apex[0];
    m.y[j] = strip.y[j] - apex[1];
    m.z[j] = strip.z[j] - apex[2];
  }
  for (int j = 0; j < strip.count; ++j) {
    m.mx[j] = m.y[j] * strip.dz[j] - m.z[j] * strip.dy[j];
    m.my[j] = m.z[j] * strip.dx[j] - m.x[j] * strip.dz[j];
    m.mz[j] = m.x[j] * strip.dy[j] - m.y[j] * strip.dx[j];
  }
}

GRASPLESS_INLINE void compute_spoke(const Strip& strip, const Moments& m, const double* corner,
                                    double scale, const double* apex, Spoke& spoke) {
  double e[3];
  for (int k = 0; k < 3; ++k) spoke.e[k] = e[k] = corner[k] * scale - apex[k];
  spoke.length = __builtin_sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
  for (int j = 0; j < strip.count; ++j) {
    spoke.volume[j] = m.mx[j] * e[0] + m.my[j] * e[1] + m.mz[j] * e[2];
  }
}

/// Counts crossings through the triangle between spokes A and B. A segment that changes sides of
/// the triangle's plane crosses the triangle if its determinants with the three sides have the same
/// sign. The three add up to the segment's change of height, which gives the third.
GRASPLESS_INLINE void count_triangle(const Strip& strip, const Moments& m, const Spoke& A,
                                     const Spoke& B, Count& count) {
  const double nx = A.e[1] * B.e[2] - A.e[2] * B.e[1], ny = A.e[2] * B.e[0] - A.e[0] * B.e[2],
               nz = A.e[0] * B.e[1] - A.e[1] * B.e[0];
  const double area = A.length * B.length;
  if (nx * nx + ny * ny + nz * nz <= 1e-30 * area * area) return;  // degenerate triangle
  double height[kStrip + 1];
  for (int j = 0; j <= strip.count; ++j) height[j] = nx * m.x[j] + ny * m.y[j] + nz * m.z[j];
  const double flat = kRounding * area, near = kRounding * (A.length + B.length);
  for (int block = 0; block < strip.count; block += kLanes) {
    for (int l = 0; l < kLanes; ++l) {
      const int j = block + l;
      const double h0 = height[j], h1 = height[j + 1], a = A.volume[j], b = B.volume[j];
      const double rim = h1 - h0 + b - a;
      const bool rises = (h0 < 0) & (h1 >= 0), falls = (h0 >= 0) & (h1 < 0);
      const double up = rises & (a >= 0) & (b < 0) & (rim >= 0) ? 1 : 0;
      const double down = falls & (a < 0) & (b >= 0) & (rim < 0) ? 1 : 0;
      const double nearest = std::min(std::min(std::abs(a), std::abs(b)), std::abs(rim));
      const bool grazes = (rises | falls) & (nearest <= near * strip.length[j]);
      const double doubt = grazes | (std::abs(h0) <= flat) ? 1 : 0;
      count.crossings[l] += up - down;
      count.doubts[l] += doubt;
    }
  }
}

GRASPLESS_SIMD void count_strip(const Strip& strip, const Curve& curve, double scale,
                                const double* apex, Moments& m, Spoke* spokes, Count& count) {
  compute_moments(strip, apex, m);
  compute_spoke(strip, m, curve.corners.data(), scale, apex, spokes[0]);
  for (int i = 0; i < curve.segments; ++i) {
    const Eigen::Index next = i + 1 < curve.corners.cols() ? i + 1 : 0;
    const double* corner = curve.corners.data() + 3 * next;
    compute_spoke(strip, m, corner, scale, apex, spokes[(i + 1) % 2]);
    count_triangle(strip, m, spokes[i % 2], spokes[(i + 1) % 2], count);
  }
}

}  // namespace

int signed_crossings(const Line& line, const Curve& curve, double scale,
                     const Eigen::Vector3d& apex, bool& is_certain) {
  Strip strip;
  Moments moments;
  Spoke spokes[2];
  Count count = {};
  for (int begin = 0; begin < line.segments; begin += kStrip) {
    load_strip(line, begin, scale, strip);
    count_strip(strip, curve, scale, apex.data(), moments, spokes, count);
  }
  double crossings = 0, doubts = 0;
  for (int l = 0; l < kLanes; ++l) {
    crossings += count.crossings[l];
    doubts += count.doubts[l];
  }
  is_certain = doubts == 0;
  return static_cast<int>(std::lround(crossings));
}

}  // namespace graspless::geometry::kernels
