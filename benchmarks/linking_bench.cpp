// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What one look at a hand costs: four closed finger curves of 8 segments with a loop of 100.
#include <vector>

#include <benchmark/benchmark.h>

#include "graspless/geometry/linking.hpp"

namespace graspless::geometry {
namespace {

using Eigen::Matrix3Xd;

/// A circle in the plane of axes 0 and `axis`, uneven as what is made of measured points.
Matrix3Xd ring(int corners, double radius, int axis, double aside) {
  Matrix3Xd points = Matrix3Xd::Zero(3, corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    points(0, i) = (aside > 0 ? 0.1 : 0) + radius * std::cos(angle);
    points(axis, i) = radius * std::sin(angle);
    points(3 - axis, i) = aside + 0.03 * radius * std::sin(7 * angle);
  }
  return points;
}

std::vector<Matrix3Xd> hand() {
  std::vector<Matrix3Xd> curves;
  for (int i = 1; i <= 4; ++i) curves.push_back(ring(8, 0.06, 2, 0.01 * i));
  return curves;
}

void gauss_linking_4_curves(benchmark::State& state) {
  const PreparedLoop loop(ring(100, 0.1, 1, 0));
  const std::vector<Matrix3Xd> curves = hand();
  for (auto _ : state) benchmark::DoNotOptimize(loop.gauss_linking(curves, true));
}
BENCHMARK(gauss_linking_4_curves);

void linking_number_4_curves(benchmark::State& state) {
  const PreparedLoop loop(ring(100, 0.1, 1, 0));
  const std::vector<Matrix3Xd> curves = hand();
  for (auto _ : state) benchmark::DoNotOptimize(loop.linking_numbers(curves));
}
BENCHMARK(linking_number_4_curves);

}  // namespace
}  // namespace graspless::geometry
