// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "perception/sight.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "graspless/watch.hpp"

#include "geometry/quantile.hpp"

namespace graspless::perception {
namespace {

constexpr double kSteepest = 4;  // tangent of the angle between ray and normal on one surface
constexpr int kSide = 16;        // pixels along a cell
constexpr double kFilled = 0.6;  // least share of a cell's pixels that have a depth
constexpr double kRoughest = 4;  // times the expected deviation
constexpr double kStepSigmas = 4.5;

/// Copies the pixels in the rows and columns k stride, with 0 for what is not a depth.
DepthImage thinned(const DepthImage& depth, int stride) {
  DepthImage result((depth.rows() + stride - 1) / stride, (depth.cols() + stride - 1) / stride);
  for (Eigen::Index v = 0; v < result.rows(); ++v) {
    poll();
    for (Eigen::Index u = 0; u < result.cols(); ++u) {
      const float z = depth(v * stride, u * stride);
      result(v, u) = z > 0 && z < 1e30f ? z : 0;  // false of NaN
    }
  }
  return result;
}

/// Clears depths that no camera measures, such as those of a renderer's background. An image of
/// such depths alone is in another unit than metres, and stays as it is.
void clear_background(DepthImage& depth) {
  constexpr float kFarthest = 50;      // [m]
  constexpr double kLeastNear = 0.02;  // share of the pixels
  const auto is_far = (depth > kFarthest).eval();
  const auto near = static_cast<double>((depth > 0).count() - is_far.count());
  if (near < kLeastNear * static_cast<double>(depth.size())) return;
  depth = is_far.select(0, depth);
}

void measure(Sight& sight) {
  constexpr Eigen::Index kEvery = 7;  // pixels are enough for the median
  std::vector<float> some;
  for (Eigen::Index i = 0; i < sight.depth.size(); i += kEvery) {
    if (sight.depth.data()[i] > 0) some.push_back(sight.depth.data()[i]);
  }
  const auto count = static_cast<double>((sight.depth > 0).count());
  sight.share = count / static_cast<double>(sight.depth.size());
  sight.median = 0;
  if (some.empty()) return;
  sight.median = geometry::median(some);
}

/// Step between the depths that an image can express; 0 if the depths are not multiples of one.
/// Second differences along rows are multiples of it, too, and those of a plane are nearly 0.
double step_of(const DepthImage& depth) {
  constexpr double kLeast = 2e-5;            // [m]
  constexpr double kSmallest = 0.05;         // quantile of the differences
  constexpr double kOff = 0.1, kMost = 0.9;  // of multiples, and their share
  constexpr Eigen::Index kEvery = 16;        // rows
  std::vector<double> differences;
  for (Eigen::Index v = 0; v < depth.rows(); v += kEvery) {
    const float* z = depth.row(v).data();
    for (Eigen::Index u = 1; u + 1 < depth.cols(); ++u) {
      if (!(z[u - 1] > 0 && z[u] > 0 && z[u + 1] > 0)) continue;
      const double bend = std::abs(static_cast<double>(z[u - 1]) - 2.0 * static_cast<double>(z[u]) +
                                   static_cast<double>(z[u + 1]));
      if (bend > kLeast) differences.push_back(bend);
    }
  }
  if (differences.empty()) return 0;
  const auto at = static_cast<std::ptrdiff_t>(kSmallest * static_cast<double>(differences.size()));
  std::nth_element(differences.begin(), differences.begin() + at, differences.end());
  const double step = differences[at];
  const auto multiples = std::count_if(differences.begin(), differences.end(), [&](double bend) {
    return std::abs(bend / step - std::round(bend / step)) < kOff;
  });
  return static_cast<double>(multiples) > kMost * static_cast<double>(differences.size()) ? step
                                                                                          : 0;
}

void remove_flying_pixels(Sight& sight, const NoiseModel& noise) {
  const DepthImage given = sight.depth;
  const auto constant = static_cast<float>(largest_step(sight, noise, 0));
  const auto linear = static_cast<float>(kSteepest / sight.K(0, 0));
  const auto quadratic =
      static_cast<float>(largest_step(sight, noise, 1) - constant - static_cast<double>(linear));
  const Eigen::Index width = given.cols();
  for (Eigen::Index v = 0; v < given.rows(); ++v) {
    poll();
    const float* row = given.row(v).data();
    const float* above = given.row(std::max<Eigen::Index>(v - 1, 0)).data();
    const float* below = given.row(std::min(v + 1, given.rows() - 1)).data();
    float* result = sight.depth.row(v).data();
    for (Eigen::Index u = 0; u < width; ++u) {
      const float z = row[u];
      const float step = constant + z * (linear + z * quadratic);
      const float left = row[u > 0 ? u - 1 : 0], right = row[u + 1 < width ? u + 1 : u];
      const int alike = (std::abs(left - z) < step) + (std::abs(right - z) < step) +
                        (std::abs(above[u] - z) < step) + (std::abs(below[u] - z) < step);
      result[u] = alike >= 2 ? z : 0;
    }
  }
}

/// Sums over the pixels of a cell, with u and v from its corner, for the fit of 1 / z.
struct Moments {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double squares = 0;
  int count = 0;
};

Moments moments_of(const DepthImage& depth, int row, int column) {
  double n = 0, su = 0, sv = 0, suu = 0, suv = 0, svv = 0, sw = 0, suw = 0, svw = 0, sww = 0;
  for (int v = 0; v < kSide; ++v) {
    const float* z = depth.row(row + v).data() + column;
    double rn = 0, ru = 0, ruu = 0, rw = 0, ruw = 0, rww = 0;
    for (int u = 0; u < kSide; ++u) {
      if (!(z[u] > 0)) continue;
      const double w = 1.0 / static_cast<double>(z[u]);
      rn += 1;
      ru += u;
      ruu += u * u;
      rw += w;
      ruw += u * w;
      rww += w * w;
    }
    n += rn;
    su += ru;
    sv += v * rn;
    suu += ruu;
    suv += v * ru;
    svv += v * v * rn;
    sw += rw;
    suw += ruw;
    svw += v * rw;
    sww += rww;
  }
  Moments result;
  result.A << suu, suv, su, suv, svv, sv, su, sv, n;
  result.b << suw, svw, sw;
  result.squares = sww;
  result.count = static_cast<int>(n);
  return result;
}

}  // namespace

double largest_step(const Sight& sight, const NoiseModel& noise, double z) {
  return kStepSigmas * std::sqrt(2.0) * noise(z) + kSteepest * z / sight.K(0, 0);
}

Sight prepare(const View& view, const NoiseModel& noise, std::int64_t max_pixels) {
  Sight sight;
  sight.stride = 1;
  const auto pixels = static_cast<double>(view.depth.size());
  while (pixels / sight.stride / sight.stride > static_cast<double>(max_pixels)) ++sight.stride;
  sight.depth = thinned(view.depth, sight.stride);
  clear_background(sight.depth);
  sight.K = view.K;
  sight.K.topRows<2>() /= sight.stride;
  sight.X_WC = view.X_WC;
  measure(sight);
  sight.step = step_of(sight.depth);
  remove_flying_pixels(sight, noise);
  return sight;
}

std::vector<Cell> planar_cells(const Sight& sight, int view, const NoiseModel& noise) {
  std::vector<Cell> cells;
  const Eigen::Matrix3d K_inverse = sight.K.inverse();
  for (int row = 0; row + kSide <= sight.height(); row += kSide) {
    poll();
    for (int column = 0; column + kSide <= sight.width(); column += kSide) {
      const Moments m = moments_of(sight.depth, row, column);
      if (m.count < kFilled * kSide * kSide) continue;
      const Eigen::Vector3d plane = m.A.ldlt().solve(m.b);  // of the local u, v
      const double mean_w = m.b.z() / m.count, z = 1 / mean_w;
      const double variance = std::max(0.0, m.squares - plane.dot(m.b)) / (m.count - 3);
      const double roughness = std::sqrt(variance) * z * z / noise(z);
      if (!(roughness < kRoughest)) continue;
      // N p = 1 for points p in C: p = z K^-1 (u, v, 1).
      const Eigen::Vector3d of_pixels(plane.x(), plane.y(),
                                      plane.z() - plane.x() * column - plane.y() * row);
      const Eigen::Vector3d N = sight.K.transpose() * of_pixels;
      const Eigen::Vector3d n_C = -N.normalized();
      const Eigen::Vector3d center(column + m.A(0, 2) / m.count, row + m.A(1, 2) / m.count, 1);
      const Eigen::Vector3d ray = K_inverse * center;
      Cell cell;
      cell.p_W = sight.X_WC * Eigen::Vector3d(ray * (1 / N.dot(ray)));
      cell.n_W = sight.X_WC.linear() * n_C;
      cell.area = m.count * z * z / (sight.K(0, 0) * sight.K(1, 1)) / std::max(0.05, -n_C.dot(ray));
      cell.deviation = noise(z) / std::sqrt(m.count);
      cell.roughness = roughness;
      cell.depth = z;
      cell.row = row / kSide;
      cell.column = column / kSide;
      cell.view = view;
      cells.push_back(cell);
    }
  }
  return cells;
}

}  // namespace graspless::perception
