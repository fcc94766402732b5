// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/linking/kernels.hpp"
#include "geometry/simd.hpp"

namespace graspless::geometry::kernels {

constexpr int kLanes = 8;    // doubles processed in parallel
constexpr int kStrip = 128;  // largest number of segments in a strip

/// Consecutive segments of a line, scaled, and padded to full lanes with segments of length 0.
struct Strip {
  int count;  // segments, a multiple of kLanes
  double x[kStrip + 1], y[kStrip + 1], z[kStrip + 1];
  double dx[kStrip], dy[kStrip], dz[kStrip], length[kStrip];
};

GRASPLESS_INLINE void load_strip(const Line& line, int begin, double scale, Strip& strip) {
  const int given = std::min(kStrip, line.segments - begin);
  strip.count = (given + kLanes - 1) / kLanes * kLanes;
  for (int j = 0; j <= given; ++j) {
    strip.x[j] = line.x[begin + j] * scale;
    strip.y[j] = line.y[begin + j] * scale;
    strip.z[j] = line.z[begin + j] * scale;
  }
  for (int j = given + 1; j <= strip.count; ++j) {
    strip.x[j] = strip.x[given];
    strip.y[j] = strip.y[given];
    strip.z[j] = strip.z[given];
  }
  for (int j = 0; j < strip.count; ++j) {
    const double x = strip.x[j + 1] - strip.x[j];
    const double y = strip.y[j + 1] - strip.y[j];
    const double z = strip.z[j + 1] - strip.z[j];
    strip.dx[j] = x;
    strip.dy[j] = y;
    strip.dz[j] = z;
    strip.length[j] = __builtin_sqrt(x * x + y * y + z * z);
  }
}

}  // namespace graspless::geometry::kernels
