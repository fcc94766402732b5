// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Gauss linking integral of two polylines. A pair of segments contributes the solid angle of the
// parallelogram of differences b - a. Each of its two triangles contributes twice the argument of a
// complex number (van Oosterom, Strackee 1983). The product of the two numbers has an argument in
// (-pi, pi). So the numbers of all pairs are multiplied, and crossings of the negative real axis
// are counted. This takes one arctangent per lane instead of one per pair.
#include <cmath>
#include <cstdint>
#include <cstring>

#include "geometry/linking/strip.hpp"

namespace graspless::geometry::kernels {
namespace {

/// Determinants below this multiple of length times length count as rounding errors: the segments
/// are coplanar or touch. Coordinates are at most 1.
constexpr double kFlat = 1e-15;

/// Vectors from a corner of the curve to every corner of the strip.
struct Row {
  double x[kStrip + 1], y[kStrip + 1], z[kStrip + 1], norm[kStrip + 1];
  double along[kStrip];  // dot products of consecutive vectors
};

/// A complex number per lane, and how often its argument passed pi minus how often it passed -pi.
struct Turns {
  double re[kLanes], im[kLanes], turns[kLanes];
};

GRASPLESS_INLINE void compute_row(const Strip& strip, const double* from, Row& row) {
  for (int j = 0; j <= strip.count; ++j) {
    const double x = strip.x[j] - from[0], y = strip.y[j] - from[1], z = strip.z[j] - from[2];
    row.x[j] = x;
    row.y[j] = y;
    row.z[j] = z;
    row.norm[j] = __builtin_sqrt(x * x + y * y + z * z);
  }
  for (int j = 0; j < strip.count; ++j) {
    row.along[j] = row.x[j] * row.x[j + 1] + row.y[j] * row.y[j + 1] + row.z[j] * row.z[j + 1];
  }
}

/// Complex numbers of segment u = B - A of the curve with every segment of the strip.
GRASPLESS_INLINE void factors(const Strip& strip, const Row& A, const Row& B, const double* u,
                              double flat, double* re, double* im) {
  for (int j = 0; j < strip.count; ++j) {
    const double vx = strip.dx[j], vy = strip.dy[j], vz = strip.dz[j];
    const double volume = A.x[j] * (u[2] * vy - u[1] * vz) + A.y[j] * (u[0] * vz - u[2] * vx) +
                          A.z[j] * (u[1] * vx - u[0] * vy);
    const double here = A.x[j] * B.x[j] + A.y[j] * B.y[j] + A.z[j] * B.z[j];
    const double there =
        A.x[j + 1] * B.x[j + 1] + A.y[j + 1] * B.y[j + 1] + A.z[j + 1] * B.z[j + 1];
    const double diagonal = A.x[j] * B.x[j + 1] + A.y[j] * B.y[j + 1] + A.z[j] * B.z[j + 1];
    const double crosswise = A.x[j + 1] * B.x[j] + A.y[j + 1] * B.y[j] + A.z[j + 1] * B.z[j];
    const double a = A.norm[j], a1 = A.norm[j + 1], b = B.norm[j], b1 = B.norm[j + 1];
    // Splits the parallelogram along the diagonal farther from the origin, for accuracy.
    const bool by_diagonal = a * b1 + diagonal >= a1 * b + crosswise;
    const double first = a * (a1 * b1 + there) + A.along[j] * b1 + diagonal * a1;
    const double second = a * (b1 * b + B.along[j]) + diagonal * b + here * b1;
    const double third = a * (a1 * b + crosswise) + A.along[j] * b + here * a1;
    const double fourth = b * (a1 * b1 + there) + B.along[j] * a1 + crosswise * b1;
    const double product = by_diagonal ? first * second : third * fourth;
    const double sum = by_diagonal ? first + second : third + fourth;
    const double real = product - volume * volume, imaginary = volume * sum;
    const bool is_flat = __builtin_fabs(volume) <= flat * strip.length[j];
    const bool is_lost = __builtin_fabs(real) + __builtin_fabs(imaginary) < 1e-280;
    re[j] = is_flat | is_lost ? 1 : real;
    im[j] = is_flat | is_lost ? 0 : imaginary;
  }
}

/// 2^-e for a positive normal number with exponent e.
GRASPLESS_INLINE double inverse_power(double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  bits = 0x7fe0000000000000u - (bits & 0x7ff0000000000000u);
  std::memcpy(&value, &bits, sizeof bits);
  return value;
}

GRASPLESS_INLINE void multiply(const double* re, const double* im, int count, Turns& product) {
  Turns p = product;
  for (int block = 0; block < count; block += kLanes) {
    for (int l = 0; l < kLanes; ++l) {
      const double x = re[block + l], y = im[block + l];
      const double real = p.re[l] * x - p.im[l] * y, imaginary = p.re[l] * y + p.im[l] * x;
      const double up = p.im[l] >= 0 && y >= 0 && imaginary < 0 ? 1 : 0;
      const double down = p.im[l] < 0 && y < 0 && imaginary >= 0 ? 1 : 0;
      const double scale = inverse_power(__builtin_fabs(real) + __builtin_fabs(imaginary));
      p.turns[l] += up - down;
      p.re[l] = real * scale;
      p.im[l] = imaginary * scale;
    }
  }
  product = p;
}

GRASPLESS_SIMD void add_strip(const Strip& strip, const Curve& curve, double scale, Row* rows,
                              Turns& product) {
  double re[kStrip], im[kStrip];
  double from[3], to[3], u[3];
  for (int k = 0; k < 3; ++k) from[k] = curve.corners(k, 0) * scale;
  compute_row(strip, from, rows[0]);
  for (int i = 0; i < curve.segments; ++i) {
    const Eigen::Index next = i + 1 < curve.corners.cols() ? i + 1 : 0;
    for (int k = 0; k < 3; ++k) to[k] = curve.corners(k, next) * scale;
    for (int k = 0; k < 3; ++k) u[k] = to[k] - from[k];
    compute_row(strip, to, rows[(i + 1) % 2]);
    const double length = __builtin_sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    factors(strip, rows[i % 2], rows[(i + 1) % 2], u, kFlat * length, re, im);
    multiply(re, im, strip.count, product);
    for (int k = 0; k < 3; ++k) from[k] = to[k];
  }
}

}  // namespace

double gauss_integral(const Line& line, const Curve& curve, double scale) {
  Strip strip;
  Row rows[2];
  Turns product;
  for (int l = 0; l < kLanes; ++l) {
    product.re[l] = 1;
    product.im[l] = product.turns[l] = 0;
  }
  for (int begin = 0; begin < line.segments; begin += kStrip) {
    load_strip(line, begin, scale, strip);
    add_strip(strip, curve, scale, rows, product);
  }
  double sum = 0;
  for (int l = 0; l < kLanes; ++l) {
    sum += std::atan2(product.im[l], product.re[l]) / (2 * M_PI) + product.turns[l];
  }
  return sum;
}

}  // namespace graspless::geometry::kernels
