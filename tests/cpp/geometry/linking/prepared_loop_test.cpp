// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "graspless/geometry/linking.hpp"

#include "geometry/linking/curves.hpp"

namespace graspless::geometry {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

TEST(PreparedLoop, AnswersAsTheFunctions) {
  std::mt19937_64 rng(9);
  for (int corners = 3; corners < 300; corners += 9) {
    const Matrix3Xd loop = random_curve(corners, rng);
    const PreparedLoop prepared(loop);
    std::vector<Matrix3Xd> curves;  // large ones and small ones, near and far
    for (int i = 0; i < 40; ++i) {
      curves.push_back((0.2 + 0.1 * (i % 9)) * random_curve(8, rng));
      curves.back().colwise() += Vector3d(0.05 * i, 0, 0);
    }
    const std::vector<double> integrals = prepared.gauss_linking(curves, false);
    const std::vector<int> numbers = prepared.linking_numbers(curves);
    ASSERT_EQ(curves.size(), integrals.size());
    ASSERT_EQ(curves.size(), numbers.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
      EXPECT_NEAR(gauss_linking(loop, true, curves[i], false), integrals[i], 1e-11);
      EXPECT_EQ(linking_number(loop, curves[i]), numbers[i]);
    }
    EXPECT_EQ(loop, prepared.points());
  }
}

TEST(PreparedLoop, FieldIsTheDerivativeByACurvesEnd) {
  std::mt19937_64 rng(10);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 30; ++i) {
    const PreparedLoop loop(random_curve(20, rng));
    const Matrix3Xd curve = random_curve(5, rng);
    for (const int end : {0, 4}) {
      const Vector3d field = loop.field(curve.col(end)) * (end == 0 ? -1 : 1);
      for (int k = 0; k < 3; ++k) {
        Matrix3Xd more = curve, less = curve;
        more(k, end) += kStep;
        less(k, end) -= kStep;
        const double change = loop.gauss_linking(more, false) - loop.gauss_linking(less, false);
        EXPECT_NEAR(change / (2 * kStep), field[k], 1e-6 * (1 + field.norm()));
      }
    }
    EXPECT_TRUE(loop.field(loop.points().col(3)).allFinite());
  }
}

}  // namespace
}  // namespace graspless::geometry
